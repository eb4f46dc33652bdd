// Input to the scene: pointer, targets and keys.

#include "app/ui/scene/body_drag.h"
#include "lessons/api/view/view.h"
#include "sim/effects/drivers/input_reader.h"
#include "tests/app/scene/drawn_scenes.h"
#include "tests/app/scene/scene_support.h"
#include "tests/suite.h"

#include <QtTest>

using namespace app;
using lessons::Interaction;

namespace {

constexpr sim::Vec2 empty = {420.0, 330.0}; ///< where no body is

/// Reads all input, and does nothing with it.
class Reader : public sim::Driver, public sim::InputReader
{
public:
    std::string id() const override { return "reader"; }
    std::string title() const override { return "reader"; }
    sim::EffectKind kind() const override { return sim::EffectKind::driver; }
    std::vector<sim::Region> regions(sim::DirectionRule) const override { return {}; }
    int count(const sim::State &, sim::PointRange points) const override { return points.count; }
    bool reads(sim::InputKind) const override { return true; }
    void drive(sim::State &, double) const override {}
    std::vector<sim::LiveValue> explain(const sim::State &, const sim::State &, int) const override
    {
        return {};
    }
};

lessons::Step stepThatKnows(const char *id, std::vector<Interaction> does, int pointed = -1,
                            bool isRead = true)
{
    sim::Scene scene = scenes::pointsAt({{200, 150}, {300, 150}});
    if (isRead)
        scene.effects.push_back(std::make_shared<Reader>());
    lessons::View view = drawn_scenes::feetOnly(scene);
    view.pointerPoint = pointed;
    lessons::Step step = drawn_scenes::step(id, scene, view);
    step.interactions = std::move(does);
    return step;
}

/// Returns the input of the run, one word per event with its position in whole px.
QStringList told(const Session &session)
{
    QStringList all;
    const auto place = [](sim::Vec2 at) { return QString(" %1,%2").arg(qRound(at.x)).arg(qRound(at.y)); };
    for (const sim::Event &event : session.timeline().script().input) {
        if (const auto *pointer = std::get_if<sim::Pointer>(&event.what))
            all << (pointer->down ? "down" : "up") + place(pointer->at);
        else if (const auto *target = std::get_if<sim::Target>(&event.what))
            all << "target" + place(target->at);
        else if (const auto *key = std::get_if<sim::Key>(&event.what))
            all << QString("%1 %2").arg(key->key == &sim::Keys::left ? "left" : "other",
                                        key->down ? "down" : "up");
        else if (const auto *grab = std::get_if<sim::Grab>(&event.what))
            all << "grab " + QString::fromStdString(grab->body);
    }
    return all;
}

/// Returns all texts of a step that ask the learner to do something.
QString phraseOf(const lessons::Step &step)
{
    QString all;
    for (const lessons::Try &one : step.tries)
        all += one.text + one.hint;
    return all;
}

/// A click on a place of the view that shows no body.
void clickWhereNothingIs(SceneView &view)
{
    view.fit();
    const Camera camera(view.viewportTransform());
    for (const QPoint at : {QPoint(30, 90), QPoint(760, 90), QPoint(400, 80), QPoint(760, 500)}) {
        if (BodyDrag::bodyAt(view.shown(), camera, at) >= 0)
            continue;
        QTest::mouseClick(view.viewport(), Qt::LeftButton, {}, at);
        return;
    }
    QFAIL("there are bodies everywhere");
}

struct ToolFixture : SceneFixture
{
    explicit ToolFixture(lessons::Step step) : SceneFixture(std::vector<lessons::Step>{std::move(step)}) {}
    QPoint onScreen(sim::Vec2 at) const { return view.mapFromScene(at.x, at.y); }
    sim::Vec2 inScene(QPoint at) const
    {
        const QPointF place = view.mapToScene(at);
        return {place.x(), place.y()};
    }
    QString word(const char *what, QPoint at) const
    {
        const sim::Vec2 place = inScene(at);
        return QString("%1 %2,%3").arg(what).arg(qRound(place.x)).arg(qRound(place.y));
    }
};

}

class TestTools : public QObject
{
    Q_OBJECT

private slots:
    void pointerIsDownFromPressToReleaseOnTheBackground()
    {
        ToolFixture fixture(stepThatKnows("wind", {Interaction::drag, Interaction::pointer}));
        const QPoint from = fixture.onScreen(empty), to = fixture.onScreen({380, 300});
        const QTransform before = fixture.view.transform();
        fixture.press(from);
        QCOMPARE(told(fixture.session), QStringList{fixture.word("down", from)});
        fixture.session.playback().frameForward();
        fixture.move(to);
        fixture.session.playback().frameForward();
        fixture.release(to);
        QCOMPARE(told(fixture.session),
                 (QStringList{fixture.word("down", from), fixture.word("down", to), fixture.word("up", to)}));
        QCOMPARE(fixture.view.transform(), before);
    }

    void movesInOneFrameAreOneEvent()
    {
        ToolFixture fixture(stepThatKnows("wind", {Interaction::drag, Interaction::pointer}));
        fixture.press(fixture.onScreen(empty));
        for (const double x : {400.0, 390.0, 380.0})
            fixture.move(fixture.onScreen({x, 320}));
        QCOMPARE(told(fixture.session), QStringList{fixture.word("down", fixture.onScreen({380, 320}))});
    }

    void bodyCanStillBeDragged()
    {
        ToolFixture fixture(stepThatKnows("wind", {Interaction::drag, Interaction::pointer}));
        const QPoint body = fixture.onScreen({300, 150});
        fixture.press(body);
        fixture.move(body + QPoint(30, 0));
        QCOMPARE(told(fixture.session), QStringList{"grab p1"});
    }

    void undoingSaysWhatWasDone()
    {
        ToolFixture fixture(stepThatKnows("wind", {Interaction::drag, Interaction::pointer}));
        const QPoint at = fixture.onScreen(empty);
        fixture.press(at);
        fixture.release(at);
        QCOMPARE(fixture.session.editor().undoStack().undoText(), QString("Move pointer"));
        const QPoint body = fixture.onScreen({300, 150});
        fixture.press(body);
        fixture.move(body + QPoint(30, 0));
        fixture.release(body + QPoint(30, 0));
        QCOMPARE(fixture.session.editor().undoStack().undoText(), QString("Drag p1"));
    }

    void theBodyThatThePointerCarriesGoesWithIt()
    {
        ToolFixture fixture(stepThatKnows("sticks", {Interaction::drag, Interaction::pointer}, 0));
        const QPoint body = fixture.onScreen({200, 150});
        fixture.press(body);
        QCOMPARE(told(fixture.session), QStringList{fixture.word("down", body)});
        QCOMPARE(fixture.session.selected(), QString("p0"));
    }

    void aClickOnTheBackgroundSetsATarget()
    {
        ToolFixture fixture(stepThatKnows("swim", {Interaction::drag, Interaction::target}));
        const QPoint at = fixture.onScreen(empty);
        fixture.press(at);
        fixture.release(at);
        QCOMPARE(told(fixture.session), QStringList{fixture.word("target", at)});
    }

    void withoutAToolTheBackgroundMovesThePicture()
    {
        ToolFixture fixture(stepThatKnows("plain", {Interaction::drag}));
        const QPoint at = fixture.onScreen(empty);
        fixture.press(at);
        fixture.move(at + QPoint(40, 0));
        fixture.release(at + QPoint(40, 0));
        QVERIFY(told(fixture.session).isEmpty());
        QVERIFY(fixture.onScreen(empty) != at);
    }

    void inputThatNoEffectReadsIsNotRecorded()
    {
        ToolFixture fixture(stepThatKnows(
            "torture", {Interaction::drag, Interaction::pointer, Interaction::target, Interaction::keys}, -1,
            false));
        const QPoint at = fixture.onScreen(empty);
        fixture.press(at);
        fixture.release(at);
        QTest::keyClick(&fixture.view, Qt::Key_Return, Qt::AltModifier);
        fixture.session.playback().play();
        QTest::keyClick(&fixture.view, Qt::Key_Left);
        fixture.session.playback().pause();
        QCOMPARE(told(fixture.session), QStringList());
        QCOMPARE(fixture.session.editor().undoStack().count(), 0);
    }

    void inNoStepAClickOnTheEmptySceneChangesTheRunUnlessItsTextAsksForIt()
    {
        SceneFixture fixture;
        const LessonLibrary library = LessonLibrary::load({LESSON_DIR});
        Session session(library);
        SceneView view(session, fixture.theme);
        view.resize(800, 600);
        int steps = 0;
        for (const LessonEntry &lesson : library.lessons) {
            for (const lessons::Step &step : lesson.steps) {
                session.openStep(lesson.id, step.id);
                clickWhereNothingIs(view);
                const QString text = step.narration + phraseOf(step);
                const bool asks = text.contains("pointer", Qt::CaseInsensitive) ||
                                  text.contains("button", Qt::CaseInsensitive) ||
                                  text.contains("click", Qt::CaseInsensitive);
                QVERIFY2(asks || session.timeline().script().input == step.script().input,
                         qPrintable(lesson.id + '/' + step.id));
                ++steps;
            }
        }
        QVERIFY(steps >= 60);
    }

    void inTheTorturePanelAClickOnTheEmptySceneLeavesTheCaseAsItIs()
    {
        SceneFixture fixture;
        const LessonLibrary library = LessonLibrary::load({LESSON_DIR});
        Session session(library);
        SceneView view(session, fixture.theme);
        view.resize(800, 600);
        session.openStep("hard_cases", "torture");
        clickWhereNothingIs(view);
        QCOMPARE(session.editor().undoStack().count(), 0);
        QVERIFY(!session.step().note(session.timeline().track()).contains("nobody claims this"));
    }

    void arrowKeysSteerWhileItPlaysAndOnlyThen()
    {
        ToolFixture fixture(stepThatKnows("steered", {Interaction::drag, Interaction::keys}));
        QTest::keyClick(&fixture.view, Qt::Key_Left);
        QVERIFY(told(fixture.session).isEmpty());
        fixture.session.playback().play();
        QTest::keyPress(&fixture.view, Qt::Key_Left);
        QTest::keyRelease(&fixture.view, Qt::Key_Left);
        fixture.session.playback().pause();
        QCOMPARE(told(fixture.session), (QStringList{"left down", "left up"}));
    }

    void aKeyThatSteersDoesNotReachTheWindowsShortcuts()
    {
        ToolFixture fixture(stepThatKnows("steered", {Interaction::drag, Interaction::keys}));
        QKeyEvent override(QEvent::ShortcutOverride, Qt::Key_Left, Qt::NoModifier);
        override.ignore();
        QApplication::sendEvent(&fixture.view, &override);
        QVERIFY(!override.isAccepted());
        fixture.session.playback().play();
        QApplication::sendEvent(&fixture.view, &override);
        QVERIFY(override.isAccepted());
    }

    void pressedKeysAreReleasedWhenTheFocusLeaves()
    {
        ToolFixture fixture(stepThatKnows("steered", {Interaction::drag, Interaction::keys}));
        fixture.session.playback().play();
        QTest::keyPress(&fixture.view, Qt::Key_Left);
        fixture.view.clearFocus();
        QCOMPARE(told(fixture.session).constLast(), QString("left up"));
    }

    void theKeyboardMovesAndPressesThePointer()
    {
        ToolFixture fixture(stepThatKnows("wind", {Interaction::drag, Interaction::pointer}));
        QTest::keyClick(&fixture.view, Qt::Key_Return, Qt::AltModifier);
        fixture.session.playback().frameForward();
        const QString first = told(fixture.session).constLast();
        QVERIFY(first.startsWith("down"));
        const double x = fixture.session.timeline().state().input.pointer->x;
        QTest::keyClick(&fixture.view, Qt::Key_Right, Qt::AltModifier | Qt::ShiftModifier);
        fixture.session.playback().frameForward();
        QCOMPARE(fixture.session.timeline().state().input.pointer->x, x + 20.0);
        QVERIFY(fixture.session.timeline().state().input.pointerDown);
        QTest::keyClick(&fixture.view, Qt::Key_Return, Qt::AltModifier);
        fixture.session.playback().frameForward();
        QVERIFY(!fixture.session.timeline().state().input.pointerDown);
    }

    void leavingAStepKeepsWhatAFileSaysOfThePointer()
    {
        ToolFixture fixture(stepThatKnows("wind", {Interaction::drag, Interaction::pointer}));
        Experiment experiment = fixture.session.experiment();
        experiment.script.input = {{2, sim::Pointer{{10, 10}, true}}, {9, sim::Pointer{{10, 10}, false}}};
        fixture.session.open(experiment);
        fixture.session.playback().goTo({5, 0});
        fixture.session.openStep("scene", "wind"); // leaves it, and comes back to it as it was left
        QCOMPARE(fixture.session.timeline().script().input.size(), std::size_t(2));
    }
};

SUITE(tst_tools, TestTools)
#include "tst_tools.moc"
