#include "sim/catalogue/families/families.h"
#include "sim/catalogue/scenes.h"

#include <cmath>

namespace sim::hard {

namespace {

/// Returns a case of sticks on which `body` hangs. It comes to rest at `rest`.
HardCase hanging(const char *id, const char *title, const char *story, Scene (*scene)(const Values &),
                 const char *body, Vec2 rest)
{
    HardCase hardCase = caseOf(id, title, story, scene, valuesOf({{"damp", 0.9}, {"gravity", 0.5}}), 600);
    hardCase.requirements = {Requirement::constraints, Requirement::comesToRest};
    hardCase.bound.reach = 200.0;
    hardCase.stickError = 0.5;
    hardCase.rest = Rest{600, {{body, rest, 0.5}}, {}, 0.01};
    return hardCase;
}

/// Returns a case of a chain that is too short by the factor `stretched`.
HardCase chain(const char *id, const char *title, const char *story, double stretched)
{
    const double links = 1000.0;
    HardCase hardCase = caseOf(
        id, title, story, stretchedChain,
        valuesOf(
            {{"links", links}, {"stretched", stretched}, {"damp", 0.9}, {"gravity", 0.0}, {"passes", 20}}),
        300);
    hardCase.brief.frames = 100;
    hardCase.requirements = {Requirement::constraints, Requirement::manyPoints};
    hardCase.bound.reach = 230.0;
    // An even share of the missing length per link. Some links have up to four times as much.
    const double shortage = 440.0 * (1.0 - 1.0 / stretched) / links;
    hardCase.stickError = 4.0 * shortage;
    return hardCase;
}

/// Returns an upper bound (px) of the length error of a link in a hanging chain. In each step, gravity moves
/// each of the N points by g h^2, and n iterations carry this to the handles. At rest, a link with the error
/// e moves its ends by e / 2 in each iteration. The sum is its tension T, so e = 2 T / n. T has two parts.
/// The vertical part is the weight that hangs below a link on one side, N g h^2 / 2 at most. The horizontal
/// part is that of a flat arc with span L and depth s, N g h^2 L / (8 s). The depth follows from the error:
/// s = L sqrt(3 e / (8 l)), where l is the length of a link.
double heavyError(double links, double linkLength, double gravity, double h, double iterations)
{
    const double weight = links * gravity * h * h;
    const double hanging = weight / iterations;
    const double flat =
        linkLength * std::pow(weight / (4.0 * std::sqrt(3.0 / 8.0) * iterations * linkLength), 2.0 / 3.0);
    return std::hypot(hanging, flat);
}

/// Returns a case of a chain under gravity, with steps of `h` frames and `iterations` over all sticks per
/// step.
HardCase heavyChain(const char *id, const char *title, const char *story, double h, double iterations)
{
    const double links = 1000.0, linkLength = 440.0 / links, gravity = 0.5;
    HardCase hardCase = caseOf(id, title, story, stretchedChain,
                               valuesOf({{"links", links},
                                         {"stretched", 1.0},
                                         {"damp", 0.9},
                                         {"gravity", gravity},
                                         {"passes", iterations}}),
                               300);
    hardCase.brief.frames = 60;
    hardCase.brief.h = hardCase.full.h = h;
    hardCase.requirements = {Requirement::constraints, Requirement::manyPoints};
    hardCase.stickError = heavyError(links, linkLength, gravity, h, iterations);
    // No point is farther from the centre than half the length of the chain.
    hardCase.bound.reach = 0.5 * links * (linkLength + *hardCase.stickError);
    return hardCase;
}

HardCase contradictorySticks()
{
    HardCase hardCase = caseOf("contradictory_triangle", SIM_TEXT("sticks that contradict each other"),
                               SIM_TEXT("Three sticks of lengths 1, 1 and 10 cannot form a triangle. "
                                        "Wherever the points move, at least one length is wrong."),
                               contradiction, valuesOf({{"damp", 0.9}}), 600);
    hardCase.requirements = {Requirement::constraints, Requirement::noDirection};
    hardCase.bound.reach = 50.0;
    hardCase.stickError = 8.0; // the complete shortage: 10 - 1 - 1
    return hardCase;
}

/// Returns a case of a swimmer. The motor counts as its stiffest spring.
HardCase swims(const char *id, const char *title, const char *story, Values values)
{
    HardCase hardCase = caseOf(id, title, story, swimmer, std::move(values), 600);
    hardCase.requirements = {Requirement::constraints, Requirement::oscillates, Requirement::driven};
    hardCase.stiffest = StiffestSpring{100.0, 0.9 * 0.25 * 0.25, 1.0, 0.0, 0.7};
    hardCase.bound.reach = 300.0;
    return hardCase;
}

/// Returns the rest with the lead at `target` and the tail 40 px away from it.
Rest atTarget(Vec2 target, double within)
{
    return {600, {{"lead", target, within}}, {{"lead", "tail", 40.0, within}}, within};
}

}

std::vector<HardCase> rigidSticks()
{
    return {
        contradictorySticks(),
        chain("chain_stretched", SIM_TEXT("a chain that is too short"),
              SIM_TEXT("A chain of a thousand links between two nails is a tenth too short, so its links "
                       "cannot keep their lengths."),
              1.1),
        heavyChain(
            "chain_heavy", SIM_TEXT("a chain too heavy for its sticks"),
            SIM_TEXT("A chain of a thousand links hangs between two nails: 20 passes a frame leave its "
                     "links much too long."),
            1.0, 20.0),
        heavyChain("chain_heavy_small_steps", SIM_TEXT("a heavy chain in small steps"),
                   SIM_TEXT("The same chain and the same work, but with 20 steps of one pass each instead of "
                            "20 passes a frame. The errors of its links are a ninth as large."),
                   1.0 / 20.0, 1.0),
        hanging("stick_without_length", SIM_TEXT("a stick without a length"),
                SIM_TEXT("Two points on a stick of length 0 have no direction between them, and a body hangs "
                         "on them."),
                noLengthStick, "p2", middle + Vec2{0.0, 60.0}),
        hanging("stick_between_nails", SIM_TEXT("a stick between two nails"),
                SIM_TEXT("A stick between two fixed points is too short, and neither point can move."),
                fixedStick, "p2", middle + Vec2{50.0, 40.0}),
    };
}

std::vector<HardCase> swimmers()
{
    HardCase through =
        swims("tail_through_lead", SIM_TEXT("the tail goes through the lead"),
              SIM_TEXT("The lead turns round and swims straight through its own tail."),
              valuesOf({{"keep", 0.7}, {"target_x", -200}, {"target_y", 200}, {"behind", 40}, {"soft", 0}}));
    through.bound.reach = 700.0;
    through.stickError = 1e-9;
    through.rest = atTarget({-200.0, 200.0}, 1e-6);
    through.requirements.insert(through.requirements.end(),
                                {Requirement::noDirection, Requirement::comesToRest});
    through.stiffest->stretch = 500.0;

    HardCase inside =
        swims("tail_in_lead", SIM_TEXT("the tail is in the lead"),
              SIM_TEXT("Lead and tail start in the same place, on a soft stick that has no direction there."),
              valuesOf({{"keep", 0.7}, {"target_x", 400}, {"target_y", 200}, {"behind", 0}, {"soft", 1}}));
    inside.rest = atTarget({400.0, 200.0}, 1e-6);
    inside.requirements.insert(inside.requirements.end(),
                               {Requirement::noDirection, Requirement::comesToRest});

    HardCase far =
        swims("target_1e9", SIM_TEXT("a target beyond the horizon"),
              SIM_TEXT("The target is a billion px away, and the motor pulls harder the farther away it is."),
              valuesOf({{"keep", 0.7}, {"target_x", 1e9}, {"target_y", -1e9}, {"behind", 40}, {"soft", 0}}));
    far.bound.reach = 3e9;
    far.stickError = 1e-5; // at 1e9 px a double has seven decimal places
    far.rest = atTarget({1e9, -1e9}, 1e-2);
    far.requirements.push_back(Requirement::comesToRest);
    far.stiffest->stretch = 1.5e9;
    return {through, inside, far};
}

}
