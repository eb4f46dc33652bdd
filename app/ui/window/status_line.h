#pragma once

#include "app/model/session.h"

#include <QStatusBar>
#include <QTimer>

namespace app {

class AccuracyStudy;
class StabilityGauge;
class StabilityWatch;
class StatusFigures;
class StatusSentence;

/// The line at the bottom of the window: how the run stands and what can be done, or what was just said; then figures,
/// then the gauge.
class StatusLine : public QStatusBar
{
    Q_OBJECT

public:
    /// Takes `gauge`. All others must outlive it.
    StatusLine(const Session &session, const AccuracyStudy &study, const StabilityWatch &stability,
               StabilityGauge *gauge, QWidget *parent = nullptr);

protected:
    void resizeEvent(QResizeEvent *event) override;

private:
    void say(const QString &sentence);
    /// A sentence stays until the learner goes on, and while the run plays until there was time to read it.
    void followRun();
    void refresh();
    /// How the run stands, and what can be done; rich text.
    QString standing() const;
    /// The sentence has the room that it needs; the figures have what is left.
    void share();

    const Session &m_session;
    StabilityGauge *m_gauge;
    StatusFigures *m_figures;
    StatusSentence *m_text;
    QString m_said;       ///< a sentence that is still to be read; empty: how the run stands
    sim::Cursor m_saidAt; ///< where the run stood then
    QTimer m_saidLong;    ///< until it was there long enough to be read while the run plays
};

}
