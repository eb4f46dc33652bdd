// Mouse, wheel and keys of the timeline.
#include "app/model/text/difference_text.h"
#include "app/model/text/phrases.h"
#include "app/ui/theme/focus_ring.h"
#include "app/ui/time/runs_menu.h"
#include "app/ui/time/timeline_strip.h"

#include <QContextMenuEvent>
#include <QHelpEvent>
#include <QMenu>
#include <QToolTip>

#include <algorithm>
#include <cstdlib>

namespace app {

namespace {

bool isOnTrack(const QPointF &place)
{
    return place.y() < TimelinePlaces::fan;
}

}

void TimelineStrip::scrubTo(std::int64_t frame)
{
    m_session.playback().pause();
    m_session.playback().goTo({frame, 0});
}

void TimelineStrip::runTo(int phase)
{
    m_session.playback().pause();
    const Position position = positionOf(m_session.timeline());
    m_session.playback().goTo({position.frame, position.phaseAfter(phase)});
}

void TimelineStrip::step(bool forward, bool byPhase)
{
    if (byPhase && goesByLines())
        forward ? m_session.lines().forward() : m_session.lines().back();
    else if (byPhase)
        forward ? m_session.playback().phaseForward() : m_session.playback().phaseBack();
    else
        forward ? m_session.playback().frameForward() : m_session.playback().frameBack();
}

void TimelineStrip::mousePressEvent(QMouseEvent *event)
{
    m_session.preview().end(); // a press acts at the cursor of the run
    if (event->button() != Qt::LeftButton) {
        QWidget::mousePressEvent(event);
        return;
    }
    const int phase = partAt(event->position());
    if (phase >= 0 && goesByLines()) {
        m_session.lines().goTo(phase);
    } else if (phase >= 0) {
        runTo(phase);
    } else if (const Fork *fork = forkAt(event->position())) {
        press(*fork, event->globalPosition().toPoint());
    } else if (isOnTrack(event->position())) {
        m_scrubbing = true;
        emit pointedAt(std::nullopt);
        scrubTo(m_axis.frameAt(event->position().x()));
    }
}

void TimelineStrip::mouseMoveEvent(QMouseEvent *event)
{
    if (!m_scrubbing) {
        const int phase = partAt(event->position());
        setHovered(phase);
        if (phase >= 0 && goesByLines())
            emit pointedAt(std::nullopt);
        else if (phase >= 0 && !m_session.playback().isPlaying())
            m_session.preview().show({frame(), m_position.phaseAfter(phase)});
        else
            emit pointedAt(trackFrameAt(event->position()));
        return;
    }
    const std::int64_t frame = m_axis.frameAt(event->position().x());
    // Small movements within one frame change nothing.
    if (frame != m_session.playback().goal().value_or(this->frame()))
        scrubTo(frame);
}

void TimelineStrip::mouseReleaseEvent(QMouseEvent *event)
{
    if (event->button() == Qt::LeftButton)
        m_scrubbing = false;
}

void TimelineStrip::leaveEvent(QEvent *)
{
    setHovered(-1);
    emit pointedAt(std::nullopt);
}

std::optional<std::int64_t> TimelineStrip::trackFrameAt(const QPointF &place) const
{
    if (!isOnTrack(place) || m_axis.frameAt(place.x()) > m_view.computed)
        return std::nullopt;
    return m_axis.frameAt(place.x());
}

int TimelineStrip::phaseBefore(sim::Cursor moment) const
{
    const int phase = moment.phase - 1 - m_position.step * m_position.phases;
    return moment.frame == frame() && phase >= 0 && phase < m_position.phases ? phase : -1;
}

void TimelineStrip::showMarked()
{
    const std::optional<sim::Cursor> &moment = m_session.preview().marked();
    setPointed(moment && moment->phase == 0 ? std::optional(moment->frame) : std::nullopt);
    const int phase = moment ? phaseBefore(*moment) : -1;
    if (phase == m_marked)
        return;
    m_marked = phase;
    update(0, TimelinePlaces::strip, width(), height() - TimelinePlaces::strip);
}

void TimelineStrip::setPointed(std::optional<std::int64_t> frame)
{
    if (frame == m_pointed)
        return;
    m_pointed = frame;
    update(0, 0, width(), TimelinePlaces::fan);
}

void TimelineStrip::setHovered(int phase)
{
    if (phase == m_hovered)
        return;
    m_hovered = phase;
    setCursor(phase >= 0 ? Qt::PointingHandCursor : Qt::ArrowCursor);
    update(0, TimelinePlaces::strip, width(), height() - TimelinePlaces::strip);
}

int TimelineStrip::partAt(const QPointF &place) const
{
    return goesByLines() ? m_lines.indexAt(place) : m_phases.phaseAt(place);
}

void TimelineStrip::wheelEvent(QWheelEvent *event)
{
    constexpr int notch = 120;
    const QPoint turned = event->angleDelta();
    // Some systems turn the wheel sideways while Shift is held.
    m_wheel += turned.y() != 0 ? turned.y() : turned.x();
    const bool byPhase = event->modifiers().testFlag(Qt::ShiftModifier);
    for (; std::abs(m_wheel) >= notch; m_wheel -= m_wheel > 0 ? notch : -notch)
        step(m_wheel > 0, byPhase);
    event->accept();
}

void TimelineStrip::keyPressEvent(QKeyEvent *event)
{
    if (!m_byKeyboard)
        update();
    m_byKeyboard = true;
    const bool shift = event->modifiers() == Qt::ShiftModifier;
    if (event->modifiers() != Qt::NoModifier && event->modifiers() != Qt::KeypadModifier && !shift) {
        event->ignore();
        return;
    }
    switch (event->key()) {
    case Qt::Key_Left:
        return step(false, shift);
    case Qt::Key_Right:
        return step(true, shift);
    case Qt::Key_Home:
        return shift ? m_session.playback().repeat() : m_session.editor().restart();
    case Qt::Key_End:
        return scrubTo(m_session.timeline().computed());
    default:
        event->ignore();
    }
}

const Fork *TimelineStrip::forkAt(const QPointF &place) const
{
    const auto found = std::find_if(m_view.forks.rbegin(), m_view.forks.rend(),
                                    [&](const Fork &fork) { return forkArea(m_axis, fork).contains(place); });
    return found == m_view.forks.rend() ? nullptr : &*found;
}

bool TimelineStrip::isOnOldRun(const QPointF &place) const
{
    return m_view.comparison && comparisonRunArea(m_axis, *m_view.comparison, m_theme).contains(place);
}

void TimelineStrip::press(const Fork &fork, const QPoint &onScreen)
{
    if (fork.branches.size() == 1)
        m_session.comparisons().show(fork.branches.front());
    else
        showRuns(fork.branches, onScreen);
}

void TimelineStrip::showRuns(std::vector<int> branches, const QPoint &onScreen)
{
    auto *menu = new RunsMenu(m_session.run(), m_session.editor(), m_session.comparisons(), m_theme, this);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    menu->showOnly(std::move(branches));
    connect(menu, &RunsMenu::compareWanted, this, &TimelineStrip::compareWanted);
    menu->popup(onScreen);
}

void TimelineStrip::contextMenuEvent(QContextMenuEvent *event)
{
    if (m_session.comparisons().branches().isEmpty()) {
        event->ignore();
        return;
    }
    const bool byMouse = event->reason() == QContextMenuEvent::Mouse;
    if (const Fork *fork = byMouse ? forkAt(event->pos()) : nullptr)
        showRuns(fork->branches, event->globalPos());
    else if (byMouse && isOnOldRun(event->pos()))
        showRuns({m_view.comparison->id}, event->globalPos());
    else
        showRuns({}, event->globalPos());
}

void TimelineStrip::focusInEvent(QFocusEvent *event)
{
    m_byKeyboard = isByKeyboard(event->reason());
    update();
}

void TimelineStrip::focusOutEvent(QFocusEvent *)
{
    update();
}

QString TimelineStrip::hintOf(const Fork &fork) const
{
    const Branch *branch = m_session.comparisons().branches().find(fork.branches.front());
    if (fork.branches.size() > 1 || !branch)
        return tr("%1 other runs branch off from this one at frame %2. Click to choose one.")
            .arg(fork.branches.size())
            .arg(fork.at);
    return tr("Another run: %1. Click to show it beside this one, right-click for more.")
        .arg(branchLine(*branch, m_session.timeline().script()));
}

QString TimelineStrip::hintAt(const QPoint &place) const
{
    const int phase = partAt(place);
    if (phase >= 0 && goesByLines())
        return tr("Line %1, %2 of %3: %4\nClick to run to it.")
            .arg(m_lines.lineOf(phase))
            .arg(phase + 1)
            .arg(m_lines.count())
            .arg(m_lines.textOf(phase));
    if (phase >= 0) {
        const QString group = m_phases.groupOf(phase);
        const QString title = m_phases.titleOf(phase);
        return tr("%1: phase %2 of %3. Click to run to it.")
            .arg(group.isEmpty() ? title : listed(group, title))
            .arg(phase + 1)
            .arg(m_phases.count());
    }
    if (!isOnTrack(place))
        return {};
    if (const Fork *fork = forkAt(place))
        return hintOf(*fork);
    if (isOnOldRun(place))
        return tr("Beside this run: %1. Right-click for more.").arg(m_view.comparison->name);
    return frameName(m_axis.frameAt(place.x()));
}

bool TimelineStrip::event(QEvent *event)
{
    if (event->type() != QEvent::ToolTip)
        return QWidget::event(event);
    const QHelpEvent *help = static_cast<QHelpEvent *>(event);
    const QString hint = hintAt(help->pos());
    if (hint.isEmpty())
        QToolTip::hideText();
    else
        QToolTip::showText(help->globalPos(), hint, this);
    return true;
}

}
