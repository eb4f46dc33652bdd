#include "tests/lessons/attempts/attempts.h"

namespace support {

namespace {

/// Moves the pressed pointer to `to` in equal steps, one per frame.
void movePointer(Player &p, sim::Vec2 to, int frames)
{
    const sim::Vec2 from = p.run().state().input.pointer.value_or(p.at("p0"));
    for (int i = 1; i <= frames; ++i) {
        p.point(from + (double(i) / frames) * (to - from), true);
        p.play(1);
    }
}

}

ATTEMPTS(rigid_constraint)
{
    return {
        {"pair", 0, "led to the right",
         [](Player &p) {
             movePointer(p, {430, 200}, 30);
         }},
        {"pair", 1, "stopped after the pointer",
         [](Player &p) {
             p.play(5);
             p.point({340, 215}, true);
             p.stepPhases(1);
         }},
        {"pair", 1, "stopped after the pointer has moved p0 across the stick",
         [](Player &p) {
             p.play(5);
             p.point(p.at("p0") + sim::Vec2{60, 0}, true);
             p.stepPhases(1);
         }},
        {"pair", 2, "no length",
         [](Player &p) {
             p.play(5);
             p.set("length", 0.0);
             movePointer(p, {400, 300}, 20);
         }},
        {"shared_error", 0, "around the fixed point",
         [](Player &p) {
             p.play(3);
             movePointer(p, {400, 165}, 15);
             movePointer(p, {240, 20}, 15);
         }},
        {"shared_error", 1, "share 0",
         [](Player &p) {
             p.set("share", 0.0);
             movePointer(p, {430, 300}, 30);
         }},
        {"shared_error", 2, "share 0.5, then held still",
         [](Player &p) {
             p.play(3);
             p.set("share", 0.5);
             movePointer(p, {420, 300}, 10);
             p.playUntilDone(60);
         }},
        {"triangle", 0, "fast",
         [](Player &p) {
             movePointer(p, {300, 200}, 10);
             movePointer(p, {480, 300}, 2);
         }},
        {"triangle", 0, "fast, to a place near the start",
         [](Player &p) {
             p.play(20);
             movePointer(p, {200, 250}, 10);
             movePointer(p, {260, 130}, 2);
         }},
        {"triangle", 1, "fast, then still",
         [](Player &p) {
             movePointer(p, {300, 200}, 10);
             movePointer(p, {480, 300}, 3);
             p.playUntilDone(300);
         }},
        {"triangle", 2, "longer sticks",
         [](Player &p) {
             p.set("length", 150.0);
             p.play(10);
             movePointer(p, {320, 120}, 20);
             p.playUntilDone(300);
         }},
        {"list", 0, "led, then still",
         [](Player &p) {
             movePointer(p, {300, 60}, 30);
             p.playUntilDone(600);
         }},
        {"list", 1, "shaken",
         [](Player &p) {
             p.set("triangles", 15.0);
             for (int i = 0; i < 10; ++i)
                 movePointer(p, {120.0 + 150 * (i % 2), 120.0}, 3);
         }},
        {"list", 2, "another length",
         [](Player &p) {
             movePointer(p, {300, 60}, 30);
             p.play(30);
             p.goTo(20);
             p.set("length", 80.0);
             p.play(20);
         }},
        {"verlet", 0, "thrown to the left",
         [](Player &p) {
             p.play(10);
             p.drag("p0", {80, 200}, 10);
             p.playUntilDone(100);
         }},
        {"verlet", 1, "many iterations, dropped",
         [](Player &p) {
             p.set("iterations", 20.0);
             p.play(60);
             p.drag("p1", {270, 150}, 20);
             p.playUntilDone(900);
         }},
        {"verlet", 2, "thrown without gravity",
         [](Player &p) {
             p.set("gravity", 0.0);
             p.drag("p2", {300, 150}, 15);
             p.playUntilDone(100);
         }},
        {"verlet", 3, "stopped after the sticks",
         [](Player &p) {
             p.play(9);
             for (int i = 0; i < 10 && !p.done(); ++i)
                 p.stepPhases(1);
         }},
        {"ragdoll", 0, "lifted by the head",
         [](Player &p) {
             p.play(100);
             p.drag("p0", {270, 120}, 40);
             p.playUntilDone(1500);
         }},
        {"ragdoll", 0, "lifted by a foot",
         [](Player &p) {
             p.play(60);
             p.drag("p9", {200, 100}, 40);
             p.playUntilDone(1500);
         }},
        {"ragdoll", 1, "thrown to the left",
         [](Player &p) {
             p.play(20);
             p.drag("p3", {90, 150}, 10);
             p.playUntilDone(200);
         }},
        {"ragdoll", 2, "shaken",
         [](Player &p) {
             p.set("iterations", 1.0);
             p.play(20);
             p.grab("p5");
             for (int i = 0; i < 10; ++i)
                 p.dragTo({200.0 + 150 * (i % 2), 150.0}, 5);
         }},
        {"ragdoll", 3, "another number of iterations",
         [](Player &p) {
             p.play(20);
             p.drag("p0", {90, 150}, 10);
             p.play(50);
             p.goTo(15);
             p.set("iterations", 2.0);
             p.play(20);
         }},
        // Near misses, with the expected hint
        {"pair", 0, "not far enough",
         [](Player &p) {
             movePointer(p, p.at("p0") + sim::Vec2{60, 80}, 10);
         },
         "led 100"},
        {"verlet", 0, "too slow",
         [](Player &p) {
             p.play(10);
             p.drag("p0", p.at("p0") + sim::Vec2{-20, 0}, 10);
             p.play(5);
         },
         "let go while the mouse moves, at 5 px per frame or more. You let go at 2.0."},
        {"ragdoll", 0, "not far enough",
         [](Player &p) {
             p.play(100);
             p.drag("p0", p.at("p0") + sim::Vec2{0, -20}, 20);
             p.play(1000);
         },
         "carry it 50 px or more. It came 20 px."},
    };
}

}
