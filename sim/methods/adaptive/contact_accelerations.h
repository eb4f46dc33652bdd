#pragma once

#include "sim/methods/adaptive/contact_events.h"
#include "sim/methods/ode_system.h"

namespace sim {

/// The accelerations within a step: those of the equations, minus the parts that surfaces balance at resting
/// points.
class ContactAccelerations
{
public:
    /// `state` must be at a whole frame, from which times count.
    ContactAccelerations(const OdeSystem &system, const ContactCandidates &contacts, State &state)
        : m_system(system), m_contacts(contacts), m_state(state)
    {
    }

    /// Computes the accelerations at `position`, `velocity` and `time` (frames), without the parts that surfaces
    /// balance. Each array has OdeSystem::size() numbers. `velocity` may be null if no force depends on it.
    void at(const double *position, const double *velocity, double time, double *accelerations);
    /// Computes the accelerations of the equations alone.
    void unconstrained(const double *position, const double *velocity, double time, double *accelerations);
    /// Runs the continuous drivers to `time` (frames).
    void advanceDriversTo(double time);
    /// Removes the parts that surfaces balance, and sets points that damping stops at once to 0.
    void removeConstrained(double *accelerations) const;
    /// Returns whether the point of `candidate` rests on its surface.
    bool isResting(const ContactCandidates::Candidate &candidate) const
    {
        return (m_state.restingContacts[candidate.point] & candidate.bit) != 0;
    }

private:
    const OdeSystem &m_system;
    const ContactCandidates &m_contacts;
    State &m_state;
    double m_driverTime = 0.0; ///< frames, time that the drivers have reached
};

}
