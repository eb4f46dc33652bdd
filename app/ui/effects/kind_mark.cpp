#include "app/ui/effects/kind_mark.h"

#include <QPainterPath>

namespace app {

namespace {

/// Returns the sign of a kind, in a square from (0, 0) to (1, 1).
QPainterPath signOf(sim::EffectKind kind)
{
    QPainterPath path;
    const auto line = [&](QPointF from, QPointF to) {
        path.moveTo(from);
        path.lineTo(to);
    };
    switch (kind) {
    case sim::EffectKind::gravity:
        path.addPolygon(QPolygonF{{0.22, 0.4}, {0.5, 0.74}, {0.78, 0.4}});
        break;
    case sim::EffectKind::damping:
        line({0.36, 0.0}, {0.36, 1.0});
        line({0.68, 0.0}, {0.68, 1.0});
        break;
    case sim::EffectKind::contact:
        line({0.0, 0.5}, {0.5, 0.0});
        line({0.15, 0.85}, {0.85, 0.15});
        line({0.5, 1.0}, {1.0, 0.5});
        break;
    case sim::EffectKind::driver:
        line({0.0, 0.5}, {1.0, 0.5});
        break;
    case sim::EffectKind::wind:
        for (const double y : {0.32, 0.68}) {
            line({0.3, y}, {0.34, y});
            line({0.66, y}, {0.7, y});
        }
        break;
    case sim::EffectKind::stick:
        line({0.28, 0.26}, {0.72, 0.26});
        line({0.28, 0.74}, {0.72, 0.74});
        line({0.5, 0.26}, {0.5, 0.74});
        break;
    case sim::EffectKind::rule:
        line({0.5, 0.22}, {0.5, 0.78});
        line({0.22, 0.5}, {0.78, 0.5});
        break;
    case sim::EffectKind::spring:
    case sim::EffectKind::motion:
        break;
    }
    return path;
}

}

void drawKindMark(QPainter &painter, const QRectF &square, sim::EffectKind kind, MarkFill fill,
                  const Theme &theme)
{
    const QColor ink = kind == sim::EffectKind::motion ? theme.tokens().ghost : theme.kindColor(kind);
    const bool isSolid = fill == MarkFill::solid;
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(ink, 1.2));
    painter.setBrush(isSolid ? QBrush(ink) : QBrush(Qt::NoBrush));
    painter.drawRoundedRect(square.adjusted(0.6, 0.6, -0.6, -0.6), 2, 2);
    painter.setClipRect(square.adjusted(1.0, 1.0, -1.0, -1.0));
    painter.translate(square.topLeft());
    painter.scale(square.width(), square.height());
    QPen pen(isSolid ? theme.tokens().panel : ink, isSolid ? 1.4 : 1.1);
    pen.setCosmetic(true);
    painter.setPen(pen);
    painter.setBrush(Qt::NoBrush);
    painter.drawPath(signOf(kind));
    painter.restore();
}

}
