#include "app/cli/cost.h"

#include "app/cli/cost_report.h"
#include "app/cli/experiment_named.h"
#include "app/cli/terminal.h"
#include "app/model/sentences.h"
#include "sim/run/script/composed_interval.h"
#include "sim/run/track.h"

#include <QCoreApplication>

#include <algorithm>

namespace app {

namespace {

struct Text
{
    Q_DECLARE_TR_FUNCTIONS(Cost)
};

using Seconds = std::chrono::duration<double>;

constexpr Seconds longEnough{1.5};
constexpr int fewestRounds = 9; ///< that have quartiles worth the name
constexpr int mostRounds = 300;

/// Where the measuring begins: a state between two frames, after the input that the next one begins with.
struct Beginning
{
    sim::Scene scene;
    sim::State state;
};

Beginning beginningOf(const sim::Script &script, std::int64_t frame)
{
    sim::Track track(script, 0);
    StatusLine status;
    const auto goesOn = [&] {
        if (status.isDue())
            status.show(Text::tr("Frame %1 of %2").arg(track.cursor().frame).arg(frame));
        return !isInterrupted();
    };
    if (!track.seek({frame, 0}, goesOn))
        return {};
    if (track.stop() && track.stop()->frame < frame)
        throw Refusal(Text::tr("The run does not reach frame %1. %2 Ask for the frames after an earlier one.")
                          .arg(frame)
                          .arg(sentenceFor(*track.stop())));
    std::shared_ptr<const sim::ComposedInterval> interval;
    sim::State state = track.preview(interval);
    state.frame = track.cursor().frame;
    return {interval->scene, state};
}

/// Effects that the scene lists and the pipeline does without, and those that the file has switched off.
std::vector<UnusedEffect> unusedEffects(const sim::Script &script, const sim::Pipeline &pipeline)
{
    std::vector<UnusedEffect> unused;
    for (const sim::EffectPtr &effect : pipeline.idleEffects)
        unused.push_back({QString::fromStdString(effect->id()), Text::tr("changes nothing")});
    sim::Script all = script;
    all.effectsOff.clear();
    for (const sim::EffectPtr &effect : sceneOf(all, script.values).effects) {
        const auto &off = script.effectsOff;
        if (std::find(off.begin(), off.end(), effect->id()) != off.end())
            unused.push_back({QString::fromStdString(effect->id()), Text::tr("switched off")});
    }
    return unused;
}

sim::FrameCost measure(sim::CostMeter &meter)
{
    StatusLine status;
    const auto start = std::chrono::steady_clock::now();
    int rounds = 0;
    const auto goesOn = [&] {
        if (status.isDue())
            status.show(Text::tr("Measured %1 times").arg(rounds));
        return !isInterrupted();
    };
    while (meter.round(goesOn) && ++rounds < mostRounds) {
        const Seconds spent = std::chrono::steady_clock::now() - start;
        if (rounds >= fewestRounds && spent > longEnough)
            break;
    }
    return meter.result();
}

int answer(const CostRequest &request, const LessonLibrary &library)
{
    const Experiment experiment = experimentNamed(request.what, library);
    const sim::Script &script = experiment.script;
    listenForInterrupt();
    Beginning beginning = beginningOf(script, request.frame);
    if (!isInterrupted()) {
        sim::CostMeter meter(beginning.scene, script.method, script.step, std::move(beginning.state));
        const CostReport report{request.what, script.method, script.step, measure(meter),
                                unusedEffects(script, meter.pipeline())};
        if (!isInterrupted()) {
            print(request.asJson ? costJson(report) : costTable(report));
            return exitDone;
        }
    }
    say(Text::tr("Stopped before everything was measured."));
    return exitInterrupted;
}

}

int cost(const CostRequest &request)
{
    try {
        return answer(request, LessonLibrary::load(LessonLibrary::folders()));
    } catch (const Refusal &refusal) {
        say(refusal.sentence());
    } catch (const sim::Error &error) {
        say(sentenceFor(error));
    }
    return exitBadUse;
}

}
