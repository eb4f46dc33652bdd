#include "app/model/series/run_sampler.h"

#include "sim/run/script/composed_interval.h"
#include "sim/simd/flush_denormals.h"

#include <algorithm>

namespace app {

sim::State stateAfter(sim::State end, const sim::Track &track)
{
    const std::int64_t frame = end.frame;
    const std::int64_t next = frame + track.framesPerOutput();
    if (track.cursor() == sim::Cursor{next, 0} || track.cachedFrameBefore(next) == next)
        return track.stateAt(next);
    sim::State state = track.stateAfterInput(std::move(end), frame);
    const sim::FlushDenormals flush;
    const std::shared_ptr<const sim::ComposedInterval> interval = track.intervalAt(next);
    for (int phase = 0; phase < interval->pipeline.phasesPerOutput(); ++phase)
        interval->pipeline.phaseAt(phase).run(state);
    return state;
}

RunSampler::RunSampler(std::vector<Quantity> quantities, std::int64_t first, int framesPerOutput,
                       std::int64_t stride)
    : m_quantities(std::move(quantities)), m_samples(m_quantities.size(), first, framesPerOutput, stride),
      m_framesPerOutput(framesPerOutput),
      m_needsPreviousStep(std::any_of(m_quantities.begin(), m_quantities.end(),
                                      [](const Quantity &one) { return needsPreviousStep(one.what); }))
{
}

void RunSampler::readNext(const sim::Track &track)
{
    const std::int64_t wanted = m_samples.nextFrame();
    if (!m_end && wanted > 0) // start an output step earlier, because accelerations need it
        m_end = track.stateAt(track.cachedFrameBefore(wanted - m_framesPerOutput));
    else if (!m_end)
        m_end = track.stateAt(0);
    if (m_end->frame == wanted) {
        read(track, nullptr);
        return;
    }
    std::optional<sim::State> before;
    const bool isThere = m_end->frame + m_framesPerOutput == wanted;
    if (isThere && m_needsPreviousStep)
        before = *m_end;
    m_end = stateAfter(std::move(*m_end), track);
    if (isThere)
        read(track, before ? &*before : nullptr);
}

void RunSampler::read(const sim::Track &track, const sim::State *before)
{
    const std::shared_ptr<const sim::ComposedInterval> interval = track.intervalAt(m_end->frame);
    if (m_reader.segment() != interval.get())
        m_reader = QuantityReader(m_quantities, interval);
    std::vector<double> values(m_quantities.size());
    m_reader.read({*m_end, before, static_cast<double>(m_framesPerOutput)}, values);
    m_samples.add(values);
}

void RunSampler::forgetAfter(std::int64_t frame)
{
    const std::int64_t was = m_samples.nextFrame();
    m_samples.forgetAfter(frame);
    if (m_samples.nextFrame() != was)
        m_end.reset();
    else if (m_end && m_end->frame > frame)
        m_end.reset();
}

}
