#include "tests/lessons/attempts/attempts.h"

namespace support {

ATTEMPTS(two_body)
{
    return {
        {"mutual", 0, "stopped between the two moves",
         [](Player &p) {
             p.play(5);
             p.stepPhases(4);
         }},
        {"mutual", 1, "flies away",
         [](Player &p) {
             p.set("k", 0.3);
             p.playUntilDone(300);
         }},
        {"mutual", 2, "damped from the start",
         [](Player &p) {
             p.set("k", 0.3);
             p.set("damp", 0.85);
             p.playUntilDone(600);
         }},
        {"mutual", 2, "damped in flight",
         [](Player &p) {
             p.set("k", 0.3);
             p.play(150);
             p.set("damp", 0.85);
             p.playUntilDone(600);
         }},
        {"mutual", 3, "all at once, after a flight",
         [](Player &p) {
             p.set("k", 0.3);
             p.play(150);
             p.useMethod("semi_implicit_euler");
             p.playUntilDone(101);
         }},
        {"leg_line", 0, "stretched",
         [](Player &p) {
             p.grab("foot");
             p.dragTo({490, 390}, 6);
         }},
        {"leg_line", 1, "compressed",
         [](Player &p) {
             p.grab("foot");
             p.dragTo(p.at("body"), 5);
             p.release();
             p.play(1);
         }},
        {"leg_line", 2, "a long leg",
         [](Player &p) {
             p.play(30);
             p.set("radius", 100.0);
             p.playUntilDone(900);
         }},
        {"leg_line", 3, "changed in the past",
         [](Player &p) {
             p.play(90);
             p.goTo(30);
             p.set("k", 0.1);
             p.play(30);
         }},
        // Near misses, with the expected hint
        {"mutual", 3, "with the other method",
         [](Player &p) {
             p.set("k", 0.3);
             p.useMethod("semi_implicit_euler");
             p.play(50);
         },
         "hands off, and let time run for 100 frames. So far: 50."},
        {"leg_line", 0, "stretched slightly",
         [](Player &p) {
             p.grab("foot");
             p.dragTo(p.at("foot") + sim::Vec2{5, 0}, 5);
         },
         "long 33"},
        {"leg_line", 1, "compressed, not released",
         [](Player &p) {
             p.grab("foot");
             p.dragTo(p.at("body"), 5);
         },
         "let_go"},
    };
}

}
