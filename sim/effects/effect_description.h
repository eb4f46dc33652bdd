#pragma once

#include "sim/scene/effect.h"
#include "sim/scene/parameter_spec.h"

#include <span>

namespace sim {

/// A variable in the source code that an effect shows.
struct CodeVariable
{
    const char *name;
    const char *unit;    ///< may be empty
    const char *meaning; ///< one sentence for a learner
};

/// The texts and parameters of an effect, and the function with which the sandbox creates it. Texts are in
/// English; see SIM_TEXT.
struct EffectDescription
{
    const char *id; ///< in files: lower case with underscores
    const char *title;
    EffectKind kind;
    const char *purpose;                            ///< one sentence for a learner
    std::span<const ParameterSpec> parameters = {}; ///< one value each for the whole scene
    /// One value each per point; see BlueprintPoint::properties.
    std::span<const ParameterSpec> pointProperties = {};
    std::span<const CodeVariable> variables = {}; ///< variables of the shown code that need an explanation
    /// Creates the effect for a blueprint. `values` has a value for each of `parameters`. Null if a learner
    /// cannot choose the effect in the sandbox.
    EffectPtr (*make)(const Blueprint &, const Values &) = nullptr;
};

/// An effect that takes its id, title and kind from its description.
template <class Base, const EffectDescription &description>
class DescribedEffect : public Base
{
public:
    using Base::Base;
    std::string id() const override { return description.id; }
    std::string title() const override { return description.title; }
    EffectKind kind() const override { return description.kind; }
};

}
