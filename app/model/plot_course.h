#pragma once

#include "app/model/plot_window.h"
#include "app/model/run_sampler.h"
#include "app/model/session.h"

#include <QObject>
#include <QTimer>

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
    int rowFrames() const { return m_rowFrames; }
    const Samples &run() const { return m_run.samples(); }
    /// The old run, from where it differs; empty where there is none.
    const Samples &ghost() const { return m_ghost.samples(); }
    /// The column of a quantity that is read.
    std::size_t columnOf(const Quantity &quantity) const;
    /// The quantity with the name of its body.
    Quantity bound(const Quantity &quantity) const { return boundTo(quantity, m_session.selected()); }
    /// One number a column at the cursor, also inside a frame; NaN where there is none.
    std::vector<double> now() const;
    /// Goes up with every change of the samples.
    quint64 revision() const { return m_revision; }
    /// Whether more of the window has been computed than was read.
    bool isReading() const;

signals:
    /// Samples were added or forgotten, or others are read.
    void changed();

private:
    std::vector<Quantity> allBound() const;
    void restart();
    void restartGhost();
    void tell();
    void dropChanged();
    void changeSelection();
    void follow();
    /// Brings window and samples to where the cursor is. Returns whether anything changed.
    bool moveWindow();
    void move(RunSampler &sampler, std::int64_t first, std::int64_t stride);
    void fill();
    bool takeRow();
    std::int64_t endOf(const sim::Track &track) const;
    std::int64_t ghostStart() const;

    Session &m_session;
    QTimer m_later;
    std::vector<Quantity> m_quantities;
    RunSampler m_run;
    RunSampler m_ghost;
    PlotWindow m_window;
    int m_rowFrames = 1;
    std::int64_t m_mostRows = 480;
    sim::Script m_script;                     ///< of the run that is read, without its input
    std::vector<sim::Event> m_input;          ///< of that run
    std::optional<sim::Script> m_ghostScript; ///< of the ghost that is read
    quint64 m_revision = 0;
    bool m_watched = false;
    bool m_isStale = true; ///< whether the run has changed since it was last watched
};

}
