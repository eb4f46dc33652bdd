#include "app/ui/scene/hud/ruler.h"

#include "app/ui/scene/drawing/canvas.h"

#include <QCoreApplication>
#include <QLineF>
#include <QLocale>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace app {

namespace {

constexpr double grip = 12.0;     ///< screen px around an end in which a press takes the end
constexpr double endRadius = 5.0; ///< screen px
constexpr double tick = 10.0;     ///< scene px between two ticks
constexpr double densest = 4.0;   ///< screen px; if ticks would be closer, some are omitted
constexpr int mostTicks = 400;

QString wordsOf(const Ruler &ruler)
{
    const QLocale locale;
    return QCoreApplication::translate("Ruler", "%1\u2009px, %2°")
        .arg(locale.toString(ruler.length(), 'f', 1), locale.toString(ruler.angle(), 'f', 1));
}

void drawTicks(const Canvas &canvas, const Ruler &ruler)
{
    const double spacing = tick * canvas.camera.zoom;
    const int count = static_cast<int>(std::min(ruler.length() / tick, static_cast<double>(mostTicks)));
    if (spacing < densest || count < 1)
        return;
    const sim::Vec2 along = (1.0 / ruler.length()) * (ruler.to - ruler.from);
    const QPointF across(-along.y, along.x);
    for (int i = 1; i <= count; ++i) {
        const QPointF at = canvas.camera.at(ruler.from + i * tick * along);
        const double half = i % 5 == 0 ? 5.0 : 3.0;
        canvas.painter.drawLine(at - half * across, at + half * across);
    }
}

}

double Ruler::length() const
{
    return std::hypot(to.x - from.x, to.y - from.y);
}

double Ruler::angle() const
{
    return length() > 0.0 ? std::atan2(from.y - to.y, to.x - from.x) * 180.0 / std::numbers::pi : 0.0;
}

std::optional<Ruler::End> Ruler::endAt(const Camera &camera, QPointF place) const
{
    const auto isNear = [&](sim::Vec2 end) { return QLineF(camera.at(end), place).length() <= grip; };
    if (isNear(to))
        return End::to;
    if (isNear(from))
        return End::from;
    return std::nullopt;
}

void drawRuler(const Canvas &canvas, const Ruler &ruler, const QRectF &scale)
{
    const Tokens &t = canvas.tokens();
    QPainter &painter = canvas.painter;
    const QPointF from = canvas.camera.at(ruler.from);
    const QPointF to = canvas.camera.at(ruler.to);
    painter.setPen(solid(t.ink2, 1.3));
    painter.drawLine(from, to);
    drawTicks(canvas, ruler);
    painter.setBrush(t.scene);
    painter.setPen(solid(t.ink, 1.5));
    for (const QPointF &end : {from, to})
        painter.drawEllipse(end, endRadius, endRadius);
    painter.setBrush(Qt::NoBrush);
    const QString words = wordsOf(ruler);
    QPointF at = (from + to) / 2.0 + QPointF(8.0, -10.0);
    const QRectF box = QFontMetricsF(canvas.shown.text).boundingRect(words).translated(at);
    if (box.intersects(scale))
        at.ry() -= box.bottom() - scale.top();
    drawWords(canvas, {at, words, canvas.shown.text, t.ink});
}

}
