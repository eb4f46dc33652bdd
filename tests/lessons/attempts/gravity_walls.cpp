#include "tests/lessons/attempts/attempts.h"

namespace support {

ATTEMPTS(gravity_walls)
{
    return {
        {"walls", 0, "thrown to the left",
         [](Player &p) {
             p.drag("body", {80, 250}, 12);
             p.playUntilDone(100);
         }},
        {"walls", 1, "stopped at a bounce",
         [](Player &p) {
             for (int i = 0; i < 400 && !p.done(); ++i)
                 p.stepPhases(1);
         }},
        {"walls", 2, "thrown without bounce",
         [](Player &p) {
             p.set("bounce", 0.0);
             p.drag("body", {80, 250}, 12);
             p.playUntilDone(100);
         }},
        {"walls", 3, "thrown over the top",
         [](Player &p) {
             p.drag("body", {420, 20}, 8);
             p.playUntilDone(100);
         }},
        {"gravity", 0, "held up",
         [](Player &p) {
             p.grab("body");
             p.dragTo({270, 100}, 10);
             p.playUntilDone(600);
         }},
        {"gravity", 1, "held up, damping 0.6",
         [](Player &p) {
             p.set("damp", 0.6);
             p.grab("body");
             p.dragTo({270, 100}, 10);
             p.playUntilDone(600);
         }},
        {"gravity", 2, "stopped after gravity",
         [](Player &p) {
             p.play(9);
             p.stepPhases(2);
         }},
        {"gravity", 3, "lifted, then let down",
         [](Player &p) {
             p.play(100);
             p.set("left", 240.0);
             p.set("right", 300.0);
             p.grab("body");
             p.dragTo({270, 250}, 20);
             p.play(60);
             p.dragTo({270, 320}, 40);
             p.release();
             p.playUntilDone(900);
         }},
        {"gravity", 3, "lifted, dropped from slightly above",
         [](Player &p) {
             p.play(100);
             p.set("left", 240.0);
             p.set("right", 300.0);
             p.drag("body", {270, 290}, 20);
             p.playUntilDone(900);
         }},
        {"gravity", 3, "lifted away from the centre",
         [](Player &p) {
             p.play(100);
             p.set("left", 240.0);
             p.set("right", 300.0);
             p.drag("body", {262, 300}, 20);
             p.playUntilDone(900);
         }},
        // Near misses, with the expected hint
        {"walls", 0, "too slow",
         [](Player &p) {
             p.drag("body", p.at("body") + sim::Vec2{-40, 0}, 20);
             p.play(20);
         },
         "let go while the mouse moves, at 5 px per frame or more. You let go at 2.0."},
        {"walls", 3, "not over the top",
         [](Player &p) {
             p.drag("body", p.at("body") + sim::Vec2{60, 0}, 10);
             p.play(20);
         },
         "above"},
        {"gravity", 0, "held on the floor",
         [](Player &p) {
             p.play(100);
             p.grab("body");
             p.dragTo({270, 380}, 20);
             p.play(100);
         },
         "hanging"},
    };
}

}
