#include "app/ui/code/margin_marks.h"

#include "app/ui/code/scintilla_style.h"
#include "app/ui/theme/theme.h"

#include <QPainter>
#include <QPainterPath>

namespace app {

void paintBreakpoint(QPainter &painter, QPointF centre, bool isOn, bool hasCondition, const Theme &theme)
{
    const Tokens &t = theme.tokens();
    painter.setPen(QPen(t.past, 1.5));
    painter.setBrush(isOn ? QBrush(t.past) : QBrush(Qt::NoBrush));
    painter.drawEllipse(centre, 4.0, 4.0);
    if (!hasCondition)
        return;
    painter.setPen(QPen(isOn ? t.panel : t.past, 1.2));
    for (const double dy : {-1.3, 1.3})
        painter.drawLine(centre + QPointF(-2.0, dy), centre + QPointF(2.0, dy));
}

void paintMarginArrow(QPainter &painter, int top, const QColor &color)
{
    QPainterPath arrow;
    const QPolygonF corners{{0, 2}, {5, 2}, {10, 6}, {5, 10}, {0, 10}};
    arrow.addPolygon(corners.translated(CodeMargins::symbol + 1.5, top + 4));
    painter.fillPath(arrow, color);
}

void paintLineFrame(QPainter &painter, const QRect &row, const Theme &theme)
{
    const QColor frame = theme.tokens().washLine;
    if (frame.alpha() == 0)
        return;
    painter.setPen(QPen(frame, 2));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(row.adjusted(CodeMargins::text - 3, 1, -1, -1));
}

}
