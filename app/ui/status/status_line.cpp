#include "app/ui/status/status_line.h"

#include "app/model/analysis/accuracy_study.h"
#include "app/model/analysis/stability_monitor.h"
#include "app/model/text/sentences.h"
#include "app/ui/actions/command.h"
#include "app/ui/actions/run_commands.h"
#include "app/ui/stability/stability_gauge.h"
#include "app/ui/status/status_figures.h"
#include "app/ui/status/status_sentence.h"
#include "sim/run/script/composed_interval.h"

namespace app {

namespace {

constexpr int readMilliseconds = 4000; ///< time that a person needs to read a message
constexpr int ownWidth = 24;           ///< px that the bar itself needs

}

StatusLine::StatusLine(const OpenRun &run, const Playback &playback, const Preview &preview,
                       const RunCommands &commands, const AccuracyStudy &study,
                       const StabilityMonitor &stability, StabilityGauge *gauge, QWidget *parent)
    : QStatusBar(parent), m_run(run), m_playback(playback), m_preview(preview),
      m_playKeys(keyText(commands.play->shortcut())), m_frameKeys(keyText(commands.frameForward->shortcut())),
      m_phaseKeys(keyText(commands.phaseForward->shortcut())), m_gauge(gauge),
      m_figures(new StatusFigures(run, playback, study, this)), m_text(new StatusSentence(this))
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
    m_run.onChange(everyChange, this, &StatusLine::follow);
    connect(&run.changes(), &ChangeNotifier::messageRequested, this, &StatusLine::showMessage);
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
    m_saidAt = m_run.timeline().cursor();
    if (m_playback.isPlaying())
        m_saidLong.start();
    else
        m_saidLong.stop(); // the learner had the time of the pause to read it
    refresh();
}

void StatusLine::follow(const Change &change)
{
    const bool isAnotherRun = change.isAny(ChangeKind::run) && !m_playback.isPlaying();
    if (change.isAny(ChangeKind::step) || isAnotherRun)
        m_message.clear(); // the message was about the previous run
    if (change.isAny(ChangeKind::cursor | ChangeKind::playing))
        followRun();
    else if (change.isAny(ChangeKind::preview))
        refresh();
}

void StatusLine::followRun()
{
    const bool isElsewhere = m_run.timeline().cursor() != m_saidAt;
    if (m_playback.isPlaying() ? !m_saidLong.isActive() : isElsewhere)
        m_message.clear();
    refresh();
}

void StatusLine::refresh()
{
    const bool isMessage = !m_message.isEmpty() && !m_preview.isActive();
    const QString text = isMessage ? m_message.toHtmlEscaped() : currentText();
    if (text != m_text->text())
        m_text->setText(text);
    share();
}

QString StatusLine::currentText() const
{
    const sim::Track &track = m_run.timeline().track();
    const sim::Cursor at = track.cursor();
    if (m_preview.isActive()) {
        const sim::Cursor seen = m_preview.run().cursor();
        return seen.phase > 0
                   ? tr("Preview inside frame %1. The run does not move.").arg(at.frame)
                   : tr("Preview of frame %1. The run stays at frame %2.").arg(seen.frame).arg(at.frame);
    }
    if (m_playback.breakHit() && !m_playback.isPlaying())
        return m_playback.breakHit()->sentence.toHtmlEscaped();
    if (m_playback.isWaiting())
        return tr("Everything is at rest. Touch something, or press <b>%1</b> to stop.").arg(m_playKeys);
    if (m_playback.isPlaying())
        return tr("Playing. Press <b>%1</b> to stop anywhere.").arg(m_playKeys);
    if (at.phase > 0) {
        const QString phase = phrase(track.interval().pipeline.phaseAt(at.phase - 1).title).toHtmlEscaped();
        return tr("Inside frame %1, after %2. <b>%3</b> next phase, <b>%4</b> next frame.")
            .arg(QString::number(at.frame), phase, m_phaseKeys, m_frameKeys);
    }
    return tr("<b>%1</b> plays, <b>%2</b> next frame, <b>%3</b> into the frame. Drag anything.")
        .arg(m_playKeys, m_frameKeys, m_phaseKeys);
}

void StatusLine::share()
{
    const int taken = m_text->sizeHint().width() + m_gauge->sizeHint().width() + ownWidth;
    m_figures->setMost(width() - taken);
}

}
