#pragma once

#include "sim/base/vec2.h"

#include <compare>
#include <optional>
#include <string>
#include <variant>

namespace sim {

/// A part of a source file between two lines `//! [marker]`, which the code panel shows.
struct Region
{
    std::string file; ///< path from the project's top folder, with slashes
    std::string marker;
    friend auto operator<=>(const Region &, const Region &) = default;
};

/// A number or vector that a formula computed.
struct LiveValue
{
    std::string name; ///< of the variable in the shown code
    std::variant<double, Vec2> value;
    std::optional<std::variant<double, Vec2>> before = {}; ///< the old value, where the line changes one
};

}
