#include "tests/lessons/attempts/attempts.h"

namespace support {

ATTEMPTS(single_spring)
{
    const auto slowThrow = [](Player &p) { p.drag("foot", {310, 170}, 6); };
    return {
        {"drag", 0, "to the cross",
         [](Player &p) {
             p.grab("foot");
             p.dragTo({270, 205}, 30);
             p.play(5); // holds still, so that the release is no throw
             p.release();
             p.playUntilDone(200);
         }},
        {"drag", 1, "thrown",
         [=](Player &p) {
             slowThrow(p);
             p.playUntilDone(200);
         }},
        {"drag", 2, "thrown without damping",
         [=](Player &p) {
             p.set("damp", 1.0);
             slowThrow(p);
             p.playUntilDone(61);
         }},
        {"fixed_centre", 0, "pulled out",
         [](Player &p) {
             p.drag("foot", {100, 100}, 10);
             p.playUntilDone(300);
         }},
        {"fixed_centre", 1, "stopped inside",
         [](Player &p) {
             p.play(7);
             p.stepPhases(1);
         }},
        {"fixed_centre", 2, "no damping",
         [](Player &p) {
             p.play(50);
             p.set("damp", 1.0);
             p.drag("foot", {100, 100}, 10);
             p.playUntilDone(101);
         }},
        {"fixed_centre", 3, "changed in the past",
         [](Player &p) {
             p.play(90);
             p.goTo(30);
             p.set("damp", 0.7);
             p.play(30);
         }},
        {"moving_body", 0, "body dragged away",
         [](Player &p) {
             p.play(20);
             p.drag("body", {500, 200}, 20);
             p.playUntilDone(300);
         }},
        {"moving_body", 1, "far behind",
         [](Player &p) {
             p.set("k", 0.02);
             p.play(60);
             p.grab("body");
             p.dragTo({520, 380}, 6);
             p.dragTo({20, 20}, 15);
         }},
        {"moving_body", 2, "thrown and stopped",
         [=](Player &p) {
             slowThrow(p);
             p.play(3);
             p.stepPhases(1);
         }},
        {"offset", 0, "from the left",
         [](Player &p) {
             p.drag("foot", {150, 250}, 9);
             p.playUntilDone(300);
         }},
        {"offset", 1, "to the left",
         [](Player &p) {
             p.play(30);
             p.set("offset", -60.0);
             p.playUntilDone(300);
         }},
        {"offset", 2, "body dragged",
         [](Player &p) {
             p.drag("body", {400, 200}, 9);
             p.play(1);
         }},
        {"radial", 0, "on the left",
         [](Player &p) {
             p.drag("foot", {215, 205}, 20);
             p.play(2);
             p.playUntilDone(300);
         }},
        {"radial", 1, "held below",
         [](Player &p) {
             p.grab("foot");
             p.dragTo({270, 290}, 10);
             p.play(6);
         }},
        {"radial", 2, "a wide ring",
         [](Player &p) {
             p.set("radius", 120.0);
             p.playUntilDone(300);
         }},
        {"radial", 3, "stopped inside", [](Player &p) { p.stepPhases(1); }},
        // Near misses, with the expected hint
        {"drag", 0, "to the cross, released at once",
         [](Player &p) {
             p.grab("foot");
             p.dragTo({270, 205}, 20);
             p.release();
             p.play(1);
         },
         "slow 8.6"},
        {"drag", 0, "beside the cross",
         [](Player &p) {
             p.grab("foot");
             p.dragTo({300, 240}, 30);
             p.play(5);
             p.release();
             p.play(200);
         },
         "near 50.0"},
        {"drag", 1, "too slow",
         [](Player &p) {
             p.drag("foot", {440, 120}, 20);
             p.play(200);
         },
         "let go while the mouse moves, at 5 px per frame or more. You let go at 1.0."},
        {"drag", 1, "not yet still",
         [](Player &p) {
             p.drag("foot", {310, 170}, 6);
             p.play(5);
         },
         "let time run (**Space**) until nothing moves."},
        {"drag", 2, "too slow",
         [](Player &p) {
             p.set("damp", 1.0);
             p.drag("foot", {440, 120}, 20);
             p.play(100);
         },
         "let go while the mouse moves, at 5 px per frame or more. You let go at 1.0."},
        {"drag", 2, "after 40 frames",
         [](Player &p) {
             p.set("damp", 1.0);
             p.drag("foot", {310, 170}, 6);
             p.play(40);
         },
         "frames 39"},
        {"drag", 2, "thrown before damping was set",
         [](Player &p) {
             p.drag("foot", {310, 170}, 6);
             p.play(5);
             p.set("damp", 1.0);
             p.play(70);
         },
         "take it with the mouse, and let go of it."},
        {"fixed_centre", 0, "not far enough",
         [](Player &p) {
             p.drag("foot", {270, 250}, 20);
             p.play(300);
         },
         "far 50"},
        {"fixed_centre", 3, "played on for five frames",
         [](Player &p) {
             p.play(90);
             p.goTo(30);
             p.set("damp", 0.7);
             p.play(5);
         },
         "play on for 10 frames from where the two part. So far: 4."},
        {"moving_body", 0, "not far enough",
         [](Player &p) {
             p.drag("body", {330, 200}, 20);
             p.play(300);
         },
         "carry it 100 px or more. It came 60 px."},
        {"offset", 1, "only −5",
         [](Player &p) {
             p.set("offset", -5.0);
             p.play(300);
         },
         "offset −5"},
        {"radial", 0, "on the right",
         [](Player &p) {
             p.drag("foot", {350, 205}, 20);
             p.play(300);
         },
         "left"},
        {"radial", 1, "below on the right",
         [](Player &p) {
             p.grab("foot");
             p.dragTo({320, 250}, 10);
         },
         "below 45"},
        {"radial", 1, "only passing below",
         [](Player &p) {
             p.grab("foot");
             p.dragTo({270, 290}, 10);
         },
         "held_still"},
    };
}

}
