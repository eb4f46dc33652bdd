// Mouse, wheel and key events of the scene view.

#include "app/ui/scene/arrow_key.h"
#include "app/ui/scene/drawing/body_text.h"
#include "app/ui/scene/scene_view.h"
#include "app/ui/theme/focus_ring.h"

#include <QFocusEvent>
#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QNativeGestureEvent>
#include <QToolTip>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>
#include <utility>

namespace app {

namespace {

constexpr double dragStep = 10.0;     ///< px that a key press moves a body
constexpr double rulerStep = 5.0;     ///< px that a key press moves an end of the ruler
constexpr double toolStep = 20.0;     ///< px that a key press moves the pointer or the target
constexpr double wheelOctave = 480.0; ///< eighths of a degree that double the zoom
constexpr double wheelPan = 0.5;      ///< screen px per eighth of a degree

/// Returns whether a wheel event comes from a touch pad. Two fingers on a touch pad pan; a mouse wheel zooms.
bool isPad(const QWheelEvent &event)
{
    return event.device()->type() == QInputDevice::DeviceType::TouchPad ||
           event.phase() != Qt::NoScrollPhase || !event.pixelDelta().isNull();
}

}

void SceneView::mousePressEvent(QMouseEvent *event)
{
    m_session.preview().end(); // a press acts at the cursor of the run
    m_pointer = event->position();
    event->accept();
    if (event->button() == Qt::LeftButton && m_picker.isPicking()) {
        setFocus(Qt::MouseFocusReason);
        m_picker.place(camera().back(m_pointer));
    } else if (event->button() == Qt::LeftButton && takeRuler()) {
        setFocus(Qt::MouseFocusReason);
    } else if (event->button() == Qt::LeftButton) {
        const int point = BodyDrag::bodyAt(m_shown, camera(), m_pointer);
        const bool pointed = point >= 0 && point == m_shown.picture.view->pointerPoint;
        if (pointed)
            m_session.select(nameOf(point));
        const EdgeMarker *outside = point < 0 ? markerAt(m_pointer) : nullptr;
        if (outside) {
            const QString body = nameOf(outside->point);
            m_session.select(body);
            bringBack(body);
        } else if ((point < 0 || pointed) && m_tools.press(camera().back(m_pointer))) {
            setFocus(Qt::MouseFocusReason);
        } else if (point >= 0) {
            m_drag.press(nameOf(point), m_shown.state().positionOf(point), camera().back(m_pointer),
                         m_pointer);
        } else {
            m_panFrom = m_pointer;
        }
    } else if (event->button() == Qt::MiddleButton && !m_drag.isDown()) {
        m_panFrom = m_pointer;
    }
    updateCursor();
}

bool SceneView::takeRuler()
{
    m_ruled = m_shown.extras.ruler ? m_shown.ruler.endAt(camera(), m_pointer) : std::nullopt;
    return m_ruled.has_value();
}

void SceneView::mouseDoubleClickEvent(QMouseEvent *event)
{
    mousePressEvent(event);
}

void SceneView::mouseMoveEvent(QMouseEvent *event)
{
    m_pointer = event->position();
    event->accept();
    if (m_picker.isPicking() && event->buttons() == Qt::LeftButton) {
        m_picker.place(camera().back(m_pointer));
    } else if (m_ruled) {
        m_shown.ruler.at(*m_ruled) = camera().back(m_pointer);
        viewport()->update();
    } else if (m_drag.isDown()) {
        m_drag.carry(camera().back(m_pointer), m_pointer);
    } else if (m_tools.isPointing()) {
        m_tools.moveTo(camera().back(m_pointer));
    } else if (m_panFrom) {
        pan(m_pointer - *m_panFrom);
        m_panFrom = m_pointer;
    } else if (event->buttons() == Qt::NoButton) {
        previewPointed();
    }
    updateCursor();
}

void SceneView::mouseReleaseEvent(QMouseEvent *event)
{
    m_pointer = event->position();
    event->accept();
    if (event->button() == Qt::LeftButton) {
        m_ruled.reset();
        m_drag.release();
        if (m_tools.isPointing())
            m_tools.release();
    }
    if (event->buttons() == Qt::NoButton)
        m_panFrom.reset();
    updateCursor();
}

void SceneView::wheelEvent(QWheelEvent *event)
{
    event->accept();
    const QPointF turn(event->angleDelta());
    if (isPad(*event) && !(event->modifiers() & Qt::ControlModifier)) {
        pan(event->pixelDelta().isNull() ? wheelPan * turn : QPointF(event->pixelDelta()));
        return;
    }
    if (turn.y() == 0.0)
        pan(wheelPan * turn);
    else
        setZoom(transform().m11() * std::exp2(turn.y() / wheelOctave), event->position());
}

void SceneView::keyPressEvent(QKeyEvent *event)
{
    const std::optional<sim::Vec2> way = arrowKey(event->key());
    event->accept();
    const auto modifiers = event->modifiers() & ~Qt::KeypadModifier;
    if (m_picker.wants(*event))
        m_picker.press(*event);
    else if (way && m_shown.extras.ruler &&
             (modifiers & ~Qt::ShiftModifier) == (Qt::AltModifier | Qt::ControlModifier)) {
        sim::Vec2 &end = m_shown.ruler.at(modifiers & Qt::ShiftModifier ? Ruler::End::from : Ruler::End::to);
        end = end + rulerStep * *way;
        viewport()->update();
    } else if (way && modifiers == Qt::AltModifier)
        carrySelected(dragStep * *way);
    else if (event->key() == Qt::Key_BracketRight)
        selectNext();
    else if (event->key() == Qt::Key_BracketLeft)
        selectPrevious();
    else if (event->key() == Qt::Key_Escape && (m_drag.isDown() || m_tools.isPointing())) {
        m_drag.release();
        m_tools.release();
    } else if (!useTools(*event))
        event->ignore(); // arrows and Page Up belong to the window, not to the scroll bars
    updateCursor();
}

bool SceneView::useTools(const QKeyEvent &event)
{
    const sim::Vec2 middle = camera().back(viewRect().center());
    const auto modifiers = event.modifiers() & ~Qt::KeypadModifier;
    const std::optional<sim::Vec2> way = arrowKey(event.key());
    if (way && modifiers == (Qt::AltModifier | Qt::ShiftModifier))
        return m_tools.nudge(toolStep * *way, middle);
    const bool enter = event.key() == Qt::Key_Return || event.key() == Qt::Key_Enter;
    if (enter && modifiers == Qt::AltModifier)
        return m_tools.togglePointer(middle);
    return m_tools.key(event, true);
}

void SceneView::keyReleaseEvent(QKeyEvent *event)
{
    if (m_tools.key(*event, false))
        event->accept();
    else
        QGraphicsView::keyReleaseEvent(event);
}

bool SceneView::event(QEvent *event)
{
    // An arrow key that steers, or moves a cross, must not also step through frames.
    if (event->type() == QEvent::ShortcutOverride) {
        const QKeyEvent &key = *static_cast<QKeyEvent *>(event);
        if (m_tools.wants(key) || m_picker.wants(key)) {
            event->accept();
            return true;
        }
    }
    return QGraphicsView::event(event);
}

void SceneView::selectBeside(int step)
{
    const int count = m_shown.points();
    if (count == 0)
        return;
    const int from = m_shown.selected < 0 ? (step > 0 ? -1 : 0) : m_shown.selected;
    const int next = (from + step + count) % count;
    m_session.select(nameOf(next));
    if (!viewRect().contains(camera().at(m_shown.state().positionOf(next))))
        bringBack(nameOf(next));
}

void SceneView::carrySelected(sim::Vec2 by)
{
    if (m_shown.selected < 0 || m_drag.isDown())
        return;
    const QString body = nameOf(m_shown.selected);
    const sim::Vec2 from = m_shown.state().positionOf(m_shown.selected);
    m_session.input().grab(body);
    m_session.input().moveTo(from + by);
    m_session.input().release();
}

void SceneView::focusInEvent(QFocusEvent *event)
{
    m_shown.focusVisible = isByKeyboard(event->reason());
    QGraphicsView::focusInEvent(event);
    viewport()->update();
}

void SceneView::focusOutEvent(QFocusEvent *event)
{
    m_drag.release();
    m_tools.release();
    m_panFrom.reset();
    m_shown.focusVisible = false;
    QGraphicsView::focusOutEvent(event);
    updateCursor();
    viewport()->update();
}

bool SceneView::viewportEvent(QEvent *event)
{
    if (event->type() == QEvent::Leave) {
        m_pointer = {-1.0, -1.0};
        pointAt({});
        if (m_ownsPreview)
            m_session.preview().end();
    } else if (event->type() == QEvent::NativeGesture) {
        pinch(*static_cast<QNativeGestureEvent *>(event));
        return true;
    } else if (event->type() == QEvent::ToolTip) {
        const auto *help = static_cast<QHelpEvent *>(event);
        QToolTip::showText(help->globalPos(), tipAt(help->pos()), viewport());
        return true;
    }
    return QGraphicsView::viewportEvent(event);
}

void SceneView::pinch(const QNativeGestureEvent &gesture)
{
    if (gesture.gestureType() == Qt::ZoomNativeGesture)
        setZoom(transform().m11() * (1.0 + gesture.value()), gesture.position());
}

const EdgeMarker *SceneView::markerAt(QPointF place)
{
    m_markers = m_overlay.markers(camera(), viewRect());
    for (const EdgeMarker &marker : m_markers) {
        if (marker.contains(place))
            return &marker;
    }
    return nullptr;
}

QString SceneView::tipAt(QPointF place)
{
    const int point = BodyDrag::bodyAt(m_shown, camera(), place);
    if (point >= 0)
        return bodySentence(nameOf(point), m_shown.state().positionOf(point),
                            m_shown.state().velocityOf(point));
    if (const EdgeMarker *marker = markerAt(place))
        return tr("%1: outside of the picture. Click, or press O, to bring it into view.").arg(marker->text);
    return {};
}

void SceneView::showNextOutside()
{
    markerAt({});
    if (m_markers.empty())
        return;
    const auto next = std::find_if(m_markers.begin(), m_markers.end(), [this](const EdgeMarker &marker) {
        return marker.point > m_shown.selected;
    });
    const QString body = nameOf((next == m_markers.end() ? m_markers.front() : *next).point);
    m_session.select(body);
    bringBack(body);
}

void SceneView::updateCursor()
{
    Qt::CursorShape shape = Qt::ArrowCursor;
    int outside = -1;
    if (m_drag.isDown() || m_ruled)
        shape = Qt::ClosedHandCursor;
    else if (m_shown.extras.ruler && m_shown.ruler.endAt(camera(), m_pointer))
        shape = Qt::OpenHandCursor;
    else if (m_panFrom)
        shape = Qt::SizeAllCursor;
    else if (m_tools.isPointing() || m_picker.isPicking())
        shape = Qt::CrossCursor;
    else if (viewRect().contains(m_pointer) && BodyDrag::bodyAt(m_shown, camera(), m_pointer) >= 0)
        shape = Qt::OpenHandCursor;
    else if (const EdgeMarker *marker = viewRect().contains(m_pointer) ? markerAt(m_pointer) : nullptr) {
        shape = Qt::PointingHandCursor;
        outside = marker->point;
    } else if (viewRect().contains(m_pointer) && m_tools.any())
        shape = Qt::CrossCursor;
    if (std::exchange(m_shown.outsidePointedAt, outside) != outside)
        viewport()->update();
    if (viewport()->cursor().shape() != shape)
        viewport()->setCursor(shape);
}

}
