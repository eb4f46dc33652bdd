#include "tests/sim/support/study_scenes.h"

#include "sim/effects/drags/damping.h"
#include "sim/effects/springs/point_spring.h"
#include "sim/pipeline/method.h"
#include "sim/scene/scene.h"
#include <cmath>

namespace support {

using namespace sim;

namespace {

constexpr double stiffness = 0.2, damp = 0.97;
const Vec2 ballX = {90.0, -30.0}, ballV = {4.0, -7.0};

}

const StudyProgress keepGoing = [](const Accuracy &, double) { return true; };

StudyPlan quickPlan(std::int64_t frames)
{
    StudyPlan plan;
    plan.frames = frames;
    plan.secondsOfTiming = 0.0;
    return plan;
}

Script scriptOf(const Scene &scene, const MethodSetup &setup)
{
    Script script = support::script(scene, setup.method->id());
    script.step = setup.step;
    return script;
}

Script scriptOf(const Scene &scene)
{
    return support::script(scene, "published");
}

std::string nameOf(const AccuracyRow &row)
{
    const StepSize step = row.setup.step;
    return row.setup.method->id() + " " + std::to_string(step.isAdaptive() ? step.tolerance : step.h);
}

Scene dampedSpring()
{
    Scene scene = scenes::oscillator(ballX, anchor, stiffness, damp);
    scene.start.setVelocity(0, ballV);
    return scene;
}

Vec2 dampedSpringAt(double t)
{
    const double c = -std::log(damp), w = std::sqrt(stiffness - c * c / 4.0);
    const Vec2 away = ballX - anchor;
    const Vec2 swing = (1.0 / w) * (ballV + (c / 2.0) * away);
    return anchor + std::exp(-c * t / 2.0) * (std::cos(w * t) * away + std::sin(w * t) * swing);
}

}
