#pragma once

#include "app/ui/scene/canvas.h"

#include <QGraphicsItem>

namespace app {

/// How far the scene goes, in px either way.
constexpr double worldReach = 1e6;

/// All things of one kind, drawn together. Later kinds lie above earlier ones.
class Layer : public QGraphicsItem
{
public:
    Layer(const Shown &shown, const Theme &theme, int height);

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
    RoomLayer(const Shown &shown, const Theme &theme) : Layer(shown, theme, 0) {}

protected:
    void draw(const Canvas &canvas) const override;
};

/// The old run: outlines, never filled.
class GhostLayer : public Layer
{
public:
    GhostLayer(const Shown &shown, const Theme &theme) : Layer(shown, theme, 1) {}

protected:
    void draw(const Canvas &canvas) const override;
};

/// Where the body was.
class TrailLayer : public Layer
{
public:
    TrailLayer(const Shown &shown, const Theme &theme) : Layer(shown, theme, 2) {}

protected:
    void draw(const Canvas &canvas) const override;
};

/// Lines from a body to its feet.
class LegLayer : public Layer
{
public:
    LegLayer(const Shown &shown, const Theme &theme) : Layer(shown, theme, 3) {}

protected:
    void draw(const Canvas &canvas) const override;
};

/// Discs with eyes, and the ring of the selected one.
class BodyLayer : public Layer
{
public:
    BodyLayer(const Shown &shown, const Theme &theme) : Layer(shown, theme, 4) {}

protected:
    void draw(const Canvas &canvas) const override;
};

/// Lines and names that explain.
class GuideLayer : public Layer
{
public:
    GuideLayer(const Shown &shown, const Theme &theme) : Layer(shown, theme, 5) {}

protected:
    void draw(const Canvas &canvas) const override;
};

/// Pulls and velocities.
class ArrowLayer : public Layer
{
public:
    ArrowLayer(const Shown &shown, const Theme &theme) : Layer(shown, theme, 6) {}

protected:
    void draw(const Canvas &canvas) const override;
};

}
