#include "sim/methods/ode_system.h"

#include "sim/simd/point_kernels.h"

#include <algorithm>
#include <cmath>

namespace sim {

namespace {

int countOf(const std::vector<Points> &runs)
{
    int count = 0;
    for (const Points &run : runs)
        count += run.count;
    return count;
}

/// The c of each point of `runs`, added up over the drags that have one.
std::vector<double> ratesOf(const Scene &scene, const std::vector<Points> &runs)
{
    std::vector<double> rates(static_cast<std::size_t>(countOf(runs)), 0.0);
    for (const EffectPtr &effect : scene.effects) {
        const auto *drag = as<Drag>(effect);
        std::size_t row = 0;
        for (const Points &run : runs) {
            for (int i = run.first; drag && i < run.end(); ++i)
                rates[row++] += drag->rate(i).value_or(0.0);
        }
    }
    return rates;
}

/// The one finite rate among the points that go on by themselves; 0 if there is none.
std::optional<double> oneOf(const std::vector<double> &rates, const std::vector<char> &inert)
{
    std::optional<double> found;
    for (std::size_t i = 0; i < rates.size(); ++i) {
        if (!inert[i] || std::isinf(rates[i]))
            continue;
        if (found && *found != rates[i])
            return {};
        found = rates[i];
    }
    return found.value_or(0.0);
}

/// The effects of a kind that work on points of `runs`.
template <class Type>
std::vector<std::shared_ptr<const Type>> all(const Scene &scene, const std::vector<Points> &runs)
{
    std::vector<std::shared_ptr<const Type>> found;
    for (const EffectPtr &effect : scene.effects) {
        const auto typed = shared<Type>(effect);
        const auto works = [&](Points run) { return typed->count(scene.start, run) > 0; };
        if (typed && std::any_of(runs.begin(), runs.end(), works))
            found.push_back(typed);
    }
    return found;
}

bool hasRates(const Drag &drag, const std::vector<Points> &runs)
{
    for (const Points &run : runs) {
        for (int i = run.first; i < run.end(); ++i) {
            if (!drag.rate(i))
                return false;
        }
    }
    return true;
}

/// As loops, which are quicker for a few numbers than a call of memcpy: see sim/CMakeLists.txt.
void copy(const double *from, int count, double *into)
{
    for (int i = 0; i < count; ++i)
        into[i] = from[i];
}

/// The numbers of `run` in both columns, to and from rows of q that lie `apart`.
void copy(const Eigen::ArrayX2d &columns, Points run, double *row, int apart)
{
    copy(&columns(run.first, 0), run.count, row);
    copy(&columns(run.first, 1), run.count, row + apart);
}
void copy(const double *row, int apart, Eigen::ArrayX2d &columns, Points run)
{
    copy(row, run.count, &columns(run.first, 0));
    copy(row + apart, run.count, &columns(run.first, 1));
}

}

Flow::Flow(const Scene &scene, Directions directions) : Flow(scene, directions, {{0, scene.start.points()}})
{
}

Flow::Flow(const Scene &scene, Directions directions, std::vector<Points> runs)
    : m_directions(directions), m_runs(std::move(runs)), m_points(countOf(m_runs)),
      m_spins(scene.start.spin.rows() > 0 ? m_points : 0), m_size(2 * m_points + m_spins),
      m_forces(all<Force>(scene, m_runs)), m_torques(all<Torque>(scene, m_runs))
{
    forEach([&](int point, int) {
        m_inert.push_back(scene.hasInertia(point));
        if (!m_inert.back())
            m_idle.push_back(point);
    });
    for (const auto &force : m_forces)
        m_pulls.push_back(force->part(m_runs));
    const std::vector<double> rates = ratesOf(scene, m_runs);
    for (int row = 0; row < m_size; ++row) {
        const double rate = rates[static_cast<std::size_t>(row % m_points)];
        if (m_stretches.empty() || m_stretches.back().rate != rate)
            m_stretches.push_back({row, 0, rate});
        ++m_stretches.back().count;
    }
    m_oneRate = oneOf(rates, m_inert);
    for (const auto &driver : all<Driver>(scene, {{0, scene.start.points()}})) {
        if (driver->pace() == Pace::flows)
            m_flowing.push_back(driver);
        else if (driver->pace() == Pace::follows)
            m_following.push_back(driver);
    }
    listEffects(scene);
}

void Flow::listEffects(const Scene &scene)
{
    for (const EffectPtr &effect : scene.effects) {
        const auto *driver = as<Driver>(effect);
        const auto *drag = as<Drag>(effect);
        if (as<Force>(effect) || as<Torque>(effect) || (driver && driver->pace() != Pace::once) ||
            (drag && hasRates(*drag, m_runs)))
            m_effects.push_back(effect);
    }
}

EffectPtr Flow::firstJump(const Scene &scene, Contacts contacts)
{
    const Points everything = {0, scene.start.points()};
    for (const EffectPtr &effect : scene.effects) {
        if (effect->count(scene.start, everything) == 0)
            continue;
        const auto *driver = as<Driver>(effect);
        const auto *drag = as<Drag>(effect);
        const bool contact = as<Contact>(effect);
        if (as<Constraint>(effect) || (driver && driver->pace() == Pace::once) ||
            (drag && !hasRates(*drag, {everything})) || (contact && contacts == Contacts::doNotFit))
            return effect;
    }
    return nullptr;
}

int Flow::pointAt(int row) const
{
    for (const Points &run : m_runs) {
        if (row < run.count)
            return run.first + row;
        row -= run.count;
    }
    return -1;
}

void Flow::read(const State &state, double *q, double *v) const
{
    forEachRun([&](Points run, int row) {
        copy(state.position, run, q + row, m_points);
        copy(state.velocity, run, v + row, m_points);
        if (m_spins > 0) {
            copy(&state.angle[run.first], run.count, q + 2 * m_points + row);
            copy(&state.spin[run.first], run.count, v + 2 * m_points + row);
        }
    });
    forEach([&](int point, int row) {
        if (goesOn(state, point, row))
            return;
        v[row] = v[m_points + row] = 0.0;
        if (m_spins > 0)
            v[2 * m_points + row] = 0.0;
    });
}

void Flow::place(const double *q, State &state) const
{
    forEachRun([&](Points run, int row) {
        if (m_spins > 0) {
            copy(q + 2 * m_points + row, run.count, &state.angle[run.first]);
            return;
        }
        copy(q + row, m_points, state.position, run);
    });
    follow(state);
}

void Flow::push(const double *v, State &state) const
{
    forEach([&](int point, int row) {
        if (!goesOn(state, point, row))
            return;
        state.velocity(point, 0) = v[row];
        state.velocity(point, 1) = v[m_points + row];
        if (m_spins > 0)
            state.spin[point] = v[2 * m_points + row];
    });
}

void Flow::clear(State &state) const
{
    for (const Points &run : m_runs) {
        sim::clear(state.acceleration, run);
        if (m_spins > 0)
            state.turning.segment(run.first, run.count).setZero();
    }
}

void Flow::accelerations(State &state, double *a) const
{
    clear(state);
    for (const AddPart &pull : m_pulls)
        pull(state, state.acceleration);
    for (const auto &torque : m_torques) {
        for (const Points &run : m_runs)
            torque->add(state, run, 1.0, state.turning);
    }
    gathered(state, a);
}

void Flow::pull(const Force &force, State &state, double *a) const
{
    clear(state);
    for (const Points &run : m_runs)
        force.add(state, run, 1.0, m_directions, state.acceleration);
    take(state, a);
}

void Flow::take(const State &state, double *a) const
{
    forEachRun([&](Points run, int row) {
        copy(state.acceleration, run, a + row, m_points);
        if (m_spins > 0)
            copy(&state.turning[run.first], run.count, a + 2 * m_points + row);
    });
}

void Flow::gathered(State &state, double *a) const
{
    for (const int idle : m_idle) {
        state.acceleration.row(idle).setZero();
        if (m_spins > 0)
            state.turning[idle] = 0.0;
    }
    take(state, a);
}

bool Flow::slopes(const State &state, Slopes &into) const
{
    bool known = true;
    for (const Points &run : m_runs) {
        for (const auto &force : m_forces)
            known = force->addSlopes(state, run, 1.0, m_directions, into) && known;
        for (const auto &torque : m_torques)
            known = torque->addSlopes(state, run, 1.0, into) && known;
    }
    return known;
}

void Flow::tick(State &state, double h) const
{
    for (const auto &driver : m_flowing)
        driver->drive(state, h);
}

void Flow::follow(State &state) const
{
    for (const auto &driver : m_following)
        driver->drive(state, 0.0);
}

void Flow::prepare(State &state) const
{
    state.acceleration.setZero(state.points(), 2);
    state.turning.setZero(state.spin.rows());
}

}
