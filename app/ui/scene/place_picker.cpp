#include "app/ui/scene/place_picker.h"

#include "app/model/text/numbers.h"
#include "app/ui/scene/arrow_key.h"
#include "app/ui/scene/drawing/line_clip.h"
#include "app/ui/scene/hud/free_area.h"

#include <QCoreApplication>
#include <QFontMetricsF>
#include <QLineF>

#include <utility>

namespace app {

namespace {

struct PlacePickerText
{
    Q_DECLARE_TR_FUNCTIONS(PlacePicker)
};

constexpr double pickStep = 10.0;   ///< px that an arrow key moves the cross
constexpr double pickFine = 1.0;    ///< px, with Shift
constexpr double markArm = 11.0;    ///< screen px, of the cross
constexpr double markRing = 6.0;    ///< screen px, the radius of the ring of the true place
constexpr double markHalo = 5.0;    ///< screen px, the width of the line under a mark
constexpr double markToLabel = 4.0; ///< screen px between a mark and its label

bool isEnter(const QKeyEvent &key)
{
    return key.key() == Qt::Key_Return || key.key() == Qt::Key_Enter;
}

/// Calls `draw` twice: with a wide pen in the colour of the scene, so that the mark is visible over everything, then with its
/// own pen.
template <class Draw>
void withHalo(const Canvas &canvas, const QColor &color, Draw draw)
{
    canvas.painter.setBrush(Qt::NoBrush);
    for (const QPen &pen : {solid(canvas.tokens().scene, markHalo), solid(color, 2.0)}) {
        canvas.painter.setPen(pen);
        draw();
    }
}

void drawCross(const Canvas &canvas, QPointF at, const QColor &color)
{
    withHalo(canvas, color, [&] {
        canvas.painter.drawLine(at - QPointF(markArm, 0.0), at + QPointF(markArm, 0.0));
        canvas.painter.drawLine(at - QPointF(0.0, markArm), at + QPointF(0.0, markArm));
    });
}

QString distanceWords(const PredictionDesk::PlaceMark &mark)
{
    return fixedNumber(sim::length(mark.said - *mark.found), 0) + QStringLiteral("\u202Fpx");
}

}

void PlacePicker::place(sim::Vec2 at)
{
    if (isPicking())
        m_desk->say(m_desk->picking()->id, PredictedAnswer{.place = at});
}

bool PlacePicker::wants(const QKeyEvent &key) const
{
    if (!isPicking())
        return false;
    const auto modifiers = key.modifiers() & ~(Qt::KeypadModifier | Qt::ShiftModifier | Qt::AltModifier);
    return modifiers == Qt::NoModifier &&
           (arrowKey(key.key()) || isEnter(key) || key.key() == Qt::Key_Escape);
}

void PlacePicker::press(const QKeyEvent &key)
{
    if (key.key() == Qt::Key_Escape) {
        m_desk->stopPicking();
    } else if (isEnter(key)) {
        m_desk->commit(m_desk->picking()->id);
    } else if (const std::optional<sim::Vec2> way = arrowKey(key.key())) {
        const std::optional<PredictionDesk::PlaceMark> mark = m_desk->mark();
        const sim::Vec2 from = mark ? mark->said : m_desk->placeOfBody();
        place(from + (key.modifiers() & Qt::ShiftModifier ? pickFine : pickStep) * *way);
    }
}

void PlacePicker::draw(const Canvas &canvas, const LabelPlaces &places,
                       const std::vector<QRectF> &texts) const
{
    const std::optional<PredictionDesk::PlaceMark> mark = m_desk ? m_desk->mark() : std::nullopt;
    if (!mark)
        return;
    const Tokens &t = canvas.tokens();
    const QPointF said = canvas.camera.at(mark->said);
    if (!mark->found) {
        drawCross(canvas, said, t.link);
        return;
    }
    const QPointF found = canvas.camera.at(*mark->found);
    for (const QLineF &line : predictionLines(*mark, canvas.camera, texts))
        withHalo(canvas, t.ink2, [&] { canvas.painter.drawLine(line); });
    drawCross(canvas, said, t.link);
    withHalo(canvas, t.ok, [&] { canvas.painter.drawEllipse(found, markRing, markRing); });
    const OverlayLabel label =
        predictionLabel(*mark, canvas.camera, freeArea(canvas.shown, canvas.area), places, canvas.shown.text);
    const QPointF down(0.0, QFontMetricsF(canvas.shown.text).ascent());
    drawWords(canvas, {label.box.topLeft() + down, label.text, canvas.shown.text, t.ink});
}

std::vector<QLineF> predictionLines(const PredictionDesk::PlaceMark &mark, const Camera &camera,
                                    const std::vector<QRectF> &texts)
{
    std::vector<QLineF> lines{{camera.at(mark.said), camera.at(*mark.found)}};
    for (const QRectF &text : texts) {
        const QRectF box = text.adjusted(-markHalo, -markHalo, markHalo, markHalo);
        std::vector<QLineF> outside;
        for (const QLineF &line : lines) {
            const auto part = text.isEmpty() ? std::nullopt : partWithin(box, line.p1(), line.p2());
            const auto [from, to] = part.value_or(std::pair(1.0, 1.0));
            if (from > 0.0)
                outside.emplace_back(line.p1(), line.pointAt(from));
            if (to < 1.0)
                outside.emplace_back(line.pointAt(to), line.p2());
        }
        lines = std::move(outside);
    }
    return lines;
}

OverlayLabel predictionLabel(const PredictionDesk::PlaceMark &mark, const Camera &camera, const QRectF &area,
                             LabelPlaces places, const QFont &font)
{
    const QPointF said = camera.at(mark.said), found = camera.at(*mark.found);
    const QPointF arm(markArm, markArm), ring(markRing, markRing);
    places.take({said - arm, said + arm});
    places.take({found - ring, found + ring});
    places.takeStroke({said, found});
    const QString text = PlacePickerText::tr("your place, %1 away").arg(distanceWords(mark));
    const QFontMetricsF metrics(font);
    const QSizeF size(metrics.horizontalAdvance(text), metrics.height());
    const QPointF wanted = said + QPointF(markArm + markToLabel, -size.height() / 2.0);
    return {text, places.within(area, wanted, size)};
}

QString PlacePicker::words() const
{
    const std::optional<PredictionDesk::PlaceMark> mark = m_desk ? m_desk->mark() : std::nullopt;
    if (!mark)
        return {};
    const QString said = PlacePickerText::tr("Your cross is at %1, %2")
                             .arg(fixedNumber(mark->said.x, 0), fixedNumber(mark->said.y, 0));
    if (!mark->found)
        return said;
    return PlacePickerText::tr("%1, %2 away from the true place %3, %4")
        .arg(said, distanceWords(*mark), fixedNumber(mark->found->x, 0), fixedNumber(mark->found->y, 0));
}

}
