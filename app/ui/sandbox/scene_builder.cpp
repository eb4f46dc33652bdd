#include "app/ui/sandbox/scene_builder.h"

#include "app/ui/scene/arrow_key.h"
#include "app/ui/scene/body_drag.h"
#include "app/ui/scene/scene_view.h"

#include <QKeyEvent>
#include <QLineF>
#include <QMouseEvent>

#include <algorithm>
#include <cmath>

namespace app {

namespace {

constexpr double clickSlack = 3.0; ///< px of the screen that a click may move
constexpr double dragLink = 10.0;  ///< px of the screen from which a drag makes a link
constexpr double snapDistance =
    8.0; ///< px of the screen, how far a click may be from the place that the guide asks for
constexpr double stride = 10.0;    ///< px that an arrow key moves the cursor
constexpr double fineStride = 1.0; ///< px, with Shift

bool isInput(const QEvent &event)
{
    switch (event.type()) {
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonDblClick:
    case QEvent::MouseMove:
    case QEvent::MouseButtonRelease:
    case QEvent::ShortcutOverride:
    case QEvent::KeyPress:
        return true;
    default:
        return false;
    }
}

bool isEnter(int key)
{
    return key == Qt::Key_Return || key == Qt::Key_Enter;
}

sim::Vec2 rounded(sim::Vec2 place)
{
    return {std::round(place.x), std::round(place.y)};
}

/// Returns the distance of `at` from the segment from `a` to `b`.
double distanceTo(QPointF at, QPointF a, QPointF b)
{
    const QPointF way = b - a;
    const double square = QPointF::dotProduct(way, way);
    const double share = square > 0.0 ? std::clamp(QPointF::dotProduct(at - a, way) / square, 0.0, 1.0) : 0.0;
    return QLineF(at, a + share * way).length();
}

}

SceneBuilder::SceneBuilder(const OpenRun &run, RunEditor &changes, Preview &preview, SandboxEditor &editor,
                           const BuildGuide &guide, SceneView &view, const Theme &theme)
    : QObject(&view), m_changes(changes), m_preview(preview), m_editor(editor), m_view(view)
{
    m_marks.editor = &editor;
    m_marks.guide = &guide;
    view.scene()->addItem(new BuildLayer(m_marks, view.shown(), theme));
    view.installEventFilter(this);
    view.viewport()->installEventFilter(this);
    connect(&editor, &SandboxEditor::changed, this, &SceneBuilder::refresh);
    connect(&guide, &BuildGuide::changed, this, &SceneBuilder::refresh);
    connect(&editor, &SandboxEditor::replaced, &view,
            &SceneView::fit); // the view may have followed the previous scene
    run.onChange(ChangeKind::selection, this, [this] {
        // The keys that select a body also move the keyboard cursor.
        const int point = m_view.shown().selected;
        if (m_marks.cursor && m_editor.isOpen() && point >= 0)
            m_marks.cursor = m_view.shown().state().positionOf(point);
    });
}

void SceneBuilder::refresh()
{
    if (m_editor.tool() == BuildTool::select || !m_editor.canBuild())
        m_marks.cursor.reset();
    if (!isLinkTool(m_editor.tool()))
        m_marks.from.reset();
    if (!m_editor.first() && !m_marks.from)
        m_marks.pointer.reset();
    if (!m_editor.canBuild()) {
        m_marks.from.reset();
        m_pressed.reset();
        m_isDragging = m_isBoxing = false;
        m_marks.box.reset();
    }
    m_view.viewport()->update();
}

bool SceneBuilder::eventFilter(QObject *watched, QEvent *event)
{
    // While the view is being destroyed, the objects used below may no longer exist.
    if (!isInput(*event) || !m_editor.isOpen())
        return QObject::eventFilter(watched, event);
    if (event->type() != QEvent::MouseMove)
        m_preview.end(); // edits act at the cursor of the run
    if (watched == m_view.viewport() && mouse(*event))
        return true;
    if (watched == &m_view && event->type() == QEvent::ShortcutOverride &&
        takes(*static_cast<QKeyEvent *>(event))) {
        event->accept();
        return true;
    }
    if (watched == &m_view && event->type() == QEvent::KeyPress &&
        keyDown(*static_cast<QKeyEvent *>(event))) {
        event->accept();
        return true;
    }
    return QObject::eventFilter(watched, event);
}

bool SceneBuilder::mouse(QEvent &event)
{
    switch (event.type()) {
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonDblClick:
        return press(static_cast<QMouseEvent &>(event));
    case QEvent::MouseMove:
        return move(static_cast<QMouseEvent &>(event));
    case QEvent::MouseButtonRelease:
        return release(static_cast<QMouseEvent &>(event));
    default:
        return false;
    }
}

sim::Vec2 SceneBuilder::placeOf(QPointF at) const
{
    const Camera camera(m_view.viewportTransform());
    const auto target = m_marks.guide->isOn() ? m_marks.guide->place() : std::nullopt;
    const bool isMeant = target && QLineF(camera.at(*target), at).length() <= snapDistance;
    return isMeant ? *target : camera.back(at);
}

int SceneBuilder::pointAt(QPointF at) const
{
    return BodyDrag::bodyAt(m_view.shown(), Camera(m_view.viewportTransform()), at);
}

Selection SceneBuilder::linkAt(QPointF at) const
{
    const Camera camera(m_view.viewportTransform());
    const auto distance = [&](const auto &link) {
        const std::vector<sim::BlueprintPoint> &points = m_editor.plan().points;
        return distanceTo(at, camera.at(points[std::size_t(link.a)].x),
                          camera.at(points[std::size_t(link.b)].x));
    };
    Selection nearest;
    double least = near;
    const auto findIn = [&](const auto &links, std::vector<int> Selection::*list) {
        for (std::size_t i = 0; i < links.size(); ++i) {
            const double away = distance(links[i]);
            if (away >= least)
                continue;
            least = away;
            nearest = {};
            nearest.*list = {static_cast<int>(i)};
        }
    };
    findIn(m_editor.plan().springs, &Selection::springs);
    findIn(m_editor.plan().sticks, &Selection::sticks);
    findIn(m_editor.plan().ruleLinks, &Selection::ruleLinks); // one that lies on a spring is behind it
    return nearest;
}

bool SceneBuilder::press(const QMouseEvent &event)
{
    if (event.button() != Qt::LeftButton)
        return false;
    const bool builds = m_editor.tool() != BuildTool::select;
    if (!m_editor.canBuild()) {
        if (builds) // the empty edit shows why the scene cannot be edited now
            m_editor.change({}, [](sim::Blueprint &) {});
        return builds;
    }
    m_view.setFocus(Qt::MouseFocusReason);
    m_marks.cursor.reset();
    m_pressed = event.position();
    m_moved = {};
    if (!builds)
        choosePart(event);
    else if (!isLinkTool(m_editor.tool())) // for links, the release decides between click and drag
        m_editor.use(rounded(placeOf(event.position())), pointAt(event.position()));
    return true;
}

void SceneBuilder::choosePart(const QMouseEvent &event)
{
    const bool adds = event.modifiers() & Qt::ShiftModifier;
    const int point = pointAt(event.position());
    if (point >= 0) {
        const std::vector<int> &chosen = m_editor.chosen().points;
        if (adds)
            m_editor.toggle({{point}, {}, {}});
        else if (!std::binary_search(chosen.begin(), chosen.end(), point))
            m_editor.choose({{point}, {}, {}});
        m_isDragging = true;
        emit partChosen();
        return;
    }
    const Selection link = linkAt(event.position());
    if (link.isEmpty()) {
        m_isBoxing = true;
        return;
    }
    if (adds)
        m_editor.toggle(link);
    else
        m_editor.choose(link);
    emit partChosen();
}

bool SceneBuilder::move(const QMouseEvent &event)
{
    if (!m_editor.canBuild())
        return false;
    const bool builds = m_editor.tool() != BuildTool::select;
    if (m_pressed && isLinkTool(m_editor.tool()))
        stretchTo(event.position());
    if (m_editor.first() || m_marks.from) {
        m_marks.pointer = placeOf(event.position());
        m_view.viewport()->update();
    }
    if (builds)
        m_view.viewport()->setCursor(Qt::CrossCursor);
    if (!m_pressed)
        return builds;
    const bool isClick = QLineF(*m_pressed, event.position()).length() < clickSlack;
    if (m_isDragging && (!isClick || m_moved != sim::Vec2{}))
        dragTo(placeOf(event.position()));
    if (m_isBoxing && !isClick) {
        const sim::Vec2 from = placeOf(*m_pressed), to = placeOf(event.position());
        m_marks.box = QRectF(QPointF(from.x, from.y), QPointF(to.x, to.y)).normalized();
        m_view.viewport()->update();
    }
    return true;
}

void SceneBuilder::dragTo(sim::Vec2 place)
{
    const sim::Vec2 total = rounded(place - placeOf(*m_pressed));
    m_editor.moveChosen(total - m_moved);
    m_moved = total;
}

bool SceneBuilder::release(const QMouseEvent &event)
{
    if (event.button() != Qt::LeftButton || !m_pressed)
        return false;
    const QPointF pressed = *std::exchange(m_pressed, std::nullopt);
    if (m_isDragging)
        m_changes.endGesture();
    if (m_isBoxing)
        chooseWithBox();
    m_isDragging = m_isBoxing = false;
    if (isLinkTool(m_editor.tool()))
        finishLink(pressed, event.position());
    return true;
}

SandboxEditor::End SceneBuilder::endAt(QPointF at) const
{
    return {rounded(placeOf(at)), pointAt(at)};
}

void SceneBuilder::stretchTo(QPointF at)
{
    if (m_marks.from || QLineF(*m_pressed, at).length() <= dragLink)
        return;
    const SandboxEditor::End from = endAt(*m_pressed);
    m_marks.from = from.hit < 0 ? from.at : m_editor.plan().points[std::size_t(from.hit)].x;
}

void SceneBuilder::finishLink(QPointF pressed, QPointF released)
{
    const bool isFar = QLineF(pressed, released).length() > dragLink;
    const bool wasDragged = m_marks.from.has_value();
    stopLink();
    if (isFar) // even if no move event arrived on the way
        m_editor.drag(endAt(pressed), endAt(released));
    else if (!wasDragged) // a drag that returns to its start is cancelled
        m_editor.use(rounded(placeOf(pressed)), pointAt(pressed));
}

void SceneBuilder::stopLink()
{
    m_pressed.reset();
    m_marks.from.reset();
    if (!m_editor.first())
        m_marks.pointer.reset();
    m_view.viewport()->update();
}

void SceneBuilder::chooseWithBox()
{
    const std::optional<QRectF> box = std::exchange(m_marks.box, std::nullopt);
    if (box)
        m_editor.choose(inBox(m_editor.plan(), {box->left(), box->top()}, {box->right(), box->bottom()}));
    else
        m_editor.choose({});
    emit partChosen();
    m_view.viewport()->update();
}

bool SceneBuilder::takes(const QKeyEvent &key) const
{
    if (!m_editor.canBuild() || m_editor.tool() == BuildTool::select)
        return false;
    const auto modifiers = key.modifiers() & ~(Qt::KeypadModifier | Qt::ShiftModifier);
    return modifiers == Qt::NoModifier && (arrowKey(key.key()) || isEnter(key.key()));
}

sim::Vec2 SceneBuilder::cursor() const
{
    if (m_marks.cursor)
        return *m_marks.cursor;
    if (m_editor.first())
        return m_editor.plan().points[std::size_t(*m_editor.first())].x;
    // Starts at the highlighted point, so that Enter links it or nails it down. A new point must go
    // elsewhere.
    const int ringed = m_view.shown().selected;
    if (ringed >= 0 && m_editor.tool() != BuildTool::point)
        return m_view.shown().state().positionOf(ringed);
    return rounded(placeOf(QPointF(m_view.viewport()->rect().center())));
}

bool SceneBuilder::arrow(sim::Vec2 way, Qt::KeyboardModifiers modifiers)
{
    const double far = modifiers & Qt::ShiftModifier ? fineStride : stride;
    if (modifiers & Qt::AltModifier) {
        if (m_editor.chosen().points.empty() || !m_editor.canBuild())
            return false;
        m_editor.moveChosen(far * way);
        m_changes.endGesture();
        return true;
    }
    m_marks.cursor = cursor() + far * way;
    m_view.viewport()->update();
    return true;
}

bool SceneBuilder::keyDown(const QKeyEvent &key)
{
    if (key.key() == Qt::Key_Escape && m_marks.from) {
        stopLink();
        return true;
    }
    if (key.key() == Qt::Key_Escape)
        return m_editor.leave();
    if (key.key() == Qt::Key_BraceRight || key.key() == Qt::Key_BraceLeft) {
        m_editor.chooseNextLink(key.key() == Qt::Key_BraceRight ? 1 : -1);
        return true;
    }
    const std::optional<sim::Vec2> way = arrowKey(key.key());
    const bool carries = way && (key.modifiers() & Qt::AltModifier);
    if (!carries && !takes(key))
        return false;
    if (way)
        return arrow(*way, key.modifiers());
    m_marks.cursor = cursor();
    const Camera camera(m_view.viewportTransform());
    m_editor.use(*m_marks.cursor, pointAt(camera.at(*m_marks.cursor)));
    return true;
}

}
