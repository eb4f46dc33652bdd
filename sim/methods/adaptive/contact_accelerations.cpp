#include "sim/methods/adaptive/contact_accelerations.h"

#include <algorithm>
#include <cmath>

namespace sim {

void ContactAccelerations::advanceDriversTo(double time)
{
    if (time == m_clock)
        return;
    m_system.advanceDrivers(m_state, time - m_clock);
    m_clock = time;
}

void ContactAccelerations::unconstrained(const double *place, double time, double *into)
{
    advanceDriversTo(time);
    m_system.writePositions(place, m_state);
    m_system.accelerations(m_state, into);
    m_state.pointEvaluations += m_system.points();
}

void ContactAccelerations::at(const double *place, double time, double *into)
{
    unconstrained(place, time, into);
    removeConstrained(into);
}

void ContactAccelerations::removeConstrained(double *numbers) const
{
    for (const OdeSystem::RateRange &rows : m_system.rateRanges()) {
        if (std::isinf(rows.rate))
            std::fill(numbers + rows.first, numbers + rows.end(), 0.0);
    }
    if (!m_contacts.any())
        return;
    const int points = m_system.points();
    for (const ContactCandidates::Candidate &place : m_contacts.all()) {
        if (!isResting(place))
            continue;
        const Vec2 left =
            restingAcceleration(place.surface, {numbers[place.row], numbers[points + place.row]});
        numbers[place.row] = left.x;
        numbers[points + place.row] = left.y;
    }
}

}
