#include "app/model/series/measure_series.h"

#include "lessons/api/view/view.h"
#include "sim/run/script/composed_interval.h"

namespace app {

MeasureSeries::MeasureSeries(const OpenRun &run, QObject *parent)
    : QObject(parent), m_run(run), m_idleTask([this] { return measureNext(); }, [this] { emit changed(); })
{
    run.onChange(ChangeKind::step | ChangeKind::run | ChangeKind::cursor, this, &MeasureSeries::follow);
    restart();
}

void MeasureSeries::restart()
{
    startAt(0, m_run.timeline().track().framesPerOutput());
    emit changed();
    m_idleTask.run();
}

void MeasureSeries::follow(const Change &change)
{
    if (change.isAny(ChangeKind::step) || change.firstFrame <= first())
        restart();
    else
        dropFrom(change.firstFrame);
}

void MeasureSeries::dropFrom(std::int64_t frame)
{
    if (eraseFrom(frame)) {
        m_before = m_run.timeline().track().stateAt(last());
        emit changed();
    }
    m_idleTask.run();
}

bool MeasureSeries::measureNext()
{
    if (m_run.step().measures.empty() && !m_run.step().isFootDown)
        return false;
    const sim::Timeline &timeline = m_run.timeline();
    const sim::Track &track = timeline.track();
    if (timeline.state().pointCount() > manyPoints) {
        // Measure only at the cursor: going back over such a run would take too long.
        if (!isEmpty() && first() == last() && last() == timeline.cursor().frame)
            return false;
        startAt(timeline.cursor().frame, framesPerOutput());
    } else if (!isEmpty() && last() >= timeline.computed()) {
        return false;
    }
    const bool isFirst = isEmpty();
    const std::int64_t frame = isFirst ? first() : last() + framesPerOutput();
    sim::State state = track.stateAt(frame);
    const std::shared_ptr<const sim::ComposedInterval> interval = track.intervalAt(frame);
    const bool comparable = !isFirst && m_before.pointCount() == state.pointCount();
    Sample sample;
    const sim::State *before = comparable ? &m_before : nullptr;
    for (const lessons::Measure &measure : m_run.step().measures)
        sample.measures.push_back(
            measure.ofRun ? measure.ofRun(track.script(), interval->scene, state, before, interval->values)
                          : measure.of(interval->scene, state, before, interval->values));
    if (m_run.step().isFootDown) {
        const lessons::View view = m_run.step().view(interval->scene, interval->values);
        for (const int foot : view.feet) {
            const std::size_t index = sample.stands.size();
            sample.stands.push_back(m_run.step().isFootDown(interval->scene, state, interval->values, foot));
            const bool stood = comparable && index < at(last())->stands.size() && at(last())->stands[index];
            const double slip =
                stood && sample.stands.back() ? state.positionOf(foot).x - m_before.positionOf(foot).x : 0.0;
            sample.slips.push_back(slip);
        }
    }
    append(std::move(sample), mostSteps);
    m_before = std::move(state);
    return true;
}

}
