#include "app/model/series/measure_series.h"

#include "lessons/api/view/view.h"
#include "sim/run/script/composed_interval.h"

#include <QElapsedTimer>

#include <cmath>

namespace app {

namespace {

constexpr qint64 measuringMilliseconds = 4;

}

MeasureSeries::MeasureSeries(const OpenRun &run, QObject *parent) : QObject(parent), m_run(run)
{
    m_timer.setSingleShot(true);
    m_timer.setInterval(0);
    connect(&m_timer, &QTimer::timeout, this, &MeasureSeries::fill);
    run.onChange(ChangeKind::step | ChangeKind::run | ChangeKind::cursor, this, &MeasureSeries::follow);
    restart();
}

const Sample *MeasureSeries::at(std::int64_t frame) const
{
    const std::int64_t row = (frame - m_first) / m_framesPerOutput;
    if (frame < m_first || row >= static_cast<std::int64_t>(m_samples.size()))
        return nullptr;
    return &m_samples[static_cast<std::size_t>(row)];
}

bool MeasureSeries::wanted() const
{
    return !m_run.step().measures.empty() || m_run.step().isFootDown;
}

void MeasureSeries::restart()
{
    m_samples.clear();
    m_first = 0;
    m_framesPerOutput = m_run.timeline().track().framesPerOutput();
    emit changed();
    fill();
}

void MeasureSeries::follow(const Change &change)
{
    if (change.isAny(ChangeKind::step) || change.firstFrame <= m_first)
        restart();
    else
        dropFrom(change.firstFrame);
}

void MeasureSeries::dropFrom(std::int64_t frame)
{
    if (!m_samples.empty() && last() >= frame) {
        m_samples.resize(static_cast<std::size_t>((frame - 1 - m_first) / m_framesPerOutput + 1));
        m_before = m_run.timeline().track().stateAt(last());
        emit changed();
    }
    fill();
}

void MeasureSeries::fill()
{
    if (!wanted())
        return;
    const sim::Timeline &timeline = m_run.timeline();
    if (timeline.state().pointCount() > manyPoints) {
        // Measure only at the cursor: going back over such a run would take too long.
        if (m_samples.empty() || last() != timeline.cursor().frame || m_first != last()) {
            m_samples.clear();
            m_first = timeline.cursor().frame;
            measureNext();
            emit changed();
        }
        return;
    }
    QElapsedTimer clock;
    clock.start();
    bool any = false;
    while ((m_samples.empty() || last() < timeline.computed()) && clock.elapsed() < measuringMilliseconds) {
        measureNext();
        any = true;
    }
    if (last() < timeline.computed())
        m_timer.start();
    if (any)
        emit changed();
}

void MeasureSeries::measureNext()
{
    const sim::Track &track = m_run.timeline().track();
    const bool isFirst = m_samples.empty();
    const std::int64_t frame = isFirst ? m_first : last() + m_framesPerOutput;
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
            const bool stood =
                comparable && index < m_samples.back().stands.size() && m_samples.back().stands[index];
            const double slip =
                stood && sample.stands.back() ? state.positionOf(foot).x - m_before.positionOf(foot).x : 0.0;
            sample.slips.push_back(slip);
        }
    }
    m_samples.push_back(std::move(sample));
    m_before = std::move(state);
    if (m_samples.size() > mostRows) {
        m_samples.pop_front();
        m_first += m_framesPerOutput;
    }
}

}
