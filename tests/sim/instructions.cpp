// Counts machine instructions under valgrind's callgrind, which counts the same on every run: what the frames of one of
// the test scenes take, with all effects and without each of them, and what each part takes by itself.
// tst_instructions runs it and reads the counts.
//   instructions SCENE METHOD

#include "sim/analysis/cost/affected_points.h"
#include "sim/analysis/cost/instrumented_effect.h"
#include "sim/effects/fields/gravity.h"
#include "sim/methods/methods.h"
#include "sim/pipeline/pipeline.h"
#include "sim/run/script/script.h"
#include "support.h"

#include <valgrind/callgrind.h>

namespace {

constexpr int frames = 40;

using Work = std::function<void(sim::State &)>;

/// Counts what `work()` takes, as the count called `name`. Once before it is done uncounted: then symbols are looked up.
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

/// The same for `work` on a copy of each of `states`.
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

/// The states that each phase meets in the frames of a run, and those that the frames begin with.
struct Met
{
    std::vector<sim::State> begins;
    std::vector<std::vector<sim::State>> phases;
};

Met follow(const sim::Pipeline &pipeline, sim::State state)
{
    Met met{{}, std::vector<std::vector<sim::State>>(pipeline.phases.size())};
    for (int frame = 0; frame < frames; ++frame) {
        state.frame += 1;
        met.begins.push_back(state);
        for (std::size_t i = 0; i < pipeline.phases.size(); ++i) {
            met.phases[i].push_back(state);
            pipeline.phases[i].run(state);
        }
    }
    return met;
}

void countPhases(const sim::Pipeline &pipeline, const Met &met)
{
    for (std::size_t i = 0; i < pipeline.phases.size(); ++i) {
        const sim::Phase &phase = pipeline.phases[i];
        const std::string whose = phase.effect ? "effect " + phase.effect->id() : "rest " + phase.id;
        const std::string number = std::to_string(i) + " " + whose;
        countAs("phase " + number, met.phases[i], [&](sim::State &state) { phase.run(state); });
        if (phase.kernels.size() > 1)
            countAs("prelude " + number, met.phases[i],
                    phase.kernels.front().run); // one at most in these scenes
    }
}

/// Frames without each effect: switched off by its id, and in a scene that never had it.
void countWithout(const sim::Script &script, const sim::Scene &scene, const Met &met)
{
    for (std::size_t i = 0; i < scene.effects.size(); ++i) {
        sim::Script off = script;
        off.effectsOff.push_back(scene.effects[i]->id());
        sim::Scene never = scene;
        never.effects.erase(never.effects.begin() + static_cast<std::ptrdiff_t>(i));
        const auto frame = [&](const sim::Scene &one) {
            return sim::compose(one, *script.method, script.step);
        };
        const std::string id = scene.effects[i]->id();
        countAs("without " + id, met.begins, frameOf(frame(never)));
        countAs("switched off " + id, met.begins, frameOf(frame(sim::sceneOf(off, off.values))));
    }
}

/// An effect whose numbers are such that it changes nothing.
class Idle : public sim::Gravity
{
public:
    Idle() : sim::Gravity(0.0) {}
    bool isIdle() const override { return true; }
};

void countIdle(const sim::Script &script, sim::Scene scene, const Met &met)
{
    scene.effects.insert(scene.effects.begin() + 1, std::make_shared<Idle>());
    countAs("with an idle one", met.begins, frameOf(sim::compose(scene, *script.method, script.step)));
}

/// For methods that compute effects within phases of their own: frames in which each call is done twice, of one effect
/// or of all; and all calls of an effect by themselves.
void countWithin(const sim::Script &script, const sim::Scene &scene, const Met &met)
{
    std::vector<std::unique_ptr<sim::CallCounter>> tallies;
    sim::Scene probed = scene;
    for (sim::EffectPtr &effect : probed.effects) {
        tallies.push_back(std::make_unique<sim::CallCounter>(sim::affectedPoints(*effect, scene.start)));
        effect = sim::instrumented(effect, *tallies.back());
    }
    const sim::Pipeline pipeline = sim::compose(probed, *script.method, script.step);
    const Work frame = frameOf(pipeline);
    countAs("once", met.begins, frame);
    for (std::size_t i = 0; i < tallies.size(); ++i) {
        tallies[i]->repeats = 1;
        countAs("twice " + scene.effects[i]->id(), met.begins, frame);
        tallies[i]->repeats = 0;
    }
    for (const auto &counter : tallies)
        counter->repeats = 1;
    countAs("twice", met.begins, frame);
    for (const auto &counter : tallies) {
        counter->repeats = 0;
        counter->restart();
        counter->acts.every = counter->slopes.every = 1;
    }
    for (sim::State state : met.begins)
        frame(state);
    for (std::size_t i = 0; i < tallies.size(); ++i) {
        const auto again = [&](int times) {
            for (const auto *calls : {&tallies[i]->acts, &tallies[i]->slopes}) {
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
    const Met met = follow(all, scene.start);
    countAs("nothing", met.begins, [](sim::State &) {});
    countAs("frame", met.begins, frameOf(all));
    countIdle(script, scene, met);
    if (script.method->evaluationsPerStep() == 0) {
        countWithin(script, scene, met);
    } else {
        countPhases(all, met);
        countWithout(script, scene, met);
    }
    return 0;
}
