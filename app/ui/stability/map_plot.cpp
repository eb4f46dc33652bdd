#include "app/ui/stability/map_plot.h"

#include "app/model/text/numbers.h"
#include "app/model/text/phrases.h"

#include <QHelpEvent>
#include <QLocale>
#include <QToolTip>

#include <algorithm>
#include <cmath>
#include <map>

namespace app {

namespace {

constexpr double leastNamed = 0.06; ///< of all cells: smaller areas have no text in them

/// Returns whether the values of an axis have equal ratios, and not equal differences.
bool isByRatio(const sim::MapAxis &axis)
{
    const std::vector<double> &all = axis.values;
    return all.back() - all[all.size() - 2] > 1.5 * (all[1] - all[0]);
}

/// Returns the place of a value on its axis. Cells of a colour map have one size, so ratios become differences.
double onAxis(const sim::MapAxis &axis, double value)
{
    if (isByRatio(axis))
        return std::log10(std::max(value, axis.values.front()));
    return std::clamp(value, axis.values.front(), axis.values.back());
}

/// Returns the distance between two values of the axis.
double spacing(const sim::MapAxis &axis)
{
    return (onAxis(axis, axis.values.back()) - onAxis(axis, axis.values.front())) /
           static_cast<double>(axis.values.size() - 1);
}

QString valueWords(const sim::MapAxis &axis, double value)
{
    if (axis.parameter.empty())
        return MapPlot::tr("a step of %1\u2009"
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

QSharedPointer<QCPAxisTicker> powersOfTen(const sim::MapAxis &axis)
{
    auto ticker = QSharedPointer<QCPAxisTickerText>::create();
    const int first = static_cast<int>(std::ceil(std::log10(axis.values.front()) - 1e-9));
    for (int i = first; i <= std::log10(axis.values.back()) + 1e-9; ++i)
        ticker->addTick(i, std::abs(i) <= 3 ? QLocale().toString(std::pow(10.0, i)) : powerOfTen(i));
    return ticker;
}

QSharedPointer<QCPAxisTicker> steps()
{
    auto ticker = QSharedPointer<QCPAxisTickerText>::create();
    for (int i = -20; i <= 6; i += 2) {
        const double h = std::ldexp(1.0, i);
        ticker->addTick(std::log10(h), i < 0 ? QStringLiteral("1/%1").arg(1 << -i) : QString::number(h));
    }
    return ticker;
}

}

MapPlot::MapPlot(const Theme &theme, QWidget *parent)
    : SpotPlot(theme, parent), m_cells(new QCPColorMap(xAxis, yAxis))
{
    setAntialiasedElements(QCP::aeNone); // cells have sharp edges
    m_cells->setInterpolate(false);
    m_cells->setTightBoundary(false);
    m_cells->setDataRange(QCPRange(0.0, 1.0));
    m_cells->setVisible(false);
    axisRect()->setAutoMargins(QCP::msNone);
    axisRect()->setMargins(QMargins(48, 30, 14, 40));
    xAxis->grid()->setVisible(false);
    yAxis->grid()->setVisible(false);
    connect(this, &SpotPlot::chosenChanged, this, [this] { setAccessibleDescription(sentence()); });
}

void MapPlot::applyTheme()
{
    SpotPlot::applyTheme();
    axisRect()->setBackground(QBrush(m_theme.tokens().scene));
}

void MapPlot::setGradient(const QCPColorGradient &gradient)
{
    m_gradient = gradient;
    m_cells->setGradient(gradient);
}

QColor MapPlot::shadeColor(double shade) const
{
    QCPColorGradient gradient = m_gradient;
    return gradient.color(shade, QCPRange(0.0, 1.0));
}

void MapPlot::refresh()
{
    const Axes map = axes();
    m_cells->setVisible(bool(map));
    if (!map) {
        keepChosen(std::nullopt);
    } else {
        fill();
        label();
        if (chosen())
            keepChosen(spotOf(cellOf(*chosen()).x(), cellOf(*chosen()).y()));
    }
    setAccessibleDescription(sentence());
    replot(QCustomPlot::rpQueuedReplot);
    update();
}

int MapPlot::columns() const
{
    return static_cast<int>(axes().x->values.size());
}

int MapPlot::rows() const
{
    return static_cast<int>(axes().y->values.size());
}

std::size_t MapPlot::cellAt(int column, int row) const
{
    return static_cast<std::size_t>(row) * axes().x->values.size() + static_cast<std::size_t>(column);
}

void MapPlot::fill()
{
    const sim::MapAxis &x = *axes().x, &y = *axes().y;
    m_cells->data()->setSize(columns(), rows());
    m_cells->data()->setRange({onAxis(x, x.values.front()), onAxis(x, x.values.back())},
                              {onAxis(y, y.values.front()), onAxis(y, y.values.back())});
    for (int row = 0; row < rows(); ++row) {
        for (int column = 0; column < columns(); ++column)
            m_cells->data()->setCell(column, row, shadeOf(cellAt(column, row)));
    }
    const double wide = 0.5 * spacing(x), high = 0.5 * spacing(y);
    xAxis->setRange(onAxis(x, x.values.front()) - wide, onAxis(x, x.values.back()) + wide);
    yAxis->setRange(onAxis(y, y.values.front()) - high, onAxis(y, y.values.back()) + high);
}

void MapPlot::label()
{
    xAxis->setTicker(powersOfTen(*axes().x));
    if (isByRatio(*axes().y)) {
        yAxis->setTicker(steps());
        return;
    }
    auto ticker = QSharedPointer<QCPAxisTickerFixed>::create();
    ticker->setTickStep(0.2);
    yAxis->setTicker(ticker);
    yAxis->setNumberFormat("f");
    yAxis->setNumberPrecision(1);
}

double MapPlot::upOf(const TriedSpot &spot) const
{
    return axes().y->parameter.empty() ? spot.h : spot.damp;
}

QPointF MapPlot::onScreen(const TriedSpot &spot) const
{
    const Axes map = axes();
    if (!map)
        return {};
    return {xAxis->coordToPixel(onAxis(*map.x, spot.k)), yAxis->coordToPixel(onAxis(*map.y, upOf(spot)))};
}

Spot MapPlot::spotOf(int column, int row) const
{
    const int x = std::clamp(column, 0, columns() - 1), y = std::clamp(row, 0, rows() - 1);
    const sim::MapAxis &across = *axes().x, &up = *axes().y;
    return {cellAt(x, y),
            {onAxis(across, across.values[static_cast<std::size_t>(x)]),
             onAxis(up, up.values[static_cast<std::size_t>(y)])},
            y};
}

QPoint MapPlot::cellOf(const Spot &spot) const
{
    const auto count = static_cast<std::size_t>(columns());
    return {static_cast<int>(spot.row % count), static_cast<int>(spot.row / count)};
}

std::optional<Spot> MapPlot::spotAt(QPointF place) const
{
    if (!axes() || !QRectF(axisRect()->rect()).contains(place))
        return std::nullopt;
    int column = 0, row = 0;
    m_cells->data()->coordToCell(xAxis->pixelToCoord(place.x()), yAxis->pixelToCoord(place.y()), &column,
                                 &row);
    return spotOf(column, row);
}

/// The first key goes on from the place in use.
std::optional<Spot> MapPlot::spotBeyond(QPoint step) const
{
    if (!axes())
        return std::nullopt;
    const std::optional<Spot> from = chosen() ? chosen() : spotAt(onScreen(tried().back()));
    const QPoint at = from ? cellOf(*from) : QPoint();
    return spotOf(at.x() + step.x(), at.y() - step.y());
}

TriedSpot MapPlot::triedAt(const Spot &spot) const
{
    const Axes map = axes();
    const QPoint at = cellOf(spot);
    TriedSpot there = tried().back();
    there.k = map.x->values[static_cast<std::size_t>(at.x())];
    (map.y->parameter.empty() ? there.h : there.damp) = map.y->values[static_cast<std::size_t>(at.y())];
    return settable(there);
}

QString MapPlot::wordsOf(const Spot &spot) const
{
    const QString result = resultWords(spot.row);
    if (result.isEmpty())
        return {};
    const Axes map = axes();
    const QPoint at = cellOf(spot);
    const QString where = listed(valueWords(*map.x, map.x->values[static_cast<std::size_t>(at.x())]),
                                 valueWords(*map.y, map.y->values[static_cast<std::size_t>(at.y())]));
    return labelled(where, result);
}

QString MapPlot::wordsAt(QPointF place) const
{
    const std::optional<Spot> spot = spotAt(place);
    return spot ? wordsOf(*spot) : QString();
}

QString MapPlot::tipOf(const Spot &spot) const
{
    const QString words = wordsOf(spot);
    return words.isEmpty() ? QString() : words + '\n' + useWords(triedAt(spot));
}

QString MapPlot::tipAt(QPointF place) const
{
    const std::optional<Spot> spot = spotAt(place);
    return spot ? tipOf(*spot) : QString();
}

QString MapPlot::overview() const
{
    if (!axes() || tried().empty())
        return tr("The map is being computed.");
    return tr("You are at %1. The arrow keys move over the map, and Enter uses the values at a place.")
        .arg(wordsAt(onScreen(tried().back())));
}

QRectF MapPlot::markOf(const Spot &spot) const
{
    const QPoint at = cellOf(spot);
    return cell(at.x(), at.y());
}

void MapPlot::use(const Spot &spot)
{
    if (axes() && !wordsOf(spot).isEmpty())
        adopt(triedAt(spot));
}

bool MapPlot::event(QEvent *event)
{
    if (event->type() != QEvent::ToolTip)
        return SpotPlot::event(event);
    const auto *help = static_cast<QHelpEvent *>(event);
    QToolTip::showText(help->globalPos(), tipAt(help->pos()), this);
    return true;
}

QRectF MapPlot::cell(int column, int row) const
{
    double x = 0.0, y = 0.0;
    m_cells->data()->cellToCoord(column, row, &x, &y);
    const double wide = 0.5 * spacing(*axes().x), high = 0.5 * spacing(*axes().y);
    return {QPointF(xAxis->coordToPixel(x - wide), yAxis->coordToPixel(y + high)),
            QPointF(xAxis->coordToPixel(x + wide), yAxis->coordToPixel(y - high))};
}

void MapPlot::drawSigns(QPainter &painter) const
{
    for (int row = 0; row < rows(); ++row) {
        for (int column = 0; column < columns(); ++column)
            drawSign(painter, cell(column, row), kindOf(cellAt(column, row)));
    }
}

void MapPlot::drawBorder(QPainter &painter) const
{
    const auto differ = [this](std::size_t a, std::size_t b) {
        return kindOf(a) != kindOf(b) && kindOf(a) >= 0 && kindOf(b) >= 0;
    };
    painter.setPen(QPen(m_theme.tokens().ink, 1.5));
    for (int row = 0; row < rows(); ++row) {
        for (int column = 0; column < columns(); ++column) {
            const QRectF here = cell(column, row);
            if (column + 1 < columns() && differ(cellAt(column, row), cellAt(column + 1, row)))
                painter.drawLine(here.topRight(), here.bottomRight());
            if (row + 1 < rows() && differ(cellAt(column, row), cellAt(column, row + 1)))
                painter.drawLine(here.topLeft(), here.topRight());
        }
    }
}

void MapPlot::drawWords(QPainter &painter) const
{
    struct Area
    {
        QPointF sum;
        int count = 0;
    };
    std::map<int, Area> areas;
    for (int row = 0; row < rows(); ++row) {
        for (int column = 0; column < columns(); ++column) {
            Area &area = areas[kindOf(cellAt(column, row))];
            area.sum += cell(column, row).center();
            ++area.count;
        }
    }
    painter.setFont(m_theme.ui(12, QFont::Medium));
    const QFontMetricsF metrics(painter.font());
    for (const auto &[kind, area] : areas) {
        const QString text = kind < 0 ? QString() : kindWord(kind);
        if (text.isEmpty() || area.count < leastNamed * columns() * rows())
            continue;
        QRectF box = wordBox(metrics, text, area.sum / area.count);
        const double most = axisRect()->right() - 2.0, least = axisRect()->left() + 2.0;
        box.moveLeft(std::max(least, std::min(box.left(), most - box.width())));
        if (box.intersects(hereBox(metrics).adjusted(-4, -4, 4, 4)))
            box.moveTop(hereBox(metrics).bottom() + 6);
        drawWord(painter, box, text, m_theme.tokens().panel, m_theme.tokens().ink);
    }
}

/// Returns the box of "you are here": beside the spot, on the side with more room.
QRectF MapPlot::hereBox(const QFontMetricsF &metrics) const
{
    const QPointF here = onScreen(tried().back());
    const QRectF area = axisRect()->rect();
    QRectF box = wordBox(metrics, tr("you are here"), here);
    if (here.x() < area.center().x())
        box.moveLeft(here.x() + 11);
    else
        box.moveRight(here.x() - 11);
    box.moveTop(std::clamp(box.top(), area.top() + 2, area.bottom() - box.height() - 2));
    return box;
}

void MapPlot::drawTried(QPainter &painter) const
{
    const Tokens &t = m_theme.tokens();
    QPolygonF path;
    for (const TriedSpot &spot : tried())
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
void MapPlot::paintPointer(QPainter &painter)
{
    if (!chosen() || !axes())
        return;
    const Tokens &t = m_theme.tokens();
    const QRectF here = markOf(*chosen()).normalized().adjusted(-2, -2, 2, 2);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(t.panel, 3.5));
    painter.drawRect(here);
    painter.setPen(QPen(t.ink, 1.5));
    painter.drawRect(here);
}

void MapPlot::drawTitles(QPainter &painter) const
{
    const QRectF area = axisRect()->rect();
    painter.setFont(m_theme.ui(12));
    painter.setPen(m_theme.tokens().ink3);
    painter.drawText(QRectF(area.left() - 44, 2, area.width(), 22), Qt::AlignLeft | Qt::AlignVCenter,
                     upTitle());
    painter.drawText(QRectF(area.left(), height() - 20, area.width(), 18), Qt::AlignRight | Qt::AlignVCenter,
                     acrossTitle());
}

void MapPlot::drawBar(QPainter &painter, const QRectF &bar, double low, double high) const
{
    QLinearGradient colors(bar.topLeft(), bar.topRight());
    for (int i = 0; i <= 16; ++i)
        colors.setColorAt(i / 16.0, shadeColor(low + (high - low) * i / 16.0));
    painter.setPen(Qt::NoPen);
    painter.setBrush(colors);
    painter.drawRoundedRect(bar, 3, 3);
}

void MapPlot::paintMarks(QPainter &painter)
{
    if (!axes())
        return;
    drawTitles(painter);
    drawKey(painter);
    painter.setClipRect(axisRect()->rect().adjusted(-1, -1, 1, 1));
    drawSigns(painter);
    drawBorder(painter);
    drawWords(painter);
    painter.setClipping(false);
    drawTried(painter);
}

}
