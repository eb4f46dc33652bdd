#include "sim/methods/adaptive/advance.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace sim {

namespace {

constexpr double touching = 1e-10; ///< px, closer counts as in touch
constexpr double none = 2.0;       ///< past the end of the step

}

void Advance::end(double start, double h)
{
    const double touchAt = firstTouch(h);
    const double liftAt = firstLift(start, h);
    const double first = std::min(touchAt, liftAt);
    if (first > 1.0)
        return;
    denseAll(h, first, endPlace(), endSpeed());
    m_ahead.to = start + first * h;
    if (liftAt > first) {
        m_lifted = -1;
    } else {
        for (const Touching::Place &place : m_course.touching.places()) {
            if (rests(place) && m_lifted == place.point)
                m_state.resting[place.point] &= ~place.bit;
        }
    }
    bounce();
    settle();
}

bool Advance::mayTouch(const Touching::Place &place) const
{
    const Surface &surface = place.surface;
    if (gap(surface, at(endPlace(), place.row)) < 0.0)
        return true;
    return away(surface, at(m_speed, place.row)) <= 0.0 && away(surface, at(endSpeed(), place.row)) > 0.0;
}

bool Advance::mayMeet() const
{
    const std::vector<Touching::Place> &places = m_course.touching.places();
    return std::any_of(places.begin(), places.end(),
                       [&](const Touching::Place &place) { return rests(place) || mayTouch(place); });
}

double Advance::firstTouch(double h) const
{
    double first = none;
    for (const Touching::Place &place : m_course.touching.places()) {
        if (!free(place) || !mayTouch(place))
            continue;
        // One look spares the search for what is still in the air when another has touched.
        const bool late = first <= 1.0 && gap(place.surface, dense(place.row, h, first).x) > 0.0;
        if (!late)
            first = std::min(first, touch(place, h));
    }
    return first;
}

double Advance::touch(const Touching::Place &place, double h) const
{
    const Surface &surface = place.surface;
    const auto gapAt = [&](double theta) { return gap(surface, dense(place.row, h, theta).x); };
    const auto speedAt = [&](double theta) { return away(surface, dense(place.row, h, theta).v); };
    if (gap(surface, at(endPlace(), place.row)) < 0.0) {
        // What has just bounced stands on the surface: it can only come back after its highest point.
        const bool leaves = away(surface, at(m_speed, place.row)) > 0.0;
        const bool returns = away(surface, at(endSpeed(), place.row)) > 0.0;
        const double highest = leaves && !returns ? firstRoot(speedAt, 0.0, 1.0) : 0.0;
        if (gapAt(highest) <= 0.0)
            return highest;
        return firstRoot(gapAt, highest, 1.0);
    }
    // It may have been past the surface in between.
    const double lowest = firstRoot([&](double theta) { return -speedAt(theta); }, 0.0, 1.0);
    if (gapAt(lowest) >= 0.0 || gapAt(0.0) < 0.0)
        return none;
    return firstRoot(gapAt, 0.0, lowest);
}

double Advance::firstLift(double start, double h)
{
    m_lifted = -1;
    double *x = m_trial, *a = m_trial + m_size;
    const auto pullAt = [&](double theta) {
        denseAll(h, theta, x, a);
        m_pulls.whole(x, start + theta * h, a);
    };
    // The pull of a place's surface less what it takes up: below 0 it lifts.
    const auto press = [&](const Touching::Place &place) { return -away(place.surface, at(a, place.row)); };
    std::vector<const Touching::Place *> lifting; // the last is looked at first
    const auto keepLifting = [&](double theta) {
        pullAt(theta);
        std::erase_if(lifting, [&](const Touching::Place *place) { return press(*place) >= 0.0; });
    };
    const std::vector<Touching::Place> &places = m_course.touching.places();
    for (auto place = places.rbegin(); place != places.rend(); ++place) {
        if (rests(*place))
            lifting.push_back(&*place);
    }
    if (lifting.empty())
        return none;
    keepLifting(1.0);
    double first = none;
    // Each search takes all forces many times: what still rests when another has lifted is not searched for.
    while (!lifting.empty()) {
        const Touching::Place &place = *lifting.back();
        lifting.pop_back();
        const auto pressAt = [&](double theta) {
            pullAt(theta);
            return press(place);
        };
        const double lift = firstRoot(pressAt, 0.0, 1.0);
        if (lift < first) {
            first = lift;
            m_lifted = place.point;
        }
        if (!lifting.empty())
            keepLifting(first);
    }
    return first;
}

void Advance::bounce()
{
    for (const Touching::Place &place : m_course.touching.places()) {
        if (!free(place))
            continue;
        const Surface &surface = place.surface;
        const Vec2 x = at(endPlace(), place.row), v = at(endSpeed(), place.row);
        const double distance = gap(surface, x);
        if (distance < 0.0)
            put(endPlace(), place.row, x - distance * surface.normal);
        if (distance <= touching && away(surface, v) < 0.0)
            put(endSpeed(), place.row, bounced(surface, v));
    }
}

void Advance::settle()
{
    m_pulls.whole(endPlace(), m_ahead.to, endSlope());
    for (const Touching::Place &place : m_course.touching.places()) {
        if (!m_state.feels(place.point))
            continue;
        const Surface &surface = place.surface;
        const double pull = away(surface, at(endSlope(), place.row));
        const Vec2 x = at(endPlace(), place.row), v = at(endSpeed(), place.row);
        const double into = std::max(0.0, -pull);
        const bool slow = std::abs(away(surface, v)) <= restingSpeed(into, m_course.tolerance) &&
                          gap(surface, x) <= touching;
        if (rests(place) && pull > 0.0)
            m_state.resting[place.point] &= ~place.bit;
        else if (!rests(place) && slow && pull <= 0.0 && place.point != m_lifted)
            m_state.resting[place.point] |= place.bit;
        if (rests(place))
            put(endSpeed(), place.row, held(surface, v));
    }
    m_pulls.hold(endSlope());
}

}
