#include "steps.h"

#include "checks.h"
#include "lessons/api/parameters.h"
#include "parameters.h"
#include "scenes.h"
#include "sim/scene/scene.h"
#include "sim/scene/values.h"
#include "view.h"

using namespace lessons;

namespace walking_gait {

namespace {

Step newStep(const char *id)
{
    Step step = lessons::makeStep("walking_gait", id);
    step.parameters = {stiffness(), damping(), leg()};
    return step;
}

/// Returns a step whose creature walks on the ground.
Step newGroundStep(const char *id)
{
    Step step = lessons::makeStep("walking_gait", id);
    step.view = groundView;
    step.isFootDown = isPlanted;
    step.overlays = footTargets;
    step.measures = {walkingSpeed(), slip()};
    return step;
}

/// Appends the parameters that all steps on the ground share.
void addCommonParameters(Step &step)
{
    step.addParameters({lessons::gravity(), footBounce(), traction(), stiffness(0.1), damping(), leg(),
                        drop(), curve(), lessons::ground()});
}

}

Step bonesStep()
{
    Step step = newStep("bones");
    step.readTexts(bonesChecks());
    step.scene = bones::setUp;
    step.view = bonesView;
    step.overlays = boneLines;
    return step;
}

Step legsStep()
{
    Step step = newStep("legs");
    step.readTexts(legsChecks());
    step.scene = legs::setUp;
    step.view = straightLegsView;
    step.overlays = footTargets;
    return step;
}

Step feetBelowStep()
{
    Step step = newStep("feet_below");
    step.parameters.push_back(drop());
    step.readTexts(feetBelowChecks());
    step.scene = feet_below::setUp;
    step.view = straightLegsView;
    step.overlays = footTargets;
    return step;
}

Step curvedLegsStep()
{
    Step step = newStep("curved_legs");
    step.parameters.insert(step.parameters.begin(), curve()); // the topic of the step comes first
    step.addParameters({drop()});
    step.readTexts(curvedLegsChecks());
    step.scene = curved_legs::setUp;
    step.view = curvedLegsView;
    step.overlays = legControlPoints;
    return step;
}

Step swingStep()
{
    Step step = newStep("swing");
    step.addParameters({speed(), drop(), curve()});
    step.readTexts(swingChecks());
    step.scene = swing::setUp;
    step.view = curvedLegsView;
    step.overlays = targetsOnCircle;
    step.measures = {swingWidth()};
    return step;
}

Step bodyPulledStep()
{
    Step step = newStep("body_pulled");
    step.addParameters({speed(), drop(), curve()});
    step.readTexts(bodyPulledChecks());
    step.scene = body_pulled::setUp;
    step.view = curvedLegsView;
    step.overlays = centreAndTargets;
    step.measures = {momentumOfAll()};
    return step;
}

Step groundStep()
{
    Step step = newStep("ground");
    step.parameters = {speed(),        lessons::gravity(), footBounce(), traction(),
                       stiffness(0.1), damping(),          leg(),        drop(),
                       curve(),        lessons::ground()};
    step.readTexts(groundChecks());
    step.scene = walking_gait::ground::setUp;
    step.view = groundView;
    step.isFootDown = isPlanted;
    step.overlays = footTargets;
    step.measures = {walkingSpeed(), slip()};
    return step;
}

Step moreFeetStep()
{
    Step step = newGroundStep("more_feet");
    step.addParameters({legCount(), spread(), speed()});
    addCommonParameters(step);
    step.readTexts(moreFeetChecks());
    step.scene = more_feet::setUp;
    step.presets = gaits();
    return step;
}

Step steeringStep()
{
    Step step = newGroundStep("steering");
    step.addParameters({speed(), top(), change()});
    addCommonParameters(step);
    step.readTexts(steeringChecks());
    step.scene = steering::setUp;
    step.interactions = {Interaction::drag, Interaction::pointer, Interaction::keys};
    step.measures.push_back(clockSpeed());
    return step;
}

Step wallsStep()
{
    Step step = newGroundStep("walls");
    step.addParameters({atWall()});
    step.addParameters(sideWalls()); // the room is the topic of the step
    step.addParameters({speed(), top(), change()});
    addCommonParameters(step);
    step.readTexts(wallsChecks());
    step.scene = walls::setUp;
    step.view = roomView;
    step.interactions = {Interaction::drag, Interaction::pointer, Interaction::keys};
    step.measures.push_back(clockSpeed());
    return step;
}

Step companyStep()
{
    Step step = newGroundStep("company");
    step.addParameters({creatures(), push(), distance(), feltBy(), atWall(), speed()});
    step.addParameters(sideWalls());
    addCommonParameters(step);
    step.readTexts(companyChecks());
    step.scene = company::setUp;
    step.view = roomView;
    step.measures = {slip(), sumOfPushes()};
    return step;
}

}
