// The companion run beside the run of a step, the note of a step, and steps that open with input.

#include "app/model/experiment/experiment.h"
#include "app/ui/scene/drawing/overlay_labels.h"
#include "lessons/api/creature.h"
#include "lessons/api/parameters.h"
#include "lessons/api/view/creature_view.h"
#include "sim/effects/constraints/sticks.h"
#include "sim/methods/methods.h"
#include "tests/app/scene/scene_support.h"
#include "tests/suite.h"

#include <QtTest>

using namespace app;

namespace {

sim::Scene footOnASpring(const sim::Values &values)
{
    return scenes::oscillator({310, 200}, {270, 200}, values["k"], values["damp"]);
}

lessons::Step footStep()
{
    lessons::Step step;
    step.id = step.title = "foot";
    step.parameters = {lessons::stiffness(0.2), lessons::damping(1.0)};
    step.scene = footOnASpring;
    step.view = [](const sim::Scene &scene, const sim::Values &) {
        lessons::View view = lessons::creatureView(scene);
        view.bodies[0].radius = 8.0;
        view.stage = QRectF(220, 150, 100, 80);
        return view;
    };
    step.method = "explicit_euler";
    step.companion = lessons::Companion{"implicit_midpoint", "calm", {0, 100}};
    return step;
}

/// With the second choice of its parameter, the step opens with a drag and steps of half a frame.
lessons::Step openedStep()
{
    lessons::Step step = footStep();
    step.companion.reset();
    lessons::Parameter which = lessons::choice("which", "Which", "Which one.", {"one", "other"});
    which.restartsRun = true;
    step.parameters.push_back(which);
    step.prepareScript = [](sim::Script &script) {
        if (script.values.integer("which") == 0)
            return;
        script.input = {{3, sim::Grab{"foot"}}, {3, sim::Move{{280, 150}}}, {5, sim::Release{}}};
        if (!script.step.isAdaptive())
            script.step = sim::StepSize::ofLength(0.5);
    };
    step.note = [](const sim::Track &run) {
        return QStringLiteral("this is frame %1").arg(run.cursor().frame);
    };
    return step;
}

LessonLibrary libraryOf(const lessons::Step &step)
{
    LessonEntry entry;
    entry.id = entry.title = "made";
    entry.steps = {step};
    LessonLibrary library;
    library.lessons = {entry};
    return library;
}

/// The script of `run` by implicit midpoint, after as many frames.
sim::State companionState(const sim::Timeline &run)
{
    sim::Script script = run.script();
    script.method = sim::findMethod("implicit_midpoint");
    script.step = sim::StepSize::ofLength(1.0);
    sim::Track track(script, 0);
    track.seek({run.cursor().frame, 0});
    return track.state();
}

bool isBeside(const Session &session)
{
    const std::optional<Picture> companion = session.presentation().companion();
    return companion && sim::sameBits(companion->state, companionState(session.timeline()));
}

}

class CompanionTest : public QObject
{
    Q_OBJECT

private slots:
    void companionFollowsTheCursor();
    void companionFollowsEdits();
    void companionReachesADistantFrame();
    void thereIsNoCompanionIfItsMethodCannotComputeTheScene();
    void companionIsDrawnAtItsOffset();
    void eachFigureHasItsCaption();
    void aCaptionIsNoWiderThanItsFigure();
    void aStepWithoutOneHasNone();
    void anotherChoiceRestartsTheRun();
    void aRefusedChoiceLeavesTheRunAsItWas();
    void theOpeningOfAStepIsNotWritten();
    void theInputOfAFileReplacesTheOpening();
    void theNoteStandsOverTheScene();
};

void CompanionTest::companionFollowsTheCursor()
{
    const LessonLibrary library = libraryOf(footStep());
    Session session(library);
    QVERIFY(isBeside(session));
    for (int i = 0; i < 20; ++i)
        session.playback().frameForward();
    QVERIFY(isBeside(session));
    QVERIFY(!sim::sameBits(session.presentation().companion()->state, session.timeline().state()));
    for (int i = 0; i < 7; ++i)
        session.playback().frameBack();
    QVERIFY(isBeside(session));
    session.playback().phaseForward();
    QCOMPARE(session.presentation().companion()->state.frame, 13);
}

void CompanionTest::companionFollowsEdits()
{
    const LessonLibrary library = libraryOf(footStep());
    Session session(library);
    for (int i = 0; i < 10; ++i)
        session.playback().frameForward();
    session.editor().setParameter("k", 0.05); // from here on
    for (int i = 0; i < 10; ++i)
        session.playback().frameForward();
    QVERIFY(isBeside(session));
    session.input().grab("foot");
    session.input().moveTo({250, 160});
    session.playback().frameForward();
    session.input().moveTo({255, 150});
    session.playback().frameForward();
    session.input().release();
    for (int i = 0; i < 10; ++i)
        session.playback().frameForward();
    QVERIFY(isBeside(session));
    session.editor().setMethod("semi_implicit_euler");
    QVERIFY(isBeside(session));
    session.playback().goTo({});
    session.editor().setParameter("damp", 0.9); // for the whole run
    for (int i = 0; i < 14; ++i)
        session.playback().frameForward();
    QVERIFY(isBeside(session));
}

void CompanionTest::companionReachesADistantFrame()
{
    SceneFixture fixture({footStep()});
    fixture.session.editor().setMethod("semi_implicit_euler");
    fixture.goTo(20'000);
    QCOMPARE(fixture.session.timeline().cursor().frame, 20'000);
    QVERIFY(isBeside(fixture.session));
}

void CompanionTest::thereIsNoCompanionIfItsMethodCannotComputeTheScene()
{
    lessons::Step step = footStep();
    step.scene = [](const sim::Values &values) {
        sim::Scene scene = footOnASpring(values);
        scene.effects.push_back(std::make_shared<sim::Sticks>(std::vector<sim::Stick>{{0, 0, 1.0}}, 1));
        return scene;
    };
    const LessonLibrary library = libraryOf(step);
    Session session(library);
    session.playback().frameForward();
    QVERIFY(!session.presentation().companion());
    QCOMPARE(session.timeline().cursor().frame, 1);
}

void CompanionTest::companionIsDrawnAtItsOffset()
{
    SceneFixture fixture({footStep()});
    const auto onScreen = [&](sim::Vec2 place) {
        return fixture.view.viewportTransform().map(QPointF(place.x, place.y)).toPoint();
    };
    const QColor body = fixture.theme.tokens().body;
    const auto isBody = [&](sim::Vec2 place) { return fixture.image().pixelColor(onScreen(place)) == body; };
    QVERIFY(isBody({310, 200}));
    QVERIFY(isBody({310, 300}));
    fixture.goTo(7);
    const sim::Vec2 there = fixture.session.presentation().companion()->state.positionOf(0);
    QVERIFY(isBody(there + sim::Vec2{0, 100}));
    QVERIFY(!isBody({310, 300}));
}

void CompanionTest::eachFigureHasItsCaption()
{
    SceneFixture fixture({footStep()});
    QCOMPARE(fixture.view.shown().name, QStringLiteral("Explicit Euler, 1 frame"));
    QCOMPARE(fixture.view.companion().name, QStringLiteral("calm"));
    QVERIFY(fixture.view.accessibleDescription().contains("calm"));
    fixture.session.editor().setMethod("rk4");
    fixture.session.editor().setStepSize(0.25);
    QCOMPARE(fixture.view.shown().name, QStringLiteral("Runge–Kutta 4, 1/4 frame"));
}

void CompanionTest::aCaptionIsNoWiderThanItsFigure()
{
    SceneFixture fixture({footStep()});
    const SceneContent &shown = fixture.view.shown();
    const double stage = shown.view().stage.width();
    const double whole = QFontMetricsF(shown.figures).horizontalAdvance(shown.name);
    for (const double zoom : {whole / stage / 2.0, whole / stage * 2.0}) {
        const Camera camera(QTransform::fromScale(zoom, zoom));
        QVERIFY(titleBox(shown, camera).width() <= std::min(whole, stage * zoom));
        QCOMPARE(shownTitle(shown, camera) == shown.name, whole <= stage * zoom);
    }
}

void CompanionTest::aStepWithoutOneHasNone()
{
    SceneFixture fixture("creature");
    QVERIFY(!fixture.session.presentation().companion());
    QCOMPARE(fixture.view.companion().points(), 0);
    QVERIFY(fixture.view.shown().name.isEmpty());
}

void CompanionTest::anotherChoiceRestartsTheRun()
{
    const LessonLibrary library = libraryOf(openedStep());
    Session session(library);
    QVERIFY(session.timeline().script().input.empty());
    session.editor().setMethod("semi_implicit_euler");
    session.editor().setParameter("k", 0.05);
    for (int i = 0; i < 10; ++i)
        session.playback().frameForward();
    session.editor().setParameter("which", 1);
    QCOMPARE(session.timeline().cursor().frame, 0);
    QCOMPARE(session.timeline().script().method->id(), std::string("semi_implicit_euler"));
    QCOMPARE(session.timeline().script().step.h, 0.5);
    QCOMPARE(session.timeline().script().input.size(), std::size_t{3});
    QCOMPARE(session.editor().parameter("k"), 0.2);
    QVERIFY(!session.presentation().comparison());
    session.editor().setParameter("which", 0);
    QVERIFY(session.timeline().script().input.empty());
    QCOMPARE(session.timeline().script().step.h, 1.0);
}

void CompanionTest::aRefusedChoiceLeavesTheRunAsItWas()
{
    lessons::Step step = openedStep();
    step.prepareScript = [](sim::Script &script) {
        if (script.values.integer("which") == 1)
            script.input = {{3, sim::Move{{std::nan(""), 0}}}};
    };
    const LessonLibrary library = libraryOf(step);
    Session session(library);
    QSignalSpy said(&session.changes(), &ChangeNotifier::messageRequested);
    for (int i = 0; i < 4; ++i)
        session.playback().frameForward();
    session.editor().setParameter("which", 1);
    QVERIFY(said.count() > 0);
    QCOMPARE(session.timeline().cursor().frame, 4);
    QCOMPARE(session.editor().parameter("which"), 0.0);
}

void CompanionTest::theOpeningOfAStepIsNotWritten()
{
    const LessonLibrary library = libraryOf(openedStep());
    Session session(library);
    session.editor().setParameter("which", 1);
    const QByteArray text = experimentText(session.experiment(), library);
    QVERIFY2(!text.contains("input") && !text.contains("\"h\""), text);
    const Experiment back = parseExperiment(text, "x.json", library);
    QVERIFY(back.script.input == session.timeline().script().input);
    QVERIFY(back.script.step == session.timeline().script().step);
}

void CompanionTest::theInputOfAFileReplacesTheOpening()
{
    const LessonLibrary library = libraryOf(openedStep());
    Session session(library);
    session.editor().setParameter("which", 1);
    session.playback().frameForward();
    session.input().grab("foot"); // forgets the input that was to come
    session.editor().setStepSize(0.25);
    const QByteArray text = experimentText(session.experiment(), library);
    const Experiment back = parseExperiment(text, "x.json", library);
    QVERIFY(back.script.input == session.timeline().script().input);
    QCOMPARE(back.script.step.h, 0.25);
    const Experiment none =
        parseExperiment("{\"format\": \"springstep-experiment/1\", \"lesson\": \"made\", \"step\": \"foot\","
                        "\"parameters\": {\"which\": \"other\"}, \"h\": 1, \"input\": []}",
                        "x.json", library);
    QVERIFY(none.script.input.empty());
    QCOMPARE(none.script.step.h, 1.0);
    QVERIFY(experimentText(none, library).contains("\"input\": []"));
}

void CompanionTest::theNoteStandsOverTheScene()
{
    SceneFixture fixture({openedStep()});
    QCOMPARE(fixture.view.caption(), QStringLiteral("this is frame 0"));
    fixture.goTo(3);
    QCOMPARE(fixture.view.caption(), QStringLiteral("this is frame 3"));
    fixture.session.playback().phaseForward();
    QVERIFY(fixture.view.caption().startsWith("Inside frame 3"));
}

SUITE(tst_companion, CompanionTest)
#include "tst_companion.moc"
