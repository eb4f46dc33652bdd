#include "sim/catalogue/families/families.h"
#include "sim/catalogue/scenes.h"

namespace sim::hard {

namespace {

/// Returns a case of one soft spring with unusual steps.
HardCase stepped(const char *id, const char *title, const char *story, RunSize brief, RunSize full)
{
    HardCase hardCase = footOnSpringCase(id, title, story, 0.2, 0.9, 0);
    hardCase.brief = brief;
    hardCase.full = full;
    hardCase.requirements.push_back(Requirement::unusualStep);
    return hardCase;
}

HardCase tenMillionFrames()
{
    HardCase hardCase = footOnSpringCase("ten_million_frames", SIM_TEXT("ten million frames"),
                                         SIM_TEXT("A foot swings without damping for ten million frames, "
                                                  "almost four days of playing. Its errors must not add up."),
                                         0.2, 1.0, 10'000'000);
    hardCase.brief.frames = 20'000;
    hardCase.requirements.push_back(Requirement::longRun);
    hardCase.bound.reach = 120.0;
    return hardCase;
}

HardCase atRest()
{
    const int feet = 2;
    const double k = 0.2, damp = 0.85;
    HardCase hardCase =
        caseOf("million_frames_at_rest", SIM_TEXT("a million frames at rest"),
               SIM_TEXT("At rest, bodies still have velocities that are almost too small to be stored, but "
                        "they must not move."),
               creature, valuesOf({{"k", k}, {"damp", damp}, {"radius", 50}, {"feet", feet}, {"out", 100}}),
               1'000'000);
    hardCase.brief.frames = 10'000;
    hardCase.requirements = {Requirement::oscillates, Requirement::comesToRest, Requirement::longRun};
    hardCase.stiffest = StiffestSpring{50.0, feet * k, 1.0 / feet, 1.0, damp};
    hardCase.bound.reach = 200.0;
    hardCase.rest = Rest{10'000, {}, {}, 1e-9, {feet, 50.0, 1e-9}};
    return hardCase;
}

}

std::vector<HardCase> unusualSteps()
{
    return {
        stepped(
            "step_1e-6", SIM_TEXT("a million steps a frame"),
            SIM_TEXT("Each step is a millionth of a frame, so its small change is almost lost in rounding."),
            {1, 1e-4}, {20, 1e-6}),
        comesToRest(stepped("step_third", SIM_TEXT("a third of a frame"),
                            SIM_TEXT("Three steps a frame: no binary number is exactly a third."),
                            {600, 1.0 / 3}, {600, 1.0 / 3}),
                    600),
        comesToRest(stepped("step_100", SIM_TEXT("a hundred frames in a step"),
                            SIM_TEXT("One step skips seven swings of the spring."), {60'000, 100},
                            {60'000, 100}),
                    600),
    };
}

std::vector<HardCase> longRuns()
{
    return {tenMillionFrames(), atRest()};
}

}
