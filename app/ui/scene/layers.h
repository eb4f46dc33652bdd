#pragma once

#include "app/ui/scene/stencil.h"
#include "app/ui/scene/tree_painter.h"

#include <QGraphicsItem>

namespace app {

/// How far the scene goes, in px either way.
constexpr double worldReach = 1e6;

/// Which kinds lie above which: later ones above earlier ones.
enum class Height {
    room,
    ground,
    shadows,
    ghost,
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
    guides,
    arrows,
    names,
    hands,
};

/// All things of one kind, drawn together.
class Layer : public QGraphicsItem
{
public:
    Layer(const Shown &shown, const Theme &theme, Height height);

    QRectF boundingRect() const override;
    void paint(QPainter *painter, const QStyleOptionGraphicsItem *option, QWidget *widget) final;

protected:
    virtual void draw(const Canvas &canvas) const = 0;

private:
    const Shown &m_shown;
    const Theme &m_theme;
};

/// Floor and walls, hatched on their solid side.
class RoomLayer : public Layer
{
public:
    RoomLayer(const Shown &shown, const Theme &theme) : Layer(shown, theme, Height::room) {}

protected:
    void draw(const Canvas &canvas) const override;
};

/// A slanted wall, hatched on its solid side. It is looked for among what acts: a look knows rooms only.
class RampLayer : public Layer
{
public:
    RampLayer(const Shown &shown, const Theme &theme) : Layer(shown, theme, Height::ground) {}

protected:
    void draw(const Canvas &canvas) const override;
};

/// An endless ground, hatched, with a distance every so many px: what stands on it does not stand still.
class GroundLayer : public Layer
{
public:
    GroundLayer(const Shown &shown, const Theme &theme) : Layer(shown, theme, Height::ground) {}

protected:
    void draw(const Canvas &canvas) const override;
};

/// Soft shadows of discs.
class ShadowLayer : public Layer
{
public:
    ShadowLayer(const Shown &shown, const Theme &theme) : Layer(shown, theme, Height::shadows) {}

protected:
    void draw(const Canvas &canvas) const override;
};

/// The old run: outlines, never filled.
class GhostLayer : public Layer
{
public:
    GhostLayer(const Shown &shown, const Theme &theme) : Layer(shown, theme, Height::ghost) {}

protected:
    void draw(const Canvas &canvas) const override;

private:
    mutable TreePainter m_tree; ///< keeps what painting needs from one time to the next
};

/// Earlier moments, the earlier the fainter.
class OnionLayer : public Layer
{
public:
    OnionLayer(const Shown &shown, const Theme &theme) : Layer(shown, theme, Height::onion) {}

protected:
    void draw(const Canvas &canvas) const override;

private:
    mutable TreePainter m_tree; ///< keeps what painting needs from one time to the next
};

/// Where the body was.
class TrailLayer : public Layer
{
public:
    TrailLayer(const Shown &shown, const Theme &theme) : Layer(shown, theme, Height::trail) {}

protected:
    void draw(const Canvas &canvas) const override;
};

/// Branches and blossoms.
class TreeLayer : public Layer
{
public:
    TreeLayer(const Shown &shown, const Theme &theme) : Layer(shown, theme, Height::tree) {}

protected:
    void draw(const Canvas &canvas) const override;

private:
    mutable TreePainter m_tree; ///< keeps what painting needs from one time to the next
};

/// The near ground below an open sky. Branches that are below it show through.
class MeadowLayer : public Layer
{
public:
    MeadowLayer(const Shown &shown, const Theme &theme) : Layer(shown, theme, Height::meadow) {}

protected:
    void draw(const Canvas &canvas) const override;

private:
    mutable TreePainter m_tree; ///< keeps what painting needs from one time to the next
};

/// Flesh round sticks.
class LimbLayer : public Layer
{
public:
    LimbLayer(const Shown &shown, const Theme &theme) : Layer(shown, theme, Height::limbs) {}

protected:
    void draw(const Canvas &canvas) const override;
};

/// Soft matter between springs.
class SheetLayer : public Layer
{
public:
    SheetLayer(const Shown &shown, const Theme &theme) : Layer(shown, theme, Height::skins) {}

protected:
    void draw(const Canvas &canvas) const override;
};

/// Springs as coils.
class SpringLayer : public Layer
{
public:
    SpringLayer(const Shown &shown, const Theme &theme) : Layer(shown, theme, Height::springs) {}

protected:
    void draw(const Canvas &canvas) const override;
};

/// Bodies with a soft outline.
class SkinLayer : public Layer
{
public:
    SkinLayer(const Shown &shown, const Theme &theme) : Layer(shown, theme, Height::skins) {}

protected:
    void draw(const Canvas &canvas) const override;
};

/// Tentacles.
class ChainLayer : public Layer
{
public:
    ChainLayer(const Shown &shown, const Theme &theme) : Layer(shown, theme, Height::chains) {}

protected:
    void draw(const Canvas &canvas) const override;
};

/// Lines from a body to its feet.
class LegLayer : public Layer
{
public:
    LegLayer(const Shown &shown, const Theme &theme) : Layer(shown, theme, Height::legs) {}

protected:
    void draw(const Canvas &canvas) const override;

private:
    mutable Stencil m_stencil; ///< keeps its memory from one time to the next
};

/// Sticks, in the colour of their error.
class StickLayer : public Layer
{
public:
    StickLayer(const Shown &shown, const Theme &theme) : Layer(shown, theme, Height::sticks) {}

protected:
    void draw(const Canvas &canvas) const override;
};

/// Discs with eyes, and the ring of the selected one.
class BodyLayer : public Layer
{
public:
    BodyLayer(const Shown &shown, const Theme &theme) : Layer(shown, theme, Height::bodies) {}

protected:
    void draw(const Canvas &canvas) const override;

private:
    mutable Stencil m_stencil; ///< keeps its memory from one time to the next
};

/// How long springs and sticks are at rest: a bar where the end of one would be then, or a ring where that is a place of
/// its own, with a dashed line to it.
class RestLayer : public Layer
{
public:
    RestLayer(const Shown &shown, const Theme &theme) : Layer(shown, theme, Height::rests) {}

protected:
    void draw(const Canvas &canvas) const override;
};

/// Where an exact solution has the bodies: dashed outlines, and how far each body is from its own.
class ReferenceLayer : public Layer
{
public:
    ReferenceLayer(const Shown &shown, const Theme &theme) : Layer(shown, theme, Height::reference) {}

protected:
    void draw(const Canvas &canvas) const override;
};

/// Lines and names that explain.
class GuideLayer : public Layer
{
public:
    GuideLayer(const Shown &shown, const Theme &theme) : Layer(shown, theme, Height::guides) {}

protected:
    void draw(const Canvas &canvas) const override;
};

/// Who a figure is, where there are two.
class NameLayer : public Layer
{
public:
    NameLayer(const Shown &shown, const Theme &theme) : Layer(shown, theme, Height::names) {}

protected:
    void draw(const Canvas &canvas) const override;
};

/// The hand of a run that is played again, so that nothing seems to move by itself.
class RecordedHandLayer : public Layer
{
public:
    RecordedHandLayer(const Session &session, const Shown &shown, const Theme &theme)
        : Layer(shown, theme, Height::hands), m_session(session)
    {
    }

protected:
    void draw(const Canvas &canvas) const override;

private:
    const Session &m_session;
};

/// Pulls and velocities.
class ArrowLayer : public Layer
{
public:
    ArrowLayer(const Shown &shown, const Theme &theme) : Layer(shown, theme, Height::arrows) {}

protected:
    void draw(const Canvas &canvas) const override;
};

}
