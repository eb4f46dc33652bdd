#pragma once

#include "app/model/session.h"

#include <QObject>
#include <QTimer>

#include <string>
#include <vector>

namespace app {

/// How far a body is in one run from where it is in the other, at one frame.
struct Difference
{
    std::int64_t frame = 0;
    double distance = 0.0; ///< px
    std::string body;
};

/// How far the run and the branch beside it are apart, from the last frame that they share to the last one that both have.
/// Looked at in slices of a few milliseconds while somebody watches, and not at all else. Of long runs fewer and fewer
/// frames are looked at.
class DifferenceCourse : public QObject
{
    Q_OBJECT

public:
    /// With so many samples, every second one goes, and every second frame is left out from there on.
    static constexpr std::size_t mostSamples = 4096;
    /// Scenes with more points than this are not compared.
    static constexpr int mostPoints = 4000;

    explicit DifferenceCourse(Session &session, QObject *parent = nullptr);

    void setWatched(bool watched);
    /// Of which body: the one that is farthest off at each frame, or the one that is selected.
    enum class Of { farthest, selected };
    void setOf(Of of);
    Of of() const { return m_of; }
    const Session &session() const { return m_session; }

    /// Whether there is a branch beside the run to compare with.
    bool isComparing() const { return m_session.timeline().comparison() != nullptr; }
    /// Whether one of the two has too many points.
    bool isTooLarge() const { return m_isTooLarge; }
    /// By frame. Where a body is not in both runs there is no sample.
    const std::vector<Difference> &samples() const { return m_samples; }
    /// The largest of all that were looked at; null if none was.
    const Difference *largest() const { return m_samples.empty() ? nullptr : &m_largest; }
    /// The last frame that both share.
    std::int64_t shared() const { return m_shared; }
    /// Frames between two that are looked at.
    std::int64_t spacing() const { return m_spacing; }
    /// The next frame to look at, and the last one there is.
    std::int64_t next() const { return m_next; }
    std::int64_t end() const;

signals:
    /// Samples were added or forgotten.
    void changed();

private:
    /// Where a body is in the one and in the other run.
    struct Pair
    {
        int one;
        int other;
    };

    void restart();
    void dropChanged();
    void dropAfter(std::int64_t frame);
    void fill();
    void look();
    void thin();
    void pairUp(const std::shared_ptr<const sim::ComposedInterval> &one,
                const std::shared_ptr<const sim::ComposedInterval> &other);

    Session &m_session;
    QTimer m_later;
    Of m_of = Of::farthest;
    bool m_watched = false;
    bool m_isTooLarge = false;
    std::vector<Difference> m_samples;
    Difference m_largest;
    std::int64_t m_shared = 0;
    std::int64_t m_rows = 1; ///< frames from one moment that both runs have to the next
    std::int64_t m_spacing = 1;
    std::int64_t m_next = 0;
    sim::Script m_run;                           ///< without its input
    std::shared_ptr<const sim::Script> m_branch; ///< the one that is compared
    std::shared_ptr<const sim::ComposedInterval> m_one, m_other;
    std::vector<Pair> m_pairs; ///< of those two: the bodies that both have
};

}
