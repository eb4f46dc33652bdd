#include "app/ui/scene/layers.h"

#include "app/ui/scene/arrows.h"
#include "app/ui/scene/guide_labels.h"

#include <QStyleOptionGraphicsItem>

namespace app {

Layer::Layer(const Shown &shown, const Theme &theme, Height height) : m_shown(shown), m_theme(theme)
{
    setFlag(ItemUsesExtendedStyleOption);
    setAcceptedMouseButtons(Qt::NoButton);
    setZValue(static_cast<int>(height));
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
    if (painter->hasClipping()) // a picture of the scene exposes all of an item, however little of it shows
        area &= painter->clipBoundingRect();
    painter->setBrush(Qt::NoBrush);
    draw({*painter, m_shown, m_theme, Camera(toView), area});
    painter->restore();
}

void TreeLayer::draw(const Canvas &canvas) const
{
    if (canvas.shown.look().tree)
        m_tree.draw(canvas, canvas.shown.picture.look, canvas.shown.state());
}

void NameLayer::draw(const Canvas &canvas) const
{
    const Shown &shown = canvas.shown;
    if (shown.name.isEmpty())
        return;
    const QPointF from =
        titleBox(shown, canvas.camera).topLeft() + QPointF(0.0, QFontMetricsF(shown.figures).ascent());
    drawWords(canvas, {from, shown.name, shown.figures, canvas.tokens().ink});
}

void ArrowLayer::draw(const Canvas &canvas) const
{
    for (const Arrow &arrow : velocityArrows(canvas.shown, canvas.camera, canvas.theme))
        drawArrow(canvas.painter, arrow, canvas.tokens().scene);
    for (const Arrow &arrow : pullArrows(canvas.shown, canvas.camera, canvas.theme))
        drawArrow(canvas.painter, arrow, canvas.tokens().scene);
}

}
