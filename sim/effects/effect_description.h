#pragma once

#include "sim/scene/effect.h"
#include "sim/scene/parameter_spec.h"

#include <span>

namespace sim {

/// A variable of an effect's shown code.
struct CodeVariable
{
    const char *name;
    const char *unit;    ///< may be empty
    const char *meaning; ///< one sentence
};

/// An effect as data: what people read of it, and how the sandbox makes it. Texts are in English; see SIM_TEXT.
struct EffectDescription
{
    const char *id; ///< in files: lower case with underscores
    const char *title;
    EffectKind kind;
    const char *purpose;                            ///< one sentence for a learner: what it is there for
    std::span<const ParameterSpec> parameters = {}; ///< the numbers of the whole scene that it reads
    std::span<const ParameterSpec> pointProperties =
        {}; ///< the numbers of each point that it reads; see BlueprintPoint::more
    std::span<const CodeVariable> variables = {}; ///< of its shown code, where their names do not tell enough
    /// Makes it for a scene that a learner built, where a learner can choose it there. `values` has each of `settings`.
    EffectPtr (*make)(const Blueprint &, const Values &) = nullptr;
};

/// An effect with the id, title and kind of its description.
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
