#pragma once

#include "app/model/later_slices.h"
#include "app/model/plot_window.h"
#include "app/model/run_sampler.h"
#include "app/model/session.h"

#include <QObject>

namespace app {

/// The course of some quantities over the frames that plots show, of the run and of its ghost. Read in slices of a few
/// milliseconds while somebody watches, and not at all else; what a change makes wrong is read again. It takes the same
/// memory however long the run is.
class PlotCourse : public QObject
{
    Q_OBJECT

public:
    /// Buckets that are kept of each quantity: see Samples.
    static constexpr std::int64_t mostBuckets = 4096;
    /// As many rows as the longest run that files may have: the whole run, always.
    static constexpr std::int64_t allRows = PlotWindow::leastRows << 20;

    explicit PlotCourse(Session &session, QObject *parent = nullptr);

    void setWatched(bool watched);
    /// What is read. A quantity without a body follows the selected one.
    void setQuantities(std::vector<Quantity> quantities);
    /// How many rows are shown at most; see PlotView.
    void setMostRows(std::int64_t rows);
    std::int64_t mostRows() const { return m_mostRows; }

    const Session &session() const { return m_session; }
    const PlotWindow &window() const { return m_window; }
    int rowFrames() const { return m_framesPerOutput; }
    const Samples &run() const { return m_run.samples(); }
    /// The old run, from where it differs; empty where there is none.
    const Samples &ghost() const { return m_ghost.samples(); }
    /// The column of a quantity that is read.
    std::size_t columnOf(const Quantity &quantity) const;
    /// The quantity with the name of its body.
    Quantity bound(const Quantity &quantity) const { return boundTo(quantity, m_session.selected()); }
    /// One number a column at the cursor, also inside a frame; NaN where there is none.
    std::vector<double> now() const;
    /// The same where the frame begins that the cursor is in: there the curve has a point.
    std::vector<double> begun() const;
    /// A moment inside a frame.
    struct Inside
    {
        double time = 0.0; ///< frames: as much of its row is over as of its phases
        std::vector<double> values;
    };
    /// The one that somebody looks at, or else where the cursor is; nothing between two frames.
    std::optional<Inside> inside() const;
    /// Goes up with every change of the samples, and the other one with changes of the ghost's.
    quint64 revision() const { return m_revision; }
    quint64 ghostRevision() const { return m_ghostRevision; }
    /// Whether more of the window has been computed than was read.
    bool isReading() const;

signals:
    /// Samples were added or forgotten, or others are read.
    void changed();

private:
    std::vector<Quantity> allBound() const;
    std::optional<std::vector<double>> kept(std::int64_t frame) const;
    std::vector<double> read(const sim::Track &track, std::shared_ptr<const sim::ComposedInterval> interval,
                             const sim::State &state, std::int64_t start) const;
    std::vector<double> readAt(const sim::Timeline &run) const;
    void restart();
    void restartGhost();
    void tell();
    void dropChanged();
    void changeSelection();
    void follow();
    /// Brings window and samples to where the cursor is. Returns whether anything changed.
    bool moveWindow();
    void move(RunSampler &sampler, std::int64_t first, std::int64_t stride);
    void fill() { m_later.run(); }
    void fillFor(double milliseconds);
    bool takeRow();
    std::int64_t endOf(const sim::Track &track) const;
    std::int64_t ghostStart() const;

    Session &m_session;
    LaterSlices m_later;
    std::vector<Quantity> m_quantities;
    RunSampler m_run;
    RunSampler m_ghost;
    PlotWindow m_window;
    int m_framesPerOutput = 1;
    std::int64_t m_mostRows = 480;
    sim::Script m_script;                     ///< of the run that is read, without its input
    std::vector<sim::Event> m_input;          ///< of that run
    std::optional<sim::Script> m_ghostScript; ///< of the ghost that is read
    quint64 m_revision = 0;
    quint64 m_ghostRevision = 0;
    bool m_watched = false;
    bool m_isStale = true; ///< whether the run has changed since it was last watched
};

}
