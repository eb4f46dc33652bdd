#pragma once

#include "app/model/map_plane.h"
#include "app/model/session.h"
#include "app/model/stability_look.h"
#include "app/model/stability_reading.h"
#include "sim/analysis/stability/growth_map.h"

#include <QElapsedTimer>
#include <QObject>
#include <QThreadPool>
#include <QTimer>

#include <atomic>

namespace app {

/// What a learner has tried: a place on either map.
struct TriedSpot
{
    double k = 0.0;    ///< 1/frame^2
    double damp = 1.0; ///< kept a frame
    double h = 1.0;    ///< frames
    friend bool operator==(const TriedSpot &, const TriedSpot &) = default;
};

/// Keeps watch over a session's step, on a thread of its own: reads it anew when anything changes, at most ten times
/// a second and with at most a fifth of a processor. Where nothing changes, nothing is computed.
class StabilityWatch : public QObject
{
    Q_OBJECT

public:
    explicit StabilityWatch(Session &session, QObject *parent = nullptr);
    /// Stops what is under way and waits for it.
    ~StabilityWatch() override;

    const Session &session() const { return m_session; }
    /// The last reading; null before the first.
    const StabilityReading *reading() const { return m_reading.get(); }
    /// The same at the moment that somebody looks at.
    const StabilityLook &look() const { return m_look; }
    /// Whether what is shown is about the session as it is now.
    bool isCurrent() const { return !m_due.isActive() && !m_reads; }
    /// Whether a map is under way or due.
    bool isMapping() const { return m_mapDue.isActive() || m_maps; }

    /// Whether somebody reads remedies.
    void setDetailed(bool detailed);
    void adopt(const sim::Remedy &remedy);

    /// The nearest to `spot` that can be set: numbers as short as fields show them, within their ranges, and a step that
    /// fits.
    TriedSpot settable(TriedSpot spot) const;
    /// Goes there, as the fields would: the run as it was before is the ghost.
    void adopt(const TriedSpot &spot);

    /// Whether the open step can have a map: its scene has the parameter "k", and for `plane` damping "damp"; the
    /// method has a limit; and something swings, or would if k were not 0.
    bool canMap(MapPlane plane) const;
    /// Whether nothing here has a stiffness, whatever its step's parameters are.
    bool nothingSwings() const;
    /// Asks for a map, which then follows the session whenever it rests; none: computes no more.
    void watchMap(std::optional<MapPlane> plane);
    std::optional<MapPlane> mapPlane() const { return m_plane; }
    /// The rows known so far; null where nothing is known.
    const sim::GrowthMap *map() const { return m_map.get(); }
    /// What the learner has tried in this step, the oldest first; the last is where the session is.
    const std::vector<TriedSpot> &tried() const { return m_tried; }

    static constexpr int pauseMilliseconds = 100; ///< between two readings
    static constexpr int restMilliseconds = 300;  ///< before a map is computed
    static constexpr int columns = 49;            ///< of a map
    static constexpr int rows = 33;

signals:
    void changed();
    void mapChanged();

private:
    struct Job; ///< one reading or map under way
    struct Subject;
    struct Offers;

    static StabilityReading readingOf(const Subject &about, const std::optional<Offers> &offers,
                                      const std::shared_ptr<Job> &job);

    Subject subject() const;
    void follow();
    void followRun();
    void forget();
    void read();
    void take(const std::shared_ptr<Job> &job, std::shared_ptr<const StabilityReading> reading, int took);
    void startMap();
    void stopMap();
    void noteSpot();
    sim::MapAxis across() const;
    sim::MapAxis up() const;

    Session &m_session;
    StabilityLook m_look;
    QThreadPool m_pool;
    QTimer m_due;    ///< runs when a reading will begin
    QTimer m_mapDue; ///< the same for a map
    std::shared_ptr<Job> m_reads;
    std::shared_ptr<Job> m_maps;
    bool m_again = false; ///< the session has changed since the reading began
    bool m_detailed = false;
    int m_pause = 0; ///< ms, to keep after the last reading
    QElapsedTimer m_sinceRead;
    std::shared_ptr<const StabilityReading> m_reading;
    std::shared_ptr<const sim::GrowthMap> m_map;
    std::optional<MapPlane> m_plane;
    std::vector<TriedSpot> m_tried;
    bool m_adopting = false; ///< some of a spot is set, not all
};

}
