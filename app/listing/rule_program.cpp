#include "app/listing/rule_program.h"

#include "app/listing/interpreter_pool.h"
#include "app/listing/language.h"
#include "app/listing/rule_interpreter.h"
#include "sim/effects/all_effects.h"
#include "sim/effects/rules/rule_force.h"
#include "sim/pipeline/method.h"
#include "sim/pipeline/pipeline.h"
#include "sim/pipeline/run_step.h"
#include "sim/simd/flush_denormals.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <mutex>
#include <set>
#include <utility>

namespace listing {

namespace {

/// `time` is among the parameters, as the interpreter sees both in the same way.
constexpr const char *timeName = "time";

Vocabulary makeRuleVocabulary()
{
    Vocabulary vocabulary;
    vocabulary.arrays = {{"bodies", ""}};
    std::set<std::string> names;
    for (const sim::EffectDescription *effect : sim::allEffects()) {
        for (const sim::ParameterSpec &parameter : effect->parameters) {
            // The function floor() is of more use in a rule than the place of a floor.
            if (effect->make && isUsableName(parameter.id) && parameter.id != std::string("floor"))
                names.insert(parameter.id);
        }
    }
    names.insert(timeName);
    vocabulary.parameters.assign(names.begin(), names.end());
    return vocabulary;
}

/// Returns ruleVocabulary() with further parameters.
Vocabulary vocabularyWith(const std::vector<std::string> &parameters)
{
    Vocabulary vocabulary = ruleVocabulary();
    std::set<std::string> names(vocabulary.parameters.begin(), vocabulary.parameters.end());
    names.insert(parameters.begin(), parameters.end());
    vocabulary.parameters.assign(names.begin(), names.end());
    return vocabulary;
}

/// Returns a number as a listing writes it: with a point, so that a division stays exact, and without an exponent.
std::string numberText(double number)
{
    std::array<char, 400> digits{};
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), std::abs(number),
                                   std::chars_format::fixed)
                         .ptr;
    std::string text(digits.data(), end);
    if (text.find('.') == std::string::npos)
        text += ".0";
    return number < 0.0 ? "(-" + text + ')' : text;
}

RuleFacts factsOf(const SourceScan &scan, const Vocabulary &vocabulary)
{
    const auto usesAny = [&](std::initializer_list<const char *> words) {
        return std::any_of(words.begin(), words.end(), [&](const char *word) { return scan.uses(word); });
    };
    RuleFacts facts;
    facts.use.bodies = scan.uses("bodies");
    facts.use.pointer = usesAny({"hand", "pointer", "pointer_down", "pointer_known"});
    facts.use.target = usesAny({"target", "new_targets"});
    facts.use.keys = scan.uses("keys");
    facts.use.held = scan.uses("held");
    facts.use.frame = usesAny({"frame_number", "random"});
    facts.use.time = scan.uses(timeName);
    facts.use.velocity = scan.uses("velocity");
    const std::vector<std::string> &names = vocabulary.parameters;
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (names[i] == timeName)
            facts.time = i;
        else if (scan.uses(names[i]))
            facts.parameters.emplace_back(i, facts.parameters.size());
    }
    return facts;
}

/// A compiled rule.
class RuleProgram : public sim::Rule
{
public:
    RuleProgram(const std::string &text, const std::vector<std::string> &parameters)
        : m_scan(text), m_vocabulary(vocabularyWith(parameters)), m_facts(factsOf(m_scan, m_vocabulary))
    {
    }

    /// Compiles the text and returns its mistakes.
    std::vector<CompileError> compile()
    {
        std::unique_ptr<RuleInterpreter> interpreter = make();
        std::vector<CompileError> errors = interpreter->errors();
        m_hasForce = interpreter->hasForce();
        m_hasPull = interpreter->hasPull();
        if (errors.empty())
            m_pool.giveBack(std::move(interpreter));
        return errors;
    }

    const std::string &text() const override { return m_scan.text(); }
    bool hasForce() const override { return m_hasForce; }
    bool hasPull() const override { return m_hasPull; }
    sim::RuleUse use() const override { return m_facts.use; }
    std::vector<std::string> parameters() const override
    {
        std::vector<std::string> ids;
        for (const auto &[name, index] : m_facts.parameters)
            ids.push_back(m_vocabulary.parameters[name]);
        return ids;
    }
    void evaluate(const sim::RuleScene &scene, const sim::State &state, std::span<const sim::RuleCall> calls,
                  std::span<sim::Vec2> forces) const override
    {
        const sim::FlushDenormals flush; // as all code that computes a run
        std::unique_ptr<RuleInterpreter> interpreter = m_pool.take([this] { return make(); });
        if (!interpreter->evaluate(scene, state, calls, forces))
            onMistake(*interpreter, scene, state);
        m_pool.giveBack(std::move(interpreter));
    }

private:
    /// Called after an evaluation that failed.
    virtual void onMistake(RuleInterpreter &, const sim::RuleScene &, const sim::State &) const {}
    std::unique_ptr<RuleInterpreter> make() const
    {
        return std::make_unique<RuleInterpreter>(m_scan, m_vocabulary, m_facts);
    }

    SourceScan m_scan;
    Vocabulary m_vocabulary;
    RuleFacts m_facts;
    bool m_hasForce = false, m_hasPull = false;
    mutable InterpreterPool<RuleInterpreter> m_pool;
};

/// A copy of a rule that notes its first mistake. Several threads may evaluate it.
class WatchedRule : public RuleProgram
{
public:
    explicit WatchedRule(const RuleProgram &rule) : RuleProgram(rule.text(), rule.parameters()) { compile(); }

    std::optional<RuleError> mistake() const { return m_mistake; }

private:
    void onMistake(RuleInterpreter &interpreter, const sim::RuleScene &scene,
                   const sim::State &state) const override
    {
        const sim::RuleCall &call = interpreter.failedCall();
        const RuleError found = {*interpreter.mistake(scene, state), call.me, call.other};
        const std::lock_guard lock(m_mutex);
        if (!m_mistake)
            m_mistake = found;
    }

    mutable std::mutex m_mutex;
    mutable std::optional<RuleError> m_mistake;
};

}

const Vocabulary &ruleVocabulary()
{
    static const Vocabulary vocabulary = makeRuleVocabulary();
    return vocabulary;
}

CompiledRule compileRule(const std::string &text, const std::vector<std::string> &parameters)
{
    const auto program = std::make_shared<RuleProgram>(text, parameters);
    std::vector<CompileError> errors = program->compile();
    if (errors.empty())
        return {program, {}};
    sortByPlace(errors);
    return {nullptr, std::move(errors)};
}

std::string withNumbers(const std::string &text, const std::map<std::string, double> &values)
{
    const SourceScan scan(text);
    const Tokens &tokens = scan.tokens();
    std::string result;
    std::size_t copied = 0;
    for (std::size_t i = 0; i < tokens.size(); ++i) {
        const Token &token = tokens[i];
        const auto value = values.find(std::string(token.text));
        const bool isMember = i > 0 && tokens.is(i - 1, ".");
        if (value == values.end() || isMember || scan.declares(token.text, token.offset))
            continue;
        result += text.substr(copied, token.offset - copied) + numberText(value->second);
        copied = token.end();
    }
    return result + text.substr(copied);
}

std::optional<RuleError> ruleErrorIn(const sim::Scene &scene, const sim::Method &method, sim::StepSize step,
                                     const sim::State &state)
{
    sim::Scene watched = scene;
    std::shared_ptr<const WatchedRule> witness;
    for (sim::EffectPtr &effect : watched.effects) {
        const auto *force = dynamic_cast<const sim::RuleForce *>(effect.get());
        const auto program = force ? std::dynamic_pointer_cast<const RuleProgram>(force->rule()) : nullptr;
        if (!program)
            continue;
        witness = std::make_shared<WatchedRule>(*program);
        effect = force->withRule(witness);
    }
    if (!witness)
        return {};
    const sim::Pipeline pipeline = sim::compose(watched, method, step);
    sim::State after = state;
    for (int i = 0; i < step.stepsPerOutput && !witness->mistake(); ++i)
        sim::runStep(pipeline, after);
    return witness->mistake();
}

}
