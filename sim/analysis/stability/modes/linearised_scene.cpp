#include "sim/analysis/stability/modes/linearised_scene.h"

#include "sim/effects/drags/damping.h"
#include "sim/methods/implicit/solvers/semidefinite.h"
#include "sim/methods/ode_system.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace sim {

namespace {

using Entries = std::vector<Slopes::Entry>;

/// The slopes of an effect as it acts on these points.
struct Acting
{
    Points on;
    Entries entries;
};

bool same(Points a, Points b)
{
    return a.first == b.first && a.count == b.count;
}

const Entries &entriesFor(const std::vector<Acting> &all, Points points)
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
    Kind kind() const override { return Kind::spring; }
    std::vector<Region> regions(Directions) const override { return {}; }
    int count(const State &, Points points) const override
    {
        return static_cast<int>(entriesFor(m_acting, points).size());
    }
    void add(const State &state, Points movers, double scale, Directions,
             Eigen::ArrayX2d &into) const override
    {
        for (const Slopes::Entry &one : entriesFor(m_acting, movers))
            into.data()[one.row] += scale * one.value * state.position.data()[one.column];
    }
    bool addSlopes(const State &, Points, double, Directions, Slopes &) const override { return false; }
    std::vector<Live> explain(const State &, int, Directions) const override { return {}; }

private:
    std::vector<Acting> m_acting;
};

class LinearTorque : public Torque
{
public:
    explicit LinearTorque(std::vector<Acting> acting) : m_acting(std::move(acting)) {}
    std::string id() const override { return "linear_torque"; }
    std::string title() const override { return SIM_TEXT("spring"); }
    Kind kind() const override { return Kind::spring; }
    std::vector<Region> regions(Directions) const override { return {}; }
    int count(const State &, Points points) const override
    {
        return static_cast<int>(entriesFor(m_acting, points).size());
    }
    void add(const State &state, Points movers, double scale, Eigen::ArrayXd &into) const override
    {
        const int before = 2 * state.points();
        for (const Slopes::Entry &one : entriesFor(m_acting, movers))
            into[one.row - before] += scale * one.value * state.angle[one.column - before];
    }
    std::vector<Live> explain(const State &, int) const override { return {}; }

private:
    std::vector<Acting> m_acting;
};

/// The entries of `slopes` that pull; those that are 0 are left out.
Entries pulling(const Slopes &slopes, int points)
{
    Entries all = negativeParts(slopes, points);
    std::erase_if(all, [](const Slopes::Entry &one) { return one.value == 0.0; });
    return all;
}

/// The slopes of a force that has none of its own: differences of what it adds, to second order.
Slopes differences(const Force &force, const State &state, Points movers, Directions way)
{
    Slopes into(state.points());
    State moved = state;
    const auto pulls = [&] {
        Eigen::ArrayX2d sum = Eigen::ArrayX2d::Zero(state.points(), 2);
        force.add(moved, movers, 1.0, way, sum);
        return sum;
    };
    for (int by = 0; by < state.points(); ++by) {
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
        for (int row = 0; row < state.points(); ++row)
            into.add(row, by, along[0](row, 0), along[1](row, 0), along[0](row, 1), along[1](row, 1));
    }
    return into;
}

std::vector<Points> sharesOf(const Scene &scene)
{
    std::vector<Points> shares = {{0, scene.start.points()}};
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
        if (!drag.rate(i))
            return false;
    }
    return true;
}

State atRest(const Scene &scene, const State &state)
{
    State rest = State::ofPoints(state.points());
    rest.inverseMass = state.inverseMass;
    if (scene.start.angle.rows() > 0)
        rest.angle.setZero(state.points());
    if (scene.start.spin.rows() > 0)
        rest.spin.setZero(state.points());
    return rest;
}

std::vector<int> rowsOf(const Scene &scene, const State &state)
{
    std::vector<int> rows;
    const int points = state.points();
    const bool turns = scene.start.spin.rows() > 0;
    for (int axis = turns ? 2 : 0; axis < (turns ? 3 : 2); ++axis) {
        for (int i = 0; i < points; ++i) {
            if (scene.hasInertia(i) && state.feels(i))
                rows.push_back(axis * points + i);
        }
    }
    return rows;
}

std::vector<double> ratesOf(const Linear &linear)
{
    std::vector<double> rates;
    const int points = linear.scene.start.points();
    for (const int row : linear.rows) {
        double sum = 0.0;
        for (const EffectPtr &effect : linear.scene.effects) {
            if (const auto *drag = as<Drag>(effect))
                sum += drag->rate(row % points).value_or(0.0);
        }
        rates.push_back(sum);
    }
    return rates;
}

void addForce(Linear &linear, const EffectPtr &effect, std::vector<Acting> acting)
{
    if (acting.front().entries.empty())
        return;
    for (const Slopes::Entry &one : acting.front().entries)
        linear.finite = linear.finite && std::isfinite(one.value);
    linear.parts.push_back({effect, acting.front().entries});
    if (as<Torque>(effect))
        linear.scene.effects.push_back(std::make_shared<LinearTorque>(std::move(acting)));
    else
        linear.scene.effects.push_back(std::make_shared<LinearForce>(std::move(acting)));
}

}

double Linear::leastRate() const
{
    return rates.empty() ? 0.0 : *std::min_element(rates.begin(), rates.end());
}

bool Linear::sameRate() const
{
    return std::adjacent_find(rates.begin(), rates.end(), std::not_equal_to<>()) == rates.end();
}

Linear linearise(const Scene &scene, const State &state, const Method &method)
{
    Linear linear;
    linear.scene.start = atRest(scene, state);
    linear.scene.names = scene.names;
    linear.scene.groups = scene.groups;
    linear.rows = rowsOf(scene, state);
    const int points = state.points();
    const Points everything = {0, points};
    const Directions way = method.directions();
    for (const EffectPtr &effect : scene.effects) {
        if (effect->idle() || effect->count(state, everything) == 0)
            continue;
        const auto *force = as<Force>(effect);
        const auto *torque = as<Torque>(effect);
        const auto *drag = as<Drag>(effect);
        const auto *driver = as<Driver>(effect);
        if (force || torque) {
            std::vector<Acting> acting;
            for (const Points share : sharesOf(scene)) {
                Slopes slopes(points);
                const bool known = force ? force->addSlopes(state, share, 1.0, way, slopes)
                                         : torque->addSlopes(state, share, 1.0, slopes);
                if (!known && force)
                    slopes = differences(*force, state, share, way);
                else if (!known)
                    linear.leftOut.push_back(effect);
                acting.push_back({share, pulling(slopes, points)});
            }
            addForce(linear, effect, std::move(acting));
        } else if (drag && hasRates(*drag, points)) {
            linear.scene.effects.push_back(effect);
        } else if (!driver || driver->pace() == Pace::once) {
            linear.leftOut.push_back(effect);
        }
    }
    linear.rates = ratesOf(linear);
    method.prepare(linear.scene.start);
    return linear;
}

Linear oscillator(const Method &method, std::complex<double> lambda, double c)
{
    const double re = lambda.real(), im = lambda.imag();
    Linear linear;
    linear.scene.start = State::ofPoints(1);
    linear.scene.names = {"point"};
    linear.scene.groups = {{"point", {0, 1}}};
    linear.rows = im == 0.0 ? std::vector<int>{0} : std::vector<int>{0, 1};
    addForce(linear, nullptr, {{{0, 1}, {{0, 0, re}, {0, 1, -im}, {1, 0, im}, {1, 1, re}}}});
    if (c != 0.0)
        linear.scene.effects.push_back(std::make_shared<Damping>(std::exp(-c)));
    linear.rates.assign(linear.rows.size(), c);
    method.prepare(linear.scene.start);
    return linear;
}

}
