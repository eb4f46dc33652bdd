#include "app/cli/cost_report.h"
#include "app/cli/experiment_argument.h"
#include "app/cli/option_values.h"
#include "app/cli/terminal.h"
#include "app/model/catalog/lists.h"
#include "app/model/run/run_program.h"
#include "sim/run/script/composed_interval.h"
#include "sim/run/track.h"

#include <QCoreApplication>

namespace app {

namespace {

struct CostText
{
    Q_DECLARE_TR_FUNCTIONS(CostText)
};

using Seconds = std::chrono::duration<double>;

constexpr Seconds longEnough{1.5};
constexpr int fewestRounds = 9; ///< fewer have no meaningful quartiles
constexpr int mostRounds = 300;

/// The state in which measuring begins: between two frames, after the input of the next one.
struct InitialState
{
    sim::Scene scene;
    sim::State state;
};

InitialState initialStateOf(const sim::Script &script, std::int64_t frame)
{
    sim::Track track(script, 0);
    TerminalLine status;
    const auto goesOn = [&] {
        status.showFrame(track.cursor().frame, frame);
        return !isInterrupted();
    };
    if (!track.seek({frame, 0}, goesOn))
        return {};
    if (track.stop() && track.stop()->frame < frame)
        throw UserError(CostText::tr("The run does not reach frame %1. %2 Give an earlier frame.")
                            .arg(frame)
                            .arg(endSentence(track)));
    std::shared_ptr<const sim::ComposedInterval> interval;
    sim::State state = track.preview(interval);
    state.frame = track.cursor().frame;
    return {interval->scene, state};
}

/// Returns the effects that do not run, because they would change nothing in this scene or because the file switches
/// them off.
std::vector<UnusedEffect> unusedEffects(const sim::Script &script, const sim::Pipeline &pipeline)
{
    std::vector<UnusedEffect> unused;
    for (const sim::EffectPtr &effect : pipeline.idleEffects)
        unused.push_back({QString::fromStdString(effect->id()), CostText::tr("changes nothing")});
    sim::Script all = script;
    all.effectsOff.clear();
    for (const sim::EffectPtr &effect : sceneOf(all, script.values).effects) {
        const auto &off = script.effectsOff;
        if (contains(off, effect->id()))
            unused.push_back({QString::fromStdString(effect->id()), CostText::tr("switched off")});
    }
    return unused;
}

sim::FrameCost measure(sim::CostMeter &meter)
{
    TerminalLine status;
    const auto start = std::chrono::steady_clock::now();
    int rounds = 0;
    const auto goesOn = [&] {
        if (status.isDue())
            status.show(CostText::tr("Measured %1 times").arg(rounds));
        return !isInterrupted();
    };
    while (meter.round(goesOn) && ++rounds < mostRounds) {
        const Seconds spent = std::chrono::steady_clock::now() - start;
        if (rounds >= fewestRounds && spent > longEnough)
            break;
    }
    return meter.result();
}

}

int runCost(const Arguments &arguments)
{
    const std::int64_t frame =
        std::llround(numberOption(arguments, "frame", 0, static_cast<double>(mostFrames)));
    const LessonLibrary library = LessonLibrary::load(LessonLibrary::folders());
    const Experiment experiment = experimentFor(arguments.names[0], library);
    const sim::Script &script = experiment.script;
    listenForInterrupt();
    InitialState initial = initialStateOf(script, frame);
    if (!isInterrupted()) {
        sim::CostMeter meter(initial.scene, script.method, script.step, std::move(initial.state));
        const CostReport report{arguments.names[0], script.method, script.step, measure(meter),
                                unusedEffects(script, meter.pipeline())};
        if (!isInterrupted()) {
            print(arguments.has("json") ? costJson(report) : costTable(report));
            return exitDone;
        }
    }
    return printInterrupted();
}

}
