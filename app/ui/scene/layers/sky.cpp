#include "app/ui/scene/layers/sky.h"

#include "lessons/api/view/view.h"
#include "sim/base/random.h"

#include <QPainterPath>

#include <algorithm>
#include <cmath>

namespace app {

namespace {

constexpr std::array skyStops{0.0, 0.42, 0.72, 0.92, 1.0};
constexpr int stars = 60;
constexpr std::uint64_t starSeed = 7;
constexpr double starsDown = 0.6;  ///< fraction of the way down to the horizon that has stars
constexpr double meadowStep = 6.0; ///< screen px between two corners of the meadow's edge

double starChance(int star, int what)
{
    return sim::uniform(starSeed, star, what);
}

void paintStars(QPainter &p, QRectF view, double horizon, const QColor &color)
{
    for (int i = 0; i < stars; ++i) {
        const QPointF at(starChance(i, 0) * view.width(),
                         std::pow(starChance(i, 1), 1.4) * starsDown * horizon);
        const double high = 1.0 - at.y() / (starsDown * std::max(1.0, horizon));
        p.setBrush(faded(color, color.alphaF() * (0.15 + 0.45 * starChance(i, 2)) * (0.4 + 0.6 * high)));
        const double r = 0.5 + 0.8 * starChance(i, 3);
        p.drawEllipse(at, r, r);
    }
}

void paintSun(QPainter &p, QRectF view, double horizon, const QColor &color)
{
    const QPointF at(0.8 * view.width(), 0.7 * horizon);
    const double r = 0.3 * view.height();
    QRadialGradient glow(at, r);
    glow.setColorAt(0.0, color);
    glow.setColorAt(0.12, faded(color, 0.55 * color.alphaF()));
    glow.setColorAt(1.0, faded(color, 0.0));
    p.setBrush(glow);
    p.drawEllipse(at, r, r);
}

/// Paints one of two rows of hills.
void paintHills(QPainter &p, QRectF view, double horizon, const QColor &color)
{
    const double w = view.width();
    const double unit = std::min(60.0, 0.1 * view.height());
    const auto row = [&](double height, double shift, double alpha) {
        QPainterPath path(QPointF(0.0, view.bottom()));
        for (double x = 0.0; x <= w + 8.0; x += 8.0) {
            const double way = x / 620.0 + shift;
            const double wave = 0.55 + 0.3 * std::sin(2.4 * way) + 0.15 * std::sin(5.1 * way + 1.0);
            path.lineTo(x, horizon - unit * height * wave);
        }
        path.lineTo(w + 8.0, view.bottom());
        p.setBrush(faded(color, alpha * color.alphaF()));
        p.drawPath(path);
    };
    row(1.5, 0.3, 0.5);
    row(0.95, 2.9, 1.0);
}

QPixmap paintedSky(QRectF view, double ratio, double horizon, Scheme scheme)
{
    const SkyColors colors = skyColors(scheme);
    QPixmap pixmap((view.size() * ratio).toSize());
    pixmap.setDevicePixelRatio(ratio);
    QPainter p(&pixmap);
    p.setRenderHint(QPainter::Antialiasing);
    p.setPen(Qt::NoPen);
    // The gradient ends at the horizon. If the horizon is out of view, most of the colours still show.
    const double low = std::clamp(horizon, 0.6 * view.height(), 1.3 * view.height());
    QLinearGradient gradient(0.0, 0.0, 0.0, low);
    for (std::size_t i = 0; i < skyStops.size(); ++i)
        gradient.setColorAt(skyStops[i], colors.sky[i]);
    p.fillRect(view, gradient);
    paintStars(p, view, low, colors.star);
    paintSun(p, view, low, colors.sun);
    paintHills(p, view, horizon, colors.hills);
    return pixmap;
}

/// Returns the height of the meadow's edge above the horizon, px; 0 on average.
double swell(double x)
{
    return 4.0 * std::sin(x / 173.0 + 0.6) + 2.0 * std::sin(x / 61.0);
}

double footOf(const SceneContent &shown)
{
    return shown.view().tree && shown.points() > 0 ? shown.state().positionOf(0).x
                                                   : shown.view().stage.center().x();
}

}

SkyColors skyColors(Scheme scheme)
{
    if (scheme == Scheme::highContrast)
        return {
            {QColor("#000000"), QColor("#000000"), QColor("#000000"), QColor("#000000"), QColor("#000000")},
            QColor(0, 0, 0, 0),
            QColor(0, 0, 0, 0),
            QColor(0, 0, 0, 0),
            QColor("#2A2A2A"),
            QColor("#FFFFFF"),
            QColor("#FFFFFF"),
            {QColor("#FFFFFF"), QColor("#E0E0E0"), QColor("#BFBFBF")},
            QColor("#FFFFFF")};
    if (scheme == Scheme::dark)
        return {
            {QColor("#161B33"), QColor("#3A3760"), QColor("#8A5578"), QColor("#D67F73"), QColor("#F0AE7C")},
            QColor("#FFFFFF"),
            QColor(0, 0, 0, 0),
            QColor(0x6E, 0x46, 0x63, 150),
            QColor("#1B1724"),
            QColor("#14121C"),
            QColor("#22182A"),
            {QColor("#F2B38A"), QColor("#F5C6A1"), QColor("#F7D9B8")},
            QColor("#8F7F95")};
    return {{QColor("#BBD8EC"), QColor("#D9E9F0"), QColor("#F1EEE2"), QColor("#FBE6CC"), QColor("#FBDDBE")},
            QColor(0, 0, 0, 0),
            QColor(0xFF, 0xF6, 0xDC, 235),
            QColor(0xA9, 0xBF, 0xB4, 150),
            QColor("#EFEEDF"),
            QColor("#2E2630"),
            QColor("#4A3A44"),
            {QColor("#DE7F6A"), QColor("#E8997F"), QColor("#D56B6B")},
            QColor("#6F6068")};
}

double horizonOf(const SceneContent &shown)
{
    const lessons::View &view = shown.view();
    if (view.tree && shown.points() > 0)
        return shown.state().positionOf(0).y;
    return view.ground.value_or(view.stage.bottom());
}

void Sky::draw(QPainter &painter, QRectF view, double horizon, Scheme scheme)
{
    const double ratio = painter.device()->devicePixelRatioF();
    const double low = std::round(std::clamp(horizon, -view.height(), 3.0 * view.height()));
    if (m_painted.isNull() || m_painted.deviceIndependentSize() != view.size() ||
        m_painted.devicePixelRatio() != ratio || m_horizon != low || m_scheme != scheme)
        m_painted = paintedSky(view, ratio, low, scheme);
    m_horizon = low;
    m_scheme = scheme;
    painter.drawPixmap(QPointF(0.0, 0.0), m_painted);
}

QPolygonF drawMeadow(const Canvas &canvas, const SkyColors &colors)
{
    const Camera &camera = canvas.camera;
    const QRectF area = canvas.area;
    const double horizon = horizonOf(canvas.shown);
    const double foot = footOf(canvas.shown);
    const double atFoot = swell(foot);
    QPolygonF edge{{area.left(), area.bottom() + 1.0}};
    for (double x = area.left(); x <= area.right() + meadowStep; x += meadowStep) {
        const double place = camera.back({x, 0.0}).x;
        edge << QPointF(x, camera.at({place, horizon - swell(place) + atFoot}).y() - 2.0);
    }
    edge << QPointF(area.right() + meadowStep, area.bottom() + 1.0);
    canvas.painter.setPen(Qt::NoPen);
    canvas.painter.setBrush(colors.meadow);
    canvas.painter.drawPolygon(edge);
    canvas.painter.setBrush(Qt::NoBrush);
    return edge;
}

}
