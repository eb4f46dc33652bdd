#include "lessons/api/view/view.h"
#include "sim/run/script/composed_interval.h"
#include "tests/lessons/support/published_files.h"
#include "tests/lessons/support/support.h"
#include "tests/lessons/support/tutorial_match.h"
#include "tests/suite.h"

#include <QTest>

#include <cmath>
#include <complex>
#include <numbers>

using namespace support;

class SingleSpring : public QObject
{
    Q_OBJECT

    const LoadedLesson m_lesson = loadLesson(QStringLiteral("single_spring"));

    const lessons::Step &step(const char *id) const { return m_lesson.step(QString::fromUtf8(id)); }

    /// Returns the step's script with the foot at rest at (`x`, 200).
    sim::Script footAt(const char *id, double x, const Changes &changes = {}) const
    {
        sim::Script script = scriptOf(step(id), "published", 1.0, changes);
        script.bodies["foot"] = {{x, 200.0}, sim::Vec2{}};
        return script;
    }

private slots:
    void publishedTrajectories_data() { addPublishedRows(QStringLiteral("single_spring")); }
    void publishedTrajectories() { checkPublished(m_lesson); }
    void matchesTutorialCode_data();
    void matchesTutorialCode();
    void thrownFootGlidesTheGeometricSum_data();
    void thrownFootGlidesTheGeometricSum();
    void springFollowsItsEigenvalues_data();
    void springFollowsItsEigenvalues();
    void periodMatchesTheEigenvalues();
    void springConvergesToTheDampedOscillatorWithOrderOne_data();
    void springConvergesToTheDampedOscillatorWithOrderOne();
    void footComesToRestAtItsTarget_data();
    void footComesToRestAtItsTarget();
    void handleFeelsNoForceAndHasNoVelocity();
    void firstTwoStepsHaveNoBody();
    void futureForceIsDrawnButDoesNotAct();
    void onlyActingSpringsAreDrawn_data();
    void onlyActingSpringsAreDrawn();
    void angleLabelShowsDegreesAndRadians();
};

void SingleSpring::matchesTutorialCode_data()
{
    using Kind = Tutorial::Kind;
    QTest::addColumn<Match>("match");
    std::mt19937 random(1);
    for (int run = 0; run < 20; ++run) {
        for (const auto &[id, kind] :
             {std::pair{"fixed_centre", Kind::fixedCentre}, std::pair{"moving_body", Kind::movingBody},
              std::pair{"offset", Kind::offset}, std::pair{"radial", Kind::radial}})
            QTest::addRow("%s, random drags %d", id, run) << Match{id, randomTutorial(kind, 1, random)};
    }
}

void SingleSpring::matchesTutorialCode()
{
    QFETCH(Match, match);
    QVERIFY(largestDifference(step(match.step), match.tutorial, 200) <= 1e-9);
}

void SingleSpring::thrownFootGlidesTheGeometricSum_data()
{
    QTest::addColumn<double>("damp");
    QTest::newRow("damping 0.5: once the last drag distance") << 0.5;
    QTest::newRow("damping 0.9: nine times that distance") << 0.9;
    QTest::newRow("damping 0.95: nineteen times that distance") << 0.95;
}

void SingleSpring::thrownFootGlidesTheGeometricSum()
{
    QFETCH(double, damp);
    sim::Script script = footAt("drag", 100.0, {{"damp", damp}});
    script.input = {
        {1, sim::Grab{"foot"}}, {1, sim::Move{{100, 200}}}, {2, sim::Move{{110, 200}}}, {3, sim::Release{}}};
    const double expected = 110.0 + 10.0 * damp / (1.0 - damp);
    QVERIFY(std::abs(stateAfter(script, 2000).position(0, 0) - expected) < 1e-9);
}

void SingleSpring::springFollowsItsEigenvalues_data()
{
    QTest::addColumn<double>("k");
    QTest::addColumn<double>("damp");
    QTest::addColumn<QString>("method");
    QTest::addColumn<double>("h");
    QTest::newRow("as published") << 0.2 << 0.9 << "published" << 1.0;
    QTest::newRow("soft") << 0.02 << 0.95 << "published" << 1.0;
    QTest::newRow("stiff") << 2.0 << 0.8 << "published" << 1.0;
    QTest::newRow("without damping") << 0.2 << 1.0 << "published" << 1.0;
    QTest::newRow("steps of a quarter frame") << 0.2 << 0.9 << "published" << 0.25;
    QTest::newRow("semi-implicit Euler") << 0.2 << 0.9 << "semi_implicit_euler" << 0.5;
}

/// One step is the map v' = d (v - h k x), x' = x + h v' with d = damp^h. Its eigenvalues r e^(+-i angle)
/// have r^2 = d and 2 r cos(angle) = 1 + d - d k h^2. So x_n = r^n (x_0 cos(n angle) + b sin(n angle)).
void SingleSpring::springFollowsItsEigenvalues()
{
    QFETCH(double, k);
    QFETCH(double, damp);
    QFETCH(QString, method);
    QFETCH(double, h);
    sim::Script script = footAt("fixed_centre", 420.0, {{"k", k}, {"damp", damp}});
    script.method = scriptOf(step("fixed_centre"), method.toStdString(), h).method;
    script.step = sim::StepSize::ofLength(h);
    const double d = std::pow(damp, h);
    const double r = std::sqrt(d);
    const double angle = std::acos((1.0 + d - d * k * h * h) / (2.0 * r));
    const double x0 = 150.0;
    const double x1 = x0 - h * d * h * k * x0;
    const double b = (x1 / r - x0 * std::cos(angle)) / std::sin(angle);
    sim::Track track(script, 0);
    for (int frame = 0; frame <= 200; ++frame) {
        const double n = frame / h;
        const double x = std::pow(r, n) * (x0 * std::cos(n * angle) + b * std::sin(n * angle));
        track.seek({frame, 0});
        QVERIFY(std::abs(track.state().position(0, 0) - (270.0 + x)) < 1e-9);
    }
}

void SingleSpring::periodMatchesTheEigenvalues()
{
    sim::Track track(footAt("fixed_centre", 420.0, {{"damp", 1.0}}), 0);
    int crossings = 0;
    double before = 150.0;
    constexpr int frames = 10'000;
    for (int frame = 1; frame <= frames; ++frame) {
        track.seek({frame, 0});
        const double now = track.state().position(0, 0) - 270.0;
        crossings += now * before < 0.0;
        before = now;
    }
    const double period = 2.0 * std::numbers::pi / std::acos(1.0 - 0.2 / 2.0);
    QVERIFY(std::abs(crossings - 2.0 * frames / period) <= 1.0);
}

void SingleSpring::springConvergesToTheDampedOscillatorWithOrderOne_data()
{
    QTest::addColumn<QString>("method");
    QTest::newRow("published") << "published";
    QTest::newRow("semi-implicit Euler") << "semi_implicit_euler";
}

/// The model is x'' = -k x - c x' with c = -ln(damp).
void SingleSpring::springConvergesToTheDampedOscillatorWithOrderOne()
{
    QFETCH(QString, method);
    const double c = -std::log(0.9);
    const double w = std::sqrt(0.2 - c * c / 4.0);
    const auto exact = [&](double t) {
        return 150.0 * std::exp(-c * t / 2.0) * (std::cos(w * t) + c / (2.0 * w) * std::sin(w * t));
    };
    const OrderRange order = observedOrders(
        [&](double h) {
            sim::Script script = scriptOf(step("fixed_centre"), method.toStdString(), h);
            script.bodies["foot"] = {{420.0, 200.0}, sim::Vec2{}};
            sim::Track track(script, 0);
            double largest = 0.0;
            for (int frame = 1; frame <= 20; ++frame) {
                track.seek({frame, 0});
                largest = std::max(largest, std::abs(track.state().position(0, 0) - 270.0 - exact(frame)));
            }
            return largest;
        },
        3, 8);
    QVERIFY(order.min > 0.9 && order.max < 1.1);
}

void SingleSpring::footComesToRestAtItsTarget_data()
{
    QTest::addColumn<QString>("id");
    QTest::addColumn<double>("startX");
    QTest::addColumn<double>("restX");
    QTest::newRow("fixed centre") << "fixed_centre" << 420.0 << 270.0;
    QTest::newRow("body") << "moving_body" << 100.0 << 270.0;
    QTest::newRow("right of the body, from the left") << "offset" << 100.0 << 320.0;
    QTest::newRow("right of the body, from close by on the right") << "radial" << 300.0 << 320.0;
    QTest::newRow("left of the body, from close by on the left") << "radial" << 240.0 << 220.0;
}

void SingleSpring::footComesToRestAtItsTarget()
{
    QFETCH(QString, id);
    QFETCH(double, startX);
    QFETCH(double, restX);
    const sim::State rest = stateAfter(footAt(qPrintable(id), startX), 1000);
    QVERIFY(std::abs(rest.position(0, 0) - restX) < 1e-9);
    QVERIFY(std::abs(rest.position(0, 1) - 200.0) < 1e-9);
}

void SingleSpring::handleFeelsNoForceAndHasNoVelocity()
{
    for (const char *id : {"moving_body", "offset", "radial"}) {
        sim::Script script = step(id).script();
        script.input = {{5, sim::Grab{"body"}}, {6, sim::Move{{300, 100}}}, {7, sim::Release{}}};
        sim::Track track(script, 0);
        for (int frame = 0; frame < 30; ++frame) {
            track.seek({frame, 0});
            QCOMPARE(track.state().velocityOf(1), (sim::Vec2{0, 0}));
            QCOMPARE(track.state().positionOf(1), frame < 6 ? (sim::Vec2{270, 200}) : (sim::Vec2{300, 100}));
        }
    }
}

void SingleSpring::firstTwoStepsHaveNoBody()
{
    for (const char *id : {"drag", "fixed_centre"})
        QCOMPARE(step(id).scene(step(id).defaultValues()).names, std::vector<std::string>{"foot"});
}

void SingleSpring::futureForceIsDrawnButDoesNotAct()
{
    const lessons::Step &drag = step("drag");
    const sim::Script script = drag.script();
    const sim::State start = script.build(script.values).start;
    QCOMPARE(stateAfter(script, 50).positionOf(0), start.positionOf(0));
    const auto overlays = drag.overlays(script.build(script.values), start, script.values);
    QCOMPARE(overlays.size(), std::size_t{2});
    QCOMPARE(overlays[0].a, (sim::Vec2{270, 200}));
    QCOMPARE(overlays[1].b, (sim::Vec2{0.2 * (270.0 - 420.0), 0.2 * (200.0 - 120.0)}));
}

void SingleSpring::onlyActingSpringsAreDrawn_data()
{
    QTest::addColumn<int>("springs");
    QTest::newRow("drag") << 0;
    for (const char *id : {"fixed_centre", "moving_body", "offset", "radial"})
        QTest::newRow(id) << 1;
}

void SingleSpring::onlyActingSpringsAreDrawn()
{
    QFETCH(int, springs);
    const lessons::Step &lessonStep = step(QTest::currentDataTag());
    sim::Script script = scriptOf(lessonStep);
    const auto drawnSprings = [&] {
        const sim::Scene scene = sim::Track(script, 0).interval().scene;
        return static_cast<int>(lessonStep.view(scene, script.values).springs.size());
    };
    QCOMPARE(drawnSprings(), springs);
    script.values.set("k", 0.0);
    QCOMPARE(drawnSprings(), 0); // without stiffness it does not pull
    script.values.set("k", 0.2);
    for (const char *id : {"point_spring", "body_spring", "offset_spring", "radial_spring"})
        script.effectsOff.push_back(id);
    QCOMPARE(drawnSprings(), 0);
}

void SingleSpring::angleLabelShowsDegreesAndRadians()
{
    const lessons::Step &radial = step("radial");
    const sim::Scene scene = radial.scene(radial.defaultValues());
    const auto overlays = radial.overlays(scene, scene.start, radial.defaultValues());
    QCOMPARE(overlays.back().label, QStringLiteral("45.0° = 0.785 rad"));
    QVERIFY(radial.narration.contains(QStringLiteral("57.2958")));
}

SUITE(tst_single_spring, SingleSpring)
#include "tst_single_spring.moc"
