#pragma once

#include "app/model/run/idle_task.h"
#include "app/model/session/comparison_runs.h"
#include "app/model/session/open_run.h"

#include <QObject>

#include <string>
#include <vector>

namespace app {

/// The distance between the positions of a body in two runs, at one frame.
struct Difference
{
    std::int64_t frame = 0;
    double distance = 0.0; ///< px
    std::string body;
};

/// Compares the run with its comparison run, from their last shared frame to the last frame that both have. It works in
/// slices of a few milliseconds, and only while it is watched. In long runs it samples frames at growing intervals.
class DifferenceSeries : public QObject
{
    Q_OBJECT

public:
    /// When this number is reached, every second sample is dropped and the spacing doubles.
    static constexpr std::size_t mostSamples = 4096;
    /// Scenes with more points than this are not compared.
    static constexpr int mostPoints = 4000;

    explicit DifferenceSeries(const OpenRun &run, const ComparisonRuns &comparisons,
                              QObject *parent = nullptr);

    void setActive(bool isActive);
    /// The body to compare: the one that is farthest off at each frame, or the selected one.
    enum class Of { farthest, selected };
    void setOf(Of of);
    Of of() const { return m_of; }
    const ComparisonRuns &comparisons() const { return m_comparisons; }

    /// Returns whether there is a comparison run.
    bool isComparing() const { return m_run.timeline().comparison() != nullptr; }
    /// Returns whether one of the two runs has too many points.
    bool isTooLarge() const { return m_isTooLarge; }
    /// Returns the samples by frame. A frame without a body in both runs has no sample.
    const std::vector<Difference> &samples() const { return m_samples; }
    /// Returns the largest difference of all sampled frames; null if there are none.
    const Difference *largest() const { return m_samples.empty() ? nullptr : &m_largest; }
    /// Returns the last frame that both runs share.
    std::int64_t shared() const { return m_shared; }
    /// Returns the number of frames between two samples.
    std::int64_t spacing() const { return m_spacing; }
    /// Return the next frame to sample, and the last available frame.
    std::int64_t next() const { return m_next; }
    std::int64_t end() const;

signals:
    /// Samples were added or dropped.
    void changed();

private:
    /// The indices of a body in the two runs.
    struct Pair
    {
        int one;
        int other;
    };

    void restart();
    void follow(const Change &change);
    /// Drops the samples from `frame` on, because the run has changed there.
    void dropFrom(std::int64_t frame);
    void dropAfter(std::int64_t frame);
    /// Compares the runs at the next frame. Returns false if there is none.
    bool addSample();
    void thin();
    void pairUp(const std::shared_ptr<const sim::ComposedInterval> &one,
                const std::shared_ptr<const sim::ComposedInterval> &other);

    const OpenRun &m_run;
    const ComparisonRuns &m_comparisons;
    IdleTask m_idleTask;
    Of m_of = Of::farthest;
    bool m_isActive = false;
    bool m_isTooLarge = false;
    std::vector<Difference> m_samples;
    Difference m_largest;
    std::int64_t m_shared = 0;
    std::int64_t m_leastSpacing = 1; ///< frames between two moments that both runs have
    std::int64_t m_spacing = 1;
    std::int64_t m_next = 0;
    std::shared_ptr<const sim::Script> m_branch; ///< the comparison run
    std::shared_ptr<const sim::ComposedInterval> m_one, m_other;
    std::vector<Pair> m_pairs; ///< the bodies that m_one and m_other share
};

}
