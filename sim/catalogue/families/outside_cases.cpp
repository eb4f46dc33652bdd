#include "sim/catalogue/families/families.h"
#include "sim/catalogue/scenes.h"

#include <limits>
#include <numbers>

namespace sim::hard {

namespace {

constexpr double damp = 0.85;
constexpr int feet = 3;

HardCase held(const char *id, const char *title, const char *story, double k, double far, double speed,
              std::vector<Event> input)
{
    HardCase one =
        caseOf(id, title, story, creature,
               valuesOf({{"k", k}, {"damp", damp}, {"radius", 50}, {"feet", feet}, {"out", 60}}), 600);
    one.script.input = std::move(input);
    one.requirements = {Requirement::oscillates, Requirement::comesToRest, Requirement::dragging};
    one.stiffest = StiffestSpring{far, feet * k, 1.0 / feet, 1.0, damp};
    one.bound.reach =
        100.0 * far; // a throw goes 1 / (1 - damp) times its speed far, and may be overdone a few times
    one.rest = Rest{600, {}, {}, speed};
    for (int i = 0; i < feet; ++i)
        one.rest->distances.push_back({"foot" + std::to_string(i), "body", 50.0, 1e-2});
    return one;
}

/// In a room; what happens there has no rest that is told beforehand.
HardCase inRoom(const char *id, const char *title, const char *story, double gravity, double bounce)
{
    const double k = 0.2;
    HardCase one = caseOf(id, title, story, creatureInRoom,
                          valuesOf({{"k", k},
                                    {"damp", damp},
                                    {"radius", 50},
                                    {"feet", feet},
                                    {"out", 60},
                                    {"gravity", gravity},
                                    {"left", 20},
                                    {"right", 520},
                                    {"floor", 380},
                                    {"bounce", bounce}}),
                          600);
    one.requirements = {Requirement::oscillates, Requirement::bounces};
    one.stiffest = StiffestSpring{100.0, feet * k, 1.0 / feet, 1.0, damp};
    return one;
}

HardCase thrownIntoCorner()
{
    HardCase one = inRoom("thrown_into_corner", SIM_TEXT("thrown into a corner"),
                          SIM_TEXT("A body comes into a corner at a million px a frame: in one step it would "
                                   "be two thousand rooms away."),
                          0.0, 0.5);
    one.script.bodies = {{"body", {middle, Vec2{1e6, 1e6}}}};
    one.stiffest->stretch = 1e7;
    one.bounces = 2000.0;
    one.bound.reach = 2e7; // there is no ceiling
    return one;
}

HardCase narrowRoom()
{
    HardCase one = inRoom(
        "walls_closer_than_body", SIM_TEXT("walls closer than the body"),
        SIM_TEXT("The body is 30 px wide and the room 15: wherever it is, it is in a wall."), 0.5, 1.0);
    one.script.values.set("left", 265.0);
    one.script.values.set("right", 280.0);
    one.requirements.push_back(Requirement::noRoom);
    one.bound.reach = 600.0;
    return one;
}

HardCase heavyGravity()
{
    HardCase one = inRoom("gravity_1e6", SIM_TEXT("a million times the gravity"),
                          SIM_TEXT("All falls at a million px a frame, each frame, onto a floor that "
                                   "gives nothing back."),
                          1e6, 0.0);
    one.brief.frames = one.full.frames = 1000;
    one.stiffest->stretch = 500.0;
    one.bounces = 1.0;
    one.bound.reach = 1000.0;
    one.rest = Rest{1000, {}, {}, 1e-3};
    return one;
}

HardCase walking(const char *id, const char *title, const char *story, double speed)
{
    HardCase one = caseOf(id, title, story, walker,
                          valuesOf({{"k", 0.1}, {"damp", 0.9}, {"gravity", 0.5}, {"speed", speed}}), 600);
    one.requirements = {Requirement::oscillates, Requirement::bounces, Requirement::driven};
    one.stiffest = StiffestSpring{100.0, 0.2, 0.5, 1.0, 0.9};
    one.bounces = 2.0;
    one.driven = speed;
    one.bound.reach = 600.0 * 20.0; // no foot is pulled faster than 20 px a frame
    return one;
}

/// A run that must not begin: its input is no number.
HardCase notANumber(const char *id, const char *title, const char *story, Event event)
{
    HardCase one =
        caseOf(id, title, story, creature,
               valuesOf({{"k", 0.2}, {"damp", damp}, {"radius", 50}, {"feet", feet}, {"out", 60}}), 60);
    one.script.input = {{4, Grab{"body"}}, event};
    one.requirements = {Requirement::refused, Requirement::dragging};
    one.refusal = "input-not-finite";
    return one;
}

}

std::vector<HardCase> roughHands()
{
    return {
        held("grabbed_one_frame", SIM_TEXT("grabbed and let go"),
             SIM_TEXT("A hand takes the body for one frame and lets it go."), 0.2, 100.0, 1e-3,
             {{10, Grab{"body"}}, {11, Release{}}}),
        held("dragged_1e9", SIM_TEXT("torn away"),
             SIM_TEXT("A hand takes the body a billion px away in one frame, and lets it go."), 0.2, 1e9,
             1e-3, {{10, Grab{"body"}}, {11, Move{{1e9, -1e9}}}, {12, Release{}}}),
        held("dragged_1e9_stiff", SIM_TEXT("torn away on stiff springs"),
             SIM_TEXT("The same on springs of stiffness a million."), 1e6, 1e9,
             10.0, // a place at 1e10 px has six digits after the point, and the springs pull by what is lost
             {{10, Grab{"body"}}, {11, Move{{1e9, -1e9}}}, {12, Release{}}}),
    };
}

std::vector<HardCase> wallsAndWalking()
{
    return {
        thrownIntoCorner(),
        narrowRoom(),
        heavyGravity(),
        walking("gait_pi", SIM_TEXT("legs that flip"),
                SIM_TEXT("The gait turns by half a circle each frame: a step sees two places of it only."),
                std::numbers::pi),
        walking("gait_1e6", SIM_TEXT("legs that whirl"), SIM_TEXT("The gait turns 159,155 times in a frame."),
                1e6),
    };
}

std::vector<HardCase> badInput()
{
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    constexpr double infinite = std::numeric_limits<double>::infinity();
    return {
        notANumber("hand_not_a_number", SIM_TEXT("a hand that is nowhere"),
                   SIM_TEXT("The hand moves to a place that is not a number."), {5, Move{{nan, 200.0}}}),
        notANumber("pointer_infinite", SIM_TEXT("a pointer at the end of the world"),
                   SIM_TEXT("The pointer goes to a place that is infinitely far away."),
                   {5, Pointer{{270.0, infinite}, true}}),
        notANumber("parameter_infinite", SIM_TEXT("an endless stiffness"),
                   SIM_TEXT("The stiffness is set to infinity."), {5, Set{"k", infinite}}),
    };
}

}
