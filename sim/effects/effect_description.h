#pragma once

#include "sim/scene/effect.h"
#include "sim/scene/parameter_spec.h"

#include <span>

namespace sim {

/// A variable of an effect's shown code.
struct Variable
{
    const char *name;
    const char *unit;    ///< may be empty
    const char *meaning; ///< one sentence
};

/// An effect as data: what people read of it, and how the sandbox makes it. Texts are in English; see SIM_TEXT.
struct Description
{
    const char *id; ///< in files: lower case with underscores
    const char *title;
    Kind kind;
    const char *purpose;                    ///< one sentence for a learner: what it is there for
    std::span<const Setting> settings = {}; ///< the numbers of the whole scene that it reads
    std::span<const Setting> ofPoints = {}; ///< the numbers of each point that it reads; see BuiltPoint::more
    std::span<const Variable> variables = {}; ///< of its shown code, where their names do not tell enough
    /// Makes it for a scene that a learner built, where a learner can choose it there. `values` has each of `settings`.
    EffectPtr (*make)(const Blueprint &, const Values &) = nullptr;
};

/// An effect with the id, title and kind of its description.
template <class Base, const Description &description>
class Described : public Base
{
public:
    using Base::Base;
    std::string id() const override { return description.id; }
    std::string title() const override { return description.title; }
    Kind kind() const override { return description.kind; }
};

}
