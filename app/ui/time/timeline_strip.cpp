#include "app/ui/time/timeline_strip.h"

#include "app/ui/theme/focus_ring.h"
#include "app/ui/time/line_position.h"
#include "app/ui/time/run_view.h"
#include "app/ui/time/timeline_access.h"

#include <QAccessible>
#include <QPaintEvent>

namespace app {

namespace {

using Places = TimelinePlaces;

QRectF stripArea(const TimelineAxis &axis)
{
    return {axis.left(), Places::strip + 0.5, axis.right() - axis.left(), Places::stripHeight};
}

}

TimelineStrip::TimelineStrip(Session &session, const Theme &theme, QWidget *parent)
    : QWidget(parent), m_session(session), m_theme(theme)
{
    installTimelineAccess();
    setLayoutDirection(Qt::LeftToRight); // time runs to the right in every language
    setObjectName("timeline");
    setAccessibleName(tr("Timeline"));
    setAccessibleDescription(
        tr("Left and Right: one frame. With Shift: one phase. Home: restart. With Shift: repeat the run. "
           "End: the last computed frame. Menu: the other runs."));
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setAttribute(Qt::WA_OpaquePaintEvent);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    session.onChange(everyChange, this, &TimelineStrip::follow);
    refresh();
}

QSize TimelineStrip::sizeHint() const
{
    return {600, m_form == Form::whole ? Places::height : Places::fan};
}

QSize TimelineStrip::minimumSizeHint() const
{
    return {280, sizeHint().height()};
}

void TimelineStrip::setForm(Form form)
{
    m_form = form;
    readPhases();
    updateGeometry();
    update();
}

void TimelineStrip::setStepBy(StepBy stepBy)
{
    m_stepBy = stepBy;
    m_hovered = -1;
    refresh();
}

QString TimelineStrip::sentence() const
{
    const QString current = goesByLines() && m_session.timeline().cursor().phase == 0
                                ? sentenceOf(m_session.lines(), frame())
                                : sentenceOf(m_session.timeline());
    return m_session.preview().isActive()
               ? tr("%1. Preview: %2").arg(current, sentenceOf(m_session.preview().run()))
               : current;
}

bool TimelineStrip::coverRun()
{
    bool grown = m_axis.cover(m_view.computed);
    if (m_view.comparison)
        grown = m_axis.cover(m_view.comparison->end) || grown;
    for (const Stretch &stretch : m_view.input)
        grown = m_axis.cover(stretch.to) || grown;
    return grown;
}

void TimelineStrip::refresh()
{
    m_view = runViewOf(m_session.timeline(), m_session.comparisons(), m_session.playback().isPlaying());
    coverRun();
    readPhases();
    update();
    announce();
}

void TimelineStrip::readPhases()
{
    const sim::Timeline &timeline = m_session.timeline();
    m_position = positionOf(timeline);
    m_showsEnd = showsEnd();
    m_interval = phasesShown();
    m_phases.setContent(*m_interval, m_showsEnd ? endOf(timeline) : m_position);
    m_phases.arrange(stripArea(m_axis), m_theme);
    if (goesByLines())
        readLines();
}

void TimelineStrip::readLines()
{
    // During playback the lines stay as they were: they would be computed again for every frame.
    if (m_session.playback().isPlaying() && m_lines.count() > 0)
        return;
    m_lines.setContent(m_session.lines().nextFrame().get(), m_session.code().text(),
                       m_session.lines().index());
    m_lines.arrange(stripArea(m_axis), m_theme);
}

bool TimelineStrip::showsEnd() const
{
    const sim::Cursor at = m_session.timeline().cursor();
    return !m_session.playback().isPlaying() && at.phase == 0 && at.frame > 0;
}

std::shared_ptr<const sim::ComposedInterval> TimelineStrip::phasesShown() const
{
    const sim::Track &track = m_session.timeline().track();
    return showsEnd() ? track.intervalPtr() : track.nextInterval();
}

void TimelineStrip::follow(const Change &change)
{
    if (change.isAny(ChangeKind::step))
        m_axis.reset();
    if (change.isAny(ChangeKind::step | ChangeKind::run | ChangeKind::playing | ChangeKind::code))
        refresh();
    if (change.isAny(ChangeKind::cursor))
        followCursor();
    if (change.isAny(ChangeKind::preview))
        showMarked();
}

void TimelineStrip::followCursor()
{
    const RunView was = m_view;
    const Position before = m_position;
    app::follow(m_view, m_session.timeline());
    const bool grown = coverRun();
    Position now = positionOf(m_session.timeline());
    const bool isPlaying = m_session.playback().isPlaying();
    const bool samePhases = (isPlaying || !goesByLines()) && m_interval == phasesShown() &&
                            m_showsEnd == showsEnd() && !before.isInside() && !now.isInside();
    if (grown || !samePhases) {
        readPhases();
        update();
    } else {
        m_position = now;
        // The phase strip looks the same between any two frames, so only the upper part needs repainting
        // during playback.
        update(changedByMove(m_axis, was, m_view, m_theme));
    }
    announce();
}

void TimelineStrip::announce()
{
    if (!QAccessible::isActive() || m_session.playback().isPlaying())
        return;
    QAccessibleValueChangeEvent event(this, QVariant::fromValue<qlonglong>(frame()));
    QAccessible::updateAccessibility(&event);
}

void TimelineStrip::resizeEvent(QResizeEvent *)
{
    m_axis.setWidth(width());
    m_phases.arrange(stripArea(m_axis), m_theme);
    m_lines.arrange(stripArea(m_axis), m_theme);
}

void TimelineStrip::paintEvent(QPaintEvent *event)
{
    QPainter painter(this);
    painter.fillRect(event->rect(), m_theme.tokens().panel);
    paintTimeline(painter, m_axis, m_view, m_theme, m_form == Form::whole ? Below::fan : Below::nothing);
    if (m_pointed)
        paintPointed(painter, m_axis, *m_pointed, m_theme);
    if (m_form == Form::whole && event->region().intersects(stripArea(m_axis).toAlignedRect())) {
        if (goesByLines())
            m_lines.paint(painter, m_theme, m_view.playing, m_hovered);
        else
            m_phases.paint(painter, m_theme, m_view.playing, m_hovered < 0 ? m_marked : m_hovered);
    }
    if (hasFocus() && m_byKeyboard) {
        constexpr double half = FocusRing::width / 2.0;
        painter.setPen(QPen(m_theme.tokens().ink, FocusRing::width));
        painter.setBrush(Qt::NoBrush);
        painter.drawRoundedRect(QRectF(rect()).adjusted(half, half, -half, -half), 8, 8);
    }
}

}
