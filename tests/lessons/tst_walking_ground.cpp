#include "sim/run/script/composed_interval.h"
#include "sim/run/script/script.h"
#include "sim/run/track.h"
#include "tests/lessons/support.h"

#include "sim/methods/methods.h"

#include <QTest>

#include <array>
#include <cmath>
#include <numbers>

using namespace support;
using std::numbers::pi;

/// Step `ground` of the lesson on walking: it walks, and why.
class WalkingGround : public QObject
{
    Q_OBJECT

    const LoadedLesson m_lesson = loadLesson(QStringLiteral("walking_gait"));

    const lessons::Step &step(const char *id) const { return m_lesson.step(QString::fromUtf8(id)); }

    static void addMethodRows()
    {
        QTest::addColumn<QString>("method");
        for (const sim::MethodPtr &method : walkingMethods())
            QTest::addRow("%s", method->id().c_str()) << QString::fromStdString(method->id());
    }

    /// Whether the row's method computes as coarsely as the one that the steps' texts take their figures from.
    static bool asTheTextsSay()
    {
        QFETCH(QString, method);
        return sim::findMethod(method.toStdString())->order() == 1;
    }

    sim::Script scriptOfRow(const char *id, double h, const Changes &changes = {}) const
    {
        QFETCH(QString, method);
        return scriptOf(step(id), method.toStdString(), h, changes);
    }

    /// How far the body comes per frame, over whole turns of the clock after the first ten.
    static double pace(const sim::Script &script)
    {
        const double turn = 2.0 * pi / std::abs(script.values["speed"]);
        const auto from = std::llround(10.0 * turn), to = std::llround(20.0 * turn);
        sim::Track track(script, 0);
        track.seek({from, 0});
        const double before = track.state().positionOf(2).x;
        track.seek({to, 0});
        return (track.state().positionOf(2).x - before) / double(to - from);
    }

    /// What a measure of step `ground` says on the average over frames 600 to 1200, where it says anything.
    double averageOf(const char *name, const sim::Script &script) const;

private slots:
    void itWalksTheWayThatTheSignOfTheSpeedSays_data();
    void itWalksTheWayThatTheSignOfTheSpeedSays();
    void leftAndRightAreMirrorImages();
    void withoutTractionItDoesNotAdvance_data() { addMethodRows(); }
    void withoutTractionItDoesNotAdvance();
    void slipShrinksWithTheStep_data() { addMethodRows(); }
    void slipShrinksWithTheStep();
    void theGroundStopsAFootAndABounceTurnsItRound_data();
    void theGroundStopsAFootAndABounceTurnsItRound();
    void onlyFeetMeetTheGround();
};

double WalkingGround::averageOf(const char *name, const sim::Script &script) const
{
    for (const lessons::Measure &measure : step("ground").measures) {
        if (measure.name != QString::fromUtf8(name))
            continue;
        sim::Track track(script, 0);
        track.seek({600, 0});
        double sum = 0.0;
        int count = 0;
        for (int frame = 601; frame <= 1200; ++frame) {
            const sim::State before = track.state();
            track.seek({frame, 0});
            const double now =
                measure.of(track.interval().scene, track.state(), &before, track.interval().values);
            sum += std::isfinite(now) ? now : 0.0;
            count += std::isfinite(now);
        }
        return sum / count;
    }
    return NAN;
}

void WalkingGround::itWalksTheWayThatTheSignOfTheSpeedSays_data()
{
    QTest::addColumn<QString>("method");
    QTest::addColumn<double>("speed");
    QTest::addColumn<double>("least");
    for (const sim::MethodPtr &method : walkingMethods()) {
        for (const auto &[speed, least] : {std::pair{0.02, 0.4}, {0.05, 1.1}, {0.1, 2.4}, {0.15, 3.5}}) {
            for (double sign : {1.0, -1.0})
                QTest::addRow("%s, speed %g", method->id().c_str(), sign * speed)
                    << QString::fromStdString(method->id()) << sign * speed << sign * least;
        }
    }
}

void WalkingGround::itWalksTheWayThatTheSignOfTheSpeedSays()
{
    QFETCH(double, speed);
    QFETCH(double, least);
    const double walked = pace(scriptOfRow("ground", 1.0, {{"speed", speed}}));
    QVERIFY2(walked * speed > 0.0 && std::abs(walked) > std::abs(least), qPrintable(QString::number(walked)));
    if (std::abs(speed) == 0.05 && asTheTextsSay()) // the step's text: about 150 px in each turn
        QVERIFY(std::abs(std::abs(walked) * 2.0 * pi / 0.05 - 150.0) < 8.0);
}

void WalkingGround::leftAndRightAreMirrorImages()
{
    const auto after = [&](double speed) {
        return stateAfter(scriptOf(step("ground"), "published", 1.0, {{"speed", speed}}), 400);
    };
    const sim::State right = after(0.05), left = after(-0.05);
    const std::array<int, 3> mirrored = {1, 0, 2};
    for (int i = 0; i < 3; ++i) {
        const sim::Vec2 one = right.positionOf(i),
                        other = left.positionOf(mirrored[static_cast<std::size_t>(i)]);
        QVERIFY(std::abs(one.x - 270.0 + other.x - 270.0) < 1e-8 && std::abs(one.y - other.y) < 1e-8);
    }
}

/// Legs give the creature no momentum, gravity none sideways, and ice takes none: the middle stays.
void WalkingGround::withoutTractionItDoesNotAdvance()
{
    const sim::State state = stateAfter(scriptOfRow("ground", 1.0, {{"traction", 1.0}}), 3000);
    QVERIFY(std::abs(state.position.col(0).mean() - 270.0) < 1e-8);
    QVERIFY(std::abs(state.positionOf(2).x - 270.0) < 1.0);
    const double walked = stateAfter(scriptOfRow("ground", 1.0), 3000).positionOf(2).x - 270.0;
    QVERIFY(walked > 3000.0);
}

void WalkingGround::slipShrinksWithTheStep()
{
    const auto slip = [&](double h) { return averageOf("Slip", scriptOfRow("ground", h)); };
    if (asTheTextsSay()) {
        const double whole = slip(1.0);
        QVERIFY2(whole > 0.35 && whole < 0.5, qPrintable(QString::number(whole)));
        QVERIFY(std::abs(slip(0.5) - 0.25) < 0.01); // the step's text, as what follows
        QVERIFY(std::abs(pace(scriptOfRow("ground", 1.0)) - 1.2) < 0.05);
        QVERIFY(std::abs(pace(scriptOfRow("ground", 0.5)) - 1.4) < 0.05);
    }
    const Slope jacobian = slopeOf(slip, 0, 4);
    QVERIFY2(jacobian.least > 0.8 && jacobian.greatest < 1.2,
             qPrintable(u"%1 to %2"_qs.arg(jacobian.least).arg(jacobian.greatest)));
}

void WalkingGround::theGroundStopsAFootAndABounceTurnsItRound_data()
{
    QTest::addColumn<double>("bounce");
    QTest::addColumn<double>("traction");
    QTest::addColumn<sim::Vec2>("after");
    QTest::newRow("as published") << 0.0 << 0.0 << sim::Vec2{0, 0};
    QTest::newRow("bounce 1") << 1.0 << 0.0 << sim::Vec2{0, -8};
    QTest::newRow("bounce 0.25") << 0.25 << 0.0 << sim::Vec2{0, -2};
    QTest::newRow("ice") << 0.0 << 1.0 << sim::Vec2{3, 0};
    QTest::newRow("ice, bounce 0.5") << 0.5 << 1.0 << sim::Vec2{3, -4};
}

void WalkingGround::theGroundStopsAFootAndABounceTurnsItRound()
{
    QFETCH(double, bounce);
    QFETCH(double, traction);
    QFETCH(sim::Vec2, after);
    sim::Script script =
        scriptOf(step("ground"), "published", 1.0,
                 {{"bounce", bounce}, {"traction", traction}, {"k", 0.0}, {"gravity", 0.0}, {"damp", 1.0}});
    script.bodies = {{"foot0", {{220, 395}, sim::Vec2{3, 8}}}, {"foot1", {{320, 392}, sim::Vec2{3, 8}}}};
    const sim::State state = stateAfter(script, 1);
    QCOMPARE(state.positionOf(0), (sim::Vec2{223, 400}));
    QCOMPARE(state.velocityOf(0), after);
    QVERIFY(!std::signbit(state.velocityOf(0).x) && (after.y != 0.0 || !std::signbit(state.velocityOf(0).y)));
    QCOMPARE(state.positionOf(1), (sim::Vec2{323, 400})); // touches, and is not below
    QCOMPARE(state.velocityOf(1), (sim::Vec2{3, 8}));
}

void WalkingGround::onlyFeetMeetTheGround()
{
    sim::Script script = scriptOf(step("ground"), "published", 1.0, {{"k", 0.0}});
    const sim::State fallen = stateAfter(script, 200);
    QVERIFY(fallen.positionOf(0).y == 400.0 && fallen.positionOf(1).y == 400.0 &&
            fallen.positionOf(2).y > 600.0);
    script.input = {{5, sim::Grab{"foot0"}}, {5, sim::Move{{200, 450}}}};
    QCOMPARE(stateAfter(script, 50).positionOf(0), (sim::Vec2{200, 450}));
}

QTEST_GUILESS_MAIN(WalkingGround)
#include "tst_walking_ground.moc"
