#include "app/ui/scene/layers/wind_overlay.h"

#include "sim/base/random.h"

#include <QPainterPath>

#include <cmath>
#include <numbers>

namespace app {

namespace {

constexpr int streaks = 34;
constexpr std::uint64_t windSeed = 5;
constexpr double ring = 26.0; ///< screen px, as all sizes here
constexpr double dot = 15.0;
constexpr double nearest = 40.0;
constexpr double drift = 130.0; ///< how far a streak moves before it starts again
constexpr double period = 40.0; ///< frames per such move

double streakChance(int streak, int what)
{
    return sim::uniform(windSeed, what, streak);
}

void drawStreak(const Canvas &canvas, QPointF middle, int streak)
{
    const double turn = (streak + 0.8 * streakChance(streak, 0)) * 2.0 * std::numbers::pi / streaks;
    const QPointF u(std::cos(turn), std::sin(turn));
    const QPointF n(-u.y(), u.x());
    const double frames = canvas.shown.extras.still ? 0.0 : static_cast<double>(canvas.shown.state().frame);
    const double way = std::fmod(frames / period + streakChance(streak, 1), 1.0);
    const double from = nearest + drift * way;
    const double length = 50.0 + 90.0 * streakChance(streak, 2);
    const double bend = 26.0 * (streakChance(streak, 3) - 0.5);
    QPainterPath path(middle + from * u);
    path.quadTo(middle + (from + length * 0.5) * u + bend * n, middle + (from + length) * u + 0.2 * bend * n);
    // A streak fades in and out at the ends of its path, so that its jump back is invisible.
    const double strength = std::sin(std::numbers::pi * way);
    QLinearGradient fading(path.pointAtPercent(0.0), path.pointAtPercent(1.0));
    fading.setColorAt(0.0, faded(canvas.tokens().wind, 0.25 * strength));
    fading.setColorAt(0.35, faded(canvas.tokens().wind, 0.95 * strength));
    fading.setColorAt(1.0, faded(canvas.tokens().wind, 0.0));
    QPen pen = dashed(canvas.tokens().wind, 1.5 + 0.9 * streakChance(streak, 4), {2.0, 4.0});
    pen.setBrush(fading);
    canvas.painter.strokePath(path, pen);
    // A thin line connects the dashes.
    QPen line(QBrush(fading), pen.widthF() * 0.6, Qt::SolidLine, Qt::RoundCap);
    canvas.painter.strokePath(path, line);
}

}

void drawWind(const Canvas &canvas, QPointF middle)
{
    if (!canvas.reaches(middle, nearest + drift + 140.0))
        return;
    QPainter &p = canvas.painter;
    for (int i = 0; i < streaks; ++i)
        drawStreak(canvas, middle, i);
    p.setPen(QPen(faded(canvas.tokens().wind, 0.75), 1.6));
    p.setBrush(Qt::NoBrush);
    p.drawEllipse(middle, ring, ring);
    p.setPen(Qt::NoPen);
    p.setBrush(faded(canvas.tokens().wind, 0.28));
    p.drawEllipse(middle, dot, dot);
    p.setBrush(Qt::NoBrush);
}

}
