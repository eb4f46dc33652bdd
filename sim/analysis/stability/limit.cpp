#include "sim/analysis/stability/limit.h"

#include <cmath>
#include <limits>

namespace sim {

namespace {

constexpr double shortest = 1e-5; ///< rad of the fastest swing
constexpr double usual = 0.01;    ///< rad: few limits are below
constexpr double longest = 30.0;  ///< rad: what has not grown by then will not
constexpr double exact = 1e-4;    ///< of the step
/// Growth that is none within rounding may be growth that shrinks with the step. So a little past a limit it must be
/// well above rounding.
constexpr double little = 1.2;
constexpr double wellAbove = 100.0;

}

double findLimit(const std::function<double(double h)> &growth, double fastest, double rounding, double fine)
{
    const auto holds = [&](double h) { return growth(h) <= rounding; };
    double held = usual / fastest, grown = 0.0;
    if (holds(held)) {
        const double end = longest / fastest;
        double h = held;
        while (grown == 0.0 && h < end) {
            h *= fine;
            (holds(h) ? held : grown) = h;
        }
        if (grown == 0.0)
            return std::numeric_limits<double>::infinity();
    } else {
        grown = held;
        do {
            held = grown / 4.0;
            if (held < shortest / fastest)
                return 0.0;
        } while (!holds(held) && (grown = held, true));
    }
    while (grown - held > exact * grown) {
        const double middle = std::sqrt(held * grown);
        (holds(middle) ? held : grown) = middle;
    }
    return growth(little * grown) > wellAbove * rounding ? held : 0.0;
}

}
