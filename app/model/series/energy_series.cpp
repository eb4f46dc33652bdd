#include "app/model/series/energy_series.h"

#include "sim/run/script/composed_interval.h"

namespace app {

namespace {

/// If the cursor is far ahead, counting starts this many output steps before it.
constexpr std::int64_t stepsBefore = 500;

}

EnergySeries::EnergySeries(const OpenRun &run, const Playback &playback, QObject *parent)
    : QObject(parent), m_run(run), m_playback(playback),
      m_idleTask([this] { return countNext(); }, [this] { emit changed(); })
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

std::optional<sim::NoEnergy> EnergySeries::whyNone(const sim::Scene &scene)
{
    if (scene.start.pointCount() > mostPoints)
        return sim::NoEnergy::tooLarge;
    return sim::StoredEnergyReader::whyNot(scene);
}

void EnergySeries::restartAt(std::int64_t frame)
{
    const sim::Track &track = m_run.timeline().track();
    startAt(frame, track.framesPerOutput());
    m_start = frame;
    m_ledger = {};
    m_stale = !m_isActive;
    if (m_stale)
        return;
    const std::shared_ptr<const sim::ComposedInterval> interval = track.intervalAt(frame);
    m_whyNot = whyNone(interval->scene);
    if (!m_whyNot) {
        sim::Balance nothing;
        nothing.before = nothing.after = sim::StoredEnergyReader(interval->scene).read(track.stateAt(frame));
        append(nothing, mostSteps);
    }
    emit changed();
    fill();
}

void EnergySeries::follow(const Change &change)
{
    if (change.isAny(ChangeKind::step) || change.firstFrame <= first())
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
    if (eraseFrom(frame))
        emit changed();
    fill();
}

void EnergySeries::followCursor()
{
    if (m_playback.isPlaying())
        fill();
    else
        m_idleTask.runWhileMoved();
}

bool EnergySeries::countNext()
{
    if (!m_isActive || m_whyNot)
        return false;
    const sim::Timeline &timeline = m_run.timeline();
    const std::int64_t cursor = timeline.cursor().frame, frame = last() + framesPerOutput();
    if (cursor < first() || cursor - last() > mostAhead * framesPerOutput()) {
        restartAt(cursor < first() ? 0 : std::max<std::int64_t>(0, cursor - stepsBefore * framesPerOutput()));
        return false;
    }
    if (frame > timeline.computed())
        return false;
    const std::shared_ptr<const sim::ComposedInterval> interval = timeline.track().intervalAt(frame);
    const bool fits = interval->scene.start.pointCount() <= mostPoints;
    const std::optional<sim::Balance> step =
        fits ? m_ledger.balanceAt(timeline.track(), frame) : std::nullopt;
    if (!step) { // a changed parameter has made a scene without energy
        m_whyNot = whyNone(interval->scene);
        startAt(first(), framesPerOutput());
        return true;
    }
    sim::Balance balance = *at(last());
    balance.append(*step);
    append(std::move(balance), mostSteps);
    return true;
}

}
