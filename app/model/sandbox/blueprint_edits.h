#pragma once

#include "sim/scene/blueprint.h"

#include <optional>
#include <string>
#include <vector>

namespace app {

/// A selection of parts of a sandbox scene, by index. Each list is sorted and has no duplicates.
struct Selection
{
    std::vector<int> points;
    std::vector<int> springs;
    std::vector<int> sticks;
    std::vector<int> ruleLinks = {};

    bool isEmpty() const { return count() == 0; }
    std::size_t count() const { return points.size() + springs.size() + sticks.size() + ruleLinks.size(); }
    friend bool operator==(const Selection &, const Selection &) = default;
};

// Edits of a sandbox scene. Each one turns a valid plan into a plan that a file can hold. If a limit is reached, or
// both ends are the same point, the plan stays as it is and the result is empty.

/// Adds a free point of standard mass and size, named p and the first free number.
std::optional<int> addPoint(sim::Blueprint &plan, sim::Vec2 at);
/// Adds a spring whose rest length is the distance of its ends, with the stiffness of the last spring.
std::optional<int> addSpring(sim::Blueprint &plan, int a, int b);
/// Adds a stick whose length is the distance of its ends. Each end corrects a share of the error that depends on its
/// mass.
std::optional<int> addStick(sim::Blueprint &plan, int a, int b);
/// Adds a link along which the learner's rule acts. Empty if these points have one already.
std::optional<int> addRuleLink(sim::Blueprint &plan, int a, int b);
/// Adds a rule link between each two of `points` that have none. If there is not enough room for all of them, nothing
/// changes and the result is empty. Otherwise it is the number of new links.
std::optional<int> addRuleLinksAmong(sim::Blueprint &plan, const std::vector<int> &points);
/// Makes `foot` a foot of `body` in the last gait group, at its present angle. Empty if `foot` is already a foot.
std::optional<int> addFoot(sim::Blueprint &plan, int foot, int body);
/// Adds a gait group that copies the last one. Returns its number.
std::optional<int> addGait(sim::Blueprint &plan);

/// Removes the selected parts, and all parts that would lose an end.
void erase(sim::Blueprint &plan, const Selection &chosen);
/// Copies the selected points and the links between them, moved by `by` px. Returns the copies. If there is not enough
/// room for all of them, nothing changes and the result is empty.
std::optional<Selection> duplicate(sim::Blueprint &plan, const Selection &chosen, sim::Vec2 by);
/// Moves points. Links that were at their rest length get the new distance as their length. A foot that stood at its
/// angle gets the new angle, if its body stays.
void moveBy(sim::Blueprint &plan, const std::vector<int> &points, sim::Vec2 by);
/// Updates lengths and angles in the same way, for points that have moved since `before`.
void keepTies(sim::Blueprint &plan, const sim::Blueprint &before);

/// Returns all parts of the plan.
Selection everything(const sim::Blueprint &plan);
/// Returns the points whose centres are in the box with these two corners, and the links between them.
Selection inBox(const sim::Blueprint &plan, sim::Vec2 one, sim::Vec2 other);
/// Returns the parts of `chosen` that exist in `plan`.
Selection within(const sim::Blueprint &plan, const Selection &chosen);

/// Returns the index of the point with this name. Empty if there is none.
std::optional<int> pointCalled(const sim::Blueprint &plan, const std::string &name);
/// Returns the index of `point` in the plan's list of feet. Empty if it is not a foot.
std::optional<int> footOf(const sim::Blueprint &plan, int point);

}
