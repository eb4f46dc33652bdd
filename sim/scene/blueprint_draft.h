#pragma once

#include "sim/scene/blueprint.h"
#include "sim/scene/parameter_spec.h"
#include "sim/scene/state.h"

#include <Eigen/Core>

#include <initializer_list>
#include <map>
#include <utility>

namespace sim {

/// A scene as a learner could have built it.
struct BlueprintDraft
{
    Blueprint blueprint;
    std::map<std::string, double> parameters; ///< settings of the scene, by id
    std::vector<std::string> omitted;         ///< what of it nobody can build, in English; see SIM_TEXT
    State state; ///< of the scene: points that the blueprint has beyond these stand for something else

    /// Adds an effect with its settings.
    void addEffect(const std::string &effect,
                   std::initializer_list<std::pair<const char *, double>> settings);
    /// Adds a spring. One that is built pulls both ends; `pullsBoth`: whether this one does, too.
    void addSpring(const BlueprintSpring &spring, bool pullsBoth);
    /// Adds a point that stands fast, and returns its number. It is called `name`, with a number behind it where a point
    /// is called so already.
    int addFixedPoint(const std::string &name, Vec2 x);
    void omit(const std::string &what);
};

/// Whether the effect called `id` was chosen for the scene.
bool hasEffect(const Blueprint &plan, const std::string &id);

/// The number that a setting of points has at `point`: its preset where the point has none of its own.
double valueOf(const BlueprintPoint &point, const ParameterSpec &parameter);
void setValue(BlueprintPoint &point, const ParameterSpec &parameter, double value);
/// One entry a point.
Eigen::ArrayXd valuesOf(const Blueprint &plan, const ParameterSpec &parameter);

/// Each point's width, and half of it, in px.
Eigen::ArrayXd widths(const Blueprint &plan);
Eigen::ArrayXd halfWidths(const Blueprint &plan);

/// The points that are feet, in order.
std::vector<int> feetOf(const Blueprint &plan);

// The clocks of a scene: one a gait group, then that of the wind, then one that no leg goes by.

int clocksOf(const Blueprint &plan);
int windClockOf(const Blueprint &plan);
/// Which clock each point goes by, one a point.
std::vector<int> clockOf(const Blueprint &plan);
/// For each clock those of the other gait groups with feet on the same bodies: one creature.
std::vector<std::vector<int>> partnerClocksOf(const Blueprint &plan);

}
