#pragma once

#include <QString>

#include <cstddef>

namespace app {

/// A range for the numbers of a sandbox scene. Files and panels use the same ranges.
struct Span
{
    double min = 0.0;
    double max = 0.0;
    bool holds(double value) const { return value >= min && value <= max; }
};

namespace built {

constexpr std::size_t mostPoints = 1000;
constexpr std::size_t mostLinks = 10'000; ///< springs, and the same number of sticks and of rule links
constexpr std::size_t mostGaits = 16;
constexpr int longestName = 40;
constexpr Span place{-1e6, 1e6};    ///< px
constexpr Span speed{-1e6, 1e6};    ///< px/frame
constexpr Span mass{0.001, 1e6};    ///< relative to a standard body
constexpr Span size{1.0, 1000.0};   ///< px
constexpr Span stiffness{0.0, 1e9}; ///< mass/frame^2
constexpr Span length{0.0, 1e6};    ///< px
constexpr Span share{0.0, 1.0};
constexpr Span angle{-360.0, 360.0};   ///< degrees
constexpr Span drop{-1e6, 1e6};        ///< px
constexpr Span gaitSpeed{-10.0, 10.0}; ///< rad/frame
constexpr Span gaitStart{-1e6, 1e6};   ///< rad

/// Returns whether a body may have this name: a letter, then letters, digits, _ and dots.
bool isName(const QString &name);

}

}
