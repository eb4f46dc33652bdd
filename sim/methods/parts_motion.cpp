#include "sim/methods/parts.h"

#include <algorithm>

namespace sim {

namespace {

/// What a part of the step is called that is not the whole of it.
const char *half(double part, const char *whole, const char *halved)
{
    return part == 1.0 ? whole : halved;
}

/// Calls `visit(point)` for each point of `points` that is in `runs` and feels forces in `state`.
template <class Visit>
void forEachFree(const State &state, const std::vector<Points> &runs, Points points, Visit &&visit)
{
    for (const Points &run : runs) {
        const int end = std::min(run.end(), points.end());
        for (int i = std::max(run.first, points.first); i < end; ++i) {
            if (state.feels(i))
                visit(i);
        }
    }
}

}

void PhaseList::kick(const Share &share, double part)
{
    bool anyForce = false, anyTorque = false;
    forEach<Force>(share, [&](const auto &) { anyForce = true; });
    forEach<Torque>(share, [&](const auto &) { anyTorque = true; });
    const std::vector<Points> runs = inert(share.points);
    if (anyTorque)
        kickSpins(share, part);
    if (!anyForce || runs.empty())
        return;
    Phase phase = ownPhase("kick", half(part, SIM_TEXT("kick"), SIM_TEXT("half kick")), share);
    phase.kicks = part * m_h;
    setWork(phase, [runs, h = part * m_h](State &state, Points points) {
        forEachFree(state, runs, points, [&](int i) {
            const Vec2 a = {state.acceleration(i, 0), state.acceleration(i, 1)};
            state.push(i, sim::kick(state.speed(i), a, h));
        });
    });
    phase.explain = [](const State &before, const State &after, int point) {
        return std::vector<Live>{{"v", after.speed(point), before.speed(point)}};
    };
    m_phases.push_back(std::move(phase));
}

void PhaseList::kickSpins(const Share &share, double part)
{
    Phase phase = ownPhase("kick_spin", half(part, SIM_TEXT("kick"), SIM_TEXT("half kick")), share);
    phase.kicks = part * m_h;
    setWork(phase, [runs = inert(share.points), h = part * m_h](State &state, Points points) {
        forEachFree(state, runs, points,
                    [&](int i) { state.spin[i] = kickSpin(state.spin[i], state.turning[i], h); });
    });
    phase.explain = [](const State &before, const State &after, int point) {
        return std::vector<Live>{{"spin", after.spin[point], before.spin[point]}};
    };
    m_phases.push_back(std::move(phase));
}

void PhaseList::move(const Share &share, double part)
{
    const std::vector<Points> runs = inert(share.points);
    if (runs.empty())
        return;
    if (spins()) {
        turnAngles(share, part);
        return;
    }
    Phase phase = ownPhase("move", half(part, SIM_TEXT("move"), SIM_TEXT("half move")), share);
    phase.moves = true;
    setWork(phase, [runs, h = part * m_h](State &state, Points points) {
        forEachFree(state, runs, points,
                    [&](int i) { state.place(i, sim::move(state.at(i), state.speed(i), h)); });
    });
    if (const auto keep = remembering(share))
        setWorkBefore(phase, keep);
    phase.explain = [](const State &before, const State &after, int point) {
        return std::vector<Live>{{"x", after.at(point), before.at(point)}};
    };
    m_phases.push_back(std::move(phase));
}

void PhaseList::turnAngles(const Share &share, double part)
{
    Phase phase = ownPhase("turn", half(part, SIM_TEXT("turn"), SIM_TEXT("half turn")), share);
    phase.moves = true;
    setWork(phase, [runs = inert(share.points), h = part * m_h](State &state, Points points) {
        forEachFree(state, runs, points,
                    [&](int i) { state.angle[i] = turn(state.angle[i], state.spin[i], h); });
    });
    phase.explain = [](const State &before, const State &after, int point) {
        return std::vector<Live>{{"angle", after.angle[point], before.angle[point]}};
    };
    m_phases.push_back(std::move(phase));
}

void PhaseList::constraints(const Share &share)
{
    forEach<Constraint>(share, [&](const std::shared_ptr<const Constraint> &constraint) {
        Phase phase = phaseOf(constraint, share);
        setWork(phase, [constraint, way = m_directions, h = m_h](State &state, Points points) {
            constraint->enforce(state, points, way, h);
        });
        phase.explain = [constraint](const State &before, const State &after, int point) {
            return constraint->explain(before, after, point);
        };
        m_phases.push_back(std::move(phase));
    });
    if (hasConstraint(share))
        velocities(share);
}

void PhaseList::velocities(const Share &share)
{
    const std::vector<Points> runs = inert(share.points);
    if (runs.empty() || spins())
        return;
    Phase phase = ownPhase("came", SIM_TEXT("new velocity"), share);
    setWork(phase, [runs, h = m_h](State &state, Points points) {
        forEachFree(state, runs, points, [&](int i) {
            const Vec2 before = {state.previous(i, 0), state.previous(i, 1)};
            state.push(i, came(state.at(i), before, h));
        });
    });
    phase.explain = [](const State &before, const State &after, int point) {
        return std::vector<Live>{{"v", after.speed(point), before.speed(point)}};
    };
    m_phases.push_back(std::move(phase));
}

void PhaseList::contacts(const Share &share)
{
    forEach<Contact>(share, [&](const std::shared_ptr<const Contact> &contact) {
        Phase phase = phaseOf(contact, share);
        setWork(phase, [contact](State &state, Points points) { contact->resolve(state, points); });
        phase.explain = [](const State &before, const State &after, int point) {
            return changeOf(before, after, point);
        };
        m_phases.push_back(std::move(phase));
    });
}

}
