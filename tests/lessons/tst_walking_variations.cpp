#include "lessons/api/view/view.h"
#include "sim/run/track.h"
#include "tests/lessons/support.h"
#include "tests/lessons/trajectory.h"

#include "sim/methods/methods.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace support;
using std::numbers::pi;

namespace {

constexpr double turn = 2.0 * pi / 0.05; ///< frames that the gait clock takes at its usual speed

sim::Event key(std::int64_t frame, bool sim::Keys::*which, bool down)
{
    return sim::eventOf(frame, sim::Key{which, down});
}

using Input = std::vector<sim::Event>;

}

Q_DECLARE_METATYPE(Input)

/// The steps that follow the tutorial's first two suggestions, and the feet diagram. Walls and company are in
/// tst_walking_company.cpp.
class WalkingFurther : public QObject
{
    Q_OBJECT

    const LoadedLesson m_lesson = loadLesson(QStringLiteral("walking_gait"));

    const lessons::Step &step(const char *id) const { return m_lesson.step(QString::fromUtf8(id)); }

private slots:
    void anyNumberOfFeetWalks_data();
    void anyNumberOfFeetWalks();
    void feetAreSpreadEvenlyOverATurn();
    void moreFeetCarryTheBodyMoreEvenly();
    void allFeetInStepGetNowhere();
    void everyGaitOfTheGalleryWalks();
    void keysAndPointerSetTheSpeed_data();
    void keysAndPointerSetTheSpeed();
    void steeringTurnsTheCreatureRound();
    void aSpeedThatIsSetReplacesTheSteeredOne();
    void theFeetDiagramTellsWhichFeetStand_data();
    void theFeetDiagramTellsWhichFeetStand();
};

void WalkingFurther::anyNumberOfFeetWalks_data()
{
    QTest::addColumn<int>("feet");
    QTest::addColumn<QString>("method");
    for (int feet = 2; feet <= 12; ++feet) {
        for (const sim::MethodPtr &method : walkingMethods())
            QTest::addRow("%d feet, %s", feet, method->id().c_str())
                << feet << QString::fromStdString(method->id());
    }
}

void WalkingFurther::anyNumberOfFeetWalks()
{
    QFETCH(int, feet);
    QFETCH(QString, method);
    const sim::Script script =
        scriptOf(step("more_feet"), method.toStdString(), 1.0, {{"feet", double(feet)}});
    const Course integrator = courseOf(script, "body", 1000, 1000 + int(10.0 * turn));
    // The coarse rules slip; none walks faster than its feet swing: legs of 50 px, 0.05 rad a frame.
    const double most = sim::findMethod(method.toStdString())->order() == 1 ? 1.6 : 50.0 * 0.05;
    QVERIFY2(integrator.pace > 1.15 && integrator.pace < most, qPrintable(QString::number(integrator.pace)));
    QVERIFY(integrator.top > 250.0 && integrator.bottom < 400.0);
    QVERIFY(stateAfter(script, 10'000).position.isFinite().all());
}

void WalkingFurther::feetAreSpreadEvenlyOverATurn()
{
    // Held up, far above the ground, a clock that stands: each foot comes to rest in its place.
    sim::Script script = scriptOf(step("more_feet"), "published", 1.0,
                                  {{"feet", 7.0}, {"speed", 0.0}, {"gravity", 0.0}, {"ground", 1e6}});
    script.input = {{1, sim::Grab{"body"}}};
    const sim::State rest = stateAfter(script, 2000);
    for (int i = 0; i < 7; ++i) {
        const double angle = 2.0 * pi * i / 7.0;
        const sim::Vec2 place = {270.0 - 50.0 * std::cos(angle), 350.0 - 50.0 * std::sin(angle)};
        QVERIFY(sim::length(rest.positionOf(i) - place) < 1e-9);
    }
}

/// The figures that the step's text gives.
void WalkingFurther::moreFeetCarryTheBodyMoreEvenly()
{
    const auto course = [&](double feet) {
        return courseOf(scriptOf(step("more_feet"), "published", 1.0, {{"feet", feet}}), "body", 1000,
                        1000 + int(10.0 * turn));
    };
    const Course two = course(2.0), five = course(5.0), twelve = course(12.0);
    const auto rise = [](const Course &c) { return c.bottom - c.top; };
    QVERIFY2(std::abs(rise(two) - 55.0) < 1.0, qPrintable(QString::number(rise(two))));
    QVERIFY2(std::abs(rise(five) - 4.0) < 0.5, qPrintable(QString::number(rise(five))));
    QVERIFY2(std::abs(rise(twelve) - 1.0) < 0.5, qPrintable(QString::number(rise(twelve))));
    QVERIFY(std::abs(two.pace - 1.2) < 0.05);
    QVERIFY(std::abs(five.pace - 1.4) < 0.05 && std::abs(twelve.pace - 1.4) < 0.06);
}

void WalkingFurther::allFeetInStepGetNowhere()
{
    for (double feet : {2.0, 5.0, 12.0}) {
        const Course integrator =
            courseOf(scriptOf(step("more_feet"), "published", 1.0, {{"feet", feet}, {"spread", 0.0}}), "body",
                     1000, 1000 + int(20.0 * turn));
        QVERIFY2(std::abs(integrator.pace) < 0.05, qPrintable(QString::number(integrator.pace)));
        QVERIFY2(integrator.bottom - integrator.top > 60.0,
                 qPrintable(QString::number(integrator.bottom - integrator.top)));
    }
}

void WalkingFurther::everyGaitOfTheGalleryWalks()
{
    QVERIFY(step("more_feet").presets.size() >= 3);
    for (const lessons::Preset &preset : step("more_feet").presets) {
        sim::Script script = step("more_feet").script();
        for (const auto &[id, value] : preset.values)
            script.values.set(id.toStdString(), value);
        const Course integrator = courseOf(script, "body", 1000, 3000);
        QVERIFY2(integrator.pace > 0.8, qPrintable(preset.title));
    }
}

void WalkingFurther::keysAndPointerSetTheSpeed_data()
{
    QTest::addColumn<Input>("input");
    QTest::addColumn<double>("speed");
    const auto left = &sim::Keys::left, right = &sim::Keys::right;
    QTest::newRow("nothing") << Input{} << 0.05;
    QTest::newRow("right for 8 frames") << Input{key(1, right, true), key(9, right, false)} << 0.07;
    QTest::newRow("left for 8 frames") << Input{key(1, left, true), key(9, left, false)} << 0.03;
    QTest::newRow("left until the end") << Input{key(1, left, true)} << -0.05;
    QTest::newRow("both") << Input{key(1, left, true), key(1, right, true)} << 0.05;
    const auto pointer = [](double x, bool down) { return sim::eventOf(40, sim::Pointer{{x, 10}, down}); };
    QTest::newRow("far to the right") << Input{pointer(900, true)} << 0.15;
    QTest::newRow("far to the left") << Input{pointer(-900, true)} << -0.15;
    QTest::newRow("button up") << Input{pointer(-900, false)} << 0.05;
    QTest::newRow("pointer before keys") << Input{key(1, right, true), pointer(-900, true)} << -0.15;
}

void WalkingFurther::keysAndPointerSetTheSpeed()
{
    QFETCH(Input, input);
    QFETCH(double, speed);
    for (double h : {1.0, 0.25}) {
        sim::Script script = scriptOf(step("steering"), "published", h);
        script.input = input;
        QVERIFY(std::abs(stateAfter(script, 40).gaitSpeed[0] - speed) < 1e-12);
    }
    sim::Script half = step("steering").script(); // half of 200 px away: half of 0.15
    half.input = {{1, sim::Pointer{{170, 0}, true}}};
    QVERIFY(std::abs(stateAfter(half, 1).gaitSpeed[0] + 0.075) < 0.001);
}

void WalkingFurther::steeringTurnsTheCreatureRound()
{
    sim::Script script = step("steering").script();
    script.input = {key(200, &sim::Keys::left, true), key(240, &sim::Keys::left, false)};
    QVERIFY(courseOf(script, "body", 50, 199).pace > 0.8);
    QVERIFY(courseOf(script, "body", 400, 400 + int(turn)).pace < -0.8);
    QVERIFY(step("steering").accepts(lessons::Interaction::keys) &&
            step("steering").accepts(lessons::Interaction::pointer));
    QVERIFY(step("walls").accepts(lessons::Interaction::keys) &&
            !step("ground").accepts(lessons::Interaction::keys));
}

void WalkingFurther::aSpeedThatIsSetReplacesTheSteeredOne()
{
    sim::Script script = step("steering").script();
    script.input = {key(1, &sim::Keys::left, true), key(11, &sim::Keys::left, false)};
    script.input.push_back({20, sim::Set{"k", 0.2}});
    script.input.push_back({30, sim::Set{"speed", 0.08}});
    QVERIFY(std::abs(stateAfter(script, 25).gaitSpeed[0] - 0.025) < 1e-12);
    QVERIFY(std::abs(stateAfter(script, 35).gaitSpeed[0] - 0.08) < 1e-12);
}

void WalkingFurther::theFeetDiagramTellsWhichFeetStand_data()
{
    QTest::addColumn<QString>("id");
    for (const char *id : {"ground", "more_feet", "steering", "walls", "company"})
        QTest::newRow(id) << id;
}

void WalkingFurther::theFeetDiagramTellsWhichFeetStand()
{
    QFETCH(QString, id);
    const lessons::Step &step = m_lesson.step(id);
    const sim::Scene scene = step.scene(step.defaultValues());
    const lessons::View look = step.view(scene, step.defaultValues());
    const auto feet = std::count_if(scene.names.begin(), scene.names.end(), [](const std::string &name) {
        return name.find("foot") != std::string::npos;
    });
    QCOMPARE(static_cast<std::ptrdiff_t>(look.feet.size()), feet);
    QVERIFY(look.ground.has_value() != look.room.has_value());
    QCOMPARE(look.followedPoint >= 0, look.ground.has_value());
    int stood = 0, lifted = 0;
    sim::Track track(step.script(), 0);
    for (int frame = 0; frame <= 300; ++frame) {
        track.seek({frame, 0});
        for (int foot : look.feet) {
            const bool stands = step.isFootDown(scene, track.state(), step.defaultValues(), foot);
            QCOMPARE(stands, track.state().positionOf(foot).y == 400.0);
            (stands ? stood : lifted) += 1;
        }
    }
    QVERIFY(stood > 50 && lifted > 50);
    sim::Script held = step.script();
    const std::string name = scene.names[static_cast<std::size_t>(look.feet.front())];
    held.input = {{1, sim::Grab{name}}, {1, sim::Move{{200, 400}}}};
    QVERIFY(!step.isFootDown(scene, stateAfter(held, 5), step.defaultValues(), look.feet.front()));
}

QTEST_GUILESS_MAIN(WalkingFurther)
#include "tst_walking_variations.moc"
