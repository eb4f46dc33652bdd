#pragma once

#include "sim/scene/blueprint.h"

#include <optional>
#include <vector>

namespace app {

/// Parts of a built scene, by number; each list in order, without one twice.
struct Chosen
{
    std::vector<int> points;
    std::vector<int> springs;
    std::vector<int> sticks;

    bool isEmpty() const { return points.empty() && springs.empty() && sticks.empty(); }
    std::size_t count() const { return points.size() + springs.size() + sticks.size(); }
    friend bool operator==(const Chosen &, const Chosen &) = default;
};

// What a learner changes in a built scene. Each takes a plan and leaves one that a file can hold; where there is no
// more room for one more of a kind, or the two ends are one point, nothing changes and nothing is returned.

/// A free point of the usual mass and size, called p and the first number that is free.
std::optional<int> addPoint(sim::Blueprint &plan, sim::Vec2 at);
/// A spring that is as long as its ends are apart, with the stiffness of the one built last.
std::optional<int> addSpring(sim::Blueprint &plan, int a, int b);
/// A stick that is as long as its ends are apart; each end takes as much of an error as its mass lets it.
std::optional<int> addStick(sim::Blueprint &plan, int a, int b);
/// `foot` as a foot of `body`, of the last gait group, at the angle at which it is now; nothing for what is a foot.
std::optional<int> addFoot(sim::Blueprint &plan, int foot, int body);
/// Another gait group like the last. Returns its number.
std::optional<int> addGait(sim::Blueprint &plan);

/// Without what is chosen, and without what would have lost an end.
void erase(sim::Blueprint &plan, const Chosen &chosen);
/// The chosen points and what ties them, once more, `by` px away. Returns what is new; nothing, and nothing changes, where
/// there is no room for all of it.
std::optional<Chosen> duplicate(sim::Blueprint &plan, const Chosen &chosen, sim::Vec2 by);
/// Moves points. What was as long as it should be stays so: its length follows. So does the angle of a foot that stood at
/// it, where its body stays.
void moveBy(sim::Blueprint &plan, const std::vector<int> &points, sim::Vec2 by);
/// The same for points that stand elsewhere now than they did `before`.
void keepTies(sim::Blueprint &plan, const sim::Blueprint &before);

/// Everything there is.
Chosen everything(const sim::Blueprint &plan);
/// The points whose middle is in the box of these two corners, and what ties them.
Chosen inBox(const sim::Blueprint &plan, sim::Vec2 one, sim::Vec2 other);
/// Those of `chosen` that there are in `plan`.
Chosen within(const sim::Blueprint &plan, const Chosen &chosen);

/// The foot that `point` is, as a number in the plan's list; empty where it is none.
std::optional<int> footOf(const sim::Blueprint &plan, int point);

}
