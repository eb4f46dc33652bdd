#include "tests/lessons/support/codeling_targets.h"
#include "tests/lessons/support/published_files.h"
#include "tests/lessons/support/support.h"
#include "tests/suite.h"

#include <QTest>

#include <cmath>
#include <complex>

using namespace support;

namespace {

struct Position
{
    double x = 0.0, y = 0.0;
    Position minus(Position other) const { return {x - other.x, y - other.y}; }
    double length() const { return std::hypot(x, y); }
};

/// The tutorial's code for lead and tail, transcribed from its text without any code of sim. It keeps current
/// and previous positions, and no velocities.
struct Printed
{
    double k = 0.9, dt = 0.25, keep = 0.7, anticipation = 0.2, along = 0.7, across = 0.5;
    double soft = 0.1, hard = 0.8, minLength = 20, restLength = 40, maxLength = 60;
    Position lead, leadBefore, tail, tailBefore, target;

    void mouseDown(Position at)
    {
        target = at;
        const Position displacement = lead.minus(target);
        lead.x += displacement.x * anticipation;
        lead.y += displacement.y * anticipation;
    }

    void update()
    {
        moveLead();
        moveTail();
        relax();
    }

private:
    void moveLead()
    {
        const Position force = {-k * (lead.x - target.x), -k * (lead.y - target.y)};
        const Position next = {(1 + keep) * lead.x - keep * leadBefore.x + force.x * dt * dt,
                               (1 + keep) * lead.y - keep * leadBefore.y + force.y * dt * dt};
        leadBefore = lead;
        lead = next;
    }

    void moveTail()
    {
        const Position velocity = tail.minus(tailBefore), displacement = lead.minus(tail);
        const double dot = velocity.x * displacement.x + velocity.y * displacement.y;
        const double ratio = dot / (displacement.length() * displacement.length());
        const Position parallel = {displacement.x * ratio, displacement.y * ratio};
        const Position perpendicular = velocity.minus(parallel);
        tailBefore = tail;
        tail.x += along * parallel.x + across * perpendicular.x;
        tail.y += along * parallel.y + across * perpendicular.y;
    }

    void relax()
    {
        const Position displacement = lead.minus(tail);
        const double length = displacement.length();
        double wanted = restLength, strength = soft;
        if (length < minLength || length > maxLength) {
            wanted = length < minLength ? minLength : maxLength;
            strength = hard;
        }
        const double ratio = (length - wanted) / length * strength;
        tail.x += displacement.x * ratio;
        tail.y += displacement.y * ratio;
    }
};

}

class Codeling : public QObject
{
    Q_OBJECT

    const LoadedLesson m_lesson = loadLesson(QStringLiteral("codeling"));

    const lessons::Step &step(const char *id) const { return m_lesson.step(QString::fromUtf8(id)); }

private slots:
    void publishedTrajectories_data() { addPublishedRows(QStringLiteral("codeling")); }
    void publishedTrajectories() { checkPublished(m_lesson); }
    void matchesPrintedCode_data();
    void matchesPrintedCode();
    void motorIsExactDampedOscillator_data();
    void motorIsExactDampedOscillator();
    void motorConvergesToContinuousModel();
    void tailKeepsItsRestLength();
    void anticipationIsOppositeToMove_data();
    void anticipationIsOppositeToMove();
    void bothTargetsInOneFrameCount();
    void heldLeadDoesNotAnticipate();
    void softStickRelaxationDoesNotDependOnStep();
    void settingTheTargetParameterMovesIt();
};

void Codeling::matchesPrintedCode_data()
{
    QTest::addColumn<int>("seed");
    for (int seed = 1; seed <= 20; ++seed)
        QTest::addRow("random targets %d", seed) << seed;
    for (int seed = 21; seed <= 80; ++seed)
        QTest::addRow("random parameters and targets %d", seed) << seed;
}

void Codeling::matchesPrintedCode()
{
    QFETCH(int, seed);
    constexpr int frames = 400;
    std::mt19937 random(static_cast<unsigned>(seed));
    const auto real = [&](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    };
    Printed printed;
    if (seed > 20) { // in ranges that keep the tail off the lead, where rounding errors grow
        printed.k = real(0.3, 2);
        printed.dt = real(0.15, 0.4);
        printed.keep = real(0.3, 0.9);
        printed.anticipation = real(0, 0.3);
        printed.along = real(0.3, 0.9);
        printed.across = real(0.3, 0.9);
        printed.soft = real(0.05, 0.5);
        printed.hard = real(0.7, 1);
        printed.minLength = real(15, 25);
        printed.restLength = printed.minLength + real(10, 30);
        printed.maxLength = printed.restLength + real(10, 30);
    }
    printed.target = {real(0, 540), real(0, 400)};
    printed.lead = printed.leadBefore = {real(0, 540), real(0, 400)};
    printed.tail = printed.tailBefore = {printed.lead.x + real(5, 70), printed.lead.y - real(5, 70)};
    sim::Script script = scriptOf(step("squash_stretch"), "published", 1.0,
                                  {{"k", printed.k},
                                   {"dt", printed.dt},
                                   {"keep", printed.keep},
                                   {"anticipation", printed.anticipation},
                                   {"along", printed.along},
                                   {"across", printed.across},
                                   {"soft", printed.soft},
                                   {"hard", printed.hard},
                                   {"min_length", printed.minLength},
                                   {"rest_length", printed.restLength},
                                   {"max_length", printed.maxLength},
                                   {"target_x", printed.target.x},
                                   {"target_y", printed.target.y}});
    script.bodies = {{"lead", {{printed.lead.x, printed.lead.y}, {}}},
                     {"tail", {{printed.tail.x, printed.tail.y}, {}}}};
    const Targets targets = randomTargets(frames, seed % 2, 40, static_cast<unsigned>(seed));
    addTargets(script, targets);
    sim::Track track(script, 0);
    auto next = targets.begin();
    for (int frame = 1; frame <= frames; ++frame) {
        for (; next != targets.end() && next->first == frame; ++next)
            printed.mouseDown({next->second.x, next->second.y});
        printed.update();
        track.seek({frame, 0});
        for (const auto &[point, wanted] : {std::pair{0, printed.lead}, std::pair{1, printed.tail}}) {
            const sim::Vec2 at = track.state().positionOf(point);
            QVERIFY2(std::abs(at.x - wanted.x) <= 1e-9 && std::abs(at.y - wanted.y) <= 1e-9,
                     qPrintable(QString::number(frame)));
        }
    }
}

void Codeling::motorIsExactDampedOscillator_data()
{
    QTest::addColumn<double>("k");
    QTest::addColumn<double>("keep");
    QTest::newRow("as published") << 0.9 << 0.7;
    QTest::newRow("no drag") << 0.9 << 1.0;
    QTest::newRow("much drag: no overshoot") << 0.5 << 0.3;
    QTest::newRow("stiff") << 20.0 << 0.7;
}

/// Relative to the target, x(n+1) = (1 + keep - k dt^2) x(n) - keep x(n-1). The solution is a sum of powers
/// of the two roots of z^2 = (1 + keep - k dt^2) z - keep. From rest, x(0) = 1 and x(1) = 1 - k dt^2.
void Codeling::motorIsExactDampedOscillator()
{
    QFETCH(double, k);
    QFETCH(double, keep);
    const double pull = k * 0.25 * 0.25;
    const std::complex<double> sum = 1 + keep - pull;
    const std::complex<double> root = std::sqrt(sum * sum - 4 * keep);
    const std::complex<double> z1 = 0.5 * (sum + root), z2 = 0.5 * (sum - root);
    const std::complex<double> part1 = (1 - pull - z2) / (z1 - z2), part2 = 1.0 - part1;
    sim::Script script = scriptOf(step("motor"), "published", 1.0, {{"k", k}, {"keep", keep}});
    script.values.set("target_x", 450);
    script.values.set("target_y", 120);
    for (const int n : {1, 2, 3, 10, 40, 100}) {
        const double remaining = (part1 * std::pow(z1, n) + part2 * std::pow(z2, n)).real();
        const sim::Vec2 wanted = sim::Vec2{450, 120} + remaining * sim::Vec2{-250, 80};
        QVERIFY(sim::length(stateAfter(script, n).positionOf(0) - wanted) <= 1e-9);
    }
}

/// The model is x'' = k dt^2 (target - x) - c x' with c = -ln(keep), from rest.
void Codeling::motorConvergesToContinuousModel()
{
    const double c = -std::log(0.7), w2 = 0.9 * 0.0625, w = std::sqrt(w2 - c * c / 4), t = 12;
    const double remaining = std::exp(-c * t / 2) * (std::cos(w * t) + c / (2 * w) * std::sin(w * t));
    for (const char *method : {"published", "semi_implicit_euler"}) {
        const OrderRange order = observedOrders(
            [&](double h) {
                const sim::Script script = scriptOf(step("motor"), method, h, {{"target_x", 450}});
                return std::abs(stateAfter(script, 12).position(0, 0) - (450 - 250 * remaining));
            },
            4, 9);
        QVERIFY(order.min > 0.9 && order.max < 1.1);
    }
}

void Codeling::tailKeepsItsRestLength()
{
    for (const char *id : {"orientation", "anticipation"}) {
        sim::Script script = step(id).script();
        addTargets(script, randomTargets(1000, 1, 60, 11));
        sim::Track track(script, 0);
        for (int frame = 1; frame <= 1000; ++frame) {
            track.seek({frame, 0});
            QVERIFY(std::abs(sim::length(track.state().positionOf(0) - track.state().positionOf(1)) - 40.0) <=
                    1e-9);
        }
        QVERIFY(!track.stop());
    }
}

void Codeling::anticipationIsOppositeToMove_data()
{
    QTest::addColumn<QString>("id");
    for (const lessons::Step &each : m_lesson.steps) {
        if (each.parameter("anticipation"))
            QTest::addRow("%s", qPrintable(each.id)) << each.id;
    }
}

/// From rest at (200, 200), the shift is 0.2 of the distance, away from the target. In the first frame the
/// lead keeps 0.7 of that shift as velocity. The motor pulls it by 0.05625 of the distance, which is now 1.2
/// times as long. The sum is 0.2 + 0.14 - 0.0675 of the distance.
void Codeling::anticipationIsOppositeToMove()
{
    QFETCH(QString, id);
    for (const double angle : {0.0, 1.0, 2.5, 4.0}) {
        const sim::Vec2 toTarget = 150.0 * sim::Vec2{std::cos(angle), std::sin(angle)};
        sim::Script script = m_lesson.step(id).script();
        script.input = {{10, sim::Target{sim::Vec2{200, 200} + toTarget}}};
        const sim::Vec2 moved = stateAfter(script, 10).positionOf(0) - sim::Vec2{200, 200};
        QVERIFY(sim::length(moved + (0.2 + 0.14 - 0.0675) * toTarget) <= 1e-9);
        QVERIFY(sim::length(stateAfter(script, 100).positionOf(0) - sim::Vec2{200, 200} - toTarget) < 0.1);
    }
}

void Codeling::bothTargetsInOneFrameCount()
{
    sim::Script script = step("anticipation").script();
    script.input = {{1, sim::Target{{300, 200}}}, {1, sim::Target{{200, 400}}}};
    const sim::State state = stateAfter(script, 1);
    // 200 - 20 = 180 and 200, then + 0.2 (180 - 200, 200 - 400): (176, 160), with the velocity (-24, -40).
    const sim::Vec2 v = sim::Vec2{0.7 * -24, 0.7 * -40} + 0.05625 * sim::Vec2{200 - 176, 400 - 160};
    QVERIFY(sim::length(state.positionOf(0) - sim::Vec2{176, 160} - v) <= 1e-9);
}

void Codeling::heldLeadDoesNotAnticipate()
{
    sim::Script script = step("squash_stretch").script();
    script.input = {{1, sim::Grab{"lead"}}, {1, sim::Move{{300, 300}}}, {5, sim::Target{{100, 100}}}};
    QCOMPARE(stateAfter(script, 20).positionOf(0), (sim::Vec2{300, 300}));
}

/// After h frames (1 - soft)^h of the error remains, for any step. Lead and tail are at rest and nothing else
/// acts on the tail.
void Codeling::softStickRelaxationDoesNotDependOnStep()
{
    for (const double h : {1.0, 0.5, 0.125}) {
        sim::Script script = scriptOf(step("squash_stretch"), "published", h, {{"along", 0}, {"across", 0}});
        script.bodies["tail"] = {{150, 200}, {}};
        for (const int frame : {1, 5}) {
            const double spine = sim::length(stateAfter(script, frame).positionOf(0) -
                                             stateAfter(script, frame).positionOf(1));
            QVERIFY(std::abs(spine - (40 + 10 * std::pow(0.9, frame))) <= 1e-9);
        }
    }
}

void Codeling::settingTheTargetParameterMovesIt()
{
    sim::Script script = step("anticipation").script();
    script.input = {{10, sim::Set{"target_x", 400.0}}};
    QVERIFY(sim::length(stateAfter(script, 200).positionOf(0) - sim::Vec2{400, 200}) < 1e-6);
}

SUITE(tst_codeling, Codeling)
#include "tst_codeling.moc"
