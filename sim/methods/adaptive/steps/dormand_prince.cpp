#include "sim/methods/adaptive/steps/dormand_prince.h"

#include "sim/methods/adaptive/steps/embedded_runge_kutta.h"
#include "sim/methods/adaptive/steps/hermite.h"

#include <cmath>

namespace sim {

namespace {

Tableau fifthOrder()
{
    Tableau t;
    //! [dormand_prince_tableau]
    t.stages = 7;
    t.c = {0, 1. / 5, 3. / 10, 4. / 5, 8. / 9, 1, 1};
    t.a[1] = {1. / 5};
    t.a[2] = {3. / 40, 9. / 40};
    t.a[3] = {44. / 45, -56. / 15, 32. / 9};
    t.a[4] = {19372. / 6561, -25360. / 2187, 64448. / 6561, -212. / 729};
    t.a[5] = {9017. / 3168, -355. / 33, 46732. / 5247, 49. / 176, -5103. / 18656};
    t.a[6] = {35. / 384, 0, 500. / 1113, 125. / 192, -2187. / 6784, 11. / 84};
    t.b = t.a[6];
    //! [dormand_prince_tableau]
    return t;
}

/// The weights of order 5 minus those of order 4.
constexpr Tableau::Row differenceToOrder4 = {71. / 57600,      0,         -71. / 16695, 71. / 1920,
                                             -17253. / 339200, 22. / 525, -1. / 40};
constexpr Tableau::Row noWeights{};

/// The pair with its dense output: the polynomial of degree 5 through positions, velocities and accelerations
/// at both ends of the step.
class DormandPrincePair : public EmbeddedPair
{
public:
    const Tableau &tableau() const override { return m_tableau; }
    int order() const override { return 5; }
    const Tableau::Row &error() const override { return differenceToOrder4; }
    const Tableau::Row &lowerError() const override { return noWeights; }
    bool hasLowerError() const override { return false; }
    int extraStages() const override { return 0; }
    int denseColumns() const override { return 6; }

    void makeDense(const StepData &step, const double *endX, const double *endV,
                   double *columns) const override
    {
        const double h = step.h;
        const double *endAccelerations = step.accelerations + 6 * step.size;
        for (int i = step.first; i < step.end; ++i) {
            const double x0 = step.x[i], x1 = endX[i];
            const double v0 = h * step.v[i], v1 = h * endV[i];
            const double a0 = h * h * (step.accelerations[i] - step.rate * step.v[i]);
            const double a1 = h * h * (endAccelerations[i] - step.rate * endV[i]);
            const Quintic quintic = Quintic::through(x0, v0, a0, x1, v1, a1);
            for (int j = 0; j < 6; ++j)
                columns[j * step.size + i] = quintic.c[j];
        }
    }

    void dense(const double *columns, int size, int first, int end, const DenseTime &time, double *x,
               double *v) const override
    {
        for (int i = first; i < end; ++i) {
            const NewtonPolynomial output = NewtonPolynomial::at<6>(columns + i, size, time.theta);
            x[i - first] = output.value;
            v[i - first] = output.derivative / time.h;
        }
    }

private:
    Tableau m_tableau = fifthOrder();
};

}

const EmbeddedPair &dormandPrincePair()
{
    static const DormandPrincePair pair;
    return pair;
}

namespace {

const StepRule &rule()
{
    static const EmbeddedRungeKutta instance(dormandPrincePair());
    return instance;
}

}

DormandPrince::DormandPrince()
    : Adaptive(rule(), {{"sim/methods/adaptive/steps/embedded_runge_kutta.cpp", "embedded_step"},
                        {"sim/methods/adaptive/steps/dormand_prince.cpp", "dormand_prince_tableau"}})
{
}

}
