#include "app/listing/program.h"

#include "app/listing/interpreter.h"
#include "app/listing/interpreter_pool.h"
#include "app/listing/loop_turns.h"
#include "sim/simd/flush_denormals.h"

#include <algorithm>
#include <utility>

namespace listing {

struct Program::Private
{
    Private(const std::string &listing, const Vocabulary &names) : scan(listing), vocabulary(names) {}

    RunResult run(sim::State &state, const Binding &binding, const Recording &recording)
    {
        const sim::FlushDenormals flush; // as all code that computes a run
        std::unique_ptr<Interpreter> interpreter =
            pool.take([this] { return std::make_unique<Interpreter>(scan, vocabulary); });
        RunResult result = interpreter->run(state, binding, recording);
        pool.giveBack(std::move(interpreter));
        return result;
    }

    SourceScan scan;
    Vocabulary vocabulary;
    InterpreterPool<Interpreter> pool;
};

Program::Program(std::unique_ptr<Private> data) : m_data(std::move(data)) {}

Program::~Program() = default;

Compiled Program::compile(const std::string &text, const Vocabulary &vocabulary)
{
    auto data = std::make_unique<Private>(text, vocabulary);
    auto interpreter = std::make_unique<Interpreter>(data->scan, data->vocabulary);
    std::vector<CompileError> errors = interpreter->errors();
    if (!errors.empty()) {
        // A brace that is never closed comes last: it may just not have been typed yet.
        sortByPlace(std::span(errors).first(errors.size() - (data->scan.unclosed() ? 1 : 0)));
        return {nullptr, std::move(errors)};
    }
    data->pool.giveBack(std::move(interpreter));
    return {std::shared_ptr<const Program>(new Program(std::move(data))), {}};
}

const std::string &Program::text() const
{
    return m_data->scan.text();
}

const Vocabulary &Program::vocabulary() const
{
    return m_data->vocabulary;
}

bool Program::dependsOnTime() const
{
    return m_data->scan.uses("frame_number") || m_data->scan.uses("random");
}

bool Program::remembers() const
{
    return m_data->scan.hasGlobals();
}

std::optional<RunError> Program::run(sim::State &state, const Binding &binding) const
{
    return m_data->run(state, binding, {}).error;
}

Trace Program::trace(const sim::State &state, const Binding &binding) const
{
    Trace trace;
    Recording recording;
    recording.lines = &trace.lines;
    sim::State after = state;
    RunResult result = m_data->run(after, binding, recording);
    trace.isComplete = result.isComplete;
    trace.error = std::move(result.error);
    trace.globals = std::move(result.globals);
    countLoopTurns(trace.lines);
    return trace;
}

Moment Program::runLines(sim::State state, const Binding &binding, int lines) const
{
    Recording recording;
    recording.stopAfter = std::max(0, lines);
    Moment moment;
    moment.state = std::move(state);
    RunResult result = m_data->run(moment.state, binding, recording);
    moment.next = std::move(result.next);
    if (moment.next)
        moment.next->loops.clear();
    moment.error = std::move(result.error);
    return moment;
}

}
