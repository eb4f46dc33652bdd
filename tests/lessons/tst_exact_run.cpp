// The exact run and the budgets that depend on it, on the lesson `accuracy`, against independent solutions.

#include "lessons/api/checks/budget.h"
#include "lessons/api/checks/exact_run.h"
#include "lessons/api/view/view.h"
#include "sim/methods/methods.h"
#include "sim/run/script/script.h"
#include "sim/run/track.h"
#include "tests/lessons/support/accuracy_truths.h"
#include "tests/lessons/support/support.h"
#include "tests/suite.h"

#include <QTest>

using namespace support;

namespace {

/// An independent solution for a creature of feet and, last, a body, without any code of sim. Springs of
/// length `radius` join the body to each foot. Integrated by Runge-Kutta 4 with tiny steps, with drag.
class ReferenceCreature
{
public:
    struct Numbers
    {
        double k = 0.2, damp = 0.97, radius = 50.0;
    };
    ReferenceCreature(const sim::State &start, Numbers numbers)
        : m_points(start.pointCount()), m_numbers(numbers)
    {
        for (int i = 0; i < m_points; ++i) {
            for (const double number :
                 {start.positionOf(i).x, start.positionOf(i).y, start.velocityOf(i).x, start.velocityOf(i).y})
                m_now.push_back(number);
        }
    }

    void run(int frames, int stepsPerFrame)
    {
        const double h = 1.0 / stepsPerFrame;
        for (int i = 0; i < frames * stepsPerFrame; ++i) {
            const std::vector<double> a = rates(m_now);
            const std::vector<double> b = rates(advanced(a, h / 2));
            const std::vector<double> c = rates(advanced(b, h / 2));
            const std::vector<double> d = rates(advanced(c, h));
            for (std::size_t j = 0; j < m_now.size(); ++j)
                m_now[j] += h / 6 * (a[j] + 2 * b[j] + 2 * c[j] + d[j]);
        }
    }

    double largestDistanceFrom(const sim::State &state) const
    {
        double largest = 0.0;
        for (int i = 0; i < m_points; ++i) {
            const auto first = static_cast<std::size_t>(4 * i);
            largest = std::max(largest, std::hypot(state.positionOf(i).x - m_now[first],
                                                   state.positionOf(i).y - m_now[first + 1]));
        }
        return largest;
    }

private:
    std::vector<double> advanced(const std::vector<double> &rate, double h) const
    {
        std::vector<double> next = m_now;
        for (std::size_t j = 0; j < next.size(); ++j)
            next[j] += h * rate[j];
        return next;
    }

    std::vector<double> rates(const std::vector<double> &at) const
    {
        std::vector<double> rate(at.size());
        const std::size_t body = at.size() - 4;
        for (std::size_t i = 0; i < at.size(); i += 4) {
            rate[i] = at[i + 2];
            rate[i + 1] = at[i + 3];
            rate[i + 2] += std::log(m_numbers.damp) * at[i + 2];
            rate[i + 3] += std::log(m_numbers.damp) * at[i + 3];
            if (i == body)
                break;
            const double dx = at[i] - at[body], dy = at[i + 1] - at[body + 1];
            const double distance = std::hypot(dx, dy);
            const double tension = m_numbers.k * (distance - m_numbers.radius) / distance;
            rate[i + 2] -= tension * dx;
            rate[i + 3] -= tension * dy;
            rate[body + 2] += tension * dx;
            rate[body + 3] += tension * dy;
        }
        return rate;
    }

    int m_points;
    Numbers m_numbers;
    std::vector<double> m_now; ///< x, y and velocity of each point
};

}

class ExactRun : public QObject
{
    Q_OBJECT

    const LoadedLesson m_lesson = loadLesson(QStringLiteral("accuracy"));
    lessons::ExactRun m_exact;

    const lessons::Step &step(const char *id) const { return m_lesson.step(QString::fromUtf8(id)); }

    /// Returns the largest distance from the exact run over frames 1 to `frames`, in px.
    double worstError(const sim::Script &script, std::int64_t frames)
    {
        sim::Track track(script, 0);
        double largest = 0.0;
        for (std::int64_t frame = 1; frame <= frames; ++frame) {
            track.seek({frame, 0});
            largest = std::max(largest, m_exact.distance(script, track.state(), frame));
        }
        return largest;
    }

private slots:
    void exactRunOfASpringIsACosine();
    void exactRunFollowsChangedParameters();
    void exactRunOfACreatureMatchesIndependentSolution_data();
    void exactRunOfACreatureMatchesIndependentSolution();
    void exactRunOfABallConsistsOfParabolas_data();
    void exactRunOfABallConsistsOfParabolas();
    void noExactRunBeyondItsFrameLimit();
    void expensiveExactRunIsAborted();
    void onlySuitableMethodsKeepTheBudget_data();
    void onlySuitableMethodsKeepTheBudget();
    void budgetMeasuresTheTimeOfTheRun();
    void measuredTimeIsPositive();
    void overlaysShowTheExactPosition();
};

void ExactRun::exactRunOfASpringIsACosine()
{
    for (const auto &[id, amplitude, k] :
         {std::tuple{"big_step", 130.0, 0.2}, std::tuple{"energy", 100.0, 0.02}}) {
        const sim::Script script = step(id).script();
        for (int frame : {0, 1, 17, 100, 600}) {
            const sim::State *state = m_exact.at(script, frame);
            QVERIFY(state);
            QVERIFY(std::abs(state->positionOf(0).x - 270.0 - springDisplacement(amplitude, k, frame)) <
                    1e-7);
            QCOMPARE(state->positionOf(0).y, 200.0);
        }
    }
}

void ExactRun::exactRunFollowsChangedParameters()
{
    sim::Script script = step("big_step").script();
    script.input = {{31, sim::Set{"k", 0.05}}};
    const double w = std::sqrt(0.2), wAfter = std::sqrt(0.05);
    const double x = 130.0 * std::cos(30 * w), v = -130.0 * w * std::sin(30 * w);
    const double expected = x * std::cos(25 * wAfter) + v / wAfter * std::sin(25 * wAfter);
    QVERIFY(std::abs(m_exact.at(script, 55)->positionOf(0).x - 270.0 - expected) < 1e-7);
    script.input.clear();
    QVERIFY(std::abs(m_exact.at(script, 55)->positionOf(0).x - 270.0 - springDisplacement(130.0, 0.2, 55)) <
            1e-7);
}

void ExactRun::exactRunOfACreatureMatchesIndependentSolution_data()
{
    QTest::addColumn<QString>("id");
    QTest::addColumn<double>("k");
    QTest::addColumn<int>("frames");
    QTest::newRow("halve") << "halve" << 0.2 << 60;
    QTest::newRow("budget") << "budget" << 0.1 << 200;
}

void ExactRun::exactRunOfACreatureMatchesIndependentSolution()
{
    QFETCH(QString, id);
    QFETCH(double, k);
    QFETCH(int, frames);
    const sim::Script script = m_lesson.step(id).script();
    ReferenceCreature creature(script.build(script.values).start, {.k = k});
    creature.run(frames, 400);
    QVERIFY(creature.largestDistanceFrom(*m_exact.at(script, frames)) < 1e-6);
}

void ExactRun::exactRunOfABallConsistsOfParabolas_data()
{
    QTest::addColumn<double>("bounce");
    for (double bounce : {1.0, 0.8, 0.5})
        QTest::addRow("bounce %g", bounce) << bounce;
}

void ExactRun::exactRunOfABallConsistsOfParabolas()
{
    QFETCH(double, bounce);
    const sim::Script script = scriptOf(step("bounce"), "rk4", 1.0, {{"bounce", bounce}});
    for (int frame = 0; frame <= 270; ++frame) { // the ball reaches the wall after frame 278
        const sim::State *state = m_exact.at(script, frame);
        QVERIFY(state);
        QVERIFY(std::abs(state->positionOf(0).x - 60.0 - 1.6 * frame) < 1e-8);
        const double height = bouncingHeight(235.0, 0.5, bounce, frame);
        QVERIFY2(std::abs(365.0 - state->positionOf(0).y - height) < (bounce < 0.6 ? 1e-3 : 1e-7),
                 qPrintable(QString::number(frame)));
    }
}

void ExactRun::noExactRunBeyondItsFrameLimit()
{
    const sim::Script script = step("big_step").script();
    QVERIFY(m_exact.at(script, lessons::ExactRun::maxFrames));
    QVERIFY(!m_exact.at(script, lessons::ExactRun::maxFrames + 1));
    QVERIFY(!m_exact.at(script, -1));
}

void ExactRun::expensiveExactRunIsAborted()
{
    const sim::Script script = scriptOf(step("big_step"), "rk4", 1.0, {{"k", 1e6}});
    QVERIFY(m_exact.at(script, 1));
    QVERIFY(!m_exact.at(script, 1000));
    QVERIFY(m_exact.at(script, 1));
}

void ExactRun::onlySuitableMethodsKeepTheBudget_data()
{
    QTest::addColumn<QString>("method");
    QTest::addColumn<double>("h");
    QTest::addColumn<bool>("isWithin");
    QTest::newRow("the setup of the step") << "semi_implicit_euler" << 1.0 << false;
    QTest::newRow("semi-implicit, 1/8") << "semi_implicit_euler" << 0.125 << false;
    QTest::newRow("semi-implicit, 1/16") << "semi_implicit_euler" << 0.0625 << true;
    QTest::newRow("Verlet, 1") << "velocity_verlet" << 1.0 << false;
    QTest::newRow("Verlet, 1/2") << "velocity_verlet" << 0.5 << true;
    QTest::newRow("midpoint, 1/4") << "midpoint" << 0.25 << false;
    QTest::newRow("Runge-Kutta 4, 1") << "rk4" << 1.0 << true;
}

void ExactRun::onlySuitableMethodsKeepTheBudget()
{
    QFETCH(QString, method);
    QFETCH(double, h);
    QFETCH(bool, isWithin);
    const sim::Script script = scriptOf(step("budget"), method.toStdString(), h);
    QCOMPARE(worstError(script, 200) <= 1.0, isWithin);
    const auto free = [](const sim::Script &, std::int64_t) { return 0.0; };
    QCOMPARE(lessons::staysWithin(*step("budget").tries[1].budget, script, free), isWithin);
    if (h == 1.0 && method == u"semi_implicit_euler") {
        QVERIFY(step("budget").narration.contains(u"15 px off"_qs));
        QCOMPARE(std::round(worstError(script, 200)), 15.0);
    }
}

void ExactRun::budgetMeasuresTheTimeOfTheRun()
{
    const lessons::Budget budget = *step("budget").tries[1].budget;
    QCOMPARE(budget.error, 1.0);
    QCOMPARE(budget.nsPerFrame, 500.0);
    const sim::Script script = scriptOf(step("budget"), "velocity_verlet", 0.5);
    int calls = 0;
    const auto timingOf = [&](double ns) {
        return [&calls, ns](const sim::Script &timed, std::int64_t frames) {
            ++calls;
            return timed.method->id() == "velocity_verlet" && timed.step.h == 0.5 && frames == 200 ? ns : 1e9;
        };
    };
    QVERIFY(lessons::staysWithin(budget, script, timingOf(499.0)));
    QVERIFY(!lessons::staysWithin(budget, script, timingOf(501.0)));
    QCOMPARE(calls, 2);
    // This run is too inaccurate, so it is not timed.
    QVERIFY(!lessons::staysWithin(budget, step("budget").script(), timingOf(1.0)));
    QCOMPARE(calls, 2);
}

void ExactRun::measuredTimeIsPositive()
{
    const double ns = lessons::measureTime(step("budget").script(), 200);
    QVERIFY(std::isfinite(ns) && ns > 0.0);
}

void ExactRun::overlaysShowTheExactPosition()
{
    const sim::Script script = step("big_step").script();
    const sim::State state = stateAfter(script, 100);
    const std::vector<lessons::Overlay> overlays = step("big_step").runOverlays(script, state, 100);
    QCOMPARE(overlays.size(), std::size_t{2});
    QCOMPARE(overlays[0].shape, lessons::Overlay::Shape::ring);
    QVERIFY(std::abs(overlays[0].a.x - 270.0 - springDisplacement(130.0, 0.2, 100)) < 1e-7);
    QCOMPARE(overlays[1].a, state.positionOf(0));
    QCOMPARE(overlays[1].b, overlays[0].a);
    QVERIFY(overlays[0].label.startsWith(u"66."));
}

SUITE(tst_exact_run, ExactRun)
#include "tst_exact_run.moc"
