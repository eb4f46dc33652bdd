#include "app/ui/time/transport_bar.h"

#include "app/ui/actions/command.h"
#include "app/ui/actions/command_button.h"
#include "app/ui/actions/run_commands.h"
#include "app/ui/time/frame_counter.h"
#include "app/ui/time/line_position.h"
#include "app/ui/time/run_position.h"
#include "app/ui/time/runs_menu.h"
#include "app/ui/time/speed_button.h"

#include <QHBoxLayout>
#include <QShortcut>
#include <QToolButton>

namespace app {

namespace {

/// A button that becomes narrower if space is short.
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

}

TransportBar::TransportBar(Session &session, const RunCommands &commands, const Theme &theme, QWidget *parent)
    : QWidget(parent), m_session(session), m_commands(commands), m_theme(theme),
      m_layout(new QHBoxLayout(this)), m_cancel(new QShortcut(RunCommands::cancelKey, this))
{
    setObjectName("transport");
    setLayoutDirection(Qt::LeftToRight); // as the timeline below it
    setFixedHeight(52);
    setAutoFillBackground(true);
    build();
    connect(commands.goToFrame, &QAction::triggered, this, &TransportBar::editFrame);
    connect(commands.slower, &QAction::triggered, this, &TransportBar::slower);
    connect(commands.faster, &QAction::triggered, this, &TransportBar::faster);
    connect(commands.chooseRun, &QAction::triggered, this, [this] { m_runs->popupAbove(*m_runsButton); });
    connect(m_cancel, &QShortcut::activated, &session, &Session::cancelComputing);
    connect(m_cancel, &QShortcut::activatedAmbiguously, &session, &Session::cancelComputing);
    connect(m_frame, &FrameCounter::frameRequested, this, [this](std::int64_t frame) {
        m_session.playback().runTo({frame, 0});
    });
    connect(m_frame, &FrameCounter::refused, &session, &Session::showMessage);
    connect(m_frame, &FrameCounter::resized, this, &TransportBar::fit);
    connect(m_speed, &SpeedButton::chosen, &session.playback(), &Playback::setSpeed);
    session.onChange(everyChange, this, &TransportBar::follow);
    refresh();
}

void TransportBar::build()
{
    m_layout->setContentsMargins(12, 0, 12, 0);
    m_layout->setSpacing(0);
    addButton("reset", *m_commands.restart, {32, 28}, &Tokens::ink2);
    addSpace(14);
    addButton("phaseBack", *m_commands.phaseBack, {32, 28}, &Tokens::ink2);
    addSpace(4);
    addButton("frameBack", *m_commands.frameBack, {32, 28}, &Tokens::ink);
    addSpace(10);
    addButton("play", *m_commands.play, {44, 38}, &Tokens::buttonText)->setIconSize({18, 18});
    addSpace(10);
    addButton("frameForward", *m_commands.frameForward, {32, 28}, &Tokens::ink);
    addSpace(4);
    addButton("phaseForward", *m_commands.phaseForward, {32, 28}, &Tokens::ink2);
    addSpace(18);
    m_frame = new FrameCounter(m_theme, this);
    m_frame->setToolTip(m_commands.goToFrame->toolTip());
    m_layout->addWidget(m_frame);
    m_layout->addSpacerItem(new QSpacerItem(8, 0, QSizePolicy::Expanding));
    m_runs = new RunsMenu(m_session.run(), m_session.editor(), m_session.comparisons(), m_theme, this);
    m_runsButton = addButton("runsButton", *m_commands.chooseRun, {32, 28}, &Tokens::ink2);
    addSpace(6);
    m_speed = new SpeedButton(m_theme, this);
    m_speed->setToolTip(
        tr("Playing speed (%1 and %2). It never changes the step")
            .arg(keyText(m_commands.slower->shortcut()), keyText(m_commands.faster->shortcut())));
    m_layout->addWidget(m_speed);
}

QToolButton *TransportBar::addButton(const QString &name, Command &command, ButtonWidths widths,
                                     QColor Tokens::*ink)
{
    const int height = name == QLatin1String("play") ? 36 : 32;
    QToolButton *button = new TransportButton({widths.usual, height}, widths.least, this);
    button->setObjectName(name);
    button->setIconSize({16, 16});
    showCommand(*button, command, m_theme, ink);
    m_layout->addWidget(button);
    return button;
}

void TransportBar::addSpace(int width)
{
    m_layout->addSpacerItem(new QSpacerItem(width, 0, QSizePolicy::Maximum));
}

void TransportBar::refresh()
{
    m_speed->setSpeed(m_session.playback().speed());
    showFrame();
    followCancel();
    fit();
}

void TransportBar::followCancel()
{
    m_cancel->setEnabled(m_session.playback().goal() || m_session.comparisons().isComputing());
}

void TransportBar::follow(const Change &change)
{
    if (change.isAny(ChangeKind::step | ChangeKind::run | ChangeKind::playing))
        refresh();
    else if (change.isAny(ChangeKind::preview))
        showFrame();
    else if (change.isAny(ChangeKind::cursor))
        followCursor();
}

void TransportBar::followCursor()
{
    if (m_pace.isDue())
        showFrame();
    followCancel();
}

void TransportBar::showFrame()
{
    m_pace.restart();
    const Position position = positionOf(m_session.timeline());
    QString detail = progressOf(position);
    QString brief = shortProgressOf(position);
    if (m_session.lines().index() > 0) {
        detail = progressOf(m_session.lines());
        brief = shortProgressOf(m_session.lines());
    }
    if (m_session.preview().isActive()) {
        showPreview(position.frame);
        return;
    }
    if (const std::optional<std::int64_t> target = m_session.playback().goal()) {
        detail = tr("going to %1… %2 stops").arg(QString::number(*target), keyText(RunCommands::cancelKey));
        brief = tr("going to %1…").arg(*target);
    }
    const auto dotted = [](const QString &text) { return text.isEmpty() ? text : tr("· %1").arg(text); };
    m_frame->show(position.frame, dotted(detail), dotted(brief));
}

void TransportBar::showPreview(std::int64_t current)
{
    const Position shown = positionOf(m_session.preview().run());
    const QString full = shown.isInside() ? tr("· preview: %1").arg(progressOf(shown))
                                          : tr("· preview of frame %1").arg(shown.frame);
    const QString brief =
        shown.isInside() ? tr("· %1").arg(shortProgressOf(shown)) : tr("· at %1").arg(shown.frame);
    for (const QString &text : {full, brief, QString()}) {
        m_frame->show(current, text, text);
        m_layout->invalidate();
        if (m_layout->sizeHint().width() <= width())
            return;
    }
}

void TransportBar::slower()
{
    m_session.playback().setSpeed(SpeedButton::slowerThan(m_session.playback().speed()));
}

void TransportBar::faster()
{
    m_session.playback().setSpeed(SpeedButton::fasterThan(m_session.playback().speed()));
}

void TransportBar::editFrame()
{
    m_frame->edit();
}

void TransportBar::insertMiddle(QWidget *widget)
{
    m_middle = widget;
    m_layout->insertWidget(m_layout->indexOf(m_frame) + 1, widget, 1000);
    updateGeometry();
    fit();
}

void TransportBar::removeMiddle(QWidget *widget)
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
    // Buttons and spaces become narrower by themselves. Then the rate is hidden, then the phases.
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
