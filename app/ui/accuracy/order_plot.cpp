#include "app/ui/accuracy/order_plot.h"

#include "app/model/text/accuracy_text.h"
#include "app/model/text/numbers.h"

#include <algorithm>
#include <cmath>

namespace app {

namespace {

using sim::AccuracyRow;

constexpr double orderNameRoom = 196.0;
constexpr double near = 0.15; ///< of an order

/// Returns the median of the measured slopes: the coarsest and the finest steps say least.
std::optional<double> orderOf(const sim::Accuracy &accuracy, const sim::Method &method)
{
    std::vector<double> orders;
    for (const Slope &slope : slopesOf(accuracy, method))
        orders.push_back(slope.order);
    if (orders.empty())
        return std::nullopt;
    std::sort(orders.begin(), orders.end());
    return orders[orders.size() / 2];
}

}

OrderPlot::OrderPlot(AccuracyStudy &study, const Theme &theme, QWidget *parent)
    : StudyPlot(study, theme, parent)
{
    setObjectName("order");
    setAccessibleName(tr("Error against step: the measured order"));
    makeLogarithmic(*xAxis);
    xAxis->setRangeReversed(true); // finer steps to the right, as in the other plots
    xAxis->setRange(0.001, 1.0);
}

QString OrderPlot::orderWords(const sim::Accuracy &accuracy, const sim::Method &method)
{
    const std::optional<double> order = orderOf(accuracy, method);
    if (!order)
        return methodTitle(method);
    const QString measured = fixedNumber(*order, 1);
    if (std::abs(*order - method.order()) <= near)
        return tr("%1: %2, as expected").arg(methodTitle(method), measured);
    return tr("%1: %2 of %3").arg(methodTitle(method), measured).arg(method.order());
}

std::vector<Spot> OrderPlot::layOut()
{
    const std::vector<AccuracyRow> &rows = m_study.accuracy()->rows;
    std::vector<Spot> spots;
    int line = -1;
    std::vector<double> all;
    double finest = 1e300, coarsest = 0.0;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        if (i == 0 || rows[i].setup.method->id() != rows[i - 1].setup.method->id())
            ++line;
        if (rows[i].outcome != sim::Outcome::measured || rows[i].setup.step.isAdaptive() ||
            !shown().has(*rows[i].setup.method))
            continue;
        const double h = rows[i].setup.step.h;
        spots.push_back({i, {h, rows[i].error}, line});
        all.push_back(rows[i].error);
        finest = std::min(finest, h);
        coarsest = std::max(coarsest, h);
    }
    setErrors(errorScale(all, 8.0, axisRect()->height()));
    for (Spot &spot : spots)
        spot.place.setY(errors().place(spot.place.y()));
    if (!spots.empty()) {
        const double inner = std::max(80.0, axisRect()->width() - orderNameRoom - 24.0);
        const double decades = std::max(0.3, std::log10(coarsest / finest)) / inner; // a px
        xAxis->setRange(finest * std::pow(10.0, -orderNameRoom * decades),
                        coarsest * std::pow(10.0, 24.0 * decades));
    }
    return spots;
}

void OrderPlot::drawStated(QPainter &painter, const Spot &from, const Spot &to) const
{
    const int order = rowOf(from).setup.method->order();
    painter.setPen(dotted(inkOf(from).color, 1.2));
    const double ratio = to.place.x() / from.place.x();
    painter.drawLine(onScreen(from),
                     onScreen(QPointF(to.place.x(), from.place.y() * std::pow(ratio, order))));
}

AxisNames OrderPlot::axisNames() const
{
    return {tr("step, frames (finer →)"), largestError(), {}, {}};
}

QString OrderPlot::nameOf(const sim::Method &method) const
{
    return orderWords(*m_study.accuracy(), method);
}

void OrderPlot::drawLines(QPainter &painter)
{
    painter.setClipRect(QRectF(axisRect()->rect()).adjusted(-6.0, 0.0, 6.0, 0.0));
    for (const Line &line : lines()) {
        const MethodColors ink = inkOf(*line.front());
        if (rowOf(*line.front()).error > 0.0)
            drawStated(painter, *line.front(), *line.back());
        painter.setPen(QPen(ink.color, 1.8));
        painter.drawPolyline(onScreen(line));
        for (const Spot *spot : line) {
            drawMarker(painter, onScreen(*spot), ink, markerSize(), m_theme.tokens().panel);
            if (rowOf(*spot).error == 0.0)
                drawZeroBar(painter, onScreen(*spot), ink, markerSize());
        }
    }
}

void OrderPlot::drawOver(QPainter &painter)
{
    if (const Spot *used = spotInUse())
        drawRing(painter, onScreen(*used), QPen(m_theme.tokens().now, 2.5), markerSize());
}

QString OrderPlot::tipOf(const Spot &spot) const
{
    QString text = rowWords(rowOf(spot));
    const sim::Method &method = *rowOf(spot).setup.method;
    for (const Slope &slope : slopesOf(*m_study.accuracy(), method)) {
        if (slope.fine != &rowOf(spot))
            continue;
        const double times = slope.coarse->setup.step.h / slope.fine->setup.step.h;
        text += '\n' +
                tr("A step %1 times as short makes the error %2 times as small: order %3 here, %4 expected")
                    .arg(roughNumber(times), roughNumber(slope.coarse->error / slope.fine->error),
                         fixedNumber(slope.order, 2))
                    .arg(method.order());
    }
    return text;
}

}
