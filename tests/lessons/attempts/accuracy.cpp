#include "sim/run/script/script.h"
#include "tests/lessons/attempts/attempts.h"

namespace support {

namespace {

/// Returns a time measurement that reports `nanoseconds` per frame for every run.
lessons::TimeMeasurement fixedTiming(double nanoseconds)
{
    return [nanoseconds](const sim::Script &, std::int64_t) { return nanoseconds; };
}

void playWith(Player &p, const char *method, double h, int frames)
{
    p.useMethod(method);
    p.useStep(h);
    p.play(frames);
}

}

ATTEMPTS(accuracy)
{
    return {
        {"big_step", 0, "1/8 frame", [](Player &p) { playWith(p, "semi_implicit_euler", 0.125, 100); }},
        {"big_step", 1, "2 frames",
         [](Player &p) {
             p.useStep(2.0);
             p.playUntilDone(50);
         }},
        {"big_step", 2, "5 frames",
         [](Player &p) {
             p.useStep(5.0);
             p.playUntilDone(20);
         }},
        {"big_step", 3, "a slow oscillation",
         [](Player &p) {
             p.set("k", 0.02);
             p.play(100);
         }},
        {"energy", 0, "twice the energy",
         [](Player &p) {
             p.useMethod("explicit_euler");
             p.playUntilDone(40);
         }},
        {"energy", 1, "explicit Euler, small steps",
         [](Player &p) {
             p.useMethod("explicit_euler");
             p.useStep(0.125);
             p.playUntilDone(60);
         }},
        {"energy", 2, "Verlet", [](Player &p) { playWith(p, "velocity_verlet", 1.0, 200); }},
        {"halve", 0, "order 1", [](Player &p) { playWith(p, "semi_implicit_euler", 1.0 / 16, 60); }},
        {"halve", 1, "order 2", [](Player &p) { playWith(p, "midpoint", 1.0 / 16, 60); }},
        {"halve", 2, "order 4", [](Player &p) { playWith(p, "rk4", 1.0 / 16, 60); }},
        {"halve", 3, "Runge-Kutta 4, 1/4 frame", [](Player &p) { playWith(p, "rk4", 0.25, 60); }},
        {"halve", 3, "Dormand-Prince, 0.0001 px",
         [](Player &p) {
             p.useMethod("dormand_prince");
             p.useTolerance(1e-4);
             p.play(60);
         }},
        {"adapt", 0, "a loose tolerance",
         [](Player &p) {
             p.useTolerance(0.1);
             p.play(150);
         }},
        {"adapt", 0, "a loose tolerance after a throw",
         [](Player &p) {
             p.grab("foot");
             p.dragTo({120, 110}, 8);
             p.release();
             p.useTolerance(0.1);
             p.play(150);
         },
         "unchanged"},
        {"adapt", 1, "thrown past the centre",
         [](Player &p) {
             p.grab("foot");
             p.dragTo({120, 110}, 8);
             p.dragTo({195, 158}, 3);
             p.release();
             p.playUntilDone(60);
         }},
        {"adapt", 1, "thrown fast through the centre",
         [](Player &p) {
             p.drag("foot", {340, 200}, 4);
             p.playUntilDone(60);
         }},
        {"adapt", 2, "Runge-Kutta 4, 1/4 frame", [](Player &p) { playWith(p, "rk4", 0.25, 150); }},
        {"bounce", 0, "1/8 frame", [](Player &p) { playWith(p, "rk4", 0.125, 200); }},
        {"bounce", 1, "Dormand-Prince",
         [](Player &p) {
             p.useMethod("dormand_prince");
             p.play(200);
         }},
        {"bounce", 2, "to rest",
         [](Player &p) {
             p.useMethod("dormand_prince");
             p.set("bounce", 0.5);
             p.playUntilDone(110);
         }},
        {"budget", 0, "small steps",
         [](Player &p) {
             p.useTiming(fixedTiming(4000.0));
             playWith(p, "semi_implicit_euler", 1.0 / 16, 200);
         }},
        {"budget", 1, "Velocity Verlet, 1/2 frame",
         [](Player &p) {
             p.useTiming(fixedTiming(400.0));
             playWith(p, "velocity_verlet", 0.5, 200);
         }},
        {"budget", 1, "Runge-Kutta 4, 1 frame",
         [](Player &p) {
             p.useTiming(fixedTiming(400.0));
             playWith(p, "rk4", 1.0, 200);
         }},
        {"budget", 2, "Runge-Kutta 4, 1/2 frame",
         [](Player &p) {
             p.useTiming(fixedTiming(900.0));
             playWith(p, "rk4", 0.5, 200);
         }},
        {"crowd", 0, "20 000 creatures",
         [](Player &p) {
             p.set("creatures", 10'000);
             p.play(60);
             p.set("creatures", 20'000);
             p.play(61);
         }},
        {"crowd", 1, "no bounce",
         [](Player &p) {
             p.set("bounce", 0.0);
             p.playUntilDone(1500);
         }},
        {"crowd", 2, "no gravity",
         [](Player &p) {
             p.play(30);
             p.set("gravity", 0.0);
             p.play(61);
         }},
        // Near misses, with the expected hint
        {"big_step", 0, "not far enough", [](Player &p) { playWith(p, "semi_implicit_euler", 0.125, 40); },
         "frame 40"},
        {"big_step", 3, "set during the run",
         [](Player &p) {
             p.play(20);
             p.set("k", 0.02);
             p.play(100);
         },
         "from_start"},
        {"big_step", 2, "with the soft spring of the slow oscillation",
         [](Player &p) {
             p.set("k", 0.02);
             p.useStep(5.0);
             p.play(100);
         },
         "k"},
        {"halve", 3, "too expensive", [](Player &p) { playWith(p, "rk4", 0.125, 60); }, "price 32"},
        {"adapt", 1, "too slow",
         [](Player &p) {
             p.drag("foot", p.at("foot") + sim::Vec2{20, 0}, 10);
             p.play(5);
         },
         "let go while the mouse moves, at 5 px per frame or more. You let go at 2.0."},
    };
}

}
