#include "tests/sim/support/support.h"

#include "sim/base/error.h"
#include "sim/effects/contacts/ground.h"
#include "sim/effects/contacts/ramp.h"
#include "sim/effects/contacts/walls.h"
#include "sim/effects/drags/damping.h"
#include "sim/effects/drivers/gait_clock.h"
#include "sim/effects/drivers/steering.h"
#include "sim/effects/drivers/turn_round.h"
#include "sim/effects/fields/gravity.h"
#include "sim/effects/springs/leg_spring.h"
#include "sim/effects/springs/offset_spring.h"
#include "sim/effects/springs/push.h"
#include "sim/methods/methods.h"
#include "sim/pipeline/pipeline.h"
#include "sim/run/script/script.h"
#include "sim/simd/flush_denormals.h"

#include <complex>
#include <stdexcept>

namespace support {

namespace {

using sim::Values;
using std::make_shared;

Values values(std::initializer_list<std::pair<const char *, double>> numbers)
{
    Values all;
    for (const auto &[id, value] : numbers)
        all.set(id, value);
    return all;
}

sim::Scene springToPoint(const Values &v)
{
    return scenes::oscillator({90.0, -30.0}, scenes::centre, v["k"], v["damp"]);
}

sim::Scene beside(const Values &v)
{
    sim::Scene scene = scenes::creatureOnHandle(1);
    scatter(scene.start, 3, 150.0);
    scenes::add<sim::OffsetSpring>(scene, std::vector<sim::Link>{{0, 1}}, v["k"], v["offset"]);
    scenes::add<sim::Damping>(scene, v["damp"]);
    return scene;
}

sim::Scene creature(const Values &v)
{
    sim::Scene scene = scenes::springCreature(v.integer("feet"), v["k"], v["radius"]);
    if (v["spread"] > 0.0)
        scatter(scene.start, v.seed, v["spread"]);
    scenes::add<sim::Gravity>(scene, v["gravity"]);
    scenes::add<sim::Damping>(scene, v["damp"]);
    scenes::add<sim::Walls>(scene, sim::Room{20.0, 520.0, 380.0, 1.0}, scenes::halfWidths(scene));
    return scene;
}

sim::Scene heavyPair(const Values &v)
{
    sim::Scene scene = scenes::linearCreature(1, v["k"]);
    scatter(scene.start, 11, 200.0);
    scene.start.inverseMass << 0.5, 0.1;
    scenes::add<sim::Damping>(scene, v["damp"]);
    return scene;
}

/// Returns a creature on a ramp that ends at a wall.
sim::Scene onRamp(const Values &v)
{
    sim::Scene scene = creature(v);
    const Eigen::ArrayXd half = Eigen::ArrayXd::Constant(scene.start.pointCount(), 5.0);
    scene.effects.push_back(make_shared<sim::Ramp>(sim::inclineOf({270.0, 300.0}, 25.0, 0.5), half));
    return scene;
}

/// Returns two creatures that walk into each other and into walls. The first can be steered.
sim::Scene walkers(const Values &v)
{
    sim::Scene scene = scenes::crowd(2, 2);
    scene.names = {"foot0", "foot1", "body", "foot2", "foot3", "other"};
    scatter(scene.start, v.seed, 200.0);
    scene.start.gait.setZero(2);
    scene.start.gaitSpeed.resize(2);
    scene.start.gaitSpeed << v["speed"], -v["speed"];
    const sim::LegRule rule{v["k"], 50.0, 50.0, sim::Aim::swing, sim::Reaction::equal};
    const std::vector<sim::Leg> legs = {{0, 2, 0.0, 0}, {1, 2, 3.0, 0}, {3, 5, 0.5, 1}, {4, 5, 3.5, 1}};
    const sim::Room room{220.0, 320.0, 1e9, 0.5};
    const Eigen::ArrayXd half = Eigen::ArrayXd::Constant(6, 5.0);
    const std::vector<int> clockOf = {0, 0, 0, 1, 1, 1};
    scene.effects = {make_shared<sim::Steering>(0, 2, sim::SteeringLimits{}),
                     make_shared<sim::LegSpring>(legs, rule),
                     make_shared<sim::Push>(std::vector<int>{2, 5}, v["k"], 60.0, sim::Reaction::equal),
                     make_shared<sim::Gravity>(0.5),
                     make_shared<sim::Damping>(v["damp"]),
                     make_shared<sim::Ground>(std::vector<int>{0, 1, 3, 4},
                                              sim::GroundPlane{280.0, 0.3, sim::Traction::full}),
                     make_shared<sim::Walls>(room, half),
                     make_shared<sim::TurnRound>(room, half, clockOf),
                     make_shared<sim::GaitClock>(clockOf)};
    return scene;
}

}

const std::vector<Sample> &samples()
{
    static const std::vector<Sample> all = {
        {"spring to a point", springToPoint, values({{"k", 0.2}, {"damp", 0.9}})},
        {"beside a handle", beside, values({{"k", 0.2}, {"damp", 0.9}, {"offset", 50.0}})},
        {"heavy pair", heavyPair, values({{"k", 0.3}, {"damp", 0.95}})},
        {"creature in a room", creature,
         values({{"k", 0.2},
                 {"damp", 0.85},
                 {"radius", 50.0},
                 {"gravity", 0.5},
                 {"feet", 5},
                 {"spread", 300.0}})},
        {"creature on a ramp", onRamp,
         values({{"k", 0.2},
                 {"damp", 0.9},
                 {"radius", 50.0},
                 {"gravity", 0.5},
                 {"feet", 3},
                 {"spread", 100.0}})},
        {"walkers", walkers, values({{"k", 0.1}, {"damp", 0.9}, {"speed", 0.1}})},
        {"creature from one place", creature,
         values(
             {{"k", 0.1}, {"damp", 0.9}, {"radius", 50.0}, {"gravity", 0.0}, {"feet", 3}, {"spread", 0.0}})},
    };
    return all;
}

const Sample &sample(const std::string &name)
{
    for (const Sample &sample : samples()) {
        if (sample.name == name)
            return sample;
    }
    throw std::out_of_range(name);
}

sim::StepSize stepFor(const sim::Method &method, double h)
{
    return method.stepping() == sim::Stepping::adaptive ? sim::StepSize::withTolerance(1e-2 * h)
                                                        : sim::StepSize::ofLength(h);
}

std::vector<sim::MethodPtr> fixedMethods()
{
    std::vector<sim::MethodPtr> methods = sim::allMethods();
    std::erase_if(methods, [](const auto &method) { return method->stepping() == sim::Stepping::adaptive; });
    return methods;
}

bool fits(const sim::Scene &scene, const sim::Method &method)
{
    try {
        sim::compose(scene, method, stepFor(method, 1.0));
        return true;
    } catch (const sim::Error &) {
        return false;
    }
}

sim::Script script(const Sample &sample, const std::string &method, double h)
{
    sim::Script script;
    script.build = sample.build;
    script.values = sample.values;
    script.method = sim::findMethod(method);
    script.step = stepFor(*script.method, h);
    return script;
}

sim::Script script(const sim::Scene &scene, const std::string &method, double h)
{
    return script(Sample{{}, [scene](const Values &) { return scene; }, {}}, method, h);
}

void scatter(sim::State &state, std::uint64_t seed, double side)
{
    Dice dice(seed);
    for (int i = 0; i < state.pointCount(); ++i) {
        const double x = 270.0 + dice.real(-0.5, 0.5) * side;
        const double y = 200.0 + dice.real(-0.5, 0.5) * side;
        state.place(i, {x, y});
    }
}

sim::State plainRun(const sim::Scene &scene, const std::string &method, double h, int frames)
{
    const sim::MethodPtr rule = sim::findMethod(method);
    const sim::Pipeline pipeline = sim::compose(scene, *rule, stepFor(*rule, h));
    sim::State state = scene.start;
    rule->prepareState(state);
    const sim::FlushDenormals flush;
    for (int frame = 0; frame < frames; frame += pipeline.step.framesPerOutput) {
        state.frame = frame + pipeline.step.framesPerOutput;
        for (int i = 0; i < pipeline.phasesPerOutput(); ++i)
            pipeline.phaseAt(i).run(state);
    }
    return state;
}

double dampedOscillation(double x0, double v0, double k, double damp, double t)
{
    using Complex = std::complex<double>;
    const double c = -std::log(damp);
    const Complex root = std::sqrt(Complex(c * c / 4 - k, 0.0));
    const Complex r1 = -c / 2 + root, r2 = -c / 2 - root;
    const Complex a = (v0 - r2 * x0) / (r1 - r2);
    return (a * std::exp(r1 * t) + (x0 - a) * std::exp(r2 * t)).real();
}

double Dice::real(double low, double high)
{
    // std::uniform_real_distribution gives other numbers in other standard libraries.
    return low + (high - low) * (static_cast<double>(m_engine() >> 11) * 0x1.0p-53);
}

int Dice::whole(int low, int high)
{
    return low + static_cast<int>(m_engine() % static_cast<std::uint64_t>(high - low + 1));
}

std::string seekMismatch(const sim::Script &script, std::size_t budget, int frames, int cursors,
                         std::uint64_t seed)
{
    std::vector<std::pair<sim::Cursor, sim::State>> expected;
    sim::Track straightRun(script, 0);
    while (straightRun.cursor().frame < frames) {
        expected.emplace_back(straightRun.cursor(), straightRun.state());
        straightRun.seek({straightRun.cursor().frame, straightRun.cursor().phase + 1});
    }
    sim::Track track(script, budget);
    Dice dice(seed);
    for (int i = 0; i < cursors; ++i) {
        const auto &[cursor, state] =
            expected[static_cast<std::size_t>(dice.whole(0, static_cast<int>(expected.size()) - 1))];
        track.seek(cursor);
        const std::string found = difference(track.state(), state);
        if (track.cursor() != cursor || !found.empty()) {
            return "seek " + std::to_string(i) + " to frame " + std::to_string(cursor.frame) + " phase " +
                   std::to_string(cursor.phase) + ": " + found;
        }
    }
    return {};
}

std::string difference(const sim::State &a, const sim::State &b)
{
    if (sim::sameBits(a, b))
        return {};
    if (a.pointCount() != b.pointCount())
        return std::to_string(a.pointCount()) + " points, not " + std::to_string(b.pointCount());
    for (int i = 0; i < a.pointCount(); ++i) {
        if (a.positionOf(i) != b.positionOf(i) || a.velocityOf(i) != b.velocityOf(i))
            return "point " + std::to_string(i) + " at (" + std::to_string(a.positionOf(i).x) + ", " +
                   std::to_string(a.positionOf(i).y) + "), not (" + std::to_string(b.positionOf(i).x) + ", " +
                   std::to_string(b.positionOf(i).y) + ")";
    }
    return "mass, hold, frame, scratch or input";
}

}
