#pragma once

#include "sim/base/vec2.h"
#include "sim/effects/contacts/room.h"

#include <QRectF>
#include <QString>

#include <array>
#include <optional>
#include <vector>

namespace lessons {

/// The appearance of a point.
struct BodyView
{
    enum class Shape {
        body,  ///< a disc with eyes
        foot,  ///< a disc
        joint, ///< a small disc at the end of sticks
        none,  ///< not drawn, and the pointer cannot drag it
    };
    Shape shape = Shape::foot;
    double radius = 5.0; ///< px
    bool fixed = false;  ///< whether the point is fixed; drawn with a nail
};

/// A leg, drawn between two points.
struct LegView
{
    int from = 0;
    int to = 0;
    /// px, height of the control point of the leg's quadratic curve above `to`. 0 is a straight leg.
    double curve = 0.0;
};

/// A stick. Its colour shows the error of its length.
struct StickView
{
    int a = 0;
    int b = 0;
    double length = 0.0; ///< px, without error
    double width = 3.0;  ///< px
};

/// A link along which the learner's rule acts, drawn as a thin line.
struct RuleLinkView
{
    int a = 0;
    int b = 0;
};

/// A spring, drawn as a zigzag from point `a` to point `b` plus the offset `at`.
struct SpringView
{
    int a = 0;
    int b = 0;           ///< -1: `at` is a fixed position
    double length = 0.0; ///< px, at rest
    sim::Vec2 at = {};   ///< px
    /// Springs of a soft sheet are drawn as lines. Those inside the sheet are faint.
    enum class Part { alone, inside, edge };
    Part part = Part::alone;
};

/// A soft sheet between four points, in order. It has springs along its sides and diagonals.
struct SheetView
{
    std::array<int, 4> corners{};
};

/// A thick limb with round ends, drawn under the sticks.
struct LimbView
{
    int a = 0;
    int b = 0;
    double width = 12.0; ///< px
};

/// A tentacle: a chain of points that gets thinner from the first to the last.
struct ChainView
{
    std::vector<int> points;
    double width = 8.0; ///< px, at the first point
};

/// A body whose outline is a smooth closed curve through some points, in order.
struct SkinView
{
    std::vector<int> outline;
    int front = -1; ///< the point with the eyes; -1: no eyes
};

/// A tree with one branch per point. A branch begins at its point and goes in the direction of the point's
/// angle. Each array has one entry per branch.
struct TreeView
{
    std::vector<int> parent;    ///< -1 for the trunk; parents precede their children
    std::vector<double> length; ///< px
    std::vector<double> width;  ///< px, at the start of the branch
};

/// An arrow whose angle, sine and cosine the unit circle shows.
struct AngleView
{
    int from = 0; ///< a point
    int to = -1;  ///< a point; -1: the end of the branch that begins at `from`
};

/// The appearance of a scene, by point indices. It is the same for all states of the scene.
struct View
{
    std::vector<BodyView> bodies; ///< one per point
    std::vector<LegView> legs;
    std::vector<StickView> sticks;
    std::vector<SpringView> springs;
    std::vector<LimbView> limbs;
    std::vector<ChainView> chains;
    std::vector<SkinView> skins;
    std::optional<TreeView> tree;
    std::optional<sim::Room> room; ///< walls and floor; empty without them
    std::optional<double> ground;  ///< px, y of an endless ground; empty without one
    QRectF stage{0, 0, 540, 400};  ///< px, the area that "fit" shows
    enum class Sky { paper, dusk };
    Sky sky = Sky::paper;
    /// The point that the camera follows out of the stage; -1: none.
    int followedPoint = -1;
    /// The feet in the feet diagram, in order. Empty: no diagram.
    std::vector<int> feet;
    /// The point that follows the pointer. Dragging it sends pointer events instead of a drag. -1: none.
    int pointerPoint = -1;
    /// Whether velocities and onion skins are shown at first. The learner can switch them.
    bool showsVelocities = false;
    bool showsOnionSkins = false;
    std::vector<SheetView> sheets;
    std::vector<RuleLinkView> ruleLinks;
    std::optional<AngleView> angle; ///< empty: no unit circle
};

/// A thin explanatory drawing over the scene, computed for each state.
struct Overlay
{
    enum class Shape {
        cross, ///< a cross at `a`
        ring,  ///< a circle round `a` with radius `size`, px
        arrow, ///< an acceleration `b`, px/frame^2, drawn from `a`
        line,  ///< a dashed line from `a` to `b`
        angle, ///< an arc round `a` from the x axis to the angle `size`, rad
        wind,  ///< streaks that point away from `a`
    };
    Shape shape = Shape::cross;
    sim::Vec2 a = {}; ///< px
    sim::Vec2 b = {};
    double size = 0.0;
    QString label = {}; ///< may be empty
    /// The subject of the overlay. While the scene view shows the exact motion itself, overlays about it are
    /// not drawn.
    enum class About { step, exactMotion };
    About about = About::step;
};

}
