#include "app/ui/scene/layers/layers.h"

#include "app/model/session/user_input.h"
#include "app/ui/scene/drawing/arrows.h"
#include "app/ui/scene/drawing/overlay_labels.h"
#include "app/ui/scene/layers/highlight_marks.h"

#include <QGraphicsScene>
#include <QStyleOptionGraphicsItem>

#include <utility>

namespace app {

Layer::Layer(const SceneContent &shown, const Theme &theme, double z, Draw draw)
    : m_shown(shown), m_theme(theme), m_draw(std::move(draw))
{
    setFlag(ItemUsesExtendedStyleOption);
    setAcceptedMouseButtons(Qt::NoButton);
    setZValue(z);
}

QRectF Layer::boundingRect() const
{
    return {-worldReach, -worldReach, 2.0 * worldReach, 2.0 * worldReach};
}

void Layer::paint(QPainter *painter, const QStyleOptionGraphicsItem *option, QWidget *)
{
    if (m_shown.points() == 0)
        return;
    QRectF area = painter->worldTransform().mapRect(option->exposedRect);
    QTransform toView = painter->worldTransform();
    toView.translate(m_shown.shift.x, m_shown.shift.y);
    painter->save();
    painter->setWorldTransform({});
    if (painter->hasClipping()) // when the scene is exported as an image, Qt exposes the whole item
        area &= painter->clipBoundingRect();
    painter->setBrush(Qt::NoBrush);
    m_draw({*painter, m_shown, m_theme, Camera(toView), area});
    painter->restore();
}

namespace {

/// Which figures have a layer.
enum class Of { run, both };

struct LayerEntry
{
    Layer::Draw draw;
    Of of;
};

/// Returns a layer that keeps its painter's memory between two paints.
template <typename Painter>
Layer::Draw with(void (*draw)(const Canvas &, Painter &))
{
    return [draw, painter = Painter()](const Canvas &canvas) mutable { draw(canvas, painter); };
}

/// Returns the layers that both figures can have, and those of the run. Later ones are above earlier ones.
std::vector<LayerEntry> layerTable()
{
    return {{drawRoom, Of::both},
            {drawRamps, Of::run},
            {drawGround, Of::run},
            {drawShadows, Of::both},
            {with(drawComparison), Of::run},
            {with(drawOnion), Of::run},
            {drawTrail, Of::run},
            {with(drawTree), Of::run},
            {with(drawNearGround), Of::run},
            {drawLimbs, Of::both},
            {drawSkins, Of::both},
            {drawSheets, Of::run},
            {drawChains, Of::both},
            {with(drawLegs), Of::both},
            {drawSprings, Of::both},
            {drawSticks, Of::both},
            {drawRuleLinks, Of::both},
            {with(drawBodies), Of::both},
            {drawRests, Of::both},
            {drawReference, Of::run},
            {drawTriangle, Of::run},
            {drawOverlays, Of::both},
            {drawArrows, Of::run},
            {drawVector, Of::run},
            {drawHighlights, Of::run},
            {drawName, Of::both}};
}

/// Adds the layers, and returns the z value above them.
double addTable(QGraphicsScene &scene, const SceneContent &shown, const Theme &theme, Of least)
{
    double z = 0.0;
    for (LayerEntry &entry : layerTable()) {
        if (entry.of == Of::both || least == Of::run)
            scene.addItem(new Layer(shown, theme, z, std::move(entry.draw)));
        z += 1.0;
    }
    return z;
}

}

void addLayers(QGraphicsScene &scene, const SceneContent &shown, const Theme &theme, const UserInput &input)
{
    const double z = addTable(scene, shown, theme, Of::run);
    scene.addItem(new Layer(shown, theme, z, [&input](const Canvas &canvas) { drawPointer(canvas, input); }));
}

void addCompanionLayers(QGraphicsScene &scene, const SceneContent &shown, const Theme &theme)
{
    addTable(scene, shown, theme, Of::both);
}

void drawTree(const Canvas &canvas, TreePainter &tree)
{
    if (canvas.shown.view().tree)
        tree.draw(canvas, canvas.shown.picture.view, canvas.shown.state());
}

void drawName(const Canvas &canvas)
{
    const SceneContent &shown = canvas.shown;
    if (shown.name.isEmpty())
        return;
    const QPointF from =
        titleBox(shown, canvas.camera).topLeft() + QPointF(0.0, QFontMetricsF(shown.figures).ascent());
    drawWords(canvas, {from, shownTitle(shown, canvas.camera), shown.figures, canvas.tokens().ink});
}

namespace {

/// Returns the outline of a hand with its fingertip at `tip`, screen px.
QPainterPath handShape(QPointF tip)
{
    QPainterPath hand;
    hand.addRoundedRect(QRectF(-2.2, 0.0, 4.4, 15.0), 2.2, 2.2); // the index finger
    for (int finger = 0; finger < 3; ++finger) {
        QPainterPath folded;
        folded.addRoundedRect(QRectF(1.6 + 4.0 * finger, 7.0 + finger, 4.6, 8.0), 2.3, 2.3);
        hand |= folded;
    }
    QPainterPath palm, thumb;
    palm.addRoundedRect(QRectF(-2.2, 10.5, 16.4, 12.5), 5.0, 5.0);
    thumb.addRoundedRect(QRectF(-7.5, 11.0, 9.0, 4.6), 2.3, 2.3);
    hand |= palm;
    hand |= thumb;
    return hand.translated(tip);
}

}

void drawPointer(const Canvas &canvas, const UserInput &input)
{
    const std::optional<sim::Vec2> place = input.recordedPointer();
    if (!place)
        return;
    canvas.painter.setPen(QPen(canvas.tokens().scene, 4.0, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    canvas.painter.setBrush(canvas.tokens().scene);
    const QPainterPath hand = handShape(canvas.camera.at(*place));
    canvas.painter.drawPath(hand);
    canvas.painter.setPen(QPen(canvas.tokens().ink, 1.5, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    canvas.painter.drawPath(hand);
}

void drawArrows(const Canvas &canvas)
{
    for (const Arrow &arrow : velocityArrows(canvas.shown, canvas.camera, canvas.theme))
        drawArrow(canvas.painter, arrow, canvas.tokens().scene);
    for (const Arrow &arrow : pullArrows(canvas.shown, canvas.camera, canvas.theme))
        drawArrow(canvas.painter, arrow, canvas.tokens().scene);
}

}
