// Pointer, targets and keys that reach the scene.

#include "app/ui/scene/hand.h"
#include "lessons/api/view/view.h"
#include "look_scenes.h"
#include "scene_bench.h"
#include "sim/effects/drivers/input_reader.h"

#include <QTemporaryDir>
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
    lessons::View look = look_scenes::feetOnly(scene);
    look.pointerPoint = pointed;
    lessons::Step step = look_scenes::step(id, scene, look);
    step.interactions = std::move(does);
    return step;
}

/// What the run was told, one word an event with its place in whole px.
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

/// All that a step says of what to do.
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
        if (Hand::bodyAt(view.shown(), camera, at) >= 0)
            continue;
        QTest::mouseClick(view.viewport(), Qt::LeftButton, {}, at);
        return;
    }
    QFAIL("there are bodies everywhere");
}

struct ToolBench : SceneBench
{
    explicit ToolBench(lessons::Step step) : SceneBench(std::vector<lessons::Step>{std::move(step)}) {}
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
    void initTestCase() { useOwnSettings(m_settings); }

    void aPressOnTheBackgroundIsThePointersDownToItsRelease()
    {
        ToolBench bench(stepThatKnows("wind", {Interaction::drag, Interaction::pointer}));
        const QPoint from = bench.onScreen(empty), to = bench.onScreen({380, 300});
        const QTransform before = bench.view.transform();
        bench.press(from);
        QCOMPARE(told(bench.session), QStringList{bench.word("down", from)});
        bench.session.frameForward();
        bench.move(to);
        bench.session.frameForward();
        bench.release(to);
        QCOMPARE(told(bench.session),
                 (QStringList{bench.word("down", from), bench.word("down", to), bench.word("up", to)}));
        QCOMPARE(bench.view.transform(), before);
    }

    void movesInOneFrameAreOneEvent()
    {
        ToolBench bench(stepThatKnows("wind", {Interaction::drag, Interaction::pointer}));
        bench.press(bench.onScreen(empty));
        for (const double x : {400.0, 390.0, 380.0})
            bench.move(bench.onScreen({x, 320}));
        QCOMPARE(told(bench.session), QStringList{bench.word("down", bench.onScreen({380, 320}))});
    }

    void aBodyIsStillTakenByTheHand()
    {
        ToolBench bench(stepThatKnows("wind", {Interaction::drag, Interaction::pointer}));
        const QPoint body = bench.onScreen({300, 150});
        bench.press(body);
        bench.move(body + QPoint(30, 0));
        QCOMPARE(told(bench.session), QStringList{"grab p1"});
    }

    void undoingSaysWhatWasDone()
    {
        ToolBench bench(stepThatKnows("wind", {Interaction::drag, Interaction::pointer}));
        const QPoint at = bench.onScreen(empty);
        bench.press(at);
        bench.release(at);
        QCOMPARE(bench.session.deeds().undoText(), QString("Move pointer"));
        const QPoint body = bench.onScreen({300, 150});
        bench.press(body);
        bench.move(body + QPoint(30, 0));
        bench.release(body + QPoint(30, 0));
        QCOMPARE(bench.session.deeds().undoText(), QString("Drag p1"));
    }

    void theBodyThatThePointerCarriesGoesWithIt()
    {
        ToolBench bench(stepThatKnows("sticks", {Interaction::drag, Interaction::pointer}, 0));
        const QPoint body = bench.onScreen({200, 150});
        bench.press(body);
        QCOMPARE(told(bench.session), QStringList{bench.word("down", body)});
        QCOMPARE(bench.session.selected(), QString("p0"));
    }

    void aClickOnTheBackgroundSetsATarget()
    {
        ToolBench bench(stepThatKnows("swim", {Interaction::drag, Interaction::target}));
        const QPoint at = bench.onScreen(empty);
        bench.press(at);
        bench.release(at);
        QCOMPARE(told(bench.session), QStringList{bench.word("target", at)});
    }

    void withoutAToolTheBackgroundMovesThePicture()
    {
        ToolBench bench(stepThatKnows("plain", {Interaction::drag}));
        const QPoint at = bench.onScreen(empty);
        bench.press(at);
        bench.move(at + QPoint(40, 0));
        bench.release(at + QPoint(40, 0));
        QVERIFY(told(bench.session).isEmpty());
        QVERIFY(bench.onScreen(empty) != at);
    }

    void whatNoEffectReadsIsNoInput()
    {
        ToolBench bench(stepThatKnows(
            "torture", {Interaction::drag, Interaction::pointer, Interaction::target, Interaction::keys}, -1,
            false));
        const QPoint at = bench.onScreen(empty);
        bench.press(at);
        bench.release(at);
        QTest::keyClick(&bench.view, Qt::Key_Return, Qt::AltModifier);
        bench.session.play();
        QTest::keyClick(&bench.view, Qt::Key_Left);
        bench.session.pause();
        QCOMPARE(told(bench.session), QStringList());
        QCOMPARE(bench.session.deeds().count(), 0);
    }

    void inNoStepAClickOnTheEmptySceneChangesTheRunUnlessItsTextAsksForIt()
    {
        SceneBench bench;
        const LessonLibrary library = LessonLibrary::load({LESSON_DIR});
        Session session(library);
        SceneView view(session, bench.theme);
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
        SceneBench bench;
        const LessonLibrary library = LessonLibrary::load({LESSON_DIR});
        Session session(library);
        SceneView view(session, bench.theme);
        view.resize(800, 600);
        session.openStep("hard_cases", "torture");
        clickWhereNothingIs(view);
        QCOMPARE(session.deeds().count(), 0);
        QVERIFY(!session.step().note(session.timeline().track()).contains("nobody claims this"));
    }

    void arrowKeysSteerWhileItPlaysAndOnlyThen()
    {
        ToolBench bench(stepThatKnows("steered", {Interaction::drag, Interaction::keys}));
        QTest::keyClick(&bench.view, Qt::Key_Left);
        QVERIFY(told(bench.session).isEmpty());
        bench.session.play();
        QTest::keyPress(&bench.view, Qt::Key_Left);
        QTest::keyRelease(&bench.view, Qt::Key_Left);
        bench.session.pause();
        QCOMPARE(told(bench.session), (QStringList{"left down", "left up"}));
    }

    void aKeyThatSteersDoesNotReachTheWindowsShortcuts()
    {
        ToolBench bench(stepThatKnows("steered", {Interaction::drag, Interaction::keys}));
        QKeyEvent override(QEvent::ShortcutOverride, Qt::Key_Left, Qt::NoModifier);
        override.ignore();
        QApplication::sendEvent(&bench.view, &override);
        QVERIFY(!override.isAccepted());
        bench.session.play();
        QApplication::sendEvent(&bench.view, &override);
        QVERIFY(override.isAccepted());
    }

    void whatIsDownComesUpWhenTheKeyboardLeaves()
    {
        ToolBench bench(stepThatKnows("steered", {Interaction::drag, Interaction::keys}));
        bench.session.play();
        QTest::keyPress(&bench.view, Qt::Key_Left);
        bench.view.clearFocus();
        QCOMPARE(told(bench.session).constLast(), QString("left up"));
    }

    void theKeyboardMovesAndPressesThePointer()
    {
        ToolBench bench(stepThatKnows("wind", {Interaction::drag, Interaction::pointer}));
        QTest::keyClick(&bench.view, Qt::Key_Return, Qt::AltModifier);
        bench.session.frameForward();
        const QString first = told(bench.session).constLast();
        QVERIFY(first.startsWith("down"));
        const double x = bench.session.timeline().state().input.pointer->x;
        QTest::keyClick(&bench.view, Qt::Key_Right, Qt::AltModifier | Qt::ShiftModifier);
        bench.session.frameForward();
        QCOMPARE(bench.session.timeline().state().input.pointer->x, x + 20.0);
        QVERIFY(bench.session.timeline().state().input.pointerDown);
        QTest::keyClick(&bench.view, Qt::Key_Return, Qt::AltModifier);
        bench.session.frameForward();
        QVERIFY(!bench.session.timeline().state().input.pointerDown);
    }

    void leavingAStepKeepsWhatAFileSaysOfThePointer()
    {
        ToolBench bench(stepThatKnows("wind", {Interaction::drag, Interaction::pointer}));
        Experiment experiment = bench.session.experiment();
        experiment.script.input = {{2, sim::Pointer{{10, 10}, true}}, {9, sim::Pointer{{10, 10}, false}}};
        bench.session.open(experiment);
        bench.session.goTo({5, 0});
        bench.session.openStep("scene", "wind"); // leaves it, and comes back to it as it was left
        QCOMPARE(bench.session.timeline().script().input.size(), std::size_t(2));
    }

private:
    QTemporaryDir m_settings;
};

QTEST_MAIN(TestTools)
#include "tst_tools.moc"
