#include "app/ui/accuracy/run_plot.h"

#include "app/model/analysis/accuracy_rows.h"
#include "app/model/text/accuracy_text.h"
#include "app/model/text/phrases.h"

#include <algorithm>
#include <cmath>

namespace app {

namespace {

using sim::AccuracyRow;

constexpr double runNameRoom = 128.0;

double cost(const AccuracyRow &row)
{
    return row.nsPerFrame > 0.0 ? row.nsPerFrame : row.evaluations;
}

/// Returns the ratio of two costs, as a positive logarithm.
double costRatio(const AccuracyRow &a, const AccuracyRow &b)
{
    return cost(a) > 0.0 && cost(b) > 0.0 ? std::abs(std::log(cost(a) / cost(b))) : 1e9;
}

}

RunPlot::RunPlot(AccuracyStudy &study, const Preview &preview, const Theme &theme, QWidget *parent)
    : StudyPlot(study, theme, parent), m_preview(preview)
{
    setObjectName("overTheRun");
    setAccessibleName(tr("Error over the run"));
    study.run().onChange(ChangeKind::cursor | ChangeKind::preview, this, [this] {
        if (isVisible())
            update();
    });
}

std::optional<std::int64_t> RunPlot::frameAt(QPointF place) const
{
    if (!m_study.accuracy() || !QRectF(axisRect()->rect()).contains(place))
        return std::nullopt;
    const auto frame = static_cast<std::int64_t>(std::lround(xAxis->pixelToCoord(place.x())));
    const std::int64_t computed = m_study.run().timeline().computed();
    const bool isThere = frame >= 0 && frame <= std::min<std::int64_t>(computed, m_study.accuracy()->horizon);
    return isThere ? std::optional(frame) : std::nullopt;
}

std::optional<std::int64_t> RunPlot::hovered() const
{
    const std::optional<sim::Cursor> &moment = m_preview.marked();
    if (!m_study.accuracy() || !moment || moment->phase > 0 || moment->frame > m_study.accuracy()->horizon)
        return std::nullopt;
    return moment->frame;
}

void RunPlot::mouseMoveEvent(QMouseEvent *event)
{
    StudyPlot::mouseMoveEvent(event);
    emit pointedAt(frameAt(event->position()));
}

void RunPlot::leaveEvent(QEvent *event)
{
    StudyPlot::leaveEvent(event);
    emit pointedAt(std::nullopt);
}

void RunPlot::chooseRows()
{
    m_rows.clear();
    const std::vector<AccuracyRow> &rows = m_study.accuracy()->rows;
    const AccuracyRow *used = m_study.inUse();
    if (used && used->outcome != sim::Outcome::measured)
        used = nullptr;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        if (rows[i].outcome != sim::Outcome::measured || rows[i].errorAt.size() < 2 ||
            !shown().has(*rows[i].setup.method))
            continue;
        const bool isNew =
            m_rows.empty() || rows[m_rows.back()].setup.method->id() != rows[i].setup.method->id();
        if (isNew)
            m_rows.push_back(i);
        else if (used &&
                 (&rows[i] == used || (&rows[m_rows.back()] != used &&
                                       costRatio(rows[i], *used) < costRatio(rows[m_rows.back()], *used))))
            m_rows.back() = i;
    }
}

std::vector<Spot> RunPlot::layOut()
{
    chooseRows();
    const std::vector<AccuracyRow> &rows = m_study.accuracy()->rows;
    std::vector<double> all;
    for (const std::size_t row : m_rows)
        all.insert(all.end(), rows[row].errorAt.begin() + 1, rows[row].errorAt.end());
    setErrors(errorScale(all, 5.0, axisRect()->height()));
    std::vector<Spot> spots;
    for (std::size_t line = 0; line < m_rows.size(); ++line) {
        const std::vector<double> &ofRow = rows[m_rows[line]].errorAt;
        for (std::size_t frame = 1; frame < ofRow.size(); ++frame)
            spots.push_back({m_rows[line],
                             {static_cast<double>(frame), errors().place(ofRow[frame])},
                             static_cast<int>(line)});
    }
    const double frames = std::max(1.0, static_cast<double>(m_study.accuracy()->horizon));
    const double inner = std::max(80.0, axisRect()->width() - runNameRoom);
    xAxis->setRange(0.0, frames * (1.0 + runNameRoom / inner));
    return spots;
}

AxisNames RunPlot::axisNames() const
{
    return {frameHeading(), tr("error, px"), {}, {}};
}

void RunPlot::drawLines(QPainter &painter)
{
    painter.setClipRect(axisRect()->rect());
    const AccuracyRow *used = m_study.inUse();
    for (const Line &line : lines()) {
        const MethodColors ink = inkOf(*line.back());
        painter.setPen(QPen(ink.color, &rowOf(*line.back()) == used ? 3.0 : 1.6));
        painter.drawPolyline(onScreen(line));
        drawMarker(painter, onScreen(*line.back()), ink, markerSize(), m_theme.tokens().panel);
    }
    drawCursors(painter);
}

/// Draws the cursor of the run, and the thin one of a preview.
void RunPlot::drawCursors(QPainter &painter) const
{
    const QRectF area = axisRect()->rect();
    const auto line = [&](std::int64_t frame, const QPen &pen) {
        const double x = xAxis->coordToPixel(static_cast<double>(frame));
        painter.setPen(pen);
        painter.drawLine(QPointF(x, area.top()), QPointF(x, area.bottom()));
    };
    line(m_study.run().timeline().cursor().frame, QPen(m_theme.tokens().now, 2.0));
    if (hovered())
        line(*hovered(), QPen(m_theme.tokens().ink3, 1.0));
}

QByteArray RunPlot::numbersOf(const sim::Accuracy &accuracy) const
{
    return errorsOverRun(accuracy, m_rows);
}

QString RunPlot::tipOf(const Spot &spot) const
{
    const int frame = qRound(spot.place.x());
    const double error = rowOf(spot).errorAt[static_cast<std::size_t>(frame)];
    return tr("Frame %1: error %2").arg(frame).arg(pixels(error)) + '\n' + rowWords(rowOf(spot));
}

}
