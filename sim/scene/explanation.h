#pragma once

#include "sim/base/vec2.h"

#include <compare>
#include <optional>
#include <string>
#include <variant>

namespace sim {

/// A part of a source file that the code panel shows: it stands between two lines `//! [marker]`.
struct Region
{
    std::string file; ///< path from the project's top folder, with slashes
    std::string marker;
    friend auto operator<=>(const Region &, const Region &) = default;
};

/// The current value of a variable in the shown code.
struct LiveValue
{
    std::string name; ///< of the variable
    std::variant<double, Vec2> value;
    std::optional<std::variant<double, Vec2>> before =
        {}; ///< previous value, if the code changes the variable
};

}
