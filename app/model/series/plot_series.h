#pragma once

#include "app/model/run/idle_task.h"
#include "app/model/series/plot_window.h"
#include "app/model/series/run_sampler.h"
#include "app/model/session/comparison_runs.h"
#include "app/model/session/open_run.h"
#include "app/model/session/playback.h"

#include <QObject>

namespace app {

/// The time series of the plotted quantities, for the run and its comparison run. They are read in slices of a few
/// milliseconds, and only while they are watched. A change of the run makes the affected samples be read again. Memory
/// use does not depend on the length of the run.
class PlotSeries : public QObject
{
    Q_OBJECT

public:
    /// The number of buckets stored per quantity: see Samples.
    static constexpr std::int64_t mostBuckets = 4096;
    /// The number of output steps of the longest run that files may have. With this value the whole run is always
    /// shown.
    static constexpr std::int64_t allSteps = PlotWindow::leastSteps << 20;

    explicit PlotSeries(const OpenRun &run, const Playback &playback, const ComparisonRuns &comparisons,
                        QObject *parent = nullptr);

    void setActive(bool isActive);
    /// Sets the quantities to read. A quantity without a body follows the selected one.
    void setQuantities(std::vector<Quantity> quantities);
    /// Sets the largest number of output steps on display; see PlotView.
    void setMostSteps(std::int64_t steps);
    std::int64_t mostSteps() const { return m_mostSteps; }

    const PlotWindow &window() const { return m_window; }
    int framesPerOutput() const { return m_framesPerOutput; }
    const Samples &run() const { return m_runSampler.samples(); }
    /// Returns the comparison run, from its first difference; empty if there is none.
    const Samples &comparison() const { return m_comparisonSampler.samples(); }
    /// Returns the column of a quantity.
    std::size_t columnOf(const Quantity &quantity) const;
    /// Returns the quantity with the name of its body.
    Quantity bound(const Quantity &quantity) const { return boundTo(quantity, m_run.selected()); }
    /// Returns one number per column at the cursor, also inside a frame. NaN marks missing values.
    std::vector<double> now() const;
    /// Returns the same at the start of the cursor's frame, where the curve has a point.
    std::vector<double> begun() const;
    /// A moment inside a frame.
    struct Inside
    {
        double time =
            0.0; ///< frames: the elapsed fraction of the output step equals the fraction of completed phases
        std::vector<double> values;
    };
    /// Returns the moment of `shown`, or else that at the cursor, if it is inside a frame.
    std::optional<Inside> inside(const sim::Timeline &shown) const;
    /// Returns a number that increases with every change of the samples. comparisonRevision() does the same for the
    /// comparison run.
    quint64 revision() const { return m_revision; }
    quint64 comparisonRevision() const { return m_comparisonRevision; }
    /// Returns whether the run has computed steps in the window that have not been read yet.
    bool isReading() const { return m_idleTask.isDue(); }

signals:
    /// Samples were added or dropped, or the quantities have changed.
    void changed();

private:
    std::vector<Quantity> allBound() const;
    std::optional<std::vector<double>> sampledAt(std::int64_t frame) const;
    std::vector<double> read(const sim::Track &track, std::shared_ptr<const sim::ComposedInterval> interval,
                             const sim::State &state, std::int64_t start) const;
    std::vector<double> readAt(const sim::Timeline &run) const;
    void restart();
    void restartComparison();
    void announce();
    void follow(const Change &change);
    void followCursor();
    /// Drops the samples from `frame` on, because the run has changed there.
    void dropFrom(std::int64_t frame);
    bool followsSelection() const;
    /// Returns the script of the branch that is the comparison run; null if there is none.
    std::shared_ptr<const sim::Script> shownBranch() const;
    /// Moves the window and the samples to the cursor. Returns whether anything changed.
    bool moveWindow();
    void move(RunSampler &sampler, std::int64_t first, std::int64_t stride);
    void fill() { m_idleTask.run(); }
    bool readNext();
    std::int64_t endOf(const sim::Track &track) const;
    std::int64_t comparisonStart() const;

    const OpenRun &m_run;
    const Playback &m_playback;
    const ComparisonRuns &m_comparisons;
    IdleTask m_idleTask;
    std::vector<Quantity> m_quantities;
    RunSampler m_runSampler;
    RunSampler m_comparisonSampler;
    PlotWindow m_window;
    int m_framesPerOutput = 1;
    std::int64_t m_mostSteps = 480;
    std::shared_ptr<const sim::Script>
        m_comparisonScript; ///< of the comparison run that is read; null if none is
    quint64 m_revision = 0;
    quint64 m_comparisonRevision = 0;
    bool m_isActive = false;
    bool m_isStale = true; ///< whether the run has changed since it was last watched
};

}
