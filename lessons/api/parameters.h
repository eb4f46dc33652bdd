#pragma once

#include "lessons/api/parameter.h"
#include "sim/effects/all_effects.h"
#include "sim/forward.h"

#include <span>
#include <vector>

/// The parameters that several lessons share.
namespace lessons {

/// Returns `parameter` as a length or a coordinate: in px, from -1e6 to 1e6, without decimals.
Parameter inPixels(Parameter parameter);
/// Returns the parameter of an effect with its texts translated.
Parameter parameterFromSpec(const sim::ParameterSpec &spec);
/// Returns the parameters of the effects `known`, each once, with the ids of the effects that read it.
std::vector<Parameter> parametersOf(std::span<const sim::EffectDescription *const> known);
/// Returns the parameter `id` of `effect` with another default value.
Parameter effectParameter(const sim::EffectDescription &effect, const char *id, double defaultValue);

Parameter stiffness(double defaultValue = 0.2);
Parameter damping(double defaultValue = 0.9);
Parameter radius(double defaultValue = 50.0);
Parameter offset(double defaultValue = 50.0);
Parameter feet(int defaultValue);
Parameter gravity(double defaultValue = 0.5);
Parameter bounce(double defaultValue = 1.0);
/// Returns the parameter `ground`: the height of the ground, in px down from the top of the stage.
Parameter ground(double defaultValue = 400.0);
/// Returns a parameter `id` whose values are `choices`. The first choice is the default.
Parameter choice(const char *id, const QString &name, const QString &help, const QStringList &choices);
/// Returns `centre_x` and `centre_y`.
std::vector<Parameter> centre();
/// Returns `left`, `right` and `floor`.
std::vector<Parameter> room();

}
