#include "lessons/api/view/view.h"
#include "sim/run/track.h"
#include "tests/lessons/support/support.h"
#include "tests/lessons/support/trajectory.h"

#include "sim/methods/methods.h"
#include "tests/suite.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace support;
using std::numbers::pi;

namespace {

constexpr double gaitCycle = 2.0 * pi / 0.05; ///< frames per gait cycle at the default speed

sim::Event key(std::int64_t frame, bool sim::Keys::*which, bool down)
{
    return sim::eventOf(frame, sim::Key{which, down});
}

using Input = std::vector<sim::Event>;

}

Q_DECLARE_METATYPE(Input)

/// Steps `more_feet` and `steering`, which follow the tutorial's first two suggestions, and the feet diagram.
/// Walls and company are in tst_walking_company.cpp.
class WalkingVariations : public QObject
{
    Q_OBJECT

    const LoadedLesson m_lesson = loadLesson(QStringLiteral("walking_gait"));

    const lessons::Step &step(const char *id) const { return m_lesson.step(QString::fromUtf8(id)); }

private slots:
    void creatureWalksWithAnyNumberOfFeet_data();
    void creatureWalksWithAnyNumberOfFeet();
    void feetAreSpreadEvenlyOverACycle();
    void moreFeetCarryTheBodyMoreEvenly();
    void feetInStepDoNotAdvance();
    void presetGaitsWalk();
    void keysAndPointerSetTheSpeed_data();
    void keysAndPointerSetTheSpeed();
    void steeringReversesTheCreature();
    void setSpeedReplacesTheSteeredOne();
    void feetDiagramShowsPlantedFeet_data();
    void feetDiagramShowsPlantedFeet();
};

void WalkingVariations::creatureWalksWithAnyNumberOfFeet_data()
{
    QTest::addColumn<int>("feet");
    QTest::addColumn<QString>("method");
    for (int feet = 2; feet <= 12; ++feet) {
        for (const sim::MethodPtr &method : walkingMethods())
            QTest::addRow("%d feet, %s", feet, method->id().c_str())
                << feet << QString::fromStdString(method->id());
    }
}

void WalkingVariations::creatureWalksWithAnyNumberOfFeet()
{
    QFETCH(int, feet);
    QFETCH(QString, method);
    const sim::Script script =
        scriptOf(step("more_feet"), method.toStdString(), 1.0, {{"feet", double(feet)}});
    const MotionSummary motion = motionOf(script, "body", 1000, 1000 + int(10.0 * gaitCycle));
    // Methods of order 1 slip. No creature walks faster than its feet swing: legs of 50 px at 0.05 rad per
    // frame.
    const double maxVelocity = sim::findMethod(method.toStdString())->order() == 1 ? 1.6 : 50.0 * 0.05;
    QVERIFY2(motion.meanVelocity > 1.15 && motion.meanVelocity < maxVelocity,
             qPrintable(QString::number(motion.meanVelocity)));
    QVERIFY(motion.top > 250.0 && motion.bottom < 400.0);
    QVERIFY(stateAfter(script, 10'000).position.isFinite().all());
}

void WalkingVariations::feetAreSpreadEvenlyOverACycle()
{
    // The body is held far above the ground and the gait is stopped. So each foot rests at its target.
    sim::Script script = scriptOf(step("more_feet"), "published", 1.0,
                                  {{"feet", 7.0}, {"speed", 0.0}, {"gravity", 0.0}, {"ground", 1e6}});
    script.input = {{1, sim::Grab{"body"}}};
    const sim::State rest = stateAfter(script, 2000);
    for (int i = 0; i < 7; ++i) {
        const double angle = 2.0 * pi * i / 7.0;
        const sim::Vec2 target = {270.0 - 50.0 * std::cos(angle), 350.0 - 50.0 * std::sin(angle)};
        QVERIFY(sim::length(rest.positionOf(i) - target) < 1e-9);
    }
}

/// Checks the numbers in the step's text.
void WalkingVariations::moreFeetCarryTheBodyMoreEvenly()
{
    const auto motionWith = [&](double feet) {
        return motionOf(scriptOf(step("more_feet"), "published", 1.0, {{"feet", feet}}), "body", 1000,
                        1000 + int(10.0 * gaitCycle));
    };
    const MotionSummary two = motionWith(2.0), five = motionWith(5.0), twelve = motionWith(12.0);
    const auto rise = [](const MotionSummary &motion) { return motion.bottom - motion.top; };
    QVERIFY2(std::abs(rise(two) - 55.0) < 1.0, qPrintable(QString::number(rise(two))));
    QVERIFY2(std::abs(rise(five) - 4.0) < 0.5, qPrintable(QString::number(rise(five))));
    QVERIFY2(std::abs(rise(twelve) - 1.0) < 0.5, qPrintable(QString::number(rise(twelve))));
    QVERIFY(std::abs(two.meanVelocity - 1.2) < 0.05);
    QVERIFY(std::abs(five.meanVelocity - 1.4) < 0.05 && std::abs(twelve.meanVelocity - 1.4) < 0.06);
}

void WalkingVariations::feetInStepDoNotAdvance()
{
    for (double feet : {2.0, 5.0, 12.0}) {
        const MotionSummary motion =
            motionOf(scriptOf(step("more_feet"), "published", 1.0, {{"feet", feet}, {"spread", 0.0}}), "body",
                     1000, 1000 + int(20.0 * gaitCycle));
        QVERIFY2(std::abs(motion.meanVelocity) < 0.05, qPrintable(QString::number(motion.meanVelocity)));
        QVERIFY2(motion.bottom - motion.top > 60.0, qPrintable(QString::number(motion.bottom - motion.top)));
    }
}

void WalkingVariations::presetGaitsWalk()
{
    QVERIFY(step("more_feet").presets.size() >= 3);
    for (const lessons::Preset &preset : step("more_feet").presets) {
        sim::Script script = step("more_feet").script();
        for (const auto &[id, value] : preset.values)
            script.values.set(id.toStdString(), value);
        const MotionSummary motion = motionOf(script, "body", 1000, 3000);
        QVERIFY2(motion.meanVelocity > 0.8, qPrintable(preset.title));
    }
}

void WalkingVariations::keysAndPointerSetTheSpeed_data()
{
    QTest::addColumn<Input>("input");
    QTest::addColumn<double>("speed");
    const auto left = &sim::Keys::left, right = &sim::Keys::right;
    QTest::newRow("nothing") << Input{} << 0.05;
    QTest::newRow("right for 8 frames") << Input{key(1, right, true), key(9, right, false)} << 0.07;
    QTest::newRow("left for 8 frames") << Input{key(1, left, true), key(9, left, false)} << 0.03;
    QTest::newRow("left until the end") << Input{key(1, left, true)} << -0.05;
    QTest::newRow("left and right") << Input{key(1, left, true), key(1, right, true)} << 0.05;
    const auto pointer = [](double x, bool down) { return sim::eventOf(40, sim::Pointer{{x, 10}, down}); };
    QTest::newRow("far to the right") << Input{pointer(900, true)} << 0.15;
    QTest::newRow("far to the left") << Input{pointer(-900, true)} << -0.15;
    QTest::newRow("button up") << Input{pointer(-900, false)} << 0.05;
    QTest::newRow("pointer overrides keys") << Input{key(1, right, true), pointer(-900, true)} << -0.15;
}

void WalkingVariations::keysAndPointerSetTheSpeed()
{
    QFETCH(Input, input);
    QFETCH(double, speed);
    for (double h : {1.0, 0.25}) {
        sim::Script script = scriptOf(step("steering"), "published", h);
        script.input = input;
        QVERIFY(std::abs(stateAfter(script, 40).gaitSpeed[0] - speed) < 1e-12);
    }
    sim::Script half = step("steering").script(); // 100 px away is half of 200 px, which gives half of 0.15
    half.input = {{1, sim::Pointer{{170, 0}, true}}};
    QVERIFY(std::abs(stateAfter(half, 1).gaitSpeed[0] + 0.075) < 0.001);
}

void WalkingVariations::steeringReversesTheCreature()
{
    sim::Script script = step("steering").script();
    script.input = {key(200, &sim::Keys::left, true), key(240, &sim::Keys::left, false)};
    QVERIFY(motionOf(script, "body", 50, 199).meanVelocity > 0.8);
    QVERIFY(motionOf(script, "body", 400, 400 + int(gaitCycle)).meanVelocity < -0.8);
    QVERIFY(step("steering").accepts(lessons::Interaction::keys) &&
            step("steering").accepts(lessons::Interaction::pointer));
    QVERIFY(step("walls").accepts(lessons::Interaction::keys) &&
            !step("ground").accepts(lessons::Interaction::keys));
}

void WalkingVariations::setSpeedReplacesTheSteeredOne()
{
    sim::Script script = step("steering").script();
    script.input = {key(1, &sim::Keys::left, true), key(11, &sim::Keys::left, false)};
    script.input.push_back({20, sim::Set{"k", 0.2}});
    script.input.push_back({30, sim::Set{"speed", 0.08}});
    QVERIFY(std::abs(stateAfter(script, 25).gaitSpeed[0] - 0.025) < 1e-12);
    QVERIFY(std::abs(stateAfter(script, 35).gaitSpeed[0] - 0.08) < 1e-12);
}

void WalkingVariations::feetDiagramShowsPlantedFeet_data()
{
    QTest::addColumn<QString>("id");
    for (const char *id : {"ground", "more_feet", "steering", "walls", "company"})
        QTest::newRow(id) << id;
}

void WalkingVariations::feetDiagramShowsPlantedFeet()
{
    QFETCH(QString, id);
    const lessons::Step &step = m_lesson.step(id);
    const sim::Scene scene = step.scene(step.defaultValues());
    const lessons::View view = step.view(scene, step.defaultValues());
    const auto feet = std::count_if(scene.names.begin(), scene.names.end(), [](const std::string &name) {
        return name.find("foot") != std::string::npos;
    });
    QCOMPARE(static_cast<std::ptrdiff_t>(view.feet.size()), feet);
    QVERIFY(view.ground.has_value() != view.room.has_value());
    QCOMPARE(view.followedPoint >= 0, view.ground.has_value());
    int planted = 0, lifted = 0;
    sim::Track track(step.script(), 0);
    for (int frame = 0; frame <= 300; ++frame) {
        track.seek({frame, 0});
        for (int foot : view.feet) {
            const bool isPlanted = step.isFootDown(scene, track.state(), step.defaultValues(), foot);
            QCOMPARE(isPlanted, track.state().positionOf(foot).y == 400.0);
            (isPlanted ? planted : lifted) += 1;
        }
    }
    QVERIFY(planted > 50 && lifted > 50);
    sim::Script held = step.script();
    const std::string name = scene.names[static_cast<std::size_t>(view.feet.front())];
    held.input = {{1, sim::Grab{name}}, {1, sim::Move{{200, 400}}}};
    QVERIFY(!step.isFootDown(scene, stateAfter(held, 5), step.defaultValues(), view.feet.front()));
}

SUITE(tst_walking_variations, WalkingVariations)
#include "tst_walking_variations.moc"
