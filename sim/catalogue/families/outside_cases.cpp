#include "sim/catalogue/families/families.h"
#include "sim/catalogue/scenes.h"

#include <limits>
#include <numbers>

namespace sim::hard {

namespace {

constexpr double outsideDamp = 0.85;
constexpr int footCount = 3;

/// Returns a case of a creature that is dragged by `input`. `stretch`: px, see StiffestSpring. `speed`: see
/// Rest.
HardCase dragged(const char *id, const char *title, const char *story, double k, double stretch, double speed,
                 std::vector<Event> input)
{
    HardCase hardCase = caseOf(
        id, title, story, creature,
        valuesOf({{"k", k}, {"damp", outsideDamp}, {"radius", 50}, {"feet", footCount}, {"out", 60}}), 600);
    hardCase.script.input = std::move(input);
    hardCase.requirements = {Requirement::oscillates, Requirement::comesToRest, Requirement::dragging};
    hardCase.stiffest = StiffestSpring{stretch, footCount * k, 1.0 / footCount, 1.0, outsideDamp};
    // A thrown body goes 1 / (1 - outsideDamp) times its speed far. The factor allows for several such overshoots.
    hardCase.bound.reach = 100.0 * stretch;
    hardCase.rest = Rest{600, {}, {}, speed, {footCount, 50.0, 1e-2}};
    return hardCase;
}

/// Returns a case in a room. It requires no particular rest.
HardCase inRoom(const char *id, const char *title, const char *story, double gravity, double bounce)
{
    const double k = 0.2;
    HardCase hardCase = caseOf(id, title, story, creatureInRoom,
                               valuesOf({{"k", k},
                                         {"damp", outsideDamp},
                                         {"radius", 50},
                                         {"feet", footCount},
                                         {"out", 60},
                                         {"gravity", gravity},
                                         {"left", 20},
                                         {"right", 520},
                                         {"floor", 380},
                                         {"bounce", bounce}}),
                               600);
    hardCase.requirements = {Requirement::oscillates, Requirement::bounces};
    hardCase.stiffest = StiffestSpring{100.0, footCount * k, 1.0 / footCount, 1.0, outsideDamp};
    return hardCase;
}

HardCase thrownIntoCorner()
{
    HardCase hardCase = inRoom("thrown_into_corner", SIM_TEXT("thrown into a corner"),
                               SIM_TEXT("A body flies into a corner at a million px a frame. In one step, it "
                                        "would fly through two thousand rooms."),
                               0.0, 0.5);
    hardCase.script.bodies = {{"body", {middle, Vec2{1e6, 1e6}}}};
    hardCase.stiffest->stretch = 1e7;
    hardCase.bounces = 2000.0;
    hardCase.bound.reach = 2e7; // there is no ceiling
    return hardCase;
}

HardCase narrowRoom()
{
    HardCase hardCase = inRoom(
        "walls_closer_than_body", SIM_TEXT("walls closer than the body"),
        SIM_TEXT(
            "The body is 30 px wide but the room only 15 px. Wherever the body is, it is inside a wall."),
        0.5, 1.0);
    hardCase.script.values.set("left", 265.0);
    hardCase.script.values.set("right", 280.0);
    hardCase.requirements.push_back(Requirement::noRoom);
    hardCase.bound.reach = 600.0;
    return hardCase;
}

HardCase heavyGravity()
{
    HardCase hardCase = inRoom("gravity_1e6", SIM_TEXT("a million times the gravity"),
                               SIM_TEXT("In each frame, gravity makes everything a million px a frame "
                                        "faster, above a floor without bounce."),
                               1e6, 0.0);
    hardCase.brief.frames = hardCase.full.frames = 1000;
    hardCase.stiffest->stretch = 500.0;
    hardCase.bounces = 1.0;
    hardCase.bound.reach = 1000.0;
    hardCase.rest = Rest{1000, {}, {}, 1e-3};
    return hardCase;
}

HardCase walking(const char *id, const char *title, const char *story, double speed)
{
    HardCase hardCase =
        caseOf(id, title, story, walker,
               valuesOf({{"k", 0.1}, {"damp", 0.9}, {"gravity", 0.5}, {"speed", speed}}), 600);
    hardCase.requirements = {Requirement::oscillates, Requirement::bounces, Requirement::driven};
    hardCase.stiffest = StiffestSpring{100.0, 0.2, 0.5, 1.0, 0.9};
    hardCase.bounces = 2.0;
    hardCase.driven = speed;
    hardCase.bound.reach = 600.0 * 20.0; // no foot is faster than 20 px/frame
    return hardCase;
}

/// Returns a case whose input is not finite, so that it must be rejected.
HardCase notANumber(const char *id, const char *title, const char *story, Event event)
{
    HardCase hardCase = caseOf(
        id, title, story, creature,
        valuesOf({{"k", 0.2}, {"damp", outsideDamp}, {"radius", 50}, {"feet", footCount}, {"out", 60}}), 60);
    hardCase.script.input = {{4, Grab{"body"}}, event};
    hardCase.requirements = {Requirement::rejected, Requirement::dragging};
    hardCase.expectedError = "input-not-finite";
    return hardCase;
}

}

std::vector<HardCase> suddenDrags()
{
    return {
        dragged("grabbed_one_frame", SIM_TEXT("grabbed and let go"),
                SIM_TEXT("The body is grabbed for one frame and let go."), 0.2, 100.0, 1e-3,
                {{10, Grab{"body"}}, {11, Release{}}}),
        dragged("dragged_1e9", SIM_TEXT("torn away"),
                SIM_TEXT("The body is dragged a billion px away in one frame and let go."), 0.2, 1e9, 1e-3,
                {{10, Grab{"body"}}, {11, Move{{1e9, -1e9}}}, {12, Release{}}}),
        dragged(
            "dragged_1e9_stiff", SIM_TEXT("torn away on stiff springs"),
            SIM_TEXT("The same, with springs of stiffness one million."), 1e6, 1e9,
            10.0, // at 1e10 px a double has six decimal places, and the springs respond to the rounding error
            {{10, Grab{"body"}}, {11, Move{{1e9, -1e9}}}, {12, Release{}}}),
    };
}

std::vector<HardCase> wallsAndWalking()
{
    return {
        thrownIntoCorner(),
        narrowRoom(),
        heavyGravity(),
        walking(
            "gait_pi", SIM_TEXT("legs that flip"),
            SIM_TEXT(
                "The gait turns by half a circle in each frame, so the steps see only two of its positions."),
            std::numbers::pi),
        walking("gait_1e6", SIM_TEXT("legs that whirl"), SIM_TEXT("The gait turns 159,155 times in a frame."),
                1e6),
    };
}

std::vector<HardCase> invalidInput()
{
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    constexpr double infinite = std::numeric_limits<double>::infinity();
    return {
        notANumber("hand_not_a_number", SIM_TEXT("a drag to nowhere"),
                   SIM_TEXT("The body is dragged to a position that is not a number."),
                   {5, Move{{nan, 200.0}}}),
        notANumber("pointer_infinite", SIM_TEXT("a pointer infinitely far away"),
                   SIM_TEXT("The pointer moves to a position that is infinitely far away."),
                   {5, Pointer{{270.0, infinite}, true}}),
        notANumber("parameter_infinite", SIM_TEXT("an infinite stiffness"),
                   SIM_TEXT("The stiffness is set to infinity."), {5, Set{"k", infinite}}),
    };
}

}
