#include "sim/analysis/cost/cost.h"

#include "sim/analysis/accuracy/samples.h"
#include "sim/analysis/cost/affected_points.h"
#include "sim/analysis/cost/instrumented_effect.h"
#include "sim/analysis/cost/timing_batch.h"
#include "sim/base/cpu_clock.h"

#include <algorithm>

namespace sim {

namespace {

constexpr std::size_t keptBytes = 64 << 20; ///< of the states that calls are kept with, an effect
constexpr std::int64_t mostKept = 8;        ///< calls of one kind
constexpr double replaySeconds = 10e-6;     ///< a sample of one kept call
constexpr int mostReplays = 2000;

/// One effect under measurement.
struct Watched
{
    Watched(const EffectPtr &which, const State &state, DirectionRule directionRule)
        : Watched(which, state, affectedPoints(*which, state), directionRule)
    {
    }
    Watched(const EffectPtr &which, const State &state, const std::vector<char> &movers,
            DirectionRule directionRule)
        : effect(which), counter(std::make_unique<CallCounter>(movers)),
          points(pointsOf(*which, state, movers, directionRule))
    {
    }

    bool isAsked() const { return counter->acts.count + counter->slopes.count > 0; }

    EffectPtr effect;
    std::unique_ptr<CallCounter> counter;
    int points = 0;
    bool isWithin = false; ///< whether phases of the method's own compute it
    double evaluations = 0.0;
    Samples samples = {};
};

bool computes(const Phase &phase, const EffectPtr &effect)
{
    return phase.effect == effect || std::find(phase.innerEffects.begin(), phase.innerEffects.end(),
                                               effect) != phase.innerEffects.end();
}

std::ptrdiff_t firstPhaseOf(const Pipeline &pipeline, const EffectPtr &effect)
{
    const auto found = std::find_if(pipeline.phases.begin(), pipeline.phases.end(),
                                    [&](const Phase &phase) { return computes(phase, effect); });
    return found - pipeline.phases.begin();
}

}

class CostMeter::Work
{
public:
    Work(const Scene &scene, const MethodPtr &method, StepSize step, State from, TimerKind clocks)
        : m_plain(compose(scene, *method, step)), m_frames(step.framesPerOutput),
          m_stateBytes(std::max<std::size_t>(1, byteSize(from)))
    {
        for (const EffectPtr &effect : scene.effects) {
            if (!effect->isIdle())
                m_watched.emplace_back(effect, from, method->directionRule());
        }
        Scene probed = scene;
        probed.effects.clear();
        for (Watched &one : m_watched)
            probed.effects.push_back(instrumented(one.effect, *one.counter));
        m_probed = compose(probed, *method, step);
        std::stable_sort(m_watched.begin(), m_watched.end(), [this](const Watched &a, const Watched &b) {
            return firstPhaseOf(m_plain, a.effect) < firstPhaseOf(m_plain, b.effect);
        });
        for (Watched &one : m_watched)
            one.isWithin = std::any_of(m_plain.phases.begin(), m_plain.phases.end(), [&](const Phase &phase) {
                return !phase.effect && computes(phase, one.effect);
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
        Round found{*frame, 0.0, std::vector<double>(m_watched.size(), 0.0)};
        if (!addPhases(*plain, found, shouldContinue) || !addWithin(found, shouldContinue))
            return false;
        const double scale = 1e9 / m_frames;
        m_frame.add(scale * found.frame);
        m_rest.add(scale * found.rest);
        for (std::size_t i = 0; i < m_watched.size(); ++i)
            m_watched[i].samples.add(scale * found.effects[i]);
        return true;
    }

    FrameCost result() const
    {
        FrameCost cost{m_frame.median(), m_frame.spread(), {},
                       m_rest.median(),  m_rest.spread(),  m_frame.count()};
        for (const Watched &one : m_watched)
            cost.effects.push_back(
                {one.effect, one.points, one.evaluations, one.samples.median(), one.samples.spread()});
        return cost;
    }

    const Pipeline &pipeline() const { return m_plain; }

private:
    /// Seconds a row.
    struct Round
    {
        double frame;
        double rest;
        std::vector<double> effects;
    };

    /// Counts what each effect is asked in the frames that are measured, and keeps calls of those that have no phase of
    /// their own.
    bool prepare(const ShouldContinue &shouldContinue)
    {
        if (!m_batch->choose(m_plain, shouldContinue) || !m_batch->timeFrames(m_probed, shouldContinue))
            return false;
        const double frames = double(m_batch->rowsRun()) * m_frames;
        bool anyWithin = false;
        const auto most =
            std::clamp<std::int64_t>(static_cast<std::int64_t>(keptBytes / m_stateBytes), 1, mostKept);
        for (Watched &one : m_watched) {
            one.evaluations = one.counter->evaluations / frames;
            one.isWithin = one.isWithin && one.isAsked();
            anyWithin = anyWithin || one.isWithin;
            for (Calls *calls : {&one.counter->acts, &one.counter->slopes})
                calls->every = one.isWithin ? (calls->count + most - 1) / most : 0;
        }
        if (anyWithin && !keepCalls(shouldContinue))
            return false;
        m_isReady = true;
        return true;
    }

    bool keepCalls(const ShouldContinue &shouldContinue)
    {
        for (Watched &one : m_watched)
            one.counter->restart();
        const bool isDone = m_batch->timeFrames(m_probed, shouldContinue).has_value();
        for (Watched &one : m_watched) {
            for (Calls *calls : {&one.counter->acts, &one.counter->slopes})
                calls->every = 0;
        }
        m_perRow.clear();
        for (const Watched &one : m_watched)
            m_perRow.push_back({one.counter->acts.count, one.counter->slopes.count});
        return isDone;
    }

    /// Effects and the rest as far as they have phases of their own, and of the others the rest.
    bool addPhases(const PhaseTimes &plain, Round &found, const ShouldContinue &shouldContinue)
    {
        bool anyWithin = false;
        for (std::size_t i = 0; i < m_plain.phases.size(); ++i) {
            const Phase &phase = m_plain.phases[i];
            found.rest += plain.prelude[i];
            if (const auto which = indexOf(phase.effect))
                found.effects[*which] += plain.run[i] - plain.prelude[i];
            else
                found.rest += plain.run[i] - plain.prelude[i];
            anyWithin = anyWithin || computesWithin(phase);
        }
        if (!anyWithin)
            return true;
        const auto once = m_batch->timePhases(m_probed, shouldContinue);
        setRepeats(1);
        const auto twice = once ? m_batch->timePhases(m_probed, shouldContinue) : std::nullopt;
        setRepeats(0);
        for (std::size_t i = 0; twice && i < m_plain.phases.size(); ++i) {
            if (computesWithin(m_plain.phases[i]))
                found.rest -= twice->run[i] - once->run[i];
        }
        return twice.has_value();
    }

    /// Effects that have no phases of their own, by calling them again.
    bool addWithin(Round &found, const ShouldContinue &shouldContinue)
    {
        for (std::size_t i = 0; i < m_watched.size(); ++i) {
            Watched &one = m_watched[i];
            if (!one.isWithin)
                continue;
            if (shouldContinue && !shouldContinue())
                return false;
            found.effects[i] += (secondsOf(one.counter->acts) * double(m_perRow[i].acts) +
                                 secondsOf(one.counter->slopes) * double(m_perRow[i].slopes)) /
                                m_batch->rowsRun();
        }
        return true;
    }

    /// Seconds a call, the mean over the kept ones.
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
            const double wanted = replaySeconds / std::max(first, 1e-9);
            sum += wanted < 4.0 ? first : timed(static_cast<int>(std::min(wanted, double(mostReplays))));
        }
        return calls.kept.empty() ? 0.0 : sum / static_cast<double>(calls.kept.size());
    }

    void setRepeats(int repeats)
    {
        for (Watched &one : m_watched)
            one.counter->repeats = one.isWithin ? repeats : 0;
    }

    std::optional<std::size_t> indexOf(const EffectPtr &effect) const
    {
        for (std::size_t i = 0; i < m_watched.size(); ++i) {
            if (effect && m_watched[i].effect == effect)
                return i;
        }
        return {};
    }

    bool computesWithin(const Phase &phase) const
    {
        return std::any_of(phase.innerEffects.begin(), phase.innerEffects.end(),
                           [this](const EffectPtr &effect) {
                               const auto which = indexOf(effect);
                               return which && m_watched[*which].isWithin;
                           });
    }

    struct CallCounts
    {
        std::int64_t acts = 0;
        std::int64_t slopes = 0;
    };

    Pipeline m_plain;
    Pipeline m_probed; ///< the same, with effects that tell what they are asked
    std::vector<Watched> m_watched;
    std::optional<TimingBatch> m_batch;
    std::vector<CallCounts> m_perRow;
    int m_frames; ///< a row
    std::size_t m_stateBytes;
    bool m_isReady = false;
    Samples m_frame;
    Samples m_rest;
};

double FrameCost::sum() const
{
    double total = restNs;
    for (const EffectCost &one : effects)
        total += one.ns;
    return total;
}

CostMeter::CostMeter(const Scene &scene, const MethodPtr &method, StepSize step, State from)
    : m_work(std::make_unique<Work>(scene, method, step, std::move(from),
                                    TimerKind{wallSeconds, threadCpuSeconds}))
{
}

CostMeter::CostMeter(const Scene &scene, const MethodPtr &method, StepSize step, State from, Clock clock)
    : m_work(std::make_unique<Work>(scene, method, step, std::move(from), TimerKind{clock, clock}))
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
