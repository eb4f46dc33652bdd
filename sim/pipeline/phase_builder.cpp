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

PhaseBuilder::PhaseBuilder(const Scene &scene, DirectionRule directionRule, double h)
    : m_scene(scene), m_directionRule(directionRule), m_h(h)
{
}

PhasePoints PhaseBuilder::allPoints() const
{
    return {{0, m_scene.start.pointCount()}, -1};
}

std::vector<PhasePoints> PhaseBuilder::groups() const
{
    std::vector<PhasePoints> shares;
    for (const Group &group : m_scene.groups)
        shares.push_back({group.points, static_cast<int>(shares.size())});
    return shares;
}

Phase PhaseBuilder::phaseOf(const EffectPtr &effect, const PhasePoints &share) const
{
    Phase phase;
    phase.id = effect->id();
    phase.title = effect->title();
    phase.kind = effect->kind();
    phase.effect = effect;
    phase.points = share.points;
    phase.group = share.group;
    phase.regions = effect->regions(m_directionRule);
    return phase;
}

Phase PhaseBuilder::ownPhase(const char *id, const char *title, const PhasePoints &share) const
{
    Phase phase;
    phase.id = id;
    phase.title = title;
    phase.points = share.points;
    phase.group = share.group;
    phase.regions = {{here, id}};
    return phase;
}

std::vector<PointRange> PhaseBuilder::movingRanges(PointRange points) const
{
    std::vector<PointRange> ranges;
    for (const Group &group : m_scene.groups) {
        const int first = std::max(points.first, group.points.first);
        const int end = std::min(points.end(), group.points.end());
        if (group.motion == Motion::prescribed || first >= end)
            continue;
        const auto free = m_scene.start.inverseMass.segment(first, end - first) != 0.0;
        if (!free.any())
            continue;
        ranges.push_back({first, end - first});
    }
    return sortedRanges(std::move(ranges));
}

PointRange PhaseBuilder::trimToDynamic(PointRange points) const
{
    const auto feels = [&](int point) { return m_scene.start.isDynamic(point); };
    while (points.count > 0 && !feels(points.end() - 1))
        --points.count;
    while (points.count > 0 && !feels(points.first))
        points = {points.first + 1, points.count - 1};
    return points;
}

bool PhaseBuilder::hasConstraint(const PhasePoints &share) const
{
    bool any = false;
    forEach<Constraint>(share, [&](const auto &) { any = true; });
    return any;
}

void PhaseBuilder::driver(const std::shared_ptr<const Driver> &driver, double h)
{
    if (driver->count(m_scene.start, allPoints().points) == 0)
        return;
    Phase phase = phaseOf(driver, allPoints());
    phase.kernels = {{[driver, h](State &state) { driver->drive(state, h); }, {}}};
    phase.explain = [driver](const State &before, const State &after, int point) {
        return driver->explain(before, after, point);
    };
    m_phases.push_back(std::move(phase));
}

std::size_t PhaseBuilder::leading() const
{
    const auto end = std::find_if(m_scene.effects.begin(), m_scene.effects.end(), runsInOrder);
    return static_cast<std::size_t>(end - m_scene.effects.begin());
}

template <class Accept>
void PhaseBuilder::drivers(std::size_t first, std::size_t end, double h, Accept &&accept)
{
    for (std::size_t i = first; i < end; ++i) {
        const auto one = sharedAs<Driver>(m_scene.effects[i]);
        if (one && accept(one->timing()))
            driver(one, h);
    }
}

void PhaseBuilder::leadingDrivers()
{
    drivers(0, leading(), m_h, [](DriverTiming) { return true; });
}

void PhaseBuilder::trailingDrivers()
{
    drivers(leading(), m_scene.effects.size(), m_h, [](DriverTiming) { return true; });
}

void PhaseBuilder::leadingImpulses()
{
    drivers(0, leading(), m_h, [](DriverTiming pace) { return pace == DriverTiming::impulsive; });
}

void PhaseBuilder::trailingImpulses()
{
    drivers(leading(), m_scene.effects.size(), m_h,
            [](DriverTiming pace) { return pace == DriverTiming::impulsive; });
}

void PhaseBuilder::continuousDrivers(double part)
{
    drivers(0, m_scene.effects.size(), part * m_h,
            [](DriverTiming pace) { return pace == DriverTiming::continuous; });
    drivers(0, m_scene.effects.size(), part * m_h,
            [](DriverTiming pace) { return pace == DriverTiming::dependent; });
}

void PhaseBuilder::force(const std::shared_ptr<const Force> &force, const PhasePoints &share,
                         const ForceAccumulation &accumulation)
{
    Phase phase = phaseOf(force, share);
    phase.regions.push_back(accumulation.forceRegion);
    setWork(phase, [force, add = accumulation.force, h = m_h](State &state, PointRange points) {
        add(*force, state, points, h);
    });
    if (Kernel &kernel = phase.kernels.back();
        kernel.prepareFor && accumulation.target == AccumulationTarget::acceleration)
        kernel.prepareFor = [force](const std::vector<PointRange> &ranges) {
            return [add = force->adderFor(ranges), force](State &state) { add(state, state.acceleration); };
        };
    if (const std::optional<double> fall = force->uniformGravity();
        fall && accumulation.target == AccumulationTarget::acceleration)
        phase.kernels.back().operation = {PointOperation::Kind::addGravity, *fall,
                                          trimToDynamic(share.points)};
    phase.explain = [force, way = m_directionRule](const State &before, const State &after, int point) {
        std::vector<LiveValue> live = force->explain(before, point, way);
        if (!live.empty() && before.velocityOf(point) != after.velocityOf(point))
            live.push_back({"velocity", after.velocityOf(point), before.velocityOf(point)});
        return live;
    };
    m_phases.push_back(std::move(phase));
}

void PhaseBuilder::torque(const std::shared_ptr<const Torque> &torque, const PhasePoints &share,
                          const ForceAccumulation &accumulation)
{
    Phase phase = phaseOf(torque, share);
    phase.regions.push_back(accumulation.torqueRegion);
    setWork(phase, [torque, add = accumulation.torque, h = m_h](State &state, PointRange points) {
        add(*torque, state, points, h);
    });
    phase.explain = [torque](const State &before, const State &after, int point) {
        std::vector<LiveValue> live = torque->explain(before, point);
        if (!live.empty() && before.spin[point] != after.spin[point])
            live.push_back({"spin", after.spin[point], before.spin[point]});
        return live;
    };
    m_phases.push_back(std::move(phase));
}

void PhaseBuilder::drag(const std::shared_ptr<const Drag> &drag, const PhasePoints &share, double part)
{
    Phase phase = phaseOf(drag, share);
    const double h = part * m_h;
    setWork(phase, [drag, h](State &state, PointRange points) { drag->apply(state, points, h); });
    if (const std::optional<double> keep = drag->velocityFactor(share.points, h); keep && !spins())
        phase.kernels.back().operation = {PointOperation::Kind::damp, *keep, trimToDynamic(share.points)};
    phase.explain = [drag, h](const State &before, const State &after, int point) {
        return drag->explain(before, after, point, h);
    };
    m_phases.push_back(std::move(phase));
}

void PhaseBuilder::forces(const PhasePoints &share, const ForceAccumulation &accumulation)
{
    forEach<Force>(share, [&](const auto &one) { force(one, share, accumulation); });
    forEach<Torque>(share, [&](const auto &one) { torque(one, share, accumulation); });
}

void PhaseBuilder::accumulateForces(const PhasePoints &share)
{
    const std::size_t before = m_phases.size();
    forces(share, accelerationAccumulation());
    if (m_phases.size() == before)
        return;
    // Nothing is gathered yet from where the step begins, or from where the last trial place was left.
    Phase &first = m_phases[m_gathers ? before : 0];
    m_gathers = true;
    setWorkBefore(first, [](State &state, PointRange points) {
        setZero(state.acceleration, points);
        if (state.angularAcceleration.rows() > 0)
            state.angularAcceleration.segment(points.first, points.count).setZero();
    });
}

void PhaseBuilder::damping(const PhasePoints &share, double part)
{
    forEach<Drag>(share, [&](const auto &one) { drag(one, share, part); });
}

void PhaseBuilder::dampingWithoutRate(const PhasePoints &share)
{
    forEach<Drag>(share, [&](const auto &one) {
        if (!one->dampingRate(share.points.first))
            drag(one, share, 1.0);
    });
}

void PhaseBuilder::inSceneOrder(const PhasePoints &share, const ForceAccumulation &accumulation)
{
    for (const EffectPtr &effect : m_scene.effects) {
        if (effect->count(m_scene.start, share.points) == 0)
            continue;
        if (const auto asForce = sharedAs<Force>(effect))
            force(asForce, share, accumulation);
        else if (const auto asTorque = sharedAs<Torque>(effect))
            torque(asTorque, share, accumulation);
        else if (const auto asDrag = sharedAs<Drag>(effect))
            drag(asDrag, share, 1.0);
    }
}

std::function<void(State &, PointRange)> PhaseBuilder::savePrevious(const PhasePoints &share) const
{
    if (!hasConstraint(share))
        return nullptr;
    return [](State &state, PointRange points) {
        if (state.previous.rows() != state.pointCount())
            state.previous = state.position;
        state.previous.middleRows(points.first, points.count) =
            state.position.middleRows(points.first, points.count);
    };
}

void PhaseBuilder::rewindPrevious(const PhasePoints &share)
{
    if (!hasConstraint(share))
        return;
    m_keepBefore = m_phases.size();
    m_keep = [h = m_h](State &state, PointRange points) {
        if (state.previous.rows() != state.pointCount())
            state.previous = state.position;
        state.previous.middleRows(points.first, points.count) =
            state.position.middleRows(points.first, points.count) -
            h * state.velocity.middleRows(points.first, points.count);
    };
}

std::vector<Phase> PhaseBuilder::take()
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

void kickAll(State &state, PointRange range, double h)
{
    const XyColumns v(state.velocity), a(state.acceleration);
    updateDynamic(state.inverseMass, range, state.velocity,
                  [=](int i) { return sim::kick(v.at(i), a.at(i), h); });
}

void moveAll(State &state, PointRange range, double h)
{
    const XyColumns x(state.position), v(state.velocity);
    updateDynamic(state.inverseMass, range, state.position,
                  [=](int i) { return sim::move(x.at(i), v.at(i), h); });
}

void kickSpinOfAll(State &state, PointRange range, double h)
{
    const double *spin = state.spin.data(), *turning = state.angularAcceleration.data();
    updateDynamic(state.inverseMass, range, state.spin.data(),
                  [=](int i) { return kickSpin(spin[i], turning[i], h); });
}

void turnAll(State &state, PointRange range, double h)
{
    const double *angle = state.angle.data(), *spin = state.spin.data();
    updateDynamic(state.inverseMass, range, state.angle.data(),
                  [=](int i) { return turn(angle[i], spin[i], h); });
}

/// Gives all points of `run` the velocity with which they came to where they are.
void takeVelocities(State &state, PointRange range, double h)
{
    const XyColumns x(state.position), before(state.previous);
    updateDynamic(state.inverseMass, range, state.velocity,
                  [=](int i) { return velocityFromPositions(x.at(i), before.at(i), h); });
}

/// Calls `visit(run)` for each of `runs` as far as it is among `points`.
template <class Visit>
void forEachRun(const std::vector<PointRange> &ranges, PointRange points, Visit &&visit)
{
    for (const PointRange &range : ranges) {
        if (const PointRange part = intersection(range, points); part.count > 0)
            visit(part);
    }
}
}

void PhaseBuilder::kick(const PhasePoints &share, double part)
{
    bool anyForce = false, anyTorque = false;
    forEach<Force>(share, [&](const auto &) { anyForce = true; });
    forEach<Torque>(share, [&](const auto &) { anyTorque = true; });
    const std::vector<PointRange> ranges = movingRanges(share.points);
    if (anyTorque)
        kickSpins(share, part);
    if (!anyForce || ranges.empty())
        return;
    Phase phase = ownPhase("kick", half(part, SIM_TEXT("kick"), SIM_TEXT("half kick")), share);
    phase.kickFrames = part * m_h;
    setWork(phase, [ranges, h = part * m_h](State &state, PointRange points) {
        forEachRun(ranges, points, [&](PointRange range) { kickAll(state, range, h); });
    });
    if (ranges.size() == 1)
        phase.kernels.back().operation = {PointOperation::Kind::kick, part * m_h,
                                          trimToDynamic(ranges.front())};
    phase.explain = [](const State &before, const State &after, int point) {
        return std::vector<LiveValue>{{"v", after.velocityOf(point), before.velocityOf(point)}};
    };
    m_phases.push_back(std::move(phase));
}

void PhaseBuilder::kickSpins(const PhasePoints &share, double part)
{
    Phase phase = ownPhase("kick_spin", half(part, SIM_TEXT("kick"), SIM_TEXT("half kick")), share);
    phase.kickFrames = part * m_h;
    setWork(phase, [ranges = movingRanges(share.points), h = part * m_h](State &state, PointRange points) {
        forEachRun(ranges, points, [&](PointRange range) { kickSpinOfAll(state, range, h); });
    });
    phase.explain = [](const State &before, const State &after, int point) {
        return std::vector<LiveValue>{{"spin", after.spin[point], before.spin[point]}};
    };
    m_phases.push_back(std::move(phase));
}

void PhaseBuilder::move(const PhasePoints &share, double part)
{
    const std::vector<PointRange> ranges = movingRanges(share.points);
    if (ranges.empty())
        return;
    if (spins()) {
        turnAngles(share, part);
        return;
    }
    Phase phase = ownPhase("move", half(part, SIM_TEXT("move"), SIM_TEXT("half move")), share);
    phase.consumesAcceleration = true;
    setWork(phase, [ranges, h = part * m_h](State &state, PointRange points) {
        forEachRun(ranges, points, [&](PointRange range) { moveAll(state, range, h); });
    });
    if (ranges.size() == 1)
        phase.kernels.back().operation = {PointOperation::Kind::move, part * m_h,
                                          trimToDynamic(ranges.front())};
    if (const auto keep = savePrevious(share))
        setWorkBefore(phase, keep);
    phase.explain = [](const State &before, const State &after, int point) {
        return std::vector<LiveValue>{{"x", after.positionOf(point), before.positionOf(point)}};
    };
    m_phases.push_back(std::move(phase));
}

void PhaseBuilder::turnAngles(const PhasePoints &share, double part)
{
    Phase phase = ownPhase("turn", half(part, SIM_TEXT("turn"), SIM_TEXT("half turn")), share);
    phase.consumesAcceleration = true;
    setWork(phase, [ranges = movingRanges(share.points), h = part * m_h](State &state, PointRange points) {
        forEachRun(ranges, points, [&](PointRange range) { turnAll(state, range, h); });
    });
    phase.explain = [](const State &before, const State &after, int point) {
        return std::vector<LiveValue>{{"angle", after.angle[point], before.angle[point]}};
    };
    m_phases.push_back(std::move(phase));
}

void PhaseBuilder::constraints(const PhasePoints &share)
{
    forEach<Constraint>(share, [&](const std::shared_ptr<const Constraint> &constraint) {
        Phase phase = phaseOf(constraint, share);
        setWork(phase, [constraint, way = m_directionRule, h = m_h](State &state, PointRange points) {
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

void PhaseBuilder::velocities(const PhasePoints &share)
{
    const std::vector<PointRange> ranges = movingRanges(share.points);
    if (ranges.empty() || spins())
        return;
    Phase phase = ownPhase("came", SIM_TEXT("new velocity"), share);
    setWork(phase, [ranges, h = m_h](State &state, PointRange points) {
        forEachRun(ranges, points, [&](PointRange range) { takeVelocities(state, range, h); });
    });
    phase.explain = [](const State &before, const State &after, int point) {
        return std::vector<LiveValue>{{"v", after.velocityOf(point), before.velocityOf(point)}};
    };
    m_phases.push_back(std::move(phase));
}

void PhaseBuilder::contacts(const PhasePoints &share)
{
    forEach<Contact>(share, [&](const std::shared_ptr<const Contact> &contact) {
        Phase phase = phaseOf(contact, share);
        setWork(phase, [contact](State &state, PointRange points) { contact->resolve(state, points); });
        phase.explain = [](const State &before, const State &after, int point) {
            return motionChange(before, after, point);
        };
        m_phases.push_back(std::move(phase));
    });
}

}
