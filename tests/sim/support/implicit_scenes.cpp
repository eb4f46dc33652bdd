#include "tests/sim/support/implicit_scenes.h"

#include "tests/sim/support/support.h"

#include "sim/effects/drags/damping.h"
#include "sim/effects/drivers/gait_clock.h"
#include "sim/effects/fields/gravity.h"
#include "sim/effects/springs/leg_spring.h"
#include "sim/effects/springs/point_spring.h"
#include "sim/effects/springs/radial_spring.h"
#include "sim/effects/tree/joints.h"
#include "sim/effects/tree/torsion.h"
#include "sim/scenes/trees.h"

#include <complex>

namespace implicit_scenes {

namespace {

using sim::Vec2;
using Numbers = Eigen::ArrayXd;
using Accelerations = std::function<Numbers(double t, const Numbers &x)>;
using std::make_shared;

constexpr double k = 0.1;
constexpr double radius = 50.0;

/// Solves x'' = a(t, x) - c x' by the classical Runge-Kutta method in steps of 1/400 frame. Shares no code
/// with sim.
Coordinates integrate(const Accelerations &accelerations, double damp, Coordinates state, int frames)
{
    const double c = -std::log(damp);
    const auto rate = [&](double t, const Coordinates &e) {
        return Coordinates{e.v, accelerations(t, e.x) - c * e.v};
    };
    const auto moved = [](const Coordinates &e, const Coordinates &slope, double h) {
        return Coordinates{e.x + h * slope.x, e.v + h * slope.v};
    };
    constexpr int stepsPerFrame = 400;
    constexpr double h = 1.0 / stepsPerFrame;
    for (int i = 0; i < frames * stepsPerFrame; ++i) {
        const double t = i * h;
        const Coordinates a = rate(t, state);
        const Coordinates b = rate(t + h / 2, moved(state, a, h / 2));
        const Coordinates d = rate(t + h / 2, moved(state, b, h / 2));
        const Coordinates e = rate(t + h, moved(state, d, h));
        state.x += h / 6 * (a.x + 2 * b.x + 2 * d.x + e.x);
        state.v += h / 6 * (a.v + 2 * b.v + 2 * d.v + e.v);
    }
    return state;
}

/// Returns the accelerations of feet on radial springs and of their body, the last point. Both arrays hold
/// all x, then all y.
Numbers creatureAccelerations(const Numbers &x)
{
    const Eigen::Index points = x.size() / 2, body = points - 1;
    Numbers a = Numbers::Zero(x.size());
    a.tail(points) = gravity;
    for (Eigen::Index foot = 0; foot < body; ++foot) {
        const std::complex<double> d(x[body] - x[foot], x[points + body] - x[points + foot]);
        const std::complex<double> pull = k * (std::abs(d) - radius) * d / std::abs(d);
        a[foot] += pull.real();
        a[points + foot] += pull.imag();
        a[body] -= pull.real();
        a[points + body] -= pull.imag();
    }
    return a;
}

constexpr double gaitSpeed = 0.3;

/// Returns the accelerations of two feet on legs of 40 px and of their body, point 2, which feels the
/// reaction.
Numbers walkerAccelerations(double t, const Numbers &x)
{
    Numbers a = Numbers::Zero(6);
    a.tail(3) = gravity;
    for (int foot = 0; foot < 2; ++foot) {
        const double angle = 0.3 + 3.0 * foot + gaitSpeed * t;
        const double pullX = k * (x[2] - 40.0 * std::cos(angle) - x[foot]);
        const double pullY = k * (x[5] - 40.0 * std::sin(angle) + 60.0 - x[3 + foot]);
        a[foot] += pullX;
        a[3 + foot] += pullY;
        a[2] -= pullX;
        a[5] -= pullY;
    }
    return a;
}

/// Returns the solution of x'' = -k x - c x' from the roots of its characteristic polynomial.
Coordinates oscillatorEnd(const Coordinates &start, double stiffness, double damp, double t)
{
    using Complex = std::complex<double>;
    const double c = -std::log(damp);
    const Complex root = std::sqrt(Complex(c * c / 4 - stiffness, 0.0));
    const Complex r1 = -c / 2 + root, r2 = -c / 2 - root;
    Coordinates end = start;
    for (Eigen::Index i = 0; i < start.x.size(); ++i) {
        const Complex a = (start.v[i] - r2 * start.x[i]) / (r1 - r2), b = start.x[i] - a;
        end.x[i] = (a * std::exp(r1 * t) + b * std::exp(r2 * t)).real();
        end.v[i] = (a * r1 * std::exp(r1 * t) + b * r2 * std::exp(r2 * t)).real();
    }
    return end;
}

sim::TreePtr smallTree()
{
    sim::Tree tree = sim::Tree::ofTrunk(100.0);
    tree.addBranch(0, -120.0, 0.8);
    tree.addBranch(0, -65.0, 0.7);
    tree.addBranch(1, -150.0, 0.6);
    tree.addBranch(1, -95.0, 0.5);
    return make_shared<const sim::Tree>(tree);
}

/// Returns the branches of smallTree(), bent away from rest.
sim::Scene bentBranches()
{
    sim::Scene scene = scenes::branchesOf(*smallTree());
    scenes::enableSpins(scene);
    scene.start.place(0, {270, 380});
    for (int i = 0; i < scene.start.pointCount(); ++i)
        scene.start.angle[i] += 5.0 + 3.0 * i;
    return scene;
}

/// Returns a bent tree with spring joints, without wind.
sim::Scene bentTree(double damp)
{
    const sim::TreePtr tree = smallTree();
    sim::Scene scene = bentBranches();
    scenes::add<sim::Torsion>(scene, tree, sim::branchMechanicsOf(*tree, k));
    scenes::add<sim::SpinDamping>(scene, damp);
    scenes::add<sim::Joints>(scene, tree, sim::degreesPerRadian);
    return scene;
}

/// Returns the angular accelerations: each joint turns its branch back and its parent the other way.
Numbers treeAccelerations(const Numbers &angles)
{
    const sim::TreePtr tree = smallTree();
    const sim::BranchMechanics mechanics = sim::branchMechanicsOf(*tree, k);
    Numbers torque = Numbers::Zero(angles.size());
    for (int i = 0; i < tree->branchCount(); ++i) {
        const auto bend = [&](int branch) { return angles[branch] - tree->rest[std::size_t(branch)]; };
        const int parent = tree->parent[std::size_t(i)];
        const double restoring = mechanics.stiffness[i] * (bend(i) - (parent < 0 ? 0.0 : bend(parent)));
        torque[i] -= restoring;
        if (parent >= 0)
            torque[parent] += restoring;
    }
    return torque / mechanics.inertia;
}

SmoothScene smooth(std::string name, const sim::Scene &scene, double damp, const Accelerations &accelerations)
{
    const Coordinates start = coordinatesOf(scene.start);
    return {std::move(name), scene,
            [=](int frames) { return integrate(accelerations, damp, start, frames); }};
}

SmoothScene spring(std::string name, double stiffness, double damp)
{
    const sim::Scene scene = oscillator(stiffness, damp);
    const Coordinates start = coordinatesOf(scene.start);
    return {std::move(name), scene,
            [=](int frames) { return oscillatorEnd(start, stiffness, damp, frames); }};
}

}

Coordinates coordinatesOf(const sim::State &state)
{
    if (state.spin.rows() > 0)
        return {state.angle, state.spin};
    return {state.position.reshaped(), state.velocity.reshaped()};
}

double distance(const Coordinates &a, const Coordinates &b)
{
    return std::max((a.x - b.x).abs().maxCoeff(), (a.v - b.v).abs().maxCoeff());
}

const std::vector<SmoothScene> &smoothScenes()
{
    const Accelerations onCreature = [](double, const Numbers &x) { return creatureAccelerations(x); };
    const Accelerations onTree = [](double, const Numbers &x) { return treeAccelerations(x); };
    static const std::vector<SmoothScene> all = {
        spring("an underdamped spring", 0.2, 0.9),
        spring("an overdamped spring", 0.05, 0.5),
        spring("an undamped spring", 0.2, 1.0),
        smooth("a creature in the air", creature(5, 0.9), 0.9, onCreature),
        smooth("an undamped creature", creature(5, 1.0), 1.0, onCreature),
        smooth("forty feet", creature(40, 0.9), 0.9, onCreature),
        smooth("legs that swing", walker(0.9), 0.9, walkerAccelerations),
        smooth("undamped legs that swing", walker(1.0), 1.0, walkerAccelerations),
        smooth("a tree", bentTree(0.95), 0.95, onTree),
    };
    return all;
}

sim::Scene oscillator(double stiffness, double damp)
{
    sim::Scene scene = scenes::oscillator({100.0, -40.0}, {}, stiffness, damp);
    scene.start.setVelocity(0, {3.0, 8.0});
    return scene;
}

sim::Scene creature(int feet, double damp)
{
    sim::Scene scene = scenes::springCreature(feet, k, radius);
    for (int i = 0; i < feet; ++i) { // far enough from the body to stay clear of it
        const double angle = 0.4 + 2.0 * i, far = 70.0 + 5.0 * (i % 8);
        scene.start.place(i, {270.0 + far * std::cos(angle), 200.0 + far * std::sin(angle)});
        scene.start.setVelocity(i, {2.0 - i % 4, 1.0 - i % 3});
    }
    scenes::add<sim::Gravity>(scene, gravity);
    scenes::add<sim::Damping>(scene, damp);
    return scene;
}

sim::Scene walker(double damp)
{
    sim::Scene scene = scenes::creature(2);
    scene.start.place(0, {230.0, 240.0});
    scene.start.place(1, {320.0, 270.0});
    scene.start.gait.setZero(1);
    scene.start.gaitSpeed.setConstant(1, gaitSpeed);
    const std::vector<sim::Leg> legs = {{0, 2, 0.3, 0}, {1, 2, 3.3, 0}};
    scene.effects = {
        make_shared<sim::LegSpring>(legs, sim::LegRule{k, 40.0, 60.0, sim::Aim::swing, sim::Reaction::equal}),
        make_shared<sim::Gravity>(gravity), make_shared<sim::Damping>(damp), make_shared<sim::GaitClock>()};
    return scene;
}

sim::Scene hanging(double stiffness, double damp)
{
    sim::Scene scene =
        scenes::pointsAt({{290, 230}, {230, 160}, {90, 260}, {180, 260}, {200, 200}, {300, 100}});
    scene.start.inverseMass.tail(2).setZero();
    scene.groups.front().points = {0, 4};
    const std::vector<sim::Link> links = {{0, 4}, {1, 5}, {1, 3}, {3, 1}};
    scene.effects = {make_shared<sim::RadialSpring>(links, stiffness, radius),
                     make_shared<sim::PointSpring>(2, Vec2{120.0, 150.0}, stiffness),
                     make_shared<sim::Gravity>(gravity), make_shared<sim::Damping>(damp)};
    return scene;
}

sim::Scene windyTree()
{
    sim::Scene scene = bentBranches();
    scene.start.input.pointer = Vec2{150.0, 250.0};
    scene.start.input.pointerDown = true;
    scene.start.gustExtent = {500.0, 0.0};
    scenes::addSway(scene, smallTree(), {.k = k, .damp = 0.95, .front = 12.0, .wind = 8.0, .gusts = 0.4});
    return scene;
}

}
