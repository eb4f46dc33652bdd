#include "sim/catalogue/families/families.h"
#include "sim/catalogue/scenes.h"

#include <cmath>

namespace sim::hard {

namespace {

HardCase hanging(const char *id, const char *title, const char *story, Scene (*scene)(const Values &),
                 const char *body, Vec2 rest)
{
    HardCase one = caseOf(id, title, story, scene, valuesOf({{"damp", 0.9}, {"gravity", 0.5}}), 600);
    one.requirements = {Requirement::constraints, Requirement::comesToRest};
    one.bound.reach = 200.0;
    one.stickError = 0.5;
    one.rest = Rest{600, {{body, rest, 0.5}}, {}, 0.01};
    return one;
}

HardCase chain(const char *id, const char *title, const char *story, double stretched)
{
    const double links = 1000.0;
    HardCase one = caseOf(
        id, title, story, stretchedChain,
        valuesOf(
            {{"links", links}, {"stretched", stretched}, {"damp", 0.9}, {"gravity", 0.0}, {"passes", 20}}),
        300);
    one.brief.frames = 100;
    one.requirements = {Requirement::constraints, Requirement::manyPoints};
    one.bound.reach = 230.0;
    // What is missing in all, shared out evenly, and three times that for links next to where it is shared out.
    const double missing = 440.0 * (1.0 - 1.0 / stretched) / links;
    one.stickError = 4.0 * missing;
    return one;
}

/// How wrong a link of a hanging chain can be, in px. In each step gravity moves each point by g h^2, and the sweeps
/// must carry that to the nails: at rest a link whose error is e moves its ends by e / 2 in each of n sweeps, and that
/// adds up to its tension T; so e = 2 T / n. T is what hangs below a link on one side, N g h^2 / 2 at most, and what
/// stretches the chain across its span L: of a flat arc of depth s, N g h^2 L / 8 s, where the depth comes from the
/// error itself, s = L sqrt(3 e / 8 l) at a link length l.
double heavyError(double links, double each, double gravity, double h, double passes)
{
    const double weight = links * gravity * h * h;
    const double hanging = weight / passes;
    const double flat = each * std::pow(weight / (4.0 * std::sqrt(3.0 / 8.0) * passes * each), 2.0 / 3.0);
    return std::hypot(hanging, flat);
}

HardCase heavyChain(const char *id, const char *title, const char *story, double h, double passes)
{
    const double links = 1000.0, each = 440.0 / links, gravity = 0.5;
    HardCase one = caseOf(
        id, title, story, stretchedChain,
        valuesOf(
            {{"links", links}, {"stretched", 1.0}, {"damp", 0.9}, {"gravity", gravity}, {"passes", passes}}),
        300);
    one.brief.frames = 60;
    one.brief.h = one.full.h = h;
    one.requirements = {Requirement::constraints, Requirement::manyPoints};
    one.stickError = heavyError(links, each, gravity, h, passes);
    // No point is farther from the middle than half the chain is long.
    one.bound.reach = 0.5 * links * (each + *one.stickError);
    return one;
}

HardCase contradictorySticks()
{
    HardCase one = caseOf(
        "contradictory_triangle", SIM_TEXT("sticks that contradict each other"),
        SIM_TEXT("Three sticks of lengths 1, 1 and 10 make no triangle: whatever moves, one is wrong."),
        contradiction, valuesOf({{"damp", 0.9}}), 600);
    one.requirements = {Requirement::constraints, Requirement::noDirection};
    one.bound.reach = 50.0;
    one.stickError = 8.0; // all of what is missing
    return one;
}

HardCase swims(const char *id, const char *title, const char *story, Values values)
{
    HardCase one = caseOf(id, title, story, swimmer, std::move(values), 600);
    one.requirements = {Requirement::constraints, Requirement::oscillates, Requirement::driven};
    one.stiffest = StiffestSpring{100.0, 0.9 * 0.25 * 0.25, 1.0, 0.0, 0.7};
    one.bound.reach = 300.0;
    return one;
}

/// The lead comes to rest at the target, and the tail 40 px from it.
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
              SIM_TEXT("A chain of a thousand links between two nails is a tenth too short: no link can be "
                       "right."),
              1.1),
        heavyChain(
            "chain_heavy", SIM_TEXT("a chain too heavy for its sticks"),
            SIM_TEXT("A chain of a thousand links hangs between two nails: 20 passes a frame leave its "
                     "links much too long."),
            1.0, 20.0),
        heavyChain("chain_heavy_small_steps", SIM_TEXT("a heavy chain in small steps"),
                   SIM_TEXT("The same chain and the same work: in place of 20 passes a frame 20 steps of one "
                            "pass each. Its links err a ninth as much."),
                   1.0 / 20.0, 1.0),
        hanging("stick_without_length", SIM_TEXT("a stick without a length"),
                SIM_TEXT("Two points on a stick of length 0 have no direction between them, and a body hangs "
                         "on them."),
                noLengthStick, "p2", middle + Vec2{0.0, 60.0}),
        hanging("stick_between_nails", SIM_TEXT("a stick between two nails"),
                SIM_TEXT("A stick that is too short between two points that stand fast: neither gives way."),
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
              SIM_TEXT("Lead and tail begin in one place, on a soft stick that has no direction there."),
              valuesOf({{"keep", 0.7}, {"target_x", 400}, {"target_y", 200}, {"behind", 0}, {"soft", 1}}));
    inside.rest = atTarget({400.0, 200.0}, 1e-6);
    inside.requirements.insert(inside.requirements.end(),
                               {Requirement::noDirection, Requirement::comesToRest});

    HardCase far =
        swims("target_1e9", SIM_TEXT("a target beyond the horizon"),
              SIM_TEXT("The target is a billion px away, and the motor pulls the harder the farther it is."),
              valuesOf({{"keep", 0.7}, {"target_x", 1e9}, {"target_y", -1e9}, {"behind", 40}, {"soft", 0}}));
    far.bound.reach = 3e9;
    far.stickError = 1e-5; // places have seven digits after the point there
    far.rest = atTarget({1e9, -1e9}, 1e-2);
    far.requirements.push_back(Requirement::comesToRest);
    far.stiffest->stretch = 1.5e9;
    return {through, inside, far};
}

}
