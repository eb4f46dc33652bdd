#include "tests/lessons/attempts/attempts.h"

namespace support {

namespace {

/// Sends the codeling back and forth between two targets.
void sendBackAndForth(Player &p, sim::Vec2 a, sim::Vec2 b, int times, int frames)
{
    for (int i = 0; i < times && !p.done(); ++i) {
        p.target(i % 2 ? b : a);
        p.playUntilDone(frames);
    }
}

}

ATTEMPTS(codeling)
{
    return {
        {"motor", 0, "sent to the right",
         [](Player &p) {
             p.play(5);
             p.target({420, 150});
             p.playUntilDone(200);
         }},
        {"motor", 1, "thrown",
         [](Player &p) {
             p.drag("lead", {400, 300}, 10);
             p.playUntilDone(200);
         }},
        {"motor", 2, "keep 1",
         [](Player &p) {
             p.set("keep", 1.0);
             p.target({300, 100});
             p.playUntilDone(150);
         }},
        {"orientation", 0, "sent up, then to the left",
         [](Player &p) {
             p.target({250, 60});
             p.play(40);
             p.target({60, 60});
             p.playUntilDone(100);
         }},
        {"orientation", 1, "pulled by its tail",
         [](Player &p) {
             p.play(5);
             p.drag("tail", {40, 320}, 20);
             p.playUntilDone(300);
         }},
        {"orientation", 2, "stopped after the move",
         [](Player &p) {
             p.target({480, 200});
             for (int i = 0; i < 60 && !p.done(); ++i)
                 p.stepPhases(1);
         }},
        {"anticipation", 0, "stopped after the shift",
         [](Player &p) {
             p.play(5);
             p.target({450, 200});
             p.stepPhases(1);
         }},
        {"anticipation", 1, "winds up",
         [](Player &p) {
             p.set("anticipation", 0.6);
             p.target({400, 300});
             p.playUntilDone(20);
         }},
        {"anticipation", 2, "another anticipation",
         [](Player &p) {
             p.play(10);
             p.target({450, 200});
             p.play(40);
             p.goTo(8);
             p.set("anticipation", 0.5);
             p.play(15);
         }},
        {"squash_stretch", 0, "sent far",
         [](Player &p) {
             p.target({500, 80});
             p.playUntilDone(60);
         }},
        {"squash_stretch", 1, "sent straight ahead",
         [](Player &p) {
             p.play(5);
             p.target({520, 200});
             p.playUntilDone(60);
         }},
        {"squash_stretch", 2, "rigid",
         [](Player &p) {
             p.target({500, 80});
             p.play(40);
             p.goTo(5);
             p.set("soft", 1.0);
             p.play(20);
         }},
        {"volume", 0, "squashed",
         [](Player &p) {
             p.play(5);
             p.target({520, 200});
             p.playUntilDone(60);
         }},
        {"volume", 1, "stretched",
         [](Player &p) {
             p.target({500, 80});
             p.playUntilDone(60);
         }},
        {"volume", 2, "pulled at a side",
         [](Player &p) {
             p.play(5);
             p.grab("side0");
             p.dragTo({180, 120}, 20);
             p.playUntilDone(30);
         }},
        {"tentacles", 0, "eight tentacles",
         [](Player &p) {
             p.set("tentacles", 8.0);
             p.target({450, 120});
             p.playUntilDone(200);
         }},
        {"tentacles", 1, "back and forth",
         [](Player &p) {
             p.set("water", 0.98);
             sendBackAndForth(p, {500, 60}, {60, 340}, 12, 15);
         }},
        {"tentacles", 2, "thicker water",
         [](Player &p) {
             p.target({500, 80});
             p.play(40);
             p.goTo(5);
             p.set("water", 0.5);
             p.play(20);
         }},
        // Near misses, with the expected hint
        {"motor", 0, "too close",
         [](Player &p) {
             p.play(5);
             p.target(p.at("lead") + sim::Vec2{30, 40});
             p.play(200);
         },
         "distance 50"},
        {"motor", 2, "sent before keep was set",
         [](Player &p) {
             p.target({300, 100});
             p.play(150);
             p.set("keep", 1.0);
             p.play(110);
         },
         "click"},
        {"motor", 1, "too slow",
         [](Player &p) {
             p.drag("lead", p.at("lead") + sim::Vec2{20, 0}, 10);
             p.play(100);
         },
         "let go while the mouse moves, at 5 px per frame or more. You let go at 2.0."},
        {"squash_stretch", 1, "sent behind its tail",
         [](Player &p) {
             p.play(5);
             p.target({80, 200});
             p.play(60);
         },
         "ahead"},
        {"squash_stretch", 2, "not 1",
         [](Player &p) {
             p.target({500, 80});
             p.play(40);
             p.goTo(5);
             p.set("soft", 0.5);
             p.play(20);
         },
         "soft"},
    };
}

}
