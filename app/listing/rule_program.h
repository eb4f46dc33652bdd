#pragma once

#include "app/listing/values.h"
#include "app/listing/vocabulary.h"
#include "sim/base/step_size.h"
#include "sim/scene/rule.h"

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace listing {

/// The result of compiling a rule: a rule, or the mistakes in its text, in the order of the text.
struct CompiledRule
{
    std::shared_ptr<const sim::Rule> rule; ///< null if there are errors
    std::vector<CompileError> errors;
};

/// Compiles the text of a rule for the sandbox: `Vec2 force(Body me)`, `Vec2 pull(Body me, Body other)`, or both. The
/// rule can read `parameters`, too, which a lesson declares. The result does not depend on a scene. Takes about 1 ms.
CompiledRule compileRule(const std::string &text, const std::vector<std::string> &parameters = {});

/// Returns the text of a rule with numbers in place of the parameters in `values`.
std::string withNumbers(const std::string &text, const std::map<std::string, double> &values);

/// Returns the names that every rule has besides those of the language: the array `bodies`, `time`, and the parameters of
/// the effects of the sandbox.
const Vocabulary &ruleVocabulary();

/// A mistake that stopped a rule.
struct RuleError
{
    RunError error;
    int me = -1;    ///< point for which the rule ran
    int other = -1; ///< the other end of the link in `pull`; -1 in `force`
};

/// Runs a step of `method` from `state`, the state before it with its input. Returns the first mistake of a rule of
/// `scene`, or nothing if its rule has none.
std::optional<RuleError> ruleErrorIn(const sim::Scene &scene, const sim::Method &method, sim::StepSize step,
                                     const sim::State &state);

}
