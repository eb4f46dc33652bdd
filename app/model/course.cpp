#include "app/model/course.h"

#include "app/model/same_run.h"
#include "lessons/api/view/view.h"
#include "sim/run/script/composed_interval.h"

#include <QElapsedTimer>

#include <cmath>

namespace app {

namespace {

constexpr qint64 sliceMilliseconds = 4;

}

Course::Course(Session &session, QObject *parent) : QObject(parent), m_session(session)
{
    m_later.setSingleShot(true);
    m_later.setInterval(0);
    connect(&m_later, &QTimer::timeout, this, &Course::fill);
    connect(&session, &Session::stepOpened, this, &Course::restart);
    connect(&session, &Session::runChanged, this, &Course::dropChanged);
    connect(&session, &Session::moved, this, &Course::fill);
    restart();
}

const Sample *Course::at(std::int64_t frame) const
{
    const std::int64_t row = (frame - m_first) / m_framesPerOutput;
    if (frame < m_first || row >= static_cast<std::int64_t>(m_samples.size()))
        return nullptr;
    return &m_samples[static_cast<std::size_t>(row)];
}

bool Course::wanted() const
{
    return !m_session.step().measures.empty() || m_session.step().isFootDown;
}

void Course::restart()
{
    m_samples.clear();
    m_first = 0;
    m_framesPerOutput = m_session.timeline().track().framesPerOutput();
    m_script = withoutInput(m_session.timeline().script());
    m_input = m_session.timeline().script().input;
    emit changed();
    fill();
}

void Course::dropChanged()
{
    const sim::Timeline &timeline = m_session.timeline();
    // What a learner does concerns the rows after the cursor; what is undone may be long past.
    const std::int64_t differs = firstDifference(m_input, timeline.script().input);
    m_input = timeline.script().input;
    if (!sameRun(m_script, timeline.script()) || differs <= timeline.cursor().frame) {
        restart();
        return;
    }
    if (!m_samples.empty() && last() > timeline.cursor().frame) {
        if (timeline.cursor().frame < m_first) {
            restart();
            return;
        }
        m_samples.resize(
            static_cast<std::size_t>((timeline.cursor().frame - m_first) / m_framesPerOutput + 1));
        m_before = timeline.track().stateAt(last());
        emit changed();
    }
    fill();
}

void Course::fill()
{
    if (!wanted())
        return;
    const sim::Timeline &timeline = m_session.timeline();
    if (timeline.state().pointCount() > manyPoints) {
        // Only where the cursor is: going back over such a run would take too long.
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
    while ((m_samples.empty() || last() < timeline.computed()) && clock.elapsed() < sliceMilliseconds) {
        measureNext();
        any = true;
    }
    if (last() < timeline.computed())
        m_later.start();
    if (any)
        emit changed();
}

void Course::measureNext()
{
    const sim::Track &track = m_session.timeline().track();
    const bool isFirst = m_samples.empty();
    const std::int64_t frame = isFirst ? m_first : last() + m_framesPerOutput;
    sim::State state = track.stateAt(frame);
    const std::shared_ptr<const sim::ComposedInterval> interval = track.intervalAt(frame);
    const bool comparable = !isFirst && m_before.pointCount() == state.pointCount();
    Sample sample;
    const sim::State *before = comparable ? &m_before : nullptr;
    for (const lessons::Measure &measure : m_session.step().measures)
        sample.measures.push_back(
            measure.ofRun ? measure.ofRun(track.script(), interval->scene, state, before, interval->values)
                          : measure.of(interval->scene, state, before, interval->values));
    if (m_session.step().isFootDown) {
        const lessons::View look = m_session.step().view(interval->scene, interval->values);
        for (const int foot : look.feet) {
            const std::size_t index = sample.stands.size();
            sample.stands.push_back(
                m_session.step().isFootDown(interval->scene, state, interval->values, foot));
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
