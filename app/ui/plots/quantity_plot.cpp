#include "app/ui/plots/quantity_plot.h"

#include "app/model/text/phrases.h"
#include "app/model/text/quantity_text.h"
#include "app/ui/plots/dashed_curve.h"
#include "app/ui/theme/colors.h"
#include "sim/run/script/composed_interval.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace app {

namespace {

constexpr double curveWidth = 1.6;      ///< px
constexpr double thickWidth = 3.2;      ///< px
constexpr double comparisonWidth = 1.5; ///< px
constexpr double dash = 4.5;            ///< px
constexpr double paleFuture = 0.35;     ///< the share of its colour that a curve has after the cursor
constexpr double nearEnough = 28.0;     ///< px from the curve of a plot without time
constexpr double notch = 120.0;         ///< of the wheel
constexpr int betweenTicks = 36;        ///< px, about; across, twice that
constexpr int emptyWidth = 420;         ///< px: longer lines are hard to read
const QMargins besideTime(54, 22, 14, 24);
const QMargins besideQuantity(54, 22, 16, 42); ///< with a name below the axis
constexpr double noise =
    1e-12; ///< of the numbers on the axis: smaller values are rounding errors, shown as 0
constexpr double mostNoise =
    1e-9; ///< larger values never are, even if the comparison run has very large numbers
const char *const curveLayer = "curves";
const char *const comparisonLayer =
    "comparison"; ///< of its own, because it stays as it is when the cursor moves

double withoutNoise(double value, const PlotRange &range)
{
    const double largest = std::max(std::abs(range.low), std::abs(range.high));
    return std::abs(value) < std::min(noise * largest, mostNoise) ? 0.0 : value;
}

bool isZoomIn(int key)
{
    return key == Qt::Key_Plus || key == Qt::Key_Equal;
}

}

QuantityPlot::QuantityPlot(const OpenRun &run, Playback &playback, const PlotSeries &series,
                           const Theme &theme, QWidget *parent)
    : CursorPlot(run, playback, theme, parent), m_series(series)
{
    setObjectName("quantityPlot");
    addLayer(comparisonLayer, layer("main"), limAbove);
    addLayer(curveLayer, layer(comparisonLayer), limAbove);
    for (const char *buffered : {comparisonLayer, curveLayer})
        layer(buffered)->setMode(QCPLayer::lmBuffered);
    axisRect()->setAutoMargins(QCP::msNone);
    m_comparison = onLayer(comparisonLayer, {new DashedGraph(xAxis, yAxis), new DashedCurve(xAxis, yAxis)});
    for (Curve *curve : {&m_future, &m_past})
        *curve = onLayer(curveLayer, {new QCPGraph(xAxis, yAxis), new QCPCurve(xAxis, yAxis)});
    applyTheme();
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

void QuantityPlot::applyTheme()
{
    CursorPlot::applyTheme();
    setPens();
    m_axesAreOld = true;
    update();
}

void QuantityPlot::setPointedBody(const QString &body)
{
    const auto shows = [&](const Quantity &one) {
        return !body.isEmpty() && m_series.bound(one).body == body;
    };
    const bool isThick = shows(m_spec.up) || shows(m_spec.across);
    if (isThick == std::exchange(m_isThick, isThick))
        return;
    setPens();
    layer(curveLayer)->replot();
    ++m_curvesPainted;
}

void QuantityPlot::setPens()
{
    const Tokens &t = m_theme.tokens();
    const double width = m_isThick ? thickWidth : curveWidth;
    setPen(m_past, curvePen(t.body, width));
    setPen(m_future, curvePen(mixed(t.panel, t.body, paleFuture), width));
    setPen(m_comparison, dashedPen(t.ghost, comparisonWidth, dash));
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
    return unitOf(quantity.what, m_run.timeline().state().spin.rows() > 0);
}

QString QuantityPlot::title() const
{
    return tr("%1 against %2")
        .arg(quantityTitle(m_series.bound(m_spec.up)), quantityTitle(m_series.bound(m_spec.across)));
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
    return (m_inside ? tr("%1: %2 inside frame %3") : tr("%1: %2 at frame %3"))
        .arg(title(), valueText())
        .arg(cursorFrame());
}

QString QuantityPlot::whyEmpty() const
{
    const sim::Scene &scene = m_run.timeline().track().interval().scene;
    for (const Quantity &one : {m_series.bound(m_spec.up), m_series.bound(m_spec.across)}) {
        if (const std::optional<NoValue> why = whyNot(one, scene))
            return noValueWords(one, scene, *why);
    }
    if (m_run.timeline().computed() == 0)
        return tr("Play, or step one frame, to start a curve here.");
    return {};
}

QuantityPlot::Moment QuantityPlot::momentOf(const std::vector<double> &numbers, double time) const
{
    const auto valueAt = [&numbers](std::size_t column) {
        return column < numbers.size() ? numbers[column] : std::numeric_limits<double>::quiet_NaN();
    };
    return {valueAt(m_up), m_spec.isAgainstTime() ? time : valueAt(m_across)};
}

void QuantityPlot::refresh(const std::vector<double> &begun, const std::optional<PlotSeries::Inside> &inside)
{
    const std::int64_t at = cursorFrame();
    m_up = m_series.columnOf(m_spec.up);
    m_across = m_series.columnOf(m_spec.across);
    m_now = momentOf(begun, static_cast<double>(at));
    m_inside = inside ? std::optional(momentOf(inside->values, inside->time)) : std::nullopt;
    m_empty = whyEmpty();
    const bool isComparisonChanged = m_drawnComparison != m_series.comparisonRevision();
    const bool isChanged = m_drawn != m_series.revision() || m_drawnAt != at;
    m_drawnComparison = m_series.comparisonRevision();
    m_drawn = m_series.revision();
    m_drawnAt = at;
    if (isComparisonChanged || m_axesAreOld)
        fillComparison();
    if (isChanged || m_axesAreOld)
        fillCurves();
    drawCurves(isChanged, isComparisonChanged);
    announceCursor();
}

void QuantityPlot::drawCurves(bool curves, bool comparison)
{
    const bool isRescaled = fitAxes();
    if (std::exchange(m_axesAreOld, false) || isRescaled) {
        replot(QCustomPlot::rpQueuedRefresh);
        ++m_axesPainted;
        ++m_curvesPainted;
        ++m_comparisonsPainted;
        return;
    }
    if (comparison) {
        layer(comparisonLayer)->replot();
        ++m_comparisonsPainted;
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
    for (const Samples *samples : {&m_series.run(), &m_series.comparison()}) {
        for (std::size_t i = 0; column < samples->columns() && i < samples->size(); ++i)
            take(samples->at(i, column).low, samples->at(i, column).high);
    }
    for (const Moment *moment : {&m_now, m_inside ? &*m_inside : &m_now}) {
        const double now = column == m_up ? moment->up : moment->across;
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
        xAxis->setRange(static_cast<double>(m_series.window().first),
                        static_cast<double>(m_series.window().last));
    else
        fitAxis(*xAxis, m_acrossRange, m_across);
    keepShape();
    return xAxis->range() != across || yAxis->range() != up;
}

/// Gives a path, y against x, the shape that it has in the scene: one scale for both axes.
void QuantityPlot::keepShape()
{
    const bool isPath = m_spec.up.what == QuantityKind::placeY && m_spec.across.what == QuantityKind::placeX;
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
    const Samples &run = m_series.run();
    const std::size_t end = run.isEmpty() ? 0 : run.size() - 1;
    const std::int64_t at = cursorFrame();
    const std::size_t here = run.isEmpty() || at < run.firstFrame() ? 0 : run.bucketNear(at);
    fill(m_past, run, 0, here);
    fill(m_future, run, here, here < end ? end : 0);
}

void QuantityPlot::fillComparison()
{
    const Samples &comparison = m_series.comparison();
    fill(m_comparison, comparison, 0, comparison.isEmpty() ? 0 : comparison.size() - 1);
}

bool QuantityPlot::hasCurve() const
{
    const Samples &run = m_series.run();
    return m_empty.isEmpty() && !run.isEmpty() && m_up < run.columns() && m_across < run.columns();
}

std::size_t QuantityPlot::nearestBucket(QPointF where, double &distance) const
{
    const Samples &run = m_series.run();
    std::size_t nearest = 0;
    distance = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < run.size(); ++i) {
        const QPointF off = onScreen({run.at(i, m_across).first, run.at(i, m_up).first}) - where;
        const double length = std::hypot(off.x(), off.y());
        if (length < distance) {
            distance = length;
            nearest = i;
        }
    }
    return nearest;
}

std::optional<std::int64_t> QuantityPlot::frameAt(QPointF where) const
{
    if (!hasCurve())
        return std::nullopt;
    const Samples &run = m_series.run();
    if (!m_spec.isAgainstTime()) {
        double distance = 0.0;
        const std::size_t bucket = nearestBucket(where, distance);
        return distance <= nearEnough || (isDragging() && std::isfinite(distance))
                   ? std::optional(run.frameOf(bucket))
                   : std::nullopt;
    }
    const auto framesPerBucket = static_cast<double>(m_series.framesPerOutput() * run.stride());
    const double frame = xAxis->pixelToCoord(where.x());
    const double first = static_cast<double>(run.firstFrame());
    const auto bucket =
        static_cast<std::int64_t>(std::lround(std::max(0.0, (frame - first) / framesPerBucket)));
    return run.frameOf(
        static_cast<std::size_t>(std::min<std::int64_t>(bucket, static_cast<std::int64_t>(run.size()) - 1)));
}

void QuantityPlot::wheelEvent(QWheelEvent *event)
{
    if (!(event->modifiers() & Qt::ControlModifier)) {
        CursorPlot::wheelEvent(event); // the panel scrolls
        return;
    }
    m_wheel += event->angleDelta().y();
    for (; std::abs(m_wheel) >= notch; m_wheel -= std::copysign(notch, m_wheel))
        emit zoomWanted(m_wheel > 0.0 ? 1 : -1);
    event->accept();
}

bool QuantityPlot::wantsKey(const QKeyEvent &event) const
{
    const bool isOwn = isZoomIn(event.key()) || event.key() == Qt::Key_Minus || event.key() == Qt::Key_Delete;
    return CursorPlot::wantsKey(event) || (isOwn && isPlainKey(event, Qt::ShiftModifier));
}

void QuantityPlot::keyPressEvent(QKeyEvent *event)
{
    if (isZoomIn(event->key()))
        emit zoomWanted(1);
    else if (event->key() == Qt::Key_Minus)
        emit zoomWanted(-1);
    else if (event->key() == Qt::Key_Delete)
        emit removalWanted();
    else
        CursorPlot::keyPressEvent(event);
}

void QuantityPlot::resizeEvent(QResizeEvent *event)
{
    CursorPlot::resizeEvent(event);
    yAxis->ticker()->setTickCount(std::clamp(axisRect()->height() / betweenTicks, 2, 8));
    xAxis->ticker()->setTickCount(std::clamp(axisRect()->width() / (2 * betweenTicks), 2, 12));
    if (fitAxes())
        replot(QCustomPlot::rpQueuedRefresh);
}

QPointF QuantityPlot::placeOf(std::int64_t frame) const
{
    const Samples &run = m_series.run();
    const std::size_t bucket = run.bucketNear(frame);
    return onScreen({run.at(bucket, m_across).first, run.at(bucket, m_up).first});
}

QPointF QuantityPlot::placeOf(const Moment &moment) const
{
    return onScreen({moment.across, moment.up});
}

std::optional<QPointF> QuantityPlot::insidePlace() const
{
    return m_inside ? std::optional(placeOf(*m_inside)) : std::nullopt;
}

void QuantityPlot::paintMarks(QPainter &painter)
{
    if (m_empty.isEmpty())
        paintUnits(painter);
    else
        paintEmpty(painter);
    paintNow(painter);
}

void QuantityPlot::paintUnits(QPainter &painter) const
{
    const QRectF area = axisRect()->rect();
    painter.setFont(m_theme.ui(12));
    painter.setPen(m_theme.tokens().ink3);
    const double line = painter.fontMetrics().height();
    const QString down = pointsDown(m_spec.up.what) ? QStringLiteral(" ↓") : QString();
    painter.drawText(QRectF(6.0, 2.0, area.width(), line), Qt::AlignLeft | Qt::AlignVCenter,
                     unit(m_spec.up) + down);
    if (m_spec.isAgainstTime()) {
        const double labels = area.bottom() + 7.0;
        painter.drawText(QRectF(0.0, labels, area.left() - 12.0, line), Qt::AlignRight | Qt::AlignVCenter,
                         tr("frame"));
        return;
    }
    const QString across = quantityTitle(m_series.bound(m_spec.across));
    painter.drawText(QRectF(area.left(), height() - line - 3.0, area.width(), line),
                     Qt::AlignRight | Qt::AlignVCenter, listed(across, unit(m_spec.across)));
}

void QuantityPlot::paintNow(QPainter &painter) const
{
    const QPointF now = placeOf(m_now);
    if (m_spec.isAgainstTime())
        paintCursor(painter, now.x());
    if (m_inside)
        paintInside(painter, placeOf(*m_inside));
    paintDot(painter, now); // on top: it stays in sight where both are near each other
}

QString QuantityPlot::hoveredText(std::int64_t frame) const
{
    if (!hasCurve())
        return {};
    const Samples &run = m_series.run();
    const std::size_t bucket = run.bucketNear(frame);
    return labelled(frameName(run.frameOf(bucket)),
                    readout(run.at(bucket, m_up).first, run.at(bucket, m_across).first));
}

std::vector<QPointF> QuantityPlot::curvesAt(std::int64_t frame) const
{
    const QPointF dot = hasCurve() ? placeOf(frame) : QPointF(qQNaN(), qQNaN());
    return std::isfinite(dot.x()) ? std::vector{dot} : std::vector<QPointF>{};
}

void QuantityPlot::paintEmpty(QPainter &painter) const
{
    const QRectF area = QRectF(axisRect()->rect()).adjusted(12.0, 8.0, -12.0, -8.0);
    const QRectF room(area.left(), area.top(), std::min<double>(area.width(), emptyWidth), area.height());
    painter.setFont(m_theme.ui(13));
    const QRectF text = painter.fontMetrics().boundingRect(
        room.toRect(), Qt::AlignLeft | Qt::AlignVCenter | Qt::TextWordWrap, m_empty);
    painter.fillRect(text.adjusted(-4.0, -2.0, 4.0, 2.0), m_theme.tokens().panel);
    painter.setPen(m_theme.tokens().ink3);
    painter.drawText(room, Qt::AlignLeft | Qt::AlignVCenter | Qt::TextWordWrap, m_empty);
}

PlotPicture QuantityPlot::picture()
{
    QString name = quantityName(m_series.bound(m_spec.up));
    if (!m_spec.isAgainstTime())
        name += QStringLiteral(" against ") + quantityName(m_series.bound(m_spec.across));
    name.remove(')').replace(QLatin1String(", "), QLatin1String(",")); // "distance-foot-body"
    for (QChar &c : name) { // names of bodies may hold anything; names of files may not
        if (!c.isLetterOrNumber() && c != '_' && c != ' ')
            c = '-';
    }
    return pictureNamed(title(), name);
}

}
