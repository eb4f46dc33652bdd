#include "app/ui/scene/layers.h"

#include "app/ui/scene/arrows.h"

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
    const QTransform toView = painter->worldTransform();
    painter->save();
    painter->setWorldTransform({});
    painter->setBrush(Qt::NoBrush);
    draw({*painter, m_shown, m_theme, Camera(toView), toView.mapRect(option->exposedRect)});
    painter->restore();
}

void TreeLayer::draw(const Canvas &canvas) const
{
    if (canvas.shown.look().tree)
        m_tree.draw(canvas, canvas.shown.picture.look, canvas.shown.state());
}

void ArrowLayer::draw(const Canvas &canvas) const
{
    for (const Arrow &arrow : velocityArrows(canvas.shown, canvas.camera, canvas.theme))
        drawArrow(canvas.painter, arrow, canvas.tokens().scene);
    for (const Arrow &arrow : pullArrows(canvas.shown, canvas.camera, canvas.theme))
        drawArrow(canvas.painter, arrow, canvas.tokens().scene);
}

}
