#pragma once

#include "app/model/session/open_run.h"

#include <QObject>
#include <QTimer>

#include <deque>

namespace app {

/// The measurements at the end of one output step.
struct Sample
{
    std::vector<double> measures; ///< one per measure of the step; not finite if there is nothing to measure
    std::vector<char> stands;     ///< one per foot of the view's diagram
    std::vector<double>
        slips; ///< px that each foot moved sideways in this output step, if it stood before and after
};

/// The time series of a step's measures and of its feet, over the computed output steps. It is filled in slices of a
/// few milliseconds, so the window stays responsive. A change of the run makes the affected steps be measured again.
class MeasureSeries : public QObject
{
    Q_OBJECT

public:
    /// The largest number of stored output steps. Longer runs keep the last ones.
    static constexpr std::size_t mostRows = 36'000;
    /// Scenes with more points than this are measured only at the cursor.
    static constexpr int manyPoints = 4000;

    explicit MeasureSeries(const OpenRun &run, QObject *parent = nullptr);

    /// Returns the sample of the output step that ends at `frame`; null if there is none yet.
    const Sample *at(std::int64_t frame) const;
    std::int64_t rowFrames() const { return m_framesPerOutput; }
    /// Return the frames that have samples: from `first` to `last`, both included. There are none if last < first.
    std::int64_t first() const { return m_first; }
    std::int64_t last() const
    {
        return m_first + static_cast<std::int64_t>(m_samples.size() - 1) * m_framesPerOutput;
    }
    bool isEmpty() const { return m_samples.empty(); }

signals:
    /// Samples were added or dropped.
    void changed();

private:
    void restart();
    void follow(const Change &change);
    /// Drops the samples from `frame` on, because the run has changed there.
    void dropFrom(std::int64_t frame);
    void fill();
    void measureNext();
    bool wanted() const;

    const OpenRun &m_run;
    QTimer m_timer;
    std::deque<Sample> m_samples; ///< by output step, from m_first on
    std::int64_t m_first = 0;
    int m_framesPerOutput = 1;
    sim::State m_before; ///< at the end of the last sample's output step
};

}
