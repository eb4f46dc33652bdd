#pragma once

#include "sim/methods/adaptive/contact_events.h"
#include "sim/methods/ode_system.h"

namespace sim {

/// The accelerations along a step: of the equations, less what surfaces take up of points that rest on them.
class Pulls
{
public:
    /// Between two frames: `state` stands at a whole one.
    Pulls(const Flow &flow, const Touching &touching, State &state)
        : m_flow(flow), m_touching(touching), m_state(state)
    {
    }

    /// a(q, t) at the place `place`, `time` frames after the last whole one, of what rests without what its surface takes
    /// up. Flow::size() numbers each.
    void at(const double *place, double time, double *into);
    /// The same with what surfaces take up.
    void whole(const double *place, double time, double *into);
    /// Takes the drivers to `time`.
    void clockTo(double time);
    /// Takes out what surfaces take up, and what damping stops at once.
    void hold(double *numbers) const;
    bool rests(const Touching::Place &place) const { return (m_state.resting[place.point] & place.bit) != 0; }

private:
    const Flow &m_flow;
    const Touching &m_touching;
    State &m_state;
    double m_clock = 0.0; ///< frames since the last whole one, to which the drivers have been taken
};

}
