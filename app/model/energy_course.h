#pragma once

#include "app/model/later_slices.h"
#include "app/model/session.h"
#include "sim/analysis/energy/ledger.h"

#include <QObject>

#include <deque>

namespace app {

/// Where energy and momentum went over the rows that are computed: for each row the balance from a starting frame to
/// it. Counted in slices of a few milliseconds while somebody watches, and not at all else; what a change makes wrong
/// is counted again.
class EnergyCourse : public QObject
{
    Q_OBJECT

public:
    /// Rows that are remembered; of longer runs the last ones.
    static constexpr std::size_t mostRows = 20'000;
    /// Farther ahead than this, in rows, it starts anew near the cursor: to count all of them would take too long.
    static constexpr std::int64_t mostAhead = 20'000;
    /// Scenes with more points than this are not counted.
    static constexpr int mostPoints = 20'000;

    explicit EnergyCourse(Session &session, QObject *parent = nullptr);

    void setWatched(bool watched);
    const Session &session() const { return m_session; }

    /// From start() to `frame`; null where that is not counted.
    const sim::Balance *at(std::int64_t frame) const;
    /// The frame from which it is counted.
    std::int64_t start() const { return m_start; }
    std::int64_t rowFrames() const { return m_framesPerOutput; }
    /// The frames that have balances: from first() to last(), both included; last() < first(): none.
    std::int64_t first() const { return m_first; }
    std::int64_t last() const
    {
        return m_first + (static_cast<std::int64_t>(m_balances.size()) - 1) * m_framesPerOutput;
    }
    /// Why the scene at the cursor has no energy to count, if it has none.
    std::optional<sim::NoEnergy> whyNot() const { return m_whyNot; }

signals:
    /// Balances were added or forgotten, or there is another reason why there are none.
    void changed();

private:
    static std::optional<sim::NoEnergy> whyNone(const sim::Scene &scene);
    void restartAt(std::int64_t frame);
    void restart() { restartAt(0); }
    void dropChanged();
    void follow();
    void fill() { m_later.run(); }
    void fillFor(double milliseconds);
    void countNext();

    Session &m_session;
    sim::Ledger m_ledger;
    LaterSlices m_later;
    std::deque<sim::Balance> m_balances; ///< by row, from m_first on
    std::int64_t m_start = 0;
    std::int64_t m_first = 0;
    int m_framesPerOutput = 1;
    std::optional<sim::NoEnergy> m_whyNot;
    sim::Script m_script;            ///< of the run that is counted, without its input
    std::vector<sim::Event> m_input; ///< of that run
    bool m_watched = false;
    bool m_stale = true; ///< whether the run has changed since it was last watched
};

}
