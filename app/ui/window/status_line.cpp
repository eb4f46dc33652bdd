#include "app/ui/window/status_line.h"

#include "app/model/accuracy_study.h"
#include "app/model/sentences.h"
#include "app/model/stability_watch.h"
#include "app/ui/stability/stability_gauge.h"
#include "app/ui/window/status_figures.h"
#include "app/ui/window/status_sentence.h"
#include "sim/run/script/composed_interval.h"

namespace app {

namespace {

constexpr int readMilliseconds = 4000; ///< that a sentence takes to be read
constexpr int between = 24;            ///< px that the bar itself takes

}

StatusLine::StatusLine(const Session &session, const AccuracyStudy &study, const StabilityWatch &stability,
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
    connect(&stability, &StabilityWatch::changed, this, &StatusLine::share);
    connect(&m_saidLong, &QTimer::timeout, this, &StatusLine::followRun);
    connect(&m_session, &Session::moved, this, &StatusLine::followRun);
    connect(&m_session, &Session::playingChanged, this, &StatusLine::followRun);
    connect(&m_session, &Session::glanceChanged, this, &StatusLine::refresh);
    connect(&m_session, &Session::runChanged, this, [this] {
        if (!m_session.isPlaying())
            m_said.clear(); // it was about what was done before
    });
    connect(&m_session, &Session::said, this, &StatusLine::say);
    connect(&m_session, &Session::stepOpened, this, [this] { m_said.clear(); });
    refresh();
}

void StatusLine::resizeEvent(QResizeEvent *event)
{
    QStatusBar::resizeEvent(event);
    share();
}

void StatusLine::say(const QString &sentence)
{
    m_said = sentence;
    m_saidAt = m_session.timeline().cursor();
    m_saidLong.start();
    refresh();
}

void StatusLine::followRun()
{
    const bool isElsewhere = m_session.timeline().cursor() != m_saidAt;
    if (m_session.isPlaying() ? !m_saidLong.isActive() : isElsewhere)
        m_said.clear();
    refresh();
}

void StatusLine::refresh()
{
    const bool isSaid = !m_said.isEmpty() && !m_session.isGlancing();
    const QString text = isSaid ? m_said.toHtmlEscaped() : standing();
    if (text != m_text->text())
        m_text->setText(text);
    share();
}

QString StatusLine::standing() const
{
    const sim::Track &track = m_session.timeline().track();
    const sim::Cursor at = track.cursor();
    if (m_session.isGlancing()) {
        const sim::Cursor seen = m_session.shown().cursor();
        return seen.phase > 0
                   ? tr("A look inside frame %1. The run stays where it is.").arg(at.frame)
                   : tr("A look at frame %1. The run stays at frame %2.").arg(seen.frame).arg(at.frame);
    }
    if (m_session.stoppedBy() && !m_session.isPlaying())
        return m_session.stoppedBy()->sentence.toHtmlEscaped();
    if (m_session.isResting())
        return tr("Everything rests. Touch something, or press <b>Space</b> to stop.");
    if (m_session.isPlaying())
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
