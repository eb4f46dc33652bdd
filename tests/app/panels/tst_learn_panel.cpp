// The lessons and the text of the open step, driven with mouse and keyboard.

#include "app/ui/dock/panel_title.h"
#include "app/ui/learn/after/summary_page.h"
#include "app/ui/learn/learn_panel.h"
#include "app/ui/learn/lessons/lesson_list.h"
#include "app/ui/learn/lessons/lesson_model.h"
#include "app/ui/learn/step/narration.h"
#include "app/ui/learn/step/try_row.h"
#include "app/ui/learn/step_button.h"
#include "tests/app/support/panel_fixture.h"
#include "tests/suite.h"

#include <QScrollArea>
#include <QScrollBar>
#include <QSettings>
#include <QTest>
#include <QTreeView>

using namespace app;
using namespace tests;

namespace {

QTreeView &listOf(LearnPanel &panel)
{
    return *panel.findChild<LessonList *>();
}

void clickRow(QTreeView &list, const QModelIndex &index)
{
    QTest::mouseClick(list.viewport(), Qt::LeftButton, {}, list.visualRect(index).center());
}

QModelIndex stepIndex(const QTreeView &list, int lesson, int step)
{
    return list.model()->index(step, 0, list.model()->index(lesson, 0));
}

}

class LearnPanelTest : public QObject
{
    Q_OBJECT

private slots:
    void init() { QSettings().clear(); }

    void clickingAStepOpensIt();
    void clickingALessonOpensItsFirstStepThatIsNotDone();
    void theOpenLessonAloneShowsItsSteps();
    void theArrowKeysMoveAndEnterOpens();
    void theListSaysHowFarTheLearnerIs();
    void aFileThatIsNoLessonIsNamedLast();
    void aLongTextKeepsTheOpenStepInSight();
    void theTitleOfTheOpenLessonStaysInSight();
    void theTextIsShownWholeBeforeTheListIs();
    void nextAndBackCrossLessons();
    void theEndsSayWhyNothingFollows();
    void aTryIsTickedWhenItIsDone();
    void aTryCannotBeTickedByHand();
    void theButtonsStayInSight_data();
    void theButtonsStayInSight();
};

void LearnPanelTest::clickingAStepOpensIt()
{
    PanelFixture<LearnPanel> fixture({280, 732});
    QTreeView &list = listOf(fixture.panel);
    clickRow(list, stepIndex(list, 0, 1));
    QCOMPARE(fixture.session.step().id, QString("second"));
    QVERIFY(stepIndex(list, 0, 1).data(LessonModel::openRole).toBool());
    QVERIFY(!stepIndex(list, 0, 0).data(LessonModel::openRole).toBool());
}

void LearnPanelTest::clickingALessonOpensItsFirstStepThatIsNotDone()
{
    SessionFixture world;
    world.session.progress().markDone("one", "first", 0);
    world.session.openStep("two", "many");
    LearnPanel panel(world.session, world.theme);
    show(panel, {280, 732});
    QTreeView &list = listOf(panel);
    clickRow(list, list.model()->index(0, 0));
    QCOMPARE(world.session.lesson().id, QString("one"));
    QCOMPARE(world.session.step().id, QString("second"));
}

void LearnPanelTest::theOpenLessonAloneShowsItsSteps()
{
    PanelFixture<LearnPanel> fixture({280, 732});
    QTreeView &list = listOf(fixture.panel);
    QVERIFY(list.isExpanded(list.model()->index(0, 0)));
    QVERIFY(!list.isExpanded(list.model()->index(1, 0)));
    QCOMPARE(list.height(), 2 * 27 + 3 * 26); // with the summary
    fixture.session.openStep("two", "many");
    QVERIFY(!list.isExpanded(list.model()->index(0, 0)));
    QVERIFY(list.isExpanded(list.model()->index(1, 0)));
    QCOMPARE(list.height(), 2 * 27 + 2 * 26);
}

void LearnPanelTest::theArrowKeysMoveAndEnterOpens()
{
    PanelFixture<LearnPanel> fixture({280, 732});
    QTreeView &list = listOf(fixture.panel);
    list.setFocus(Qt::TabFocusReason);
    QTest::keyClick(&list, Qt::Key_Down);
    QCOMPARE(list.currentIndex(), stepIndex(list, 0, 1));
    QCOMPARE(fixture.session.step().id, QString("first"));
    QTest::keyClick(&list, Qt::Key_Return);
    QCOMPARE(fixture.session.step().id, QString("second"));
    QTest::keyClick(&list, Qt::Key_Down); // the summary
    QTest::keyClick(&list, Qt::Key_Down);
    QTest::keyClick(&list, Qt::Key_Enter);
    QCOMPARE(fixture.session.lesson().id, QString("two"));
    QTest::keyClick(&list, Qt::Key_Up);
    QTest::keyClick(&list, Qt::Key_Up);
    QTest::keyClick(&list, Qt::Key_Return);
    QCOMPARE(fixture.session.lesson().id, QString("one"));
}

void LearnPanelTest::theListSaysHowFarTheLearnerIs()
{
    SessionFixture world;
    LearnPanel panel(world.session, world.theme);
    const QModelIndex lesson = listOf(panel).model()->index(0, 0);
    const auto *title = panel.findChild<PanelTitle *>();
    QCOMPARE(lesson.data(Qt::AccessibleTextRole).toString(), QString("Lesson one, 0 of 2 steps done"));
    QCOMPARE(title->caption(), QString("0 of 3 steps"));
    world.session.progress().markDone("one", "first", 0);
    QCOMPARE(lesson.data(Qt::AccessibleTextRole).toString(), QString("Lesson one, 1 of 2 steps done"));
    QCOMPARE(title->caption(), QString("1 of 3 steps"));
    QVERIFY(stepIndex(listOf(panel), 0, 0).data(Qt::AccessibleTextRole).toString().contains("done, open"));
}

void LearnPanelTest::aFileThatIsNoLessonIsNamedLast()
{
    LessonLibrary library = twoLessons();
    library.problems.push_back({"broken.so", "broken.so is not a lesson: remove it."});
    PanelFixture<LearnPanel> fixture(library, {280, 732});
    QTreeView &list = listOf(fixture.panel);
    QCOMPARE(list.model()->rowCount(), 3);
    const QModelIndex last = list.model()->index(2, 0);
    QCOMPARE(last.data().toString(), QString("1 file is not a lesson"));
    QCOMPARE(last.data(Qt::ToolTipRole).toString(), QString("broken.so is not a lesson: remove it."));
    clickRow(list, last);
    QCOMPARE(fixture.session.step().id, QString("first"));
}

void LearnPanelTest::aLongTextKeepsTheOpenStepInSight()
{
    LessonLibrary library = twoLessons();
    for (int i = 0; i < 12; ++i) {
        library.lessons.back().steps.front().narration += "\n\nOne more paragraph that needs its two lines.";
        library.lessons.front().steps.push_back(library.lessons.front().steps.back());
    }
    SessionFixture world(library);
    world.session.openStep("two", "many");
    LearnPanel panel(world.session, world.theme);
    show(panel, {280, 500});
    QTreeView &list = listOf(panel);
    QVERIFY(list.height() >= 27 + 26 && list.height() <= 4 * 27);
    QTRY_VERIFY(list.viewport()->rect().contains(list.visualRect(stepIndex(list, 1, 0))));
    QVERIFY(list.viewport()->rect().contains(list.visualRect(list.model()->index(1, 0))));
    world.session.openStep("one", "first"); // of a lesson with more steps than there is room for
    QTRY_VERIFY(list.viewport()->rect().contains(list.visualRect(stepIndex(list, 0, 0))));
    QVERIFY(list.viewport()->rect().contains(list.visualRect(list.model()->index(0, 0))));
}

void LearnPanelTest::theTitleOfTheOpenLessonStaysInSight()
{
    LessonLibrary library = twoLessons();
    for (int i = 0; i < 12; ++i)
        library.lessons.front().steps.push_back(library.lessons.front().steps.back());
    for (int i = 0; i < 12; ++i)
        library.lessons.front().steps.front().narration += "\n\nOne more paragraph that needs its two lines.";
    SessionFixture world(library);
    world.session.openStep("one", "first");
    LearnPanel panel(world.session, world.theme);
    show(panel, {280, 500});
    QTreeView &list = listOf(panel);
    const QModelIndex lesson = list.model()->index(0, 0), far = stepIndex(list, 0, 9);
    QVERIFY(!list.verticalScrollBar()->isVisible()); // two rows: the wheel scrolls them
    const QRect title(0, 0, list.viewport()->width(), 27);
    const QImage before = list.viewport()->grab(title).toImage();
    list.scrollTo(far);
    QVERIFY(list.visualRect(lesson).bottom() < 0);
    QVERIFY(list.visualRect(far).top() >= title.height());
    QVERIFY(list.viewport()->rect().contains(list.visualRect(far)));
    QCOMPARE(list.viewport()->grab(title).toImage(), before);
    QCOMPARE(list.indexAt(title.center()), lesson);
}

void LearnPanelTest::theTextIsShownWholeBeforeTheListIs()
{
    LessonLibrary library = twoLessons();
    for (int i = 0; i < 12; ++i)
        library.lessons.front().steps.push_back(library.lessons.front().steps.back());
    PanelFixture<LearnPanel> fixture(library, {280, 500});
    const auto *area = fixture.panel.findChild<Narration *>()->findChild<QScrollArea *>();
    QTRY_COMPARE(area->verticalScrollBar()->maximum(), 0);
    QVERIFY(listOf(fixture.panel).verticalScrollBar()->maximum() > 0);
}

void LearnPanelTest::nextAndBackCrossLessons()
{
    PanelFixture<LearnPanel> fixture({280, 732});
    auto *next = fixture.panel.findChild<StepButton *>("next");
    auto *back = fixture.panel.findChild<QPushButton *>("back");
    QCOMPARE(next->accessibleName(), QString("Next: The second step"));
    QTest::mouseClick(next, Qt::LeftButton);
    QCOMPARE(fixture.session.step().id, QString("second"));
    QCOMPARE(next->accessibleName(), QString("Next: What you learnt"));
    QTest::mouseClick(next, Qt::LeftButton);
    auto *page = fixture.panel.findChild<SummaryPage *>();
    QVERIFY(page->isVisible() && !next->isVisible());
    next = page->findChild<StepButton *>("next");
    QCOMPARE(next->accessibleName(), QString("Next: Lesson two"));
    QTest::mouseClick(next, Qt::LeftButton);
    QCOMPARE(fixture.session.lesson().id, QString("two"));
    QVERIFY(!page->isVisible());
    back->setFocus(Qt::TabFocusReason);
    QTest::keyClick(back, Qt::Key_Space);
    QCOMPARE(fixture.session.step().id, QString("second"));
}

void LearnPanelTest::theEndsSayWhyNothingFollows()
{
    PanelFixture<LearnPanel> fixture({280, 732});
    const auto *next = fixture.panel.findChild<StepButton *>("next");
    const auto *back = fixture.panel.findChild<QPushButton *>("back");
    QVERIFY(!back->isEnabled());
    QCOMPARE(back->toolTip(), QString("This is the first step."));
    QVERIFY(next->isEnabled());
    fixture.session.openStep("two", "many");
    QVERIFY(back->isEnabled());
    QVERIFY(next->isEnabled()); // to the summary
    QTest::mouseClick(fixture.panel.findChild<StepButton *>("next"), Qt::LeftButton);
    next = fixture.panel.findChild<SummaryPage *>()->findChild<StepButton *>("next");
    QVERIFY(next->isVisible() && !next->isEnabled());
    QCOMPARE(next->toolTip(), QString("No lesson comes after this one."));
}

void LearnPanelTest::aTryIsTickedWhenItIsDone()
{
    PanelFixture<LearnPanel> fixture({280, 732});
    auto *row = fixture.panel.findChild<TryRow *>();
    const auto *next = fixture.panel.findChild<StepButton *>("next");
    QVERIFY(!row->isChecked());
    QCOMPARE(row->accessibleName(), QString("Wait five frames. not yet"));
    QVERIFY(!next->isPrimary());
    for (int i = 0; i < 5; ++i)
        fixture.session.playback().frameForward();
    QVERIFY(row->isChecked());
    QCOMPARE(row->accessibleName(), QString("Wait five frames. done"));
    QVERIFY(next->isPrimary());
    const QImage picture = row->grab().toImage();
    QCOMPARE(picture.pixelColor(2, row->height() / 2), fixture.theme.tokens().ok);
}

void LearnPanelTest::aTryCannotBeTickedByHand()
{
    PanelFixture<LearnPanel> fixture({280, 732});
    auto *row = fixture.panel.findChild<TryRow *>();
    QTest::mouseClick(row, Qt::LeftButton, {}, {8, 12});
    QTest::keyClick(row, Qt::Key_Space);
    QVERIFY(!row->isChecked());
    QVERIFY(!fixture.session.progress().isDone("one", "first", 0));
}

void LearnPanelTest::theButtonsStayInSight_data()
{
    QTest::addColumn<QSize>("size");
    QTest::newRow("as designed") << QSize(280, 732);
    QTest::newRow("wide") << QSize(320, 1012);
    QTest::newRow("low") << QSize(280, 420);
    QTest::newRow("very low") << QSize(280, 300);
}

void LearnPanelTest::theButtonsStayInSight()
{
    QFETCH(QSize, size);
    LessonLibrary library = twoLessons();
    for (int i = 0; i < 12; ++i)
        library.lessons.front().steps.front().narration += "\n\nOne more paragraph that needs its two lines.";
    PanelFixture<LearnPanel> fixture(library, size);
    QCOMPARE(fixture.panel.size(), size);
    const auto buttons = fixture.panel.findChildren<QPushButton *>();
    QCOMPARE(buttons.size(), 6);
    for (const QPushButton *button : buttons) {
        const QRect place(button->mapTo(&fixture.panel, QPoint()), button->size());
        QVERIFY2(fixture.panel.rect().contains(place), qPrintable(button->accessibleName()));
    }
    const auto *area = fixture.panel.findChild<QScrollArea *>();
    QVERIFY(area->widget()->width() <= area->viewport()->width());
    const auto *row = fixture.panel.findChild<TryRow *>();
    QVERIFY(row->height() >= row->heightForWidth(row->width()));
}

SUITE(tst_learn_panel, LearnPanelTest)

#include "tst_learn_panel.moc"
