#include "app/ui/stability/growth_plot.h"

#include "app/model/numbers.h"
#include "app/ui/stability/map_axis.h"
#include "app/ui/stability/stability_gauge.h"
#include "app/ui/theme/plot_axes.h"

#include <QLocale>

#include <algorithm>
#include <cmath>

namespace app {

namespace {

QColor mixed(const QColor &a, const QColor &b, double share)
{
    const auto part = [share](int from, int to) { return qRound(from + share * (to - from)); };
    return {part(a.red(), b.red()), part(a.green(), b.green()), part(a.blue(), b.blue())};
}

}

GrowthPlot::GrowthPlot(StabilityWatch &watch, const Theme &theme, QWidget *parent)
    : QCustomPlot(parent), m_watch(watch), m_theme(theme), m_cells(new QCPColorMap(xAxis, yAxis))
{
    installGaugeAccess();
    setObjectName("growthMap");
    setAccessibleName(tr("Map of growth"));
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    m_cells->setInterpolate(false);
    m_cells->setTightBoundary(false);
    m_cells->setDataRange(QCPRange(holding, std::log10(mostShown)));
    axisRect()->setMinimumMargins(QMargins(44, 30, 14, 40));
    axisRect()->setAutoMargins(QCP::msNone);
    axisRect()->setMargins(QMargins(48, 30, 14, 40));
    xAxis->grid()->setVisible(false);
    yAxis->grid()->setVisible(false);
    connect(&watch, &StabilityWatch::mapChanged, this, &GrowthPlot::refresh);
    connect(&theme, &Theme::changed, this, &GrowthPlot::dress);
    dress();
}

void GrowthPlot::dress()
{
    const Tokens &t = m_theme.tokens();
    setBackground(QBrush(t.panel));
    axisRect()->setBackground(QBrush(t.scene));
    dressAxis(*xAxis, m_theme);
    dressAxis(*yAxis, m_theme);
    // Ever darker on a light ground, ever brighter on a dark one: it reads without hue.
    const bool isDark = m_theme.isDark();
    const QColor far = isDark ? mixed(t.near, Qt::white, 0.65) : mixed(t.past, Qt::black, 0.5);
    m_gradient.clearColorStops();
    m_gradient.setColorInterpolation(QCPColorGradient::ciRGB);
    const double nought = -holding / (std::log10(mostShown) - holding);
    m_gradient.setColorStopAt(0.0, t.scene);
    m_gradient.setColorStopAt(nought * 0.6, t.scene);
    m_gradient.setColorStopAt(nought * 0.61, mixed(t.scene, t.near, isDark ? 0.3 : 0.3));
    m_gradient.setColorStopAt(0.4, mixed(t.scene, t.near, 0.85));
    m_gradient.setColorStopAt(1.0, far);
    m_cells->setGradient(m_gradient);
    m_cells->setDataRange(QCPRange(holding, std::log10(mostShown)));
    refresh();
}

void GrowthPlot::refresh()
{
    m_cells->setVisible(m_watch.map());
    if (!m_watch.map())
        m_chosen.reset();
    if (const sim::GrowthMap *map = m_watch.map()) {
        fill(*map);
        label(*map);
    }
    setAccessibleDescription(sentence());
    replot(QCustomPlot::rpQueuedReplot);
    update();
}

void GrowthPlot::fill(const sim::GrowthMap &map)
{
    const int columns = static_cast<int>(map.x.values.size());
    const int rows = static_cast<int>(map.y.values.size());
    m_cells->data()->setSize(columns, rows);
    m_cells->data()->setRange({onAxis(map.x, map.x.values.front()), onAxis(map.x, map.x.values.back())},
                              {onAxis(map.y, map.y.values.front()), onAxis(map.y, map.y.values.back())});
    m_cells->data()->fill(holding);
    for (std::size_t i = 0; i < map.growth.size(); ++i) {
        const double growth = map.growth[i];
        const double value = growth > 1.0 ? std::min(std::log10(growth), std::log10(mostShown)) : holding;
        m_cells->data()->setCell(static_cast<int>(i) % columns, static_cast<int>(i) / columns, value);
    }
    const double wide = 0.5 * spacing(map.x), high = 0.5 * spacing(map.y);
    xAxis->setRange(onAxis(map.x, map.x.values.front()) - wide, onAxis(map.x, map.x.values.back()) + wide);
    yAxis->setRange(onAxis(map.y, map.y.values.front()) - high, onAxis(map.y, map.y.values.back()) + high);
}

void GrowthPlot::label(const sim::GrowthMap &map)
{
    const auto powers = [](const sim::MapAxis &axis) {
        auto ticker = QSharedPointer<QCPAxisTickerText>::create();
        const int first = static_cast<int>(std::ceil(std::log10(axis.values.front()) - 1e-9));
        for (int i = first; i <= std::log10(axis.values.back()) + 1e-9; ++i)
            ticker->addTick(i, std::abs(i) <= 3 ? QLocale().toString(std::pow(10.0, i)) : powerOfTen(i));
        return ticker;
    };
    xAxis->setTicker(powers(map.x));
    if (!map.y.parameter.empty()) {
        auto ticker = QSharedPointer<QCPAxisTickerFixed>::create();
        ticker->setTickStep(0.2);
        yAxis->setTicker(ticker);
        yAxis->setNumberFormat("f");
        yAxis->setNumberPrecision(1);
        return;
    }
    auto ticker = QSharedPointer<QCPAxisTickerText>::create();
    for (int i = -20; i <= 6; i += 2) {
        const double h = std::ldexp(1.0, i);
        ticker->addTick(std::log10(h), i < 0 ? QStringLiteral("1/%1").arg(1 << -i) : QString::number(h));
    }
    yAxis->setTicker(ticker);
}

double GrowthPlot::upOf(const TriedSpot &spot) const
{
    return m_watch.map()->y.parameter.empty() ? spot.h : spot.damp;
}

QPointF GrowthPlot::onScreen(const TriedSpot &spot) const
{
    const sim::GrowthMap *map = m_watch.map();
    if (!map)
        return {};
    return {xAxis->coordToPixel(onAxis(map->x, spot.k)), yAxis->coordToPixel(onAxis(map->y, upOf(spot)))};
}

bool GrowthPlot::grows(int column, int row) const
{
    const sim::GrowthMap &map = *m_watch.map();
    const auto index = static_cast<std::size_t>(row) * map.x.values.size() + static_cast<std::size_t>(column);
    return index < map.growth.size() && map.growth[index] > 1.0;
}

}
