#include "sim/pipeline/phase_builder.h"

#include "sim/simd/point_kernels.h"

#include <algorithm>

namespace sim {

namespace {

const char *const sourceFile = "sim/pipeline/phase_builder.h";

bool isNoDriver(const EffectPtr &effect)
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
    std::vector<PhasePoints> selections;
    for (const Group &group : m_scene.groups)
        selections.push_back({group.points, static_cast<int>(selections.size())});
    return selections;
}

Phase PhaseBuilder::phaseOf(const EffectPtr &effect, const PhasePoints &selection) const
{
    Phase phase;
    phase.id = effect->id();
    phase.title = effect->title();
    phase.kind = effect->kind();
    phase.effect = effect;
    phase.points = selection.points;
    phase.group = selection.group;
    phase.regions = effect->regions(m_directionRule);
    return phase;
}

Phase PhaseBuilder::methodPhase(const char *id, const char *title, const PhasePoints &selection) const
{
    Phase phase;
    phase.id = id;
    phase.title = title;
    phase.points = selection.points;
    phase.group = selection.group;
    phase.regions = {{sourceFile, id}};
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
        if ((m_scene.start.inverseMass.segment(first, end - first) != 0.0).any())
            ranges.push_back({first, end - first});
    }
    return sortedRanges(std::move(ranges));
}

PointRange PhaseBuilder::trimToDynamic(PointRange points) const
{
    const auto isDynamic = [&](int point) { return m_scene.start.isDynamic(point); };
    while (points.count > 0 && !isDynamic(points.end() - 1))
        --points.count;
    while (points.count > 0 && !isDynamic(points.first))
        points = {points.first + 1, points.count - 1};
    return points;
}

bool PhaseBuilder::hasConstraint(const PhasePoints &selection) const
{
    bool any = false;
    forEach<Constraint>(selection, [&](const auto &) { any = true; });
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

std::size_t PhaseBuilder::leadingDriverCount() const
{
    const auto end = std::find_if(m_scene.effects.begin(), m_scene.effects.end(), isNoDriver);
    return static_cast<std::size_t>(end - m_scene.effects.begin());
}

template <class Accept>
void PhaseBuilder::drivers(std::size_t first, std::size_t end, double h, Accept &&accept)
{
    for (std::size_t i = first; i < end; ++i) {
        const auto found = sharedAs<Driver>(m_scene.effects[i]);
        if (found && accept(found->timing()))
            driver(found, h);
    }
}

void PhaseBuilder::leadingDrivers()
{
    drivers(0, leadingDriverCount(), m_h, [](DriverTiming) { return true; });
}

void PhaseBuilder::trailingDrivers()
{
    drivers(leadingDriverCount(), m_scene.effects.size(), m_h, [](DriverTiming) { return true; });
}

void PhaseBuilder::leadingImpulses()
{
    drivers(0, leadingDriverCount(), m_h,
            [](DriverTiming timing) { return timing == DriverTiming::impulsive; });
}

void PhaseBuilder::trailingImpulses()
{
    drivers(leadingDriverCount(), m_scene.effects.size(), m_h,
            [](DriverTiming timing) { return timing == DriverTiming::impulsive; });
}

void PhaseBuilder::continuousDrivers(double fraction)
{
    drivers(0, m_scene.effects.size(), fraction * m_h,
            [](DriverTiming timing) { return timing == DriverTiming::continuous; });
    drivers(0, m_scene.effects.size(), fraction * m_h,
            [](DriverTiming timing) { return timing == DriverTiming::dependent; });
}

void PhaseBuilder::force(const std::shared_ptr<const Force> &force, const PhasePoints &selection,
                         const ForceAccumulation &accumulation)
{
    Phase phase = phaseOf(force, selection);
    phase.regions.push_back(accumulation.forceRegion);
    appendKernel(phase, [force, add = accumulation.force, h = m_h](State &state, PointRange points) {
        add(*force, state, points, h);
    });
    if (Kernel &kernel = phase.kernels.back();
        kernel.prepareFor && accumulation.target == AccumulationTarget::acceleration)
        kernel.prepareFor = [force](const std::vector<PointRange> &ranges) {
            return [add = force->adderFor(ranges), force](State &state) { add(state, state.acceleration); };
        };
    if (const std::optional<double> gravity = force->uniformGravity();
        gravity && accumulation.target == AccumulationTarget::acceleration)
        phase.kernels.back().operation = {PointOperation::Kind::addGravity, *gravity,
                                          trimToDynamic(selection.points)};
    phase.explain = [force, directionRule = m_directionRule](const State &before, const State &after,
                                                             int point) {
        std::vector<LiveValue> live = force->explain(before, point, directionRule);
        if (!live.empty() && before.velocityOf(point) != after.velocityOf(point))
            live.push_back({"velocity", after.velocityOf(point), before.velocityOf(point)});
        return live;
    };
    m_phases.push_back(std::move(phase));
}

void PhaseBuilder::torque(const std::shared_ptr<const Torque> &torque, const PhasePoints &selection,
                          const ForceAccumulation &accumulation)
{
    Phase phase = phaseOf(torque, selection);
    phase.regions.push_back(accumulation.torqueRegion);
    appendKernel(phase, [torque, add = accumulation.torque, h = m_h](State &state, PointRange points) {
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

void PhaseBuilder::drag(const std::shared_ptr<const Drag> &drag, const PhasePoints &selection,
                        double fraction)
{
    Phase phase = phaseOf(drag, selection);
    const double h = fraction * m_h;
    appendKernel(phase, [drag, h](State &state, PointRange points) { drag->apply(state, points, h); });
    if (const std::optional<double> factor = drag->velocityFactor(selection.points, h); factor && !hasSpin())
        phase.kernels.back().operation = {PointOperation::Kind::damp, *factor,
                                          trimToDynamic(selection.points)};
    phase.explain = [drag, h](const State &before, const State &after, int point) {
        return drag->explain(before, after, point, h);
    };
    m_phases.push_back(std::move(phase));
}

void PhaseBuilder::forces(const PhasePoints &selection, const ForceAccumulation &accumulation)
{
    forEach<Force>(selection, [&](const auto &found) { force(found, selection, accumulation); });
    forEach<Torque>(selection, [&](const auto &found) { torque(found, selection, accumulation); });
}

void PhaseBuilder::accumulateForces(const PhasePoints &selection)
{
    const std::size_t before = m_phases.size();
    forces(selection, accelerationAccumulation());
    if (m_phases.size() == before)
        return;
    // Sums start from 0 in the first phase of the step, and again in the first phase of each further
    // accumulation.
    Phase &first = m_phases[m_accumulates ? before : 0];
    m_accumulates = true;
    prependKernel(first, [](State &state, PointRange points) {
        setZero(state.acceleration, points);
        if (state.angularAcceleration.rows() > 0)
            state.angularAcceleration.segment(points.first, points.count).setZero();
    });
}

void PhaseBuilder::damping(const PhasePoints &selection, double fraction)
{
    forEach<Drag>(selection, [&](const auto &found) { drag(found, selection, fraction); });
}

void PhaseBuilder::dampingWithoutRate(const PhasePoints &selection)
{
    forEach<Drag>(selection, [&](const auto &found) {
        if (!found->dampingRate(selection.points.first))
            drag(found, selection, 1.0);
    });
}

void PhaseBuilder::effectsInSceneOrder(const PhasePoints &selection, const ForceAccumulation &accumulation)
{
    for (const EffectPtr &effect : m_scene.effects) {
        if (effect->count(m_scene.start, selection.points) == 0)
            continue;
        if (const auto asForce = sharedAs<Force>(effect))
            force(asForce, selection, accumulation);
        else if (const auto asTorque = sharedAs<Torque>(effect))
            torque(asTorque, selection, accumulation);
        else if (const auto asDrag = sharedAs<Drag>(effect))
            drag(asDrag, selection, 1.0);
    }
}

std::function<void(State &, PointRange)> PhaseBuilder::savePrevious(const PhasePoints &selection) const
{
    if (!hasConstraint(selection))
        return nullptr;
    return [](State &state, PointRange points) {
        if (state.previous.rows() != state.pointCount())
            state.previous = state.position;
        state.previous.middleRows(points.first, points.count) =
            state.position.middleRows(points.first, points.count);
    };
}

void PhaseBuilder::rewindPrevious(const PhasePoints &selection)
{
    if (!hasConstraint(selection))
        return;
    m_rewindPhase = m_phases.size();
    m_rewind = [h = m_h](State &state, PointRange points) {
        if (state.previous.rows() != state.pointCount())
            state.previous = state.position;
        state.previous.middleRows(points.first, points.count) =
            state.position.middleRows(points.first, points.count) -
            h * state.velocity.middleRows(points.first, points.count);
    };
}

std::vector<Phase> PhaseBuilder::take()
{
    if (m_rewind && m_rewindPhase < m_phases.size())
        prependKernel(m_phases[m_rewindPhase], m_rewind);
    return std::move(m_phases);
}

namespace {

/// Returns the title of a phase: `whole` if it takes the whole step, else `half`.
const char *titleFor(double fraction, const char *whole, const char *half)
{
    return fraction == 1.0 ? whole : half;
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

void kickAllSpins(State &state, PointRange range, double h)
{
    const double *spin = state.spin.data(), *acceleration = state.angularAcceleration.data();
    updateDynamic(state.inverseMass, range, state.spin.data(),
                  [=](int i) { return kickSpin(spin[i], acceleration[i], h); });
}

void turnAllAngles(State &state, PointRange range, double h)
{
    const double *angle = state.angle.data(), *spin = state.spin.data();
    updateDynamic(state.inverseMass, range, state.angle.data(),
                  [=](int i) { return turn(angle[i], spin[i], h); });
}

/// Sets the velocities of `range` to the displacement of the step divided by its length.
void updateVelocities(State &state, PointRange range, double h)
{
    const XyColumns x(state.position), before(state.previous);
    updateDynamic(state.inverseMass, range, state.velocity,
                  [=](int i) { return velocityFromPositions(x.at(i), before.at(i), h); });
}

/// Calls `visit` with the part of each range that is in `points`.
template <class Visit>
void forEachIntersection(const std::vector<PointRange> &ranges, PointRange points, Visit &&visit)
{
    for (const PointRange &range : ranges) {
        if (const PointRange common = intersection(range, points); common.count > 0)
            visit(common);
    }
}

}

void PhaseBuilder::kick(const PhasePoints &selection, double fraction)
{
    bool anyForce = false, anyTorque = false;
    forEach<Force>(selection, [&](const auto &) { anyForce = true; });
    forEach<Torque>(selection, [&](const auto &) { anyTorque = true; });
    const std::vector<PointRange> ranges = movingRanges(selection.points);
    if (anyTorque)
        kickSpins(selection, fraction);
    if (!anyForce || ranges.empty())
        return;
    Phase phase = methodPhase("kick", titleFor(fraction, SIM_TEXT("kick"), SIM_TEXT("half kick")), selection);
    phase.kickFrames = fraction * m_h;
    appendKernel(phase, [ranges, h = fraction * m_h](State &state, PointRange points) {
        forEachIntersection(ranges, points, [&](PointRange range) { kickAll(state, range, h); });
    });
    if (ranges.size() == 1)
        phase.kernels.back().operation = {PointOperation::Kind::kick, fraction * m_h,
                                          trimToDynamic(ranges.front())};
    phase.explain = [](const State &before, const State &after, int point) {
        return std::vector<LiveValue>{{"v", after.velocityOf(point), before.velocityOf(point)}};
    };
    m_phases.push_back(std::move(phase));
}

void PhaseBuilder::kickSpins(const PhasePoints &selection, double fraction)
{
    Phase phase =
        methodPhase("kick_spin", titleFor(fraction, SIM_TEXT("kick"), SIM_TEXT("half kick")), selection);
    phase.kickFrames = fraction * m_h;
    appendKernel(phase, [ranges = movingRanges(selection.points), h = fraction * m_h](State &state,
                                                                                      PointRange points) {
        forEachIntersection(ranges, points, [&](PointRange range) { kickAllSpins(state, range, h); });
    });
    phase.explain = [](const State &before, const State &after, int point) {
        return std::vector<LiveValue>{{"spin", after.spin[point], before.spin[point]}};
    };
    m_phases.push_back(std::move(phase));
}

void PhaseBuilder::move(const PhasePoints &selection, double fraction)
{
    const std::vector<PointRange> ranges = movingRanges(selection.points);
    if (ranges.empty())
        return;
    if (hasSpin()) {
        turnAngles(selection, fraction);
        return;
    }
    Phase phase = methodPhase("move", titleFor(fraction, SIM_TEXT("move"), SIM_TEXT("half move")), selection);
    phase.consumesAcceleration = true;
    appendKernel(phase, [ranges, h = fraction * m_h](State &state, PointRange points) {
        forEachIntersection(ranges, points, [&](PointRange range) { moveAll(state, range, h); });
    });
    if (ranges.size() == 1)
        phase.kernels.back().operation = {PointOperation::Kind::move, fraction * m_h,
                                          trimToDynamic(ranges.front())};
    if (const auto save = savePrevious(selection))
        prependKernel(phase, save);
    phase.explain = [](const State &before, const State &after, int point) {
        return std::vector<LiveValue>{{"x", after.positionOf(point), before.positionOf(point)}};
    };
    m_phases.push_back(std::move(phase));
}

void PhaseBuilder::turnAngles(const PhasePoints &selection, double fraction)
{
    Phase phase = methodPhase("turn", titleFor(fraction, SIM_TEXT("turn"), SIM_TEXT("half turn")), selection);
    phase.consumesAcceleration = true;
    appendKernel(phase, [ranges = movingRanges(selection.points), h = fraction * m_h](State &state,
                                                                                      PointRange points) {
        forEachIntersection(ranges, points, [&](PointRange range) { turnAllAngles(state, range, h); });
    });
    phase.explain = [](const State &before, const State &after, int point) {
        return std::vector<LiveValue>{{"angle", after.angle[point], before.angle[point]}};
    };
    m_phases.push_back(std::move(phase));
}

void PhaseBuilder::constraints(const PhasePoints &selection)
{
    forEach<Constraint>(selection, [&](const std::shared_ptr<const Constraint> &constraint) {
        Phase phase = phaseOf(constraint, selection);
        appendKernel(phase,
                     [constraint, directionRule = m_directionRule, h = m_h](State &state, PointRange points) {
                         constraint->enforce(state, points, directionRule, h);
                     });
        phase.explain = [constraint](const State &before, const State &after, int point) {
            return constraint->explain(before, after, point);
        };
        m_phases.push_back(std::move(phase));
    });
    if (hasConstraint(selection))
        velocityUpdate(selection);
}

void PhaseBuilder::velocityUpdate(const PhasePoints &selection)
{
    const std::vector<PointRange> ranges = movingRanges(selection.points);
    if (ranges.empty() || hasSpin())
        return;
    Phase phase = methodPhase("velocity_update", SIM_TEXT("new velocity"), selection);
    appendKernel(phase, [ranges, h = m_h](State &state, PointRange points) {
        forEachIntersection(ranges, points, [&](PointRange range) { updateVelocities(state, range, h); });
    });
    phase.explain = [](const State &before, const State &after, int point) {
        return std::vector<LiveValue>{{"v", after.velocityOf(point), before.velocityOf(point)}};
    };
    m_phases.push_back(std::move(phase));
}

void PhaseBuilder::contacts(const PhasePoints &selection)
{
    forEach<Contact>(selection, [&](const std::shared_ptr<const Contact> &contact) {
        Phase phase = phaseOf(contact, selection);
        appendKernel(phase, [contact](State &state, PointRange points) { contact->resolve(state, points); });
        phase.explain = [](const State &before, const State &after, int point) {
            return motionChange(before, after, point);
        };
        m_phases.push_back(std::move(phase));
    });
}

}
