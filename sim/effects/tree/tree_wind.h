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

/// The wind at a branch.
struct BranchWind
{
    Vec2 d; ///< vector between the pointer and the branch's end; its sign and unit depend on the formula
    double distance = 0.0; ///< length of `d`
    double wind = 0.0;     ///< degrees, angle towards which the wind blows
};

namespace tree_formulas::fast {

using portable::fast::atan2;

/// Returns the wind at the end of a branch. It blows away from the pointer. Positions in px. The first
/// function is for ends that do not coincide with the pointer; it has no branch instruction, so the compiler
/// can vectorise loops that call it. The second one handles all ends.
// Shown lines are short.
// clang-format off
SIM_INLINED inline
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

/// Returns the wind at a branch by the published formula. `d`: see pointerOffsetPublished(). The formula
/// subtracts 180 degrees from the angle of `d`. Published: swaying tree, bend().
// Shown lines are short.
// clang-format off
SIM_INLINED inline
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

/// Returns the resistance to the wind by the distance (px) from the pointer. It is the time constant (frames)
/// of bend(): a branch with a larger resistance turns more slowly.
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

/// Returns the resistance by distance and thickness: thick branches are stiffer. `wind`: strength of the
/// wind. Published: swaying tree, the second `strength`.
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

/// Returns the angle (degrees) that turbulence adds to the wind's angle. `random` is from 0 to 1.
/// Published: swaying tree, generateWind().
// The markers leave out `inline`.
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

/// Returns the angle of a branch after it turned towards the wind for `h` frames, in one explicit Euler step
/// of `angle' = way / strength`. It turns in the shorter direction and never past the wind. A branch within 1
/// degree of the wind does not turn. Angles in degrees, `strength` in frames.
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

/// Returns the same by the published formula. Its second comparison has 360, but the shorter direction needs
/// 180.
/// Published: swaying tree, bend().
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

/// How the branches of a tree resist the wind. See byDistance().
struct Resistance
{
    enum class By {
        ease,      ///< all branches have the resistance `amount`, in frames
        distance,  ///< see byDistance()
        thickness, ///< see byThickness(); `amount` is the strength of the wind
    };
    By by = By::ease;
    double amount = 8.0;
};

/// Random changes of the wind's angle, one per frame. InputState::gust replaces them.
struct Turbulence
{
    double degrees = 20.0; ///< maximum to either side
    std::uint64_t seed = 1;
};

/// Wind that blows away from the pointer while its button is down, and turns the branches from the trunk to
/// the twigs.
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
    bool reads(InputKind kind) const override { return kind == InputKind::pointer; }
    /// Turbulence depends on the frame number, but only while the wind blows.
    bool isTimeIndependent(const State &state) const override { return !m_turbulence || !blows(state); }
    void drive(State &state, double h) const override;
    std::vector<LiveValue> explain(const State &before, const State &after, int point) const override;

    TreeFormula formula() const { return m_formula; }
    /// Returns the wind from `pointer` at branch `point` with the given origin (px) and angle (degrees),
    /// without turbulence.
    BranchWind windOn(TreeFormula formula, int point, Vec2 origin, double angle, Vec2 pointer) const;

private:
    static bool blows(const State &state) { return state.input.pointerDown && state.input.pointer; }
    /// Returns the turbulence of the current frame, in degrees.
    double gustNow(const State &state) const;
    /// Returns the resistance of branch `point`, see Resistance.
    double strength(double distance, int point) const;
    /// Turns all branches. `formula` computes the wind at a branch, and the angle after the wind turned it.
    template <class Formula>
    void bendTree(State &state, double h, const Formula &formula) const;

    TreePtr m_tree;
    TreeFormula m_formula;
    Resistance m_resistance;
    std::optional<Turbulence> m_turbulence;
};

}
