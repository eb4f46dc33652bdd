#include "sim/methods/adaptive/steps/nystrom.h"

#include "sim/methods/adaptive/steps/hermite.h"
#include "sim/simd/dispatch.h"

#include <algorithm>
#include <cmath>

namespace sim {

namespace {

NystromTableau nystromOfOrderEight()
{
    NystromTableau t;
    //! [nystrom_tableau]
    t.c = {0, 1. / 20, 1. / 10, 3. / 10, 1. / 2, 7. / 10, 9. / 10, 1, 1};
    t.a[1] = {1. / 800};
    t.a[2] = {1. / 600, 1. / 300};
    t.a[3] = {9. / 200, -9. / 100, 9. / 100};
    t.a[4] = {-66701. / 197352, 28325. / 32892, -2665. / 5482, 2170. / 24669};
    t.a[5] = {227015747. / 304251000, -54897451. / 30425100, 12942349. / 10141700, -9499. / 304251,
              539. / 9250};
    t.a[6] = {-1131891597. / 901789000, 41964921. / 12882700, -6663147. / 3220675,
              270954. / 644135,         -108. / 5875,         114. / 1645};
    t.a[7] = {13836959. / 3667458,   -17731450. / 1833729, 1063919505. / 156478208,
              -33213845. / 39119552, 13335. / 28544,       -705. / 14272,
              1645. / 57088};
    t.a[8] = {223. / 7938, 0, 1175. / 8064, 925. / 6048, 41. / 448, 925. / 14112, 1175. / 72576};
    t.b = {223. / 7938,   0,          5875. / 36288, 4625. / 21168, 41. / 224, 4625. / 21168,
           5875. / 36288, 223. / 7938};
    //! [nystrom_tableau]
    t.lowerPosition = {7987313. / 109941300, 0,
                       1610737. / 44674560,  10023263. / 33505920,
                       -497221. / 12409600,  10023263. / 78180480,
                       1610737. / 402071040};
    t.lowerVelocity = {7987313. / 109941300,
                       0,
                       1610737. / 40207104,
                       10023263. / 23454144,
                       -497221. / 6204800,
                       10023263. / 23454144,
                       1610737. / 40207104,
                       -4251941. / 54970650,
                       3. / 20};
    return t;
}

/// Returns the time t (frames) that belongs to s, for a damping rate c.
double timeOf(double s, double c)
{
    return c == 0.0 ? s : -std::log1p(-c * s) / c;
}

/// Returns e^(2 c t) at that time.
double growth(double s, double c)
{
    const double keep = 1.0 - c * s;
    return 1.0 / (keep * keep);
}

/// Returns the time (frames after the last whole frame) that belongs to s in `step`. Without continuous
/// drivers the time does not matter, and the start of the step is returned.
double momentOf(const StepAttempt &step, double s)
{
    return step.system.hasContinuousDrivers() ? step.start + timeOf(s, step.nystrom->rate) : step.start;
}

/// Returns the accelerations of the first stage; those of the others follow.
double *stagesOf(const StepAttempt &step)
{
    return step.scratch + 2 * step.system.size();
}

}

void NystromWeights::set(const NystromTableau &coefficients, double c, double step)
{
    if (c == rate && step == h)
        return;
    rate = c;
    h = step;
    whole = c == 0.0 ? h : -std::expm1(-c * h) / c;
    const double kept = 1.0 - c * whole;
    velocity[0] = kept;
    for (std::size_t j = 0; j < stages; ++j) {
        const double s = coefficients.c[j] * whole, factor = growth(s, c);
        position[j][0] = s;
        for (std::size_t i = j + 1; i < stages; ++i)
            position[i][j + 1] = whole * whole * coefficients.a[i][j] * factor;
        velocity[j + 1] = kept * whole * coefficients.b[j] * factor;
        positionError[j] =
            whole * whole * (coefficients.a[stages - 1][j] - coefficients.lowerPosition[j]) * factor;
        velocityError[j] = kept * whole * (coefficients.b[j] - coefficients.lowerVelocity[j]) * factor;
    }
}

RungeKuttaNystrom::RungeKuttaNystrom() : m_tableau(nystromOfOrderEight()) {}

// Shown lines are short.
// clang-format off
//! [nystrom_step]
double RungeKuttaNystrom::attempt(
    const StepAttempt &step) const
{
    int n = step.system.size();
    NystromWeights &w = *step.nystrom;
    w.set(m_tableau,
          *step.system.uniformRate(), step.h);
    double *v = step.scratch + n;
    double *a = stagesOf(step);
    std::copy_n(step.v, n, v);
    std::copy_n(step.a, n, a);
    double *x = step.endX;
    for (int i = 1; i < w.stages; ++i) {
        // the velocity, and the
        // accelerations so far
        auto row = std::size_t(i);
        blendRows(x, step.x, 1,
            v, w.position[row].data(),
            i + 1, 0, n, n);
        double s = w.position[row][0];
        step.accelerations.at(x, nullptr,
            momentOf(step, s), a + i * n);
    }
    blendRows(step.endV,
        step.v, w.velocity[0],
        a, w.velocity.data() + 1,
        w.stages, 0, n, n);
    int last = w.stages - 1;
    std::copy_n(a + last * n, n,
                step.endA);
    //! [nystrom_step]
    double *difference = step.scratch;
    blendRows(difference, a, 0.0, a, w.positionError.data(), w.stages, 0, n, n);
    const double positionError = maxAbs(difference, n);
    blendRows(difference, a, 0.0, a, w.velocityError.data(), w.stages, 0, n, n);
    return std::max(positionError, maxAbs(difference, n));
}
// clang-format on

void RungeKuttaNystrom::makeDense(const StepAttempt &step) const
{
    const int n = step.system.size();
    const NystromWeights &w = *step.nystrom;
    const double square = w.whole * w.whole;
    const double kept = 1.0 - w.rate * w.whole, factor = growth(w.whole, w.rate);
    const double *a = stagesOf(step), *end = a + (w.stages - 1) * n;
    double *middle = step.scratch;
    for (int i = 0; i < n; ++i) {
        const Quintic q = Quintic::through(step.x[i], w.whole * step.v[i], square * a[i], step.endX[i],
                                           w.whole * step.endV[i] / kept, square * factor * end[i]);
        for (int j = 0; j < 6; ++j)
            step.columns[j * n + i] = q.c[j];
        middle[i] = q.c[0] + q.c[1] / 2 + q.c[2] / 4 + q.c[3] / 8 - q.c[4] / 16 + q.c[5] / 32;
    }
    // The acceleration in the middle of the step raises the degree of the polynomial to 6.
    double *middleAcceleration = step.scratch + (2 + w.stages) * n;
    step.accelerations.at(middle, nullptr, momentOf(step, 0.5 * w.whole), middleAcceleration);
    const double middleFactor = square * growth(0.5 * w.whole, w.rate);
    for (int i = 0; i < n; ++i)
        step.columns[6 * n + i] =
            NewtonPolynomial::seventh(step.columns + i, n, middleFactor * middleAcceleration[i]);
}

DenseTime RungeKuttaNystrom::instant(double rate, double h, double theta) const
{
    if (rate == 0.0 || std::isinf(rate)) // infinite: the points stand still
        return {h, theta, 1.0, h, theta};
    const double atEnd = std::expm1(-rate * h), atTheta = std::expm1(-rate * h * theta);
    return {h, theta, 1.0 + atTheta, -atEnd / rate, atTheta / atEnd};
}

void RungeKuttaNystrom::dense(const double *columns, int size, int first, int end, const DenseTime &time,
                              double *x, double *v) const
{
    dispatch([=] {
        SIM_INDEPENDENT_ITERATIONS
        for (int i = 0; i < end - first; ++i) {
            const NewtonPolynomial output = NewtonPolynomial::at<7>(columns + first + i, size, time.share);
            x[i] = output.value;
            v[i] = time.kept * output.derivative / time.whole;
        }
    });
}

namespace {

const StepRule &nystromRule()
{
    static const RungeKuttaNystrom instance;
    return instance;
}

}

Nystrom::Nystrom()
    : Adaptive(nystromRule(), {{"sim/methods/adaptive/steps/nystrom.cpp", "nystrom_step"},
                               {"sim/methods/adaptive/steps/nystrom.cpp", "nystrom_tableau"}})
{
}

}
