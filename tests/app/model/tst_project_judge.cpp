// The judge of projects. A solution passes each level of each lesson, and the start scene does not.

#include "app/model/experiment/experiment.h"
#include "app/model/learning/project_judge.h"
#include "app/model/text/user_error.h"
#include "sim/methods/methods.h"
#include "tests/suite.h"

#include <QFile>
#include <QTest>

using namespace app;

namespace {

const LessonLibrary &judgedLibrary()
{
    static const LessonLibrary library = LessonLibrary::load({LESSON_DIR});
    return library;
}

Experiment startOfProject(const QString &lesson)
{
    QFile file(lessons::projectStartFile(lesson));
    if (!file.open(QIODevice::ReadOnly))
        qFatal("%s has no start scene", qPrintable(lesson));
    return parseExperiment(file.readAll(), lesson, judgedLibrary());
}

Experiment solutionOf(const QString &lesson, const QString &level)
{
    return readExperiment(QStringLiteral(TEST_DATA "/projects/%1-%2.json").arg(lesson, level),
                          judgedLibrary());
}

ProjectTrial trialOf(const QString &lesson, const QString &level, const Experiment &built)
{
    const Experiment start = startOfProject(lesson);
    ProjectTrial trial{
        {}, judgedLibrary().lesson(start.lesson)->step(start.step), start.script, built.script};
    for (const lessons::ProjectLevel &one : judgedLibrary().lesson(lesson)->project->levels) {
        if (one.id == level)
            trial.level = one;
    }
    return trial;
}

/// Returns a trial of the start scene of a lesson with a level that has one condition.
ProjectTrial trialWith(const QString &lesson, const QString &condition,
                       lessons::ProjectDemand::When when = lessons::ProjectDemand::When::always)
{
    const Experiment start = startOfProject(lesson);
    ProjectTrial trial{
        {}, judgedLibrary().lesson(start.lesson)->step(start.step), start.script, start.script};
    trial.level.id = "one";
    trial.level.run.frames = 60;
    trial.level.demands = {{when, condition, "it does so", 1}};
    return trial;
}

QString sentenceOn(const ProjectTrial &trial)
{
    return judgeProject(trial).value().sentence;
}

using Points = std::vector<sim::BlueprintPoint>;

/// Changes the points of the scene that was built.
void changePoints(ProjectTrial &trial, const std::function<void(Points &)> &change)
{
    sim::Blueprint plan = *trial.built.values.blueprint;
    change(plan.points);
    trial.built.values.blueprint = std::make_shared<const sim::Blueprint>(std::move(plan));
}

}

class ProjectJudgeTest : public QObject
{
    Q_OBJECT

private slots:
    void theSolutionPasses_data() { addLevelRows(); }
    void theSolutionPasses();
    void theStartSceneDoesNotPass_data() { addLevelRows(); }
    void theStartSceneDoesNotPass();
    void theFirstFrameThatFailsIsNamed();
    void aDemandThatIsNeverMetIsNamedWithTheLastFrame();
    void eachConditionHasAMark();
    void countsAreOfTheLearnersScene_data();
    void countsAreOfTheLearnersScene();
    void numbersOfTheWholeSceneAreThoseOfItsBodies_data();
    void numbersOfTheWholeSceneAreThoseOfItsBodies();
    void evaluationsAreThoseOfTheMethod_data();
    void evaluationsAreThoseOfTheMethod();
    void anotherParameterIsNamed();
    void anotherBodyIsNamed();
    void aMissingBodyIsNamed();
    void aMissingEffectIsNamed();
    void theLearnersInputIsLeftOut();
    void theRunOfTheLevelHasItsValues();
    void aRunThatStopsIsNamedWithItsFrame();
    void aDraftIsNotJudged();
    void progressGrowsToTheEnd();
    void canBeCancelled();

private:
    static void addLevelRows();
};

void ProjectJudgeTest::addLevelRows()
{
    QTest::addColumn<QString>("lesson");
    QTest::addColumn<QString>("level");
    for (const LessonEntry &lesson : judgedLibrary().lessons) {
        QVERIFY2(lesson.project, qPrintable(lesson.id));
        for (const lessons::ProjectLevel &level : lesson.project->levels)
            QTest::addRow("%s/%s", qPrintable(lesson.id), qPrintable(level.id)) << lesson.id << level.id;
    }
}

void ProjectJudgeTest::theSolutionPasses()
{
    QFETCH(QString, lesson);
    QFETCH(QString, level);
    const Experiment solution = solutionOf(lesson, level);
    const Experiment start = startOfProject(lesson);
    QCOMPARE(solution.lesson, start.lesson);
    QCOMPARE(solution.step, start.step);
    QVERIFY(!solution.draft);
    const ProjectVerdict verdict = judgeProject(trialOf(lesson, level, solution)).value();
    QVERIFY2(verdict.isPassed(), qPrintable(verdict.sentence));
}

void ProjectJudgeTest::theStartSceneDoesNotPass()
{
    QFETCH(QString, lesson);
    QFETCH(QString, level);
    const ProjectVerdict verdict = judgeProject(trialOf(lesson, level, startOfProject(lesson))).value();
    QVERIFY(!verdict.isPassed());
    QVERIFY2(verdict.sentence.startsWith("Not yet: "), qPrintable(verdict.sentence));
}

void ProjectJudgeTest::theFirstFrameThatFailsIsNamed()
{
    // The foot swings from 420 to 270 and beyond.
    const ProjectVerdict verdict = judgeProject(trialWith("single_spring", "foot.x > 265")).value();
    QCOMPARE(verdict.frame, 4);
    QCOMPARE(verdict.demand, 0);
    QVERIFY2(
        verdict.sentence.startsWith("Not yet: in frame 4, this does not hold: it does so (foot.x is 237."),
        qPrintable(verdict.sentence));
}

void ProjectJudgeTest::aDemandThatIsNeverMetIsNamedWithTheLastFrame()
{
    using When = lessons::ProjectDemand::When;
    const QString never = sentenceOn(trialWith("single_spring", "foot.x > 500", When::once));
    QVERIFY2(never.startsWith("Not yet: up to frame 60, this never happens: it does so (foot.x is "),
             qPrintable(never));
    const QString end = sentenceOn(trialWith("single_spring", "foot.x > 500", When::atTheEnd));
    QVERIFY2(end.startsWith("Not yet: at the end, in frame 60, this does not hold: "), qPrintable(end));
    const QString start = sentenceOn(trialWith("single_spring", "foot.x > 500", When::atTheStart));
    QVERIFY2(start.contains("at the start, this does not hold: it does so (foot.x is 420)"), // no ".0"
             qPrintable(start));
    QVERIFY(sentenceOn(trialWith("single_spring", "foot.x < 250", When::once)).isEmpty());
}

void ProjectJudgeTest::eachConditionHasAMark()
{
    using When = lessons::ProjectDemand::When;
    ProjectTrial trial = trialWith("single_spring", "foot.x > 100");
    trial.level.demands.push_back({When::once, "foot.x > 500", "never", 2});
    trial.level.demands.push_back({When::atTheEnd, "frame == 60", "ever", 3});
    const ProjectVerdict verdict = judgeProject(trial).value();
    QCOMPARE(verdict.met, (std::vector<bool>{true, false, true}));
    QCOMPARE(verdict.demand, 1);
}

void ProjectJudgeTest::countsAreOfTheLearnersScene_data()
{
    QTest::addColumn<QString>("lesson");
    QTest::addColumn<QString>("level"); ///< whose solution is counted; empty: the start scene
    QTest::addColumn<QString>("condition");
    QTest::newRow("points") << "multi_foot"
                            << ""
                            << "bodies == 7 and nails == 6 and springs == 0 and stiffest == 0";
    QTest::newRow("springs") << "multi_foot"
                             << "many"
                             << "springs == 5 and stiffest == 0.05";
    QTest::newRow("feet") << "walking_gait"
                          << ""
                          << "bodies == 11 and feet == 8 and sticks == 0";
    QTest::newRow("sticks") << "walking_gait"
                            << "carry"
                            << "sticks == 3 and stick_error < 0.001";
}

void ProjectJudgeTest::countsAreOfTheLearnersScene()
{
    QFETCH(QString, lesson);
    QFETCH(QString, level);
    QFETCH(QString, condition);
    ProjectTrial trial = trialWith(lesson, condition, lessons::ProjectDemand::When::atTheStart);
    if (!level.isEmpty())
        trial.built = solutionOf(lesson, level).script;
    QCOMPARE(sentenceOn(trial), QString());
}

void ProjectJudgeTest::numbersOfTheWholeSceneAreThoseOfItsBodies_data()
{
    QTest::addColumn<QString>("condition");
    QTest::newRow("leftmost") << "leftmost == body.x or leftmost == foot.x";
    QTest::newRow("rightmost") << "rightmost >= foot.x and rightmost >= body.x";
    QTest::newRow("highest") << "highest <= foot.y and highest <= body.y";
    QTest::newRow("lowest") << "lowest == foot.y or lowest == body.y";
    QTest::newRow("middle") << "abs(middle_x - (foot.x + body.x) / 2) < 0.000001";
    QTest::newRow("middle y") << "abs(middle_y - (foot.y + body.y) / 2) < 0.000001";
    QTest::newRow("fastest") << "fastest >= sqrt(foot.vx * foot.vx + foot.vy * foot.vy)";
    QTest::newRow("moved")
        << "moved >= sqrt((foot.x - 330) * (foot.x - 330) + (foot.y - 260) * (foot.y - 260)) - 0.000001";
}

void ProjectJudgeTest::numbersOfTheWholeSceneAreThoseOfItsBodies()
{
    QFETCH(QString, condition);
    QCOMPARE(sentenceOn(trialWith("two_body", condition)), QString());
}

void ProjectJudgeTest::evaluationsAreThoseOfTheMethod_data()
{
    QTest::addColumn<QString>("method");
    QTest::addColumn<double>("h");
    QTest::addColumn<int>("evaluations");
    QTest::newRow("one a step") << "semi_implicit_euler" << 1.0 << 60;
    QTest::newRow("small steps") << "semi_implicit_euler" << 0.25 << 240;
    QTest::newRow("four a step") << "rk4" << 1.0 << 240;
    QTest::newRow("long steps") << "rk4" << 2.0 << 120;
}

void ProjectJudgeTest::evaluationsAreThoseOfTheMethod()
{
    QFETCH(QString, method);
    QFETCH(double, h);
    QFETCH(int, evaluations);
    ProjectTrial trial = trialWith("accuracy", QStringLiteral("evaluations == %1").arg(evaluations),
                                   lessons::ProjectDemand::When::atTheEnd);
    trial.built.method = sim::findMethod(method.toStdString());
    trial.built.step = sim::StepSize::ofLength(h);
    QCOMPARE(sentenceOn(trial), QString());
}

void ProjectJudgeTest::anotherParameterIsNamed()
{
    ProjectTrial trial = trialWith("single_spring", "frame >= 0");
    trial.level.unchanged = {"k"};
    QCOMPARE(sentenceOn(trial), QString());
    trial.built.values.set("k", 0.3);
    const QString sentence = sentenceOn(trial);
    QVERIFY2(sentence.contains("Stiffness") && sentence.contains("at 0.2"), qPrintable(sentence));
}

void ProjectJudgeTest::anotherBodyIsNamed()
{
    ProjectTrial trial = trialWith("multi_foot", "frame >= 0");
    trial.level.unchanged = {"stone"};
    QCOMPARE(sentenceOn(trial), QString());
    changePoints(trial, [](Points &points) { points.back().mass = 1.0; });
    const QString sentence = sentenceOn(trial);
    QVERIFY2(sentence.contains("leave stone as it was"), qPrintable(sentence));
}

void ProjectJudgeTest::aMissingBodyIsNamed()
{
    ProjectTrial trial = trialWith("multi_foot", "stone.y < 1000");
    changePoints(trial, [](Points &points) { points.pop_back(); });
    const QString sentence = sentenceOn(trial);
    QVERIFY2(sentence.contains("has no body \"stone\"") && sentence.contains("Undo"), qPrintable(sentence));
    QVERIFY(judgeProject(trial).value().met.empty());
}

void ProjectJudgeTest::aMissingEffectIsNamed()
{
    ProjectTrial trial = trialWith("multi_foot", "frame >= 0");
    trial.level.effects = {"gravity"};
    QCOMPARE(sentenceOn(trial), QString());
    trial.built.effectsOff = {"gravity"};
    const QString sentence = sentenceOn(trial);
    QVERIFY2(sentence.contains("needs \"gravity\""), qPrintable(sentence));
}

void ProjectJudgeTest::theLearnersInputIsLeftOut()
{
    ProjectTrial trial = trialWith("multi_foot", "abs(stone.x - 270) < 0.001");
    trial.built.input = {{0, sim::Grab{"stone"}}, {1, sim::Move{{400, 200}}}, {5, sim::Release{}}};
    QCOMPARE(sentenceOn(trial), QString());
}

void ProjectJudgeTest::theRunOfTheLevelHasItsValues()
{
    ProjectTrial trial = trialWith("multi_foot", "stone.y == 200");
    trial.level.run.values = {{"gravity", "0"}};
    QCOMPARE(sentenceOn(trial), QString());
    trial.level.run.drags = {{"stone", {350, 200}, 20}};
    trial.level.demands = {
        {lessons::ProjectDemand::When::once, "abs(stone.x - 350) < 0.001", "it is dragged", 1}};
    QCOMPARE(sentenceOn(trial), QString());
}

void ProjectJudgeTest::aRunThatStopsIsNamedWithItsFrame()
{
    ProjectTrial trial = trialWith("single_spring", "frame >= 0");
    trial.built.values.set("k", 1e9);
    trial.built.values.set("damp", 1.0);
    trial.level.run.frames = 2000;
    const ProjectVerdict verdict = judgeProject(trial).value();
    QVERIFY2(verdict.sentence.startsWith("Not yet: the run stops in frame "), qPrintable(verdict.sentence));
    QVERIFY(verdict.frame > 0 && verdict.frame < 2000);
}

void ProjectJudgeTest::aDraftIsNotJudged()
{
    ProjectTrial trial = trialWith("single_spring", "frame >= 0");
    trial.hasDraft = true;
    QVERIFY(sentenceOn(trial).contains("does not use what you have written"));
}

void ProjectJudgeTest::progressGrowsToTheEnd()
{
    std::vector<int> reported;
    const auto verdict = judgeProject(trialWith("single_spring", "frame >= 0"),
                                      [&](int percent) { reported.push_back(percent); });
    QVERIFY(verdict->isPassed());
    QVERIFY(std::is_sorted(reported.begin(), reported.end()));
    QCOMPARE(reported.back(), 100);
}

void ProjectJudgeTest::canBeCancelled()
{
    int frames = 0;
    const auto verdict =
        judgeProject(trialWith("single_spring", "frame >= 0"), {}, [&] { return ++frames < 10; });
    QVERIFY(!verdict);
}

SUITE(tst_project_judge, ProjectJudgeTest)
#include "tst_project_judge.moc"
