#pragma once

#include "app/model/cost_watch.h"
#include "app/model/effect_lines.h"

namespace app {

/// The effects of the session's scene with what each costs, and those that other lessons know. Measures while it is
/// watched.
class EffectLedger : public QObject
{
    Q_OBJECT

public:
    explicit EffectLedger(Session &session, CostFunction function = measureCost, QObject *parent = nullptr);
    ~EffectLedger() override;

    void setWatched(bool watched);
    std::vector<EffectLine> lines() const;
    /// "0.0460\u2009µs a frame, ±0.0020, measured now"; what is under way where nothing is known yet.
    QString caption() const;
    const CostWatch &costs() const { return m_costs; }
    CostWatch &costs() { return m_costs; }
    void switchEffect(const QString &id, bool on);
    /// Whether all lessons were asked what they know.
    bool knowsAll() const { return m_knowsAll; }

signals:
    void changed();

private:
    void askLessons();

    const std::vector<sim::EffectPtr> &listed() const;

    Session &m_session;
    CostWatch m_costs;
    /// All effects of the segment at the cursor: a large scene takes time to set up.
    mutable std::vector<sim::EffectPtr> m_listed;
    mutable std::weak_ptr<const sim::ComposedInterval> m_listedIn;
    std::vector<KnownEffect> m_known;
    bool m_isAsked = false;
    bool m_knowsAll = false;
    std::atomic<bool> m_leave = false; ///< nobody waits for the lessons' answer any more
    QThreadPool m_asking;
};

}
