#include "app/model/series/energy_series.h"

#include "sim/run/script/composed_interval.h"

#include <QElapsedTimer>

namespace app {

namespace {

/// If the cursor is far ahead, counting starts this many output steps before it.
constexpr std::int64_t rowsBefore = 500;

}

EnergySeries::EnergySeries(const OpenRun &run, const Playback &playback, QObject *parent)
    : QObject(parent), m_run(run), m_playback(playback),
      m_idleTask([this](double milliseconds) { fillFor(milliseconds); })
{
    run.onChange(ChangeKind::step | ChangeKind::run | ChangeKind::cursor, this, &EnergySeries::follow);
}

void EnergySeries::setActive(bool isActive)
{
    m_isActive = isActive;
    if (!isActive)
        m_idleTask.stop();
    else if (m_stale)
        restart();
    else
        fill();
}

const sim::Balance *EnergySeries::at(std::int64_t frame) const
{
    const std::int64_t row = (frame - m_first) / m_framesPerOutput;
    if (frame < m_first || row >= static_cast<std::int64_t>(m_balances.size()))
        return nullptr;
    return &m_balances[static_cast<std::size_t>(row)];
}

std::optional<sim::NoEnergy> EnergySeries::whyNone(const sim::Scene &scene)
{
    if (scene.start.pointCount() > mostPoints)
        return sim::NoEnergy::tooLarge;
    return sim::StoredEnergyReader::whyNot(scene);
}

void EnergySeries::restartAt(std::int64_t frame)
{
    m_balances.clear();
    m_ledger = {};
    m_stale = !m_isActive;
    if (m_stale)
        return;
    m_start = m_first = frame;
    const sim::Timeline &timeline = m_run.timeline();
    m_framesPerOutput = timeline.track().framesPerOutput();
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

void EnergySeries::follow(const Change &change)
{
    if (change.isAny(ChangeKind::step) || change.firstFrame <= m_first)
        restart();
    else if (change.isAny(ChangeKind::run))
        dropFrom(change.firstFrame);
    else
        followCursor();
}

void EnergySeries::dropFrom(std::int64_t frame)
{
    if (!m_isActive) {
        m_stale = true;
        return;
    }
    if (last() >= frame) {
        m_balances.resize(static_cast<std::size_t>((frame - 1 - m_first) / m_framesPerOutput + 1));
        emit changed();
    }
    fill();
}

void EnergySeries::followCursor()
{
    if (m_playback.isPlaying())
        fill();
    else
        m_idleTask.runWhileMoved();
}

void EnergySeries::fillFor(double milliseconds)
{
    if (!m_isActive || m_whyNot)
        return;
    const sim::Timeline &timeline = m_run.timeline();
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
        m_idleTask.goOn();
    if (any)
        emit changed();
}

void EnergySeries::countNext()
{
    const sim::Track &track = m_run.timeline().track();
    const std::int64_t frame = last() + m_framesPerOutput;
    const bool fits = track.intervalAt(frame)->scene.start.pointCount() <= mostPoints;
    const std::optional<sim::Balance> row = fits ? m_ledger.row(track, frame) : std::nullopt;
    if (!row) { // a changed parameter has made a scene without energy
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
