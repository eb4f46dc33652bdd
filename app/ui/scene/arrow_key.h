#pragma once

#include "sim/base/vec2.h"

#include <Qt>

#include <optional>

namespace app {

/// Returns the unit vector in the direction of an arrow key; empty for other keys.
inline std::optional<sim::Vec2> arrowKey(int key)
{
    switch (key) {
    case Qt::Key_Left:
        return sim::Vec2{-1.0, 0.0};
    case Qt::Key_Right:
        return sim::Vec2{1.0, 0.0};
    case Qt::Key_Up:
        return sim::Vec2{0.0, -1.0};
    case Qt::Key_Down:
        return sim::Vec2{0.0, 1.0};
    default:
        return std::nullopt;
    }
}

}
