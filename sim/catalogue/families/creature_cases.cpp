#include "sim/catalogue/families/families.h"
#include "sim/catalogue/scenes.h"
#include "sim/effects/drags/damping.h"
#include "sim/effects/fields/charges.h"

namespace sim::hard {

namespace {

constexpr double legStiffness = 0.2;
constexpr double legDamp = 0.85;
constexpr double radius = 50.0;

/// Returns all legs of a creature as one spring; see StiffestSpring.
StiffestSpring legsAsOne(double feet, double stretch)
{
    return {stretch, feet * legStiffness, 1.0 / feet, 1.0, legDamp};
}

/// Returns the rest in which all legs have the given length (px).
Rest legsAtLength(int feet, double length, double within)
{
    return {200, {}, {}, within, {feet, length, within}};
}

HardCase feetOnBody(const char *id, const char *title, const char *story, int feet, std::int64_t brief)
{
    HardCase hardCase = caseOf(id, title, story, creature,
                               valuesOf({{"k", legStiffness},
                                         {"damp", legDamp},
                                         {"radius", radius},
                                         {"feet", double(feet)},
                                         {"out", 150}}),
                               400);
    hardCase.brief.frames = brief;
    hardCase.requirements = {Requirement::oscillates, Requirement::comesToRest};
    if (feet >= 1000)
        hardCase.requirements.push_back(Requirement::manyPoints);
    hardCase.stiffest = legsAsOne(feet, 100.0);
    hardCase.bound.reach = 300.0;
    hardCase.rest = legsAtLength(feet, radius, 1e-3);
    return hardCase;
}

/// Returns a case of a creature whose springs have no direction at the start or at rest.
HardCase coincident(const char *id, const char *title, const char *story, Scene (*scene)(const Values &),
                    double length)
{
    const int feet = 5;
    HardCase hardCase = caseOf(
        id, title, story, scene,
        valuesOf(
            {{"k", legStiffness / 2}, {"damp", legDamp}, {"radius", length}, {"feet", feet}, {"out", 0}}),
        400);
    hardCase.requirements = {Requirement::oscillates, Requirement::comesToRest, Requirement::noDirection,
                             Requirement::centreStays};
    hardCase.stiffest = legsAsOne(feet, 100.0);
    hardCase.stiffest->k /= 2.0;
    hardCase.bound.reach = 300.0;
    hardCase.bound.drift = 1e-6;
    hardCase.rest = legsAtLength(feet, length, 1e-3);
    return hardCase;
}

HardCase squeezed()
{
    const int feet = 12;
    const double stiff = 1e6;
    HardCase hardCase = caseOf(
        "crowd_squeezed", SIM_TEXT("squeezed into one pixel"),
        SIM_TEXT("Twelve feet stand within 1 px of their body, on springs of stiffness one million that are "
                 "50 px long. Squeezed like this, they flip over at the slightest touch."),
        creature, valuesOf({{"k", stiff}, {"damp", legDamp}, {"radius", radius}, {"feet", feet}, {"out", 1}}),
        400);
    hardCase.requirements = {Requirement::oscillates, Requirement::comesToRest, Requirement::noDirection};
    hardCase.stiffest = StiffestSpring{radius, feet * stiff, 1.0 / feet, 1.0, legDamp};
    hardCase.bound.reach = 500.0;
    hardCase.rest = legsAtLength(feet, radius, 1e-3);
    return hardCase;
}

/// Returns two charges at rest at the centre. Values: charge_strength, softening, damp.
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
    HardCase hardCase = caseOf(
        "charges_in_one_place", SIM_TEXT("two charges in one place"),
        SIM_TEXT("Two like charges begin in one place, where the force between them is greatest "
                 "and has no direction."),
        chargesTogether, valuesOf({{"charge_strength", 1000}, {"softening", 10}, {"damp", legDamp}}), 400);
    hardCase.requirements = {Requirement::noDirection, Requirement::centreStays};
    hardCase.bound.reach = 200.0;
    hardCase.bound.drift = 1e-6;
    return hardCase;
}

HardCase runaway()
{
    const double spring = 0.3, keep = 0.9;
    HardCase hardCase =
        caseOf("runaway_pair", SIM_TEXT("the pair that runs away"),
               SIM_TEXT("A foot and a body pull each other, but one after the other. So the pair drives "
                        "itself forward, although nothing pushes it."),
               runawayPair, valuesOf({{"k", spring}, {"damp", keep}, {"radius", radius}}), 1000);
    hardCase.requirements = {Requirement::oscillates, Requirement::comesToRest, Requirement::centreStays};
    hardCase.stiffest = StiffestSpring{50.0, spring, 1.0, 1.0, keep};
    hardCase.bound.reach = 200.0;
    hardCase.bound.drift = 1e-6;
    hardCase.rest = legsAtLength(1, radius, 1e-6);
    return hardCase;
}

}

std::vector<HardCase> manyFeet()
{
    std::vector<HardCase> all;
    all.push_back(runaway());
    all.push_back(feetOnBody(
        "feet_60", SIM_TEXT("sixty feet"),
        SIM_TEXT("Each foot has a soft spring, but sixty together pull the body too hard for one step."), 60,
        400));
    all.push_back(feetOnBody("feet_100", SIM_TEXT("a hundred feet"),
                             SIM_TEXT("A hundred soft springs on one body make a stiff one."), 100, 400));
    all.push_back(feetOnBody("feet_1000", SIM_TEXT("a thousand feet"),
                             SIM_TEXT("A thousand feet pull one body as hard as a spring of stiffness 200."),
                             1000, 30));
    all.push_back(feetOnBody(
        "feet_10000", SIM_TEXT("ten thousand feet"),
        SIM_TEXT("Ten thousand feet pull one body as hard as a spring of stiffness 2000."), 10000, 1));
    return all;
}

std::vector<HardCase> coincidentPoints()
{
    return {
        coincident("one_place", SIM_TEXT("all in one place"),
                   SIM_TEXT("Body and feet start in the same place, where no spring has a direction."),
                   creature, radius),
        coincident("on_one_line", SIM_TEXT("all on one line"),
                   SIM_TEXT("Body and feet stand on one line, so nothing pulls them off it."), creatureOnLine,
                   radius),
        coincident(
            "no_rest_length", SIM_TEXT("springs without a length"),
            SIM_TEXT(
                "Springs of length 0 pull all points to one place, where the springs have no direction."),
            creatureOnLine, 0.0),
        squeezed(),
        chargesInOnePlace(),
    };
}

}
