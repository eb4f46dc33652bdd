#include "app/ui/time/timeline_painter.h"

#include <QFontMetricsF>
#include <QPainterPath>

#include <algorithm>
#include <cmath>

namespace app {

namespace {

using Places = TimelinePlaces;

constexpr double nameGap = 8.0;
constexpr double bend = 16.0; ///< px over which the dots descend from the track

/// The position of the old run's dots and its name. Near the right end, the name replaces the last dots to
/// stay visible. If no dots would be left, the name is left of the fork. A name that fits on no side is shortened.
struct ComparisonRunPlace
{
    double from = 0.0;
    double to = 0.0;
    double name = 0.0;
    double nameWidth = 0.0;
    QString text; ///< the name as it is shown
};

ComparisonRunPlace placeOf(const TimelineAxis &axis, const ComparisonRun &comparison, const Theme &theme)
{
    ComparisonRunPlace place;
    place.from = axis.xOf(comparison.fork);
    place.to = std::max(axis.xOf(comparison.end), place.from + bend);
    const QFontMetricsF metrics(theme.ui(11.5));
    const double rightRoom = axis.right() - place.from - bend - nameGap,
                 leftRoom = place.from - nameGap - axis.left();
    place.text = metrics.elidedText(comparison.name, Qt::ElideRight, std::max(rightRoom, leftRoom));
    place.nameWidth = metrics.horizontalAdvance(place.text);
    if (place.nameWidth <= rightRoom) {
        place.name = std::min(place.to + nameGap, axis.right() - place.nameWidth);
        place.to = place.name - nameGap;
    } else {
        place.name = place.from - nameGap - place.nameWidth;
    }
    return place;
}

void paintTicks(QPainter &painter, const TimelineAxis &axis, const Theme &theme)
{
    const QFont font = theme.ui(11);
    const QFontMetricsF metrics(font);
    painter.setFont(font);
    const double widest = metrics.horizontalAdvance(QString::number(axis.frames()));
    for (const std::int64_t frame : axis.ticks(widest)) {
        const double x = axis.xOf(frame);
        const QString label = QString::number(frame);
        const double width = metrics.horizontalAdvance(label);
        const double start = std::clamp(x - width / 2, axis.left(), axis.right() - width);
        painter.setPen(theme.tokens().ink3);
        painter.drawText(QPointF(start, Places::labels), label);
        const double line = std::min(std::floor(x), axis.right() - 1) + 0.5;
        painter.setPen(theme.tokens().line2);
        painter.drawLine(QPointF(line, Places::labels + 3), QPointF(line, Places::labels + 7));
    }
}

void paintBar(QPainter &painter, double from, double to, const QColor &color)
{
    constexpr double thickness = 6.0;
    if (to <= from)
        return;
    painter.setPen(Qt::NoPen);
    painter.setBrush(color);
    const QRectF bar(from, Places::track - thickness / 2, to - from, thickness);
    painter.drawRoundedRect(bar, 3, 3);
}

void paintTrack(QPainter &painter, const TimelineAxis &axis, const RunView &view, const Theme &theme)
{
    const Tokens &t = theme.tokens();
    paintBar(painter, axis.left(), axis.right(), t.track);
    paintBar(painter, axis.left(), axis.xOf(view.computed), t.computed);
    paintBar(painter, axis.left(), axis.xOf(view.at), t.ink2);
    for (const Stretch &stretch : view.input) {
        // A minimum width keeps a very short interval visible.
        const double from = std::min(axis.xOf(stretch.from), axis.right() - 3);
        paintBar(painter, from, std::max(axis.xOf(stretch.to), from + 3), theme.kindColor(stretch.kind));
    }
}

void paintRing(QPainter &painter, double x, const QColor &ink, const Tokens &t)
{
    painter.setPen(QPen(ink, 1.5));
    painter.setBrush(t.panel);
    painter.drawEllipse(QPointF(x, Places::track), 4, 4);
}

/// Paints round dots from the track at `from`, downwards and on to `to`.
void paintDots(QPainter &painter, double from, double to, const Tokens &t)
{
    const double drop = Places::comparisonRun - Places::track;
    QPainterPath path({from, Places::track});
    path.cubicTo(QPointF(from + 8, Places::track), QPointF(from + 6, Places::track + drop),
                 QPointF(from + bend, Places::comparisonRun));
    path.lineTo(to, Places::comparisonRun);
    QPen dots(t.ghost, 3.0, Qt::CustomDashLine, Qt::RoundCap);
    dots.setDashPattern({1.0 / 3.0, 2.0});
    painter.setPen(dots);
    painter.setBrush(Qt::NoBrush);
    painter.drawPath(path);
}

void paintFork(QPainter &painter, const TimelineAxis &axis, const Fork &fork, const Tokens &t)
{
    const double x = axis.xOf(fork.at);
    paintDots(painter, x, x + bend, t);
    paintRing(painter, x, t.ghost, t);
}

void paintComparisonRun(QPainter &painter, const TimelineAxis &axis, const ComparisonRun &comparison,
                        const Theme &theme)
{
    const Tokens &t = theme.tokens();
    const ComparisonRunPlace place = placeOf(axis, comparison, theme);
    paintDots(painter, place.from, place.to, t);
    paintRing(painter, place.from, t.ink, t);
    // Hides the playhead's line behind the name.
    painter.fillRect(QRectF(place.name - 1, Places::comparisonRun - 6, place.nameWidth + 2, 13), t.panel);
    painter.setFont(theme.ui(11.5));
    painter.setPen(t.ink3);
    painter.drawText(QPointF(place.name, Places::comparisonRun + 4), place.text);
}

void paintFan(QPainter &painter, const TimelineAxis &axis, double x, bool playing, const Tokens &t)
{
    QColor pale = t.now;
    pale.setAlphaF(playing ? 0.10F : 0.20F);
    painter.setPen(QPen(t.now, 2.0, Qt::SolidLine, Qt::FlatCap));
    painter.drawLine(QPointF(x, Places::track + 5), QPointF(x, Places::fan));
    painter.setPen(Qt::NoPen);
    painter.setBrush(pale);
    const QPointF fan[] = {{x - 1, Places::fan},
                           {axis.left(), Places::strip},
                           {axis.right(), Places::strip},
                           {x + 1, Places::fan}};
    painter.drawConvexPolygon(fan, 4);
}

void paintHead(QPainter &painter, double x, const Tokens &t)
{
    const double top = Places::track - 10;
    painter.setPen(QPen(t.panel, 1.5, Qt::SolidLine, Qt::FlatCap, Qt::MiterJoin));
    painter.setBrush(t.now);
    const QPointF head[] = {{x - 5, top}, {x + 5, top}, {x + 5, top + 9}, {x, top + 15}, {x - 5, top + 9}};
    painter.drawConvexPolygon(head, 5);
}

}

void paintTimeline(QPainter &painter, const TimelineAxis &axis, const RunView &view, const Theme &theme,
                   Below below)
{
    painter.setRenderHint(QPainter::Antialiasing);
    paintTicks(painter, axis, theme);
    paintTrack(painter, axis, view, theme);
    for (const Fork &fork : view.forks)
        paintFork(painter, axis, fork, theme.tokens());
    const double x = axis.xOf(view.at);
    if (below == Below::fan)
        paintFan(painter, axis, x, view.playing, theme.tokens());
    if (view.comparison)
        paintComparisonRun(painter, axis, *view.comparison, theme);
    paintHead(painter, x, theme.tokens());
}

void paintPointed(QPainter &painter, const TimelineAxis &axis, std::int64_t frame, const Theme &theme)
{
    const double x = std::min(std::floor(axis.xOf(frame)), axis.right() - 1) + 0.5;
    painter.setPen(QPen(theme.tokens().ink3, 1.0));
    painter.drawLine(QPointF(x, Places::track - 9.0), QPointF(x, Places::track + 9.0));
}

QRectF comparisonRunArea(const TimelineAxis &axis, const ComparisonRun &comparison, const Theme &theme)
{
    const ComparisonRunPlace place = placeOf(axis, comparison, theme);
    const double left = std::min(place.from, place.name) - 4;
    const double right = std::max(place.to, place.name + place.nameWidth) + 4;
    return {left, Places::comparisonRun - 8, right - left, 16};
}

QRectF forkArea(const TimelineAxis &axis, const Fork &fork)
{
    const double top = Places::track + 6;
    return {axis.xOf(fork.at) - 6, top, bend + 12, Places::fan - top};
}

QRegion changedByMove(const TimelineAxis &axis, const RunView &was, const RunView &is, const Theme &theme)
{
    constexpr int reach = 8; // half a playhead, and a margin for round ends and antialiasing
    QRegion region(0, Places::fan, static_cast<int>(std::ceil(axis.right() + reach)),
                   Places::strip - Places::fan);
    const auto add = [&](std::int64_t from, std::int64_t to, int top, int bottom) {
        const int left = static_cast<int>(std::floor(axis.xOf(std::min(from, to)))) - reach;
        const int right = static_cast<int>(std::ceil(axis.xOf(std::max(from, to)))) + reach;
        region += QRect(left, top, right - left, bottom - top);
    };
    const int track = static_cast<int>(Places::track);
    add(was.at, was.at, track - 12, Places::fan);
    add(is.at, is.at, track - 12, Places::fan);
    add(was.at, is.at, track - 4, track + 4);
    add(was.computed, is.computed, track - 4, track + 4);
    // The old run grows with the present run, which moves its name.
    if (was.comparison && is.comparison && was.comparison->end != is.comparison->end) {
        for (const RunView *view : {&was, &is})
            region += comparisonRunArea(axis, *view->comparison, theme).toAlignedRect();
    }
    return region;
}

}
