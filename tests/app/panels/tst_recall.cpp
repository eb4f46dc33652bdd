// The questions after a lesson, answered with mouse and keyboard.

#include "app/ui/learn/after/recall_box.h"
#include "app/ui/learn/after/recall_page.h"
#include "app/ui/learn/after/summary_page.h"
#include "app/ui/learn/choice_row.h"
#include "app/ui/learn/learn_panel.h"
#include "app/ui/learn/narration_text.h"
#include "app/ui/learn/step/narration.h"
#include "tests/app/support/panel_fixture.h"
#include "tests/app/support/window_fixture.h"
#include "tests/suite.h"

#include <QLabel>
#include <QPushButton>
#include <QScrollBar>
#include <QSettings>
#include <QTest>
#include <QToolButton>

using namespace app;
using namespace tests;

namespace {

/// Returns the two lessons. The first has a question with choices, and one that is answered in "two/many".
LessonLibrary askingLessons()
{
    LessonLibrary library = twoLessons();
    lessons::RecallQuestion choice{.id = "line", .text = "Which line **pulls**?"};
    choice.choices = {{"`foot += k * (target - foot);`", "It points to the target."},
                      {"`foot -= k * (target - foot);`", "It pushes."},
                      {"`foot = target;`", "It jumps."}};
    lessons::RecallQuestion task{.id = "drag", .text = "Drag the foot."};
    task.task = lessons::RecallTask{{.step = "two/many", .until = "abs(foot.x) >= 0"}, "Well dragged."};
    library.lessons[0].recall = {"one/recall.md", "What do you remember?", "Two questions.", {choice, task}};
    return library;
}

struct RecallFixture : PanelFixture<LearnPanel>
{
    RecallFixture() : PanelFixture(askingLessons(), {280, 732})
    {
        session.openStep("one", "second");
        panel.showSummary(true);
        settle();
    }

    RecallBox &box() const { return *panel.findChild<RecallBox *>(); }
    SummaryPage &summary() const { return *panel.findChild<SummaryPage *>(); }
    RecallPage &page() const { return *panel.findChild<RecallPage *>(); }
    /// Returns the choice whose text contains this.
    ChoiceRow *choice(const QString &text) const
    {
        QCoreApplication::processEvents(); // shows new rows
        for (ChoiceRow *one : box().findChildren<ChoiceRow *>()) {
            if (one->accessibleName().contains(text) && one->isVisible())
                return one;
        }
        return nullptr;
    }
    /// Returns the explanation that is shown; empty if there is none.
    QString explanation() const
    {
        QStringList all;
        for (const NarrationText *one : box().findChildren<NarrationText *>("explanation")) {
            if (one->isVisible())
                all << one->toPlainText();
        }
        return all.join('|');
    }
    QString count() const
    {
        for (const QLabel *one : box().findChildren<QLabel *>("caption")) {
            if (one->text().startsWith("Question"))
                return one->text();
        }
        return {};
    }
    template <class Part>
    Part &part(const char *name) const
    {
        return *box().findChild<Part *>(name);
    }
};

}

class RecallTest : public QObject
{
    Q_OBJECT

private slots:
    void init() { QSettings().clear(); }

    void theQuestionsComeFirstInTheSummary();
    void aLessonWithoutQuestionsAsksNone();
    void aChoiceIsExplained_data();
    void aChoiceIsExplained();
    void anotherChoiceReplacesTheFirst();
    void arrowKeysMoveWithoutChoosing();
    void questionsCanBeSkippedAndComeBack();
    void theFirstOpenQuestionIsShownAtTheNextStart();
    void aTaskIsDoneInTheScene_data();
    void aTaskIsDoneInTheScene();
    void aTaskCanBeLeftWithoutAnAnswer();
    void nothingIsBlockedByOpenQuestions();
    void everyControlHasANameAndATip();
    void theFootIsDraggedInTheRealScene();
};

void RecallTest::theQuestionsComeFirstInTheSummary()
{
    RecallFixture fixture;
    QVERIFY(fixture.box().isVisible());
    const auto *told = fixture.summary().findChild<NarrationText *>();
    QVERIFY(told->toPlainText().contains("things tried"));
    QVERIFY(fixture.box().geometry().bottom() < told->geometry().top());
    QCOMPARE(fixture.count(), QString("Question 1 of 2"));
    QCOMPARE(fixture.part<NarrationText>("recallText").toPlainText(), QString("Which line pulls?"));
    QCOMPARE(fixture.box().findChildren<ChoiceRow *>().size(), 3);
    QVERIFY(!fixture.part<QPushButton>("doIt").isVisible());
    for (const ChoiceRow *one : fixture.box().findChildren<ChoiceRow *>())
        QVERIFY(!one->isChecked());
    QVERIFY(fixture.explanation().isEmpty());
}

void RecallTest::aLessonWithoutQuestionsAsksNone()
{
    RecallFixture fixture;
    fixture.session.openStep("two", "many");
    fixture.panel.showSummary(true);
    QVERIFY(fixture.summary().isVisible() && !fixture.box().isVisible());
}

void RecallTest::aChoiceIsExplained_data()
{
    QTest::addColumn<int>("key"); // 0: the mouse
    QTest::newRow("mouse") << 0;
    QTest::newRow("space") << int(Qt::Key_Space);
    QTest::newRow("enter") << int(Qt::Key_Return);
}

void RecallTest::aChoiceIsExplained()
{
    QFETCH(int, key);
    RecallFixture fixture;
    ChoiceRow *wrong = fixture.choice("foot = target");
    const int high = fixture.box().height();
    if (key == 0) {
        QTest::mouseClick(wrong, Qt::LeftButton, {}, QPoint(wrong->width() - 30, wrong->height() / 2));
    } else {
        wrong->setFocus(Qt::TabFocusReason);
        QTest::keyClick(wrong, Qt::Key(key));
    }
    QVERIFY(wrong->isChecked());
    QCOMPARE(wrong->verdict(), ChoiceRow::Verdict::wrong);
    QCOMPARE(wrong->accessibleName(), QString("foot = target;, wrong"));
    QCOMPARE(fixture.explanation(), QString("Not this one. It jumps."));
    QTRY_VERIFY(fixture.box().height() > high);
    QCOMPARE(fixture.count(), QString("Question 1 of 2"));
    QCOMPARE(fixture.session.notes().find("one/recall:line")->said, QString("2"));
}

void RecallTest::anotherChoiceReplacesTheFirst()
{
    RecallFixture fixture;
    QTest::mouseClick(fixture.choice("foot -= k"), Qt::LeftButton);
    QCOMPARE(fixture.explanation(), QString("Not this one. It pushes."));
    QTest::mouseClick(fixture.choice("foot += k"), Qt::LeftButton);
    QCOMPARE(fixture.explanation(), QString("Right. It points to the target."));
    QVERIFY(!fixture.choice("foot -= k")->isChecked());
    QCOMPARE(fixture.choice("foot -= k")->verdict(), ChoiceRow::Verdict::none);
    QCOMPARE(fixture.count(), QString("Question 1 of 2 ✓"));
    QTest::mouseClick(fixture.choice("foot += k"), Qt::LeftButton); // stays chosen
    QVERIFY(fixture.choice("foot += k")->isChecked());
    QVERIFY(fixture.session.notes().find("one/recall:line")->isRight);
}

void RecallTest::arrowKeysMoveWithoutChoosing()
{
    RecallFixture fixture;
    auto *first = fixture.box().findChildren<ChoiceRow *>()[0];
    first->setFocus(Qt::TabFocusReason);
    QTest::keyClick(first, Qt::Key_Down);
    auto *now = qobject_cast<ChoiceRow *>(QApplication::focusWidget());
    QVERIFY(now && now != first);
    QVERIFY(!first->isChecked() && !now->isChecked());
    QVERIFY(!fixture.session.notes().find("one/recall:line"));
    QTest::keyClick(now, Qt::Key_Tab);
    QVERIFY(qobject_cast<ChoiceRow *>(QApplication::focusWidget())); // Tab goes on to the third
}

void RecallTest::questionsCanBeSkippedAndComeBack()
{
    RecallFixture fixture;
    auto &back = fixture.part<QToolButton>("previousQuestion");
    auto &next = fixture.part<QToolButton>("nextQuestion");
    QVERIFY(!back.isEnabled() && next.isEnabled());
    QTest::mouseClick(&next, Qt::LeftButton);
    QCOMPARE(fixture.count(), QString("Question 2 of 2"));
    QVERIFY(fixture.part<QPushButton>("doIt").isVisible());
    QVERIFY(back.isEnabled() && !next.isEnabled());
    back.setFocus(Qt::TabFocusReason);
    QTest::keyClick(&back, Qt::Key_Space);
    QCOMPARE(fixture.count(), QString("Question 1 of 2"));
    QVERIFY(fixture.choice("foot += k"));
}

void RecallTest::theFirstOpenQuestionIsShownAtTheNextStart()
{
    {
        RecallFixture fixture;
        QTest::mouseClick(fixture.choice("foot += k"), Qt::LeftButton);
    }
    RecallFixture again;
    QCOMPARE(again.count(), QString("Question 2 of 2"));
    QTest::mouseClick(&again.part<QToolButton>("previousQuestion"), Qt::LeftButton);
    QVERIFY(again.choice("foot += k")->isChecked());
    QCOMPARE(again.explanation(), QString("Right. It points to the target."));
}

void RecallTest::aTaskIsDoneInTheScene_data()
{
    QTest::addColumn<bool>("byKey");
    QTest::newRow("mouse") << false;
    QTest::newRow("keyboard") << true;
}

void RecallTest::aTaskIsDoneInTheScene()
{
    QFETCH(bool, byKey);
    RecallFixture fixture;
    const auto press = [byKey](QAbstractButton &button) {
        if (!byKey) {
            QTest::mouseClick(&button, Qt::LeftButton);
            return;
        }
        button.setFocus(Qt::TabFocusReason);
        QTest::keyClick(&button, Qt::Key_Space);
    };
    press(fixture.part<QToolButton>("nextQuestion"));
    press(fixture.part<QPushButton>("doIt"));
    QCOMPARE(fixture.session.lesson().id, QString("two"));
    QVERIFY(fixture.page().isVisible() && !fixture.summary().isVisible());
    QVERIFY(!fixture.panel.narration().isVisible());
    QCOMPARE(fixture.page().findChild<NarrationText *>("recallText")->toPlainText(),
             QString("Drag the foot."));
    const auto *state = fixture.page().findChild<NarrationText *>("recallState");
    QVERIFY(state->toPlainText().startsWith("Not done yet."));
    fixture.session.input().grab("foot");
    fixture.session.input().moveTo({200, 200});
    fixture.session.playback().frameForward();
    QVERIFY(state->toPlainText().startsWith("Done ✓"));
    QVERIFY(state->toPlainText().contains("Well dragged."));
    press(*fixture.page().findChild<QPushButton *>("backToQuestions"));
    QCOMPARE(fixture.session.lesson().id, QString("one"));
    QCOMPARE(fixture.session.step().id, QString("second"));
    QVERIFY(fixture.summary().isVisible() && !fixture.page().isVisible());
    QCOMPARE(fixture.count(), QString("Question 2 of 2 ✓"));
    QCOMPARE(fixture.part<NarrationText>("recallAnswer").toPlainText(), QString("Well dragged."));
    QVERIFY(fixture.part<NarrationText>("recallAnswer").isVisible());
}

void RecallTest::aTaskCanBeLeftWithoutAnAnswer()
{
    RecallFixture fixture;
    fixture.box().showQuestion(1);
    QTest::mouseClick(&fixture.part<QPushButton>("doIt"), Qt::LeftButton);
    fixture.session.openStep("one", "first"); // she does something else
    QVERIFY(!fixture.page().isVisible() && fixture.panel.narration().isVisible());
    fixture.panel.showSummary(true);
    QVERIFY(fixture.summary().isVisible());
    QTest::mouseClick(&fixture.part<QPushButton>("doIt"), Qt::LeftButton);
    fixture.session.editor().setParameter("k", 0.1);
    QTest::mouseClick(fixture.page().findChild<QToolButton *>("startOver"), Qt::LeftButton);
    QVERIFY(
        fixture.page().findChild<NarrationText *>("recallState")->toPlainText().startsWith("Not done yet."));
    QTest::mouseClick(fixture.page().findChild<QPushButton *>("backToQuestions"), Qt::LeftButton);
    QVERIFY(fixture.summary().isVisible());
}

void RecallTest::nothingIsBlockedByOpenQuestions()
{
    RecallFixture fixture;
    auto *next = fixture.summary().findChild<QPushButton *>("next");
    QVERIFY(next->isEnabled());
    QTest::mouseClick(next, Qt::LeftButton);
    QCOMPARE(fixture.session.lesson().id, QString("two"));
}

void RecallTest::everyControlHasANameAndATip()
{
    RecallFixture fixture;
    fixture.box().showQuestion(1);
    QTest::mouseClick(&fixture.part<QPushButton>("doIt"), Qt::LeftButton);
    const auto check = [](const QWidget &in) {
        const auto buttons = in.findChildren<QAbstractButton *>();
        QVERIFY(!buttons.isEmpty());
        for (const QAbstractButton *one : buttons) {
            const QString name = one->accessibleName().isEmpty() ? one->text() : one->accessibleName();
            QVERIFY2(!name.isEmpty() && !one->toolTip().isEmpty(), qPrintable(one->objectName()));
            QVERIFY2(one->focusPolicy() & Qt::TabFocus, qPrintable(one->objectName()));
        }
    };
    check(fixture.page());
    check(fixture.box());
    fixture.box().showQuestion(0);
    check(fixture.box());
}

void RecallTest::theFootIsDraggedInTheRealScene()
{
    WindowFixture fixture({.lesson = "single_spring", .step = "radial"});
    fixture.part<LearnPanel>().showSummary(true);
    auto &box = fixture.part<RecallBox>("recall");
    while (box.findChild<NarrationText *>("recallText")->toPlainText().count("atan2") == 0) {
        const std::size_t before = box.number();
        QTest::mouseClick(box.findChild<QToolButton *>("nextQuestion"), Qt::LeftButton);
        QVERIFY(box.number() > before);
    }
    QTest::mouseClick(box.findChild<QPushButton *>("doIt"), Qt::LeftButton);
    settle();
    const auto *state = fixture.part<RecallPage>().findChild<NarrationText *>("recallState");
    QVERIFY(state->isVisible() && state->toPlainText().startsWith("Not done yet."));
    const QPoint foot = fixture.onScreen("foot"), body = fixture.onScreen("body");
    QTest::mousePress(fixture.view.viewport(), Qt::LeftButton, {}, foot);
    const QPoint place = body - QPoint(foot.x() - body.x(), 0) * 2;
    moveMouse(*fixture.view.viewport(), place, Qt::LeftButton);
    QTRY_VERIFY(state->toPlainText().startsWith("Done"));
    QTest::mouseRelease(fixture.view.viewport(), Qt::LeftButton, {}, place);
    QVERIFY(fixture.session.notes().find("single_spring/recall:left_of_body")->isRight);
}

SUITE(tst_recall, RecallTest)
#include "tst_recall.moc"
