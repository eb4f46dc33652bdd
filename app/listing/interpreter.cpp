#include "app/listing/interpreter.h"

#include "app/listing/limits.h"

#include <angelscript.h>

#include <algorithm>
#include <cstddef>
#include <cstring>

namespace listing {

using namespace AngelScript;

Interpreter::Interpreter(const SourceScan &scan, const Vocabulary &vocabulary)
    : ScriptRunner(scan, vocabulary, BodyAccess::write, maxLinesPerFrame)
{
    findFrame();
    if (errors().empty())
        makeContext();
}

void Interpreter::findFrame()
{
    const auto addMissingFrame = [this] {
        addError(1, 1, "The function 'void frame()' is missing. It runs once in every frame.");
    };
    if (errors().empty() && scan().tokens().empty())
        return addMissingFrame();
    if (!module())
        return;
    m_frame = module()->GetFunctionByDecl("void frame()");
    if (!m_frame)
        addMissingFrame();
    findGlobals();
}

void Interpreter::findGlobals()
{
    for (asUINT i = 0; i < module()->GetGlobalVarCount(); ++i) {
        Global global = {nullptr, 0, i, 0};
        module()->GetGlobalVar(i, &global.name, nullptr, &global.type);
        global.bytes = cells().sizeOf(global.type);
        if (global.bytes == 0) {
            addErrorAt(global.name,
                       "'" + std::string(global.name) +
                           "' cannot be remembered from frame to frame. Only numbers, bool and Vec2 can.");
            continue;
        }
        m_memoryBytes += global.bytes;
        m_globals.push_back(global);
    }
    if (m_memoryBytes > maxMemoryBytes)
        addError(1, 1,
                 "The variables outside of functions take " + std::to_string(m_memoryBytes) +
                     " bytes. The most is " + std::to_string(maxMemoryBytes) + ".");
}

RunResult Interpreter::run(sim::State &state, const Binding &binding, const Recording &recording)
{
    prepareScriptThread();
    cells().load(state, binding);
    RunResult result = execute(state, binding, recording);
    if (!result.error && !result.isStopped && !firstNonFinite().empty()) {
        // Once more, with a check after each line. This finds the line without slowing down every frame.
        Recording search;
        search.findsNonFinite = true;
        cells().load(state, binding);
        const RunResult found = execute(state, binding, search);
        result.error = found.error;
    }
    if (!result.error)
        store(state);
    return result;
}

RunResult Interpreter::execute(const sim::State &state, const Binding &binding, const Recording &recording)
{
    m_recording = recording;
    m_result = {};
    m_lines = 0;
    m_before = {};
    forgetError();
    restartCount();
    if (state.memory.size() != m_memoryBytes) {
        initialise();
    } else {
        allocateGlobals(state, binding);
        std::size_t at = 0;
        for (const Global &global : m_globals) {
            if (void *address = addressOf(global))
                std::memcpy(address, state.memory.data() + at, global.bytes);
            at += global.bytes;
        }
    }
    for (const Global &global : m_globals) {
        if (!addressOf(global) && !error())
            setError({RunErrorKind::other,
                      1,
                      "The first value of '" + std::string(global.name) + "' cannot be computed.",
                      {}});
    }
    restartCount();
    m_recorded.clear();
    if (!error())
        runFrame();
    if (m_recording.lines) {
        recordChanges();
        m_result.globals = variables();
    }
    if (m_recording.findsNonFinite)
        checkFinite();
    m_result.error = error();
    return std::move(m_result);
}

void *Interpreter::addressOf(const Global &global) const
{
    return module()->GetAddressOfGlobalVar(global.index);
}

void Interpreter::initialise()
{
    if (m_globals.empty())
        return;
    m_isInitialising = true;
    if (module()->ResetGlobalVars(&context()) < 0 && !error())
        setError({RunErrorKind::other, lastLine(), "The interpreter stopped.", {}});
    m_isInitialising = false;
}

void Interpreter::allocateGlobals(const sim::State &state, const Binding &binding)
{
    const auto isMissing = [this](const Global &global) { return !addressOf(global); };
    const auto anyIsMissing = [&] { return std::any_of(m_globals.begin(), m_globals.end(), isMissing); };
    if (!anyIsMissing())
        return;
    // The values do not matter: those of the state replace them. Computing them can fail in the current state, for
    // example if a body is gone since the first frame. Then other parameters and bodies help.
    initialise();
    if (anyIsMissing()) {
        forgetError();
        restartCount();
        cells().loadPlaceholders();
        initialise();
        cells().load(state, binding);
    }
    forgetError();
}

void Interpreter::record(int line, int column, int depth)
{
    const bool keepsLine = m_recording.lines && m_recording.lines->size() < std::size_t{maxTracedLines};
    const bool isLast = m_recording.stopAfter >= 0 && m_lines > m_recording.stopAfter;
    if (m_recording.findsNonFinite && !checkFinite())
        return abort();
    if (m_recording.lines && !keepsLine)
        m_result.isComplete = false;
    if (m_recording.lines && m_result.isComplete)
        recordChanges();
    if (!keepsLine && !isLast && !m_recording.findsNonFinite)
        return;
    TracedLine traced = {line, depth, context().GetFunction(0)->GetName(), variables(), {}};
    const std::size_t at = scan().offsetOf(line, column);
    for (const Loop &loop : scan().loops()) {
        // The turn is counted afterwards: 0 in the head of a loop.
        if (loop.whole.contains(at))
            traced.loops.push_back({loop.line, loop.body.contains(at) ? 1 : 0, 0});
    }
    if (isLast) {
        m_result.isStopped = true;
        m_result.next = std::move(traced);
        abort();
    } else if (m_recording.findsNonFinite) {
        m_before = std::move(traced);
    } else {
        m_recording.lines->push_back(std::move(traced));
    }
}

void Interpreter::recordChanges()
{
    const bool isFirst = m_recorded.empty();
    cells().readMotions(m_motions);
    if (isFirst) {
        m_recorded = m_motions;
        return;
    }
    for (std::size_t i = 0; i < m_motions.size(); ++i) {
        if (m_recorded[i] != m_motions[i])
            m_recording.lines->back().changed.push_back(m_recorded[i] = m_motions[i]);
    }
}

std::string Interpreter::firstNonFinite() const
{
    std::string name = cells().firstNonFinite();
    if (!name.empty())
        return name;
    for (const Global &global : m_globals) {
        const std::optional<Value> value = cells().values().valueAt(addressOf(global), global.type);
        if (value && !isFinite(*value))
            return "'" + std::string(global.name) + "'";
    }
    return {};
}

bool Interpreter::checkFinite()
{
    const std::string name = error() ? std::string() : firstNonFinite();
    if (!name.empty())
        setError({RunErrorKind::notFinite, m_before.line, notFiniteSentence(name), m_before.variables});
    return name.empty();
}

std::vector<Variable> Interpreter::variables() const
{
    std::vector<Variable> all = ScriptRunner::variables();
    for (const Global &global : m_globals) {
        if (const std::optional<Value> value = cells().values().valueAt(addressOf(global), global.type))
            all.push_back({global.name, *value, true});
    }
    return all;
}

void Interpreter::onNewLine(int line, int column, int depth)
{
    ++m_lines;
    if (m_recording.lines || m_recording.findsNonFinite || m_recording.stopAfter >= 0)
        record(line, column, depth);
}

void Interpreter::runFrame()
{
    context().Prepare(m_frame);
    if (!ScriptRunner::execute() && !error() && !m_result.isStopped)
        setError({RunErrorKind::other, lastLine(), "The interpreter stopped.", {}});
    context().Unprepare();
}

void Interpreter::store(sim::State &state) const
{
    cells().store(state);
    state.memory.resize(m_memoryBytes);
    std::size_t at = 0;
    for (const Global &global : m_globals) {
        std::memcpy(state.memory.data() + at, addressOf(global), global.bytes);
        at += global.bytes;
    }
}

}
