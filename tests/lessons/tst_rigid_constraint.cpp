#include "sim/run/script/script.h"
#include "tests/lessons/support/published_files.h"
#include "tests/lessons/support/support.h"

#include "sim/base/error.h"
#include "tests/suite.h"

#include <QTest>

#include <cmath>
#include <random>

using namespace support;

namespace {

struct FigurePosition
{
    double x = 0.0, y = 0.0;
};

/// The tutorial's function, transcribed from its text without any code of sim.
void constraint(FigurePosition &first, FigurePosition &second, double distance, double errorOnFirst)
{
    const double errorOnSecond = 1 - errorOnFirst;
    const double distX = first.x - second.x, distY = first.y - second.y;
    const double actual = std::sqrt(distX * distX + distY * distY);
    const double angle = -std::atan2(distX, distY);
    const double error = actual - distance;
    first.x += error * errorOnFirst * std::sin(angle);
    first.y -= error * errorOnFirst * std::cos(angle);
    second.x -= error * errorOnSecond * std::sin(angle);
    second.y += error * errorOnSecond * std::cos(angle);
}

/// Points and sticks, with the position of the pointer in each frame.
struct Figure
{
    std::vector<FigurePosition> positions;
    std::vector<sim::Stick> sticks;
    std::vector<sim::Vec2> pointer; ///< from frame 1 on
};

Figure randomFigure(int points, int sticks, std::mt19937 &random)
{
    const auto real = [&](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    };
    Figure figure;
    for (int i = 0; i < points; ++i)
        figure.positions.push_back(real(0, 1) < 0.1 ? FigurePosition{240, 165}
                                                    : FigurePosition{real(0, 540), real(0, 400)});
    std::uniform_int_distribution<int> point(0, points - 1);
    while (static_cast<int>(figure.sticks.size()) < sticks) {
        const int a = point(random), b = point(random);
        const double share = real(0, 1);
        if (a != b)
            figure.sticks.push_back({a, b, real(0, 200), share < 0.2 ? 0.0 : share > 0.8 ? 1.0 : share});
    }
    sim::Vec2 pointer = {240, 165};
    for (int frame = 1; frame <= 60; ++frame) {
        pointer = pointer + sim::Vec2{real(-20, 20), real(-20, 20)};
        figure.pointer.push_back(pointer);
    }
    return figure;
}

sim::Script figureScript(const Figure &figure, const lessons::Step &step)
{
    sim::Script script = step.script();
    script.values.points = static_cast<int>(figure.positions.size());
    script.values.sticks = figure.sticks;
    for (std::size_t i = 0; i < figure.positions.size(); ++i)
        script.bodies[figurePointName(i)] = {{figure.positions[i].x, figure.positions[i].y}, {}};
    for (std::size_t i = 0; i < figure.pointer.size(); ++i)
        script.input.push_back(
            {static_cast<std::int64_t>(i) + 1, sim::Pointer{figure.pointer[i], i % 2 == 0}});
    return script;
}

}

Q_DECLARE_METATYPE(Figure)

class RigidConstraint : public QObject
{
    Q_OBJECT

    const LoadedLesson m_lesson = loadLesson(QStringLiteral("rigid_constraint"));

    const lessons::Step &step(const char *id) const { return m_lesson.step(QString::fromUtf8(id)); }

private slots:
    void publishedTrajectories_data() { addPublishedRows(QStringLiteral("rigid_constraint")); }
    void publishedTrajectories() { checkPublished(m_lesson); }
    void matchesPrintedCode_data();
    void matchesPrintedCode();
    void errorIsSharedAsRequested_data();
    void errorIsSharedAsRequested();
    void errorShrinksByTheShareEachFrame_data();
    void errorShrinksByTheShareEachFrame();
    void coincidentPointsSeparate_data();
    void coincidentPointsSeparate();
    void freeEndTakesAllTheErrorOfAHeldEnd();
    void p0StaysAtItsStartWithoutAPointer();
    void sticksWithAMissingEndAreRejected_data();
    void sticksWithAMissingEndAreRejected();
};

void RigidConstraint::matchesPrintedCode_data()
{
    QTest::addColumn<QString>("id");
    QTest::addColumn<Figure>("figure");
    std::mt19937 random(7);
    const char *const ids[] = {"pair", "shared_error", "triangle", "list"};
    for (const auto &[points, sticks] :
         {std::pair{1, 0}, {2, 1}, {2, 5}, {3, 3}, {5, 9}, {12, 30}, {40, 60}, {300, 500}, {1000, 1500}}) {
        for (const char *id : ids)
            QTest::addRow("%s, %d points, %d sticks", id, points, sticks)
                << QString(QLatin1String(id)) << randomFigure(points, sticks, random);
    }
}

void RigidConstraint::matchesPrintedCode()
{
    QFETCH(QString, id);
    QFETCH(Figure, figure);
    sim::Track track(figureScript(figure, m_lesson.step(id)), 0);
    std::vector<FigurePosition> positions = figure.positions;
    for (std::size_t frame = 1; frame <= figure.pointer.size(); ++frame) {
        positions[0] = {figure.pointer[frame - 1].x, figure.pointer[frame - 1].y};
        for (const sim::Stick &stick : figure.sticks)
            constraint(positions[static_cast<std::size_t>(stick.a)],
                       positions[static_cast<std::size_t>(stick.b)], stick.length, stick.share);
        track.seek({static_cast<std::int64_t>(frame), 0});
        for (std::size_t i = 0; i < positions.size(); ++i) {
            const sim::Vec2 at = track.state().positionOf(static_cast<int>(i));
            QVERIFY(std::abs(at.x - positions[i].x) <= 1e-9 && std::abs(at.y - positions[i].y) <= 1e-9);
        }
    }
}

void RigidConstraint::errorIsSharedAsRequested_data()
{
    QTest::addColumn<QString>("method");
    QTest::addColumn<double>("share");
    for (const QString &method : {QStringLiteral("published"), QStringLiteral("semi_implicit_euler")}) {
        for (const double share : {0.0, 0.25, 0.5, 0.8, 1.0})
            QTest::addRow("%s, share %g", qPrintable(method), share) << method << share;
    }
}

/// The distance is 50 px (3-4-5 triangle) and shall be 100 px. So the error is -50 px along (0.6, 0.8).
void RigidConstraint::errorIsSharedAsRequested()
{
    QFETCH(QString, method);
    QFETCH(double, share);
    sim::Script script =
        support::scriptOf(step("shared_error"), method.toStdString(), 1.0, {{"share", share}});
    script.bodies = {{"p0", {{230, 240}, {}}}, {"p1", {{200, 200}, {}}}};
    const sim::State state = stateAfter(script, 1);
    const sim::Vec2 wanted0 = sim::Vec2{230, 240} + (50 * share) * sim::Vec2{0.6, 0.8};
    const sim::Vec2 wanted1 = sim::Vec2{200, 200} - (50 * (1 - share)) * sim::Vec2{0.6, 0.8};
    QVERIFY(sim::length(state.positionOf(0) - wanted0) <= 1e-12 &&
            sim::length(state.positionOf(1) - wanted1) <= 1e-12);
    if (share == 0.0)
        QCOMPARE(state.positionOf(0), (sim::Vec2{230, 240}));
    if (share == 1.0)
        QCOMPARE(state.positionOf(1), (sim::Vec2{200, 200}));
}

void RigidConstraint::errorShrinksByTheShareEachFrame_data()
{
    QTest::addColumn<double>("share");
    for (const double share : {0.0, 0.3, 0.5, 0.9, 1.0})
        QTest::addRow("share %g", share) << share;
}

/// The pointer stays 300 px from p1 and the stick is 100 px long. After n frames p0 is 200 share^n px from
/// the pointer.
void RigidConstraint::errorShrinksByTheShareEachFrame()
{
    QFETCH(double, share);
    sim::Script script = support::scriptOf(step("shared_error"), "published", 1.0, {{"share", share}});
    script.bodies = {{"p0", {{100, 100}, {}}}, {"p1", {{100, 300}, {}}}};
    script.input = {{1, sim::Pointer{{400, 300}, false}}};
    for (int frame = 1; frame <= 20; ++frame) {
        const double distance = sim::length(stateAfter(script, frame).positionOf(0) - sim::Vec2{400, 300});
        QVERIFY(std::abs(distance - 200 * std::pow(share, frame)) <= 1e-10);
    }
}

void RigidConstraint::coincidentPointsSeparate_data()
{
    QTest::addColumn<QString>("method");
    QTest::newRow("published") << "published";
    QTest::newRow("semi-implicit Euler") << "semi_implicit_euler";
}

void RigidConstraint::coincidentPointsSeparate()
{
    QFETCH(QString, method);
    const sim::State state = stateAfter(support::scriptOf(step("pair"), method.toStdString()), 1);
    QVERIFY(std::abs(sim::length(state.positionOf(0) - state.positionOf(1)) - 100.0) <= 1e-12);
    QVERIFY(sim::length(state.positionOf(0) + state.positionOf(1) - sim::Vec2{480, 330}) <= 1e-12);
    if (method == u"published") { // straight up and down
        QCOMPARE(state.positionOf(0), (sim::Vec2{240, 215}));
        QCOMPARE(state.positionOf(1), (sim::Vec2{240, 115}));
    }
}

void RigidConstraint::freeEndTakesAllTheErrorOfAHeldEnd()
{
    for (const char *held : {"p0", "p1"}) {
        sim::Script script = support::scriptOf(step("shared_error"), "published", 1.0, {{"share", 0.3}});
        script.input = {{1, sim::Grab{held}}, {1, sim::Move{{400, 300}}}};
        const sim::State state = stateAfter(script, 1);
        const int heldPoint = state.hold.point;
        QCOMPARE(state.positionOf(heldPoint), (sim::Vec2{400, 300}));
        QVERIFY(std::abs(sim::length(state.positionOf(1 - heldPoint) - state.positionOf(heldPoint)) -
                         100.0) <= 1e-12);
    }
}

void RigidConstraint::p0StaysAtItsStartWithoutAPointer()
{
    sim::Script script = step("pair").script();
    script.bodies = {{"p0", {{100, 100}, {}}}, {"p1", {{160, 180}, {}}}};
    QCOMPARE(stateAfter(script, 10).positionOf(0), (sim::Vec2{100, 100}));
}

void RigidConstraint::sticksWithAMissingEndAreRejected_data()
{
    QTest::addColumn<QString>("id");
    QTest::addColumn<int>("end");
    for (const lessons::Step &each : m_lesson.steps) {
        for (const int end : {-1, 2, 1000000})
            QTest::addRow("%s, end %d of 2 points", qPrintable(each.id), end) << each.id << end;
    }
}

void RigidConstraint::sticksWithAMissingEndAreRejected()
{
    QFETCH(QString, id);
    QFETCH(int, end);
    sim::Script script = m_lesson.step(id).script();
    script.values.points = 2;
    script.values.sticks = {{0, 1, 50, 0.5}, {1, end, 50, 0.5}};
    try {
        const sim::Track track(script, 0);
        QFAIL("no error was thrown");
    } catch (const sim::Error &error) {
        QCOMPARE(error.id(), std::string("stick-without-end"));
        const std::map<std::string, std::string> wanted = {
            {"stick", "1"}, {"end", std::to_string(end)}, {"points", "2"}};
        QVERIFY(error.values() == wanted);
    }
}

SUITE(tst_rigid_constraint, RigidConstraint)
#include "tst_rigid_constraint.moc"
