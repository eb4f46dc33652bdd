// Springs, and the soft matter that many of them hold.

#include "app/ui/scene/figure.h"
#include "app/ui/scene/layers.h"
#include "app/ui/scene/material.h"
#include "lessons/api/view/view.h"

#include <algorithm>
#include <cmath>

namespace app {

namespace {

constexpr int fewest = 3;            ///< turns of a coil
constexpr int most = 14;             ///< turns of a coil
constexpr int turnsOfNoLength = 14;  ///< of a spring that has no length at rest
constexpr double turnLength = 9.0;   ///< px of the scene, of a spring at rest
constexpr double halfWidth = 4.0;    ///< px of the scene, of a spring at rest
constexpr double widest = 7.5;       ///< px of the screen, half of it
constexpr double smallest = 5.0;     ///< px of the screen: a turn that is shorter is not drawn as one
constexpr double longestLead = 12.0; ///< px of the screen, the straight piece at each end
constexpr double pinRadius = 3.5;    ///< px of the screen, where a spring is fastened to a place
constexpr std::size_t mostCoils = 200;
constexpr double matterShare = 0.16; ///< of the spring's colour, in soft matter
constexpr double insideShare = 0.4;  ///< of it, in the springs within

/// The colour of the strands that run behind the coil, between the spring's and the background's.
constexpr double behind = 0.35;

double discAt(const Canvas &canvas, int point)
{
    return canvas.shown.isHidden(point) ? 0.0 : canvas.camera.radius(canvas.shown.radius(point));
}

/// The strands of coils, those in front and those behind, as far as they show.
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

/// A zigzag with straight ends. It keeps its turns, so that they stand closer when it is pressed.
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

/// From edge to edge of the discs at its ends; from middle to middle where they overlap.
QLineF visibleLine(const Canvas &canvas, const lessons::SpringView &spring)
{
    const sim::State &state = canvas.shown.state();
    const QLineF line(canvas.camera.at(state.positionOf(spring.a)), canvas.camera.at(endOf(spring, state)));
    const bool isPlace = spring.b < 0 || spring.at != sim::Vec2();
    const double far = isPlace ? pinRadius : discAt(canvas, spring.b);
    const double near = discAt(canvas, spring.a), length = line.length();
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
    const int turns =
        hasLength ? std::clamp(static_cast<int>(spring.length / turnLength), fewest, most) : turnsOfNoLength;
    const double zoom = canvas.camera.zoom;
    const double rest = (hasLength ? spring.length : turns * turnLength) * zoom;
    if (line.length() < smallest * fewest) {
        coils.add(coils.front, line.p1(), line.p2());
        return;
    }
    // A wire gets narrower where it is pulled long, and wider where it is pressed.
    const double swelling = std::clamp(std::sqrt(rest / line.length()), 0.5, 1.3);
    addCoil(coils, line, turns, std::min(widest, std::max(2.0, halfWidth * zoom)) * swelling);
}

void drawPin(const Canvas &canvas, const lessons::SpringView &spring)
{
    const QPointF at = canvas.camera.at(endOf(spring, canvas.shown.state()));
    if (canvas.reaches(at, pinRadius))
        canvas.painter.drawEllipse(at, pinRadius, pinRadius);
}

/// Springs of which there are so many that each is a line only.
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

void SheetLayer::draw(const Canvas &canvas) const
{
    const std::vector<lessons::SheetView> &sheets = canvas.shown.look().sheets;
    if (sheets.empty() || isFlat(canvas.theme))
        return;
    QPainterPath path;
    path.setFillRule(Qt::WindingFill); // no seams where two meet
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

void SpringLayer::draw(const Canvas &canvas) const
{
    const std::vector<lessons::SpringView> &springs = canvas.shown.look().springs;
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
