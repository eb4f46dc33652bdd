// Building a scene: that all of it can be undone, and how a lesson's scene becomes one.

#include "app/model/workbench.h"
#include "app/model/workshop.h"

#include <QSettings>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include <random>

using namespace app;

namespace {

const LessonLibrary &library()
{
    static const LessonLibrary loaded = LessonLibrary::load({LESSON_DIR});
    return loaded;
}

struct World
{
    World() { session.openStep("sandbox", "build"); }
    const sim::Blueprint &plan() const { return bench.plan(); }
    QString lastSaid() const { return said.isEmpty() ? QString() : said.last().first().toString(); }

    Session session{library()};
    Workbench bench{session};
    QSignalSpy said{&session, &Session::said};
};

/// A triangle of points without anything else.
sim::Blueprint triangle()
{
    sim::Blueprint plan;
    plan.points = {{"p0", {0, 0}, {}}, {"p1", {30, 40}, {}}, {"p2", {0, 100}, {}}};
    return plan;
}

/// The scene of a lesson's step, taken over after `frames` frames, with another method if one is given.
TakenScene taken(const QString &lesson, const QString &step, std::int64_t frames = 0,
                 const QString &method = {})
{
    Session session(library());
    session.openStep(lesson, step);
    if (!method.isEmpty())
        session.setMethod(method);
    session.goTo({frames, 0});
    return takenScene(session, library().workshops.front().steps.front());
}

}

class WorkshopTest : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QSettings::setDefaultFormat(QSettings::IniFormat);
        QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, m_folder.path());
    }

    void eachDeedIsOneEntryAndComesBackWithTheSameBits()
    {
        World world;
        const sim::Blueprint start = world.plan();
        world.bench.setTool(BuildTool::spring);
        world.bench.use({100, 100}, -1); // a point, where the spring begins
        world.bench.use({160, 100}, -1); // a point and the spring
        QCOMPARE(world.plan().points.size(), start.points.size() + 2);
        QCOMPARE(world.plan().springs.back().length, 60.0);
        QCOMPARE(world.session.deeds().count(), 2); // one a click
        world.bench.setTool(BuildTool::select);
        world.bench.choose({{2}, {}, {}});
        for (int i = 0; i < 10; ++i)
            world.bench.moveChosen({1, 0}); // one drag
        world.session.endGesture();
        QCOMPARE(world.session.deeds().count(), 3);
        world.session.goTo({20, 0});
        const sim::State after = world.session.timeline().state();
        const sim::Blueprint end = world.plan();
        while (world.session.deeds().canUndo())
            world.session.undo();
        QVERIFY(world.plan() == start);
        while (world.session.deeds().canRedo())
            world.session.redo();
        QVERIFY(world.plan() == end);
        world.session.goTo({20, 0});
        QVERIFY(sim::sameBits(world.session.timeline().state(), after));
    }

    void randomEditsAreAllUndone()
    {
        World world;
        std::mt19937 random(11);
        const auto upTo = [&](int most) { return std::uniform_int_distribution<int>(0, most)(random); };
        const sim::Blueprint start = world.plan();
        const QStringList effects = {"push", "gravity", "breeze", "damping",
                                     "room", "walls",   "ramp",   "ground"};
        for (int i = 0; i < 90; ++i) {
            const int points = static_cast<int>(world.plan().points.size());
            world.bench.setTool(BuildTool(upTo(5)));
            const sim::Vec2 at{double(upTo(500)), double(upTo(380))};
            switch (upTo(6)) {
            case 0:
                world.bench.choose({{upTo(points - 1)}, {}, {}});
                world.bench.eraseChosen();
                break;
            case 1:
                world.bench.choose(inBox(world.plan(), at, {at.x + 150, at.y + 150}));
                world.bench.duplicateChosen();
                break;
            case 2:
                world.bench.choose({{upTo(points - 1)}, {}, {}});
                world.bench.moveChosen({double(upTo(40)) - 20, double(upTo(40)) - 20});
                world.session.endGesture();
                break;
            case 3:
                world.bench.setEffect(effects[upTo(int(effects.size()) - 1)], upTo(1) == 1);
                break;
            default:
                world.bench.use(at, upTo(2) == 0 ? -1 : upTo(points - 1));
            }
            const QByteArray text = experimentText(world.session.experiment(), library());
            QVERIFY(*parseExperiment(text, "x.json", library()).script.values.blueprint == world.plan());
        }
        QVERIFY(world.session.deeds().count() > 30);
        while (world.session.deeds().canUndo())
            world.session.undo();
        QVERIFY(world.plan() == start);
    }

    void whereThereIsNoRoomForALinkThatIsSaidAndNothingChanges()
    {
        World world;
        sim::Blueprint full = world.plan();
        addPoint(full, {300, 300});
        while (addSpring(full, 0, 1))
            ;
        QVERIFY(world.session.build({"full", {}, {}}, full));
        world.said.clear();
        world.bench.setTool(BuildTool::spring);
        world.bench.use({}, 0);
        world.bench.use({}, 1);
        QVERIFY2(world.lastSaid().startsWith("There is no room"), qPrintable(world.lastSaid()));
        world.said.clear();
        world.bench.use({50, 50}, -1); // no point without its spring, either
        QVERIFY2(world.lastSaid().startsWith("There is no room"), qPrintable(world.lastSaid()));
        QVERIFY(world.plan() == full);
    }

    void whereNotAllOfACopyHasRoomNothingIsCopiedAndThatIsSaid_data()
    {
        QTest::addColumn<QString>("full");
        for (const char *full : {"points", "springs", "sticks", "far away"})
            QTest::newRow(full) << QString(full);
    }
    void whereNotAllOfACopyHasRoomNothingIsCopiedAndThatIsSaid()
    {
        QFETCH(QString, full);
        World world;
        sim::Blueprint plan = triangle();
        addSpring(plan, 0, 1);
        addStick(plan, 0, 1);
        while (full == "points" && plan.points.size() < 998)
            addPoint(plan, {300, 300});
        while (full == "springs" && addSpring(plan, 0, 1))
            ;
        while (full == "sticks" && addStick(plan, 0, 1))
            ;
        if (full == "far away")
            plan.points[2].x = {1e6, 0};
        QVERIFY(world.session.build({"full", {}, {}}, plan));
        world.said.clear();
        const int deeds = world.session.deeds().count();
        world.bench.choose({{0, 1, 2}, {}, {}});
        world.bench.duplicateChosen();
        QVERIFY(world.plan() == plan);
        QCOMPARE(world.session.deeds().count(), deeds);
        QCOMPARE(world.said.count(), 1);
        QVERIFY2(world.lastSaid().startsWith("There is no room for a copy"), qPrintable(world.lastSaid()));
        world.bench.choose({{2}, {}, {}}); // one has room, where it is points that are many
        world.bench.duplicateChosen();
        QCOMPARE(world.session.deeds().count(), deeds + (full == "far away" ? 0 : 1));
        if (full == "far away")
            return;
        QCOMPARE(world.plan().points.size(), plan.points.size() + 1);
        world.session.undo(); // one entry
        QVERIFY(world.plan() == plan);
    }

    void aLinkIsNoLongerThanAFileCanHold()
    {
        World world;
        world.bench.setTool(BuildTool::stick);
        world.bench.use({-1e6, -1e6}, -1);
        world.bench.use({1e6, 1e6}, -1);
        world.bench.setTool(BuildTool::spring);
        world.bench.use({}, int(world.plan().points.size()) - 1);
        world.bench.use({}, int(world.plan().points.size()) - 2);
        QCOMPARE(world.plan().springs.back().length, 1e6);
        const QByteArray text = experimentText(world.session.experiment(), library());
        QVERIFY(*parseExperiment(text, "x.json", library()).script.values.blueprint == world.plan());
    }

    void buildingHappensAtTheStart()
    {
        World world;
        world.session.goTo({5, 0});
        QVERIFY(!world.bench.canBuild());
        const sim::Blueprint before = world.plan();
        world.bench.setTool(BuildTool::point);
        world.bench.use({10, 10}, -1);
        QVERIFY(world.plan() == before);
        QCOMPARE(world.lastSaid(),
                 QString("Building happens at the start of the run: press Home to go there."));
        world.session.restart();
        QVERIFY(world.bench.canBuild());
        world.bench.use({10, 10}, -1);
        QCOMPARE(world.plan().points.size(), before.points.size() + 1);
    }

    void whatCannotMoveIsNotLeftAlone()
    {
        World world;
        const sim::Blueprint before = world.plan();
        world.bench.choose({{1}, {}, {}}); // the only one that can move
        world.bench.eraseChosen();
        QVERIFY(world.plan() == before);
        QCOMPARE(world.lastSaid(), QString("Nothing in this scene can move: leave at least one body free."));
        world.bench.chooseAll();
        world.bench.eraseChosen();
        QVERIFY(world.plan() == before);
    }

    void anEffectThatIsTakenAwayIsNotLeftSwitchedOff()
    {
        World world;
        world.session.setEffect("gravity", false);
        world.bench.setEffect("gravity", false);
        QVERIFY(world.session.timeline().script().effectsOff.empty());
        QVERIFY(!world.bench.has("gravity"));
        world.session.undo();
        QVERIFY(world.bench.has("gravity"));
        QVERIFY(world.session.isOff("gravity"));
    }

    void aTakenSceneRunsAsItDid_data()
    {
        QTest::addColumn<QString>("lesson");
        QTest::addColumn<QString>("step");
        QTest::addColumn<QString>("method");
        const std::vector<std::pair<const char *, const char *>> steps = {
            {"two_body", "mutual"},           {"multi_foot", "any_number"}, {"gravity_walls", "gravity"},
            {"gravity_walls", "walls"},       {"walking_gait", "ground"},   {"walking_gait", "walls"},
            {"single_spring", "fixed_centre"}};
        for (const auto &[lesson, step] : steps)
            QTest::addRow("%s/%s", lesson, step) << lesson << step << "semi_implicit_euler";
        QTest::addRow("rigid_constraint/verlet") << "rigid_constraint"
                                                 << "verlet"
                                                 << "semi_implicit_euler";
    }
    void aTakenSceneRunsAsItDid()
    {
        QFETCH(QString, lesson);
        QFETCH(QString, step);
        QFETCH(QString, method);
        Session session(library());
        session.openStep(lesson, step);
        session.setMethod(method);
        session.goTo({10, 0});
        const TakenScene scene = takenScene(session, library().workshops.front().steps.front());
        QCOMPARE(scene.script.method->id(), method.toStdString());
        sim::Timeline built(scene.script);
        for (int frame = 0; frame <= 100; frame += 20) {
            built.seek({frame, 0});
            session.goTo({10 + frame, 0});
            const sim::State &now = session.timeline().state();
            for (int i = 0; i < now.pointCount(); ++i)
                QVERIFY2(sim::length(built.state().positionOf(i) - now.positionOf(i)) < 1e-6,
                         qPrintable(QStringLiteral("frame %1, point %2").arg(frame).arg(i)));
        }
        QVERIFY(scene.sentence.startsWith("This is your own copy"));
    }

    void whatIsNotTakenAlongIsNamed()
    {
        QCOMPARE(taken("rigid_constraint", "ragdoll").sentence,
                 QString("This is your own copy of the scene. What could not be taken along: joint limits."));
        QCOMPARE(taken("multi_foot", "any_number").sentence,
                 QString("This is your own copy of the scene. What could not be taken along: the order in "
                         "which points "
                         "move (feet, body), as here all move at once."));
        QCOMPARE(taken("multi_foot", "any_number", 0, "semi_implicit_euler").sentence,
                 QString("This is your own copy of the scene: change what you like."));
        try {
            taken("swaying_tree", "wind");
            QFAIL("a tree was taken");
        } catch (const Refusal &refusal) {
            QVERIFY(refusal.sentence().contains("joints"));
        }
    }

    void everyStepIsTakenOrRefusedInASentence()
    {
        int takenScenes = 0;
        for (const LessonEntry &lesson : library().lessons) {
            for (const lessons::Step &step : lesson.steps) {
                Session session(library());
                session.openStep(lesson.id, step.id);
                try {
                    const TakenScene scene = takenScene(session, library().workshops.front().steps.front());
                    sim::Timeline run(scene.script); // throws where it does not compose
                    QVERIFY(!scene.sentence.isEmpty());
                    Experiment experiment = newExperiment("sandbox", "build", library());
                    experiment.script = scene.script;
                    const QByteArray text = experimentText(experiment, library());
                    QVERIFY(*parseExperiment(text, "x.json", library()).script.values.blueprint ==
                            *scene.script.values.blueprint);
                    ++takenScenes;
                } catch (const Refusal &refusal) {
                    QVERIFY(refusal.sentence().endsWith('.'));
                }
            }
        }
        QVERIFY(takenScenes > 30);
    }

    void whatHasFlownApartIsNotTaken()
    {
        Session session(library());
        session.openStep("two_body", "mutual");
        session.setMethod("explicit_euler");
        session.setParameter("k", session.step().parameter("k")->max);
        session.goTo({100'000, 0});
        QTRY_VERIFY(!session.goingTo());
        QVERIFY(session.timeline().stop());
        try {
            takenScene(session, library().workshops.front().steps.front());
            QFAIL("a scene was taken that no file can hold");
        } catch (const Refusal &refusal) {
            QVERIFY2(refusal.sentence().contains("flown apart"), qPrintable(refusal.sentence()));
        }
    }

    void takingASceneCanBeUndone()
    {
        World world;
        world.bench.setTool(BuildTool::point);
        world.bench.use({50, 60}, -1);
        const sim::Blueprint mine = world.plan();
        world.session.openStep("multi_foot", "any_number");
        takeToWorkshop(world.session);
        QVERIFY(world.session.isWorkshop());
        QCOMPARE(world.plan().points.size(), std::size_t(6));
        world.session.undo();
        QVERIFY(world.plan() == mine);
    }

    void anExampleAndANewSceneCanBeUndone()
    {
        World world;
        const sim::Blueprint mine = world.plan();
        QVERIFY(takeExample(world.session, world.session.step().examples.front()));
        QVERIFY(!(world.plan() == mine));
        QVERIFY(startEmpty(world.session));
        QCOMPARE(world.plan().points.size(), std::size_t(1));
        world.session.undo();
        world.session.undo();
        QVERIFY(world.plan() == mine);
    }

private:
    QTemporaryDir m_folder;
};

QTEST_GUILESS_MAIN(WorkshopTest)
#include "tst_workshop.moc"
