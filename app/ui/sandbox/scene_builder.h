#pragma once

#include "app/model/sandbox/build_guide.h"
#include "app/ui/scene/layers/layers.h"

#include <QObject>
#include <QPointF>

class QKeyEvent;
class QMouseEvent;

namespace app {

class SceneView;

/// The editing marks that are drawn over the scene in a sandbox.
struct BuildMarks
{
    const SandboxEditor *editor = nullptr;
    const BuildGuide *guide = nullptr; ///< the target of its instruction is marked
    std::optional<sim::Vec2> cursor;   ///< the keyboard cursor
    std::optional<sim::Vec2> from;     ///< the start of a link that is being dragged
    std::optional<sim::Vec2> pointer;  ///< the end of a link that is being made
    std::optional<QRectF> box;         ///< the selection rectangle, px of the scene
};

/// A layer with rings round the selected parts, the link that is being made, the selection rectangle, and the
/// keyboard cursor.
class BuildLayer : public Layer
{
public:
    BuildLayer(const BuildMarks &marks, const SceneContent &shown, const Theme &theme)
        : Layer(shown, theme, topLayer, [this](const Canvas &canvas) { draw(canvas); }), m_marks(marks)
    {
    }

private:
    void draw(const Canvas &canvas) const;
    void drawLinkUnderWay(const Canvas &canvas) const;
    void drawTarget(const Canvas &canvas) const;

    const BuildMarks &m_marks;
};

/// Handles the mouse and the keys of the scene view in a sandbox. It sends them to the sandbox editor, so
/// they do not pull the creature.
class SceneBuilder : public QObject
{
    Q_OBJECT

public:
    SceneBuilder(const OpenRun &run, RunEditor &changes, Preview &preview, SandboxEditor &editor,
                 const BuildGuide &guide, SceneView &view, const Theme &theme);

    const BuildMarks &marks() const { return m_marks; }

    static constexpr double reach = 12.0; ///< px of the screen, largest distance of a click that hits a point
    static constexpr double near = 6.0;   ///< px of the screen, largest distance of a click that hits a link

signals:
    /// The learner has pressed a part, which is selected now, or has drawn a box around some.
    void partChosen();

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    bool mouse(QEvent &event);
    bool press(const QMouseEvent &event);
    bool move(const QMouseEvent &event);
    bool release(const QMouseEvent &event);
    void choosePart(const QMouseEvent &event);
    void dragTo(sim::Vec2 place);
    /// Starts to drag a link once the pointer is far enough from where the button was pressed.
    void stretchTo(QPointF at);
    void finishLink(QPointF pressed, QPointF released);
    void stopLink();
    bool keyDown(const QKeyEvent &key);
    bool takes(const QKeyEvent &key) const;
    bool arrow(sim::Vec2 way, Qt::KeyboardModifiers modifiers);
    void chooseWithBox();
    void refresh();

    sim::Vec2 placeOf(QPointF at) const;
    SandboxEditor::End endAt(QPointF at) const;
    int pointAt(QPointF at) const;
    /// Returns the spring, stick or rule link nearest to a place on the screen.
    Selection linkAt(QPointF at) const;
    sim::Vec2 cursor() const;

    RunEditor &m_changes;
    Preview &m_preview;
    SandboxEditor &m_editor;
    SceneView &m_view;
    BuildMarks m_marks;
    std::optional<QPointF> m_pressed; ///< px of the screen
    sim::Vec2 m_moved;                ///< px, how far the selected points were dragged
    bool m_isDragging = false;
    bool m_isBoxing = false;
};

}
