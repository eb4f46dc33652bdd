#include "sim/analysis/cost/cost.h"

#include "sim/analysis/accuracy/samples.h"
#include "sim/analysis/cost/affected_points.h"
#include "sim/analysis/cost/instrumented_effect.h"
#include "sim/analysis/cost/timing_batch.h"
#include "sim/base/cpu_clock.h"

#include <algorithm>

namespace sim {

namespace {

constexpr std::size_t maxRecordedBytes = 64 << 20; ///< per effect, of the states in its recorded calls
constexpr std::int64_t maxRecordedCalls = 8;       ///< of one kind
constexpr double secondsPerReplay = 10e-6;         ///< duration of a sample of one recorded call
constexpr int maxReplays = 2000;

std::ptrdiff_t firstPhaseOf(const Pipeline &pipeline, const EffectPtr &effect)
{
    const auto found = std::find_if(pipeline.phases.begin(), pipeline.phases.end(),
                                    [&](const Phase &phase) { return computes(phase, effect); });
    return found - pipeline.phases.begin();
}

}

class CostMeter::Work
{
    /// One effect under measurement.
    struct MeasuredEffect
    {
        MeasuredEffect(const EffectPtr &original, const State &state, DirectionRule directionRule)
            : MeasuredEffect(original, state, affectedPoints(*original, state), directionRule)
        {
        }
        MeasuredEffect(const EffectPtr &original, const State &state, const std::vector<char> &movers,
                       DirectionRule directionRule)
            : effect(original), counter(std::make_unique<CallCounter>(movers)),
              points(pointsOf(*original, state, movers, directionRule))
        {
        }

        bool isCalled() const { return counter->effectCalls.count + counter->jacobianCalls.count > 0; }

        EffectPtr effect;
        std::unique_ptr<CallCounter> counter;
        int points = 0;
        bool isInner = false; ///< whether phases of the method compute it inside
        double evaluations = 0.0;
        Samples samples = {};
    };

public:
    Work(const Scene &scene, const MethodPtr &method, StepSize step, State from, Clocks clocks)
        : m_plain(compose(scene, *method, step)), m_framesPerOutput(step.framesPerOutput),
          m_stateBytes(std::max<std::size_t>(1, byteSize(from)))
    {
        for (const EffectPtr &effect : scene.effects) {
            if (!effect->isIdle())
                m_effects.emplace_back(effect, from, method->directionRule());
        }
        Scene instrumentedScene = scene;
        instrumentedScene.effects.clear();
        for (MeasuredEffect &measured : m_effects)
            instrumentedScene.effects.push_back(instrumented(measured.effect, *measured.counter));
        m_instrumented = compose(instrumentedScene, *method, step);
        std::stable_sort(m_effects.begin(), m_effects.end(),
                         [this](const MeasuredEffect &a, const MeasuredEffect &b) {
                             return firstPhaseOf(m_plain, a.effect) < firstPhaseOf(m_plain, b.effect);
                         });
        for (MeasuredEffect &measured : m_effects)
            measured.isInner =
                std::any_of(m_plain.phases.begin(), m_plain.phases.end(), [&](const Phase &phase) {
                    return !phase.effect && computes(phase, measured.effect);
                });
        m_batch.emplace(std::move(from), std::move(clocks));
    }

    bool round(const ShouldContinue &shouldContinue)
    {
        if (!m_isReady && !prepare(shouldContinue))
            return false;
        const auto frame = m_batch->timeFrames(m_plain, shouldContinue);
        const auto plain = frame ? m_batch->timePhases(m_plain, shouldContinue) : std::nullopt;
        if (!plain)
            return false;
        Round found{*frame, 0.0, std::vector<double>(m_effects.size(), 0.0)};
        if (!addPhases(*plain, found, shouldContinue) || !addInnerEffects(found, shouldContinue))
            return false;
        const double scale = 1e9 / m_framesPerOutput;
        m_frame.add(scale * found.frame);
        m_rest.add(scale * found.rest);
        for (std::size_t i = 0; i < m_effects.size(); ++i)
            m_effects[i].samples.add(scale * found.effects[i]);
        return true;
    }

    FrameCost result() const
    {
        FrameCost cost{m_frame.median(), m_frame.spread(), {},
                       m_rest.median(),  m_rest.spread(),  m_frame.count()};
        for (const MeasuredEffect &measured : m_effects)
            cost.effects.push_back({measured.effect, measured.points, measured.evaluations,
                                    measured.samples.median(), measured.samples.spread()});
        return cost;
    }

    const Pipeline &pipeline() const { return m_plain; }

private:
    /// Seconds per output step.
    struct Round
    {
        double frame;
        double rest;
        std::vector<double> effects;
    };

    /// Counts the calls of each effect in the measured frames, and records calls of effects without a phase.
    bool prepare(const ShouldContinue &shouldContinue)
    {
        if (!m_batch->choose(m_plain, shouldContinue) || !m_batch->timeFrames(m_instrumented, shouldContinue))
            return false;
        const double frames = double(m_batch->outputStepsRun()) * m_framesPerOutput;
        bool hasInner = false;
        const auto maxCalls = std::clamp<std::int64_t>(
            static_cast<std::int64_t>(maxRecordedBytes / m_stateBytes), 1, maxRecordedCalls);
        for (MeasuredEffect &measured : m_effects) {
            measured.evaluations = measured.counter->evaluations / frames;
            measured.isInner = measured.isInner && measured.isCalled();
            hasInner = hasInner || measured.isInner;
            for (Calls *calls : {&measured.counter->effectCalls, &measured.counter->jacobianCalls})
                calls->every = measured.isInner ? (calls->count + maxCalls - 1) / maxCalls : 0;
        }
        if (hasInner && !recordCalls(shouldContinue))
            return false;
        m_isReady = true;
        return true;
    }

    bool recordCalls(const ShouldContinue &shouldContinue)
    {
        for (MeasuredEffect &measured : m_effects)
            measured.counter->restart();
        const bool isDone = m_batch->timeFrames(m_instrumented, shouldContinue).has_value();
        for (MeasuredEffect &measured : m_effects) {
            for (Calls *calls : {&measured.counter->effectCalls, &measured.counter->jacobianCalls})
                calls->every = 0;
        }
        m_callsPerSample.clear();
        for (const MeasuredEffect &measured : m_effects)
            m_callsPerSample.push_back(
                {measured.counter->effectCalls.count, measured.counter->jacobianCalls.count});
        return isDone;
    }

    /// Adds the times of effects that have a phase, and of the rest.
    bool addPhases(const PhaseTimes &plain, Round &found, const ShouldContinue &shouldContinue)
    {
        bool hasInner = false;
        for (std::size_t i = 0; i < m_plain.phases.size(); ++i) {
            const Phase &phase = m_plain.phases[i];
            found.rest += plain.prelude[i];
            if (const auto index = indexOf(phase.effect))
                found.effects[*index] += plain.run[i] - plain.prelude[i];
            else
                found.rest += plain.run[i] - plain.prelude[i];
            hasInner = hasInner || computesInner(phase);
        }
        if (!hasInner)
            return true;
        const auto once = m_batch->timePhases(m_instrumented, shouldContinue);
        setRepeats(1);
        const auto twice = once ? m_batch->timePhases(m_instrumented, shouldContinue) : std::nullopt;
        setRepeats(0);
        for (std::size_t i = 0; twice && i < m_plain.phases.size(); ++i) {
            if (computesInner(m_plain.phases[i]))
                found.rest -= twice->run[i] - once->run[i];
        }
        return twice.has_value();
    }

    /// Adds the times of effects without a phase, by replaying their calls.
    bool addInnerEffects(Round &found, const ShouldContinue &shouldContinue)
    {
        for (std::size_t i = 0; i < m_effects.size(); ++i) {
            MeasuredEffect &measured = m_effects[i];
            if (!measured.isInner)
                continue;
            if (shouldContinue && !shouldContinue())
                return false;
            found.effects[i] +=
                (secondsOf(measured.counter->effectCalls) * double(m_callsPerSample[i].effectCalls) +
                 secondsOf(measured.counter->jacobianCalls) * double(m_callsPerSample[i].jacobianCalls)) /
                m_batch->outputStepsRun();
        }
        return true;
    }

    /// Returns seconds per call, the mean over the recorded calls.
    double secondsOf(Calls &calls) const
    {
        double sum = 0.0;
        for (const auto &call : calls.kept) {
            const auto timed = [&](int times) {
                const double before = m_batch->now();
                call->run(times);
                return std::max(0.0, m_batch->now() - before - m_batch->reading()) / times;
            };
            const double first = timed(4);
            const double repeats = secondsPerReplay / std::max(first, 1e-9);
            sum += repeats < 4.0 ? first : timed(static_cast<int>(std::min(repeats, double(maxReplays))));
        }
        return calls.kept.empty() ? 0.0 : sum / static_cast<double>(calls.kept.size());
    }

    void setRepeats(int repeats)
    {
        for (MeasuredEffect &measured : m_effects)
            measured.counter->repeats = measured.isInner ? repeats : 0;
    }

    std::optional<std::size_t> indexOf(const EffectPtr &effect) const
    {
        for (std::size_t i = 0; i < m_effects.size(); ++i) {
            if (effect && m_effects[i].effect == effect)
                return i;
        }
        return {};
    }

    bool computesInner(const Phase &phase) const
    {
        return std::any_of(phase.innerEffects.begin(), phase.innerEffects.end(),
                           [this](const EffectPtr &effect) {
                               const auto index = indexOf(effect);
                               return index && m_effects[*index].isInner;
                           });
    }

    struct CallCounts
    {
        std::int64_t effectCalls = 0;
        std::int64_t jacobianCalls = 0;
    };

    Pipeline m_plain;
    Pipeline m_instrumented; ///< the same with instrumented effects
    std::vector<MeasuredEffect> m_effects;
    std::optional<TimingBatch> m_batch;
    std::vector<CallCounts> m_callsPerSample;
    int m_framesPerOutput;
    std::size_t m_stateBytes;
    bool m_isReady = false;
    Samples m_frame;
    Samples m_rest;
};

double FrameCost::sum() const
{
    double total = restNs;
    for (const EffectCost &effect : effects)
        total += effect.ns;
    return total;
}

CostMeter::CostMeter(const Scene &scene, const MethodPtr &method, StepSize step, State from)
    : m_work(
          std::make_unique<Work>(scene, method, step, std::move(from), Clocks{wallSeconds, threadCpuSeconds}))
{
}

CostMeter::CostMeter(const Scene &scene, const MethodPtr &method, StepSize step, State from, Clock clock)
    : m_work(std::make_unique<Work>(scene, method, step, std::move(from), Clocks{clock, clock}))
{
}

CostMeter::~CostMeter() = default;
CostMeter::CostMeter(CostMeter &&) noexcept = default;
CostMeter &CostMeter::operator=(CostMeter &&) noexcept = default;

bool CostMeter::round(const ShouldContinue &shouldContinue)
{
    return m_work->round(shouldContinue);
}

FrameCost CostMeter::result() const
{
    return m_work->result();
}

const Pipeline &CostMeter::pipeline() const
{
    return m_work->pipeline();
}

}
