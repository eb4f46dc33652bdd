#include "sim/analysis/accuracy/study_run.h"

#include <limits>

namespace sim {

RunEnd endOf(const Stop &stop)
{
    return stop.reason == StopReason::tooManySteps ? RunEnd::tooLong : RunEnd::notFinite;
}

Script scriptFor(const Script &script, const MethodSetup &setup)
{
    Script other = script;
    other.method = setup.method;
    other.step = setup.step;
    return other;
}

std::optional<Error> composeError(const Script &script)
{
    try {
        Track::check(script);
    } catch (const Error &error) {
        return error;
    }
    return {};
}

std::vector<Vec2> placesOf(const State &state)
{
    std::vector<Vec2> places;
    places.reserve(static_cast<std::size_t>(state.pointCount()));
    for (int i = 0; i < state.pointCount(); ++i)
        places.push_back(state.positionOf(i));
    return places;
}

double distanceFrom(const std::vector<Vec2> &places, const State &state)
{
    double largest = 0.0;
    for (int i = 0; i < state.pointCount(); ++i) {
        const double distance = length(state.positionOf(i) - places[static_cast<std::size_t>(i)]);
        if (!std::isfinite(distance))
            return std::numeric_limits<double>::quiet_NaN();
        largest = std::max(largest, distance);
    }
    return largest;
}

}
