#include "tests/lessons/attempts/attempts.h"

namespace support {

ATTEMPTS(multi_foot)
{
    return {
        {"two_feet", 0, "a foot pulled out",
         [](Player &p) {
             p.drag("foot0", {420, 300}, 20);
             p.playUntilDone(600);
         }},
        {"two_feet", 1, "the body dragged",
         [](Player &p) {
             p.grab("body");
             p.dragTo({500, 200}, 20);
         }},
        {"two_feet", 2, "flies away",
         [](Player &p) {
             p.set("damp", 0.9);
             p.playUntilDone(900);
         }},
        {"any_number", 0, "a foot pulled out",
         [](Player &p) {
             p.drag("foot3", {100, 190}, 20);
             p.playUntilDone(600);
         }},
        {"any_number", 1, "twelve feet",
         [](Player &p) {
             p.play(40);
             p.set("feet", 12.0);
             p.playUntilDone(201);
         }},
        {"any_number", 2, "changed in the past",
         [](Player &p) {
             p.play(90);
             p.goTo(30);
             p.set("damp", 0.7);
             p.play(30);
         }},
        {"grown_feet", 0, "sixteen feet, moved all at once",
         [](Player &p) {
             p.play(50);
             p.set("feet", 16.0);
             p.play(100);
             p.useMethod("semi_implicit_euler");
             p.playUntilDone(900);
         }},
        {"grown_feet", 1, "sixty feet",
         [](Player &p) {
             p.set("feet", 60.0);
             p.playUntilDone(900);
         }},
        {"grown_feet", 2, "sixty feet with half-frame steps, after the instability",
         [](Player &p) {
             p.set("feet", 60.0);
             p.play(600);
             p.reset();
             p.useStep(0.5);
             p.playUntilDone(600);
         }},
        // Near misses, with the expected hint
        {"two_feet", 0, "not far enough",
         [](Player &p) {
             p.drag("foot0", p.at("foot0") + sim::Vec2{50, 0}, 20);
             p.play(400);
         },
         "carry it 75 px or more. It came 50 px."},
        {"any_number", 1, "too short",
         [](Player &p) {
             p.set("feet", 12.0);
             p.play(150);
         },
         "let time run for 200 frames with this value. So far: 150."},
        {"grown_feet", 0, "with the published method",
         [](Player &p) {
             p.set("feet", 16.0);
             p.play(5);
         },
         "method"},
    };
}

}
