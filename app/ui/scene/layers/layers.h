#pragma once

#include "app/ui/scene/layers/stencil.h"
#include "app/ui/scene/layers/tree_painter.h"

#include <QGraphicsItem>

#include <functional>

class QGraphicsScene;

namespace app {

class UserInput;

/// The extent of the scene in each direction, px.
constexpr double worldReach = 1e6;

/// The z value of a layer above the scene's own.
constexpr double topLayer = 100.0;

/// A layer of the scene, which draws all things of one kind.
class Layer : public QGraphicsItem
{
public:
    using Draw = std::function<void(const Canvas &)>;

    Layer(const SceneContent &shown, const Theme &theme, double z, Draw draw);

    QRectF boundingRect() const override;
    void paint(QPainter *painter, const QStyleOptionGraphicsItem *option, QWidget *widget) override;

private:
    const SceneContent &m_shown;
    const Theme &m_theme;
    Draw m_draw;
};

/// Adds the layers of the run to `scene`, with the pointer that `input` has recorded.
void addLayers(QGraphicsScene &scene, const SceneContent &shown, const Theme &theme, const UserInput &input);
/// Adds the layers of the run that goes along beside it.
void addCompanionLayers(QGraphicsScene &scene, const SceneContent &shown, const Theme &theme);

// What the layers draw. A painter or a stencil keeps its memory between two paints.

/// Draws the floor and the walls, hatched on their solid side.
void drawRoom(const Canvas &canvas);
/// Draws a ramp, hatched on its solid side. It looks for the ramp among the scene's effects, because lesson views have
/// only rooms.
void drawRamps(const Canvas &canvas);
/// Draws an endless hatched ground with distance labels, which show how far a creature has moved.
void drawGround(const Canvas &canvas);
/// Draws soft shadows of discs.
void drawShadows(const Canvas &canvas);
/// Draws the ghost of the comparison run as outlines.
void drawComparison(const Canvas &canvas, TreePainter &tree);
/// Draws earlier moments; the earlier, the fainter.
void drawOnion(const Canvas &canvas, TreePainter &tree);
/// Draws the recent path of the bodies.
void drawTrail(const Canvas &canvas);
/// Draws branches and blossoms.
void drawTree(const Canvas &canvas, TreePainter &tree);
/// Draws the near ground below an open sky. Branches below the ground show through, and so does the ghost.
void drawNearGround(const Canvas &canvas, TreePainter &tree);
/// Draws limbs around sticks.
void drawLimbs(const Canvas &canvas);
/// Draws bodies with a soft outline.
void drawSkins(const Canvas &canvas);
/// Draws the soft material between springs.
void drawSheets(const Canvas &canvas);
/// Draws tentacles.
void drawChains(const Canvas &canvas);
/// Draws legs from a body to its feet.
void drawLegs(const Canvas &canvas, Stencil &stencil);
/// Draws springs as coils.
void drawSprings(const Canvas &canvas);
/// Draws sticks, coloured by their error.
void drawSticks(const Canvas &canvas);
/// Draws the links along which the learner's rule acts.
void drawRuleLinks(const Canvas &canvas);
/// Draws discs with eyes, and a ring around the selected body.
void drawBodies(const Canvas &canvas, Stencil &stencil);
/// Draws the rest lengths of springs and sticks: a bar across the link at its rest length. Where the rest position is
/// off the link, it draws a ring there and a dashed line to it.
void drawRests(const Canvas &canvas);
/// Draws the positions of the exact solution as dashed outlines, with a line from each body to its exact position.
void drawReference(const Canvas &canvas);
/// Draws the step's explaining lines and their labels.
void drawOverlays(const Canvas &canvas);
/// Draws force and velocity arrows.
void drawArrows(const Canvas &canvas);
/// Draws the Vec2 of the listing under the mouse, with its name: a cross at a place, an arrow for a difference.
void drawVector(const Canvas &canvas);
/// Draws the right triangle of the arrow whose angle the unit circle shows: the side beside the angle as a line, the
/// opposite one dashed.
void drawTriangle(const Canvas &canvas);
/// Draws the name of each of two figures.
void drawName(const Canvas &canvas);
/// Draws the hand of a recorded run, so that nothing seems to move by itself.
void drawPointer(const Canvas &canvas, const UserInput &input);

}
