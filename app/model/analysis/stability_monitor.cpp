#include "app/model/analysis/stability_monitor.h"

#include "app/model/run/run_program.h"
#include "sim/base/error.h"
#include "sim/run/script/composed_interval.h"

#include <algorithm>

namespace app {

namespace {

constexpr double leastStiffness = 0.01, mostStiffness = 10.0; ///< 1/frame^2, of a map
constexpr double leastStep = 1.0 / 64, mostStep = 4.0;        ///< frames
constexpr double mostDamp =
    0.999; ///< of a map: at 1 nothing is damped, and whole regions change colour at once

}

/// The state that a job examines, copied for its thread.
struct StabilityMonitor::Subject
{
    sim::Script script;
    std::shared_ptr<const sim::ComposedInterval> interval;
    sim::State state;
    std::int64_t frame = 0;
};

/// The remedies to search for besides the limit, if they are shown.
struct StabilityMonitor::Offers
{
    std::optional<sim::DampRange> damping;
    std::optional<sim::IterationRange> passes;
};

StabilityMonitor::StabilityMonitor(const OpenRun &run, RunEditor &editor, const Preview &preview,
                                   QObject *parent)
    : QObject(parent), m_run(run), m_editor(editor), m_preview(run, preview)
{
    m_due.setSingleShot(true);
    m_mapDue.setSingleShot(true);
    m_mapDue.setInterval(restMilliseconds);
    connect(&m_due, &QTimer::timeout, this, &StabilityMonitor::startReading);
    connect(&m_mapDue, &QTimer::timeout, this, &StabilityMonitor::startMap);
    run.onChange(ChangeKind::step, this, &StabilityMonitor::reset);
    run.onChange(ChangeKind::run, this, &StabilityMonitor::followRun);
    run.onChange(ChangeKind::cursor, this, &StabilityMonitor::followCursor);
    noteSpot();
    followCursor();
}

StabilityMonitor::Subject StabilityMonitor::currentSubject() const
{
    const sim::Track &track = m_run.timeline().track();
    // Both of the next output step: its input may change the number of points.
    std::shared_ptr<const sim::ComposedInterval> interval;
    sim::State state = track.preview(interval);
    return {m_run.timeline().script(), std::move(interval), std::move(state),
            m_run.timeline().cursor().frame};
}

void StabilityMonitor::followCursor()
{
    if (m_plane)
        m_mapDue.start();
    if (m_readingJob.isRunning())
        m_hasChanged = true;
    else if (!m_due.isActive())
        m_due.start(m_sinceReading.isValid() ? std::max<int>(0, m_pause - int(m_sinceReading.elapsed())) : 0);
}

void StabilityMonitor::followRun()
{
    noteSpot();
    followCursor();
}

void StabilityMonitor::reset()
{
    stopMap();
    m_map.reset();
    m_tried.clear();
    noteSpot();
    followCursor();
    emit mapChanged();
}

StabilityReading StabilityMonitor::readingOf(const Subject &subject, const std::optional<Offers> &offers,
                                             const BackgroundJob::Context &job)
{
    StabilityReading reading = readStability(subject.script, subject.interval, subject.state);
    if (!offers || job.isCancelled() || programOf(subject.script.method))
        return reading;
    try {
        reading.remedies = sim::remediesFor(subject.script, subject.interval->values, subject.state,
                                            reading.stability, offers->damping ? &*offers->damping : nullptr);
        reading.sticks = sim::stickAdvice(subject.script, subject.frame,
                                          offers->passes ? &*offers->passes : nullptr, job.shouldContinue());
    } catch (const sim::Error &) {
        // The scene cannot be set up: the session reports the reason.
        reading.stability.bound = sim::Bound::unknown;
    }
    return reading;
}

void StabilityMonitor::startReading()
{
    m_hasChanged = false;
    std::optional<Offers> offers;
    if (m_detailed)
        offers = Offers{m_editor.damping(), m_editor.passes()};
    m_readingJob.start(
        [subject = currentSubject(), offers](const BackgroundJob::Context &job) {
            return timedReading([&] { return readingOf(subject, offers, job); });
        },
        [this](std::future<TimedReading> result) { receive(result.get()); });
}

void StabilityMonitor::receive(const TimedReading &result)
{
    m_pause = std::max(pauseMilliseconds, result.pause());
    m_sinceReading.start();
    m_reading = result.reading;
    if (m_hasChanged)
        m_due.start(m_pause);
    emit changed();
}

void StabilityMonitor::setDetailed(bool detailed)
{
    if (detailed == m_detailed)
        return;
    m_detailed = detailed;
    if (detailed)
        followCursor();
}

void StabilityMonitor::adopt(const sim::Remedy &remedy)
{
    m_editor.use(remedy);
}

void StabilityMonitor::adopt(const TriedSpot &spot)
{
    const TriedSpot to = settable(spot);
    m_adopting = true;
    // Set the step first: this turns the old run into the comparison run. Later changes at the cursor do not make
    // another.
    m_editor.setStepSize(to.h);
    m_editor.setParameter(QStringLiteral("damp"), to.damp);
    m_editor.setParameter(QStringLiteral("k"), to.k);
    m_adopting = false;
    noteSpot();
}

void StabilityMonitor::noteSpot()
{
    if (m_adopting)
        return; // only some of the settings are applied so far
    const sim::Values &values = m_run.timeline().values();
    TriedSpot spot;
    spot.k = values.has("k") ? values["k"] : 0.0;
    spot.damp = values.has("damp") ? values["damp"] : 1.0;
    spot.h = m_run.timeline().script().step.h;
    if (addTried(m_tried, spot))
        emit mapChanged();
}

bool StabilityMonitor::canMap(MapPlane plane) const
{
    const lessons::Step &step = m_run.step();
    return m_run.timeline().state().pointCount() <= sim::maxAnalysedPoints &&
           !programOf(m_run.timeline().script().method) &&
           m_run.timeline().script().method->stepLimit() == sim::StepLimit::stiffness &&
           step.parameter(QStringLiteral("k")) &&
           (plane == MapPlane::step || step.parameter(QStringLiteral("damp"))) && !nothingSwings();
}

bool StabilityMonitor::nothingSwings() const
{
    return m_reading && m_reading->stability.bound == sim::Bound::noSprings && m_tried.back().k > 0.0;
}

void StabilityMonitor::requestMap(std::optional<MapPlane> plane)
{
    if (plane == m_plane)
        return;
    stopMap();
    m_plane = plane;
    m_map.reset();
    if (plane)
        startMap();
    emit mapChanged();
}

sim::MapAxis StabilityMonitor::across() const
{
    const double k = std::max(m_tried.back().k, 1e-6);
    const lessons::Parameter &declared = *m_run.step().parameter(QStringLiteral("k"));
    return sim::MapAxis::byRatio("k", std::min(leastStiffness, k / 2.0),
                                 std::min(declared.max, std::max(mostStiffness, 2.0 * k)), columns);
}

sim::MapAxis StabilityMonitor::up() const
{
    if (*m_plane == MapPlane::damping)
        return sim::MapAxis::evenly("damp", 0.0, mostDamp, rows);
    const double h = m_tried.back().h;
    return sim::MapAxis::byRatio({}, std::min(leastStep, h), std::max(mostStep, h), rows);
}

void StabilityMonitor::stopMap()
{
    m_mapDue.stop();
    m_mapJob.cancel();
}

void StabilityMonitor::startMap()
{
    stopMap();
    if (!m_plane || !canMap(*m_plane)) {
        emit mapChanged(); // isMapping() may have changed
        return;
    }
    m_mapJob.start(
        [this, subject = currentSubject(), x = across(), y = up()](const BackgroundJob::Context &job) {
            QElapsedTimer sinceReport;
            sinceReport.start();
            const auto report = [&](const sim::GrowthMap &soFar) {
                if (sinceReport.hasExpired(pauseMilliseconds)) {
                    sinceReport.start();
                    job.report([this, copy = std::make_shared<const sim::GrowthMap>(soFar)] {
                        m_map = copy;
                        emit mapChanged();
                    });
                }
                return !job.isCancelled();
            };
            return std::make_shared<const sim::GrowthMap>(
                sim::growthMap(subject.script, subject.interval->values, subject.state, x, y, report));
        },
        [this](std::future<std::shared_ptr<const sim::GrowthMap>> result) {
            try {
                m_map = result.get();
            } catch (const sim::Error &) {
                // The scene cannot be set up: keep the known rows of the map.
            }
            emit mapChanged();
        });
}

}
