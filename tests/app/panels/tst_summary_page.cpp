// The summary of a lesson, and starting the lesson over, by mouse and keys.

#include "app/ui/learn/after/summary_page.h"
#include "app/ui/learn/learn_panel.h"
#include "app/ui/learn/lessons/lesson_list.h"
#include "app/ui/learn/lessons/lesson_model.h"
#include "app/ui/learn/narration_text.h"
#include "app/ui/learn/step/narration.h"
#include "tests/app/support/panel_fixture.h"
#include "tests/suite.h"

#include <QSettings>
#include <QTest>
#include <QToolButton>

using namespace app;
using namespace tests;

namespace {

/// Returns two lessons whose first step has something to learn and two things to try.
LessonLibrary summedUpLessons()
{
    LessonLibrary library = twoLessons();
    lessons::Step &first = library.lessons[0].steps[0];
    first.explanation.learnt = "A spring pulls.";
    first.tries.push_back(first.tries[0]);
    return library;
}

struct SummaryFixture : PanelFixture<LearnPanel>
{
    SummaryFixture() : PanelFixture(summedUpLessons(), {280, 732}) {}

    SummaryPage &summary() const { return *panel.findChild<SummaryPage *>(); }
    QToolButton &startOver() const { return *panel.findChild<QToolButton *>("startOver"); }
};

}

class SummaryPageTest : public QObject
{
    Q_OBJECT

private slots:
    void init() { QSettings().clear(); }

    void theSummaryTellsWhatWasLearntAndWhatIsOpen();
    void goingOnAfterTheLastStepShowsTheSummaryFirst();
    void theSummaryIsInTheList();
    void aLessonCanBeStartedOverAndTheTicksBroughtBack();
};

void SummaryPageTest::theSummaryTellsWhatWasLearntAndWhatIsOpen()
{
    SummaryFixture fixture;
    fixture.session.progress().markDone("one", "first", 1);
    fixture.panel.showSummary(true);
    const auto *text = fixture.summary().findChild<NarrationText *>();
    QVERIFY(fixture.summary().isVisible() && !fixture.panel.narration().isVisible());
    QVERIFY(text->toPlainText().contains("1 of 2 things tried."));
    QVERIFY(text->toPlainText().contains("A spring pulls."));
    QVERIFY(text->toPlainText().contains("Still to try: Wait five frames."));
    QVERIFY(text->toPlainText().contains("Next: Lesson two. The second."));
    fixture.session.openStep("one", "second");
    QVERIFY(!fixture.summary().isVisible() && fixture.panel.narration().isVisible());
}

void SummaryPageTest::goingOnAfterTheLastStepShowsTheSummaryFirst()
{
    SummaryFixture fixture;
    const Session &session = fixture.session;
    fixture.panel.goOn();
    QCOMPARE(session.step().id, QString("second"));
    fixture.panel.goOn();
    QVERIFY(fixture.summary().isVisible());
    QCOMPARE(session.step().id, QString("second"));
    fixture.panel.goBack();
    QVERIFY(!fixture.summary().isVisible());
    QCOMPARE(session.step().id, QString("second"));
    fixture.panel.goOn();
    fixture.panel.goOn();
    QVERIFY(!fixture.summary().isVisible());
    QCOMPARE(session.lesson().id, QString("two"));
    fixture.panel.goBack();
    QCOMPARE(session.lesson().id, QString("one"));
    fixture.panel.hide(); // so the summary cannot be seen
    fixture.panel.goOn();
    QCOMPARE(session.lesson().id, QString("two"));
}

void SummaryPageTest::theSummaryIsInTheList()
{
    SummaryFixture fixture;
    auto *list = fixture.panel.findChild<LessonList *>();
    const QModelIndex lesson = list->model()->index(0, 0);
    const QModelIndex row = list->model()->index(2, 0, lesson);
    QCOMPARE(row.data().toString(), QString("What you learnt"));
    QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, list->visualRect(row).center());
    QVERIFY(fixture.summary().isVisible());
    QVERIFY(row.data(LessonModel::openRole).toBool());
    // And back to the step that is open anyway.
    const QModelIndex step = list->model()->index(0, 0, lesson);
    QVERIFY(!step.data(LessonModel::openRole).toBool());
    QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, list->visualRect(step).center());
    QVERIFY(!fixture.summary().isVisible());
    QVERIFY(step.data(LessonModel::openRole).toBool());
}

void SummaryPageTest::aLessonCanBeStartedOverAndTheTicksBroughtBack()
{
    SummaryFixture fixture;
    Progress &progress = fixture.session.progress();
    fixture.panel.showSummary(true);
    QVERIFY(!fixture.startOver().isEnabled());
    progress.markDone("one", "first", 0);
    progress.markDone("two", "many", 0);
    QCOMPARE(fixture.startOver().text(), QString("Restart this lesson"));
    QTest::mouseClick(&fixture.startOver(), Qt::LeftButton);
    QVERIFY(!progress.isDone("one", "first", 0) && progress.isDone("two", "many", 0));
    QCOMPARE(fixture.startOver().text(), QString("Restore the ticks"));
    QTest::keyClick(&fixture.startOver(), Qt::Key_Space);
    QVERIFY(progress.isDone("one", "first", 0));
    QCOMPARE(fixture.startOver().text(), QString("Restart this lesson"));
}

SUITE(tst_summary_page, SummaryPageTest)
#include "tst_summary_page.moc"
