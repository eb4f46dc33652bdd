// Layers of springs, and of the soft material that many springs form.

#include "app/ui/scene/drawing/figure.h"
#include "app/ui/scene/layers/layers.h"
#include "app/ui/scene/layers/material.h"
#include "lessons/api/view/view.h"

#include <algorithm>
#include <cmath>

namespace app {

namespace {

constexpr int fewestTurns = 3;       ///< turns of a coil
constexpr int mostTurns = 14;        ///< turns of a coil
constexpr int turnsOfNoLength = 14;  ///< turns of a spring with rest length 0
constexpr double turnLength = 9.0;   ///< scene px, of a spring at rest
constexpr double halfWidth = 4.0;    ///< scene px, of a spring at rest
constexpr double widest = 7.5;       ///< screen px, half of the width
constexpr double smallest = 5.0;     ///< screen px; if turns would be shorter, there are fewer
constexpr double longestLead = 12.0; ///< screen px, the straight piece at each end
constexpr double pinRadius = 3.5;    ///< screen px, where a spring is fixed to a position
constexpr std::size_t mostCoils = 200;
constexpr double matterShare = 0.16; ///< opacity of the spring's colour in soft material
constexpr double insideShare = 0.4;  ///< relative opacity of the springs inside

/// The colour of the rear half of a coil, between the spring's colour and the background's.
constexpr double behind = 0.35;

/// The visible strands of coils, in front and behind.
struct Coils
{
    const Canvas &canvas;
    QPainterPath front = {};
    QPainterPath back = {};

    void add(QPainterPath &strands, QPointF from, QPointF to) const
    {
        const QLineF line = canvas.cut(from, to);
        if (line.isNull())
            return;
        if (strands.currentPosition() != line.p1() || strands.isEmpty())
            strands.moveTo(line.p1());
        strands.lineTo(line.p2());
    }
};

/// Adds a zigzag with straight ends. It keeps its number of turns, so that they move closer when the spring
/// is compressed.
void addCoil(Coils &coils, const QLineF &line, int turns, double wide)
{
    const double length = line.length();
    const QPointF u = (line.p2() - line.p1()) / length;
    const QPointF across = wide * QPointF(-u.y(), u.x());
    const double lead = std::min(longestLead, 0.12 * length);
    const double part = (length - 2.0 * lead) / (2.0 * turns);
    const auto corner = [&](int i) {
        return line.p1() + (lead + (i + 0.5) * part) * u + (i % 2 == 0 ? across : -across);
    };
    const QPointF first = line.p1() + lead * u, last = line.p2() - lead * u;
    coils.add(coils.front, line.p1(), first);
    coils.add(coils.front, first, corner(0));
    for (int i = 1; i < 2 * turns; ++i)
        coils.add(i % 2 == 0 ? coils.back : coils.front, corner(i - 1), corner(i));
    coils.add(coils.front, corner(2 * turns - 1), last);
    coils.add(coils.front, last, line.p2());
}

/// Returns the line between the edges of the discs at a spring's ends, or between their centres if they
/// overlap.
QLineF visibleLine(const Canvas &canvas, const lessons::SpringView &spring)
{
    const sim::State &state = canvas.shown.state();
    const QLineF line(canvas.camera.at(state.positionOf(spring.a)), canvas.camera.at(endOf(spring, state)));
    const bool isPlace = spring.b < 0 || spring.at != sim::Vec2();
    const double far = isPlace ? pinRadius : canvas.discRadius(spring.b);
    const double near = canvas.discRadius(spring.a), length = line.length();
    if (length <= near + far + smallest)
        return isPlace && length <= near ? QLineF() : line;
    const QPointF u = (line.p2() - line.p1()) / length;
    return {line.p1() + near * u, line.p2() - far * u};
}

void addSpring(Coils &coils, const lessons::SpringView &spring)
{
    const Canvas &canvas = coils.canvas;
    const QLineF line = visibleLine(canvas, spring);
    if (line.isNull() || canvas.cut(line.p1(), line.p2()).isNull())
        return;
    const bool hasLength = spring.length > 0.0;
    const int turns = hasLength
                          ? std::clamp(static_cast<int>(spring.length / turnLength), fewestTurns, mostTurns)
                          : turnsOfNoLength;
    const double zoom = canvas.camera.zoom;
    const double rest = (hasLength ? spring.length : turns * turnLength) * zoom;
    if (line.length() < smallest * fewestTurns) {
        coils.add(coils.front, line.p1(), line.p2());
        return;
    }
    // A coil gets narrower when stretched and wider when compressed.
    const double swelling = std::clamp(std::sqrt(rest / line.length()), 0.5, 1.3);
    addCoil(coils, line, turns, std::min(widest, std::max(2.0, halfWidth * zoom)) * swelling);
}

void drawPin(const Canvas &canvas, const lessons::SpringView &spring)
{
    const QPointF at = canvas.camera.at(endOf(spring, canvas.shown.state()));
    if (canvas.reaches(at, pinRadius))
        canvas.painter.drawEllipse(at, pinRadius, pinRadius);
}

/// Draws very many springs as plain lines.
void drawFine(const Canvas &canvas, const std::vector<lessons::SpringView> &springs, bool all)
{
    using Part = lessons::SpringView::Part;
    const sim::State &state = canvas.shown.state();
    QList<QLineF> inside, edges;
    for (const lessons::SpringView &spring : springs) {
        if (spring.part == Part::alone && !all)
            continue;
        const QLineF line =
            canvas.cut(canvas.camera.at(state.positionOf(spring.a)), canvas.camera.at(endOf(spring, state)));
        if (!line.isNull())
            (spring.part == Part::inside ? inside : edges) << line;
    }
    const QColor color = canvas.tokens().spring;
    canvas.painter.setPen(solid(faded(color, insideShare), 1.0));
    canvas.painter.drawLines(inside);
    canvas.painter.setPen(solid(color, std::clamp(1.1 * canvas.camera.zoom, 1.0, 2.4)));
    canvas.painter.drawLines(edges);
}

}

void drawSheets(const Canvas &canvas)
{
    const std::vector<lessons::SheetView> &sheets = canvas.shown.view().sheets;
    if (sheets.empty() || isFlat(canvas.theme))
        return;
    QPainterPath path;
    path.setFillRule(Qt::WindingFill); // no seams where two strands meet
    for (const lessons::SheetView &sheet : sheets) {
        QPolygonF patch;
        for (const int corner : sheet.corners)
            patch << canvas.camera.at(canvas.shown.state().positionOf(corner));
        if (patch.boundingRect().intersects(canvas.area)) {
            path.addPolygon(canvas.cut(patch));
            path.closeSubpath();
        }
    }
    canvas.painter.fillPath(path, faded(canvas.tokens().spring, matterShare));
}

void drawSprings(const Canvas &canvas)
{
    const std::vector<lessons::SpringView> &springs = canvas.shown.view().springs;
    if (springs.empty())
        return;
    QPainter &p = canvas.painter;
    p.setBrush(Qt::NoBrush);
    const bool areMany = springs.size() > mostCoils || canvas.shown.isCrowd();
    drawFine(canvas, springs, areMany);
    if (areMany)
        return;
    const Tokens &tokens = canvas.tokens();
    const QPen front = solid(tokens.spring, std::clamp(1.1 * canvas.camera.zoom, 1.0, 2.0));
    QPen back = front;
    back.setColor(mixed(tokens.spring, tokens.scene, behind));
    for (const lessons::SpringView &spring : springs) {
        if (spring.part != lessons::SpringView::Part::alone)
            continue;
        Coils coils{canvas};
        addSpring(coils, spring);
        p.setPen(back);
        p.drawPath(coils.back);
        p.setPen(front);
        p.drawPath(coils.front);
        if (spring.b < 0 || spring.at != sim::Vec2())
            drawPin(canvas, spring);
    }
}

}
