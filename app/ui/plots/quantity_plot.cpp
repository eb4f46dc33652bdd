#include "app/ui/plots/quantity_plot.h"

#include "app/model/quantity_words.h"
#include "app/ui/plots/dashed_curve.h"
#include "app/ui/plots/number_ticker.h"
#include "app/ui/theme/plot_axes.h"
#include "sim/run/script/composed_interval.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace app {

namespace {

constexpr double curveWidth = 1.6;  ///< px
constexpr double thickWidth = 3.2;  ///< px
constexpr double ghostWidth = 1.5;  ///< px
constexpr double dash = 4.5;        ///< px
constexpr double paleFuture = 0.35; ///< how much of its colour a curve has after the cursor
const QMargins besideTime(54, 22, 14, 24);
const QMargins besideQuantity(54, 22, 16, 42); ///< with a name below the axis
constexpr double noise = 1e-12; ///< of the numbers on the axis: less than this is rounding, and shown as 0,
constexpr double surelyNoise = 1e-9; ///< but no more than this, however far an old run flew off
const char *const curveLayer = "curves";
const char *const ghostLayer = "ghost"; ///< below it: the old run stays as it is where the cursor moves

double withoutNoise(double value, const PlotRange &range)
{
    const double largest = std::max(std::abs(range.low), std::abs(range.high));
    return std::abs(value) < std::min(noise * largest, surelyNoise) ? 0.0 : value;
}

}

QuantityPlot::QuantityPlot(Session &session, const PlotCourse &course, const Theme &theme, QWidget *parent)
    : CursorPlot(session, theme, parent), m_course(course)
{
    setObjectName("quantityPlot");
    addLayer(ghostLayer, layer("main"), limAbove);
    addLayer(curveLayer, layer(ghostLayer), limAbove);
    for (const char *buffered : {ghostLayer, curveLayer})
        layer(buffered)->setMode(QCPLayer::lmBuffered);
    xAxis->setTicker(QSharedPointer<QCPAxisTicker>(new NumberTicker(5)));
    yAxis->setTicker(QSharedPointer<QCPAxisTicker>(new NumberTicker(4)));
    axisRect()->setAutoMargins(QCP::msNone);
    m_ghost = onLayer(ghostLayer, {new DashedGraph(xAxis, yAxis), new DashedCurve(xAxis, yAxis)});
    for (Curve *curve : {&m_future, &m_past})
        *curve = onLayer(curveLayer, {new QCPGraph(xAxis, yAxis), new QCPCurve(xAxis, yAxis)});
    connect(&theme, &Theme::changed, this, &QuantityPlot::dress);
    dress();
}

QuantityPlot::Curve QuantityPlot::onLayer(const char *name, Curve curve)
{
    curve.graph->setLayer(name);
    curve.curve->setLayer(name);
    return curve;
}

void QuantityPlot::setPen(const Curve &curve, const QPen &pen)
{
    curve.graph->setPen(pen);
    curve.curve->setPen(pen);
}

void QuantityPlot::dress()
{
    const Tokens &t = m_theme.tokens();
    setBackground(t.panel);
    dressAxis(*xAxis, m_theme);
    dressAxis(*yAxis, m_theme);
    dressCurves();
    m_axesAreOld = true;
    update();
}

void QuantityPlot::setPointedBody(const QString &body)
{
    const auto isOfIt = [&](const Quantity &one) {
        return !body.isEmpty() && m_course.bound(one).body == body;
    };
    const bool isThick = isOfIt(m_spec.up) || isOfIt(m_spec.across);
    if (isThick == std::exchange(m_isThick, isThick))
        return;
    dressCurves();
    layer(curveLayer)->replot();
    ++m_curvesPainted;
}

void QuantityPlot::dressCurves()
{
    const Tokens &t = m_theme.tokens();
    const double width = m_isThick ? thickWidth : curveWidth;
    setPen(m_past, curvePen(t.body, width));
    setPen(m_future, curvePen(faint(t.body, paleFuture, t.panel), width));
    setPen(m_ghost, dashedPen(t.ghost, ghostWidth, dash));
}

void QuantityPlot::setSpec(const PlotSpec &spec)
{
    if (spec == m_spec && !m_axesAreOld)
        return;
    m_spec = spec;
    axisRect()->setMargins(spec.isAgainstTime() ? besideTime : besideQuantity);
    yAxis->setRangeReversed(pointsDown(spec.up.what));
    m_upRange = m_acrossRange = {};
    m_axesAreOld = true;
}

QString QuantityPlot::unit(const Quantity &quantity) const
{
    return unitOf(quantity.what, m_session.timeline().state().spin.rows() > 0);
}

QString QuantityPlot::title() const
{
    return tr("%1 against %2")
        .arg(quantityTitle(m_course.bound(m_spec.up)), quantityTitle(m_course.bound(m_spec.across)));
}

QString QuantityPlot::readout(double up, double across) const
{
    const QString first = valueWords(withoutNoise(up, m_upRange), unit(m_spec.up));
    if (m_spec.isAgainstTime())
        return first;
    return tr("%1 at %2").arg(first, valueWords(withoutNoise(across, m_acrossRange), unit(m_spec.across)));
}

QString QuantityPlot::exactText() const
{
    return valueText().isEmpty() ? QString() : valueWords(reading().up, unit(m_spec.up));
}

QString QuantityPlot::valueText() const
{
    return m_empty.isEmpty() || std::isfinite(reading().up) ? readout(reading().up, reading().across)
                                                            : QString();
}

QString QuantityPlot::sentence() const
{
    if (!m_empty.isEmpty())
        return tr("%1. %2").arg(title(), m_empty);
    const std::int64_t frame = m_session.timeline().cursor().frame;
    return (m_inside ? tr("%1: %2 inside frame %3") : tr("%1: %2 at frame %3"))
        .arg(title(), valueText())
        .arg(frame);
}

QString QuantityPlot::whyEmpty() const
{
    const sim::Scene &scene = m_session.timeline().track().interval().scene;
    for (const Quantity &one : {m_course.bound(m_spec.up), m_course.bound(m_spec.across)}) {
        if (const std::optional<NoValue> why = whyNot(one, scene))
            return noValueWords(one, scene, *why);
    }
    if (m_session.timeline().computed() == 0)
        return tr("Play, or step a frame: then a curve begins here.");
    return {};
}

QuantityPlot::Spot QuantityPlot::spotOf(const std::vector<double> &numbers, double time) const
{
    const auto valueAt = [&numbers](std::size_t column) {
        return column < numbers.size() ? numbers[column] : std::numeric_limits<double>::quiet_NaN();
    };
    return {valueAt(m_up), m_spec.isAgainstTime() ? time : valueAt(m_across)};
}

void QuantityPlot::refresh(const std::vector<double> &begun, const std::optional<PlotCourse::Inside> &inside)
{
    const std::int64_t at = m_session.timeline().cursor().frame;
    m_up = m_course.columnOf(m_spec.up);
    m_across = m_course.columnOf(m_spec.across);
    m_now = spotOf(begun, static_cast<double>(at));
    m_inside = inside ? std::optional(spotOf(inside->values, inside->time)) : std::nullopt;
    m_empty = whyEmpty();
    const bool isGhostRead = m_drawnGhost != m_course.ghostRevision();
    const bool isChanged = m_drawn != m_course.revision() || m_drawnAt != at;
    m_drawnGhost = m_course.ghostRevision();
    m_drawn = m_course.revision();
    m_drawnAt = at;
    if (isGhostRead || m_axesAreOld)
        fillGhost();
    if (isChanged || m_axesAreOld)
        fillCurves();
    draw(isChanged, isGhostRead);
    announce();
}

void QuantityPlot::draw(bool curves, bool ghost)
{
    const bool isRescaled = fitAxes();
    if (std::exchange(m_axesAreOld, false) || isRescaled) {
        replot(QCustomPlot::rpQueuedRefresh);
        ++m_axesPainted;
        ++m_curvesPainted;
        ++m_ghostsPainted;
        return;
    }
    if (ghost) {
        layer(ghostLayer)->replot();
        ++m_ghostsPainted;
    }
    if (curves) {
        layer(curveLayer)->replot();
        ++m_curvesPainted;
    } else {
        update();
    }
}

void QuantityPlot::fitAxis(QCPAxis &axis, PlotRange &range, std::size_t column)
{
    double low = std::numeric_limits<double>::infinity(), high = -low;
    const auto take = [&](double least, double most) {
        low = std::fmin(low, least);
        high = std::fmax(high, most);
    };
    for (const Samples *samples : {&m_course.run(), &m_course.ghost()}) {
        for (std::size_t i = 0; column < samples->columns() && i < samples->size(); ++i)
            take(samples->at(i, column).low, samples->at(i, column).high);
    }
    for (const Spot *spot : {&m_now, m_inside ? &*m_inside : &m_now}) {
        const double now = column == m_up ? spot->up : spot->across;
        if (std::isfinite(now))
            take(now, now);
    }
    if (!(low <= high) || !std::isfinite(high - low))
        return;
    range = rangeAfter(range, low, high);
    axis.setRange(range.low, range.high);
}

bool QuantityPlot::fitAxes()
{
    const QCPRange across = xAxis->range(), up = yAxis->range();
    fitAxis(*yAxis, m_upRange, m_up);
    if (m_spec.isAgainstTime())
        xAxis->setRange(static_cast<double>(m_course.window().first),
                        static_cast<double>(m_course.window().last));
    else
        fitAxis(*xAxis, m_acrossRange, m_across);
    keepShape();
    return xAxis->range() != across || yAxis->range() != up;
}

/// A path is seen as it is in the picture: as many px up as across.
void QuantityPlot::keepShape()
{
    const bool isPath = m_spec.up.what == Measured::placeY && m_spec.across.what == Measured::placeX;
    const QRect area = axisRect()->rect();
    if (!isPath || area.isEmpty())
        return;
    const double upScale = m_upRange.high - m_upRange.low,
                 acrossScale = m_acrossRange.high - m_acrossRange.low;
    const double scale = std::max(upScale / area.height(), acrossScale / area.width());
    const auto widen = [scale](QCPAxis &axis, const PlotRange &range, int pixels) {
        const double middle = 0.5 * (range.low + range.high), half = 0.5 * scale * pixels;
        axis.setRange(middle - half, middle + half);
    };
    widen(*xAxis, m_acrossRange, area.width());
    widen(*yAxis, m_upRange, area.height());
}

void QuantityPlot::fill(const Curve &curve, const Samples &samples, std::size_t first, std::size_t last)
{
    const bool isGraph = m_spec.isAgainstTime();
    QVector<QCPGraphData> points;
    QVector<QCPCurveData> places;
    const bool isThere = m_empty.isEmpty() && m_up < samples.columns() && m_across < samples.columns();
    for (std::size_t i = first; isThere && i <= last && i < samples.size(); ++i) {
        const auto frame = static_cast<double>(samples.frameOf(i));
        const Samples::Bucket &up = samples.at(i, m_up);
        if (!isGraph) {
            places.append({frame, samples.at(i, m_across).first, up.first});
            continue;
        }
        points.append({frame, samples.stride() > 1 ? up.low : up.first});
        if (samples.stride() > 1)
            points.append({frame, up.high});
    }
    curve.graph->data()->set(points, true);
    curve.curve->data()->set(places, true);
}

void QuantityPlot::fillCurves()
{
    const Samples &run = m_course.run();
    const std::size_t end = run.isEmpty() ? 0 : run.size() - 1;
    const std::int64_t at = m_session.timeline().cursor().frame;
    const std::size_t here = run.isEmpty() || at < run.firstFrame() ? 0 : run.bucketNear(at);
    fill(m_past, run, 0, here);
    fill(m_future, run, here, here < end ? end : 0);
}

void QuantityPlot::fillGhost()
{
    const Samples &ghost = m_course.ghost();
    fill(m_ghost, ghost, 0, ghost.isEmpty() ? 0 : ghost.size() - 1);
}

}
