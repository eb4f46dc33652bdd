#pragma once

#include "sim/methods/adaptive/contact_events.h"
#include "sim/methods/ode_system.h"

namespace sim {

/// The accelerations along a step: of the equations, less what surfaces take up of points that rest on them.
class ContactAccelerations
{
public:
    /// Between two frames: `state` stands at a whole one.
    ContactAccelerations(const OdeSystem &system, const ContactCandidates &contacts, State &state)
        : m_system(system), m_contacts(contacts), m_state(state)
    {
    }

    /// a(q, t) at the place `place`, `time` frames after the last whole one, of what rests without what its surface takes
    /// up. Flow::size() numbers each.
    void at(const double *place, double time, double *into);
    /// The same with what surfaces take up.
    void unconstrained(const double *place, double time, double *into);
    /// Takes the drivers to `time`.
    void advanceDriversTo(double time);
    /// Takes out what surfaces take up, and what damping stops at once.
    void removeConstrained(double *numbers) const;
    bool isResting(const ContactCandidates::Candidate &place) const
    {
        return (m_state.restingContacts[place.point] & place.bit) != 0;
    }

private:
    const OdeSystem &m_system;
    const ContactCandidates &m_contacts;
    State &m_state;
    double m_clock = 0.0; ///< frames since the last whole one, to which the drivers have been taken
};

}
