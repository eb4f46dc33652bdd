#pragma once

#include "app/model/build_guide.h"
#include "app/ui/scene/layers.h"

#include <QObject>
#include <QPointF>

class QKeyEvent;
class QMouseEvent;

namespace app {

class SceneView;

/// What is drawn over the scene while it is built.
struct BuildMarks
{
    const Workbench *bench = nullptr;
    const BuildGuide *guide = nullptr; ///< what it asks for is marked
    std::optional<sim::Vec2> cursor;   ///< where the keyboard builds
    std::optional<sim::Vec2> from;     ///< where the link that is dragged begins
    std::optional<sim::Vec2> pointer;  ///< where a link under way would end
    std::optional<QRectF> box;         ///< that chooses, px of the scene
};

/// Rings round what is chosen, the link under way, the box that chooses, and the keyboard's cross.
class BuildLayer : public Layer
{
public:
    BuildLayer(const BuildMarks &marks, const Shown &shown, const Theme &theme)
        : Layer(shown, theme, Height::names), m_marks(marks)
    {
    }

protected:
    void draw(const Canvas &canvas) const override;

private:
    void drawLinkUnderWay(const Canvas &canvas) const;
    void drawAsked(const Canvas &canvas) const;

    const BuildMarks &m_marks;
};

/// Mouse and keys of the scene view while a scene is built: they go to the workbench in place of the hand.
class SceneBuilder : public QObject
{
    Q_OBJECT

public:
    SceneBuilder(Session &session, Workbench &bench, const BuildGuide &guide, SceneView &view,
                 const Theme &theme);

    const BuildMarks &marks() const { return m_marks; }

    static constexpr double reach = 12.0; ///< px of the screen, from which a point is hit
    static constexpr double near = 6.0;   ///< px of the screen, from which a link is hit

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    bool mouse(QEvent &event);
    bool press(const QMouseEvent &event);
    bool move(const QMouseEvent &event);
    bool release(const QMouseEvent &event);
    void choosePart(const QMouseEvent &event);
    void dragTo(sim::Vec2 place);
    /// Begins to drag a link, once the pointer has gone far enough from where the button went down.
    void stretchTo(QPointF at);
    void finishLink(QPointF pressed, QPointF released);
    void stopLink();
    bool keyDown(const QKeyEvent &key);
    bool takes(const QKeyEvent &key) const;
    bool arrow(sim::Vec2 way, Qt::KeyboardModifiers modifiers);
    void chooseWithBox();
    void refresh();

    sim::Vec2 placeOf(QPointF at) const;
    Workbench::End endAt(QPointF at) const;
    int pointAt(QPointF at) const;
    /// The spring or stick nearest to a place of the screen.
    Chosen linkAt(QPointF at) const;
    sim::Vec2 cursor() const;

    Session &m_session;
    Workbench &m_bench;
    SceneView &m_view;
    BuildMarks m_marks;
    std::optional<QPointF> m_pressed; ///< px of the screen
    sim::Vec2 m_moved;                ///< px, how far the chosen points were dragged
    bool m_isDragging = false;
    bool m_isBoxing = false;
};

}
