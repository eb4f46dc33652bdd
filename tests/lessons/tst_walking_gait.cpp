#include "lessons/api/view/view.h"
#include "tests/lessons/support/published_files.h"
#include "tests/lessons/support/support.h"
#include "tests/lessons/support/trajectory.h"
#include "tests/lessons/support/walking_tutorial.h"

#include "sim/methods/methods.h"
#include "tests/suite.h"

#include <QTest>

#include <cmath>
#include <complex>
#include <numbers>

using namespace support;
using std::numbers::pi;
using Complex = std::complex<double>;

namespace {

/// Returns z(t) for z'' + c z' + k (z - centre - radius e^{i (phase + speed t)}) = 0, from rest at `start`.
/// This is the exact motion of a foot whose target moves on a circle. The solution is a circle and two
/// decaying modes.
Complex driven(double k, double c, Complex centre, double radius, double phase, double speed, Complex start,
               double t)
{
    const Complex i(0.0, 1.0);
    const Complex circle = k * radius * std::polar(1.0, phase) / (k - speed * speed + i * c * speed);
    const Complex root = std::sqrt(Complex(c * c - 4.0 * k));
    const Complex eigenvalue1 = 0.5 * (-c + root), eigenvalue2 = 0.5 * (-c - root);
    const Complex x = start - centre - circle, v = -i * speed * circle;
    const Complex a = (v - eigenvalue2 * x) / (eigenvalue1 - eigenvalue2), b = x - a;
    return centre + circle * std::exp(i * speed * t) + a * std::exp(eigenvalue1 * t) +
           b * std::exp(eigenvalue2 * t);
}

Complex complex(sim::Vec2 a)
{
    return {a.x, a.y};
}

}

/// The published steps up to `body_pulled`, and all things to try. Step `ground` is in
/// tst_walking_ground.cpp. The tutorial's suggestions are in tst_walking_variations.cpp and
/// tst_walking_company.cpp.
class WalkingGait : public QObject
{
    Q_OBJECT

    const LoadedLesson m_lesson = loadLesson(QStringLiteral("walking_gait"));

    const lessons::Step &step(const char *id) const { return m_lesson.step(QString::fromUtf8(id)); }

    static int orderOfRow()
    {
        QFETCH(QString, method);
        return sim::findMethod(method.toStdString())->order();
    }

    sim::Script scriptOfRow(const char *id, double h, const Changes &changes = {}) const
    {
        QFETCH(QString, method);
        return scriptOf(step(id), method.toStdString(), h, changes);
    }

private slots:
    void publishedTrajectories_data();
    void publishedTrajectories() { checkPublished(m_lesson); }
    void matchesTutorialCode_data();
    void matchesTutorialCode();
    void footZeroRestsOnTheLeft();
    void footConvergesToItsExactSolution_data() { addWalkingMethodRows(); }
    void footConvergesToItsExactSolution();
    void creatureConvergesToItsExactSolution_data() { addWalkingMethodRows(); }
    void creatureConvergesToItsExactSolution();
    void swingWidthMatchesText();
    void legsConserveMomentum_data();
    void legsConserveMomentum();
    void heldEndStaysAndTheOtherFeelsTheLeg();
    void curveChangesOnlyTheView();
};

void WalkingGait::publishedTrajectories_data()
{
    QCOMPARE(publishedNames(QStringLiteral("walking_gait")).size(), 3);
    addPublishedRows(QStringLiteral("walking_gait"));
}

void WalkingGait::matchesTutorialCode_data()
{
    QTest::addColumn<Walk>("walk");
    std::mt19937 random(5);
    using Kind = WalkingTutorial::Kind;
    const std::vector<std::pair<const char *, Kind>> steps = {
        {"bones", Kind::bones},       {"legs", Kind::bones},     {"feet_below", Kind::below},
        {"curved_legs", Kind::below}, {"swing", Kind::swing},    {"body_pulled", Kind::bodyPulled},
        {"ground", Kind::ground},     {"steering", Kind::ground}};
    for (const auto &[id, kind] : steps) {
        for (int run = 0; run < 12; ++run)
            QTest::addRow("%s, random drags %d", id, run) << Walk{id, randomWalk(kind, 2, random)};
    }
    for (int feet = 2; feet <= 12; ++feet)
        QTest::addRow("more_feet, %d feet", feet)
            << Walk{"more_feet", randomWalk(Kind::ground, feet, random)};
}

void WalkingGait::matchesTutorialCode()
{
    QFETCH(Walk, walk);
    QVERIFY(largestDifference(step(walk.step), walk.tutorial, 300) <= 1e-9);
}

void WalkingGait::footZeroRestsOnTheLeft()
{
    const sim::State rest = stateAfter(step("bones").script(), 1000);
    QVERIFY(sim::length(rest.positionOf(0) - sim::Vec2{220, 200}) < 1e-9);
    QVERIFY(sim::length(rest.positionOf(1) - sim::Vec2{320, 200}) < 1e-9);
    const sim::State below = stateAfter(step("feet_below").script(), 1000);
    QVERIFY(sim::length(below.positionOf(0) - sim::Vec2{220, 350}) < 1e-9);
    QVERIFY(std::abs(sim::length(below.positionOf(0) - below.positionOf(2)) - 70.7) < 0.05);
}

void WalkingGait::footConvergesToItsExactSolution()
{
    const double damping = -std::log(0.9);
    const OrderRange order = observedOrders(
        [&](double h) {
            const sim::State state = stateAfter(scriptOfRow("swing", h, {{"speed", 0.3}}), 40);
            const Complex target = driven(0.2, damping, {270, 350}, 50.0, pi, 0.3, Complex(220, 350), 40.0);
            return std::abs(complex(state.positionOf(0)) - target);
        },
        4, 9);
    QVERIFY2(order.min > orderOfRow() - 0.1 && order.max < orderOfRow() + 0.1,
             qPrintable(u"%1 to %2"_qs.arg(order.min).arg(order.max)));
}

/// Relative to the body, the sum of both feet has the stiffness k (1 + 2) and their difference has k. The
/// body moves against the sum.
void WalkingGait::creatureConvergesToItsExactSolution()
{
    const double damping = -std::log(0.9);
    const auto exact = [&](double t) {
        const Complex sum = driven(3.0 * 0.2, damping, {0, 100}, 0.0, 0.0, 0.1, Complex(30, 80), t);
        const Complex against = driven(0.2, damping, {0, 0}, 50.0, pi, 0.1, Complex(-65, 10), t);
        const Complex body = Complex(290, 300) - (sum - Complex(30, 80)) / 3.0;
        return body + 0.5 * sum + against;
    };
    const OrderRange order = observedOrders(
        [&](double h) {
            sim::Script script = scriptOfRow("body_pulled", h, {{"speed", 0.1}});
            // Feet relative to the body: (-50, 50) and (80, 30).
            script.bodies = {
                {"body", {{290, 300}, {}}}, {"foot0", {{240, 350}, {}}}, {"foot1", {{370, 330}, {}}}};
            return std::abs(complex(stateAfter(script, 40).positionOf(0)) - exact(40.0));
        },
        7, 10);
    QVERIFY2(order.min > orderOfRow() - 0.1 && order.max < orderOfRow() + 0.1,
             qPrintable(u"%1 to %2"_qs.arg(order.min).arg(order.max)));
}

/// Checks the 50.6 px of the text. Near its natural frequency a foot swings much farther.
void WalkingGait::swingWidthMatchesText()
{
    const auto width = [&](double speed) {
        const sim::State state =
            stateAfter(scriptOf(step("swing"), "published", 1.0, {{"speed", speed}}), 500);
        return sim::length(state.positionOf(0) - sim::Vec2{270, 350});
    };
    QVERIFY(std::abs(width(0.05) - 50.6) < 0.05);
    QVERIFY(width(0.45) > 150.0);
    QVERIFY(width(1.5) < 10.0);
}

void WalkingGait::legsConserveMomentum_data()
{
    QTest::addColumn<QString>("method");
    QTest::addColumn<double>("h");
    for (const sim::MethodPtr &method : walkingMethods()) {
        for (double h : {1.0, 0.5, 0.125})
            QTest::addRow("%s, h %g", method->id().c_str(), h) << QString::fromStdString(method->id()) << h;
    }
}

void WalkingGait::legsConserveMomentum()
{
    QFETCH(double, h);
    sim::Script script = scriptOfRow("body_pulled", h, {{"damp", 1.0}});
    script.bodies = {{"foot0", {{200, 300}, sim::Vec2{5, -2}}},
                     {"foot1", {{350, 390}, sim::Vec2{1, 4}}},
                     {"body", {{270, 300}, sim::Vec2{-2, 3}}}};
    for (int frames : {1, 10, 100, 1000}) {
        const sim::State state = stateAfter(script, frames);
        QVERIFY(sim::length(momentumOf(state) - sim::Vec2{4, 5}) < 1e-10);
    }
    const double moved = sim::length(stateAfter(script, 10).velocityOf(2) - sim::Vec2{-2, 3});
    QVERIFY2(moved > 1.0, "legs must transfer momentum during this run");
}

void WalkingGait::heldEndStaysAndTheOtherFeelsTheLeg()
{
    sim::Script script = scriptOf(step("body_pulled"), "published", 1.0, {{"damp", 1.0}, {"speed", 0.0}});
    script.bodies = {{"foot0", {{200, 350}, {}}}}; // 20 px left of its target
    script.input = {{1, sim::Grab{"foot0"}}};
    const sim::State footHeld = stateAfter(script, 1);
    QCOMPARE(footHeld.positionOf(0), (sim::Vec2{200, 350}));
    QVERIFY(sim::length(footHeld.velocityOf(2) - sim::Vec2{-4, 0}) < 1e-12); // k 0.2 times 20 px
    script.input = {{1, sim::Grab{"body"}}};
    const sim::State bodyHeld = stateAfter(script, 1);
    QCOMPARE(bodyHeld.positionOf(2), (sim::Vec2{270, 300}));
    QVERIFY(sim::length(bodyHeld.velocityOf(0) - sim::Vec2{4, 0}) < 1e-12);
}

void WalkingGait::curveChangesOnlyTheView()
{
    const lessons::Step &curved = step("curved_legs");
    const auto run = [&](double curve) {
        sim::Script script = scriptOf(curved, "published", 1.0, {{"curve", curve}});
        script.bodies = {{"body", {{200, 250}, {}}}};
        return stateAfter(script, 50);
    };
    QVERIFY(sim::sameBits(run(50.0), run(-20.0)));
    sim::Values values = curved.defaultValues();
    values.set("curve", 33.0);
    const lessons::View view = curved.view(curved.scene(values), values);
    QCOMPARE(view.legs.size(), std::size_t{2});
    for (const lessons::LegView &leg : view.legs) {
        QCOMPARE(leg.curve, 33.0);
        QVERIFY(leg.from == 2 && leg.to < 2);
    }
}

SUITE(tst_walking_gait, WalkingGait)
#include "tst_walking_gait.moc"
