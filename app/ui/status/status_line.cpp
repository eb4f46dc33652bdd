#include "app/ui/status/status_line.h"

#include "app/model/analysis/accuracy_study.h"
#include "app/model/analysis/stability_monitor.h"
#include "app/model/text/sentences.h"
#include "app/ui/stability/stability_gauge.h"
#include "app/ui/status/status_figures.h"
#include "app/ui/status/status_sentence.h"
#include "sim/run/script/composed_interval.h"

namespace app {

namespace {

constexpr int readMilliseconds = 4000; ///< time that a person needs to read a message
constexpr int between = 24;            ///< px that the bar itself needs

}

StatusLine::StatusLine(const Session &session, const AccuracyStudy &study, const StabilityMonitor &stability,
                       StabilityGauge *gauge, QWidget *parent)
    : QStatusBar(parent), m_session(session), m_gauge(gauge),
      m_figures(new StatusFigures(session, study, this)), m_text(new StatusSentence(this))
{
    addWidget(m_text, 1);
    addPermanentWidget(m_figures);
    addPermanentWidget(m_gauge);
    setSizeGripEnabled(false);
    setFixedHeight(28);
    m_saidLong.setSingleShot(true);
    m_saidLong.setInterval(readMilliseconds);
    connect(&stability, &StabilityMonitor::changed, this, &StatusLine::share);
    connect(&m_saidLong, &QTimer::timeout, this, &StatusLine::followRun);
    connect(&m_session, &Session::changed, this, &StatusLine::follow);
    connect(&m_session, &Session::messageRequested, this, &StatusLine::showMessage);
    refresh();
}

void StatusLine::resizeEvent(QResizeEvent *event)
{
    QStatusBar::resizeEvent(event);
    share();
}

void StatusLine::showMessage(const QString &sentence)
{
    m_message = sentence;
    m_saidAt = m_session.timeline().cursor();
    m_saidLong.start();
    refresh();
}

void StatusLine::follow(const Change &change)
{
    const bool isAnotherRun = change.isAny(ChangeKind::run) && !m_session.playback().isPlaying();
    if (change.isAny(ChangeKind::step) || isAnotherRun)
        m_message.clear(); // the message was about the previous run
    if (change.isAny(ChangeKind::cursor | ChangeKind::playing))
        followRun();
    else if (change.isAny(ChangeKind::preview))
        refresh();
}

void StatusLine::followRun()
{
    const bool isElsewhere = m_session.timeline().cursor() != m_saidAt;
    if (m_session.playback().isPlaying() ? !m_saidLong.isActive() : isElsewhere)
        m_message.clear();
    refresh();
}

void StatusLine::refresh()
{
    const bool isMessage = !m_message.isEmpty() && !m_session.preview().isActive();
    const QString text = isMessage ? m_message.toHtmlEscaped() : currentText();
    if (text != m_text->text())
        m_text->setText(text);
    share();
}

QString StatusLine::currentText() const
{
    const sim::Track &track = m_session.timeline().track();
    const sim::Cursor at = track.cursor();
    if (m_session.preview().isActive()) {
        const sim::Cursor seen = m_session.preview().run().cursor();
        return seen.phase > 0
                   ? tr("Preview inside frame %1. The run does not move.").arg(at.frame)
                   : tr("Preview of frame %1. The run stays at frame %2.").arg(seen.frame).arg(at.frame);
    }
    if (m_session.playback().breakHit() && !m_session.playback().isPlaying())
        return m_session.playback().breakHit()->sentence.toHtmlEscaped();
    if (m_session.playback().isWaiting())
        return tr("Everything is at rest. Touch something, or press <b>Space</b> to stop.");
    if (m_session.playback().isPlaying())
        return tr("Playing. Press <b>Space</b> to stop anywhere.");
    if (at.phase > 0) {
        const QString phase = phrase(track.interval().pipeline.phaseAt(at.phase - 1).title).toHtmlEscaped();
        return tr("Inside frame %1, after %2. <b>Shift+→</b> next phase, <b>→</b> next frame.")
            .arg(at.frame)
            .arg(phase);
    }
    return tr("<b>Space</b> plays, <b>→</b> next frame, <b>Shift+→</b> into the frame. Drag anything.");
}

void StatusLine::share()
{
    const int taken = m_text->sizeHint().width() + m_gauge->sizeHint().width() + between;
    m_figures->setMost(width() - taken);
}

}
