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

/// The slopes of an effect as it acts on these points.
struct Acting
{
    PointRange on;
    Entries entries;
};

bool same(PointRange a, PointRange b)
{
    return a.first == b.first && a.count == b.count;
}

const Entries &entriesFor(const std::vector<Acting> &all, PointRange points)
{
    static const Entries none;
    const auto found =
        std::find_if(all.begin(), all.end(), [&](const Acting &one) { return same(one.on, points); });
    return found == all.end() ? none : found->entries;
}

/// A force near one state. It acts on the same points as the one that it comes from: all of them, or a group.
class LinearForce : public Force
{
public:
    explicit LinearForce(std::vector<Acting> acting) : m_acting(std::move(acting)) {}
    std::string id() const override { return "linear_force"; }
    std::string title() const override { return SIM_TEXT("spring"); }
    EffectKind kind() const override { return EffectKind::spring; }
    std::vector<Region> regions(DirectionRule) const override { return {}; }
    int count(const State &, PointRange points) const override
    {
        return static_cast<int>(entriesFor(m_acting, points).size());
    }
    void add(const State &state, PointRange movers, double scale, DirectionRule,
             Eigen::ArrayX2d &into) const override
    {
        for (const Jacobian::Entry &one : entriesFor(m_acting, movers))
            into.data()[one.row] += scale * one.value * state.position.data()[one.column];
    }
    bool addJacobian(const State &, PointRange, double, DirectionRule, Jacobian &) const override
    {
        return false;
    }
    std::vector<LiveValue> explain(const State &, int, DirectionRule) const override { return {}; }

private:
    std::vector<Acting> m_acting;
};

class LinearTorque : public Torque
{
public:
    explicit LinearTorque(std::vector<Acting> acting) : m_acting(std::move(acting)) {}
    std::string id() const override { return "linear_torque"; }
    std::string title() const override { return SIM_TEXT("spring"); }
    EffectKind kind() const override { return EffectKind::spring; }
    std::vector<Region> regions(DirectionRule) const override { return {}; }
    int count(const State &, PointRange points) const override
    {
        return static_cast<int>(entriesFor(m_acting, points).size());
    }
    void add(const State &state, PointRange movers, double scale, Eigen::ArrayXd &into) const override
    {
        const int before = 2 * state.pointCount();
        for (const Jacobian::Entry &one : entriesFor(m_acting, movers))
            into[one.row - before] += scale * one.value * state.angle[one.column - before];
    }
    std::vector<LiveValue> explain(const State &, int) const override { return {}; }

private:
    std::vector<Acting> m_acting;
};

/// The entries of `slopes` that pull; those that are 0 are left out.
Entries pulling(const Jacobian &jacobian, int points)
{
    Entries all = nearestNegativeSemidefiniteBlocks(jacobian, points);
    std::erase_if(all, [](const Jacobian::Entry &one) { return one.value == 0.0; });
    return all;
}

/// The slopes of a force that has none of its own: differences of what it adds, to second order.
Jacobian differences(const Force &force, const State &state, PointRange movers, DirectionRule way)
{
    Jacobian jacobian(state.pointCount());
    State moved = state;
    const auto pulls = [&] {
        Eigen::ArrayX2d sum = Eigen::ArrayX2d::Zero(state.pointCount(), 2);
        force.add(moved, movers, 1.0, way, sum);
        return sum;
    };
    for (int by = 0; by < state.pointCount(); ++by) {
        Eigen::ArrayX2d along[2];
        for (const int axis : {0, 1}) {
            double &place = moved.position(by, axis);
            const double was = place;
            const double delta =
                1e-5 * std::max(1.0, std::abs(was)); // the cube root of a double's last digit
            place = was + delta;
            const Eigen::ArrayX2d ahead = pulls();
            place = was - delta;
            along[axis] = (ahead - pulls()) / (2.0 * delta);
            place = was;
        }
        for (int row = 0; row < state.pointCount(); ++row)
            jacobian.add(row, by, along[0](row, 0), along[1](row, 0), along[0](row, 1), along[1](row, 1));
    }
    return jacobian;
}

std::vector<PointRange> sharesOf(const Scene &scene)
{
    std::vector<PointRange> shares = {{0, scene.start.pointCount()}};
    for (const Group &group : scene.groups) {
        if (!same(group.points, shares.front()))
            shares.push_back(group.points);
    }
    return shares;
}

/// A drag whose c is known for every point.
bool hasRates(const Drag &drag, int points)
{
    for (int i = 0; i < points; ++i) {
        if (!drag.dampingRate(i))
            return false;
    }
    return true;
}

State atRest(const Scene &scene, const State &state)
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

void addForce(LinearisedScene &linearised, const EffectPtr &effect, std::vector<Acting> acting)
{
    if (acting.front().entries.empty())
        return;
    for (const Jacobian::Entry &one : acting.front().entries)
        linearised.finite = linearised.finite && std::isfinite(one.value);
    linearised.parts.push_back({effect, acting.front().entries});
    if (as<Torque>(effect))
        linearised.scene.effects.push_back(std::make_shared<LinearTorque>(std::move(acting)));
    else
        linearised.scene.effects.push_back(std::make_shared<LinearForce>(std::move(acting)));
}

}

double LinearisedScene::leastRate() const
{
    return rates.empty() ? 0.0 : *std::min_element(rates.begin(), rates.end());
}

bool LinearisedScene::sameRate() const
{
    return std::adjacent_find(rates.begin(), rates.end(), std::not_equal_to<>()) == rates.end();
}

LinearisedScene linearise(const Scene &scene, const State &state, const Method &method)
{
    LinearisedScene linearised;
    linearised.scene.start = atRest(scene, state);
    linearised.scene.names = scene.names;
    linearised.scene.groups = scene.groups;
    linearised.rows = rowsOf(scene, state);
    const int points = state.pointCount();
    const PointRange everything = {0, points};
    const DirectionRule way = method.directionRule();
    for (const EffectPtr &effect : scene.effects) {
        if (effect->isIdle() || effect->count(state, everything) == 0)
            continue;
        const auto *force = as<Force>(effect);
        const auto *torque = as<Torque>(effect);
        const auto *drag = as<Drag>(effect);
        const auto *driver = as<Driver>(effect);
        if (force || torque) {
            std::vector<Acting> acting;
            for (const PointRange share : sharesOf(scene)) {
                Jacobian jacobian(points);
                const bool known = force ? force->addJacobian(state, share, 1.0, way, jacobian)
                                         : torque->addJacobian(state, share, 1.0, jacobian);
                if (!known && force)
                    jacobian = differences(*force, state, share, way);
                else if (!known)
                    linearised.ignored.push_back(effect);
                acting.push_back({share, pulling(jacobian, points)});
            }
            addForce(linearised, effect, std::move(acting));
        } else if (drag && hasRates(*drag, points)) {
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
