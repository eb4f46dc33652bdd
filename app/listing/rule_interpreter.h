#pragma once

#include "app/listing/script_runner.h"
#include "sim/scene/rule.h"

#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace listing {

/// A parameter of a rule: its index in the vocabulary, and in RuleScene::parameters.
using RuleParameter = std::pair<std::size_t, std::size_t>;

/// The fixed facts about a rule that its interpreters share.
struct RuleFacts
{
    sim::RuleUse use;
    std::vector<RuleParameter> parameters; ///< without `time`
    std::size_t time = 0;                  ///< index of `time` in the vocabulary
};

/// A compiled rule with the memory for one evaluation. RuleProgram makes one for each thread.
class RuleInterpreter : public ScriptRunner
{
public:
    /// Compiles the text of `scan`. The references must outlive this object.
    RuleInterpreter(const SourceScan &scan, const Vocabulary &vocabulary, const RuleFacts &facts);

    bool hasForce() const { return m_force != nullptr; }
    bool hasPull() const { return m_pull != nullptr; }

    /// Computes the forces of `calls`. After a mistake, all further forces are NaN, and error() and failedCall() describe
    /// it. Returns whether there was none.
    bool evaluate(const sim::RuleScene &scene, const sim::State &state, std::span<const sim::RuleCall> calls,
                  std::span<sim::Vec2> forces);
    /// Returns the mistake of the last evaluation, with its line.
    std::optional<RunError> mistake(const sim::RuleScene &scene, const sim::State &state);
    /// Returns the call at which the last evaluation stopped.
    const sim::RuleCall &failedCall() const { return m_failedCall; }

private:
    void findFunctions();
    /// Finds the function `name`, and adds an error if it has another form than `declaration`.
    asIScriptFunction *find(const std::string &name, const std::string &declaration);
    void load(const sim::RuleScene &scene, const sim::State &state);
    /// Reads a body into its cell.
    BodyCell &loadBody(const sim::RuleScene &scene, const sim::State &state, int point);
    sim::Vec2 run(const sim::RuleScene &scene, const sim::State &state, const sim::RuleCall &call);
    sim::Vec2 execute(BodyCell &me, BodyCell *other);
    void onNewLine(int line, int column, int depth) override;

    const RuleFacts &m_facts;
    asIScriptFunction *m_force = nullptr;
    asIScriptFunction *m_pull = nullptr;
    sim::RuleCall m_failedCall;
    bool m_findsNonFinite =
        false;            ///< whether the first line that makes a variable infinite or NaN is an error
    int m_lineBefore = 0; ///< the line that runs, for m_findsNonFinite
};

}
