#pragma once

#include "lessons/api/parameter.h"
#include "sim/effects/all_effects.h"
#include "sim/forward.h"

#include <span>
#include <vector>

/// The parameters that several lessons share.
namespace lessons {

/// Returns a setting of an effect as a parameter, in the learner's language.
Parameter parameterFromSpec(const sim::ParameterSpec &parameter);
/// Returns the settings of all effects of `known`, each once, with the effects that read it.
std::vector<Parameter> parametersOf(std::span<const sim::EffectDescription *const> known);
/// Returns the setting `id` of the effect `effect`, with another preset.
Parameter effectParameter(const sim::EffectDescription &effect, const char *id, double preset);

Parameter stiffness(double preset = 0.2);
Parameter damping(double preset = 0.9);
Parameter radius(double preset = 50.0);
Parameter offset(double preset = 50.0);
Parameter feet(int preset);
Parameter gravity(double preset = 0.5);
Parameter bounce(double preset = 1.0);
/// `ground`: where it lies.
Parameter ground(double preset = 400.0);
/// A parameter `id` whose values are `choices`; the first is the preset.
Parameter choice(const char *id, const QString &name, const QString &help, const QStringList &choices);
/// `centre_x` and `centre_y`.
std::vector<Parameter> centre();
/// `left`, `right` and `floor`.
std::vector<Parameter> room();

}
