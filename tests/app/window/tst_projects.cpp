// The project of a lesson in the window: on the page after the lesson, and in the sandbox.

#include "tests/app/support/window_fixture.h"

#include "app/model/learning/project_desk.h"
#include "app/ui/learn/after/level_box.h"
#include "app/ui/learn/after/project_box.h"
#include "app/ui/learn/after/summary_page.h"
#include "app/ui/learn/learn_panel.h"
#include "app/ui/learn/narration_text.h"
#include "app/ui/sandbox/build_panel.h"
#include "app/ui/sandbox/property_row.h"
#include "lessons/api/view/view.h"
#include "sim/run/script/composed_interval.h"
#include "tests/suite.h"

#include <QLabel>
#include <QSettings>
#include <QToolButton>

#include <algorithm>

using namespace app;
using namespace tests;

namespace {

/// The window on the page after a lesson.
struct ProjectFixture : WindowFixture
{
    explicit ProjectFixture(const QString &lesson, const QString &code = {})
        : WindowFixture({.lesson = lesson, .step = firstStepOf(lesson), .language = code, .codePage = {}})
    {
        panel.showSummary(true);
        settle();
    }

    static const LessonLibrary &allLessons()
    {
        static const LessonLibrary all = LessonLibrary::load({LESSON_DIR});
        return all;
    }
    static QString firstStepOf(const QString &lesson)
    {
        return allLessons().lesson(lesson)->steps.front().id;
    }

    ProjectBox &project() const { return part<ProjectBox>("project"); }
    ProjectBox &card() const { return part<ProjectBox>("projectCard"); }
    /// Clicks a button of a level or a project, after making it visible by the keyboard focus.
    void click(QWidget &in, const char *name)
    {
        auto *button = in.findChild<QToolButton *>(name);
        QVERIFY(button);
        button->setFocus(Qt::TabFocusReason);
        settle();
        QVERIFY2(button->isVisible(), name);
        QTest::mouseClick(button, Qt::LeftButton);
        settle();
    }
    void press(QWidget &in, const char *name)
    {
        auto *button = in.findChild<QToolButton *>(name);
        QVERIFY(button);
        button->setFocus(Qt::TabFocusReason);
        QTest::keyClick(button, Qt::Key_Space);
        settle();
    }
    void waitForJudge()
    {
        QVERIFY(QTest::qWaitFor([this] { return desk.judging(project().lesson()).isEmpty(); }, 30'000));
        settle();
    }
    static QString sentenceOf(const LevelBox &level)
    {
        return level.findChild<QLabel *>("levelSentence")->text();
    }
    Experiment solution(const QString &name) const
    {
        return readExperiment(QStringLiteral(TEST_DATA "/projects/%1.json").arg(name), library);
    }

    LearnPanel &panel = part<LearnPanel>();
    ProjectDesk &desk = panel.projects();
};

}

class ProjectsTest : public QObject
{
    Q_OBJECT

private slots:
    void init() { QSettings().clear(); }

    void theSceneShowsTheRingOfAProjectUntilItIsPutAway();
    void thePageAfterALessonHasItsProject_data();
    void thePageAfterALessonHasItsProject();
    void theFirstLevelIsUnfolded();
    void theBuildPanelShowsTheProjectThatIsBuilt();
    void aBodyThatIsSelectedShowsItsNumbersBelowTheProject();
    void startingIsOneEditThatCanBeUndone();
    void aProjectOfTheListingKeepsItsPage();
    void aProjectOfTheListingReplacesWhatWasWrittenBefore();
    void aSolutionIsTickedByKeys();
    void theMissingDemandIsNamed();
    void theWholeVerdictIsInView();
    void judgingCanBeCancelled();
    void thePageCountsTheLevels();
    void aHintIsShownAndHidden();
    void aBuiltSceneWaitsInTheProject();
    void puttingAwayKeepsTheScene();
    void theCurrentProjectIsKnownAtTheNextStart();
    void germanTextsFit();
};

void ProjectsTest::theSceneShowsTheRingOfAProjectUntilItIsPutAway()
{
    ProjectFixture fixture("gravity_walls");
    const auto ring = [&]() -> const lessons::Overlay * {
        const std::vector<lessons::Overlay> &all = fixture.view.shown().picture.overlays;
        const auto found = std::find_if(all.begin(), all.end(), [](const lessons::Overlay &one) {
            return one.shape == lessons::Overlay::Shape::ring;
        });
        return found == all.end() ? nullptr : &*found;
    };
    QVERIFY(!ring());
    fixture.desk.start("gravity_walls");
    QVERIFY(ring());
    QCOMPARE(ring()->a, (sim::Vec2{400.0, 150.0}));
    QCOMPARE(ring()->size, 12.0);
    const QImage with = fixture.view.picture();
    fixture.session.playback().frameForward();
    QVERIFY(ring());
    fixture.session.playback().goTo({});
    fixture.desk.putAway();
    QVERIFY(!ring());
    QVERIFY(fixture.view.picture() != with);
}

void ProjectsTest::thePageAfterALessonHasItsProject_data()
{
    QTest::addColumn<QString>("lesson");
    for (const LessonEntry &lesson : ProjectFixture::allLessons().lessons) {
        if (lesson.project)
            QTest::newRow(qPrintable(lesson.id)) << lesson.id;
    }
}

void ProjectsTest::thePageAfterALessonHasItsProject()
{
    QFETCH(QString, lesson);
    ProjectFixture window(lesson);
    QCOMPARE(window.project().lesson(), lesson);
    QVERIFY(window.project().isVisible());
    QCOMPARE(window.project().levels().size(), 3U);
    const auto buttons = window.project().findChildren<QToolButton *>();
    QVERIFY(!buttons.isEmpty());
    for (QToolButton *button : buttons)
        QVERIFY2(!button->toolTip().isEmpty(), qPrintable(button->objectName()));
}

void ProjectsTest::theFirstLevelIsUnfolded()
{
    ProjectFixture window("single_spring");
    QVERIFY(window.project().levels()[0]->isUnfolded());
    QVERIFY(!window.project().levels()[1]->isUnfolded());
    window.project().levels()[1]->setUnfolded(true);
    settle();
    QVERIFY(window.project().levels()[1]->findChild<QToolButton *>("judgeLevel")->isVisible());
}

void ProjectsTest::theBuildPanelShowsTheProjectThatIsBuilt()
{
    ProjectFixture window("multi_foot");
    QVERIFY(!window.card().isVisible());
    window.click(window.project(), "startProject");
    QVERIFY(window.session.isSandbox());
    QVERIFY(window.card().isVisible());
    QCOMPARE(window.card().lesson(), "multi_foot");
    QVERIFY(window.card().findChild<QWidget *>("projectBrief")->isVisible());
    window.click(window.card(), "foldProject");
    QVERIFY(!window.card().findChild<QWidget *>("projectBrief")->isVisible());
    window.press(window.card(), "foldProject");
    QVERIFY(window.card().findChild<QWidget *>("projectBrief")->isVisible());
}

void ProjectsTest::aBodyThatIsSelectedShowsItsNumbersBelowTheProject()
{
    ProjectFixture window("gravity_walls");
    window.click(window.project(), "startProject");
    QVERIFY(window.session.isSandbox());
    QVERIFY(window.card().isVisible());
    QVERIFY(window.card().visibleRegion().boundingRect().contains(0, 0)); // the task comes first
    const sim::Vec2 body = window.session.timeline().state().positionOf(0);
    QTest::mouseClick(window.view.viewport(), Qt::LeftButton, {}, window.view.mapFromScene(body.x, body.y));
    const PropertyRow &first = *window.part<BuildPanel>().rows().front();
    QTRY_COMPARE(first.visibleRegion().boundingRect(), first.rect());
}

void ProjectsTest::startingIsOneEditThatCanBeUndone()
{
    ProjectFixture window("multi_foot");
    window.session.openStep("sandbox", "build");
    window.session.openStep("multi_foot", "two_feet");
    window.panel.showSummary(true);
    settle();
    window.click(window.project(), "startProject");
    QVERIFY(window.session.timeline().track().interval().scene.find("stone") >= 0);
    QCOMPARE(window.session.editor().undoStack().count(), 1);
    window.session.editor().undo();
    QVERIFY(window.session.isSandbox());
    QVERIFY(window.session.timeline().track().interval().scene.find("stone") < 0);
    window.session.editor().redo();
    QVERIFY(window.session.timeline().track().interval().scene.find("stone") >= 0);
}

void ProjectsTest::aProjectOfTheListingKeepsItsPage()
{
    ProjectFixture window("single_spring");
    window.click(window.project(), "startProject");
    QCOMPARE(window.session.step().id, "fixed_centre");
    QVERIFY(window.session.code().isInUse());
    QVERIFY(window.project().isVisible());
    QVERIFY(!window.card().isVisible());
}

void ProjectsTest::aProjectOfTheListingReplacesWhatWasWrittenBefore()
{
    ProjectFixture window("single_spring");
    window.session.openStep("single_spring", "fixed_centre");
    window.session.code().write(window.session.code().text() + "// mine\n");
    QVERIFY(window.session.code().isInUse());
    window.session.editor().setMethod("published");
    QVERIFY(window.session.code().draft()); // kept while another method computes the run
    window.panel.showSummary(true);
    settle();
    window.click(window.project(), "startProject");
    QVERIFY(window.session.code().isRunning());
    QVERIFY(!window.session.code().text().contains("// mine"));
}

void ProjectsTest::aSolutionIsTickedByKeys()
{
    ProjectFixture window("single_spring");
    window.click(window.project(), "startProject");
    window.session.editor().setParameter("damp", 0.7);
    LevelBox &level = *window.project().levels().front();
    window.press(level, "judgeLevel");
    window.waitForJudge();
    QCOMPARE(window.sentenceOf(level), "Passed: everything holds.");
    QVERIFY(window.session.progress().isWritten("single_spring", "project", "on_time"));
    QCOMPARE(window.desk.passedLevels("single_spring"), 1);
}

void ProjectsTest::theMissingDemandIsNamed()
{
    ProjectFixture window("single_spring");
    window.click(window.project(), "startProject");
    LevelBox &level = *window.project().levels().front();
    window.click(level, "judgeLevel");
    window.waitForJudge();
    const QString sentence = window.sentenceOf(level);
    QVERIFY2(sentence.startsWith("Not yet: at the end, in frame 60"), qPrintable(sentence));
    QVERIFY(!window.session.progress().isWritten("single_spring", "project", "on_time"));
}

void ProjectsTest::theWholeVerdictIsInView()
{
    ProjectFixture window("single_spring", "de");
    window.click(window.project(), "startProject");
    LevelBox &level = *window.project().levels().front();
    window.click(level, "judgeLevel");
    window.waitForJudge();
    const auto &verdict = *level.findChild<QLabel *>("levelSentence");
    QVERIFY(verdict.height() > 2 * verdict.fontMetrics().height()); // more than one line
    const auto &judge = *level.findChild<QToolButton *>("judgeLevel");
    QTRY_COMPARE(verdict.visibleRegion().boundingRect(), verdict.rect());
    QTRY_COMPARE(judge.visibleRegion().boundingRect(), judge.rect());
    const int end = verdict.mapTo(&window.window, QPoint(0, verdict.height())).y();
    QVERIFY(end <= judge.mapTo(&window.window, QPoint()).y());
}

void ProjectsTest::thePageCountsTheLevels()
{
    ProjectFixture window("single_spring");
    const auto text = [&] {
        QString all;
        for (const NarrationText *one : window.part<SummaryPage>().findChildren<NarrationText *>())
            all += one->toPlainText() + '\n';
        return all;
    };
    QVERIFY2(text().contains("0 of 3 levels of the project passed."), qPrintable(text()));
    QVERIFY(text().contains("Still to pass: On time"));
    window.session.progress().markWritten("single_spring", projectTicks, "on_time");
    QVERIFY(text().contains("1 of 3 levels of the project passed."));
    QVERIFY(!text().contains("Still to pass: On time"));
    QVERIFY(text().contains("Still to pass: "));
    for (const lessons::ProjectLevel &level : window.session.lesson().project->levels)
        window.session.progress().markWritten("single_spring", projectTicks, level.id);
    QVERIFY(text().contains("Project: " + window.session.lesson().project->title + " ✓"));
}

void ProjectsTest::judgingCanBeCancelled()
{
    ProjectFixture window("hard_cases");
    window.desk.start("hard_cases");
    window.session.editor().replaceScene({"solution", {}, {}}, window.solution("hard_cases-heavy").script);
    window.desk.judge("hard_cases", "heavy");
    QCOMPARE(window.desk.judging("hard_cases"), "heavy");
    LevelBox &level = *window.card().levels()[1];
    level.setUnfolded(true);
    auto *cancel = level.findChild<QToolButton *>("cancelJudging");
    QVERIFY(cancel && !cancel->isHidden());
    cancel->click();
    QVERIFY(window.desk.judging("hard_cases").isEmpty());
    settle();
    QVERIFY(!window.desk.verdict("hard_cases", "heavy"));
}

void ProjectsTest::aHintIsShownAndHidden()
{
    ProjectFixture window("single_spring");
    LevelBox &level = *window.project().levels().front();
    auto *hint = level.findChild<QWidget *>("levelHint");
    QVERIFY(!hint->isVisible());
    window.press(level, "levelHintButton");
    QVERIFY(!hint->isHidden());
    window.press(level, "levelHintButton");
    QVERIFY(hint->isHidden());
}

void ProjectsTest::aBuiltSceneWaitsInTheProject()
{
    ProjectFixture window("multi_foot");
    window.click(window.project(), "startProject");
    const Experiment solution = window.solution("multi_foot-hangs");
    QVERIFY(window.session.editor().replaceScene({"solution", {}, {}}, solution.script));
    window.session.openStep("multi_foot", "two_feet");
    window.panel.showSummary(true);
    settle();
    window.click(*window.project().levels().front(), "judgeLevel"); // the scene that was left
    window.waitForJudge();
    QVERIFY(window.desk.isPassed("multi_foot", "hangs"));
    window.click(window.project(), "goOnProject");
    QVERIFY(window.session.isSandbox());
    QVERIFY(window.session.timeline().script().values == solution.script.values);
}

void ProjectsTest::puttingAwayKeepsTheScene()
{
    ProjectFixture window("multi_foot");
    window.click(window.project(), "startProject");
    const sim::Values before = window.session.timeline().script().values;
    window.click(window.card(), "putAwayProject");
    QVERIFY(!window.card().isVisible());
    QVERIFY(window.session.timeline().script().values == before);
}

void ProjectsTest::theCurrentProjectIsKnownAtTheNextStart()
{
    {
        ProjectFixture window("multi_foot");
        window.click(window.project(), "startProject");
    }
    ProjectFixture window("single_spring");
    QCOMPARE(window.desk.current(), "multi_foot");
    window.session.openStep("sandbox", "build");
    settle();
    QVERIFY(window.card().isVisible());
}

void ProjectsTest::germanTextsFit()
{
    ProjectFixture window("single_spring", "de");
    QCOMPARE(window.session.lesson().project->title, "Sanft landen");
    const LevelBox &level = *window.project().levels().front();
    int shown = 0;
    for (const QToolButton *button : level.findChildren<QToolButton *>()) {
        if (!button->isVisible())
            continue;
        ++shown;
        QVERIFY2(button->width() >= button->sizeHint().width(), qPrintable(button->text()));
    }
    QVERIFY(shown > 0);
    QVERIFY(window.project().width() <= window.panel.width());
}

SUITE(tst_projects, ProjectsTest)
#include "tst_projects.moc"
