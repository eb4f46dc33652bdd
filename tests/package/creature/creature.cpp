// A creature of one body and two feet falls for ten frames. Uses the installed simulation core only.

#include "sim/effects/drags/damping.h"
#include "sim/effects/fields/gravity.h"
#include "sim/effects/springs/radial_spring.h"
#include "sim/methods/methods.h"
#include "sim/pipeline/run_step.h"

#include <cstdio>
#include <memory>
#include <vector>

int main()
{
    sim::Scene scene;
    scene.start = sim::State::ofPoints(3);
    scene.names = {"foot0", "foot1", "body"};
    scene.start.place(0, {200, 100});
    scene.start.place(1, {340, 100});
    scene.start.place(2, {270, 60});
    scene.groups = {{"points", {0, 3}}};
    const std::vector<sim::Link> legs = {{0, 2}, {1, 2}, {2, 0}, {2, 1}};
    scene.effects = {std::make_shared<sim::RadialSpring>(legs, 0.2, 50.0),
                     std::make_shared<sim::Gravity>(0.5), std::make_shared<sim::Damping>(0.9)};

    const sim::MethodPtr method = sim::findMethod("semi_implicit_euler");
    const sim::Pipeline pipeline = sim::compose(scene, *method, sim::StepSize::ofLength(1.0));
    sim::State state = scene.start;
    method->prepareState(state);
    for (state.frame = 1; state.frame <= 10; ++state.frame) {
        sim::runStep(pipeline, state);
        for (int point = 0; point < state.pointCount(); ++point) {
            std::printf("%d,%s,%.6f,%.6f\n", static_cast<int>(state.frame), scene.names[point].c_str(),
                        state.positionOf(point).x, state.positionOf(point).y);
        }
    }
}
