#include "tests/lessons/attempts.h"

namespace support {

std::vector<Attempt> attempts()
{
    const auto slowThrow = [](Player &p) { p.drag("foot", {150, 150}, 12); };
    return {
        {"drag", 0, "to the cross",
         [](Player &p) {
             p.grab("foot");
             p.carryTo({270, 205}, 30);
             p.play(5); // holds still: lets go without a throw
             p.letGo();
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
        {"fixed_centre", 3, "a ghost",
         [](Player &p) {
             p.play(90);
             p.goTo(30);
             p.set("damp", 0.7);
             p.play(30);
         }},
        {"moving_body", 0, "carried away",
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
             p.carryTo({520, 380}, 6);
             p.carryTo({20, 20}, 15);
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
        {"offset", 2, "carried",
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
             p.carryTo({270, 290}, 10);
         }},
        {"radial", 2, "a wide ring",
         [](Player &p) {
             p.set("radius", 120.0);
             p.playUntilDone(300);
         }},
        {"radial", 3, "stopped inside", [](Player &p) { p.stepPhases(1); }},
    };
}

}
