#pragma once

#include "sim/scene/blueprint.h"
#include "sim/scene/parameter_spec.h"
#include "sim/scene/state.h"

#include <Eigen/Core>

#include <initializer_list>
#include <map>
#include <utility>

namespace sim {

/// A scene translated to a Blueprint, so that a learner can edit it in the sandbox.
struct BlueprintDraft
{
    Blueprint blueprint;
    std::map<std::string, double> parameters; ///< of the scene, by id
    std::vector<std::string> omitted;         ///< what a blueprint cannot express, in English; see SIM_TEXT
    /// The state of the original scene. Points that the blueprint has in addition are fixed ends of springs.
    State state;

    /// Adds the effect with the id `effect`, unless it is there already, and sets its parameters.
    void addEffect(const std::string &effect,
                   std::initializer_list<std::pair<const char *, double>> settings);
    /// Adds a spring. A spring of a blueprint always pulls both ends. If the original pulls only `a`
    /// (`pullsBoth` is false) and `b` is not fixed, the difference is added to `omitted`.
    void addSpring(const BlueprintSpring &spring, bool pullsBoth);
    /// Adds a fixed point at `x` (px) and returns its index. If a point called `name` exists, a number is
    /// appended to the name.
    int addFixedPoint(const std::string &name, Vec2 x);
    /// Adds `what` to `omitted`, once.
    void omit(const std::string &what);
};

/// Returns whether the scene has the effect `id`.
bool hasEffect(const Blueprint &blueprint, const std::string &id);

/// Returns the value of a point property at `point`, or the default value if the point does not set it.
double valueOf(const BlueprintPoint &point, const ParameterSpec &parameter);
/// Sets a point property. The default value is not stored.
void setValue(BlueprintPoint &point, const ParameterSpec &parameter, double value);
/// Returns the values of a point property, one per point.
Eigen::ArrayXd valuesOf(const Blueprint &blueprint, const ParameterSpec &parameter);

/// Returns the width of each point in px.
Eigen::ArrayXd widths(const Blueprint &blueprint);
/// Returns half the width of each point in px.
Eigen::ArrayXd halfWidths(const Blueprint &blueprint);

/// Returns the points that are feet, in ascending order.
std::vector<int> feetOf(const Blueprint &blueprint);

// A scene has one clock for each gait group, then the wind's clock, then one for points that belong to no
// leg. The last one is the time for a rule that reads it.

/// Returns the number of clocks.
int clockCount(const Blueprint &blueprint);
/// Returns the index of the wind's clock.
int windClockOf(const Blueprint &blueprint);
/// Returns the index of the clock that advances by 1 per frame, for a rule that reads the time.
int ruleClockOf(const Blueprint &blueprint);
/// Returns whether the rule of `blueprint` reads the time.
bool hasRuleClock(const Blueprint &blueprint);
/// Returns the index of the clock that each point follows.
std::vector<int> clockOf(const Blueprint &blueprint);
/// Returns, for each clock, the other gait clocks of the same creature: their groups have feet on the same
/// bodies.
std::vector<std::vector<int>> partnerClocksOf(const Blueprint &blueprint);

}
