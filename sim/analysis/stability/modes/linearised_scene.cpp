#include "sim/analysis/stability/modes/linearised_scene.h"

#include "sim/effects/drags/damping.h"
#include "sim/methods/implicit/solvers/semidefinite.h"
#include "sim/methods/ode_system.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace sim {

namespace {

using Entries = std::vector<Jacobian::Entry>;

/// The Jacobian of an effect that is computed for these points.
struct RangeEntries
{
    PointRange points;
    Entries entries;
};

bool areEqual(PointRange a, PointRange b)
{
    return a.first == b.first && a.count == b.count;
}

const Entries &entriesOf(const std::vector<RangeEntries> &all, PointRange points)
{
    static const Entries none;
    const auto found = std::find_if(
        all.begin(), all.end(), [&](const RangeEntries &entry) { return areEqual(entry.points, points); });
    return found == all.end() ? none : found->entries;
}

/// A linearised force. It is computed for the same ranges as the original force: all points, or a group.
class LinearForce : public Force
{
public:
    explicit LinearForce(std::vector<RangeEntries> rangeEntries) : m_entries(std::move(rangeEntries)) {}
    std::string id() const override { return "linear_force"; }
    std::string title() const override { return SIM_TEXT("spring"); }
    EffectKind kind() const override { return EffectKind::spring; }
    std::vector<Region> regions(DirectionRule) const override { return {}; }
    int count(const State &, PointRange points) const override
    {
        return static_cast<int>(entriesOf(m_entries, points).size());
    }
    void add(const State &state, PointRange movers, double scale, DirectionRule,
             Eigen::ArrayX2d &into) const override
    {
        for (const Jacobian::Entry &entry : entriesOf(m_entries, movers))
            into.data()[entry.row] += scale * entry.value * state.position.data()[entry.column];
    }
    bool addJacobian(const State &, PointRange, double, DirectionRule, Jacobian &) const override
    {
        return false;
    }
    std::vector<LiveValue> explain(const State &, int, DirectionRule) const override { return {}; }

private:
    std::vector<RangeEntries> m_entries;
};

class LinearTorque : public Torque
{
public:
    explicit LinearTorque(std::vector<RangeEntries> rangeEntries) : m_entries(std::move(rangeEntries)) {}
    std::string id() const override { return "linear_torque"; }
    std::string title() const override { return SIM_TEXT("spring"); }
    EffectKind kind() const override { return EffectKind::spring; }
    std::vector<Region> regions(DirectionRule) const override { return {}; }
    int count(const State &, PointRange points) const override
    {
        return static_cast<int>(entriesOf(m_entries, points).size());
    }
    void add(const State &state, PointRange movers, double scale, Eigen::ArrayXd &into) const override
    {
        const int before = 2 * state.pointCount();
        for (const Jacobian::Entry &entry : entriesOf(m_entries, movers))
            into[entry.row - before] += scale * entry.value * state.angle[entry.column - before];
    }
    std::vector<LiveValue> explain(const State &, int) const override { return {}; }

private:
    std::vector<RangeEntries> m_entries;
};

/// Returns the entries of `jacobian` that are not 0 after projection to negative semi-definite blocks.
Entries restoringEntries(const Jacobian &jacobian, int points)
{
    Entries all = nearestNegativeSemidefiniteBlocks(jacobian, points);
    std::erase_if(all, [](const Jacobian::Entry &entry) { return entry.value == 0.0; });
    return all;
}

/// Returns the Jacobian of a force without addJacobian(), by central differences.
Jacobian finiteDifferences(const Force &force, const State &state, PointRange movers,
                           DirectionRule directionRule)
{
    Jacobian jacobian(state.pointCount());
    State moved = state;
    const auto accelerations = [&] {
        Eigen::ArrayX2d sum = Eigen::ArrayX2d::Zero(state.pointCount(), 2);
        force.add(moved, movers, 1.0, directionRule, sum);
        return sum;
    };
    for (int column = 0; column < state.pointCount(); ++column) {
        Eigen::ArrayX2d along[2];
        for (const int axis : {0, 1}) {
            double &coordinate = moved.position(column, axis);
            const double original = coordinate;
            // 1e-5 is about the cube root of the rounding unit: optimal for central differences.
            const double delta = 1e-5 * std::max(1.0, std::abs(original));
            coordinate = original + delta;
            const Eigen::ArrayX2d forward = accelerations();
            coordinate = original - delta;
            along[axis] = (forward - accelerations()) / (2.0 * delta);
            coordinate = original;
        }
        for (int row = 0; row < state.pointCount(); ++row)
            jacobian.add(row, column, along[0](row, 0), along[1](row, 0), along[0](row, 1), along[1](row, 1));
    }
    return jacobian;
}

std::vector<PointRange> forceRanges(const Scene &scene)
{
    std::vector<PointRange> ranges = {{0, scene.start.pointCount()}};
    for (const Group &group : scene.groups) {
        if (!areEqual(group.points, ranges.front()))
            ranges.push_back(group.points);
    }
    return ranges;
}

State restState(const Scene &scene, const State &state)
{
    State rest = State::ofPoints(state.pointCount());
    rest.inverseMass = state.inverseMass;
    if (scene.start.angle.rows() > 0)
        rest.angle.setZero(state.pointCount());
    if (scene.start.spin.rows() > 0)
        rest.spin.setZero(state.pointCount());
    return rest;
}

std::vector<int> rowsOf(const Scene &scene, const State &state)
{
    std::vector<int> rows;
    const int points = state.pointCount();
    const bool turns = scene.start.spin.rows() > 0;
    for (int axis = turns ? 2 : 0; axis < (turns ? 3 : 2); ++axis) {
        for (int i = 0; i < points; ++i) {
            if (scene.movesByVelocity(i) && state.isDynamic(i))
                rows.push_back(axis * points + i);
        }
    }
    return rows;
}

std::vector<double> ratesOf(const LinearisedScene &linearised)
{
    std::vector<double> rates;
    const int points = linearised.scene.start.pointCount();
    for (const int row : linearised.rows) {
        double sum = 0.0;
        for (const EffectPtr &effect : linearised.scene.effects) {
            if (const auto *drag = as<Drag>(effect))
                sum += drag->dampingRate(row % points).value_or(0.0);
        }
        rates.push_back(sum);
    }
    return rates;
}

void addForce(LinearisedScene &linearised, const EffectPtr &effect, std::vector<RangeEntries> rangeEntries)
{
    if (rangeEntries.front().entries.empty())
        return;
    for (const Jacobian::Entry &entry : rangeEntries.front().entries)
        linearised.finite = linearised.finite && std::isfinite(entry.value);
    linearised.effectJacobians.push_back({effect, rangeEntries.front().entries});
    if (as<Torque>(effect))
        linearised.scene.effects.push_back(std::make_shared<LinearTorque>(std::move(rangeEntries)));
    else
        linearised.scene.effects.push_back(std::make_shared<LinearForce>(std::move(rangeEntries)));
}

}

double LinearisedScene::minRate() const
{
    return rates.empty() ? 0.0 : *std::min_element(rates.begin(), rates.end());
}

bool LinearisedScene::hasUniformRate() const
{
    return std::adjacent_find(rates.begin(), rates.end(), std::not_equal_to<>()) == rates.end();
}

LinearisedScene linearise(const Scene &scene, const State &state, const Method &method)
{
    LinearisedScene linearised;
    linearised.scene.start = restState(scene, state);
    linearised.scene.names = scene.names;
    linearised.scene.groups = scene.groups;
    linearised.rows = rowsOf(scene, state);
    const int points = state.pointCount();
    const PointRange everything = {0, points};
    const DirectionRule directionRule = method.directionRule();
    for (const EffectPtr &effect : scene.effects) {
        if (effect->isIdle() || effect->count(state, everything) == 0)
            continue;
        const auto *force = as<Force>(effect);
        const auto *torque = as<Torque>(effect);
        const auto *drag = as<Drag>(effect);
        const auto *driver = as<Driver>(effect);
        if (force || torque) {
            std::vector<RangeEntries> rangeEntries;
            for (const PointRange range : forceRanges(scene)) {
                Jacobian jacobian(points);
                const bool hasJacobian = force
                                             ? force->addJacobian(state, range, 1.0, directionRule, jacobian)
                                             : torque->addJacobian(state, range, 1.0, jacobian);
                if (!hasJacobian && force)
                    jacobian = finiteDifferences(*force, state, range, directionRule);
                else if (!hasJacobian)
                    linearised.ignored.push_back(effect);
                rangeEntries.push_back({range, restoringEntries(jacobian, points)});
            }
            addForce(linearised, effect, std::move(rangeEntries));
        } else if (drag && hasDampingRate(*drag, everything)) {
            linearised.scene.effects.push_back(effect);
        } else if (!driver || driver->timing() == DriverTiming::impulsive) {
            linearised.ignored.push_back(effect);
        }
    }
    linearised.rates = ratesOf(linearised);
    method.prepareState(linearised.scene.start);
    return linearised;
}

LinearisedScene oscillator(const Method &method, std::complex<double> lambda, double c)
{
    const double re = lambda.real(), im = lambda.imag();
    LinearisedScene linearised;
    linearised.scene.start = State::ofPoints(1);
    linearised.scene.names = {"point"};
    linearised.scene.groups = {{"point", {0, 1}}};
    linearised.rows = im == 0.0 ? std::vector<int>{0} : std::vector<int>{0, 1};
    addForce(linearised, nullptr, {{{0, 1}, {{0, 0, re}, {0, 1, -im}, {1, 0, im}, {1, 1, re}}}});
    if (c != 0.0)
        linearised.scene.effects.push_back(std::make_shared<Damping>(std::exp(-c)));
    linearised.rates.assign(linearised.rows.size(), c);
    method.prepareState(linearised.scene.start);
    return linearised;
}

}
