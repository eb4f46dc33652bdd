#pragma once

#include "app/model/run/idle_task.h"
#include "app/model/series/frame_series.h"
#include "app/model/session/open_run.h"

#include <QObject>

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
class MeasureSeries : public QObject, public FrameSeries<Sample>
{
    Q_OBJECT

public:
    /// The largest number of stored output steps. Longer runs keep the last ones.
    static constexpr std::size_t mostSteps = 36'000;
    /// Scenes with more points than this are measured only at the cursor.
    static constexpr int manyPoints = 4000;

    explicit MeasureSeries(const OpenRun &run, QObject *parent = nullptr);

signals:
    /// Samples were added or dropped.
    void changed();

private:
    void restart();
    void follow(const Change &change);
    /// Drops the samples from `frame` on, because the run has changed there.
    void dropFrom(std::int64_t frame);
    /// Measures the next output step. Returns false if there is none.
    bool measureNext();

    const OpenRun &m_run;
    IdleTask m_idleTask;
    sim::State m_before; ///< at the end of the last sample's output step
};

}
