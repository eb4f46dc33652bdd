#include "app/model/code/code_history.h"

#include "sim/run/script/composed_interval.h"
#include "sim/simd/flush_denormals.h"

#include <algorithm>
#include <optional>

namespace app {

namespace {

constexpr std::int64_t mostComputed = 200'000; ///< points times steps

using Value = std::variant<double, sim::Vec2>;

/// Returns the number that `phase` computes for the symbol's name, which may be one component of a pair ("v.x").
std::optional<Value> valueIn(const std::vector<sim::LiveValue> &all, const std::string &name)
{
    for (const sim::LiveValue &live : all) {
        if (live.name == name)
            return live.value;
        const sim::Vec2 *pair = std::get_if<sim::Vec2>(&live.value);
        if (pair && name == live.name + ".x")
            return pair->x;
        if (pair && name == live.name + ".y")
            return pair->y;
    }
    return std::nullopt;
}

/// Returns the parameter's value in the output step that ends at `frame`.
double parameterAt(const sim::Script &script, const std::string &id, std::int64_t frame)
{
    double value = script.values[id];
    for (const sim::Event &event : script.input) {
        const auto *set = std::get_if<sim::Set>(&event.what);
        if (set && set->parameter == id && event.frame <= frame)
            value = set->value;
    }
    return value;
}

CodeHistory parameterHistory(const std::string &id, const sim::Track &run)
{
    CodeHistory history;
    const std::int64_t framesPerOutput = run.framesPerOutput();
    std::int64_t frame =
        std::max<std::int64_t>(0, run.cursor().frame - (historyFrames - 1) * framesPerOutput);
    for (; frame <= run.cursor().frame; frame += framesPerOutput)
        history.samples.push_back({frame, parameterAt(run.script(), id, frame + framesPerOutput)});
    return history;
}

/// Runs `phases` phases of an output step on `state`. Returns the result of the last run of the step's phase number
/// `which`.
std::optional<Value> runRow(sim::State &state, const sim::ComposedInterval &interval, int phases, int which,
                            const std::string &name, int point)
{
    const sim::Pipeline &pipeline = interval.pipeline;
    const int perStep = pipeline.phasesPerStep();
    const int last = (phases - 1 - which) / perStep * perStep + which;
    std::optional<Value> value;
    for (int i = 0; i < phases; ++i) {
        const sim::Phase &phase = pipeline.phaseAt(i);
        if (i != last || which >= phases) {
            phase.run(state);
            continue;
        }
        const sim::State before = state;
        phase.run(state);
        if (phase.points.contains(point))
            value = valueIn(phase.explain(before, state, point), name);
    }
    return value;
}

/// Returns how many output steps before the cursor may be computed again.
std::int64_t rowsToCompute(const sim::Track &run)
{
    const std::int64_t perOutputStep =
        run.script().step.stepsPerOutput * std::max(1, run.state().pointCount());
    const std::int64_t most = std::min<std::int64_t>(historyFrames, mostComputed / perOutputStep);
    const std::int64_t framesPerOutput = run.framesPerOutput();
    const std::int64_t first = std::max<std::int64_t>(0, run.cursor().frame - most * framesPerOutput);
    const std::int64_t way = (first - run.cachedFrameBefore(first)) / framesPerOutput;
    return way * perOutputStep > 10 * mostComputed ? 0 : most;
}

}

CodeHistory historyOf(const CodeSymbol &symbol, const sim::Track &run, const std::string &body)
{
    if (!symbol.parameter.isEmpty())
        return parameterHistory(symbol.parameter.toStdString(), run);
    const sim::FlushDenormals flush;
    CodeHistory history;
    const std::int64_t rows = rowsToCompute(run), framesPerOutput = run.framesPerOutput();
    const bool isInside = run.cursor().phase > 0;
    if (symbol.phase < 0 || (rows == 0 && !isInside))
        return history;
    const std::string name = symbol.name.toStdString();
    std::int64_t frame = std::max<std::int64_t>(0, run.cursor().frame - rows * framesPerOutput);
    sim::State state = run.stateAt(frame);
    for (; frame < run.cursor().frame || (isInside && frame == run.cursor().frame);
         frame += framesPerOutput) {
        const std::shared_ptr<const sim::ComposedInterval> interval = run.intervalAt(frame + framesPerOutput);
        state = run.stateAfterInput(std::move(state), frame);
        const int point = interval->scene.find(body);
        const int phases =
            frame < run.cursor().frame ? interval->pipeline.phasesPerOutput() : run.cursor().phase;
        if (symbol.phase >= interval->pipeline.phasesPerStep() || point < 0)
            return history; // another scene: its earlier numbers have another meaning
        if (const auto value = runRow(state, *interval, phases, symbol.phase, name, point))
            history.samples.push_back({frame + framesPerOutput, *value});
    }
    return history;
}

}
