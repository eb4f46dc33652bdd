// Hints, remaining work, answers and why-boxes, opened with mouse and keyboard.

#include "app/ui/learn/learn_panel.h"
#include "app/ui/learn/narration_text.h"
#include "app/ui/learn/prose.h"
#include "app/ui/learn/step/narration.h"
#include "app/ui/learn/step/try_box.h"
#include "app/ui/learn/step/try_row.h"
#include "app/ui/learn/why_box.h"
#include "tests/app/support/panel_fixture.h"
#include "tests/suite.h"

#include <QAbstractTextDocumentLayout>
#include <QSettings>
#include <QTest>
#include <QTextBlock>
#include <QToolButton>

using namespace app;
using namespace tests;

namespace {

/// Returns two lessons whose first step has hints and a question.
LessonLibrary toldLessons()
{
    LessonLibrary library = twoLessons();
    lessons::Step &first = library.lessons[0].steps[0];
    first.tries[0].hint = "Press **Right** five times.";
    first.tries.push_back(first.tries[0]);
    first.tries[1].hint = "Press it once more.";
    first.explanation.whys = {{"Why twice the pull?", "Because\n\n`pull = k × distance`"}};
    return library;
}

struct LearnFixture : PanelFixture<LearnPanel>
{
    LearnFixture() : PanelFixture(toldLessons(), {280, 732}) {}

    QList<TryBox *> boxes() const { return panel.findChildren<TryBox *>(); }
};

QToolButton *lampOf(const TryBox &box)
{
    return box.findChild<QToolButton *>("hint");
}

}

class LearningAidsTest : public QObject
{
    Q_OBJECT

private slots:
    void init() { QSettings().clear(); }

    void aHintIsShownWhenItIsAskedFor_data();
    void aHintIsShownWhenItIsAskedFor();
    void theNextHintIsTheFirstThatIsNotShown();
    void hintsAreRememberedUntilTheProgramEnds();
    void aDoneTaskOffersNoHint();
    void aBegunTaskSaysWhatIsMissing();
    void aTaskForAPausedRunCountsOnlyWhilePaused();
    void anAnswerAppearsWhenItsQuestionIsTickedOff();
    void anAnswerBelowALongTextScrollsIntoView();
    void nothingIsEmptyBelowAnAnswer();
    void aNumberStaysOnOneLineWithItsUnit_data();
    void aNumberStaysOnOneLineWithItsUnit();
    void anAnswerUnfolds_data();
    void anAnswerUnfolds();
};

void LearningAidsTest::aHintIsShownWhenItIsAskedFor_data()
{
    QTest::addColumn<bool>("byKey");
    QTest::newRow("mouse") << false;
    QTest::newRow("keyboard") << true;
}

void LearningAidsTest::aHintIsShownWhenItIsAskedFor()
{
    QFETCH(bool, byKey);
    LearnFixture fixture;
    const TryBox &box = *fixture.boxes()[0];
    QVERIFY(!box.showsHint());
    const int high = box.height();
    if (byKey) {
        lampOf(box)->setFocus(Qt::TabFocusReason);
        QTest::keyClick(lampOf(box), Qt::Key_Space);
    } else {
        QTest::mouseClick(lampOf(box), Qt::LeftButton);
    }
    QVERIFY(box.showsHint());
    QCOMPARE(box.findChild<NarrationText *>("hintText")->toPlainText(), QString("Press Right five times."));
    QTRY_VERIFY(box.height() > high);
    QVERIFY(!fixture.boxes()[1]->showsHint());
    QTest::mouseClick(lampOf(box), Qt::LeftButton);
    QVERIFY(!box.showsHint());
}

void LearningAidsTest::theNextHintIsTheFirstThatIsNotShown()
{
    LearnFixture fixture;
    fixture.panel.narration().showNextHint();
    QVERIFY(fixture.boxes()[0]->showsHint() && !fixture.boxes()[1]->showsHint());
    fixture.panel.narration().showNextHint();
    QVERIFY(fixture.boxes()[0]->showsHint() && fixture.boxes()[1]->showsHint());
    fixture.panel.narration().showNextHint(); // no more
    QVERIFY(fixture.boxes()[0]->showsHint() && fixture.boxes()[1]->showsHint());
}

void LearningAidsTest::hintsAreRememberedUntilTheProgramEnds()
{
    {
        LearnFixture fixture;
        QTest::mouseClick(lampOf(*fixture.boxes()[1]), Qt::LeftButton);
        fixture.session.openStep("one", "second");
        fixture.session.openStep("one", "first");
        QVERIFY(!fixture.boxes()[0]->showsHint() && fixture.boxes()[1]->showsHint());
    }
    LearnFixture again;
    QVERIFY(!again.boxes()[1]->showsHint());
}

void LearningAidsTest::aDoneTaskOffersNoHint()
{
    LearnFixture fixture;
    QTest::mouseClick(lampOf(*fixture.boxes()[0]), Qt::LeftButton);
    for (int i = 0; i < 5; ++i)
        fixture.session.playback().frameForward();
    QVERIFY(fixture.boxes()[0]->isDone());
    QVERIFY(!fixture.boxes()[0]->showsHint() && !lampOf(*fixture.boxes()[0])->isVisible());
}

namespace {

/// A thing to try that is begun at frame 1 and done at frame 5.
lessons::Try toFrameFive()
{
    const auto frame = [](const sim::Timeline &run) { return static_cast<double>(run.cursor().frame); };
    lessons::Condition atFive = lessons::atLeast(5.0, frame, {}, 0);
    atFive.todo = "go on to frame **5**. This is frame %1.";
    return {"Go to frame 5. What is there?", {lessons::atLeast(1.0, frame), atFive}};
}

LessonLibrary lessonsWith(const lessons::Try &one)
{
    LessonLibrary library = twoLessons();
    library.lessons[0].steps[0].tries = {one, one};
    return library;
}

NarrationText *textOf(const TryBox &box, const char *name)
{
    return box.findChild<NarrationText *>(name);
}

}

void LearningAidsTest::aBegunTaskSaysWhatIsMissing()
{
    PanelFixture<LearnPanel> fixture(lessonsWith(toFrameFive()), {280, 732});
    const TryBox &box = *fixture.panel.findChild<TryBox *>();
    QVERIFY(!textOf(box, "todoText")->isVisible());
    fixture.goTo(3);
    QTRY_VERIFY(textOf(box, "todoText")->isVisible());
    QCOMPARE(textOf(box, "todoText")->toPlainText(),
             QString("Still to do: go on to frame 5. This is frame 3."));
    QCOMPARE(box.findChild<TryRow *>()->accessibleDescription(), textOf(box, "todoText")->toPlainText());
    fixture.goTo(5);
    QVERIFY(box.isDone());
    QVERIFY(!textOf(box, "todoText")->isVisible());
    QVERIFY(box.findChild<TryRow *>()->accessibleDescription().isEmpty());
}

void LearningAidsTest::aTaskForAPausedRunCountsOnlyWhilePaused()
{
    lessons::Try one = toFrameFive();
    one.onlyWhilePaused = true;
    PanelFixture<LearnPanel> fixture(lessonsWith(one), {280, 732});
    const TryBox &box = *fixture.panel.findChild<TryBox *>();
    fixture.session.playback().play();
    QTRY_VERIFY(fixture.session.timeline().cursor().frame > 6);
    QVERIFY(fixture.session.playback().isPlaying());
    QVERIFY(!box.isDone());
    QTRY_VERIFY(textOf(box, "todoText")->toPlainText().contains("Space"));
    fixture.session.playback().pause();
    QVERIFY(box.isDone());
}

void LearningAidsTest::anAnswerAppearsWhenItsQuestionIsTickedOff()
{
    lessons::Try one = toFrameFive();
    one.answer = "Nothing *new*.";
    PanelFixture<LearnPanel> fixture(lessonsWith(one), {280, 732});
    const auto found = fixture.panel.findChildren<TryBox *>();
    TryBox &first = *found[0], &second = *found[1];
    QVERIFY(!textOf(first, "answerText")->isVisible());
    QVERIFY(!lampOf(first)->isVisible()); // it has no hint
    fixture.goTo(5);
    QCOMPARE(textOf(second, "answerText")->toPlainText(), QString("Nothing new."));
    QVERIFY(textOf(second, "answerText")->isVisible()); // of what was done last
    QVERIFY(!textOf(first, "answerText")->isVisible());
    QVERIFY(lampOf(first)->accessibleName().startsWith("Answer"));
    QTest::mouseClick(lampOf(first), Qt::LeftButton);
    QVERIFY(textOf(first, "answerText")->isVisible());
    QTest::mouseClick(lampOf(first), Qt::LeftButton);
    QVERIFY(!textOf(first, "answerText")->isVisible());
}

void LearningAidsTest::anAnswerBelowALongTextScrollsIntoView()
{
    lessons::Try asked = toFrameFive();
    asked.answer = QString("The answer is long, so that it needs many lines. ").repeated(8);
    LessonLibrary library = lessonsWith(asked);
    library.lessons[0].steps[0].narration = QString("A text that is longer than the panel. ").repeated(60);
    PanelFixture<LearnPanel> fixture(library, {280, 640});
    const auto boxes = fixture.panel.findChildren<TryBox *>();
    QTRY_VERIFY(!boxes[0]->visibleRegion().isEmpty());
    fixture.goTo(5);
    const NarrationText &answer = *textOf(*boxes[1], "answerText");
    QTRY_VERIFY(answer.isVisible());
    QTRY_COMPARE(answer.visibleRegion().boundingRect().bottom(), answer.rect().bottom());
}

void LearningAidsTest::nothingIsEmptyBelowAnAnswer()
{
    lessons::Try asked = toFrameFive();
    asked.answer = QString("The answer is long, so that it needs many lines. ").repeated(4);
    PanelFixture<LearnPanel> fixture(lessonsWith(asked), {280, 732});
    fixture.session.playback().goTo({5, 0});
    const NarrationText &answer = *textOf(*fixture.panel.findChildren<TryBox *>()[1], "answerText");
    QTRY_VERIFY(answer.isVisible());
    settle();
    QCOMPARE(answer.height(), qCeil(answer.document()->size().height()));
}

void LearningAidsTest::aNumberStaysOnOneLineWithItsUnit_data()
{
    QTest::addColumn<QString>("markdown");
    QTest::addColumn<QString>("together");
    QTest::newRow("two sizes") << "It has left the stage of 540 × 400\u202Fpx."
                               << "540\u00A0×\u00A0400\u202Fpx.";
    QTest::newRow("a product") << "The first flight takes 2 ×\n0.8 times as long."
                               << "2\u00A0×\u00A00.8";
    QTest::newRow("a plain space") << "The stick is now 150 px long."
                                   << "150\u202Fpx";
    QTest::newRow("a thin space") << "It is at 72\u2009% of the limit."
                                  << "72\u202F%";
}

void LearningAidsTest::aNumberStaysOnOneLineWithItsUnit()
{
    QFETCH(QString, markdown);
    QFETCH(QString, together);
    const Theme theme(Scheme::light);
    QTextDocument document;
    setProse(document, markdown, ProseStyle(), theme);
    const QTextBlock block = document.firstBlock();
    const auto from = static_cast<int>(block.text().indexOf(together));
    QVERIFY2(from >= 0, qPrintable(block.text()));
    for (int width = 110; width < 400; width += 5) {
        layOut(document, width);
        QVERIFY(document.size().height() > 0.0); // lays it out
        const QTextLayout &lines = *block.layout();
        QCOMPARE(lines.lineForTextPosition(from).lineNumber(),
                 lines.lineForTextPosition(from + static_cast<int>(together.size()) - 1).lineNumber());
    }
}

void LearningAidsTest::anAnswerUnfolds_data()
{
    QTest::addColumn<int>("key"); // 0: the mouse
    QTest::newRow("mouse") << 0;
    QTest::newRow("space") << int(Qt::Key_Space);
    QTest::newRow("enter") << int(Qt::Key_Return);
}

void LearningAidsTest::anAnswerUnfolds()
{
    QFETCH(int, key);
    LearnFixture fixture;
    auto *button = fixture.panel.findChild<WhyButton *>();
    const auto &box = *fixture.panel.findChild<WhyBox *>();
    QCOMPARE(button->accessibleName(), QString("Why twice the pull?"));
    QVERIFY(!box.findChild<NarrationText *>()); // made when the box is opened
    const auto ask = [&] {
        if (key == 0)
            QTest::mouseClick(button, Qt::LeftButton);
        else
            QTest::keyClick(button, Qt::Key(key));
    };
    ask();
    const auto *answer = box.findChild<NarrationText *>();
    QVERIFY(answer && answer->isVisible());
    QVERIFY(answer->toPlainText().contains("pull = k × distance"));
    ask();
    QVERIFY(!answer->isVisible());
}

SUITE(tst_learning_aids, LearningAidsTest)
#include "tst_learning_aids.moc"
