#pragma once

#include "sim/base/vec2.h"

#include <optional>
#include <string>
#include <variant>

namespace sim {

/// A named number (or pair) that a formula computed: `name` is the variable's name in the shown code.
struct LiveValue
{
    std::string name;
    std::variant<double, Vec2> value;
    std::optional<std::variant<double, Vec2>> before = {}; ///< set when the line changes what it had
};

}
