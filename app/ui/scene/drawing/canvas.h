#pragma once

#include "app/ui/scene/layers/scene_content.h"

#include <QPainter>
#include <QPolygonF>
#include <QTransform>

namespace app {

/// Converts between scene px and screen px.
struct Camera
{
    QTransform toView;
    double zoom = 1.0; ///< screen px per scene px

    explicit Camera(const QTransform &transform) : toView(transform), zoom(transform.m11()) {}
    /// Converts a scene position to screen px. Clamps positions that are too far away for the painter.
    QPointF at(sim::Vec2 place) const;
    sim::Vec2 back(QPointF place) const;
    /// Returns the drawn radius of a body, screen px. It has a minimum, so that small bodies stay visible.
    double radius(double px) const;
};

/// The painter and the scene content that a layer draws with. The painter works in screen px, so that lines and marks
/// have the same size at every zoom.
struct Canvas
{
    QPainter &painter;
    const SceneContent &shown;
    const Theme &theme;
    Camera camera;
    QRectF area; ///< the exposed area to paint

    const Tokens &tokens() const { return theme.tokens(); }
    /// Returns the radius of the disc drawn for a point, screen px; 0 if the point is drawn as something else.
    double discRadius(int point) const
    {
        return shown.isHidden(point) ? 0.0 : camera.radius(shown.radius(point));
    }
    /// Returns whether a disc is visible.
    bool reaches(QPointF centre, double radius) const;
    /// Returns the visible part of a line; null if none of it is visible.
    QLineF cut(QPointF from, QPointF to) const;
    /// Clips a polygon to the visible area, by the method of Sutherland and Hodgman. Without clipping, Qt takes
    /// seconds to fill a polygon that reaches a million pixels outside the view.
    QPolygonF cut(QPolygonF polygon) const;
};

/// Returns a pen of constant width, with a dash pattern in screen px.
QPen dashed(const QColor &color, double width, std::initializer_list<double> pattern);
QPen solid(const QColor &color, double width);
QColor faded(QColor color, double alpha);

/// A text drawn in the scene.
struct Words
{
    QPointF from; ///< the left end of the baseline, screen px
    QString text;
    QFont font;
    QColor ink;
};
/// Draws text that stays readable over lines.
void drawWords(const Canvas &canvas, const Words &words);

}
