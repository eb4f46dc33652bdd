#pragma once

#include "sim/effects/walls.h"
#include "sim/vec2.h"

#include <QRectF>
#include <QString>

#include <optional>
#include <vector>

namespace lessons {

/// How a point is drawn.
struct BodyLook
{
    enum class Shape { body, foot };
    Shape shape = Shape::foot;
    double radius = 5.0; ///< px
};

/// A leg between two points.
struct LegLook
{
    int from = 0;
    int to = 0;
};

/// How a scene is drawn: by point numbers, the same for all states of the scene.
struct Look
{
    std::vector<BodyLook> bodies; ///< one a point
    std::vector<LegLook> legs;
    std::optional<sim::Room> room; ///< walls and floor, if the scene has any
    QRectF stage{0, 0, 540, 400};  ///< px, what "fit" shows
};

/// A thing that explains: drawn thin, over the picture, made anew for each state.
struct Guide
{
    enum class Shape {
        cross, ///< a place, at `a`
        ring,  ///< a circle round `a`, `size` its radius in px
        arrow, ///< a pull that `label` names, from `a`; `b` is the arrow's vector in px/frame^2
        line,  ///< dashed, from `a` to `b`
        angle, ///< an arc round `a` from the x axis to `size` rad
    };
    Shape shape = Shape::cross;
    sim::Vec2 a;
    sim::Vec2 b;
    double size = 0.0;
    QString label; ///< may be empty
};

}
