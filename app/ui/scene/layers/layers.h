#pragma once

#include "app/ui/scene/layers/stencil.h"
#include "app/ui/scene/layers/tree_painter.h"

#include <QGraphicsItem>

namespace app {

/// The extent of the scene in each direction, px.
constexpr double worldReach = 1e6;

/// The stacking order of the layers: later ones are above earlier ones.
enum class Height {
    room,
    ground,
    shadows,
    comparison,
    onion,
    trail,
    tree,
    meadow,
    limbs,
    skins,
    chains,
    legs,
    springs,
    sticks,
    bodies,
    rests,
    reference,
    overlays,
    arrows,
    vectors,
    names,
    pointers,
};

/// A layer that draws all things of one kind.
class Layer : public QGraphicsItem
{
public:
    Layer(const SceneContent &shown, const Theme &theme, Height height);

    QRectF boundingRect() const override;
    void paint(QPainter *painter, const QStyleOptionGraphicsItem *option, QWidget *widget) final;

protected:
    virtual void draw(const Canvas &canvas) const = 0;

private:
    const SceneContent &m_shown;
    const Theme &m_theme;
};

/// Draws the floor and the walls, hatched on their solid side.
class RoomLayer : public Layer
{
public:
    RoomLayer(const SceneContent &shown, const Theme &theme) : Layer(shown, theme, Height::room) {}

protected:
    void draw(const Canvas &canvas) const override;
};

/// Draws a ramp, hatched on its solid side. It looks for the ramp among the scene's effects, because lesson
/// views have only rooms.
class RampLayer : public Layer
{
public:
    RampLayer(const SceneContent &shown, const Theme &theme) : Layer(shown, theme, Height::ground) {}

protected:
    void draw(const Canvas &canvas) const override;
};

/// Draws an endless hatched ground with distance labels, which show how far a creature has moved.
class GroundLayer : public Layer
{
public:
    GroundLayer(const SceneContent &shown, const Theme &theme) : Layer(shown, theme, Height::ground) {}

protected:
    void draw(const Canvas &canvas) const override;
};

/// Draws soft shadows of discs.
class ShadowLayer : public Layer
{
public:
    ShadowLayer(const SceneContent &shown, const Theme &theme) : Layer(shown, theme, Height::shadows) {}

protected:
    void draw(const Canvas &canvas) const override;
};

/// Draws the ghost of the comparison run as outlines.
class ComparisonLayer : public Layer
{
public:
    ComparisonLayer(const SceneContent &shown, const Theme &theme) : Layer(shown, theme, Height::comparison)
    {
    }

protected:
    void draw(const Canvas &canvas) const override;

private:
    mutable TreePainter m_tree; ///< keeps its caches and working memory between paints
};

/// Draws earlier moments; the earlier, the fainter.
class OnionLayer : public Layer
{
public:
    OnionLayer(const SceneContent &shown, const Theme &theme) : Layer(shown, theme, Height::onion) {}

protected:
    void draw(const Canvas &canvas) const override;

private:
    mutable TreePainter m_tree; ///< keeps its caches and working memory between paints
};

/// Draws the recent path of the bodies.
class TrailLayer : public Layer
{
public:
    TrailLayer(const SceneContent &shown, const Theme &theme) : Layer(shown, theme, Height::trail) {}

protected:
    void draw(const Canvas &canvas) const override;
};

/// Draws branches and blossoms.
class TreeLayer : public Layer
{
public:
    TreeLayer(const SceneContent &shown, const Theme &theme) : Layer(shown, theme, Height::tree) {}

protected:
    void draw(const Canvas &canvas) const override;

private:
    mutable TreePainter m_tree; ///< keeps its caches and working memory between paints
};

/// Draws the near ground below an open sky. Branches below the ground show through.
class MeadowLayer : public Layer
{
public:
    MeadowLayer(const SceneContent &shown, const Theme &theme) : Layer(shown, theme, Height::meadow) {}

protected:
    void draw(const Canvas &canvas) const override;

private:
    mutable TreePainter m_tree; ///< keeps its caches and working memory between paints
};

/// Draws limbs around sticks.
class LimbLayer : public Layer
{
public:
    LimbLayer(const SceneContent &shown, const Theme &theme) : Layer(shown, theme, Height::limbs) {}

protected:
    void draw(const Canvas &canvas) const override;
};

/// Draws the soft material between springs.
class SheetLayer : public Layer
{
public:
    SheetLayer(const SceneContent &shown, const Theme &theme) : Layer(shown, theme, Height::skins) {}

protected:
    void draw(const Canvas &canvas) const override;
};

/// Draws springs as coils.
class SpringLayer : public Layer
{
public:
    SpringLayer(const SceneContent &shown, const Theme &theme) : Layer(shown, theme, Height::springs) {}

protected:
    void draw(const Canvas &canvas) const override;
};

/// Draws bodies with a soft outline.
class SkinLayer : public Layer
{
public:
    SkinLayer(const SceneContent &shown, const Theme &theme) : Layer(shown, theme, Height::skins) {}

protected:
    void draw(const Canvas &canvas) const override;
};

/// Draws tentacles.
class ChainLayer : public Layer
{
public:
    ChainLayer(const SceneContent &shown, const Theme &theme) : Layer(shown, theme, Height::chains) {}

protected:
    void draw(const Canvas &canvas) const override;
};

/// Draws legs from a body to its feet.
class LegLayer : public Layer
{
public:
    LegLayer(const SceneContent &shown, const Theme &theme) : Layer(shown, theme, Height::legs) {}

protected:
    void draw(const Canvas &canvas) const override;

private:
    mutable Stencil m_stencil; ///< keeps its memory between paints
};

/// Draws sticks, coloured by their error.
class StickLayer : public Layer
{
public:
    StickLayer(const SceneContent &shown, const Theme &theme) : Layer(shown, theme, Height::sticks) {}

protected:
    void draw(const Canvas &canvas) const override;
};

/// Draws discs with eyes, and a ring around the selected body.
class BodyLayer : public Layer
{
public:
    BodyLayer(const SceneContent &shown, const Theme &theme) : Layer(shown, theme, Height::bodies) {}

protected:
    void draw(const Canvas &canvas) const override;

private:
    mutable Stencil m_stencil; ///< keeps its memory between paints
};

/// Draws the rest lengths of springs and sticks: a bar across the link at its rest length. Where the rest
/// position is off the link, it draws a ring there and a dashed line to it.
class RestLayer : public Layer
{
public:
    RestLayer(const SceneContent &shown, const Theme &theme) : Layer(shown, theme, Height::rests) {}

protected:
    void draw(const Canvas &canvas) const override;
};

/// Draws the positions of the exact solution as dashed outlines, with a line from each body to its exact
/// position.
class ReferenceLayer : public Layer
{
public:
    ReferenceLayer(const SceneContent &shown, const Theme &theme) : Layer(shown, theme, Height::reference) {}

protected:
    void draw(const Canvas &canvas) const override;
};

/// Draws the step's explaining lines and their labels.
class OverlayLayer : public Layer
{
public:
    OverlayLayer(const SceneContent &shown, const Theme &theme) : Layer(shown, theme, Height::overlays) {}

protected:
    void draw(const Canvas &canvas) const override;
};

/// Draws the Vec2 of the listing under the mouse, with its name: a cross at a place, an arrow for a difference.
class VectorLayer : public Layer
{
public:
    VectorLayer(const SceneContent &shown, const Theme &theme) : Layer(shown, theme, Height::vectors) {}

protected:
    void draw(const Canvas &canvas) const override;
};

/// Draws the name of each of two figures.
class NameLayer : public Layer
{
public:
    NameLayer(const SceneContent &shown, const Theme &theme) : Layer(shown, theme, Height::names) {}

protected:
    void draw(const Canvas &canvas) const override;
};

/// Draws the hand of a recorded run, so that nothing seems to move by itself.
class RecordedPointerLayer : public Layer
{
public:
    RecordedPointerLayer(const Session &session, const SceneContent &shown, const Theme &theme)
        : Layer(shown, theme, Height::pointers), m_session(session)
    {
    }

protected:
    void draw(const Canvas &canvas) const override;

private:
    const Session &m_session;
};

/// Draws force and velocity arrows.
class ArrowLayer : public Layer
{
public:
    ArrowLayer(const SceneContent &shown, const Theme &theme) : Layer(shown, theme, Height::arrows) {}

protected:
    void draw(const Canvas &canvas) const override;
};

}
