#include "sim/methods/adaptive/contact_accelerations.h"

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
    m_state.evaluations += m_flow.points();
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
    const int points = m_flow.points();
    for (const Touching::Place &place : m_touching.places()) {
        if (!rests(place))
            continue;
        const Vec2 left = held(place.surface, {numbers[place.row], numbers[points + place.row]});
        numbers[place.row] = left.x;
        numbers[points + place.row] = left.y;
    }
}

}
