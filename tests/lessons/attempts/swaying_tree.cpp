#include "tests/lessons/attempts/attempts.h"

namespace support {

namespace {

/// Presses the button at `at` and plays `frames` frames.
void blow(Player &p, sim::Vec2 at, int frames)
{
    p.point(at, true);
    p.play(frames);
}

void blowAndRelease(Player &p, sim::Vec2 at, int frames)
{
    blow(p, at, frames);
    p.point(at, false);
}

/// Blows from `at`, then goes back and plays on with the other formula.
void compareFormulas(Player &p, sim::Vec2 at)
{
    p.play(5);
    blow(p, at, 30);
    p.goTo(20);
    p.set("formula", 1.0);
    p.playUntilDone(30);
}

}

ATTEMPTS(swaying_tree)
{
    return {
        {"trunk", 1, "set", [](Player &p) { p.set("base_length", 200.0); }},
        {"trunk", 0, "switched",
         [](Player &p) {
             p.play(10);
             p.set("formula", 1.0);
             p.play(1);
         }},
        {"trunk", 0, "switched with a longer trunk",
         [](Player &p) {
             p.set("base_length", 200.0);
             p.set("formula", 1.0);
             p.play(1);
         },
         "length"},
        {"branches", 2, "raised",
         [](Player &p) {
             p.set("min_scale", 0.7);
             p.play(1);
         }},
        {"branches", 0, "set", [](Player &p) { p.set("spread", 90.0); }},
        {"branches", 1, "set", [](Player &p) { p.set("slope", 0.7); }},
        {"branches", 1, "set in a tree with fewer branches",
         [](Player &p) {
             p.set("min_scale", 0.4);
             p.set("slope", 0.7);
         },
         "smallest"},
        {"randomness", 0, "set", [](Player &p) { p.set("jitter", 0.0); }},
        {"randomness", 1, "set", [](Player &p) { p.set("jitter", 60.0); }},
        {"randomness", 2, "chosen", [](Player &p) { p.set("spread", 90.0); }},
        {"towards_pointer", 0, "held on the right",
         [](Player &p) {
             blow(p, {500, 300}, 5);
         }},
        {"towards_pointer", 0, "held close to the trunk",
         [](Player &p) {
             blow(p, {300, 330}, 5);
         }},
        {"towards_pointer", 1, "held on the left, published",
         [](Player &p) {
             p.set("formula", 1.0);
             p.point({30, 150}, true);
             p.playUntilDone(120);
         }},
        {"towards_pointer", 2, "pulled down, released",
         [](Player &p) {
             blowAndRelease(p, {500, 390}, 10);
             p.play(30);
         }},
        {"wind", 0, "blown from low on the left",
         [](Player &p) {
             blow(p, {20, 390}, 60);
         }},
        {"wind", 1, "first fast, then slow",
         [](Player &p) {
             p.set("ease", 2.0);
             blowAndRelease(p, {20, 390}, 10);
             p.goTo(0);
             p.set("ease", 30.0);
             blow(p, {20, 390}, 12);
         }},
        {"wind", 2, "went back, other formula",
         [](Player &p) {
             compareFormulas(p, {200, 200});
         }},
        {"rest", 0, "blown from below",
         [](Player &p) {
             blowAndRelease(p, {275, 390}, 60);
             p.playUntilDone(200);
         }},
        {"rest", 1, "the same, slowly",
         [](Player &p) {
             p.set("ease", 30.0);
             blowAndRelease(p, {275, 390}, 200);
             p.playUntilDone(400);
         }},
        {"rest", 2, "stopped after the return",
         [](Player &p) {
             blow(p, {60, 200}, 20);
             p.stepPhases(3);
         }},
        {"distance", 0, "close to a twig",
         [](Player &p) {
             for (int frame = 0; frame < 100 && !p.done(); ++frame) {
                 const sim::Vec2 twig = p.at("branch254");
                 blow(p, {twig.x + 5.0, twig.y + 5.0}, 1);
             }
         }},
        {"distance", 1, "from a corner",
         [](Player &p) {
             blow(p, {5, 5}, 70);
         }},
        {"distance", 1, "from beside the trunk, where the wind hardly turns a branch",
         [](Player &p) {
             blow(p, {240, 320}, 70);
         },
         "far 47"},
        {"distance", 2, "went back, other formula",
         [](Player &p) {
             compareFormulas(p, {200, 200});
         }},
        {"thickness", 0, "blown from the left",
         [](Player &p) {
             blow(p, {30, 200}, 40);
         }},
        {"thickness", 1, "hard wind on the trunk",
         [](Player &p) {
             p.set("wind", 20.0);
             blow(p, {230, 330}, 60);
         }},
        {"thickness", 2, "went back, other formula",
         [](Player &p) {
             compareFormulas(p, {200, 200});
         }},
        {"turbulence", 0, "held",
         [](Player &p) {
             blow(p, {60, 200}, 65);
         }},
        {"turbulence", 1, "went back, no turbulence",
         [](Player &p) {
             p.play(5);
             blow(p, {60, 200}, 60);
             p.goTo(20);
             p.set("turbulence", 0.0);
             p.playUntilDone(40);
         }},
        {"turbulence", 2, "another tree",
         [](Player &p) {
             p.set("spread", 60.0);
             blow(p, {60, 200}, 40);
         }},
        {"real_sway", 0, "blown from the left, released",
         [](Player &p) {
             blowAndRelease(p, {60, 250}, 60);
             p.playUntilDone(300);
         }},
        {"real_sway", 0, "a short puff from the right",
         [](Player &p) {
             blowAndRelease(p, {500, 300}, 10);
             p.playUntilDone(300);
         }},
        {"real_sway", 1, "stopped half-way",
         [](Player &p) {
             p.point({5, 250}, true);
             p.playUntilDone(40);
         }},
        {"real_sway", 2, "without damping",
         [](Player &p) {
             p.set("damp", 1.0);
             blowAndRelease(p, {60, 250}, 30);
             p.play(320);
         }},
        {"real_sway", 3, "another tree",
         [](Player &p) {
             p.set("spread", 60.0);
             blow(p, {60, 200}, 60);
         }},
        // Near misses, with the expected hint
        {"branches", 2, "seven branches",
         [](Player &p) {
             p.set("min_scale", 0.6);
             p.play(1);
         },
         "three 7"},
        {"towards_pointer", 2, "high up",
         [](Player &p) {
             blowAndRelease(p, {300, 20}, 10);
             p.play(30);
         },
         "lean 4"},
        {"wind", 1, "for five frames",
         [](Player &p) {
             p.set("ease", 30.0);
             blow(p, {20, 390}, 5);
         },
         "frames 4"},
        {"turbulence", 0, "for 20 frames",
         [](Player &p) {
             blow(p, {60, 200}, 20);
         },
         "frames 19"},
    };
}

}
