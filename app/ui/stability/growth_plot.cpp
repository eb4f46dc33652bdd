#include "app/ui/stability/growth_plot.h"

#include "app/model/text/numbers.h"
#include "app/model/text/step_text.h"

#include <QHelpEvent>
#include <QLocale>
#include <QToolTip>

#include <algorithm>
#include <cmath>

namespace app {

namespace {

constexpr double mostShown = 10.0; ///< growth a frame: faster growth has the last colour
constexpr double stable = -0.05; ///< the value of a cell without growth; others have the logarithm of growth
constexpr double leastNamed = 0.06; ///< of all cells: smaller areas have no text in them

/// Returns the place of a value on its axis. Cells of a colour map have one size, so ratios become differences.
double onAxis(const sim::MapAxis &axis, double value)
{
    return axis.parameter == "damp" ? value : std::log10(std::max(value, axis.values.front()));
}

/// Returns the distance between two values of the axis.
double spacing(const sim::MapAxis &axis)
{
    return (onAxis(axis, axis.values.back()) - onAxis(axis, axis.values.front())) /
           static_cast<double>(axis.values.size() - 1);
}

QColor mixed(const QColor &a, const QColor &b, double share)
{
    const auto part = [share](int from, int to) { return qRound(from + share * (to - from)); };
    return {part(a.red(), b.red()), part(a.green(), b.green()), part(a.blue(), b.blue())};
}

QString valueWords(const sim::MapAxis &axis, double value)
{
    if (axis.parameter.empty())
        return GrowthPlot::tr("a step of %1\u2009"
                              "frames")
            .arg(roughNumber(value));
    return QStringLiteral("%1 %2").arg(QString::fromStdString(axis.parameter), roughNumber(value));
}

/// Returns the box of a word round `centre`.
QRectF wordBox(const QFontMetricsF &metrics, const QString &text, QPointF centre)
{
    QRectF box(0, 0, metrics.horizontalAdvance(text) + 12, metrics.height() + 4);
    box.moveCenter(centre);
    return box;
}

void drawWord(QPainter &painter, const QRectF &box, const QString &text, const QColor &ground,
              const QColor &ink)
{
    painter.setPen(Qt::NoPen);
    painter.setBrush(ground);
    painter.drawRoundedRect(box, 4, 4);
    painter.setPen(ink);
    painter.drawText(box, Qt::AlignCenter, text);
}

}

GrowthPlot::GrowthPlot(StabilityMonitor &monitor, const Theme &theme, QWidget *parent)
    : SpotPlot(theme, parent), m_monitor(monitor), m_cells(new QCPColorMap(xAxis, yAxis))
{
    setObjectName("growthMap");
    setAccessibleName(tr("Map of growth"));
    setAntialiasedElements(QCP::aeNone); // cells have sharp edges
    m_cells->setInterpolate(false);
    m_cells->setTightBoundary(false);
    m_cells->setDataRange(QCPRange(stable, std::log10(mostShown)));
    axisRect()->setAutoMargins(QCP::msNone);
    axisRect()->setMargins(QMargins(48, 30, 14, 40));
    xAxis->grid()->setVisible(false);
    yAxis->grid()->setVisible(false);
    connect(&monitor, &StabilityMonitor::mapChanged, this, &GrowthPlot::refresh);
    connect(this, &SpotPlot::chosenChanged, this, [this] { setAccessibleDescription(sentence()); });
    applyTheme();
}

void GrowthPlot::applyTheme()
{
    SpotPlot::applyTheme();
    const Tokens &t = m_theme.tokens();
    axisRect()->setBackground(QBrush(t.scene));
    // Ever darker on a light ground, ever brighter on a dark one: it reads without hue.
    const bool isDark = m_theme.isDark();
    const QColor far = isDark ? mixed(t.near, Qt::white, 0.65) : mixed(t.past, Qt::black, 0.5);
    m_gradient.clearColorStops();
    m_gradient.setColorInterpolation(QCPColorGradient::ciRGB);
    const double nought = -stable / (std::log10(mostShown) - stable);
    m_gradient.setColorStopAt(0.0, t.scene);
    m_gradient.setColorStopAt(nought * 0.6, t.scene);
    m_gradient.setColorStopAt(nought * 0.61, mixed(t.scene, t.near, 0.3));
    m_gradient.setColorStopAt(0.4, mixed(t.scene, t.near, 0.85));
    m_gradient.setColorStopAt(1.0, far);
    m_cells->setGradient(m_gradient);
    refresh();
}

void GrowthPlot::refresh()
{
    m_cells->setVisible(m_monitor.map());
    if (!m_monitor.map())
        keepChosen(std::nullopt);
    if (const sim::GrowthMap *map = m_monitor.map()) {
        fill(*map);
        label(*map);
        if (chosen())
            keepChosen(spotOf(cellOf(*chosen()).x(), cellOf(*chosen()).y()));
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
    m_cells->data()->fill(stable);
    for (std::size_t i = 0; i < map.growth.size(); ++i) {
        const double growth = map.growth[i];
        const double value = growth > 1.0 ? std::min(std::log10(growth), std::log10(mostShown)) : stable;
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
    return m_monitor.map()->y.parameter.empty() ? spot.h : spot.damp;
}

QPointF GrowthPlot::onScreen(const TriedSpot &spot) const
{
    const sim::GrowthMap *map = m_monitor.map();
    if (!map)
        return {};
    return {xAxis->coordToPixel(onAxis(map->x, spot.k)), yAxis->coordToPixel(onAxis(map->y, upOf(spot)))};
}

bool GrowthPlot::grows(int column, int row) const
{
    const sim::GrowthMap &map = *m_monitor.map();
    const auto index = static_cast<std::size_t>(row) * map.x.values.size() + static_cast<std::size_t>(column);
    return index < map.growth.size() && map.growth[index] > 1.0;
}

Spot GrowthPlot::spotOf(int column, int row) const
{
    const sim::GrowthMap &map = *m_monitor.map();
    const auto columns = static_cast<int>(map.x.values.size()), rows = static_cast<int>(map.y.values.size());
    const auto x = static_cast<std::size_t>(std::clamp(column, 0, columns - 1));
    const auto y = static_cast<std::size_t>(std::clamp(row, 0, rows - 1));
    return {y * map.x.values.size() + x,
            {onAxis(map.x, map.x.values[x]), onAxis(map.y, map.y.values[y])},
            static_cast<int>(y)};
}

QPoint GrowthPlot::cellOf(const Spot &spot) const
{
    const std::size_t columns = m_monitor.map()->x.values.size();
    return {static_cast<int>(spot.row % columns), static_cast<int>(spot.row / columns)};
}

std::optional<Spot> GrowthPlot::spotAt(QPointF place) const
{
    if (!m_monitor.map() || !QRectF(axisRect()->rect()).contains(place))
        return std::nullopt;
    int column = 0, row = 0;
    m_cells->data()->coordToCell(xAxis->pixelToCoord(place.x()), yAxis->pixelToCoord(place.y()), &column,
                                 &row);
    return spotOf(column, row);
}

/// The first key goes on from the place in use.
std::optional<Spot> GrowthPlot::spotBeyond(QPoint step) const
{
    if (!m_monitor.map())
        return std::nullopt;
    const std::optional<Spot> from = chosen() ? chosen() : spotAt(onScreen(m_monitor.tried().back()));
    const QPoint cell = from ? cellOf(*from) : QPoint();
    return spotOf(cell.x() + step.x(), cell.y() - step.y());
}

TriedSpot GrowthPlot::triedAt(const Spot &spot) const
{
    const sim::GrowthMap &map = *m_monitor.map();
    const QPoint at = cellOf(spot);
    TriedSpot tried = m_monitor.tried().back();
    tried.k = map.x.values[static_cast<std::size_t>(at.x())];
    (map.y.parameter.empty() ? tried.h : tried.damp) = map.y.values[static_cast<std::size_t>(at.y())];
    return m_monitor.settable(tried);
}

QString GrowthPlot::wordsOf(const Spot &spot) const
{
    const sim::GrowthMap &map = *m_monitor.map();
    if (spot.row >= map.growth.size())
        return {};
    const QPoint at = cellOf(spot);
    const auto x = static_cast<std::size_t>(at.x()), y = static_cast<std::size_t>(at.y());
    const QString where =
        tr("%1, %2").arg(valueWords(map.x, map.x.values[x]), valueWords(map.y, map.y.values[y]));
    return grows(at.x(), at.y()) ? tr("%1: disturbances %2").arg(where, growthWords(map.at(x, y)))
                                 : tr("%1: stable").arg(where);
}

QString GrowthPlot::wordsAt(QPointF place) const
{
    const std::optional<Spot> spot = spotAt(place);
    return spot ? wordsOf(*spot) : QString();
}

QString GrowthPlot::tipOf(const Spot &spot) const
{
    const QString words = wordsOf(spot);
    if (words.isEmpty())
        return {};
    const TriedSpot there = triedAt(spot);
    const QString up = m_monitor.map()->y.parameter.empty()
                           ? tr("a step of %1").arg(stepTitle(there.h))
                           : QStringLiteral("damp %1").arg(roughNumber(there.damp));
    return tr("%1\nClick or press Enter to use k %2 and %3").arg(words, roughNumber(there.k), up);
}

QString GrowthPlot::tipAt(QPointF place) const
{
    const std::optional<Spot> spot = spotAt(place);
    return spot ? tipOf(*spot) : QString();
}

QString GrowthPlot::overview() const
{
    if (!m_monitor.map() || m_monitor.tried().empty())
        return tr("The map is being computed.");
    return tr("You are at %1. The arrow keys move over the map, and Enter uses the values at a place.")
        .arg(wordsAt(onScreen(m_monitor.tried().back())));
}

QRectF GrowthPlot::markOf(const Spot &spot) const
{
    const QPoint at = cellOf(spot);
    return cell(at.x(), at.y());
}

void GrowthPlot::use(const Spot &spot)
{
    if (m_monitor.map() && !wordsOf(spot).isEmpty())
        m_monitor.adopt(triedAt(spot));
}

bool GrowthPlot::event(QEvent *event)
{
    if (event->type() != QEvent::ToolTip)
        return SpotPlot::event(event);
    const auto *help = static_cast<QHelpEvent *>(event);
    QToolTip::showText(help->globalPos(), tipAt(help->pos()), this);
    return true;
}

QRectF GrowthPlot::cell(int column, int row) const
{
    double x = 0.0, y = 0.0;
    m_cells->data()->cellToCoord(column, row, &x, &y);
    const sim::GrowthMap &map = *m_monitor.map();
    const double wide = 0.5 * spacing(map.x), high = 0.5 * spacing(map.y);
    return {QPointF(xAxis->coordToPixel(x - wide), yAxis->coordToPixel(y + high)),
            QPointF(xAxis->coordToPixel(x + wide), yAxis->coordToPixel(y - high))};
}

void GrowthPlot::drawBorder(QPainter &painter) const
{
    const sim::GrowthMap &map = *m_monitor.map();
    const int columns = static_cast<int>(map.x.values.size());
    const int rows = static_cast<int>(map.growth.size()) / columns;
    painter.setPen(QPen(m_theme.tokens().ink, 1.5));
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column) {
            const QRectF here = cell(column, row);
            if (column + 1 < columns && grows(column, row) != grows(column + 1, row))
                painter.drawLine(here.topRight(), here.bottomRight());
            if (row + 1 < rows && grows(column, row) != grows(column, row + 1))
                painter.drawLine(here.topLeft(), here.topRight());
        }
    }
}

void GrowthPlot::drawWords(QPainter &painter) const
{
    const sim::GrowthMap &map = *m_monitor.map();
    const int columns = static_cast<int>(map.x.values.size());
    const int all = static_cast<int>(map.growth.size());
    painter.setFont(m_theme.ui(12, QFont::Medium));
    const QFontMetricsF metrics(painter.font());
    for (const bool growing : {false, true}) {
        QPointF sum;
        int count = 0;
        for (int i = 0; i < all; ++i) {
            if (grows(i % columns, i / columns) == growing) {
                sum += cell(i % columns, i / columns).center();
                ++count;
            }
        }
        if (count < leastNamed * columns * static_cast<int>(map.y.values.size()))
            continue;
        const QString text = growing ? tr("unstable") : tr("stable");
        QRectF box = wordBox(metrics, text, sum / count);
        if (box.intersects(hereBox(metrics).adjusted(-4, -4, 4, 4)))
            box.moveTop(hereBox(metrics).bottom() + 6);
        drawWord(painter, box, text, m_theme.tokens().panel, m_theme.tokens().ink);
    }
}

/// Returns the box of "you are here": beside the spot, on the side with more room.
QRectF GrowthPlot::hereBox(const QFontMetricsF &metrics) const
{
    const QPointF here = onScreen(m_monitor.tried().back());
    const QRectF area = axisRect()->rect();
    QRectF box = wordBox(metrics, tr("you are here"), here);
    if (here.x() < area.center().x())
        box.moveLeft(here.x() + 11);
    else
        box.moveRight(here.x() - 11);
    box.moveTop(std::clamp(box.top(), area.top() + 2, area.bottom() - box.height() - 2));
    return box;
}

void GrowthPlot::drawTried(QPainter &painter) const
{
    const Tokens &t = m_theme.tokens();
    const std::vector<TriedSpot> &tried = m_monitor.tried();
    QPolygonF path;
    for (const TriedSpot &spot : tried)
        path << onScreen(spot);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(t.panel, 3.5));
    painter.drawPolyline(path);
    painter.setPen(QPen(t.ink, 1.5));
    painter.drawPolyline(path);
    const QPointF here = path.back();
    painter.setPen(QPen(t.ink, 1.5));
    painter.setBrush(t.now);
    painter.drawEllipse(here, 6.0, 6.0);
    painter.setFont(m_theme.ui(12, QFont::Medium));
    drawWord(painter, hereBox(QFontMetricsF(painter.font())), tr("you are here"), t.now, t.nowText);
}

/// Outlines the chosen cell: the cell itself is only some px wide.
void GrowthPlot::paintPointer(QPainter &painter)
{
    if (!chosen() || !m_monitor.map() || !m_monitor.mapPlane())
        return;
    const Tokens &t = m_theme.tokens();
    const QRectF here = markOf(*chosen()).normalized().adjusted(-2, -2, 2, 2);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(t.panel, 3.5));
    painter.drawRect(here);
    painter.setPen(QPen(t.ink, 1.5));
    painter.drawRect(here);
}

void GrowthPlot::drawScale(QPainter &painter) const
{
    const Tokens &t = m_theme.tokens();
    const QRectF area = axisRect()->rect();
    painter.setFont(m_theme.ui(12));
    painter.setPen(t.ink3);
    const QFontMetricsF metrics(painter.font());
    const bool isStep = *m_monitor.mapPlane() == MapPlane::step;
    painter.drawText(QRectF(area.left() - 44, 2, area.width(), 22), Qt::AlignLeft | Qt::AlignVCenter,
                     isStep ? tr("step, frames") : tr("damp, kept per frame"));
    painter.drawText(QRectF(area.left(), height() - 20, area.width(), 18), Qt::AlignRight | Qt::AlignVCenter,
                     tr("stiffness k, 1/frame²"));
    // The meaning of the colours: growth a frame.
    const QString most = tr("×10 a frame"), least = QStringLiteral("×1");
    const double bar = 64.0;
    double x = area.right() - metrics.horizontalAdvance(most);
    painter.drawText(QRectF(x, 2, 200, 22), Qt::AlignLeft | Qt::AlignVCenter, most);
    x -= bar + 6;
    QLinearGradient colors(x, 0, x + bar, 0);
    const double nought = -stable / (std::log10(mostShown) - stable);
    QCPColorGradient gradient = m_gradient;
    for (int i = 0; i <= 16; ++i) {
        const double at = nought + (1.0 - nought) * i / 16.0;
        colors.setColorAt(i / 16.0, gradient.color(at, QCPRange(0.0, 1.0)));
    }
    painter.setPen(Qt::NoPen);
    painter.setBrush(colors);
    painter.drawRoundedRect(QRectF(x, 10, bar, 6), 3, 3);
    painter.setPen(t.ink3);
    x -= 6 + metrics.horizontalAdvance(least);
    painter.drawText(QRectF(x, 2, 60, 22), Qt::AlignLeft | Qt::AlignVCenter, least);
}

void GrowthPlot::paintMarks(QPainter &painter)
{
    if (!m_monitor.map() || !m_monitor.mapPlane())
        return;
    drawScale(painter);
    painter.setClipRect(axisRect()->rect().adjusted(-1, -1, 1, 1));
    drawBorder(painter);
    drawWords(painter);
    painter.setClipping(false);
    drawTried(painter);
}

}
