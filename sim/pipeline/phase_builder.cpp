#include "sim/pipeline/phase_builder.h"

#include "sim/simd/point_kernels.h"

#include <algorithm>

namespace sim {

namespace {

const char *const here = "sim/pipeline/phase_builder.h";

bool runsInOrder(const EffectPtr &effect)
{
    return !as<Driver>(effect);
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
        if (!free.any())
            continue;
        runs.push_back({first, end - first});
    }
    return inOrder(std::move(runs));
}

Points PhaseList::feeling(Points points) const
{
    const auto feels = [&](int point) { return m_scene.start.feels(point); };
    while (points.count > 0 && !feels(points.end() - 1))
        --points.count;
    while (points.count > 0 && !feels(points.first))
        points = {points.first + 1, points.count - 1};
    return points;
}

bool PhaseList::hasConstraint(const Share &share) const
{
    bool any = false;
    forEach<Constraint>(share, [&](const auto &) { any = true; });
    return any;
}

void PhaseList::driver(const std::shared_ptr<const Driver> &driver, double h)
{
    if (driver->count(m_scene.start, everything().points) == 0)
        return;
    Phase phase = phaseOf(driver, everything());
    phase.kernels = {{[driver, h](State &state) { driver->drive(state, h); }, {}}};
    phase.explain = [driver](const State &before, const State &after, int point) {
        return driver->explain(before, after, point);
    };
    m_phases.push_back(std::move(phase));
}

std::size_t PhaseList::leading() const
{
    const auto end = std::find_if(m_scene.effects.begin(), m_scene.effects.end(), runsInOrder);
    return static_cast<std::size_t>(end - m_scene.effects.begin());
}

template <class Accept>
void PhaseList::drivers(std::size_t first, std::size_t end, double h, Accept &&accept)
{
    for (std::size_t i = first; i < end; ++i) {
        const auto one = shared<Driver>(m_scene.effects[i]);
        if (one && accept(one->pace()))
            driver(one, h);
    }
}

void PhaseList::driversFirst()
{
    drivers(0, leading(), m_h, [](Pace) { return true; });
}

void PhaseList::driversLast()
{
    drivers(leading(), m_scene.effects.size(), m_h, [](Pace) { return true; });
}

void PhaseList::jumpsFirst()
{
    drivers(0, leading(), m_h, [](Pace pace) { return pace == Pace::once; });
}

void PhaseList::jumpsLast()
{
    drivers(leading(), m_scene.effects.size(), m_h, [](Pace pace) { return pace == Pace::once; });
}

void PhaseList::flow(double part)
{
    drivers(0, m_scene.effects.size(), part * m_h, [](Pace pace) { return pace == Pace::flows; });
    drivers(0, m_scene.effects.size(), part * m_h, [](Pace pace) { return pace == Pace::follows; });
}

void PhaseList::force(const std::shared_ptr<const Force> &force, const Share &share, const Adding &adding)
{
    Phase phase = phaseOf(force, share);
    phase.regions.push_back(adding.forceShown);
    setWork(phase, [force, add = adding.force, h = m_h](State &state, Points points) {
        add(*force, state, points, h);
    });
    if (Kernel &kernel = phase.kernels.back(); kernel.part && adding.onto == Onto::acceleration)
        kernel.part = [force](const std::vector<Points> &runs) {
            return [add = force->part(runs), force](State &state) { add(state, state.acceleration); };
        };
    if (const std::optional<double> fall = force->fall(); fall && adding.onto == Onto::acceleration)
        phase.kernels.back().step = {PointStep::Does::falls, *fall, feeling(share.points)};
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
    setWork(phase, [torque, add = adding.torque, h = m_h](State &state, Points points) {
        add(*torque, state, points, h);
    });
    phase.explain = [torque](const State &before, const State &after, int point) {
        std::vector<Live> live = torque->explain(before, point);
        if (!live.empty() && before.spin[point] != after.spin[point])
            live.push_back({"spin", after.spin[point], before.spin[point]});
        return live;
    };
    m_phases.push_back(std::move(phase));
}

void PhaseList::drag(const std::shared_ptr<const Drag> &drag, const Share &share, double part)
{
    Phase phase = phaseOf(drag, share);
    const double h = part * m_h;
    setWork(phase, [drag, h](State &state, Points points) { drag->slow(state, points, h); });
    if (const std::optional<double> keep = drag->keep(share.points, h); keep && !spins())
        phase.kernels.back().step = {PointStep::Does::keeps, *keep, feeling(share.points)};
    phase.explain = [drag, h](const State &before, const State &after, int point) {
        return drag->explain(before, after, point, h);
    };
    m_phases.push_back(std::move(phase));
}

void PhaseList::forces(const Share &share, const Adding &adding)
{
    forEach<Force>(share, [&](const auto &one) { force(one, share, adding); });
    forEach<Torque>(share, [&](const auto &one) { torque(one, share, adding); });
}

void PhaseList::gather(const Share &share)
{
    const std::size_t before = m_phases.size();
    forces(share, gathering());
    if (m_phases.size() == before)
        return;
    // Nothing is gathered yet from where the step begins, or from where the last trial place was left.
    Phase &first = m_phases[m_gathers ? before : 0];
    m_gathers = true;
    setWorkBefore(first, [](State &state, Points points) {
        clear(state.acceleration, points);
        if (state.turning.rows() > 0)
            state.turning.segment(points.first, points.count).setZero();
    });
}

void PhaseList::damping(const Share &share, double part)
{
    forEach<Drag>(share, [&](const auto &one) { drag(one, share, part); });
}

void PhaseList::dampingWithoutRate(const Share &share)
{
    forEach<Drag>(share, [&](const auto &one) {
        if (!one->rate(share.points.first))
            drag(one, share, 1.0);
    });
}

void PhaseList::asListed(const Share &share, const Adding &adding)
{
    for (const EffectPtr &effect : m_scene.effects) {
        if (effect->count(m_scene.start, share.points) == 0)
            continue;
        if (const auto asForce = shared<Force>(effect))
            force(asForce, share, adding);
        else if (const auto asTorque = shared<Torque>(effect))
            torque(asTorque, share, adding);
        else if (const auto asDrag = shared<Drag>(effect))
            drag(asDrag, share, 1.0);
    }
}

std::function<void(State &, Points)> PhaseList::remembering(const Share &share) const
{
    if (!hasConstraint(share))
        return nullptr;
    return [](State &state, Points points) {
        if (state.previous.rows() != state.points())
            state.previous = state.position;
        state.previous.middleRows(points.first, points.count) =
            state.position.middleRows(points.first, points.count);
    };
}

void PhaseList::comeFrom(const Share &share)
{
    if (!hasConstraint(share))
        return;
    m_keepBefore = m_phases.size();
    m_keep = [h = m_h](State &state, Points points) {
        if (state.previous.rows() != state.points())
            state.previous = state.position;
        state.previous.middleRows(points.first, points.count) =
            state.position.middleRows(points.first, points.count) -
            h * state.velocity.middleRows(points.first, points.count);
    };
}

std::vector<Phase> PhaseList::take()
{
    if (m_keep && m_keepBefore < m_phases.size())
        setWorkBefore(m_phases[m_keepBefore], m_keep);
    return std::move(m_phases);
}

namespace {

/// Returns the title of a phase: `whole` if it takes the whole step, else `halved`.
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
