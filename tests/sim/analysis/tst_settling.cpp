// When a run comes to rest, against the closed form of one damped spring.

#include "sim/analysis/settling/settling.h"
#include "sim/methods/methods.h"
#include "sim/scenes/points.h"
#include "tests/suite.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <complex>

using namespace sim;

namespace {

using Kind = Settling::Kind;

constexpr Vec2 settlingCentre{270.0, 200.0};
constexpr double settlingAway = 100.0; ///< px from the centre at the start

bool goesOn()
{
    return true;
}

Script oscillatorScript(double k, double damp, const char *method = "published", double h = 1.0)
{
    Script script;
    script.build = [](const Values &values) {
        return scenes::oscillator({settlingCentre.x + settlingAway, settlingCentre.y}, settlingCentre,
                                  values["k"], values["damp"]);
    };
    script.values.set("k", k);
    script.values.set("damp", damp);
    script.method = findMethod(method);
    script.step = StepSize::ofLength(h);
    return script;
}

/// One frame of the published method takes (x, v) to (x + v', v') with v' = damp (v - k x). Its eigenvalues a and b solve
/// z^2 - (1 + damp - damp k) z + damp = 0, and x(n) = A a^n + B b^n.
class ClosedForm
{
public:
    ClosedForm(double k, double damp)
    {
        const double trace = 1.0 + damp - damp * k;
        const std::complex<double> root = std::sqrt(std::complex<double>(trace * trace - 4.0 * damp));
        m_a = 0.5 * (trace + root);
        m_b = 0.5 * (trace - root);
        const double next = (1.0 - damp * k) * settlingAway;
        m_first = (next - m_b * settlingAway) / (m_a - m_b);
    }
    double at(int frame) const
    {
        return (m_first * std::pow(m_a, frame) + (settlingAway - m_first) * std::pow(m_b, frame)).real();
    }
    /// Returns the factor by which the motion shrinks in a frame, in the end.
    double largest() const { return std::max(std::abs(m_a), std::abs(m_b)); }

private:
    std::complex<double> m_a, m_b, m_first;
};

Settling expectedSettling(double k, double damp)
{
    const ClosedForm run(k, damp);
    if (run.largest() > 1.0 + 1e-9)
        return {Kind::grows};
    const int end = 2 * Settling::mostFrames;
    int rest = end;
    while (rest > 0 && std::abs(run.at(rest - 1) - run.at(end)) <= Settling::nearRest &&
           std::abs(run.at(rest) - run.at(rest - 1)) < Settling::slowest)
        --rest;
    return rest > Settling::mostFrames ? Settling{Kind::moves} : Settling{Kind::settles, rest};
}

QByteArray named(const std::optional<Settling> &settling)
{
    return settling ? QByteArray::number(static_cast<int>(settling->kind)) + " after " +
                          QByteArray::number(static_cast<qlonglong>(settling->frames))
                    : "nothing";
}

}

class SettlingTest : public QObject
{
    Q_OBJECT

private slots:
    void springSettlesWhenItsEigenvaluesPredict_data();
    void springSettlesWhenItsEigenvaluesPredict();
    void settlingTimeAgreesWithTheDecayOfTheSwing();
    void framesCountFromTheLastInput();
    void changesOfTheMappedParametersAndLateInputAreRemoved();
    void settlingTimeWithLongStepsIsInFrames();
    void mapAgreesWithSingleRunsAndIsRefined();
    void mapCanBeCancelled();
};

void SettlingTest::springSettlesWhenItsEigenvaluesPredict_data()
{
    QTest::addColumn<double>("k");
    QTest::addColumn<double>("damp");
    QTest::addColumn<int>("kind");
    const auto row = [](const char *what, double k, double damp, Kind kind) {
        QTest::addRow("%s: k %g, damp %g", what, k, damp) << k << damp << static_cast<int>(kind);
    };
    row("of the lesson", 0.2, 0.9, Kind::settles);
    row("swings a few times", 0.2, 0.7, Kind::settles);
    row("nearly critical", 0.2, 0.46, Kind::settles);
    row("creeps", 0.2, 0.3, Kind::settles);
    row("creeps long", 0.05, 0.1, Kind::moves);
    row("creeps for ages", 0.01, 0.04, Kind::moves);
    row("swings long", 0.2, 0.97, Kind::settles);
    row("swings too long", 0.2, 0.99, Kind::moves);
    row("undamped", 0.2, 1.0, Kind::moves);
    row("stiff", 3.0, 0.8, Kind::settles);
    row("flips each frame", 3.9, 0.9, Kind::settles);
    row("past the limit", 4.3, 0.9, Kind::grows);
    row("far past the limit", 9.0, 0.9, Kind::grows);
    row("undamped past the limit", 4.1, 1.0, Kind::grows);
    row("without a spring", 0.0, 0.9, Kind::settles);
}

void SettlingTest::springSettlesWhenItsEigenvaluesPredict()
{
    QFETCH(double, k);
    QFETCH(double, damp);
    QFETCH(int, kind);
    const Settling expected = expectedSettling(k, damp);
    QCOMPARE(static_cast<int>(expected.kind), kind);
    const std::optional<Settling> found = settlingOf(oscillatorScript(k, damp), goesOn);
    QVERIFY2(found == expected, named(found) + ", not " + named(expected));
}

/// The swing shrinks by sqrt(damp) a frame. It moves slower than 0.05 px in each frame after about n frames:
/// 100 px sqrt(k) damp^(n/2) = 0.05 px.
void SettlingTest::settlingTimeAgreesWithTheDecayOfTheSwing()
{
    const double k = 0.2, damp = 0.9;
    const double frames = 2.0 * std::log(Settling::slowest / (settlingAway * std::sqrt(k))) / std::log(damp);
    const std::optional<Settling> found = settlingOf(oscillatorScript(k, damp), goesOn);
    QVERIFY(found &&
            std::abs(static_cast<double>(found->frames) - frames) < 8.0); // half a swing takes 7 frames
}

void SettlingTest::framesCountFromTheLastInput()
{
    // Carried back to where it began, and let go there at rest: the same run again, 40 frames later.
    Script script = oscillatorScript(0.2, 0.8);
    const std::int64_t alone = settlingOf(script, goesOn)->frames;
    const Vec2 start{settlingCentre.x + settlingAway, settlingCentre.y};
    script.input = {{10, Grab{"foot"}}, {11, Move{start}}, {39, Move{start}}, {40, Release{}}};
    QCOMPARE(lastInputFrame(script), std::int64_t(40));
    const std::optional<Settling> found = settlingOf(script, goesOn);
    QVERIFY(found && found->kind == Kind::settles);
    QVERIFY2(std::abs(found->frames - alone) <= 1, named(found));
}

void SettlingTest::changesOfTheMappedParametersAndLateInputAreRemoved()
{
    Script script = oscillatorScript(0.2, 0.8);
    script.input = {{5, Set{"k", 9.0}}, {6, Set{"bounce", 0.5}}, {7, Set{"damp", 1.0}}, {900, Release{}}};
    const Script asked = settlingScript(script, "k", "damp", 600);
    QCOMPARE(asked.input.size(), std::size_t(1));
    QCOMPARE(std::get<Set>(asked.input.front().what).parameter, "bounce");
}

void SettlingTest::settlingTimeWithLongStepsIsInFrames()
{
    // Soft, so that steps of two frames come near to those of half a frame.
    const auto framesWith = [](double h) {
        return settlingOf(oscillatorScript(0.01, 0.9, "semi_implicit_euler", h), goesOn)->frames;
    };
    QCOMPARE(framesWith(2.0) % 2, std::int64_t(0));
    QVERIFY2(std::abs(framesWith(2.0) - framesWith(0.5)) < 35,
             QByteArray::number(qlonglong(framesWith(2.0))));
}

void SettlingTest::mapAgreesWithSingleRunsAndIsRefined()
{
    std::vector<std::size_t> known; // when each grid was complete
    std::size_t calls = 0, stride = 0;
    const auto progress = [&](const SettlingMap &soFar) {
        ++calls;
        if (soFar.stride != stride) {
            stride = soFar.stride;
            known.push_back(calls - 1);
        }
        // After the coarsest grid, every cell has a neighbour that is known.
        return soFar.stride == 0 || soFar.nearestKnown(8, 4).has_value();
    };
    const SettlingMap map = settlingMap(oscillatorScript(0.2, 0.9), MapAxis::byRatio("k", 0.02, 8.0, 9),
                                        MapAxis::evenly("damp", 0.1, 0.9, 5), progress, goesOn);
    QCOMPARE(map.stride, std::size_t(1));
    QCOMPARE(calls, std::size_t(9 * 5));
    QVERIFY((known == std::vector<std::size_t>{2, 6, 15})); // grids of 8, 4 and 2 cells
    for (std::size_t row = 0; row < 5; ++row) {
        for (std::size_t column = 0; column < 9; ++column) {
            const std::optional<Settling> &found = map.cells[map.indexOf(column, row)];
            const Settling expected = expectedSettling(map.x.values[column], map.y.values[row]);
            QVERIFY2(found == expected, named(found) + ", not " + named(expected));
        }
    }
}

void SettlingTest::mapCanBeCancelled()
{
    int calls = 0;
    const SettlingMap map = settlingMap(
        oscillatorScript(0.2, 0.9), MapAxis::byRatio("k", 0.02, 8.0, 9), MapAxis::evenly("damp", 0.1, 0.9, 5),
        [&](const SettlingMap &) { return ++calls < 5; }, goesOn);
    QCOMPARE(calls, 5);
    QCOMPARE(
        std::count_if(map.cells.begin(), map.cells.end(), [](const auto &one) { return one.has_value(); }),
        std::ptrdiff_t(5));
    QVERIFY(!settlingOf(oscillatorScript(0.2, 0.9), [] { return false; }));
}

SUITE(tst_settling, SettlingTest)
#include "tst_settling.moc"
