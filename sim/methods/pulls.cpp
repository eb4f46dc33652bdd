#include "sim/methods/pulls.h"

#include <algorithm>
#include <cmath>

namespace sim {

void Pulls::clockTo(double time)
{
    if (time == m_clock)
        return;
    m_flow.tick(m_state, time - m_clock);
    m_clock = time;
}

void Pulls::whole(const double *place, double time, double *into)
{
    clockTo(time);
    m_flow.place(place, m_state);
    m_flow.accelerations(m_state, into);
    ++m_state.evaluations;
}

void Pulls::at(const double *place, double time, double *into)
{
    whole(place, time, into);
    hold(into);
}

void Pulls::hold(double *numbers) const
{
    for (const Flow::Stretch &rows : m_flow.stretches()) {
        if (std::isinf(rows.rate))
            std::fill(numbers + rows.first, numbers + rows.end(), 0.0);
    }
    if (!m_touching.any())
        return;
    const int points = m_state.points();
    for (const Touching::Place &place : m_touching.places()) {
        if (!rests(place))
            continue;
        const Vec2 left = held(place.surface, {numbers[place.point], numbers[points + place.point]});
        numbers[place.point] = left.x;
        numbers[points + place.point] = left.y;
    }
}

}
