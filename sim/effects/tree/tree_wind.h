#pragma once

#include "sim/base/direction.h"
#include "sim/effects/drivers/input_reader.h"
#include "sim/effects/effect_description.h"
#include "sim/effects/tree/tree.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>

namespace sim {

namespace descriptions {
extern const EffectDescription wind;
}

/// How wind comes to a branch.
struct BranchWind
{
    Vec2 d;                ///< between the pointer and the branch's end, as the formula has it
    double distance = 0.0; ///< its length
    double wind = 0.0;     ///< degrees: where it blows to
};

namespace tree_formulas::fast {

using portable::fast::atan2;

/// The wind at a branch's end, away from the pointer; px and degrees. The first function is all of it where the pointer
/// is not on the very end.
// Shown lines are short.
// clang-format off
inline
//! [wind]
BranchWind windAt(
    Vec2 end, Vec2 pointer)
{
    // from the pointer to the end
    Vec2 d = end - pointer;
    double distance = length(d);
    double rad = atan2(d.y, d.x);
    double wind = rad * degreesPerRadian;
    return {d, distance, wind};
}
inline BranchWind windAt(
    Vec2 end, Vec2 pointer, int branch)
{
    BranchWind found =
        windAt(end, pointer);
    if (found.distance < coincidenceDistance) {
        // -1 stands for the pointer
        Vec2 out =
            fallbackDirection(-1, branch);
        found.wind =
            windAt(out, {0, 0}).wind;
    }
    return found;
}
//! [wind]
// clang-format on

}

namespace tree_formulas {

/// The same as published: what the branch sees of the pointer is `d`, in its own frame, and half a turn is taken
/// off its angle. Published: swaying tree, bend().
// Shown lines are short.
// clang-format off
inline
//! [wind_published]
BranchWind windPublished(Vec2 d)
{
    double distance = length(d);
    double rad = atan2(d.y, d.x);
    double wind = rad * 57.3 - 180;
    return {d, distance, wind};
}
//! [wind_published]
// clang-format on

}

using tree_formulas::windPublished;
using tree_formulas::fast::windAt;

/// What resists the wind: the larger, the slower a branch turns; in frames.
/// Published: swaying tree, the first `strength`.
// Shown lines are short.
// clang-format off
inline
//! [by_distance]
double byDistance(double distance)
{
    double strength = distance;
    return strength;
}
//! [by_distance]
// clang-format on

/// The same with thick branches stiffer. Published: swaying tree, the second `strength`.
// Shown lines are short.
// clang-format off
inline
//! [by_thickness]
double byThickness(
    double distance, double scale,
    double wind)
{
    double strength =
        distance * scale * scale / wind;
    return strength;
}
//! [by_thickness]
// clang-format on

/// What turbulence adds to the wind's angle, degrees. `random` from 0 to 1.
/// Published: swaying tree, generateWind().
// The marker leaves out what learners need not read.
// clang-format off
inline
//! [turbulence]
double gustOf(
    double turbulence, double random)
{
    double gust =
        turbulence * (2 * random - 1);
    return gust;
}
//! [turbulence]
inline
//! [gusty]
double gusty(double wind, double gust)
{
    // one gust for all branches
    wind += gust;
    return wind;
}
//! [gusty]
// clang-format on

namespace tree_formulas {

/// Turns a branch towards the wind's angle the short way round, if more than one degree is missing:
/// `angle' = way / strength`, as one step of explicit Euler that never goes past the wind. Degrees; strength and h
/// in frames.
// Shown lines are short.
// clang-format off
inline
//! [bend]
double bend(
    double angle, double wind,
    double strength, double h)
{
    // the short way: -180 to 180
    double way =
        remainder(wind - angle, 360);
    // never past the wind
    double share =
        std::min(1.0, h / strength);
    if (std::abs(way) > 1)
        angle += share * way;
    return angle;
}
//! [bend]
// clang-format on

}

using tree_formulas::bend;

/// The same as published: its second test has 360 where the short way round needs 180. Published: swaying tree,
/// bend().
// Shown lines are short.
// clang-format off
inline
//! [bend_published]
double bendPublished(
    double angle, double wind,
    double strength, double h)
{
    if (wind - angle < -180)
        wind += 360;
    else if (wind - angle > 360)
        wind -= 360;
    double way = wind - angle;
    if (std::abs(way) > 1)
        angle += h * way / strength;
    return angle;
}
//! [bend_published]
// clang-format on

/// What resists the wind in a tree.
struct Resistance
{
    enum class By {
        ease,      ///< all branches alike; `amount` in frames
        distance,  ///< the way from the pointer, px
        thickness, ///< the way times the square of the scale, divided by `amount`
    };
    By by = By::ease;
    double amount = 8.0;
};

/// Turbulence that is drawn anew each frame, unless the state has a gust from outside.
struct Turbulence
{
    double degrees = 20.0; ///< the most, to either side
    std::uint64_t seed = 1;
};

/// Wind that blows from the pointer while its button is down, and turns each branch, from the trunk to the twigs.
class TreeWind : public DescribedEffect<Driver, descriptions::wind>, public InputReader
{
public:
    TreeWind(TreePtr tree, TreeFormula formula, Resistance resistance,
             std::optional<Turbulence> turbulence = {})
        : m_tree(std::move(tree)), m_formula(formula), m_resistance(resistance), m_turbulence(turbulence)
    {
    }

    std::vector<Region> regions(DirectionRule directionRule) const override;
    int count(const State &state, PointRange points) const override;
    Dependence dependence() const override { return m_turbulence ? Dependence::time : Dependence::scene; }
    bool reads(InputKind signal) const override { return signal == InputKind::pointer; }
    /// Only while it blows is turbulence drawn.
    bool isTimeIndependent(const State &state) const override { return !m_turbulence || !blows(state); }
    void drive(State &state, double h) const override;
    std::vector<LiveValue> explain(const State &before, const State &after, int point) const override;

    /// How the wind from `pointer` comes to branch `point`, which stands at `origin` at `angle` degrees, by either
    /// formula, without turbulence.
    BranchWind breezeAt(TreeFormula formula, int point, Vec2 origin, double angle, Vec2 pointer) const;

private:
    static bool blows(const State &state) { return state.input.pointerDown && state.input.pointer; }
    double gustNow(const State &state) const;
    double strength(double distance, int point) const;
    /// Turns all branches, by a formula for how the wind comes to a branch and how that turns.
    template <class Bend>
    void bendAll(State &state, double h, const Bend &bendBy) const;

    TreePtr m_tree;
    TreeFormula m_formula;
    Resistance m_resistance;
    std::optional<Turbulence> m_turbulence;
};

}
