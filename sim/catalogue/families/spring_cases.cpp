#include "sim/catalogue/families/families.h"
#include "sim/catalogue/scenes.h"

namespace sim::hard {

HardCase footOnSpringCase(const char *id, const char *title, const char *story, double k, double damp,
                          std::int64_t frames)
{
    HardCase hardCase = caseOf(id, title, story, footOnSpring, valuesOf({{"k", k}, {"damp", damp}}), frames);
    hardCase.requirements = {Requirement::oscillates};
    hardCase.stiffest = StiffestSpring{100.0, k, 1.0, 0.0, damp};
    hardCase.bound.reach = 150.0;
    return hardCase;
}

HardCase comesToRest(HardCase hardCase, std::int64_t frames)
{
    hardCase.requirements.push_back(Requirement::comesToRest);
    hardCase.rest = Rest{frames, {{"foot", middle, 1e-6}}, {}, 1e-6};
    return hardCase;
}

namespace {

/// Returns a case of one foot on a spring for 2000 frames, of which `brief` has 400.
HardCase oneSpring(const char *id, const char *title, const char *story, double k, double damp)
{
    HardCase hardCase = footOnSpringCase(id, title, story, k, damp, 2000);
    hardCase.brief.frames = 400;
    return hardCase;
}

HardCase comesToRest(HardCase hardCase)
{
    return hard::comesToRest(std::move(hardCase), 400);
}

/// Near the stability limit, an amplitude of 100 px may grow up to 2000 px in stable methods, too.
HardCase nearLimit(HardCase hardCase)
{
    hardCase.bound.reach = 2100.0;
    return hardCase;
}

/// Returns a case of a light and a heavy body on a spring. Their centre of mass stays in place.
HardCase unequal(const char *id, const char *title, const char *story, double k)
{
    const double ratio = 1e9, damp = 0.9;
    HardCase hardCase =
        caseOf(id, title, story, unequalPair, valuesOf({{"k", k}, {"damp", damp}, {"ratio", ratio}}), 1000);
    hardCase.requirements = {Requirement::oscillates, Requirement::comesToRest, Requirement::centreStays};
    hardCase.stiffest = StiffestSpring{100.0, k, 1.0, 1.0 / ratio, damp};
    hardCase.bound.reach = 150.0;
    hardCase.bound.drift = 1e-6;
    hardCase.rest = Rest{1000, {{"heavy", middle, 1e-3}}, {{"light", "heavy", 0.0, 1e-3}}, 1e-3};
    return hardCase;
}

HardCase suddenlyStiff()
{
    const int feet = 3;
    const double k = 0.2, stiff = 1e6, damp = 0.85;
    HardCase hardCase =
        caseOf("stiffness_jumps", SIM_TEXT("suddenly stiff"),
               SIM_TEXT("In the middle of the run, the stiffness jumps from 0.2 to one million."), creature,
               valuesOf({{"k", k}, {"damp", damp}, {"radius", 50}, {"feet", feet}, {"out", 150}}), 400);
    hardCase.script.input = {{30, Set{"k", stiff}}};
    hardCase.requirements = {Requirement::oscillates, Requirement::comesToRest, Requirement::parameterJumps};
    hardCase.stiffest = StiffestSpring{100.0, feet * stiff, 1.0 / feet, 1.0, damp};
    hardCase.bound.reach = 500.0;
    hardCase.rest = Rest{400, {}, {}, 1e-3, {feet, 50.0, 1e-3}};
    return hardCase;
}

}

std::vector<HardCase> stiffSprings()
{
    return {
        nearLimit(
            oneSpring("stiffness_below_limit", SIM_TEXT("just below the limit"),
                      SIM_TEXT("With one step a frame, the limit is a stiffness of 4. This spring has 3.99."),
                      3.99, 1.0)),
        nearLimit(oneSpring("stiffness_at_limit", SIM_TEXT("at the limit"),
                            SIM_TEXT("At stiffness 4, each step takes the foot to the other side at full "
                                     "speed, so it swings farther each time."),
                            4.0, 1.0)),
        nearLimit(oneSpring("stiffness_above_limit", SIM_TEXT("just above the limit"),
                            SIM_TEXT("At stiffness 4.01 each swing is a tenth larger than the one before."),
                            4.01, 1.0)),
        comesToRest(oneSpring("stiffness_1e3", SIM_TEXT("a thousand times as stiff"),
                              SIM_TEXT("A spring of stiffness 1000 swings five times in a frame."), 1e3,
                              0.9)),
        comesToRest(oneSpring("stiffness_1e6", SIM_TEXT("a million times as stiff"),
                              SIM_TEXT("A spring of stiffness a million swings 159 times in a frame."), 1e6,
                              0.9)),
        comesToRest(oneSpring("stiffness_1e9", SIM_TEXT("nearly rigid"),
                              SIM_TEXT("A spring of stiffness one billion behaves almost like a stick."), 1e9,
                              0.9)),
        oneSpring(
            "stiffness_1e9_undamped", SIM_TEXT("nearly rigid, without damping"),
            SIM_TEXT("The same without damping: it may swing for ever, but no farther than at the start."),
            1e9, 1.0),
        [] {
            HardCase hardCase =
                oneSpring("damp_0", SIM_TEXT("damping that stops everything"),
                          SIM_TEXT("With damping 0, no velocity is left, so nothing may move."), 0.2, 0.0);
            hardCase.rest = Rest{1, {{"foot", middle + Vec2{100.0, 0.0}, 0.0}}, {}, 0.0};
            return hardCase;
        }(),
        oneSpring("damp_1", SIM_TEXT("no damping"),
                  SIM_TEXT("With damping 1, nothing is lost: the foot swings for ever, but never farther."),
                  0.2, 1.0),
        oneSpring("damp_1e-300", SIM_TEXT("almost no velocity left"),
                  SIM_TEXT("A damping of 1e-300 leaves velocities that are almost too small to be stored."),
                  0.2, 1e-300),
        suddenlyStiff(),
        unequal("masses_1_to_1e9", SIM_TEXT("a fly and a mountain"),
                SIM_TEXT("One body is a billion times as heavy as the one on its spring."), 0.2),
        unequal("masses_1_to_1e9_stiff", SIM_TEXT("the mountain swings, too"),
                SIM_TEXT("The spring is stiff enough to move the heavy body, and therefore a hundred million "
                         "times too stiff for the light one."),
                1e8),
    };
}

}
