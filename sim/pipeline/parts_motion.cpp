#include "sim/pipeline/parts.h"
#include "sim/simd/free_points.h"

namespace sim {

namespace {

/// What a part of the step is called that is not the whole of it.
const char *half(double part, const char *whole, const char *halved)
{
    return part == 1.0 ? whole : halved;
}

void kickAll(State &state, Points run, double h)
{
    const Columns v(state.velocity), a(state.acceleration);
    replaceFree(state.inverseMass, run, state.velocity,
                [=](int i) { return sim::kick(v.at(i), a.at(i), h); });
}

void moveAll(State &state, Points run, double h)
{
    const Columns x(state.position), v(state.velocity);
    replaceFree(state.inverseMass, run, state.position,
                [=](int i) { return sim::move(x.at(i), v.at(i), h); });
}

void kickSpinOfAll(State &state, Points run, double h)
{
    const double *spin = state.spin.data(), *turning = state.turning.data();
    replaceFree(state.inverseMass, run, state.spin.data(),
                [=](int i) { return kickSpin(spin[i], turning[i], h); });
}

void turnAll(State &state, Points run, double h)
{
    const double *angle = state.angle.data(), *spin = state.spin.data();
    replaceFree(state.inverseMass, run, state.angle.data(),
                [=](int i) { return turn(angle[i], spin[i], h); });
}

/// Gives all points of `run` the velocity with which they came to where they are.
void takeVelocities(State &state, Points run, double h)
{
    const Columns x(state.position), before(state.previous);
    replaceFree(state.inverseMass, run, state.velocity,
                [=](int i) { return came(x.at(i), before.at(i), h); });
}

/// Calls `visit(run)` for each of `runs` as far as it is among `points`.
template <class Visit>
void forEachRun(const std::vector<Points> &runs, Points points, Visit &&visit)
{
    for (const Points &run : runs) {
        if (const Points part = common(run, points); part.count > 0)
            visit(part);
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
        forEachRun(runs, points, [&](Points run) { kickAll(state, run, h); });
    });
    if (runs.size() == 1)
        phase.kernels.back().step = {PointStep::Does::kicks, part * m_h, feeling(runs.front())};
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
        forEachRun(runs, points, [&](Points run) { kickSpinOfAll(state, run, h); });
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
        forEachRun(runs, points, [&](Points run) { moveAll(state, run, h); });
    });
    if (runs.size() == 1)
        phase.kernels.back().step = {PointStep::Does::moves, part * m_h, feeling(runs.front())};
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
        forEachRun(runs, points, [&](Points run) { turnAll(state, run, h); });
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
        forEachRun(runs, points, [&](Points run) { takeVelocities(state, run, h); });
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
