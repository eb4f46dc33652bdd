#include "app/ui/measure/work_precision_plot.h"

#include "app/model/accuracy_words.h"
#include "app/ui/measure/plot_marks.h"
#include "app/ui/measure/work_precision_layout.h"

#include <algorithm>
#include <cmath>

namespace app {

namespace {

using sim::Outcome;

constexpr double markerSize = 9.0;
constexpr double besideFront = 18.0;   ///< px between the front and its name
constexpr double farthestNote = 140.0; ///< px that the name may be away from there

}

QString WorkPrecisionPlot::hereText()
{
    return tr("you are here");
}

QString WorkPrecisionPlot::frontText()
{
    return tr("The front: nothing is\nas exact for less.");
}

WorkPrecisionPlot::WorkPrecisionPlot(AccuracyStudy &study, const Theme &theme, QWidget *parent)
    : SpotPlot(study, theme, parent)
{
    setObjectName("workPrecision");
    setAccessibleName(tr("Error against time"));
    makeLogarithmic(*xAxis, PowerTicker::Writing::plain);
    xAxis->setRange(0.01, 100.0);
}

std::vector<Spot> WorkPrecisionPlot::layOut()
{
    WorkPrecisionLayout layout =
        workPrecisionLayout(*m_study.accuracy(), shown(), m_target, axisRect()->size());
    m_timed = layout.timed;
    if (!layout.spots.empty()) {
        xAxis->setRange(layout.least, layout.most);
        setErrors(layout.errors);
    }
    return std::move(layout.spots);
}

void WorkPrecisionPlot::draw(QPainter &painter)
{
    const QRectF area = axisRect()->rect();
    drawAxisNames(
        painter, area,
        {m_timed ? tr("time to compute a frame, µs") : tr("forces computed a frame (times come next)"),
         tr("how far off at most, px"), tr("← faster"), tr("← more exact")},
        m_theme);
    if (spots().empty())
        return;
    painter.save();
    painter.setClipRect(area.adjusted(-6.0, -6.0, 6.0, 6.0));
    drawFrame(painter);
    drawFront(painter);
    drawTarget(painter);
    drawWhiskers(painter);
    drawLadders(painter);
    drawUnstable(painter);
    painter.restore();
    drawEndLabels(painter, m_names, m_theme.ui(12, QFont::Medium), m_theme.tokens().panel);
    drawFrontNote(painter);
    drawHere(painter);
    if (chosen())
        drawRing(painter, onScreen(*chosen()), QPen(m_theme.tokens().ink, 2.0), markerSize);
}

QString WorkPrecisionPlot::frameText()
{
    const QString number = QString::number(qRound(frameOnScreen));
    return tr("A frame is on the screen\nfor %1\u2009µs (30 a second)")
        .arg(number.chopped(3) + QChar(0x2009) + number.right(3));
}

QRectF WorkPrecisionPlot::frameLabel() const
{
    if (!showsFrame())
        return {};
    const QRectF area = axisRect()->rect();
    const QSizeF size = QFontMetricsF(m_theme.ui(12)).size(0, frameText());
    return {QPointF(xAxis->coordToPixel(frameOnScreen) - size.width() - 8.0, area.top() + 4.0), size};
}

void WorkPrecisionPlot::drawFrame(QPainter &painter) const
{
    if (!showsFrame())
        return;
    const Tokens &t = m_theme.tokens();
    const QRectF area = axisRect()->rect();
    const double x = xAxis->coordToPixel(frameOnScreen);
    painter.setPen(QPen(t.ink2, 1.5));
    painter.drawLine(QPointF(x, area.top()), QPointF(x, area.bottom()));
    const QRectF label = frameLabel();
    painter.fillRect(label.adjusted(-2.0, 0.0, 2.0, 0.0), t.panel);
    painter.setFont(m_theme.ui(12));
    painter.drawText(label, Qt::AlignRight | Qt::AlignTop | Qt::TextDontClip, frameText());
}

QPolygonF WorkPrecisionPlot::frontLine() const
{
    QPolygonF front;
    for (const Spot &spot : spots()) {
        if (m_timed && shown().areAll && rowOf(spot).front)
            front << onScreen(spot);
    }
    std::sort(front.begin(), front.end(), [](QPointF a, QPointF b) { return a.x() < b.x(); });
    return front;
}

void WorkPrecisionPlot::drawFront(QPainter &painter) const
{
    const QPolygonF front = frontLine();
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
        painter.setPen(QPen(inkOf(*row.setup.method, m_theme).color, 1.0));
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
            const QColor color = inkOf(*rowOf(spot).setup.method, m_theme).color;
            const bool toFloor = rowOf(spot).error == 0.0 || rowOf(*before).error == 0.0;
            painter.setPen(toFloor ? dotted(color, 1.8) : QPen(color, 1.8)); // no such way was measured
            painter.drawLine(onScreen(*before), onScreen(spot));
        }
        before = &spot;
    }
    for (const Spot &spot : spots()) {
        const sim::AccuracyRow &row = rowOf(spot);
        const MethodInk ink = inkOf(*row.setup.method, m_theme);
        if (row.outcome != Outcome::measured)
            continue;
        drawMarker(painter, onScreen(spot), ink, markerSize, row.front ? ink.color : m_theme.tokens().panel);
        if (row.error == 0.0)
            drawZeroBar(painter, onScreen(spot), ink, markerSize);
    }
}

LabelPlaces WorkPrecisionPlot::takenPlaces() const
{
    std::vector<QRectF> marks{targetHandle(), hereTag(), frameLabel()};
    std::vector<QLineF> strokes;
    const double half = markerSize / 2.0 + 2.0;
    const Spot *before = nullptr;
    for (const Spot &spot : spots()) {
        const QPointF at = onScreen(spot);
        marks.emplace_back(at.x() - half, at.y() - half, 2.0 * half, 2.0 * half);
        if (before && before->line == spot.line && rowOf(spot).outcome == Outcome::measured)
            strokes.emplace_back(onScreen(*before), at);
        before = &spot;
    }
    const QRectF area = axisRect()->rect();
    const double y = yAxis->coordToPixel(m_target);
    strokes.emplace_back(area.left(), y, area.right(), y);
    return LabelPlaces(std::move(marks), std::move(strokes));
}

void WorkPrecisionPlot::placeWords()
{
    std::map<int, const Spot *> ends;
    for (const Spot &spot : spots()) {
        if (rowOf(spot).outcome == Outcome::measured)
            ends[spot.line] = &spot;
    }
    std::vector<EndLabel> labels;
    for (const auto &[line, spot] : ends) {
        const sim::Method &method = *rowOf(*spot).setup.method;
        labels.push_back({onScreen(*spot), methodTitle(method), inkOf(method, m_theme).color});
    }
    LabelPlaces places = takenPlaces();
    m_names = placeEndLabels(std::move(labels), m_theme.ui(12, QFont::Medium), axisRect()->rect(), places);
    m_note = frontNote(places);
}

WorkPrecisionPlot::Note WorkPrecisionPlot::frontNote(const LabelPlaces &places) const
{
    const QPolygonF front = frontLine();
    if (front.size() < 2)
        return {};
    const QSizeF size = QFontMetricsF(m_theme.ui(12)).size(0, frontText()) + QSizeF(4.0, 2.0);
    const QRectF area = axisRect()->rect().adjusted(8, 8, -8, -8);
    // Below the front there is nothing: that is what it means.
    const QPointF middle = (front[(front.size() - 1) / 2] + front[front.size() / 2]) / 2.0;
    const QPointF wanted = middle + QPointF(-besideFront - size.width(), besideFront);
    LabelPlaces trial = places;
    const QRectF box = trial.within(area, wanted, size);
    const QPointF off = box.topLeft() - wanted;
    if (!places.isFree(box) || std::hypot(off.x(), off.y()) > farthestNote)
        return {};
    return {box, {nearestPoint(box, middle), middle}};
}

void WorkPrecisionPlot::drawFrontNote(QPainter &painter) const
{
    if (m_note.box.isEmpty())
        return;
    const Tokens &t = m_theme.tokens();
    painter.fillRect(m_note.box, t.panel);
    painter.setPen(QPen(t.ink3, 1.0));
    painter.drawLine(m_note.lead);
    painter.setBrush(t.ink3);
    painter.drawEllipse(m_note.lead.p2(), 2.0, 2.0);
    painter.setBrush(Qt::NoBrush);
    painter.setFont(m_theme.ui(12));
    painter.drawText(m_note.box, Qt::AlignLeft | Qt::AlignVCenter | Qt::TextDontClip, frontText());
}

void WorkPrecisionPlot::drawUnstable(QPainter &painter) const
{
    for (const Spot &spot : spots()) {
        const sim::AccuracyRow &row = rowOf(spot);
        if (row.outcome != Outcome::unstable)
            continue;
        const QPointF at = onScreen(spot);
        painter.setPen(QPen(inkOf(*row.setup.method, m_theme).color, 2.2, Qt::SolidLine, Qt::RoundCap));
        painter.drawLine(at - QPointF(4.0, 4.0), at + QPointF(4.0, 4.0));
        painter.drawLine(at - QPointF(4.0, -4.0), at + QPointF(4.0, -4.0));
    }
}

const Spot *WorkPrecisionPlot::here() const
{
    const sim::AccuracyRow *used = m_study.inUse();
    const auto found =
        std::find_if(spots().begin(), spots().end(), [&](const Spot &spot) { return &rowOf(spot) == used; });
    return found == spots().end() ? nullptr : &*found;
}

QRectF WorkPrecisionPlot::hereTag() const
{
    const Spot *spot = here();
    if (!spot)
        return {};
    const QPointF at = onScreen(*spot);
    const QRectF area = axisRect()->rect();
    const double width = QFontMetricsF(m_theme.ui(12, QFont::DemiBold)).horizontalAdvance(hereText()) + 14.0;
    constexpr double height = 20.0, away = 13.0;
    const double left = std::max(area.left() + 2.0, at.x() - width / 2.0);
    const QRectF below(left, at.y() + away, width, height),
        above(left, at.y() - away - height, width, height);
    if (below.bottom() > area.bottom())
        return above;
    const auto covered = [this](const QRectF &tag) {
        return std::count_if(spots().begin(), spots().end(),
                             [&](const Spot &one) { return tag.contains(onScreen(one)); });
    };
    return above.top() >= 2.0 && covered(above) < covered(below) ? above : below;
}

void WorkPrecisionPlot::drawHere(QPainter &painter) const
{
    const Spot *spot = here();
    if (!spot)
        return;
    const Tokens &t = m_theme.tokens();
    drawRing(painter, onScreen(*spot), QPen(t.now, 2.5), markerSize);
    const QRectF tag = hereTag();
    painter.setFont(m_theme.ui(12, QFont::DemiBold));
    painter.setPen(Qt::NoPen);
    painter.setBrush(t.now);
    painter.drawRoundedRect(tag, 4.0, 4.0);
    painter.setPen(t.nowText);
    painter.drawText(tag, Qt::AlignCenter, hereText());
    painter.setBrush(Qt::NoBrush);
}

}
