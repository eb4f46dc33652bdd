// Boost's odeint in the race of creature_in_air.h: its controlled steppers, with dense output where
// available.

#include "tests/bench/peers/creature_in_air.h"

#include <boost/numeric/odeint.hpp>

#include <cmath>
#include <numeric>

namespace {

namespace odeint = boost::numeric::odeint;
using namespace bench::air;

const double c = -std::log(damp);

struct System
{
    void operator()(const Row<double> &now, Row<double> &change, double) const { rates(now, change, c); }
};

const std::array<double, frames + 1> &times()
{
    static const auto all = [] {
        std::array<double, frames + 1> whole;
        std::iota(whole.begin(), whole.end(), 0.0);
        return whole;
    }();
    return all;
}

/// A solver that runs any stepper of odeint over all frames.
template <class MakeStepper>
class WithStepper : public Solver
{
public:
    WithStepper(MakeStepper make, double tolerance) : m_make(make), m_tolerance(tolerance) {}

    void run(MeasureSeries &series) override
    {
        Row<double> now = start();
        std::size_t frame = 0;
        const auto write = [&](const Row<double> &row, double) {
            std::copy_n(row.begin(), series[frame].size(), series[frame].begin());
            ++frame;
        };
        // integrate_times, because integrate_const starts every frame with the same step size. The first step
        // size is corrected quickly.
        odeint::integrate_times(m_make(m_tolerance), System{}, now, times().begin(), times().end(), 0.1,
                                write);
    }

private:
    MakeStepper m_make;
    double m_tolerance;
};

template <class MakeStepper>
int enterStepper(const char *name, MakeStepper make)
{
    return enter({"odeint", name, tolerancesDownTo(1e-13), [make](double tolerance) {
                      return std::make_unique<WithStepper<MakeStepper>>(make, tolerance);
                  }});
}

using State = Row<double>;
const int entered[] = {
    enterStepper("dopri5, dense output",
                 [](double tolerance) {
                     return odeint::make_dense_output(tolerance, 0.0, odeint::runge_kutta_dopri5<State>());
                 }),
    enterStepper("dopri5",
                 [](double tolerance) {
                     return odeint::make_controlled(tolerance, 0.0, odeint::runge_kutta_dopri5<State>());
                 }),
    enterStepper("cash_karp54",
                 [](double tolerance) {
                     return odeint::make_controlled(tolerance, 0.0, odeint::runge_kutta_cash_karp54<State>());
                 }),
    enterStepper("fehlberg78",
                 [](double tolerance) {
                     return odeint::make_controlled(tolerance, 0.0, odeint::runge_kutta_fehlberg78<State>());
                 }),
    enterStepper("bulirsch_stoer",
                 [](double tolerance) { return odeint::bulirsch_stoer<State>(tolerance, 0.0, 0.0, 0.0); }),
};

}
