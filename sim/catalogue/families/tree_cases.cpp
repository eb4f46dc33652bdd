#include "sim/catalogue/families/families.h"
#include "sim/catalogue/scenes.h"

namespace sim::hard {

namespace {

constexpr Vec2 trunkEnd = {275.0, 300.0};

/// Returns a case of a tree in the wind from `pointer`.
HardCase blown(const char *id, const char *title, const char *story, Values values, Vec2 pointer)
{
    HardCase hardCase = caseOf(id, title, story, windyTree, std::move(values), 300);
    hardCase.script.input = {{1, Pointer{pointer, true}}};
    hardCase.requirements = {Requirement::driven, Requirement::noDirection};
    hardCase.bound = {1000.0, treeRoot, {}};
    return hardCase;
}

/// Returns the values of windyTree(); `by` and `formula` as there.
Values windBy(double by, double formula)
{
    return valuesOf({{"levels", 4},
                     {"slope", 0.8},
                     {"base_length", 100},
                     {"ease", 8},
                     {"formula", formula},
                     {"by", by},
                     {"turned", 0},
                     {"wind", 5}});
}

HardCase noDistancePublished()
{
    HardCase hardCase = blown("wind_no_distance_published", SIM_TEXT("no distance to divide by"),
                              SIM_TEXT("The printed formula divides by the distance of the pointer, which "
                                       "can be 0. Then the run must stop with a message."),
                              windBy(1, 1), treeRoot);
    // Here the published sum of the pointer and the branch's end is exactly 0.
    hardCase.script.input = {{1, Pointer{treeRoot - Vec2{100.0, 0.0}, true}}};
    hardCase.script.values.set("levels", 0);
    hardCase.script.values.set("turned", 90);
    hardCase.requirements = {Requirement::overflows};
    return hardCase;
}

HardCase turned()
{
    HardCase hardCase =
        caseOf("pointer_on_root", SIM_TEXT("the pointer on the root"),
               SIM_TEXT("The trunk turns towards a pointer that is exactly at its root."), turningTree,
               valuesOf({{"levels", 4}, {"slope", 0.8}, {"base_length", 100}}), 60);
    hardCase.script.input = {{1, Pointer{treeRoot, true}}};
    hardCase.requirements = {Requirement::driven, Requirement::noDirection};
    hardCase.bound = {600.0, treeRoot, {}};
    return hardCase;
}

HardCase deep()
{
    HardCase hardCase =
        blown("branches_16_deep", SIM_TEXT("sixteen forks"),
              SIM_TEXT("Each branch forks into two as large as itself, sixteen times: 131,071 "
                       "branches in the wind."),
              windBy(2, 0), {100.0, 100.0});
    hardCase.script.values.set("levels", 16);
    hardCase.script.values.set("slope", 1);
    hardCase.script.values.set("base_length", 20);
    hardCase.requirements = {Requirement::driven, Requirement::manyPoints};
    hardCase.brief.frames = 1;
    return hardCase;
}

HardCase endless()
{
    HardCase hardCase =
        caseOf("tree_without_end", SIM_TEXT("a tree that never ends"),
               SIM_TEXT("Branches that are as large as their parents never get small enough to stop "
                        "forking."),
               grownTree, valuesOf({{"slope", 1}, {"min_scale", 0.2}}), 60);
    hardCase.requirements = {Requirement::rejected};
    hardCase.expectedError = "tree-too-big";
    return hardCase;
}

HardCase stiffTree()
{
    const double k = 1e6, damp = 0.8;
    HardCase hardCase = caseOf(
        "tree_stiff", SIM_TEXT("a tree of glass"),
        SIM_TEXT("Joints a million times as stiff as wood, bent by ten degrees and let go."), springyTree,
        valuesOf({{"levels", 3},
                  {"slope", 0.8},
                  {"base_length", 100},
                  {"k", k},
                  {"damp", damp},
                  {"wind", 0},
                  {"bent", 10}}),
        100);
    hardCase.requirements = {Requirement::oscillates, Requirement::comesToRest};
    // Gershgorin's circle theorem bounds the fastest oscillation; see Torsion::stiffnessBound().
    hardCase.stiffest = StiffestSpring{10.0, 10.0 * k, 1.0, 0.0, damp};
    hardCase.bound = {600.0, treeRoot, {}};
    hardCase.rest = Rest{100, {{"branch1", trunkEnd, 1e-3}}, {}, 1e-3};
    return hardCase;
}

}

std::vector<HardCase> windyTrees()
{
    return {
        blown("wind_no_direction", SIM_TEXT("wind from the branch itself"),
              SIM_TEXT("The pointer is exactly where the trunk ends: the wind has no direction there."),
              windBy(0, 0), trunkEnd),
        blown("wind_no_distance", SIM_TEXT("wind without a distance"),
              SIM_TEXT("The distance to the pointer resists the wind, and here it is 0."), windBy(1, 0),
              trunkEnd),
        noDistancePublished(),
        turned(),
        deep(),
        endless(),
        stiffTree(),
    };
}

}
