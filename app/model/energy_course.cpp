#include "app/model/energy_course.h"

#include "app/model/same_run.h"
#include "sim/run/script/composed_interval.h"

#include <QElapsedTimer>

namespace app {

namespace {

constexpr std::int64_t rowsBefore = 500; ///< of the cursor, from which a run is counted that is far ahead

}

EnergyCourse::EnergyCourse(Session &session, QObject *parent)
    : QObject(parent), m_session(session), m_later([this](double milliseconds) { fillFor(milliseconds); })
{
    connect(&session, &Session::stepOpened, this, &EnergyCourse::restart);
    connect(&session, &Session::runChanged, this, &EnergyCourse::dropChanged);
    connect(&session, &Session::moved, this, &EnergyCourse::follow);
}

void EnergyCourse::setWatched(bool watched)
{
    m_watched = watched;
    if (!watched)
        m_later.stop();
    else if (m_stale)
        restart();
    else
        fill();
}

const sim::Balance *EnergyCourse::at(std::int64_t frame) const
{
    const std::int64_t row = (frame - m_first) / m_framesPerOutput;
    if (frame < m_first || row >= static_cast<std::int64_t>(m_balances.size()))
        return nullptr;
    return &m_balances[static_cast<std::size_t>(row)];
}

std::optional<sim::NoEnergy> EnergyCourse::whyNone(const sim::Scene &scene)
{
    if (scene.start.pointCount() > mostPoints)
        return sim::NoEnergy::tooLarge;
    return sim::StoredEnergyReader::whyNot(scene);
}

void EnergyCourse::restartAt(std::int64_t frame)
{
    m_balances.clear();
    m_ledger = {};
    m_stale = !m_watched;
    if (m_stale)
        return;
    m_start = m_first = frame;
    const sim::Timeline &timeline = m_session.timeline();
    m_framesPerOutput = timeline.track().framesPerOutput();
    m_script = withoutInput(timeline.script());
    m_input = timeline.script().input;
    const std::shared_ptr<const sim::ComposedInterval> interval = timeline.track().intervalAt(frame);
    m_whyNot = whyNone(interval->scene);
    if (!m_whyNot) {
        sim::Balance nothing;
        nothing.before = nothing.after =
            sim::StoredEnergyReader(interval->scene).read(timeline.track().stateAt(frame));
        m_balances.push_back(nothing);
    }
    emit changed();
    fill();
}

void EnergyCourse::dropChanged()
{
    if (!m_watched) {
        m_stale = true;
        return;
    }
    const sim::Timeline &timeline = m_session.timeline();
    // What a learner does concerns the rows after the cursor; what is undone may be long past.
    const std::int64_t differs = firstDifference(m_input, timeline.script().input);
    m_input = timeline.script().input;
    if (!sameRun(m_script, timeline.script()) || timeline.cursor().frame < m_first ||
        differs <= timeline.cursor().frame) {
        restart();
        return;
    }
    if (last() > timeline.cursor().frame) {
        m_balances.resize(
            static_cast<std::size_t>((timeline.cursor().frame - m_first) / m_framesPerOutput + 1));
        emit changed();
    }
    fill();
}

void EnergyCourse::follow()
{
    if (m_session.isPlaying())
        fill();
    else
        m_later.runWhileMoved();
}

void EnergyCourse::fillFor(double milliseconds)
{
    if (!m_watched || m_whyNot)
        return;
    const sim::Timeline &timeline = m_session.timeline();
    const std::int64_t cursor = timeline.cursor().frame;
    if (cursor < m_first) {
        restart();
        return;
    }
    if (cursor - last() > mostAhead * m_framesPerOutput) {
        restartAt(std::max<std::int64_t>(0, cursor - rowsBefore * m_framesPerOutput));
        return;
    }
    QElapsedTimer clock;
    clock.start();
    bool any = false;
    while (!m_whyNot && last() < timeline.computed() &&
           (!any || static_cast<double>(clock.nsecsElapsed()) < 1e6 * milliseconds)) {
        countNext();
        any = true;
    }
    if (!m_whyNot && last() < timeline.computed())
        m_later.goOn();
    if (any)
        emit changed();
}

void EnergyCourse::countNext()
{
    const sim::Track &track = m_session.timeline().track();
    const std::int64_t frame = last() + m_framesPerOutput;
    const bool fits = track.intervalAt(frame)->scene.start.pointCount() <= mostPoints;
    const std::optional<sim::Balance> row = fits ? m_ledger.row(track, frame) : std::nullopt;
    if (!row) { // a number has changed the scene so that it has none
        m_whyNot = whyNone(track.intervalAt(frame)->scene);
        m_balances.clear();
        return;
    }
    m_balances.push_back(m_balances.back());
    m_balances.back().append(*row);
    if (m_balances.size() > mostRows) {
        m_balances.pop_front();
        m_first += m_framesPerOutput;
    }
}

}
