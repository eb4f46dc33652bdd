#include "app/ui/accuracy/work_precision_plot.h"

#include "app/model/text/accuracy_text.h"
#include "app/ui/accuracy/work_precision_layout.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace app {

namespace {

using sim::Outcome;

constexpr double grip = 7.0;           ///< px round the target line in which it is taken
constexpr double besideFront = 18.0;   ///< px between the front and its name
constexpr double farthestNote = 140.0; ///< px that the name may be away from there

/// Returns 1 for a key that raises the target, -1 for one that lowers it, and 0 for others.
int directionOf(int key)
{
    return key == Qt::Key_Minus ? -1 : key == Qt::Key_Plus || key == Qt::Key_Equal ? 1 : 0;
}

}

QString WorkPrecisionPlot::hereText()
{
    return tr("you are here");
}

QString WorkPrecisionPlot::frontText()
{
    return tr("The front: nothing cheaper\nis as accurate.");
}

WorkPrecisionPlot::WorkPrecisionPlot(AccuracyStudy &study, const Theme &theme, QWidget *parent)
    : StudyPlot(study, theme, parent)
{
    setObjectName("workPrecision");
    setAccessibleName(tr("Error against time"));
    makeLogarithmic(*xAxis);
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

AxisNames WorkPrecisionPlot::axisNames() const
{
    return {m_timed ? tr("time to compute a frame, µs") : tr("forces computed per frame (times follow)"),
            largestError(),
            tr("← faster"),
            {}};
}

void WorkPrecisionPlot::drawLines(QPainter &painter)
{
    if (spots().empty())
        return;
    painter.setClipRect(QRectF(axisRect()->rect()).adjusted(-6.0, -6.0, 6.0, 6.0));
    drawFrame(painter);
    drawFront(painter);
    drawTarget(painter);
    drawWhiskers(painter);
    drawLadders(painter);
    drawUnstable(painter);
}

void WorkPrecisionPlot::drawOver(QPainter &painter)
{
    drawFrontNote(painter);
    drawHere(painter);
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
        painter.setPen(QPen(inkOf(spot).color, 1.0));
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
    const std::vector<Line> all = lines();
    for (const Line &line : all) {
        const QColor color = inkOf(*line.front()).color;
        for (std::size_t i = 1; i < line.size(); ++i) {
            const bool toFloor = rowOf(*line[i]).error == 0.0 || rowOf(*line[i - 1]).error == 0.0;
            painter.setPen(toFloor ? dotted(color, 1.8) : QPen(color, 1.8)); // no such way was measured
            painter.drawLine(onScreen(*line[i - 1]), onScreen(*line[i]));
        }
    }
    for (const Line &line : all) {
        for (const Spot *spot : line) {
            const MethodColors ink = inkOf(*spot);
            drawMarker(painter, onScreen(*spot), ink, markerSize(),
                       rowOf(*spot).front ? ink.color : m_theme.tokens().panel);
            if (rowOf(*spot).error == 0.0)
                drawZeroBar(painter, onScreen(*spot), ink, markerSize());
        }
    }
}

LabelPlaces WorkPrecisionPlot::takenPlaces() const
{
    std::vector<QRectF> marks{targetHandle(), hereTag(), frameLabel()};
    const double half = markerSize() / 2.0 + 2.0;
    for (const Spot &spot : spots()) {
        const QPointF at = onScreen(spot);
        marks.emplace_back(at.x() - half, at.y() - half, 2.0 * half, 2.0 * half);
    }
    std::vector<QLineF> strokes;
    for (const Line &line : lines()) {
        for (std::size_t i = 1; i < line.size(); ++i)
            strokes.emplace_back(onScreen(*line[i - 1]), onScreen(*line[i]));
    }
    const QRectF area = axisRect()->rect();
    const double y = yAxis->coordToPixel(m_target);
    strokes.emplace_back(area.left(), y, area.right(), y);
    return LabelPlaces(std::move(marks), std::move(strokes));
}

LabelPlaces WorkPrecisionPlot::placeNames()
{
    LabelPlaces places = StudyPlot::placeNames();
    m_note = frontNote(places);
    return places;
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
        painter.setPen(QPen(inkOf(spot).color, 2.2, Qt::SolidLine, Qt::RoundCap));
        painter.drawLine(at - QPointF(4.0, 4.0), at + QPointF(4.0, 4.0));
        painter.drawLine(at - QPointF(4.0, -4.0), at + QPointF(4.0, -4.0));
    }
}

QRectF WorkPrecisionPlot::hereTag() const
{
    const Spot *spot = spotInUse();
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
    const Spot *spot = spotInUse();
    if (!spot)
        return;
    const Tokens &t = m_theme.tokens();
    drawRing(painter, onScreen(*spot), QPen(t.now, 2.5), markerSize());
    const QRectF tag = hereTag();
    painter.setFont(m_theme.ui(12, QFont::DemiBold));
    painter.setPen(Qt::NoPen);
    painter.setBrush(t.now);
    painter.drawRoundedRect(tag, 4.0, 4.0);
    painter.setPen(t.nowText);
    painter.drawText(tag, Qt::AlignCenter, hereText());
    painter.setBrush(Qt::NoBrush);
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
    painter.setPen(dotted(t.ink2, 1.5));
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

bool WorkPrecisionPlot::isOnTarget(QPointF at) const
{
    return targetHandle().contains(at) || (QRectF(axisRect()->rect()).contains(at) &&
                                           std::abs(at.y() - yAxis->coordToPixel(m_target)) < grip);
}

void WorkPrecisionPlot::mousePressEvent(QMouseEvent *event)
{
    StudyPlot::mousePressEvent(event);
    m_isDraggingTarget = event->button() == Qt::LeftButton && !chosen() && isOnTarget(event->position());
}

void WorkPrecisionPlot::mouseMoveEvent(QMouseEvent *event)
{
    if (m_isDraggingTarget) {
        const QCPRange range = yAxis->range();
        setTarget(std::clamp(yAxis->pixelToCoord(event->position().y()), range.lower, range.upper));
        return;
    }
    StudyPlot::mouseMoveEvent(event);
    if (!chosen() && isOnTarget(event->position()))
        setCursor(Qt::SizeVerCursor);
}

void WorkPrecisionPlot::mouseReleaseEvent(QMouseEvent *)
{
    if (!std::exchange(m_isDraggingTarget, false))
        return;
    // The handle shows two digits, so the target has no more.
    const double power = std::pow(10.0, std::floor(std::log10(m_target)) - 1.0);
    setTarget(std::round(m_target / power) * power);
}

bool WorkPrecisionPlot::wantsKey(const QKeyEvent &event) const
{
    return StudyPlot::wantsKey(event) ||
           (isPlainKey(event, Qt::ShiftModifier) && directionOf(event.key()) != 0);
}

void WorkPrecisionPlot::keyPressEvent(QKeyEvent *event)
{
    const int direction = directionOf(event->key());
    if (direction == 0) {
        StudyPlot::keyPressEvent(event);
        return;
    }
    // The target goes through 1, 2, 5, 10, 20 and so on.
    const double third = std::round(std::log10(m_target) * 3.0) + direction;
    const double rough = std::pow(10.0, third / 3.0);
    const double power = std::pow(10.0, std::floor(std::log10(rough) + 1e-9));
    setTarget(std::round(rough / power) * power);
}

}
