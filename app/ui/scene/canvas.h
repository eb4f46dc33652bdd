#pragma once

#include "app/ui/scene/shown.h"

#include <QPainter>
#include <QPolygonF>
#include <QTransform>

namespace app {

/// From px of the scene to px of the screen.
struct Camera
{
    QTransform toView;
    double zoom = 1.0; ///< px of the screen a px

    explicit Camera(const QTransform &transform) : toView(transform), zoom(transform.m11()) {}
    /// Places that are too far for the painter come to where it still can go.
    QPointF at(sim::Vec2 place) const;
    sim::Vec2 back(QPointF place) const;
    /// How large a body is drawn: never so small that it is lost.
    double radius(double px) const;
};

/// What a layer paints with. The painter counts in px of the screen, so that lines and marks have one size at
/// every zoom.
struct Canvas
{
    QPainter &painter;
    const Shown &shown;
    const Theme &theme;
    Camera camera;
    QRectF area; ///< what is to be painted

    const Tokens &tokens() const { return theme.tokens(); }
    /// Whether a disc shows.
    bool reaches(QPointF centre, double radius) const;
    /// The part of a line that can show; null if there is none.
    QLineF cut(QPointF from, QPointF to) const;
    /// The part of an area that can show, by Sutherland and Hodgman's method. Qt takes seconds to fill one that
    /// reaches a million pixels out of the picture.
    QPolygonF cut(QPolygonF polygon) const;
};

/// A pen of one width, with dashes in px of the screen.
QPen dashed(const QColor &color, double width, std::initializer_list<double> pattern);
QPen solid(const QColor &color, double width);
QColor faded(QColor color, double alpha);

/// Words in the picture.
struct Words
{
    QPointF from; ///< the left end of their base line, px of the screen
    QString text;
    QFont font;
    QColor ink;
};
/// Words that stay readable over lines.
void drawWords(const Canvas &canvas, const Words &words);

}
