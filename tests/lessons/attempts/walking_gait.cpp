#include "tests/lessons/attempts/attempts.h"

#include <algorithm>
#include <cmath>

namespace support {

namespace {

std::vector<Attempt> standingAttempts()
{
    return {
        {"bones", 0, "pulled over and released",
         [](Player &p) {
             p.drag("foot0", {380, 200}, 20);
             p.playUntilDone(400);
         }},
        {"bones", 1, "body dragged",
         [](Player &p) {
             p.drag("body", {100, 150}, 40);
         }},
        {"bones", 2, "stopped after the springs", [](Player &p) { p.stepPhases(1); }},
        {"legs", 0, "longer legs",
         [](Player &p) {
             p.set("leg", 100.0);
             p.playUntilDone(400);
         }},
        {"legs", 1, "pulled out",
         [](Player &p) {
             p.drag("foot1", {450, 260}, 20);
             p.play(1);
         }},
        {"feet_below", 0, "without drop",
         [](Player &p) {
             p.set("drop", 0.0);
             p.playUntilDone(400);
         }},
        {"feet_below", 1, "above the body",
         [](Player &p) {
             p.set("drop", -50.0);
             p.playUntilDone(400);
         }},
        {"feet_below", 2, "body dragged",
         [](Player &p) {
             p.drag("body", {100, 250}, 40);
         }},
        {"curved_legs", 0, "straight", [](Player &p) { p.set("curve", 0.0); }},
        {"curved_legs", 1, "compared with the ghost",
         [](Player &p) {
             p.drag("body", {400, 250}, 20);
             p.play(20);
             p.goTo(5);
             p.set("curve", 120.0);
             p.play(20);
         }},
        {"curved_legs", 2, "curved the other way", [](Player &p) { p.set("curve", -30.0); }},
        {"swing", 0, "backwards",
         [](Player &p) {
             p.set("speed", -0.05);
             p.play(70);
         }},
        {"swing", 1, "near its natural frequency",
         [](Player &p) {
             p.set("speed", 0.45);
             p.playUntilDone(300);
         }},
        {"swing", 2, "body dragged",
         [](Player &p) {
             p.drag("body", {480, 300}, 100);
         }},
        {"body_pulled", 0, "pulled by a foot",
         [](Player &p) {
             p.drag("foot0", {80, 300}, 20);
             p.play(1);
         }},
        {"body_pulled", 1, "thrown without damping",
         [](Player &p) {
             p.set("damp", 1.0);
             p.drag("body", {370, 260}, 10);
             p.playUntilDone(150);
         }},
        {"body_pulled", 1, "a foot thrown without damping",
         [](Player &p) {
             p.set("damp", 1.0);
             p.drag("foot1", {460, 300}, 10);
             p.playUntilDone(150);
         }},
        {"body_pulled", 2, "held by a foot",
         [](Player &p) {
             p.play(10);
             p.grab("foot1");
             p.playUntilDone(80);
         }},
        // Near misses, with the expected hint
        {"bones", 0, "not over to the right",
         [](Player &p) {
             p.drag("foot0", {150, 200}, 20);
             p.play(300);
         },
         "past_body −20"},
        {"curved_legs", 1, "without dragging",
         [](Player &p) {
             p.play(30);
             p.goTo(5);
             p.set("curve", 120.0);
             p.play(20);
         },
         "carried"},
        {"swing", 2, "up and down",
         [](Player &p) {
             p.drag("body", p.at("body") + sim::Vec2{0, -100}, 100);
         },
         "sideways 0"},
        {"body_pulled", 1, "thrown before damping was set",
         [](Player &p) {
             p.drag("body", p.at("body") + sim::Vec2{60, -40}, 6);
             p.set("damp", 1.0);
             p.play(120);
         },
         "take it with the mouse, and let go of it."},
        {"ground", 0, "not far enough",
         [](Player &p) {
             p.set("speed", -0.05);
             p.play(3);
         },
         "walked 0"},
        {"ground", 2, "before any foot bounces", [](Player &p) { p.set("bounce", 0.8); }, "bounces"},
        {"steering", 1, "by key after a click",
         [](Player &p) {
             p.point({300, 300}, true);
             p.play(1);
             p.point({300, 300}, false);
             p.set("top", 0.05);
             p.key(&sim::Keys::left, true);
             p.play(60);
         },
         "pointer"},
        {"steering", 2, "only passing through",
         [](Player &p) {
             p.key(&sim::Keys::left, true);
             for (int i = 0; i < 25 && p.run().state().gaitSpeed[0] > 0.004; ++i)
                 p.play(1);
         },
         "stands"},
        {"ground", 3, "dragged to the side",
         [](Player &p) {
             p.play(50);
             p.drag("body", p.at("body") + sim::Vec2{140, 0}, 30);
             p.play(3);
         },
         "lifted 0"},
    };
}

std::vector<Attempt> groundAttempts()
{
    return {
        {"ground", 0, "to the left",
         [](Player &p) {
             p.set("speed", -0.05);
             p.playUntilDone(400);
         }},
        {"ground", 1, "ice",
         [](Player &p) {
             p.play(100);
             p.set("traction", 1.0);
             p.playUntilDone(200);
         }},
        {"ground", 2, "a bouncing foot",
         [](Player &p) {
             p.set("bounce", 0.8);
             p.playUntilDone(400);
         }},
        {"ground", 3, "lifted",
         [](Player &p) {
             p.play(50);
             p.drag("body", p.at("body") + sim::Vec2{30, -140}, 30);
             p.playUntilDone(300);
         }},
        {"more_feet", 0, "twelve feet",
         [](Player &p) {
             p.set("feet", 12.0);
             p.play(210);
         }},
        {"more_feet", 0, "twelve feet in step",
         [](Player &p) {
             p.set("spread", 0.0);
             p.set("feet", 12.0);
             p.play(210);
         },
         "spread"},
        {"more_feet", 1, "feet in step",
         [](Player &p) {
             p.set("spread", 0.0);
             p.play(210);
         }},
        {"more_feet", 2, "off the ground",
         [](Player &p) {
             p.set("speed", 0.3);
             p.playUntilDone(300);
         }},
    };
}

std::vector<Attempt> variationAttempts()
{
    return {
        {"steering", 0, "by key",
         [](Player &p) {
             p.play(20);
             p.key(&sim::Keys::left, true);
             p.play(45);
             p.key(&sim::Keys::left, false);
             p.playUntilDone(300);
         }},
        {"steering", 1, "by pointer",
         [](Player &p) {
             p.play(5);
             p.point({20, 300}, true);
             p.playUntilDone(5);
             p.point({20, 300}, false);
         }},
        {"steering", 2, "by key",
         [](Player &p) {
             const auto speed = [&] { return p.run().state().gaitSpeed[0]; };
             // Time runs while a key is down: a busy machine may release it some frames late.
             for (int presses = 0; presses < 5 && std::abs(speed()) > 0.004; ++presses) {
                 const bool isForward = speed() > 0.0;
                 const auto key = isForward ? &sim::Keys::left : &sim::Keys::right;
                 p.key(key, true);
                 for (int i = 0; i < 25 && std::abs(speed()) > 0.004 && (speed() > 0.0) == isForward; ++i)
                     p.play(1);
                 p.key(key, false);
             }
             p.playUntilDone(15);
         }},
        {"steering", 2, "by the pointer on the body",
         [](Player &p) {
             p.play(30);
             p.point(p.at("body"), true);
             p.playUntilDone(40);
         }},
        {"walls", 0, "walking on",
         [](Player &p) {
             p.set("at_wall", 1.0);
             p.playUntilDone(400);
         }},
        {"walls", 1, "a narrow room",
         [](Player &p) {
             p.set("left", 200.0);
             p.set("right", 340.0);
             p.playUntilDone(300);
         }},
        {"walls", 2, "thrown",
         [](Player &p) {
             p.drag("body", {420, 280}, 10);
             p.playUntilDone(60);
         }},
        {"company", 0, "dragged into the other",
         [](Player &p) {
             p.play(5);
             p.grab("creature0.body");
             p.dragTo(p.at("creature1.body") + sim::Vec2{-30, 0}, 30);
         }},
        {"company", 1, "only one feels the push",
         [](Player &p) {
             p.set("felt_by", 1.0);
             p.playUntilDone(400);
         }},
        {"company", 2, "five creatures",
         [](Player &p) {
             p.set("creatures", 5.0);
             p.play(310);
         }},
    };
}

}

ATTEMPTS(walking_gait)
{
    std::vector<Attempt> all;
    for (const std::vector<Attempt> &part : {standingAttempts(), groundAttempts(), variationAttempts()})
        all.insert(all.end(), part.begin(), part.end());
    return all;
}

}
