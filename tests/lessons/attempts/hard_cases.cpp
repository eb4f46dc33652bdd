#include "tests/lessons/attempts/attempts.h"

#include <stdexcept>

namespace support {

namespace {

/// Returns the index of a case among the choices of the last step.
double caseIndex(const char *id)
{
    const LoadedLesson lesson = loadLesson(QStringLiteral("hard_cases"));
    const qsizetype position =
        lesson.step(QStringLiteral("torture")).parameter(QStringLiteral("case"))->choices.indexOf(id);
    if (position < 0)
        throw std::runtime_error(id);
    return static_cast<double>(position);
}

void withStep(Player &p, const char *method, double h)
{
    p.useMethod(method);
    p.useStep(h);
}

}

ATTEMPTS(hard_cases)
{
    return {
        {"limit", 0, "1/2 frame",
         [](Player &p) {
             p.useStep(0.5);
             p.play(200);
         }},
        {"limit", 1, "k 3.9",
         [](Player &p) {
             p.set("k", 3.9);
             p.play(100);
         }},
        {"limit", 2, "damp 0.9",
         [](Player &p) {
             p.set("damp", 0.9);
             p.playUntilDone(300);
         }},
        {"runaway", 0, "the other method",
         [](Player &p) {
             p.useMethod("semi_implicit_euler");
             p.play(200);
         }},
        {"runaway", 1, "k 0.2",
         [](Player &p) {
             p.set("k", 0.2);
             p.playUntilDone(800);
         }},
        {"runaway", 2, "1/4 frame",
         [](Player &p) {
             p.useStep(0.25);
             p.playUntilDone(400);
         }},
        {"many_feet", 0, "38 feet",
         [](Player &p) {
             p.set("feet", 38);
             p.playUntilDone(300);
         }},
        {"many_feet", 1, "1/2 frame",
         [](Player &p) {
             p.useStep(0.5);
             p.playUntilDone(300);
         }},
        {"many_feet", 2, "k 0.1",
         [](Player &p) {
             p.set("k", 0.1);
             p.playUntilDone(300);
         }},
        {"one_place", 0, "the other method",
         [](Player &p) {
             p.useMethod("semi_implicit_euler");
             p.play(60);
         }},
        {"one_place", 1, "a foot dragged out of line",
         [](Player &p) {
             p.play(60);
             p.drag("foot0", {290, 120}, 20);
             p.playUntilDone(400);
         }},
        {"one_place", 2, "collapsed and expanded again",
         [](Player &p) {
             p.useMethod("semi_implicit_euler");
             p.play(60);
             p.set("radius", 0);
             p.play(60);
             p.set("radius", 50);
             p.playUntilDone(200);
         }},
        {"stiff", 0, "1/64 frame",
         [](Player &p) {
             p.useStep(1.0 / 64);
             p.playUntilDone(400);
         }},
        {"stiff", 1, "stiffness 1e6",
         [](Player &p) {
             p.useMethod("backward_euler");
             p.set("k", 1e6);
             p.play(30);
         }},
        {"stiff", 2, "energy loss at low stiffness",
         [](Player &p) {
             p.useMethod("backward_euler");
             p.set("k", 0.2);
             p.set("damp", 1.0);
             p.playUntilDone(200);
         }},
        {"contradiction", 0, "softer springs",
         [](Player &p) {
             p.set("k", 1.0);
             p.playUntilDone(400);
         }},
        {"contradiction", 1, "sticks",
         [](Player &p) {
             p.set("made_of", 1.0);
             p.playUntilDone(200);
         }},
        {"contradiction", 2, "a triangle",
         [](Player &p) {
             p.set("made_of", 1.0);
             p.set("longest", 30.0);
             p.playUntilDone(200);
         }},
        {"long_run", 0, "to frame 5000", [](Player &p) { p.goTo(5000); }},
        {"long_run", 1, "1/2 frame",
         [](Player &p) {
             p.useStep(0.5);
             p.goTo(5000);
         }},
        {"long_run", 2, "Verlet",
         [](Player &p) {
             withStep(p, "velocity_verlet", 1.0);
             p.goTo(20'000);
         }},
        {"torture", 0, "Backward Euler",
         [](Player &p) {
             p.set("case", caseIndex("stiffness_1e9"));
             p.useMethod("backward_euler");
             p.playUntilDone(100);
         }},
        {"torture", 1, "dragged far away, Semi-implicit Euler",
         [](Player &p) {
             p.useMethod("semi_implicit_euler");
             p.set("case", caseIndex("dragged_1e9"));
             p.playUntilDone(399);
         }},
        {"torture", 1, "dragged far away, Backward Euler",
         [](Player &p) {
             p.useMethod("backward_euler");
             p.set("case", caseIndex("dragged_1e9"));
             p.playUntilDone(399);
         }},
        {"torture", 2, "a spring that is too stiff for the step",
         [](Player &p) {
             p.useMethod("semi_implicit_euler");
             p.set("case", caseIndex("stiffness_1e3"));
             p.playUntilDone(400);
         }},
        // Near misses, with the expected hint
        {"limit", 1, "set during the run",
         [](Player &p) {
             p.play(20);
             p.set("k", 3.9);
             p.play(100);
         },
         "k_from_start"},
        {"one_place", 2, "only briefly",
         [](Player &p) {
             p.useMethod("semi_implicit_euler");
             p.play(60);
             p.set("radius", 0);
             p.play(5);
             p.set("radius", 50);
             p.play(100);
         },
         "collapsed"},
        {"long_run", 0, "not far enough", [](Player &p) { p.goTo(2000); }, "frame 2000"},
    };
}

}
