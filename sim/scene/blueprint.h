#pragma once

#include "sim/base/vec2.h"

#include <map>
#include <string>
#include <vector>

namespace sim {

/// A body of a scene that somebody built.
struct BlueprintPoint
{
    std::string name; ///< how files and events call it; no two have one name
    Vec2 x;           ///< px
    Vec2 v;           ///< px/frame
    double mass = 1.0;
    double size = 10.0; ///< px, its width: walls stop its edge, and wind takes hold of it
    bool fixed = false; ///< stands where it is, and feels nothing
    /// What effects read of it besides, by the id of the setting; what is not there has its preset. See
    /// Description::ofPoints.
    std::map<std::string, double> properties = {};
    friend bool operator==(const BlueprintPoint &, const BlueprintPoint &) = default;
};

/// A spring between two points, both of which feel it.
struct BlueprintSpring
{
    int a = 0;
    int b = 0;
    double k = 0.2;       ///< mass/frame^2
    double length = 50.0; ///< px, at which it neither pulls nor pushes
    friend bool operator==(const BlueprintSpring &, const BlueprintSpring &) = default;
};

/// A stick between two points, which keeps its length.
struct BlueprintStick
{
    int a = 0;
    int b = 0;
    double length = 50.0; ///< px
    double share = 0.5;   ///< of a wrong length, the part that `a` makes good; `b` does the rest
    friend bool operator==(const BlueprintStick &, const BlueprintStick &) = default;
};

/// A leg that knows where its foot belongs, as seen from its body.
struct BlueprintFoot
{
    int foot = 0;
    int body = 0;
    double angle = 0.0; ///< degrees; 0 is straight left of the body, 90 straight above it
    int gait = 0;       ///< which of the gait groups it belongs to
    friend bool operator==(const BlueprintFoot &, const BlueprintFoot &) = default;
};

/// What the legs of one gait group have in common.
struct BlueprintGait
{
    double k = 0.2;        ///< mass/frame^2
    double leg = 50.0;     ///< px, from the middle of all places of a foot to each
    double drop = 50.0;    ///< px, how far that middle lies below the body
    double speed = 0.0;    ///< rad/frame, at which the group's clock turns the legs
    double start = 0.0;    ///< rad, where that clock begins
    bool pullsBody = true; ///< whether the body feels what its feet feel, turned round
    friend bool operator==(const BlueprintGait &, const BlueprintGait &) = default;
};

/// A scene that somebody built, as plain values: what there is, and what acts on it. The numbers of what acts on all
/// of it (gravity, damping, walls...) are parameters.
struct Blueprint
{
    std::vector<BlueprintPoint> points;
    std::vector<BlueprintSpring> springs;
    std::vector<BlueprintStick> sticks; ///< in the order in which they are enforced
    std::vector<BlueprintFoot> feet;
    std::vector<BlueprintGait> gaits;
    std::vector<std::string> effects; ///< ids of what acts besides springs, sticks and legs
    friend bool operator==(const Blueprint &, const Blueprint &) = default;
};

}
