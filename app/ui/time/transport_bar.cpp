#include "app/ui/time/transport_bar.h"

#include "app/model/sentences.h"
#include "app/ui/time/frame_counter.h"
#include "app/ui/time/position.h"
#include "app/ui/time/runs_menu.h"
#include "app/ui/time/speed_button.h"

#include <QAction>
#include <QHBoxLayout>
#include <QShortcut>
#include <QToolButton>

namespace app {

namespace {

/// While playing, numbers change at most ten times a second: faster ones cannot be read. A little less, so that
/// every third frame counts however exactly the timer ticks.
constexpr qint64 leastMilliseconds = 90;

/// A button that gives up some of its width where there is little room.
class TransportButton : public QToolButton
{
public:
    TransportButton(QSize size, int least, QWidget *parent)
        : QToolButton(parent), m_size(size), m_least(least)
    {
        setSizePolicy(QSizePolicy::Maximum, QSizePolicy::Fixed);
    }
    QSize sizeHint() const override { return m_size; }
    QSize minimumSizeHint() const override { return {m_least, m_size.height()}; }

private:
    QSize m_size;
    int m_least;
};

void describe(QToolButton *button, const QString &what, const QString &keys, const QString &whyNot)
{
    button->setEnabled(whyNot.isEmpty());
    button->setAccessibleName(what);
    button->setToolTip(whyNot.isEmpty() ? TransportBar::tr("%1 (%2)").arg(what, keys) : whyNot);
}

}

TransportBar::TransportBar(Session &session, const Theme &theme, QWidget *parent)
    : QWidget(parent), m_session(session), m_theme(theme), m_layout(new QHBoxLayout(this)),
      m_goToFrame(new QAction(tr("Go to frame…"), this)), m_cancel(new QShortcut(Qt::Key_Escape, this))
{
    setObjectName("transport");
    setFixedHeight(52);
    setAutoFillBackground(true);
    build();
    m_goToFrame->setShortcut(Qt::CTRL | Qt::Key_G);
    addAction(m_goToFrame);
    connect(m_goToFrame, &QAction::triggered, this, &TransportBar::editFrame);
    connect(m_cancel, &QShortcut::activated, &session, &Session::stopGoing);
    connect(m_cancel, &QShortcut::activatedAmbiguously, &session, &Session::stopGoing);
    connect(m_frame, &FrameCounter::asked, this, [this](std::int64_t frame) { m_session.runTo({frame, 0}); });
    connect(m_frame, &FrameCounter::refused, &session, &Session::said);
    connect(m_frame, &FrameCounter::resized, this, &TransportBar::fit);
    connect(m_speed, &SpeedButton::chosen, &session, &Session::setSpeed);
    connect(&session, &Session::moved, this, &TransportBar::follow);
    connect(&session, &Session::glanceChanged, this, &TransportBar::showFrame);
    connect(&session, &Session::runChanged, this, &TransportBar::refresh);
    connect(&session, &Session::stepOpened, this, &TransportBar::refresh);
    connect(&session, &Session::playingChanged, this, &TransportBar::refresh);
    connect(&theme, &Theme::changed, this, &TransportBar::dress);
    dress();
}

void TransportBar::build()
{
    m_layout->setContentsMargins(12, 0, 12, 0);
    m_layout->setSpacing(0);
    m_reset = addButton("reset", 32, 28, &TransportBar::restart);
    addSpace(14);
    m_phaseBack = addButton("phaseBack", 32, 28, &TransportBar::phaseBack);
    addSpace(4);
    m_frameBack = addButton("frameBack", 32, 28, &TransportBar::frameBack);
    addSpace(10);
    m_play = addButton("play", 44, 38, &TransportBar::playOrPause);
    m_play->setIconSize({18, 18});
    addSpace(10);
    m_frameForward = addButton("frameForward", 32, 28, &TransportBar::frameForward);
    addSpace(4);
    m_phaseForward = addButton("phaseForward", 32, 28, &TransportBar::phaseForward);
    addSpace(18);
    m_frame = new FrameCounter(m_theme, this);
    m_layout->addWidget(m_frame);
    m_layout->addSpacerItem(new QSpacerItem(8, 0, QSizePolicy::Expanding));
    m_runs = new RunsMenu(m_session, m_theme, this);
    m_runsButton = addButton("runsButton", 32, 28, &TransportBar::chooseRun);
    addSpace(6);
    m_speed = new SpeedButton(m_theme, this);
    m_layout->addWidget(m_speed);
}

QToolButton *TransportBar::addButton(const QString &name, int width, int least,
                                     void (TransportBar::*pressed)())
{
    QToolButton *button = new TransportButton({width, name == "play" ? 36 : 32}, least, this);
    button->setObjectName(name);
    button->setIconSize({16, 16});
    connect(button, &QToolButton::clicked, this, pressed);
    m_layout->addWidget(button);
    return button;
}

void TransportBar::addSpace(int width)
{
    m_layout->addSpacerItem(new QSpacerItem(width, 0, QSizePolicy::Maximum));
}

void TransportBar::dress()
{
    const QColor ink = m_theme.tokens().ink;
    m_reset->setIcon(m_theme.icon("reset"));
    m_phaseBack->setIcon(m_theme.icon("phase-back"));
    m_frameBack->setIcon(m_theme.icon("frame-back", ink));
    m_frameForward->setIcon(m_theme.icon("frame-forward", ink));
    m_phaseForward->setIcon(m_theme.icon("phase-forward"));
    m_runsButton->setIcon(m_theme.icon("runs"));
    refresh();
    update();
}

void TransportBar::refresh()
{
    m_speed->setSpeed(m_session.speed());
    showPlay();
    showFrame();
    showButtons();
    showRuns();
    fit();
}

void TransportBar::showRuns()
{
    const std::size_t count = m_session.branches().all().size();
    const QString what = count == 0   ? tr("Other runs: none yet")
                         : count == 1 ? tr("Other runs: one")
                                      : tr("Other runs: %1").arg(count);
    describe(m_runsButton, what, tr("Ctrl+Shift+R"),
             count == 0
                 ? tr("Go back in time and change something: the run as it was stays, and is found here.")
                 : QString());
}

void TransportBar::chooseRun()
{
    if (m_runsButton->isEnabled())
        m_runs->popupAbove(*m_runsButton);
    else
        emit m_session.said(m_runsButton->toolTip());
}

void TransportBar::follow()
{
    if (!m_session.isPlaying() || !m_sinceFrame.isValid() || m_sinceFrame.elapsed() >= leastMilliseconds)
        showFrame();
    showButtons();
}

void TransportBar::showFrame()
{
    m_sinceFrame.start();
    const Position position = positionOf(m_session.timeline());
    QString detail = progressOf(position);
    QString brief = shortProgressOf(position);
    if (m_session.isGlancing()) {
        showLook(position.frame);
        return;
    }
    if (const std::optional<std::int64_t> target = m_session.goingTo()) {
        detail = tr("going to %1… Esc stops").arg(*target);
        brief = tr("going to %1…").arg(*target);
    }
    const auto dotted = [](const QString &text) { return text.isEmpty() ? text : tr("· %1").arg(text); };
    m_frame->show(position.frame, dotted(detail), dotted(brief));
}

void TransportBar::showLook(std::int64_t stands)
{
    const Position look = positionOf(m_session.shown());
    const QString full = look.isInside() ? tr("· looking: %1").arg(progressOf(look))
                                         : tr("· looking at frame %1").arg(look.frame);
    const QString brief =
        look.isInside() ? tr("· %1").arg(shortProgressOf(look)) : tr("· at %1").arg(look.frame);
    for (const QString &text : {full, brief, QString()}) {
        m_frame->show(stands, text, text);
        m_layout->invalidate();
        if (m_layout->sizeHint().width() <= width())
            return;
    }
}

QString TransportBar::whyNoPast() const
{
    return m_session.timeline().cursor() == sim::Cursor{} ? tr("This is frame 0: nothing comes before it.")
                                                          : QString();
}

QString TransportBar::whyNoFuture() const
{
    const std::optional<sim::Stop> &stop = m_session.timeline().stop();
    return stop && m_session.timeline().cursor().frame >= stop->frame ? sentenceFor(*stop) : QString();
}

void TransportBar::showButtons()
{
    const bool inside = m_session.timeline().cursor().phase > 0;
    const QString noPast = whyNoPast();
    const QString noFuture = whyNoFuture();
    showRestart();
    describe(m_phaseBack, tr("One phase back"), tr("Shift+←"), noPast);
    describe(m_frameBack, inside ? tr("Back to the start of this frame") : tr("One frame back"), tr("←"),
             noPast);
    describe(m_frameForward, inside ? tr("On to the end of this frame") : tr("One frame forward"), tr("→"),
             noFuture);
    describe(m_phaseForward, tr("One phase forward"), tr("Shift+→"), noFuture);
    if (m_session.goingTo())
        describe(m_play, tr("Stop here"), tr("Esc"), {});
    else
        describe(m_play, m_session.isPlaying() ? tr("Pause") : tr("Play"), tr("Space"), noFuture);
    const bool canStop = m_session.goingTo() || m_session.isBringing();
    if (m_cancel->isEnabled() != canStop) {
        m_cancel->setEnabled(canStop);
        showPlay();
    }
}

void TransportBar::showRestart()
{
    const bool repeats = m_session.hasInput();
    describe(m_reset, tr("Restart"), tr("Home"), repeats ? QString() : whyNoPast());
    if (!m_reset->isEnabled())
        return;
    QStringList tip{m_reset->toolTip(), tr("A fresh run from frame 0, with the parameters as they are now.")};
    if (repeats)
        tip << tr("Shift+Home repeats this run instead, with all that was done in it.");
    m_reset->setToolTip(tip.join('\n'));
}

void TransportBar::showPlay()
{
    const bool goes = m_session.isPlaying() || m_session.goingTo();
    m_play->setIcon(m_theme.icon(goes ? "pause" : "play", m_theme.tokens().buttonText));
}

void TransportBar::playOrPause()
{
    m_session.goingTo() ? m_session.pause() : m_session.togglePlaying();
}

void TransportBar::slower()
{
    m_session.setSpeed(SpeedButton::slowerThan(m_session.speed()));
}

void TransportBar::faster()
{
    m_session.setSpeed(SpeedButton::fasterThan(m_session.speed()));
}

void TransportBar::editFrame()
{
    m_frame->edit();
}

void TransportBar::takeIn(QWidget *widget)
{
    m_middle = widget;
    m_layout->insertWidget(m_layout->indexOf(m_frame) + 1, widget, 1000);
    updateGeometry();
    fit();
}

void TransportBar::giveOut(QWidget *widget)
{
    m_middle = nullptr;
    m_layout->removeWidget(widget);
    updateGeometry();
    fit();
}

QSize TransportBar::minimumSizeHint() const
{
    return {400 + (m_middle ? m_middle->minimumSizeHint().width() : 0), height()};
}

void TransportBar::fit()
{
    // In this order: buttons and spaces narrow by themselves, then the rate goes, then the phases' words.
    m_speed->setBrief(false);
    m_frame->setBrief(false);
    const auto fits = [this] { return m_layout->minimumSize().width() <= width(); };
    m_layout->invalidate();
    if (fits())
        return;
    m_speed->setBrief(true);
    m_layout->invalidate();
    if (fits())
        return;
    m_frame->setBrief(true);
    m_layout->invalidate();
}

void TransportBar::resizeEvent(QResizeEvent *)
{
    fit();
}

}
