#pragma once

#include "app/model/session/open_run.h"
#include "app/model/session/playback.h"
#include "app/model/session/preview.h"

#include <QStatusBar>
#include <QTimer>

namespace app {

class AccuracyStudy;
class RunCommands;
class StabilityGauge;
class StabilityMonitor;
class StatusFigures;
class StatusSentence;

/// The status bar: the state of the run and what the learner can do, or the last message; then numbers, then
/// the stability gauge.
class StatusLine : public QStatusBar
{
    Q_OBJECT

public:
    /// Takes ownership of `gauge`. The other arguments must outlive it.
    StatusLine(const OpenRun &run, const Playback &playback, const Preview &preview,
               const RunCommands &commands, const AccuracyStudy &study, const StabilityMonitor &stability,
               StabilityGauge *gauge, QWidget *parent = nullptr);

protected:
    void resizeEvent(QResizeEvent *event) override;

private:
    void showMessage(const QString &sentence);
    /// Removes a message once the learner goes on. A message that appears while the run plays stays until there was
    /// time to read it.
    void follow(const Change &change);
    void followRun();
    void refresh();
    /// Returns the state of the run and what the learner can do, as rich text.
    QString currentText() const;
    /// Gives the sentence the width that it needs, and the numbers the rest.
    void share();

    const OpenRun &m_run;
    const Playback &m_playback;
    const Preview &m_preview;
    QString m_playKeys;
    QString m_frameKeys;
    QString m_phaseKeys;
    StabilityGauge *m_gauge;
    StatusFigures *m_figures;
    StatusSentence *m_text;
    QString m_message;    ///< the message to read; empty: the state of the run
    sim::Cursor m_saidAt; ///< the cursor of the run at that time
    QTimer m_saidLong;    ///< runs until there was time to read the message during playback
};

}
