#include "app/ui/parameters/measure_row.h"

#include "app/model/text/numbers.h"
#include "sim/run/script/composed_interval.h"

#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <cmath>
#include <limits>

namespace app {

namespace {

constexpr int margin = 16;
constexpr int nameWidth = 148; ///< px: "Quantité de mouvement" fits
constexpr int numberWidth = 64;
constexpr std::int64_t leastOutputSteps = 60;
constexpr int measureUnitWidth = 90; ///< px: "por fotograma" and "px/fotograma²" fit

/// The range of values of a time series.
struct Span
{
    double low = 0.0;
    double high = 0.0;

    void take(double value)
    {
        low = std::min(low, value);
        high = std::max(high, value);
    }
};

}

MeasureRow::MeasureRow(const OpenRun &run, const Preview &preview, const MeasureSeries &series,
                       std::size_t index, const Theme &theme, QWidget *parent)
    : QWidget(parent), m_run(run), m_preview(preview), m_series(series), m_index(index),
      m_measure(run.step().measures[index]), m_theme(theme), m_value(std::numeric_limits<double>::quiet_NaN())
{
    setFixedHeight(height);
    setToolTip(m_measure.help);
    setAccessibleName(m_measure.name);
    refresh();
}

double MeasureRow::valueAt(std::int64_t frame) const
{
    const Sample *sample = m_series.at(frame);
    return sample && m_index < sample->measures.size() ? sample->measures[m_index]
                                                       : std::numeric_limits<double>::quiet_NaN();
}

double MeasureRow::valueNow() const
{
    const sim::Timeline &run = m_run.timeline();
    if (m_preview.isActive() || run.cursor().phase == 0 || !m_measure.of)
        return valueAt(m_preview.run().cursor().frame);
    // Inside a frame the measure uses the current partial state and the state at the start of the frame.
    const sim::State begun = run.track().stateAt(run.cursor().frame);
    const sim::ComposedInterval &interval = run.track().interval();
    return begun.pointCount() == run.state().pointCount()
               ? m_measure.of(interval.scene, run.state(), &begun, interval.values)
               : valueAt(run.cursor().frame);
}

QString MeasureRow::number() const
{
    return std::isfinite(m_value) ? fixedNumber(m_value, m_measure.decimals) : QStringLiteral("–");
}

void MeasureRow::refresh()
{
    m_value = valueNow();
    setAccessibleDescription(QStringLiteral("%1 %2. %3").arg(number(), m_measure.unit, m_measure.help));
    update();
}

void MeasureRow::paintSeries(QPainter &painter, const QRectF &area) const
{
    const std::int64_t at = m_run.timeline().cursor().frame;
    const std::int64_t step = m_series.framesPerOutput();
    // The cursor stays at the right end while the run grows, and moves into the plot when the learner goes
    // back.
    const std::int64_t end = std::clamp(at + mostOutputSteps / 4 * step, std::int64_t{0},
                                        std::max<std::int64_t>(m_series.isEmpty() ? 0 : m_series.last(), at));
    const std::int64_t start = std::max<std::int64_t>(0, end - mostOutputSteps * step);
    Span span;
    for (std::int64_t frame = start; frame <= end; frame += step) {
        const double value = valueAt(frame);
        if (std::isfinite(value))
            span.take(value);
    }
    if (span.high - span.low < 1e-12)
        span.high = span.low + 1.0;
    // A short run also fills the width.
    const std::int64_t shown =
        std::clamp<std::int64_t>(end - start, leastOutputSteps * step, mostOutputSteps * step);
    const auto xOf = [&](std::int64_t frame) {
        return area.left() + area.width() * double(frame - start) / double(shown);
    };
    const auto yOf = [&](double value) {
        return area.bottom() - area.height() * (value - span.low) / (span.high - span.low);
    };
    painter.setPen(QPen(m_theme.tokens().line2, 1.0));
    painter.drawLine(QPointF(area.left(), yOf(0.0)), QPointF(area.right(), yOf(0.0)));
    QPainterPath path;
    bool open = false;
    for (std::int64_t frame = start; frame <= end; frame += step) {
        const double value = valueAt(frame);
        const bool isThere = std::isfinite(value);
        if (isThere && open)
            path.lineTo(xOf(frame), yOf(value));
        else if (isThere)
            path.moveTo(xOf(frame), yOf(value));
        open = isThere;
    }
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(m_theme.tokens().ink2, 1.5));
    painter.drawPath(path);
    const auto dot = [&](std::int64_t frame) {
        const double value = valueAt(frame);
        if (std::isfinite(value) && frame >= start && frame <= end)
            painter.drawEllipse(QPointF(xOf(frame), yOf(value)), 3.0, 3.0);
    };
    painter.setPen(Qt::NoPen);
    painter.setBrush(m_theme.tokens().now);
    dot(at);
    if (!m_preview.isActive())
        return;
    painter.setPen(QPen(m_theme.tokens().ink2, 1.5));
    painter.setBrush(m_theme.tokens().panel);
    dot(m_preview.run().cursor().frame);
}

void MeasureRow::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF all(margin, 0, width() - 2.0 * margin, height);
    painter.setFont(m_theme.ui());
    painter.setPen(m_theme.tokens().ink2);
    const QString name = QFontMetrics(m_theme.ui()).elidedText(m_measure.name, Qt::ElideRight, nameWidth);
    painter.drawText(QRectF(all.left(), 0, nameWidth, height), Qt::AlignVCenter | Qt::AlignLeft, name);
    const QRectF unit(all.right() - measureUnitWidth, 0, measureUnitWidth, height);
    painter.setFont(m_theme.ui(12));
    painter.setPen(m_theme.tokens().ink3);
    painter.drawText(
        unit.adjusted(6, 0, 0, 0), Qt::AlignVCenter | Qt::AlignLeft,
        QFontMetrics(m_theme.ui(12)).elidedText(m_measure.unit, Qt::ElideRight, measureUnitWidth - 6));
    painter.setFont(m_theme.mono(12));
    painter.setPen(m_theme.tokens().ink);
    const QRectF figures(unit.left() - numberWidth, 0, numberWidth, height);
    painter.drawText(figures, Qt::AlignVCenter | Qt::AlignRight, number());
    const QRectF area(all.left() + nameWidth + 8, 6, figures.left() - all.left() - nameWidth - 16,
                      height - 12.0);
    if (area.width() > 24.0)
        paintSeries(painter, area);
}

}
