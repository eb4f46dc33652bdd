#include "sim/methods/parts.h"

#include <algorithm>

namespace sim {

namespace {

const char *const here = "sim/methods/parts.h";

bool runsInOrder(const EffectPtr &effect)
{
    return !dynamic_cast<const Driver *>(effect.get());
}

/// Calls `visit(point)` for each point of `runs` that feels forces in `state`.
template <class Visit>
void forEachFree(const State &state, const std::vector<Points> &runs, Visit &&visit)
{
    for (const Points &run : runs) {
        for (int i = run.first; i < run.end(); ++i) {
            if (state.feels(i))
                visit(i);
        }
    }
}

}

PhaseList::PhaseList(const Scene &scene, Directions directions, double h)
    : m_scene(scene), m_directions(directions), m_h(h)
{
}

Share PhaseList::everything() const
{
    return {{0, m_scene.start.points()}, -1};
}

std::vector<Share> PhaseList::groups() const
{
    std::vector<Share> shares;
    for (const Group &group : m_scene.groups)
        shares.push_back({group.points, static_cast<int>(shares.size())});
    return shares;
}

template <class Type, class Visit>
void PhaseList::forEach(const Share &share, Visit &&visit) const
{
    for (const EffectPtr &effect : m_scene.effects) {
        const auto typed = std::dynamic_pointer_cast<const Type>(effect);
        if (typed && typed->count(m_scene.start, share.points) > 0)
            visit(typed);
    }
}

Phase PhaseList::phaseOf(const EffectPtr &effect, const Share &share) const
{
    Phase phase;
    phase.id = effect->id();
    phase.title = effect->title();
    phase.kind = effect->kind();
    phase.effect = effect;
    phase.points = share.points;
    phase.group = share.group;
    phase.regions = effect->regions(m_directions);
    return phase;
}

Phase PhaseList::ownPhase(const char *id, const char *title, const Share &share) const
{
    Phase phase;
    phase.id = id;
    phase.title = title;
    phase.points = share.points;
    phase.group = share.group;
    phase.regions = {{here, id}};
    return phase;
}

std::vector<Points> PhaseList::inert(Points points) const
{
    std::vector<Points> runs;
    for (const Group &group : m_scene.groups) {
        const int first = std::max(points.first, group.points.first);
        const int end = std::min(points.end(), group.points.end());
        if (group.inertia == Inertia::none || first >= end)
            continue;
        const auto free = m_scene.start.inverseMass.segment(first, end - first) != 0.0;
        if (free.any())
            runs.push_back({first, end - first});
    }
    return runs;
}

bool PhaseList::hasConstraint(const Share &share) const
{
    bool any = false;
    forEach<Constraint>(share, [&](const auto &) { any = true; });
    return any;
}

void PhaseList::driver(const std::shared_ptr<const Driver> &driver)
{
    if (driver->count(m_scene.start, everything().points) == 0)
        return;
    Phase phase = phaseOf(driver, everything());
    phase.run = [driver, h = m_h](State &state) { driver->drive(state, h); };
    phase.explain = [driver](const State &before, const State &after, int point) {
        return driver->explain(before, after, point);
    };
    m_phases.push_back(std::move(phase));
}

void PhaseList::driversFirst()
{
    const auto end = std::find_if(m_scene.effects.begin(), m_scene.effects.end(), runsInOrder);
    for (auto effect = m_scene.effects.begin(); effect != end; ++effect)
        driver(std::static_pointer_cast<const Driver>(*effect));
}

void PhaseList::driversLast()
{
    const auto start = std::find_if(m_scene.effects.begin(), m_scene.effects.end(), runsInOrder);
    for (auto effect = start; effect != m_scene.effects.end(); ++effect) {
        if (const auto one = std::dynamic_pointer_cast<const Driver>(*effect))
            driver(one);
    }
}

void PhaseList::force(const std::shared_ptr<const Force> &force, const Share &share, const Adding &adding)
{
    Phase phase = phaseOf(force, share);
    phase.regions.push_back(adding.forceShown);
    phase.run = [force, add = adding.force, points = share.points, h = m_h](State &state) {
        add(*force, state, points, h);
    };
    phase.explain = [force, way = m_directions](const State &before, const State &after, int point) {
        std::vector<Live> live = force->explain(before, point, way);
        if (!live.empty() && before.speed(point) != after.speed(point))
            live.push_back({"velocity", after.speed(point), before.speed(point)});
        return live;
    };
    m_phases.push_back(std::move(phase));
}

void PhaseList::torque(const std::shared_ptr<const Torque> &torque, const Share &share, const Adding &adding)
{
    Phase phase = phaseOf(torque, share);
    phase.regions.push_back(adding.torqueShown);
    phase.run = [torque, add = adding.torque, points = share.points, h = m_h](State &state) {
        add(*torque, state, points, h);
    };
    phase.explain = [torque](const State &before, const State &after, int point) {
        std::vector<Live> live = torque->explain(before, point);
        if (!live.empty() && before.spin[point] != after.spin[point])
            live.push_back({"spin", after.spin[point], before.spin[point]});
        return live;
    };
    m_phases.push_back(std::move(phase));
}

void PhaseList::drag(const std::shared_ptr<const Drag> &drag, const Share &share)
{
    Phase phase = phaseOf(drag, share);
    phase.run = [drag, points = share.points, h = m_h](State &state) { drag->slow(state, points, h); };
    phase.explain = [drag, h = m_h](const State &before, const State &after, int point) {
        return drag->explain(before, after, point, h);
    };
    m_phases.push_back(std::move(phase));
}

void PhaseList::forces(const Share &share, const Adding &adding)
{
    forEach<Force>(share, [&](const auto &one) { force(one, share, adding); });
    forEach<Torque>(share, [&](const auto &one) { torque(one, share, adding); });
}

void PhaseList::damping(const Share &share)
{
    forEach<Drag>(share, [&](const auto &one) { drag(one, share); });
}

void PhaseList::asListed(const Share &share, const Adding &adding)
{
    forEach<Effect>(share, [&](const EffectPtr &effect) {
        if (const auto asForce = std::dynamic_pointer_cast<const Force>(effect))
            force(asForce, share, adding);
        else if (const auto asTorque = std::dynamic_pointer_cast<const Torque>(effect))
            torque(asTorque, share, adding);
        else if (const auto asDrag = std::dynamic_pointer_cast<const Drag>(effect))
            drag(asDrag, share);
    });
}

void PhaseList::kick(const Share &share)
{
    bool anyForce = false, anyTorque = false;
    forEach<Force>(share, [&](const auto &) { anyForce = true; });
    forEach<Torque>(share, [&](const auto &) { anyTorque = true; });
    const std::vector<Points> runs = inert(share.points);
    if (anyTorque)
        kickSpins(share);
    if (!anyForce || runs.empty())
        return;
    Phase phase = ownPhase("kick", SIM_TEXT("kick"), share);
    phase.run = [runs, h = m_h](State &state) {
        forEachFree(state, runs, [&](int i) {
            const Vec2 a = {state.acceleration(i, 0), state.acceleration(i, 1)};
            state.push(i, sim::kick(state.speed(i), a, h));
        });
    };
    phase.explain = [](const State &before, const State &after, int point) {
        return std::vector<Live>{{"v", after.speed(point), before.speed(point)}};
    };
    m_phases.push_back(std::move(phase));
}

void PhaseList::kickSpins(const Share &share)
{
    Phase phase = ownPhase("kick_spin", SIM_TEXT("kick"), share);
    phase.run = [runs = inert(share.points), h = m_h](State &state) {
        forEachFree(state, runs,
                    [&](int i) { state.spin[i] = kickSpin(state.spin[i], state.turning[i], h); });
    };
    phase.explain = [](const State &before, const State &after, int point) {
        return std::vector<Live>{{"spin", after.spin[point], before.spin[point]}};
    };
    m_phases.push_back(std::move(phase));
}

void PhaseList::move(const Share &share)
{
    const std::vector<Points> runs = inert(share.points);
    if (runs.empty())
        return;
    if (spins()) {
        turnAngles(share);
        return;
    }
    Phase phase = ownPhase("move", SIM_TEXT("move"), share);
    phase.moves = true;
    const bool remembers = hasConstraint(share);
    phase.run = [runs, points = share.points, h = m_h, remembers](State &state) {
        if (remembers && state.previous.rows() != state.points())
            state.previous = state.position;
        if (remembers)
            state.previous.middleRows(points.first, points.count) =
                state.position.middleRows(points.first, points.count);
        forEachFree(state, runs, [&](int i) { state.place(i, sim::move(state.at(i), state.speed(i), h)); });
    };
    phase.explain = [](const State &before, const State &after, int point) {
        return std::vector<Live>{{"x", after.at(point), before.at(point)}};
    };
    m_phases.push_back(std::move(phase));
}

void PhaseList::turnAngles(const Share &share)
{
    Phase phase = ownPhase("turn", SIM_TEXT("turn"), share);
    phase.moves = true;
    phase.run = [runs = inert(share.points), h = m_h](State &state) {
        forEachFree(state, runs, [&](int i) { state.angle[i] = turn(state.angle[i], state.spin[i], h); });
    };
    phase.explain = [](const State &before, const State &after, int point) {
        return std::vector<Live>{{"angle", after.angle[point], before.angle[point]}};
    };
    m_phases.push_back(std::move(phase));
}

void PhaseList::constraints(const Share &share)
{
    forEach<Constraint>(share, [&](const std::shared_ptr<const Constraint> &constraint) {
        Phase phase = phaseOf(constraint, share);
        phase.run = [constraint, points = share.points, way = m_directions, h = m_h](State &state) {
            constraint->enforce(state, points, way, h);
        };
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
    phase.run = [runs, h = m_h](State &state) {
        forEachFree(state, runs, [&](int i) {
            const Vec2 before = {state.previous(i, 0), state.previous(i, 1)};
            state.push(i, came(state.at(i), before, h));
        });
    };
    phase.explain = [](const State &before, const State &after, int point) {
        return std::vector<Live>{{"v", after.speed(point), before.speed(point)}};
    };
    m_phases.push_back(std::move(phase));
}

void PhaseList::contacts(const Share &share)
{
    forEach<Contact>(share, [&](const std::shared_ptr<const Contact> &contact) {
        Phase phase = phaseOf(contact, share);
        phase.run = [contact, points = share.points](State &state) { contact->resolve(state, points); };
        phase.explain = [](const State &before, const State &after, int point) {
            return changeOf(before, after, point);
        };
        m_phases.push_back(std::move(phase));
    });
}

}
