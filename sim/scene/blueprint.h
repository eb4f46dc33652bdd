#pragma once

#include "sim/base/vec2.h"
#include "sim/scene/rule.h"

#include <map>
#include <string>
#include <vector>

namespace sim {

/// A body of a scene that a learner built.
struct BlueprintPoint
{
    std::string name; ///< unique; files and events use it
    Vec2 x;           ///< px
    Vec2 v;           ///< px/frame
    double mass = 1.0;
    double size = 10.0; ///< px, width: walls stop its edge, and the wind's force is proportional to it
    bool fixed = false; ///< whether it keeps its position and feels no force
    /// Further numbers that effects read, by parameter id; a missing one has its default value. See
    /// EffectDescription::pointProperties.
    std::map<std::string, double> properties = {};
    friend bool operator==(const BlueprintPoint &, const BlueprintPoint &) = default;
};

/// A spring between the points `a` and `b`. Both feel it.
struct BlueprintSpring
{
    int a = 0;
    int b = 0;
    double k = 0.2;       ///< mass/frame^2
    double length = 50.0; ///< px, rest length
    friend bool operator==(const BlueprintSpring &, const BlueprintSpring &) = default;
};

/// A stick of constant length between the points `a` and `b`.
struct BlueprintStick
{
    int a = 0;
    int b = 0;
    double length = 50.0; ///< px
    double share = 0.5;   ///< fraction of a length error that `a` corrects; `b` corrects the rest
    friend bool operator==(const BlueprintStick &, const BlueprintStick &) = default;
};

/// A leg: a spring that pulls the point `foot` to a target position relative to the point `body`.
struct BlueprintFoot
{
    int foot = 0;
    int body = 0;
    double angle = 0.0; ///< degrees, direction of the target: 0 is left of the body, 90 above it
    int gait = 0;       ///< index of its gait group in Blueprint::gaits
    friend bool operator==(const BlueprintFoot &, const BlueprintFoot &) = default;
};

/// The parameters that all legs of a gait group share. The gait clock turns the targets of the feet on a
/// circle.
struct BlueprintGait
{
    double k = 0.2;        ///< mass/frame^2
    double leg = 50.0;     ///< px, radius of that circle
    double drop = 50.0;    ///< px, how far the circle's centre lies below the body
    double speed = 0.0;    ///< rad/frame, angular velocity of the gait clock
    double start = 0.0;    ///< rad, gait clock at the start
    bool pullsBody = true; ///< whether the body feels the reaction to the forces on its feet
    friend bool operator==(const BlueprintGait &, const BlueprintGait &) = default;
};

/// A pair of points on which the function `pull` of the rule acts. Each end feels the force for its own `me`.
struct BlueprintRuleLink
{
    int a = 0;
    int b = 0;
    friend bool operator==(const BlueprintRuleLink &, const BlueprintRuleLink &) = default;
};

/// A scene that a learner built, as plain values. The numbers of effects that act on the whole scene
/// (gravity, damping, walls...) are not in it: they are parameters in Values.
struct Blueprint
{
    std::vector<BlueprintPoint> points;
    std::vector<BlueprintSpring> springs;
    std::vector<BlueprintStick> sticks; ///< in the order in which they are enforced
    std::vector<BlueprintFoot> feet;
    std::vector<BlueprintGait> gaits;
    std::vector<std::string> effects; ///< ids of the effects besides springs, sticks, legs and the rule
    BlueprintRule rule = {};          ///< a force that the learner wrote
    std::vector<BlueprintRuleLink> ruleLinks = {};
    friend bool operator==(const Blueprint &, const Blueprint &) = default;
};

}
