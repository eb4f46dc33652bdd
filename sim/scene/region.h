#pragma once

#include <compare>
#include <string>

namespace sim {

/// A part of a source file between two lines `//! [marker]`: what the code panel shows.
struct Region
{
    std::string file; ///< from the project's top folder, with slashes
    std::string marker;
    friend auto operator<=>(const Region &, const Region &) = default;
};

}
