#pragma once

#include "app/model/session.h"

#include <QObject>
#include <QTimer>

#include <deque>

namespace app {

/// What was measured at the end of one row.
struct Sample
{
    std::vector<double> measures; ///< one a measure of the step; not finite where there is nothing to measure
    std::vector<char> stands;     ///< one a foot of the look's diagram
    std::vector<double>
        slips; ///< px that each foot came sideways in this row while it stood before and after
};

/// The course of a step's measures, and of its feet, over the rows that are computed. Filled in slices of a few
/// milliseconds, so that the window never waits; what a change makes wrong is measured again.
class Course : public QObject
{
    Q_OBJECT

public:
    /// Rows that are remembered; of longer runs the last ones.
    static constexpr std::size_t mostRows = 36'000;
    /// Scenes with more points than this are measured only where the cursor is.
    static constexpr int manyPoints = 4000;

    explicit Course(Session &session, QObject *parent = nullptr);

    /// The sample at the end of the row at `frame`; null where there is none yet.
    const Sample *at(std::int64_t frame) const;
    std::int64_t rowFrames() const { return m_framesPerOutput; }
    /// The frames that have samples: from `first` to `last`, both included; last < first: none.
    std::int64_t first() const { return m_first; }
    std::int64_t last() const
    {
        return m_first + static_cast<std::int64_t>(m_samples.size() - 1) * m_framesPerOutput;
    }
    bool isEmpty() const { return m_samples.empty(); }

signals:
    /// Samples were added or forgotten.
    void changed();

private:
    void restart();
    void dropChanged();
    void fill();
    void measureNext();
    bool wanted() const;

    Session &m_session;
    QTimer m_later;
    std::deque<Sample> m_samples; ///< by row, from m_first on
    std::int64_t m_first = 0;
    int m_framesPerOutput = 1;
    sim::State m_before;             ///< at the end of the last sample's row
    sim::Script m_script;            ///< of the run that the samples are from, without its input
    std::vector<sim::Event> m_input; ///< of that run
};

}
