#include "sim/catalogue/families/families.h"
#include "sim/catalogue/scenes.h"
#include "sim/effects/drags/damping.h"
#include "sim/effects/fields/charges.h"

namespace sim::hard {

namespace {

constexpr double k = 0.2;
constexpr double damp = 0.85;
constexpr double radius = 50.0;

/// All legs of a creature as one spring; see Stiffest.
StiffestSpring legsAsOne(double feet, double apart)
{
    return {apart, feet * k, 1.0 / feet, 1.0, damp};
}

Rest legsRight(int feet, double length, double within)
{
    Rest rest;
    for (int i = 0; i < feet; ++i)
        rest.distances.push_back({"foot" + std::to_string(i), "body", length, within});
    rest.speed = within;
    rest.after = 200;
    return rest;
}

HardCase feetOnBody(const char *id, const char *title, const char *story, int feet, std::int64_t brief)
{
    HardCase one = caseOf(
        id, title, story, creature,
        valuesOf({{"k", k}, {"damp", damp}, {"radius", radius}, {"feet", double(feet)}, {"out", 150}}), 400);
    one.brief.frames = brief;
    one.requirements = {Requirement::oscillates, Requirement::comesToRest};
    if (feet >= 1000)
        one.requirements.push_back(Requirement::manyPoints);
    one.stiffest = legsAsOne(feet, 100.0);
    one.bound.reach = 300.0;
    one.rest = legsRight(feet, radius, 1e-3);
    return one;
}

HardCase cramped(const char *id, const char *title, const char *story, Scene (*scene)(const Values &),
                 double length)
{
    const int feet = 5;
    HardCase one =
        caseOf(id, title, story, scene,
               valuesOf({{"k", k / 2}, {"damp", damp}, {"radius", length}, {"feet", feet}, {"out", 0}}), 400);
    one.requirements = {Requirement::oscillates, Requirement::comesToRest, Requirement::noDirection,
                        Requirement::centreStays};
    one.stiffest = legsAsOne(feet, 100.0);
    one.stiffest->k /= 2.0;
    one.bound.reach = 300.0;
    one.bound.drift = 1e-6;
    one.rest = legsRight(feet, length, 1e-3);
    return one;
}

HardCase squeezed()
{
    const int feet = 12;
    const double stiff = 1e6;
    HardCase one = caseOf(
        "crowd_squeezed", SIM_TEXT("pressed into one px"),
        SIM_TEXT(
            "Twelve feet stand within 1 px of their body, on springs of stiffness a million that are 50 px "
            "long: pressed together they turn over at a touch."),
        creature, valuesOf({{"k", stiff}, {"damp", damp}, {"radius", radius}, {"feet", feet}, {"out", 1}}),
        400);
    one.requirements = {Requirement::oscillates, Requirement::comesToRest, Requirement::noDirection};
    one.stiffest = StiffestSpring{radius, feet * stiff, 1.0 / feet, 1.0, damp};
    one.bound.reach = 500.0;
    one.rest = legsRight(feet, radius, 1e-3);
    return one;
}

/// Two charges at rest in the middle. Values: charge_strength, softening, damp.
Scene chargesTogether(const Values &values)
{
    Scene scene = scenes::pointsAt({middle, middle});
    scenes::add<Charges>(scene, Eigen::ArrayXd(Eigen::ArrayXd::Ones(2)), values["charge_strength"],
                         values["softening"]);
    scenes::add<Damping>(scene, values["damp"]);
    return scene;
}

HardCase chargesInOnePlace()
{
    HardCase one = caseOf(
        "charges_in_one_place", SIM_TEXT("two charges in one place"),
        SIM_TEXT("Two like charges begin in one place, where the force between them is greatest "
                 "and has no direction."),
        chargesTogether, valuesOf({{"charge_strength", 1000}, {"softening", 10}, {"damp", damp}}), 400);
    one.requirements = {Requirement::noDirection, Requirement::centreStays};
    one.bound.reach = 200.0;
    one.bound.drift = 1e-6;
    return one;
}

HardCase runaway()
{
    const double spring = 0.3, keep = 0.9;
    HardCase one = caseOf(
        "runaway_pair", SIM_TEXT("the pair that runs away"),
        SIM_TEXT("A foot and a body pull each other, but one after the other: so the pair drives itself on, "
                 "though nothing pushes it."),
        runawayPair, valuesOf({{"k", spring}, {"damp", keep}, {"radius", radius}}), 1000);
    one.requirements = {Requirement::oscillates, Requirement::comesToRest, Requirement::centreStays};
    one.stiffest = StiffestSpring{50.0, spring, 1.0, 1.0, keep};
    one.bound.reach = 200.0;
    one.bound.drift = 1e-6;
    one.rest = legsRight(1, radius, 1e-6);
    return one;
}

}

std::vector<HardCase> manyFeet()
{
    return {
        runaway(),
        feetOnBody("feet_60", SIM_TEXT("sixty feet"),
                   SIM_TEXT("Each foot alone is soft, but sixty together pull the body too hard for a step."),
                   60, 400),
        feetOnBody("feet_100", SIM_TEXT("a hundred feet"),
                   SIM_TEXT("A hundred soft springs on one body make a stiff one."), 100, 400),
        feetOnBody("feet_1000", SIM_TEXT("a thousand feet"),
                   SIM_TEXT("A thousand feet pull one body as hard as a spring of stiffness 200."), 1000, 30),
        feetOnBody("feet_10000", SIM_TEXT("ten thousand feet"),
                   SIM_TEXT("Ten thousand feet pull one body as hard as a spring of stiffness 2000."), 10000,
                   1),
    };
}

std::vector<HardCase> crampedPlaces()
{
    return {
        cramped("one_place", SIM_TEXT("all in one place"),
                SIM_TEXT("Body and feet begin in one place, where no spring has a direction."), creature,
                radius),
        cramped("on_one_line", SIM_TEXT("all on one line"),
                SIM_TEXT("Body and feet stand in line, so nothing pulls them off it."), creatureOnLine,
                radius),
        cramped(
            "no_rest_length", SIM_TEXT("springs without a length"),
            SIM_TEXT("Springs of length 0 pull all points into one place, where their directions are lost."),
            creatureOnLine, 0.0),
        squeezed(),
        chargesInOnePlace(),
    };
}

}
