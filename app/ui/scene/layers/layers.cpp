#include "app/ui/scene/layers/layers.h"

#include "app/ui/scene/drawing/arrows.h"
#include "app/ui/scene/drawing/overlay_labels.h"

#include <QStyleOptionGraphicsItem>

namespace app {

Layer::Layer(const SceneContent &shown, const Theme &theme, Height height) : m_shown(shown), m_theme(theme)
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
    if (painter->hasClipping()) // when the scene is exported as an image, Qt exposes the whole item
        area &= painter->clipBoundingRect();
    painter->setBrush(Qt::NoBrush);
    draw({*painter, m_shown, m_theme, Camera(toView), area});
    painter->restore();
}

void TreeLayer::draw(const Canvas &canvas) const
{
    if (canvas.shown.view().tree)
        m_tree.draw(canvas, canvas.shown.picture.view, canvas.shown.state());
}

void NameLayer::draw(const Canvas &canvas) const
{
    const SceneContent &shown = canvas.shown;
    if (shown.name.isEmpty())
        return;
    const QPointF from =
        titleBox(shown, canvas.camera).topLeft() + QPointF(0.0, QFontMetricsF(shown.figures).ascent());
    drawWords(canvas, {from, shown.name, shown.figures, canvas.tokens().ink});
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

void RecordedPointerLayer::draw(const Canvas &canvas) const
{
    const std::optional<sim::Vec2> place = m_session.input().recordedPointer();
    if (!place)
        return;
    canvas.painter.setPen(QPen(canvas.tokens().scene, 4.0, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    canvas.painter.setBrush(canvas.tokens().scene);
    const QPainterPath hand = handShape(canvas.camera.at(*place));
    canvas.painter.drawPath(hand);
    canvas.painter.setPen(QPen(canvas.tokens().ink, 1.5, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    canvas.painter.drawPath(hand);
}

void ArrowLayer::draw(const Canvas &canvas) const
{
    for (const Arrow &arrow : velocityArrows(canvas.shown, canvas.camera, canvas.theme))
        drawArrow(canvas.painter, arrow, canvas.tokens().scene);
    for (const Arrow &arrow : pullArrows(canvas.shown, canvas.camera, canvas.theme))
        drawArrow(canvas.painter, arrow, canvas.tokens().scene);
}

}
