#include "tests/sim/support/stability_scenes.h"

#include "tests/sim/support/support.h"

#include "sim/effects/drags/damping.h"
#include "sim/effects/springs/body_spring.h"
#include "sim/effects/springs/point_spring.h"
#include "sim/effects/tree/torsion.h"
#include "sim/methods/methods.h"
#include "sim/scenes/trees.h"

#include <cmath>

namespace stability_scenes {

namespace {

using namespace sim;
using scenes::centre;
using std::make_shared;

constexpr double radius = 50.0;       // px
constexpr double disturbance = 1e-5;  // px
constexpr double decisiveRatio = 1e8; // factor of energy that decides between growth and decay

double kineticEnergy(const State &state)
{
    return 0.5 * state.velocity.square().sum();
}

double pairEnergy(const State &state, int a, int b, double rest)
{
    const double extension = length(state.positionOf(a) - state.positionOf(b)) - rest;
    return 0.5 * extension * extension;
}

double anchorEnergy(const State &state, int point, Vec2 place)
{
    const double extension = length(state.positionOf(point) - place);
    return 0.5 * extension * extension;
}

}

OscillatingScene onePoint(double k, double damp)
{
    return {scenes::oscillator(centre, centre, k, damp),
            [=](const State &state) { return kineticEnergy(state) + k * anchorEnergy(state, 0, centre); }};
}

OscillatingScene chain(int count, double k, double damp)
{
    Scene scene = scenes::creature(count - 1); // all springs are slack there
    scene.effects = {make_shared<PointSpring>(0, centre, k), make_shared<PointSpring>(count - 1, centre, k),
                     make_shared<BodySpring>(scenes::chainLinks(count), k), make_shared<Damping>(damp)};
    return {scene, [=](const State &state) {
                double sum = anchorEnergy(state, 0, centre) + anchorEnergy(state, count - 1, centre);
                for (int i = 0; i + 1 < count; ++i)
                    sum += pairEnergy(state, i, i + 1, 0.0);
                return kineticEnergy(state) + k * sum;
            }};
}

OscillatingScene creature(int feet, double k, double damp)
{
    Scene scene = scenes::springCreature(feet, k, radius);
    for (int i = 0; i < feet; ++i) {
        const double angle = 6.283185307179586 * (i + 0.3) / feet;
        scene.start.place(i, centre + radius * Vec2{std::cos(angle), std::sin(angle)});
    }
    scenes::add<Damping>(scene, damp);
    return {scene, [=](const State &state) {
                double sum = 0.0;
                for (int i = 0; i < feet; ++i)
                    sum += pairEnergy(state, i, feet, radius);
                return kineticEnergy(state) + k * sum;
            }};
}

OscillatingScene bundle(int feet, double k, double damp)
{
    Scene scene = scenes::linearCreature(feet, k);
    scenes::add<Damping>(scene, damp);
    return {scene, [=](const State &state) {
                double sum = 0.0;
                for (int i = 0; i < feet; ++i)
                    sum += pairEnergy(state, i, feet, 0.0);
                return kineticEnergy(state) + k * sum;
            }};
}

OscillatingScene uneven()
{
    OscillatingScene result = chain(4, 0.3, 0.95);
    result.scene.start.inverseMass << 1.0, 0.25, 2.0, 1.0;
    result.scene.effects.push_back(make_shared<Damping>(0.8, PointRange{1, 1}));
    return result;
}

OscillatingScene manyFeet()
{
    const int feet = 20;
    OscillatingScene result = creature(feet, 0.2, 0.85);
    for (int i = 0; i < feet; ++i)
        result.scene.start.inverseMass[i] = 0.5 + 0.05 * i;
    return result;
}

OscillatingScene tree(double k, double damp)
{
    Tree grown = Tree::ofTrunk(100.0);
    grown.addBranch(0, -120.0, 0.7);
    grown.addBranch(0, -55.0, 0.8);
    grown.addBranch(1, -150.0, 0.5);
    const auto shared = make_shared<const Tree>(grown);
    Scene scene = scenes::branchesOf(grown);
    scenes::enableSpins(scene);
    scene.effects = {make_shared<Torsion>(shared, branchMechanicsOf(grown, k)),
                     make_shared<SpinDamping>(damp)};
    const Eigen::ArrayXd rest = scene.start.angle;
    return {scene, [rest](const State &state) {
                return state.spin.square().sum() + (state.angle - rest).square().sum();
            }};
}

const std::vector<const char *> &explicitMethods()
{
    static const std::vector<const char *> all = {
        "explicit_euler", "semi_implicit_euler", "position_verlet", "velocity_verlet", "midpoint", "rk4",
        "published"};
    return all;
}

Stability predicted(const Scene &scene, const std::string &method, double h)
{
    return stabilityOf(scene, scene.start, *findMethod(method), h);
}

bool grows(const OscillatingScene &oscillating, const std::string &method, double h, int steps)
{
    const MethodPtr with = findMethod(method);
    const Pipeline pipeline = compose(oscillating.scene, *with, {h, 1, 1, 0.0});
    State state = oscillating.scene.start;
    with->prepareState(state);
    support::Dice dice(7);
    for (int i = 0; i < state.pointCount(); ++i) {
        state.place(i, state.positionOf(i) + disturbance * Vec2{dice.real(-1, 1), dice.real(-1, 1)});
        if (state.spin.rows() > 0)
            state.angle[i] += disturbance * dice.real(-1, 1);
    }
    const double start = oscillating.energy(state);
    double early = 0.0, late = 0.0; // largest energy in the fifth tenth and in the last tenth of the steps
    for (int i = 0; i < steps; ++i) {
        for (const Phase &phase : pipeline.phases)
            phase.run(state);
        const double energy = oscillating.energy(state);
        if (!std::isfinite(energy) || energy > decisiveRatio * start)
            return true;
        if (energy < start / decisiveRatio)
            return false;
        if (i >= 4 * steps / 10 && i < steps / 2)
            early = std::max(early, energy);
        if (i >= steps - steps / 10)
            late = std::max(late, energy);
    }
    return late > 1.2 * early;
}

double onset(const OscillatingScene &oscillating, const std::string &method, double from)
{
    double stable = from, unstable = from;
    for (int i = 0; i < 400 && !grows(oscillating, method, unstable); ++i) {
        stable = unstable;
        unstable *= 1.04;
    }
    for (int i = 0; i < 8; ++i) {
        const double middle = 0.5 * (stable + unstable);
        (grows(oscillating, method, middle) ? unstable : stable) = middle;
    }
    return 0.5 * (stable + unstable);
}

const Remedy *findRemedy(const std::vector<Remedy> &all, Remedy::Kind kind)
{
    for (const Remedy &remedy : all) {
        if (remedy.kind == kind)
            return &remedy;
    }
    return nullptr;
}

}
