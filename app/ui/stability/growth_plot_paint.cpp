// What a map of growth draws over its cells.

#include "app/ui/stability/growth_plot.h"
#include "app/ui/stability/map_axis.h"

#include <algorithm>
#include <cmath>

namespace app {

namespace {

constexpr double leastNamed = 0.06; ///< of all cells: what smaller areas are is not written into them

/// A word on a ground of its own, round `centre`.
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

QRectF GrowthPlot::cell(int column, int row) const
{
    double x = 0.0, y = 0.0;
    m_cells->data()->cellToCoord(column, row, &x, &y);
    const sim::GrowthMap &map = *m_watch.map();
    const double wide = 0.5 * spacing(map.x), high = 0.5 * spacing(map.y);
    return {QPointF(xAxis->coordToPixel(x - wide), yAxis->coordToPixel(y + high)),
            QPointF(xAxis->coordToPixel(x + wide), yAxis->coordToPixel(y - high))};
}

void GrowthPlot::drawBorder(QPainter &painter) const
{
    const sim::GrowthMap &map = *m_watch.map();
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
    const sim::GrowthMap &map = *m_watch.map();
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
        const QString text = growing ? tr("grows") : tr("holds");
        QRectF box = wordBox(metrics, text, sum / count);
        if (box.intersects(hereBox(metrics).adjusted(-4, -4, 4, 4)))
            box.moveTop(hereBox(metrics).bottom() + 6);
        drawWord(painter, box, text, m_theme.tokens().panel, m_theme.tokens().ink);
    }
}

/// Where "you are here" is written: beside the spot, on the side with more room.
QRectF GrowthPlot::hereBox(const QFontMetricsF &metrics) const
{
    const QPointF here = onScreen(m_watch.tried().back());
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
    const std::vector<TriedSpot> &tried = m_watch.tried();
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

/// Where the keys or the pointer are: the cell itself is only some px wide.
void GrowthPlot::drawChosen(QPainter &painter) const
{
    if (!m_chosen)
        return;
    const Tokens &t = m_theme.tokens();
    const QRectF here = cell(m_chosen->x(), m_chosen->y()).normalized().adjusted(-2, -2, 2, 2);
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
    const bool isStep = *m_watch.mapPlane() == MapPlane::step;
    painter.drawText(QRectF(area.left() - 44, 2, area.width(), 22), Qt::AlignLeft | Qt::AlignVCenter,
                     isStep ? tr("step, frames") : tr("damp, kept a frame"));
    painter.drawText(QRectF(area.left(), height() - 20, area.width(), 18), Qt::AlignRight | Qt::AlignVCenter,
                     tr("stiffness k, 1/frame²"));
    // What the colours mean: growth a frame.
    const QString most = tr("×10 a frame"), least = QStringLiteral("×1");
    const double bar = 64.0;
    double x = area.right() - metrics.horizontalAdvance(most);
    painter.drawText(QRectF(x, 2, 200, 22), Qt::AlignLeft | Qt::AlignVCenter, most);
    x -= bar + 6;
    QLinearGradient colors(x, 0, x + bar, 0);
    const double nought = -holding / (std::log10(mostShown) - holding);
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

/// What lies over the cells.
void GrowthPlot::drawMarks(QPainter &painter) const
{
    painter.setRenderHint(QPainter::Antialiasing);
    drawScale(painter);
    painter.setClipRect(axisRect()->rect().adjusted(-1, -1, 1, 1));
    drawBorder(painter);
    drawWords(painter);
    painter.setClipping(false);
    drawTried(painter);
}

PlotPicture GrowthPlot::picture()
{
    return {accessibleName(), accessibleName(), size(), [this](QCPPainter &painter) {
                toPainter(&painter, width(), height());
                if (m_watch.map() && m_watch.mapPlane())
                    drawMarks(painter);
            }};
}

void GrowthPlot::paintEvent(QPaintEvent *event)
{
    QCustomPlot::paintEvent(event);
    QPainter painter(this);
    if (!m_watch.map() || !m_watch.mapPlane())
        return;
    drawMarks(painter);
    drawChosen(painter);
    if (!m_ringed)
        return;
    painter.setPen(QPen(m_theme.tokens().ink, 2.0));
    painter.setBrush(Qt::NoBrush);
    painter.drawRoundedRect(QRectF(rect()).adjusted(1.0, 1.0, -1.0, -1.0), 6.0, 6.0);
}

}
