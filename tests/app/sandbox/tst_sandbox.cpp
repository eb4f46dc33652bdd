// Building a scene: every edit can be undone, and the scene of a lesson can be copied.

#include "app/model/sandbox/sandbox.h"
#include "app/model/sandbox/sandbox_editor.h"
#include "tests/app/experiment/experiment_support.h"
#include "tests/suite.h"

#include <QSignalSpy>
#include <QTest>

#include <random>

using namespace app;
using experiment_support::library;

namespace {

struct SandboxWorld
{
    SandboxWorld() { session.openStep("sandbox", "build"); }
    const sim::Blueprint &plan() const { return editor.plan(); }
    QString lastSaid() const { return said.isEmpty() ? QString() : said.last().first().toString(); }

    Session session{library()};
    SandboxEditor editor{session};
    QSignalSpy said{&session.changes(), &ChangeNotifier::messageRequested};
};

/// A bareTriangle of points without anything else.
sim::Blueprint bareTriangle()
{
    sim::Blueprint plan;
    plan.points = {{"p0", {0, 0}, {}}, {"p1", {30, 40}, {}}, {"p2", {0, 100}, {}}};
    return plan;
}

/// Returns a copy of the scene of a lesson's step after `frames` frames, with another method if one is given.
ExportedScene taken(const QString &lesson, const QString &step, std::int64_t frames = 0,
                    const QString &method = {})
{
    Session session(library());
    session.openStep(lesson, step);
    if (!method.isEmpty())
        session.editor().setMethod(method);
    session.playback().goTo({frames, 0});
    return takenScene(session, library().sandboxes.front().steps.front());
}

}

class SandboxTest : public QObject
{
    Q_OBJECT

private slots:
    void eachEditIsOneEntryAndComesBackWithTheSameBits()
    {
        SandboxWorld world;
        const sim::Blueprint start = world.plan();
        world.editor.setTool(BuildTool::spring);
        world.editor.use({100, 100}, -1); // a point, where the spring begins
        world.editor.use({160, 100}, -1); // a point and the spring
        QCOMPARE(world.plan().points.size(), start.points.size() + 2);
        QCOMPARE(world.plan().springs.back().length, 60.0);
        QCOMPARE(world.session.editor().undoStack().count(), 2); // one a click
        world.editor.setTool(BuildTool::select);
        world.editor.choose({{2}, {}, {}});
        for (int i = 0; i < 10; ++i)
            world.editor.moveChosen({1, 0}); // one drag
        world.session.editor().endGesture();
        QCOMPARE(world.session.editor().undoStack().count(), 3);
        world.session.playback().goTo({20, 0});
        const sim::State after = world.session.timeline().state();
        const sim::Blueprint end = world.plan();
        while (world.session.editor().undoStack().canUndo())
            world.session.editor().undo();
        QVERIFY(world.plan() == start);
        while (world.session.editor().undoStack().canRedo())
            world.session.editor().redo();
        QVERIFY(world.plan() == end);
        world.session.playback().goTo({20, 0});
        QVERIFY(sim::sameBits(world.session.timeline().state(), after));
    }

    void randomEditsAreAllUndone()
    {
        SandboxWorld world;
        std::mt19937 random(11);
        const auto upTo = [&](int most) { return std::uniform_int_distribution<int>(0, most)(random); };
        const sim::Blueprint start = world.plan();
        const QStringList effects = {"push", "gravity", "breeze", "damping",
                                     "room", "walls",   "ramp",   "ground"};
        for (int i = 0; i < 90; ++i) {
            const int points = static_cast<int>(world.plan().points.size());
            world.editor.setTool(BuildTool(upTo(6)));
            const sim::Vec2 at{double(upTo(500)), double(upTo(380))};
            switch (upTo(6)) {
            case 0:
                world.editor.choose({{upTo(points - 1)}, {}, {}});
                world.editor.eraseChosen();
                break;
            case 1:
                world.editor.choose(inBox(world.plan(), at, {at.x + 150, at.y + 150}));
                world.editor.duplicateChosen();
                break;
            case 2:
                world.editor.choose({{upTo(points - 1)}, {}, {}});
                world.editor.moveChosen({double(upTo(40)) - 20, double(upTo(40)) - 20});
                world.session.editor().endGesture();
                break;
            case 3: {
                const bool isOn =
                    upTo(1) == 1; // drawn first: compilers evaluate arguments in different orders
                world.editor.setEffect(effects[upTo(int(effects.size()) - 1)], isOn);
                break;
            }
            default:
                world.editor.use(at, upTo(2) == 0 ? -1 : upTo(points - 1));
            }
            const QByteArray text = experimentText(world.session.experiment(), library());
            QVERIFY(*parseExperiment(text, "x.json", library()).script.values.blueprint == world.plan());
        }
        QVERIFY(world.session.editor().undoStack().count() > 30);
        while (world.session.editor().undoStack().canUndo())
            world.session.editor().undo();
        QVERIFY(world.plan() == start);
    }

    void linkBeyondTheLimitIsRefusedWithASentence()
    {
        SandboxWorld world;
        sim::Blueprint full = world.plan();
        addPoint(full, {300, 300});
        while (addSpring(full, 0, 1))
            ;
        QVERIFY(world.session.editor().build({"full", {}, {}}, full));
        world.said.clear();
        world.editor.setTool(BuildTool::spring);
        world.editor.use({}, 0);
        world.editor.use({}, 1);
        QVERIFY2(world.lastSaid().startsWith("The scene has too many of this kind"),
                 qPrintable(world.lastSaid()));
        world.said.clear();
        world.editor.use({50, 50}, -1); // no point without its spring, either
        QVERIFY2(world.lastSaid().startsWith("The scene has too many of this kind"),
                 qPrintable(world.lastSaid()));
        QVERIFY(world.plan() == full);
    }

    void aCopyThatDoesNotFitIsRefusedAsAWhole_data()
    {
        QTest::addColumn<QString>("full");
        for (const char *full : {"points", "springs", "sticks", "far away"})
            QTest::newRow(full) << QString(full);
    }
    void aCopyThatDoesNotFitIsRefusedAsAWhole()
    {
        QFETCH(QString, full);
        SandboxWorld world;
        sim::Blueprint plan = bareTriangle();
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
        QVERIFY(world.session.editor().build({"full", {}, {}}, plan));
        world.said.clear();
        const int edits = world.session.editor().undoStack().count();
        world.editor.choose({{0, 1, 2}, {}, {}});
        world.editor.duplicateChosen();
        QVERIFY(world.plan() == plan);
        QCOMPARE(world.session.editor().undoStack().count(), edits);
        QCOMPARE(world.said.count(), 1);
        QVERIFY2(world.lastSaid().startsWith("With this copy, the scene would have too many parts"),
                 qPrintable(world.lastSaid()));
        world.editor.choose({{2}, {}, {}}); // one has room, where it is points that are many
        world.editor.duplicateChosen();
        QCOMPARE(world.session.editor().undoStack().count(), edits + (full == "far away" ? 0 : 1));
        if (full == "far away")
            return;
        QCOMPARE(world.plan().points.size(), plan.points.size() + 1);
        world.session.editor().undo(); // one entry
        QVERIFY(world.plan() == plan);
    }

    void aLinkIsNoLongerThanAFileCanHold()
    {
        SandboxWorld world;
        world.editor.setTool(BuildTool::stick);
        world.editor.use({-1e6, -1e6}, -1);
        world.editor.use({1e6, 1e6}, -1);
        world.editor.setTool(BuildTool::spring);
        world.editor.use({}, int(world.plan().points.size()) - 1);
        world.editor.use({}, int(world.plan().points.size()) - 2);
        QCOMPARE(world.plan().springs.back().length, 1e6);
        const QByteArray text = experimentText(world.session.experiment(), library());
        QVERIFY(*parseExperiment(text, "x.json", library()).script.values.blueprint == world.plan());
    }

    void buildingIsPossibleOnlyAtTheStart()
    {
        SandboxWorld world;
        world.session.playback().goTo({5, 0});
        QVERIFY(!world.editor.canBuild());
        const sim::Blueprint before = world.plan();
        world.editor.setTool(BuildTool::point);
        world.editor.use({10, 10}, -1);
        QVERIFY(world.plan() == before);
        QCOMPARE(world.lastSaid(),
                 QString("You can only build at the start of the run. Press Home to go there."));
        world.session.editor().restart();
        QVERIFY(world.editor.canBuild());
        world.editor.use({10, 10}, -1);
        QCOMPARE(world.plan().points.size(), before.points.size() + 1);
    }

    void theLastBodyThatCanMoveCannotBeDeleted()
    {
        SandboxWorld world;
        const sim::Blueprint before = world.plan();
        world.editor.choose({{1}, {}, {}}); // the only one that can move
        world.editor.eraseChosen();
        QVERIFY(world.plan() == before);
        QCOMPARE(world.lastSaid(), QString("Nothing in this scene can move. Leave at least one body free."));
        world.editor.chooseAll();
        world.editor.eraseChosen();
        QVERIFY(world.plan() == before);
    }

    void anEffectThatIsTakenAwayIsNotLeftSwitchedOff()
    {
        SandboxWorld world;
        world.session.editor().setEffect("gravity", false);
        world.editor.setEffect("gravity", false);
        QVERIFY(world.session.timeline().script().effectsOff.empty());
        QVERIFY(!world.editor.has("gravity"));
        world.session.editor().undo();
        QVERIFY(world.editor.has("gravity"));
        QVERIFY(world.session.editor().isOff("gravity"));
    }

    void copiedSceneRunsLikeTheOriginal_data()
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
    void copiedSceneRunsLikeTheOriginal()
    {
        QFETCH(QString, lesson);
        QFETCH(QString, step);
        QFETCH(QString, method);
        Session session(library());
        session.openStep(lesson, step);
        session.editor().setMethod(method);
        session.playback().goTo({10, 0});
        const ExportedScene scene = takenScene(session, library().sandboxes.front().steps.front());
        QCOMPARE(scene.script.method->id(), method.toStdString());
        sim::Timeline built(scene.script);
        for (int frame = 0; frame <= 100; frame += 20) {
            built.seek({frame, 0});
            session.playback().goTo({10 + frame, 0});
            const sim::State &now = session.timeline().state();
            for (int i = 0; i < now.pointCount(); ++i)
                QVERIFY2(sim::length(built.state().positionOf(i) - now.positionOf(i)) < 1e-6,
                         qPrintable(QStringLiteral("frame %1, point %2").arg(frame).arg(i)));
        }
        QVERIFY(scene.sentence.startsWith("This is your own copy"));
    }

    void effectsThatCannotBeCopiedAreNamed()
    {
        QCOMPARE(taken("rigid_constraint", "ragdoll").sentence,
                 QString("This is your own copy of the scene. It could not be copied completely. Missing: "
                         "joint limits."));
        QCOMPARE(taken("multi_foot", "any_number").sentence,
                 QString("This is your own copy of the scene. It could not be copied completely. Missing: "
                         "the order in which points move (feet, body), because here all move at once."));
        QCOMPARE(taken("multi_foot", "any_number", 0, "semi_implicit_euler").sentence,
                 QString("This is your own copy of the scene: change what you like."));
        try {
            taken("swaying_tree", "wind");
            QFAIL("a tree was taken");
        } catch (const UserError &error) {
            QVERIFY(error.sentence().contains("joints"));
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
                    const ExportedScene scene =
                        takenScene(session, library().sandboxes.front().steps.front());
                    sim::Timeline run(scene.script); // throws where it does not compose
                    QVERIFY(!scene.sentence.isEmpty());
                    Experiment experiment = newExperiment("sandbox", "build", library());
                    experiment.script = scene.script;
                    const QByteArray text = experimentText(experiment, library());
                    QVERIFY(*parseExperiment(text, "x.json", library()).script.values.blueprint ==
                            *scene.script.values.blueprint);
                    ++takenScenes;
                } catch (const UserError &error) {
                    QVERIFY(error.sentence().endsWith('.'));
                }
            }
        }
        QVERIFY(takenScenes > 30);
    }

    void aSceneThatHasFlownApartIsNotCopied()
    {
        Session session(library());
        session.openStep("two_body", "mutual");
        session.editor().setMethod("explicit_euler");
        session.editor().setParameter("k", session.step().parameter("k")->max);
        session.playback().goTo({100'000, 0});
        QTRY_VERIFY(!session.playback().goal());
        QVERIFY(session.timeline().stop());
        try {
            takenScene(session, library().sandboxes.front().steps.front());
            QFAIL("a scene was taken that no file can hold");
        } catch (const UserError &error) {
            QVERIFY2(error.sentence().contains("flown apart"), qPrintable(error.sentence()));
        }
    }

    void takingASceneCanBeUndone()
    {
        SandboxWorld world;
        world.editor.setTool(BuildTool::point);
        world.editor.use({50, 60}, -1);
        const sim::Blueprint mine = world.plan();
        world.session.openStep("multi_foot", "any_number");
        takeToSandbox(world.session);
        QVERIFY(world.session.isSandbox());
        QCOMPARE(world.plan().points.size(), std::size_t(6));
        world.session.editor().undo();
        QVERIFY(world.plan() == mine);
    }

    void anExampleAndANewSceneCanBeUndone()
    {
        SandboxWorld world;
        const sim::Blueprint mine = world.plan();
        QVERIFY(
            takeExample(world.session.run(), world.session.editor(), world.session.step().examples.front()));
        QVERIFY(!(world.plan() == mine));
        QVERIFY(startEmpty(world.session.run(), world.session.editor()));
        QCOMPARE(world.plan().points.size(), std::size_t(1));
        world.session.editor().undo();
        world.session.editor().undo();
        QVERIFY(world.plan() == mine);
    }
};

SUITE(tst_sandbox, SandboxTest)
#include "tst_sandbox.moc"
