// Counts the machine instructions of a test scene's frames under valgrind's callgrind: with all effects,
// without each of them, and phase by phase. Unlike times, the counts are the same on every run.
// tst_instructions runs this program and reads the counts.
//   instructions SCENE METHOD

#include "sim/analysis/cost/affected_points.h"
#include "sim/analysis/cost/instrumented_effect.h"
#include "sim/effects/fields/gravity.h"
#include "sim/methods/methods.h"
#include "sim/pipeline/pipeline.h"
#include "sim/run/script/script.h"
#include "tests/sim/support/support.h"

#include <valgrind/callgrind.h>

namespace {

constexpr int frames = 40;

using Work = std::function<void(sim::State &)>;

/// Counts the instructions of `work()` under the name `name`. A first uncounted call resolves the symbols.
template <class Prepare, class Do>
void count(const std::string &name, Prepare &&prepare, Do &&work)
{
    prepare();
    work();
    prepare();
    CALLGRIND_START_INSTRUMENTATION;
    CALLGRIND_ZERO_STATS;
    work();
    CALLGRIND_DUMP_STATS_AT(name.c_str());
    CALLGRIND_STOP_INSTRUMENTATION;
}

/// Counts the instructions of `work` on a copy of each of `states`.
template <class Do>
void countAs(const std::string &name, const std::vector<sim::State> &states, const Do &work)
{
    std::vector<sim::State> copies;
    count(
        name, [&] { copies = states; },
        [&] {
            for (sim::State &state : copies)
                work(state);
        });
}

Work frameOf(const sim::Pipeline &pipeline)
{
    return [pipeline](sim::State &state) {
        for (const sim::Phase &phase : pipeline.phases)
            phase.run(state);
    };
}

/// The states before each frame of a run, and before each of its phases.
struct RecordedStates
{
    std::vector<sim::State> begins;
    std::vector<std::vector<sim::State>> phases;
};

RecordedStates recordStates(const sim::Pipeline &pipeline, sim::State state)
{
    RecordedStates recorded{{}, std::vector<std::vector<sim::State>>(pipeline.phases.size())};
    for (int frame = 0; frame < frames; ++frame) {
        state.frame += 1;
        recorded.begins.push_back(state);
        for (std::size_t i = 0; i < pipeline.phases.size(); ++i) {
            recorded.phases[i].push_back(state);
            pipeline.phases[i].run(state);
        }
    }
    return recorded;
}

void countPhases(const sim::Pipeline &pipeline, const RecordedStates &recorded)
{
    for (std::size_t i = 0; i < pipeline.phases.size(); ++i) {
        const sim::Phase &phase = pipeline.phases[i];
        const std::string owner = phase.effect ? "effect " + phase.effect->id() : "rest " + phase.id;
        const std::string number = std::to_string(i) + " " + owner;
        countAs("phase " + number, recorded.phases[i], [&](sim::State &state) { phase.run(state); });
        // These scenes have at most one prelude.
        if (phase.kernels.size() > 1)
            countAs("prelude " + number, recorded.phases[i], phase.kernels.front().run);
    }
}

/// Counts frames without each effect, once switched off by its id and once in a scene that does not list it.
void countWithout(const sim::Script &script, const sim::Scene &scene, const RecordedStates &recorded)
{
    for (std::size_t i = 0; i < scene.effects.size(); ++i) {
        sim::Script disabled = script;
        disabled.effectsOff.push_back(scene.effects[i]->id());
        sim::Scene removed = scene;
        removed.effects.erase(removed.effects.begin() + static_cast<std::ptrdiff_t>(i));
        const auto frame = [&](const sim::Scene &composed) {
            return sim::compose(composed, *script.method, script.step);
        };
        const std::string id = scene.effects[i]->id();
        countAs("without " + id, recorded.begins, frameOf(frame(removed)));
        countAs("switched off " + id, recorded.begins,
                frameOf(frame(sim::sceneOf(disabled, disabled.values))));
    }
}

/// An effect whose parameters make it idle.
class IdleGravity : public sim::Gravity
{
public:
    IdleGravity() : sim::Gravity(0.0) {}
    bool isIdle() const override { return true; }
};

void countIdle(const sim::Script &script, sim::Scene scene, const RecordedStates &recorded)
{
    scene.effects.insert(scene.effects.begin() + 1, std::make_shared<IdleGravity>());
    countAs("with an idle one", recorded.begins, frameOf(sim::compose(scene, *script.method, script.step)));
}

/// For methods that compute several effects within one phase. Counts frames in which each call of one effect,
/// or of all effects, is repeated. Also counts the calls of each effect alone.
void countWithin(const sim::Script &script, const sim::Scene &scene, const RecordedStates &recorded)
{
    std::vector<std::unique_ptr<sim::CallCounter>> counters;
    sim::Scene instrumentedScene = scene;
    for (sim::EffectPtr &effect : instrumentedScene.effects) {
        counters.push_back(std::make_unique<sim::CallCounter>(sim::affectedPoints(*effect, scene.start)));
        effect = sim::instrumented(effect, *counters.back());
    }
    const sim::Pipeline pipeline = sim::compose(instrumentedScene, *script.method, script.step);
    const Work frame = frameOf(pipeline);
    countAs("once", recorded.begins, frame);
    for (std::size_t i = 0; i < counters.size(); ++i) {
        counters[i]->repeats = 1;
        countAs("twice " + scene.effects[i]->id(), recorded.begins, frame);
        counters[i]->repeats = 0;
    }
    for (const auto &counter : counters)
        counter->repeats = 1;
    countAs("twice", recorded.begins, frame);
    for (const auto &counter : counters) {
        counter->repeats = 0;
        counter->restart();
        counter->effectCalls.every = counter->jacobianCalls.every = 1;
    }
    for (sim::State state : recorded.begins)
        frame(state);
    for (std::size_t i = 0; i < counters.size(); ++i) {
        const auto again = [&](int times) {
            for (const auto *calls : {&counters[i]->effectCalls, &counters[i]->jacobianCalls}) {
                for (const auto &call : calls->kept)
                    call->run(times);
            }
        };
        const auto nothing = [] {};
        count("again " + scene.effects[i]->id(), nothing, [&] { again(1); });
        count("again and again " + scene.effects[i]->id(), nothing, [&] { again(2); });
    }
}

}

int main(int argc, char **argv)
{
    if (argc != 3)
        return 2;
    const sim::Script script = support::script(support::sample(argv[1]), argv[2]);
    const sim::Scene scene = sim::sceneOf(script, script.values);
    const sim::Pipeline all = sim::compose(scene, *script.method, script.step);
    const RecordedStates recorded = recordStates(all, scene.start);
    countAs("nothing", recorded.begins, [](sim::State &) {});
    countAs("frame", recorded.begins, frameOf(all));
    countIdle(script, scene, recorded);
    if (script.method->evaluationsPerStep() == 0) {
        countWithin(script, scene, recorded);
    } else {
        countPhases(all, recorded);
        countWithout(script, scene, recorded);
    }
    return 0;
}
