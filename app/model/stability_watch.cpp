#include "app/model/stability_watch.h"

#include "sim/base/error.h"
#include "sim/run/script/composed_interval.h"

#include <algorithm>
#include <cmath>

namespace app {

namespace {

constexpr int shareOfTime = 4; ///< a reading is followed by a pause this many times as long
constexpr std::size_t mostTried = 400;
constexpr double leastStiffness = 0.01, mostStiffness = 10.0; ///< 1/frame^2, of a map
constexpr double leastStep = 1.0 / 64, mostStep = 4.0;        ///< frames
constexpr double mostDamp = 0.999; ///< of a map: at 1 nothing is damped, and whole regions turn at once

}

struct StabilityWatch::Job
{
    std::atomic<bool> stop = false;
};

/// What a job is about, for a thread of its own.
struct StabilityWatch::Subject
{
    sim::Script script;
    std::shared_ptr<const sim::ComposedInterval> interval;
    sim::State state;
    std::int64_t frame = 0;
};

/// What to look for besides the limit, when somebody reads it.
struct StabilityWatch::Offers
{
    std::optional<sim::DampRange> damping;
    std::optional<sim::IterationRange> passes;
};

StabilityWatch::StabilityWatch(Session &session, QObject *parent)
    : QObject(parent), m_session(session), m_look(session)
{
    m_pool.setMaxThreadCount(2); // one reading and one map
    m_due.setSingleShot(true);
    m_mapDue.setSingleShot(true);
    m_mapDue.setInterval(restMilliseconds);
    connect(&m_due, &QTimer::timeout, this, &StabilityWatch::read);
    connect(&m_mapDue, &QTimer::timeout, this, &StabilityWatch::startMap);
    connect(&session, &Session::moved, this, &StabilityWatch::follow);
    connect(&session, &Session::runChanged, this, &StabilityWatch::followRun);
    connect(&session, &Session::stepOpened, this, &StabilityWatch::forget);
    noteSpot();
    follow();
}

StabilityWatch::~StabilityWatch()
{
    stopMap();
    if (m_reads)
        m_reads->stop = true;
    m_pool.waitForDone();
}

StabilityWatch::Subject StabilityWatch::subject() const
{
    const sim::Track &track = m_session.timeline().track();
    std::shared_ptr<const sim::ComposedInterval>
        interval; // of the row to come: its input may change how many points there are
    sim::State state = track.preview(interval);
    return {m_session.timeline().script(), std::move(interval), std::move(state),
            m_session.timeline().cursor().frame};
}

void StabilityWatch::follow()
{
    if (m_plane)
        m_mapDue.start();
    if (m_reads)
        m_again = true;
    else if (!m_due.isActive())
        m_due.start(m_sinceRead.isValid() ? std::max<int>(0, m_pause - int(m_sinceRead.elapsed())) : 0);
}

void StabilityWatch::followRun()
{
    noteSpot();
    follow();
}

void StabilityWatch::forget()
{
    stopMap();
    m_map.reset();
    m_tried.clear();
    noteSpot();
    follow();
    emit mapChanged();
}

StabilityReading StabilityWatch::readingOf(const Subject &about, const std::optional<Offers> &offers,
                                           const std::shared_ptr<Job> &job)
{
    StabilityReading reading = readStability(about.script, about.interval, about.state);
    if (!offers || job->stop)
        return reading;
    try {
        reading.remedies = sim::remediesFor(about.script, about.interval->values, about.state,
                                            reading.stability, offers->damping ? &*offers->damping : nullptr);
        reading.sticks =
            sim::stickAdvice(about.script, about.frame, offers->passes ? &*offers->passes : nullptr,
                             [job] { return !job->stop; });
    } catch (const sim::Error &) {
        reading.stability.bound = sim::Bound::unknown; // no such scene: the session says why
    }
    return reading;
}

void StabilityWatch::read()
{
    m_again = false;
    m_reads = std::make_shared<Job>();
    m_pool.start([this, job = m_reads, about = subject(),
                  offers = m_detailed ? std::optional(Offers{m_session.damping(), m_session.passes()})
                                      : std::nullopt] {
        QElapsedTimer clock;
        clock.start();
        const auto reading = std::make_shared<const StabilityReading>(readingOf(about, offers, job));
        const int took = static_cast<int>(clock.elapsed());
        QMetaObject::invokeMethod(
            this, [this, job, reading, took] { take(job, reading, took); }, Qt::QueuedConnection);
    });
}

void StabilityWatch::take(const std::shared_ptr<Job> &job, std::shared_ptr<const StabilityReading> reading,
                          int took)
{
    if (job != m_reads)
        return;
    m_reads.reset();
    m_pause = std::max(pauseMilliseconds, shareOfTime * took);
    m_sinceRead.start();
    m_reading = std::move(reading);
    if (m_again)
        m_due.start(m_pause);
    emit changed();
}

void StabilityWatch::setDetailed(bool detailed)
{
    if (detailed == m_detailed)
        return;
    m_detailed = detailed;
    if (detailed)
        follow();
}

void StabilityWatch::adopt(const sim::Remedy &remedy)
{
    m_session.use(remedy);
}

TriedSpot StabilityWatch::settable(TriedSpot spot) const
{
    const auto fitted = [&](const char *id, double value, double grid) {
        const lessons::Parameter *declared = m_session.step().parameter(QString::fromLatin1(id));
        const double rounded = std::round(value / grid) * grid;
        return declared ? std::clamp(rounded, declared->min, declared->max) : value;
    };
    // Three digits of a stiffness, which goes by ratio; damping as its field shows it.
    if (spot.k > 0.0)
        spot.k = fitted("k", spot.k, std::pow(10.0, std::floor(std::log10(spot.k)) - 2.0));
    if (const lessons::Parameter *damp = m_session.step().parameter(QStringLiteral("damp")))
        spot.damp = fitted("damp", spot.damp, std::pow(10.0, -damp->decimals));
    spot.h = spot.h < 1.0 ? 1.0 / std::round(1.0 / spot.h) : std::round(spot.h);
    return spot;
}

void StabilityWatch::adopt(const TriedSpot &spot)
{
    const TriedSpot to = settable(spot);
    m_adopting = true;
    // The step first: it makes the run as it was the ghost, and what is set after it at the cursor makes no other.
    m_session.setStepSize(to.h);
    m_session.setParameter(QStringLiteral("damp"), to.damp);
    m_session.setParameter(QStringLiteral("k"), to.k);
    m_adopting = false;
    noteSpot();
}

void StabilityWatch::noteSpot()
{
    if (m_adopting)
        return; // half way to the next one
    const sim::Values &values = m_session.timeline().values();
    TriedSpot spot;
    spot.k = values.has("k") ? values["k"] : 0.0;
    spot.damp = values.has("damp") ? values["damp"] : 1.0;
    spot.h = m_session.timeline().script().step.h;
    if (!m_tried.empty() && m_tried.back() == spot)
        return;
    m_tried.push_back(spot);
    if (m_tried.size() > mostTried)
        m_tried.erase(m_tried.begin());
    emit mapChanged();
}

bool StabilityWatch::canMap(MapPlane plane) const
{
    const lessons::Step &step = m_session.step();
    return m_session.timeline().state().pointCount() <= sim::maxAnalysedPoints &&
           m_session.timeline().script().method->stepLimit() == sim::StepLimit::stiffness &&
           step.parameter(QStringLiteral("k")) &&
           (plane == MapPlane::step || step.parameter(QStringLiteral("damp"))) && !nothingSwings();
}

bool StabilityWatch::nothingSwings() const
{
    return m_reading && m_reading->stability.bound == sim::Bound::noSprings && m_tried.back().k > 0.0;
}

void StabilityWatch::watchMap(std::optional<MapPlane> plane)
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

sim::MapAxis StabilityWatch::across() const
{
    const double k = std::max(m_tried.back().k, 1e-6);
    const lessons::Parameter &declared = *m_session.step().parameter(QStringLiteral("k"));
    return sim::MapAxis::byRatio("k", std::min(leastStiffness, k / 2.0),
                                 std::min(declared.max, std::max(mostStiffness, 2.0 * k)), columns);
}

sim::MapAxis StabilityWatch::up() const
{
    if (*m_plane == MapPlane::damping)
        return sim::MapAxis::evenly("damp", 0.0, mostDamp, rows);
    const double h = m_tried.back().h;
    return sim::MapAxis::byRatio({}, std::min(leastStep, h), std::max(mostStep, h), rows);
}

void StabilityWatch::stopMap()
{
    m_mapDue.stop();
    if (m_maps)
        m_maps->stop = true;
    m_maps.reset();
}

void StabilityWatch::startMap()
{
    stopMap();
    if (!m_plane || !canMap(*m_plane))
        return;
    m_maps = std::make_shared<Job>();
    m_pool.start([this, job = m_maps, about = subject(), x = across(), y = up()] {
        const auto tell = [&](const sim::GrowthMap &soFar) {
            auto copy = std::make_shared<const sim::GrowthMap>(soFar);
            QMetaObject::invokeMethod(
                this,
                [this, job, copy = std::move(copy)] {
                    if (job->stop)
                        return;
                    m_map = copy;
                    emit mapChanged();
                },
                Qt::QueuedConnection);
            return !job->stop;
        };
        try {
            QElapsedTimer sinceTold;
            sinceTold.start();
            const sim::GrowthMap all = sim::growthMap(about.script, about.interval->values, about.state, x, y,
                                                      [&](const sim::GrowthMap &soFar) {
                                                          if (sinceTold.elapsed() < pauseMilliseconds)
                                                              return !job->stop;
                                                          sinceTold.start();
                                                          return tell(soFar);
                                                      });
            tell(all);
        } catch (const sim::Error &) {
            // No such scene: what is known of the map stays.
        }
        QMetaObject::invokeMethod(
            this,
            [this, job] {
                if (job == m_maps)
                    m_maps.reset();
                emit mapChanged();
            },
            Qt::QueuedConnection);
    });
}

}
