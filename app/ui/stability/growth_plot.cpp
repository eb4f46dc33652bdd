#include "app/ui/stability/growth_plot.h"

#include "app/model/text/numbers.h"
#include "app/model/text/step_text.h"

#include <algorithm>
#include <cmath>

namespace app {

namespace {

constexpr double mostShown = 10.0; ///< growth a frame: faster growth has the last colour
constexpr double nought = 0.05;    ///< the shade of growth 1; a cell without growth has the shade 0

}

GrowthPlot::GrowthPlot(StabilityMonitor &monitor, const Theme &theme, QWidget *parent)
    : MapPlot(theme, parent), m_monitor(monitor)
{
    setObjectName("growthMap");
    setAccessibleName(tr("Map of growth"));
    connect(&monitor, &StabilityMonitor::mapChanged, this, &GrowthPlot::refresh);
    applyTheme();
}

void GrowthPlot::applyTheme()
{
    MapPlot::applyTheme();
    const Tokens &t = m_theme.tokens();
    // Ever darker on a light ground, ever brighter on a dark one: it reads without hue.
    const bool isDark = m_theme.isDark();
    const QColor far = isDark ? mixed(t.near, Qt::white, 0.65) : mixed(t.past, Qt::black, 0.5);
    QCPColorGradient gradient;
    gradient.clearColorStops();
    gradient.setColorInterpolation(QCPColorGradient::ciRGB);
    gradient.setColorStopAt(0.0, t.scene);
    gradient.setColorStopAt(nought * 0.6, t.scene);
    gradient.setColorStopAt(nought * 0.61, mixed(t.scene, t.near, 0.3));
    gradient.setColorStopAt(0.4, mixed(t.scene, t.near, 0.85));
    gradient.setColorStopAt(1.0, far);
    setGradient(gradient);
    refresh();
}

MapPlot::Axes GrowthPlot::axes() const
{
    const sim::GrowthMap *map = m_monitor.mapPlane() ? m_monitor.map() : nullptr;
    return map ? Axes{&map->x, &map->y} : Axes{};
}

int GrowthPlot::kindOf(std::size_t cell) const
{
    const std::vector<double> &growth = m_monitor.map()->growth;
    return cell >= growth.size() ? -1 : growth[cell] > 1.0 ? 1 : 0;
}

double GrowthPlot::shadeOf(std::size_t cell) const
{
    if (kindOf(cell) != 1)
        return 0.0;
    const double growth = m_monitor.map()->growth[cell];
    return nought + (1.0 - nought) * std::min(std::log(growth) / std::log(mostShown), 1.0);
}

QString GrowthPlot::kindWord(int kind) const
{
    return kind == 1 ? tr("unstable") : tr("stable");
}

QString GrowthPlot::resultWords(std::size_t cell) const
{
    switch (kindOf(cell)) {
    case 0:
        return tr("stable");
    case 1:
        return tr("disturbances %1").arg(growthWords(m_monitor.map()->growth[cell]));
    default:
        return {};
    }
}

QString GrowthPlot::useWords(const TriedSpot &to) const
{
    const QString up = m_monitor.map()->y.parameter.empty()
                           ? tr("a step of %1").arg(stepTitle(to.h))
                           : QStringLiteral("damp %1").arg(roughNumber(to.damp));
    return tr("Click or press Enter to use k %1 and %2").arg(roughNumber(to.k), up);
}

QString GrowthPlot::acrossTitle() const
{
    return tr("stiffness k, 1/frame²");
}

QString GrowthPlot::upTitle() const
{
    return *m_monitor.mapPlane() == MapPlane::step ? tr("step, frames") : tr("damp, kept per frame");
}

void GrowthPlot::drawKey(QPainter &painter) const
{
    const QRectF area = axisRect()->rect();
    const QFontMetricsF metrics(painter.font());
    const QString most = tr("×10 a frame"), least = QStringLiteral("×1");
    const double bar = 64.0;
    double x = area.right() - metrics.horizontalAdvance(most);
    painter.drawText(QRectF(x, 2, 200, 22), Qt::AlignLeft | Qt::AlignVCenter, most);
    x -= bar + 6;
    drawBar(painter, {x, 10, bar, 6}, nought, 1.0);
    painter.setPen(m_theme.tokens().ink3);
    x -= 6 + metrics.horizontalAdvance(least);
    painter.drawText(QRectF(x, 2, 60, 22), Qt::AlignLeft | Qt::AlignVCenter, least);
}

}
