#pragma once

#include "sim/base/vec2.h"
#include "sim/effects/contacts/room.h"

#include <QRectF>
#include <QString>

#include <array>
#include <optional>
#include <vector>

namespace lessons {

/// How a point is drawn.
struct BodyView
{
    enum class Shape {
        body,  ///< a disc with eyes
        foot,  ///< a disc
        joint, ///< a small disc: an end of sticks
        none,  ///< not at all: something else is drawn in its place, and a hand cannot take it
    };
    Shape shape = Shape::foot;
    double radius = 5.0; ///< px
    bool fixed = false;  ///< nailed where it is: drawn with a nail
};

/// A leg between two points.
struct LegView
{
    int from = 0;
    int to = 0;
    /// How far above `to` the control point of the leg's quadratic curve lies, px; 0: a straight leg.
    double curve = 0.0;
};

/// A stick, in the colour of its error: how far its length is from `length`.
struct StickView
{
    int a = 0;
    int b = 0;
    double length = 0.0; ///< px
    double width = 3.0;  ///< px
};

/// A spring, drawn as a zigzag that gets longer and shorter: from point `a` to the place `at`, seen from point `b`.
struct SpringView
{
    int a = 0;
    int b = 0;           ///< -1: `at` is a fixed place
    double length = 0.0; ///< px, at rest
    sim::Vec2 at = {};   ///< px
    /// Springs of soft matter are lines only: those within it are faint, those at its edge are not.
    enum class Part { alone, inside, edge };
    Part part = Part::alone;
};

/// A patch of soft matter between four points, in order, that springs hold along its sides and across.
struct SheetView
{
    std::array<int, 4> corners{};
};

/// A thick round limb under the sticks.
struct LimbView
{
    int a = 0;
    int b = 0;
    double width = 12.0; ///< px
};

/// A chain that gets thinner from its first point to its last: a tentacle.
struct ChainView
{
    std::vector<int> points;
    double width = 8.0; ///< px, at its root
};

/// A body whose outline is the smooth closed curve through some points, in order.
struct SkinView
{
    std::vector<int> outline;
    int front = -1; ///< the point that it looks from, with eyes; -1: no eyes
};

/// A tree: one branch a point, from the point's place along its angle. Arrays have one row a branch.
struct TreeView
{
    std::vector<int> parent;    ///< -1 for the trunk; parents come before their children
    std::vector<double> length; ///< px
    std::vector<double> width;  ///< px, where it begins
};

/// How a scene is drawn: by point numbers, the same for all states of the scene.
struct View
{
    std::vector<BodyView> bodies; ///< one a point
    std::vector<LegView> legs;
    std::vector<StickView> sticks;
    std::vector<SpringView> springs;
    std::vector<LimbView> limbs;
    std::vector<ChainView> chains;
    std::vector<SkinView> skins;
    std::optional<TreeView> tree;
    std::optional<sim::Room> room; ///< walls and floor, if the scene has any
    std::optional<double> ground;  ///< px, how far down an endless ground lies, if there is one
    QRectF stage{0, 0, 540, 400};  ///< px, what "fit" shows
    enum class Sky { paper, dusk };
    Sky sky = Sky::paper;
    /// The point that the camera follows when it walks out of the picture; -1: none.
    int followedPoint = -1;
    /// What the feet diagram shows, in order; empty: no diagram.
    std::vector<int> feet;
    /// The point that goes where the pointer is: dragging it sends the pointer instead of a hand. -1: none.
    int pointerPoint = -1;
    /// Shown from the start; the learner can switch each.
    bool showsVelocities = false;
    bool showsOnionSkins = false;
    std::vector<SheetView> sheets;
};

/// A thing that explains: drawn thin, over the picture, made anew for each state.
struct Overlay
{
    enum class Shape {
        cross, ///< a place, at `a`
        ring,  ///< a circle round `a`, `size` its radius in px
        arrow, ///< a pull that `label` names, from `a`; `b` is the arrow's vector in px/frame^2
        line,  ///< dashed, from `a` to `b`
        angle, ///< an arc round `a` from the x axis to `size` rad
        wind,  ///< streaks that blow away from `a`
    };
    Shape shape = Shape::cross;
    sim::Vec2 a = {};
    sim::Vec2 b = {};
    double size = 0.0;
    QString label = {}; ///< may be empty
    /// What the guide is about. A picture that shows the exact motion by itself leaves out guides that do, too.
    enum class About { step, exactMotion };
    About about = About::step;
};

}
