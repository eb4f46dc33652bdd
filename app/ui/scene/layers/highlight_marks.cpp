#include "app/ui/scene/layers/highlight_marks.h"

#include "app/model/picture/arrow_angle.h"
#include "app/model/text/numbers.h"
#include "app/model/text/phrases.h"
#include "app/model/text/sentences.h"
#include "app/ui/scene/drawing/arrows.h"
#include "lessons/api/view/named_place.h"

#include <QCoreApplication>
#include <QStringList>

#include <cmath>

namespace app {

namespace {

using lessons::Highlight;

struct HighlightText
{
    Q_DECLARE_TR_FUNCTIONS(Highlights)
};

constexpr double markWidth = 3.0; ///< screen px
constexpr double markHalo = 3.0;  ///< screen px, of the light stroke on each side
constexpr double highlightGap =
    9.0;                        ///< screen px, from the edge of a body: outside the ring of the selected one
constexpr double markArm = 9.0; ///< screen px, of a cross
constexpr double besideMark = 12.0; ///< screen px, from a mark to its number

/// Marks what one formula highlights. All marks are strokes over a light stroke, which keeps them visible on a body.
class HighlightPainter
{
public:
    explicit HighlightPainter(const Canvas &canvas) : m_canvas(canvas) {}

    void draw(const Highlight &one) const
    {
        switch (one.kind) {
        case Highlight::Kind::thing:
            drawThing(one);
            break;
        case Highlight::Kind::arrow:
        case Highlight::Kind::xSide:
        case Highlight::Kind::ySide:
            drawBetween(one);
            break;
        case Highlight::Kind::velocity:
            drawVelocity(one);
            break;
        case Highlight::Kind::circle:
            drawCircle(one);
            break;
        }
    }

private:
    const Picture &picture() const { return m_canvas.shown.picture; }
    const sim::Scene &scene() const { return picture().interval->scene; }
    int pointOf(const QString &name) const { return scene().find(name.toStdString()); }
    std::optional<QPointF> at(const QString &name) const
    {
        const std::optional<sim::Vec2> place = placeOf(name);
        return place ? std::optional(m_canvas.camera.at(*place)) : std::nullopt;
    }
    std::optional<sim::Vec2> placeOf(const QString &name) const
    {
        const auto place = lessons::placeNamed(name, scene(), picture().state, picture().interval->values);
        return place && std::isfinite(place->x) && std::isfinite(place->y) ? place : std::nullopt;
    }

    /// Calls `draw` with the pen of the light stroke and then with that of the mark.
    template <class Draw>
    void stroke(Draw draw) const
    {
        m_canvas.painter.setBrush(Qt::NoBrush);
        for (const QPen &pen : {solid(m_canvas.tokens().scene, markWidth + 2.0 * markHalo),
                                solid(m_canvas.tokens().ink, markWidth)}) {
            m_canvas.painter.setPen(pen);
            draw(m_canvas.painter);
        }
    }

    void drawLine(QPointF from, QPointF to) const
    {
        const QLineF line = m_canvas.cut(from, to);
        if (!line.isNull())
            stroke([&line](QPainter &painter) { painter.drawLine(line); });
    }

    void drawArrowOver(QPointF from, QPointF vector, bool hasOpenHead) const
    {
        const Tokens &t = m_canvas.tokens();
        for (const ArrowStyle &style :
             {ArrowStyle{t.scene, markWidth + 2.0 * markHalo, ArrowStyle::Line::plain, hasOpenHead},
              ArrowStyle{t.ink, markWidth, ArrowStyle::Line::plain, hasOpenHead}})
            drawArrow(m_canvas.painter, {from, vector, style}, t.scene);
    }

    void drawNumber(QPointF middle, const QString &text) const
    {
        drawWords(m_canvas, {middle + QPointF(besideMark, -besideMark / 2.0), text, m_canvas.shown.figures,
                             m_canvas.tokens().ink});
    }

    void drawThing(const Highlight &one) const
    {
        const std::optional<QPointF> middle = at(one.a);
        if (!middle)
            return; // a parameter
        const int point = pointOf(one.a);
        if (point >= 0 && m_canvas.shown.view().tree) {
            drawLine(*middle, m_canvas.camera.at(branchEnd(picture(), point)));
        } else if (point >= 0) {
            const double radius = m_canvas.discRadius(point) + highlightGap;
            stroke([&](QPainter &painter) { painter.drawEllipse(*middle, radius, radius); });
        } else {
            drawLine(*middle - QPointF(markArm, 0.0), *middle + QPointF(markArm, 0.0));
            drawLine(*middle - QPointF(0.0, markArm), *middle + QPointF(0.0, markArm));
        }
    }

    void drawBetween(const Highlight &one) const
    {
        const std::optional<sim::Vec2> a = placeOf(one.a), b = placeOf(one.b);
        if (!a || !b)
            return;
        const sim::Vec2 corner{b->x, a->y};
        const bool isX = one.kind == Highlight::Kind::xSide, isY = one.kind == Highlight::Kind::ySide;
        const QPointF from = m_canvas.camera.at(isY ? corner : *a),
                      to = m_canvas.camera.at(isX ? corner : *b);
        const double size = isX ? b->x - a->x : isY ? b->y - a->y : shownLength(*b - *a);
        if (isX || isY)
            drawLine(from, to);
        else
            drawArrowOver(from, to - from, false);
        drawNumber((from + to) / 2.0, pixels(fixedNumber(size, 1)));
    }

    void drawVelocity(const Highlight &one) const
    {
        const int point = pointOf(one.a);
        const std::optional<QPointF> from = at(one.a);
        if (point < 0 || !from)
            return;
        const sim::Vec2 velocity = picture().state.velocityOf(point);
        const double scale = unitArrow / m_canvas.shown.scales.velocity.unit; // that of the legend
        const QPointF arrow = scale * QPointF(velocity.x, velocity.y);
        drawArrowOver(*from, arrow, true);
        drawNumber(*from + arrow,
                   HighlightText::tr("%1\u2009px/frame").arg(fixedNumber(shownLength(velocity), 2)));
    }

    void drawCircle(const Highlight &one) const
    {
        const std::optional<QPointF> middle = at(one.a);
        const sim::Values &values = picture().interval->values;
        if (!middle || !values.has(one.b.toStdString()))
            return;
        const double px = values[one.b.toStdString()], radius = px * m_canvas.camera.zoom;
        if (!m_canvas.reaches(*middle, radius) || radius > mostRadius)
            return;
        stroke([&](QPainter &painter) { painter.drawEllipse(*middle, radius, radius); });
        drawNumber(*middle + QPointF(0.0, -radius), pixels(fixedNumber(px, 1)));
    }

    static constexpr double mostRadius = 4000.0; ///< screen px; the painter takes long for larger circles

    const Canvas &m_canvas;
};

QString wordsOf(const Highlight &one)
{
    const QString a = bodyTitle(one.a), b = bodyTitle(one.b);
    switch (one.kind) {
    case Highlight::Kind::thing:
        break;
    case Highlight::Kind::arrow:
        return HighlightText::tr("the arrow from %1 to %2").arg(a, b);
    case Highlight::Kind::xSide:
        return HighlightText::tr("x from %1 to %2").arg(a, b);
    case Highlight::Kind::ySide:
        return HighlightText::tr("y from %1 to %2").arg(a, b);
    case Highlight::Kind::velocity:
        return HighlightText::tr("the velocity of %1").arg(a);
    case Highlight::Kind::circle:
        return HighlightText::tr("the circle around %1").arg(a);
    }
    return a;
}

}

void drawHighlights(const Canvas &canvas)
{
    const HighlightPainter painter(canvas);
    for (const Highlight &one : canvas.shown.highlights)
        painter.draw(one);
}

QString highlightWords(const std::vector<Highlight> &highlights)
{
    QStringList all;
    for (const Highlight &one : highlights)
        all << wordsOf(one);
    return all.join(QStringLiteral(", "));
}

}
