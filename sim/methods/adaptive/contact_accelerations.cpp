#include "sim/methods/adaptive/contact_accelerations.h"

#include <algorithm>
#include <cmath>

namespace sim {

void ContactAccelerations::advanceDriversTo(double time)
{
    if (time == m_driverTime)
        return;
    m_system.advanceDrivers(m_state, time - m_driverTime);
    m_driverTime = time;
}

void ContactAccelerations::unconstrained(const double *position, const double *velocity, double time,
                                         double *accelerations)
{
    advanceDriversTo(time);
    m_system.writePositions(position, m_state);
    if (velocity && m_system.readsVelocities())
        m_system.writeVelocities(velocity, m_state);
    m_system.accelerations(m_state, accelerations);
    m_state.pointEvaluations += m_system.points();
}

void ContactAccelerations::at(const double *position, const double *velocity, double time,
                              double *accelerations)
{
    unconstrained(position, velocity, time, accelerations);
    removeConstrained(accelerations);
}

void ContactAccelerations::removeConstrained(double *accelerations) const
{
    for (const OdeSystem::RateRange &range : m_system.rateRanges()) {
        if (std::isinf(range.rate))
            std::fill(accelerations + range.first, accelerations + range.end(), 0.0);
    }
    if (!m_contacts.any())
        return;
    const int points = m_system.points();
    for (const ContactCandidates::Candidate &candidate : m_contacts.all()) {
        if (!isResting(candidate))
            continue;
        const Vec2 remaining = restingAcceleration(
            candidate.surface, {accelerations[candidate.row], accelerations[points + candidate.row]});
        accelerations[candidate.row] = remaining.x;
        accelerations[points + candidate.row] = remaining.y;
    }
}

}
