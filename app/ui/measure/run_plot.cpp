#include "app/ui/measure/run_plot.h"

#include "app/model/accuracy_rows.h"
#include "app/model/accuracy_words.h"
#include "app/ui/measure/plot_marks.h"

#include <algorithm>
#include <cmath>

namespace app {

namespace {

using sim::AccuracyRow;

constexpr double nameRoom = 128.0;
constexpr double markerSize = 8.0;

double cost(const AccuracyRow &row)
{
    return row.nsPerFrame > 0.0 ? row.nsPerFrame : row.evaluations;
}

/// How many times as dear as the other, whichever is the dearer, as a logarithm.
double apart(const AccuracyRow &a, const AccuracyRow &b)
{
    return cost(a) > 0.0 && cost(b) > 0.0 ? std::abs(std::log(cost(a) / cost(b))) : 1e9;
}

}

RunPlot::RunPlot(AccuracyStudy &study, const Theme &theme, QWidget *parent) : SpotPlot(study, theme, parent)
{
    setObjectName("overTheRun");
    setAccessibleName(tr("Error over the run"));
    for (const auto signal : {&Session::moved, &Session::glanceChanged}) {
        connect(&study.session(), signal, this, [this] {
            if (isVisible())
                update();
        });
    }
}

std::optional<std::int64_t> RunPlot::frameAt(QPointF place) const
{
    if (!m_study.accuracy() || !QRectF(axisRect()->rect()).contains(place))
        return std::nullopt;
    const auto frame = static_cast<std::int64_t>(std::lround(xAxis->pixelToCoord(place.x())));
    const std::int64_t computed = m_study.session().timeline().computed();
    const bool isThere = frame >= 0 && frame <= std::min<std::int64_t>(computed, m_study.accuracy()->horizon);
    return isThere ? std::optional(frame) : std::nullopt;
}

std::optional<std::int64_t> RunPlot::hovered() const
{
    const std::optional<sim::Cursor> &moment = m_study.session().marked();
    if (!m_study.accuracy() || !moment || moment->phase > 0 || moment->frame > m_study.accuracy()->horizon)
        return std::nullopt;
    return moment->frame;
}

void RunPlot::mouseMoveEvent(QMouseEvent *event)
{
    SpotPlot::mouseMoveEvent(event);
    emit pointedAt(frameAt(event->position()));
}

void RunPlot::leaveEvent(QEvent *event)
{
    SpotPlot::leaveEvent(event);
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
        else if (used && (&rows[i] == used || (&rows[m_rows.back()] != used &&
                                               apart(rows[i], *used) < apart(rows[m_rows.back()], *used))))
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
    const double inner = std::max(80.0, axisRect()->width() - nameRoom);
    xAxis->setRange(0.0, frames * (1.0 + nameRoom / inner));
    return spots;
}

QPolygonF RunPlot::lineOf(std::size_t row) const
{
    QPolygonF line;
    for (const Spot &spot : spots()) {
        if (spot.row == row)
            line << onScreen(spot);
    }
    return line;
}

void RunPlot::placeWords()
{
    std::vector<EndLabel> labels;
    std::vector<QLineF> strokes;
    for (const std::size_t row : m_rows) {
        const QPolygonF line = lineOf(row);
        if (line.isEmpty())
            continue;
        addStrokes(strokes, line);
        const sim::Method &method = *m_study.accuracy()->rows[row].setup.method;
        labels.push_back({line.back(), methodTitle(method), inkOf(method, m_theme).color});
    }
    LabelPlaces places({}, std::move(strokes));
    m_names = placeEndLabels(std::move(labels), m_theme.ui(12, QFont::Medium), axisRect()->rect(), places);
}

void RunPlot::draw(QPainter &painter)
{
    const QRectF area = axisRect()->rect();
    drawAxisNames(painter, area, {tr("frame"), tr("how far off, px"), {}, tr("← more exact")}, m_theme);
    painter.save();
    painter.setClipRect(area);
    const AccuracyRow *used = m_study.inUse();
    for (const std::size_t row : m_rows) {
        const QPolygonF line = lineOf(row);
        const sim::Method &method = *m_study.accuracy()->rows[row].setup.method;
        const MethodInk ink = inkOf(method, m_theme);
        painter.setPen(QPen(ink.color, &m_study.accuracy()->rows[row] == used ? 3.0 : 1.6));
        painter.drawPolyline(line);
        if (line.isEmpty())
            continue;
        drawMarker(painter, line.back(), ink, markerSize, m_theme.tokens().panel);
    }
    drawMoments(painter);
    painter.restore();
    drawEndLabels(painter, m_names, m_theme.ui(12, QFont::Medium), m_theme.tokens().panel);
    if (chosen())
        drawRing(painter, onScreen(*chosen()), QPen(m_theme.tokens().ink, 2.0), markerSize);
}

/// The cursor of the run, and the thin one of a look.
void RunPlot::drawMoments(QPainter &painter) const
{
    const QRectF area = axisRect()->rect();
    const auto line = [&](std::int64_t frame, const QPen &pen) {
        const double x = xAxis->coordToPixel(static_cast<double>(frame));
        painter.setPen(pen);
        painter.drawLine(QPointF(x, area.top()), QPointF(x, area.bottom()));
    };
    line(m_study.session().timeline().cursor().frame, QPen(m_theme.tokens().now, 2.0));
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
    return tr("Frame %1: %2 off").arg(frame).arg(pixels(error)) + '\n' + rowWords(rowOf(spot));
}

}
