#include "app/ui/measure/work_precision_plot.h"

#include "app/model/accuracy_words.h"
#include "app/ui/measure/plot_marks.h"

#include <algorithm>
#include <cmath>

namespace app {

namespace {

using sim::Outcome;

constexpr double markerSize = 9.0;
constexpr double mostShown = 1e4;    ///< px: larger errors are at the upper edge
constexpr double leastShown = 1e-15; ///< px: smaller ones at the lower edge
constexpr double nameRoom = 128.0;   ///< px right of the last marker
constexpr double grip = 7.0;         ///< px round the target line in which it is taken

double shownError(const sim::AccuracyRow &row)
{
    return std::clamp(row.error, leastShown, mostShown);
}

}

WorkPrecisionPlot::WorkPrecisionPlot(AccuracyStudy &study, const Theme &theme, QWidget *parent)
    : SpotPlot(study, theme, parent)
{
    setObjectName("workPrecision");
    setAccessibleName(tr("Error against time"));
    makeLogarithmic(*xAxis, PowerTicker::Writing::plain);
    makeLogarithmic(*yAxis, PowerTicker::Writing::powers);
    xAxis->setRange(0.01, 100.0);
    yAxis->setRange(1e-9, 100.0);
}

void WorkPrecisionPlot::setTarget(double target)
{
    target = std::clamp(target, leastTarget, mostTarget);
    if (target == m_target)
        return;
    m_target = target;
    refresh();
    emit targetChanged();
}

double WorkPrecisionPlot::costOf(const sim::AccuracyRow &row) const
{
    return m_timed ? row.nsPerFrame / 1e3 : row.evaluations;
}

/// An unstable rung was not timed: its cost follows from that of the next finer one that was.
double WorkPrecisionPlot::unstableCost(std::size_t row) const
{
    const std::vector<sim::AccuracyRow> &rows = m_study.accuracy()->rows;
    const sim::Way &way = rows[row].way;
    for (std::size_t i = row + 1; i < rows.size() && rows[i].way.method->id() == way.method->id(); ++i) {
        if (costOf(rows[i]) > 0.0 && !way.step.adaptive())
            return costOf(rows[i]) * rows[i].way.step.h / way.step.h;
    }
    return costOf(rows[row]);
}

std::vector<SpotPlot::Spot> WorkPrecisionPlot::layOut()
{
    const std::vector<sim::AccuracyRow> &rows = m_study.accuracy()->rows;
    bool any = false;
    bool all = true;
    for (const sim::AccuracyRow &row : rows) {
        any |= row.outcome == Outcome::measured;
        all &= row.outcome != Outcome::measured || row.nsPerFrame > 0.0;
    }
    m_timed = any && all;
    std::vector<Spot> spots;
    int line = -1;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        if (i == 0 || rows[i].way.method->id() != rows[i - 1].way.method->id())
            ++line;
        if (rows[i].outcome == Outcome::measured && costOf(rows[i]) > 0.0)
            spots.push_back({i, {costOf(rows[i]), shownError(rows[i])}, line});
    }
    double low = 1e300, high = 0.0, cheap = 1e300, dear = 0.0;
    for (const Spot &spot : spots) {
        low = std::min(low, spot.place.y());
        high = std::max(high, spot.place.y());
        cheap = std::min(cheap, spot.place.x());
        dear = std::max(dear, spot.place.x());
    }
    if (!spots.empty()) {
        yAxis->setRange(std::min(low, m_target) / 4.0, std::max(high, m_target) * 30.0);
        const double inner = std::max(80.0, axisRect()->width() - nameRoom - 24.0);
        const double decades = std::max(0.3, std::log10(dear / cheap)) / inner; // a px
        xAxis->setRange(cheap * std::pow(10.0, -24.0 * decades), dear * std::pow(10.0, nameRoom * decades));
    }
    m_top = yAxis->range().upper / std::pow(yAxis->range().upper / yAxis->range().lower, 0.06);
    for (std::size_t i = 0; i < rows.size() && !spots.empty(); ++i) {
        if (rows[i].outcome != Outcome::unstable)
            continue;
        const double cost = unstableCost(i);
        spots.push_back(
            {i, {std::clamp(cost, xAxis->range().lower * 1.1, xAxis->range().upper), m_top}, line + 1});
    }
    return spots;
}

void WorkPrecisionPlot::draw(QPainter &painter)
{
    const QRectF area = axisRect()->rect();
    drawAxisNames(painter, area,
                  m_timed ? tr("time, µs a frame") : tr("forces computed a frame (times come next)"),
                  tr("error, px"), m_theme);
    if (spots().empty())
        return;
    painter.save();
    painter.setClipRect(area.adjusted(-6.0, -6.0, 6.0, 6.0));
    drawFront(painter);
    drawTarget(painter);
    drawWhiskers(painter);
    drawLadders(painter);
    drawUnstable(painter);
    painter.restore();
    drawNames(painter);
    drawHere(painter);
    if (chosen())
        drawRing(painter, onScreen(*chosen()), QPen(m_theme.tokens().ink, 2.0), markerSize);
}

void WorkPrecisionPlot::drawFront(QPainter &painter) const
{
    if (!m_timed)
        return;
    QPolygonF front;
    for (const Spot &spot : spots()) {
        if (rowOf(spot).front)
            front << onScreen(spot);
    }
    std::sort(front.begin(), front.end(), [](QPointF a, QPointF b) { return a.x() < b.x(); });
    QColor pale = m_theme.tokens().ink;
    pale.setAlphaF(0.2F);
    painter.setPen(QPen(pale, 9.0, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPolyline(front);
}

void WorkPrecisionPlot::drawWhiskers(QPainter &painter) const
{
    if (!m_timed)
        return;
    for (const Spot &spot : spots()) {
        const sim::AccuracyRow &row = rowOf(spot);
        if (row.outcome != Outcome::measured || row.spread <= 0.0)
            continue;
        painter.setPen(QPen(inkOf(*row.way.method, m_theme).color, 1.0));
        const double y = onScreen(spot).y();
        const double left = xAxis->coordToPixel(std::max(1e-6, (row.nsPerFrame - row.spread) / 1e3));
        const double right = xAxis->coordToPixel((row.nsPerFrame + row.spread) / 1e3);
        painter.drawLine(QPointF(left, y), QPointF(right, y));
        for (const double x : {left, right})
            painter.drawLine(QPointF(x, y - 3.0), QPointF(x, y + 3.0));
    }
}

void WorkPrecisionPlot::drawLadders(QPainter &painter) const
{
    const Spot *before = nullptr;
    for (const Spot &spot : spots()) {
        if (rowOf(spot).outcome != Outcome::measured)
            continue;
        if (before && before->line == spot.line) {
            painter.setPen(QPen(inkOf(*rowOf(spot).way.method, m_theme).color, 1.8));
            painter.drawLine(onScreen(*before), onScreen(spot));
        }
        before = &spot;
    }
    for (const Spot &spot : spots()) {
        const sim::AccuracyRow &row = rowOf(spot);
        const MethodInk ink = inkOf(*row.way.method, m_theme);
        if (row.outcome == Outcome::measured)
            drawMarker(painter, onScreen(spot), ink, markerSize,
                       row.front ? ink.color : m_theme.tokens().panel);
    }
}

void WorkPrecisionPlot::drawNames(QPainter &painter) const
{
    std::map<int, const Spot *> ends;
    for (const Spot &spot : spots()) {
        if (rowOf(spot).outcome == Outcome::measured)
            ends[spot.line] = &spot;
    }
    std::vector<EndLabel> labels;
    for (const auto &[line, spot] : ends) {
        const sim::Method &method = *rowOf(*spot).way.method;
        labels.push_back({onScreen(*spot), methodTitle(method), inkOf(method, m_theme).color});
    }
    drawEndLabels(painter, std::move(labels), m_theme.ui(12, QFont::Medium), axisRect()->rect(),
                  m_theme.tokens().panel);
}

void WorkPrecisionPlot::drawUnstable(QPainter &painter) const
{
    for (const Spot &spot : spots()) {
        const sim::AccuracyRow &row = rowOf(spot);
        if (row.outcome != Outcome::unstable)
            continue;
        const QPointF at = onScreen(spot);
        painter.setPen(QPen(inkOf(*row.way.method, m_theme).color, 2.2, Qt::SolidLine, Qt::RoundCap));
        painter.drawLine(at - QPointF(4.0, 4.0), at + QPointF(4.0, 4.0));
        painter.drawLine(at - QPointF(4.0, -4.0), at + QPointF(4.0, -4.0));
    }
}

QRectF WorkPrecisionPlot::targetHandle() const
{
    const QString text = pixels(m_target) + QStringLiteral(" ⇅");
    const double width = QFontMetricsF(m_theme.ui(12)).horizontalAdvance(text) + 14.0;
    const QRectF area = axisRect()->rect();
    return {area.right() - width, yAxis->coordToPixel(m_target) - 24.0, width, 20.0};
}

void WorkPrecisionPlot::drawTarget(QPainter &painter) const
{
    const Tokens &t = m_theme.tokens();
    const QRectF area = axisRect()->rect();
    const double y = yAxis->coordToPixel(m_target);
    QPen pen(t.ink2, 1.5, Qt::CustomDashLine, Qt::FlatCap);
    pen.setDashPattern({1.5, 3.0});
    painter.setPen(pen);
    painter.drawLine(QPointF(area.left(), y), QPointF(area.right(), y));
    const QRectF handle = targetHandle();
    painter.setPen(QPen(t.line2, 1.0));
    painter.setBrush(t.panel);
    painter.drawRoundedRect(handle, 4.0, 4.0);
    painter.setFont(m_theme.ui(12));
    painter.setPen(t.ink);
    painter.drawText(handle, Qt::AlignCenter, pixels(m_target) + QStringLiteral(" ⇅"));
    painter.setBrush(Qt::NoBrush);
}

void WorkPrecisionPlot::drawHere(QPainter &painter) const
{
    const sim::AccuracyRow *used = m_study.inUse();
    const auto here =
        std::find_if(spots().begin(), spots().end(), [&](const Spot &spot) { return &rowOf(spot) == used; });
    if (here == spots().end())
        return;
    const Tokens &t = m_theme.tokens();
    const QPointF at = onScreen(*here);
    drawRing(painter, at, QPen(t.now, 2.5), markerSize);
    const QString text = tr("you are here");
    painter.setFont(m_theme.ui(12, QFont::DemiBold));
    const QRectF area = axisRect()->rect();
    QRectF tag(0.0, 0.0, QFontMetricsF(painter.font()).horizontalAdvance(text) + 14.0, 20.0);
    tag.moveTo(std::max(area.left() + 2.0, at.x() - tag.width() / 2.0), at.y() + 13.0);
    if (tag.bottom() > area.bottom())
        tag.moveBottom(at.y() - 13.0);
    painter.setPen(Qt::NoPen);
    painter.setBrush(t.now);
    painter.drawRoundedRect(tag, 4.0, 4.0);
    painter.setPen(t.nowText);
    painter.drawText(tag, Qt::AlignCenter, text);
    painter.setBrush(Qt::NoBrush);
}

bool WorkPrecisionPlot::press(QPointF at)
{
    const QRectF area = axisRect()->rect();
    return targetHandle().contains(at) ||
           (area.contains(at) && std::abs(at.y() - yAxis->coordToPixel(m_target)) < grip);
}

void WorkPrecisionPlot::drag(QPointF at)
{
    setTarget(std::clamp(yAxis->pixelToCoord(at.y()), yAxis->range().lower, yAxis->range().upper));
}

void WorkPrecisionPlot::drop()
{
    // Two digits: what the handle says is what is meant.
    const double power = std::pow(10.0, std::floor(std::log10(m_target)) - 1.0);
    setTarget(std::round(m_target / power) * power);
}

bool WorkPrecisionPlot::wantsKey(const QKeyEvent &event) const
{
    return event.key() == Qt::Key_Plus || event.key() == Qt::Key_Minus || event.key() == Qt::Key_Equal;
}

bool WorkPrecisionPlot::key(const QKeyEvent &event)
{
    if (!wantsKey(event))
        return false;
    // 1, 2, 5, 10, 20...: as a dial clicks.
    const double exponent = std::log10(m_target);
    const int up = event.key() == Qt::Key_Minus ? -1 : 1;
    const double third = std::round(exponent * 3.0) + up;
    const double rough = std::pow(10.0, third / 3.0);
    const double power = std::pow(10.0, std::floor(std::log10(rough) + 1e-9));
    setTarget(std::round(rough / power) * power);
    return true;
}

Qt::CursorShape WorkPrecisionPlot::cursorAt(QPointF at) const
{
    const double y = yAxis->coordToPixel(m_target);
    const bool isLine = axisRect()->rect().contains(at.toPoint()) && std::abs(at.y() - y) < grip;
    return isLine || targetHandle().contains(at) ? Qt::SizeVerCursor : Qt::ArrowCursor;
}

}
