#pragma once

#include "app/model/listing/vector_mark.h"
#include "app/model/session/session.h"
#include "app/ui/scene/hud/ruler.h"
#include "app/ui/scene/layers/trail.h"
#include "app/ui/theme/theme.h"

#include <QFont>

#include <optional>
#include <vector>

namespace app {

/// The number of frames between two onion skins, and the number of skins.
constexpr int onionFrames = 4;
constexpr int onionSkins = 6;

/// Scenes with more points count as crowds: no trails, and arrows, a label and an edge marker only for the
/// selected body.
constexpr int crowdPoints = 600;

/// The positions of the points at the cursor's frame, by a far more accurate solution.
struct ReferencePlaces
{
    std::vector<sim::Vec2> places; ///< px, one per point
    double uncertainty = 0.0;      ///< px, error bound of the solution itself
    int farthest = -1;             ///< the visible point that is farthest from its exact position, or -1
    double distance = 0.0;         ///< px, of that point
};

/// The optional parts of the scene view. Most are entries of the "Show" menu.
struct Extras
{
    bool trails = true;
    bool velocities = false;
    bool grid = true;
    bool overlays = true;
    bool eyes = true;
    bool comparison = true;
    bool onion = false;
    bool reference = true;
    bool pulls = false; ///< also between two frames
    bool rests = false; ///< rest lengths of springs and sticks
    bool ruler = false;
    bool clock = false;
    bool unitCircle = true; ///< also the triangle of its arrow
    bool still = false;     ///< no movement of mere decoration
};

/// The scale of one kind of arrow. The legend mentions a change of scale while `before` has a value.
struct ArrowScale
{
    double unit = 1.0;            ///< px/frame or px/frame^2 per legend arrow
    std::optional<double> before; ///< the unit before the last change
    std::int64_t changed = 0;     ///< the frame shown at the last change
    bool isUsed = false;          ///< whether any arrow has been drawn with it yet
};

/// The scales of all kinds of arrow.
struct ArrowScales
{
    ArrowScale pull;     ///< px/frame^2
    ArrowScale velocity; ///< px/frame
};

/// The content of the scene at one moment. Layers and the heads-up display read only this.
struct SceneContent
{
    Picture picture;
    std::optional<Picture> comparison;        ///< only if it differs from `picture`
    std::optional<ReferencePlaces> reference; ///< only while accuracy is measured for this scene
    QString comparisonName;                   ///< how the ghost's run differs
    std::vector<sim::ForceSnapshot> gathered; ///< forces; inside a frame, those that no move has consumed yet
    QString caption; ///< what the frame has done so far, or the step's note about this moment
    QString name;    ///< the name of one of two figures; shown above its stage
    sim::Vec2 shift; ///< px, offset of the figure from the positions of its points
    Trail trail;
    std::optional<Picture> past;   ///< the moment under the mouse, in the trail or in an onion skin
    std::vector<sim::State> onion; ///< onion skins, the latest first; empty unless shown
    Extras extras;
    Ruler ruler;
    std::optional<VectorMark> vector; ///< the Vec2 of the listing under the mouse
    /// The subjects of the formula under the mouse, or of the one that the learner keeps.
    std::vector<lessons::Highlight> highlights;
    QRectF card;       ///< screen px, a card over the scene, which labels avoid; empty without one
    QString clock;     ///< the run's time, as text
    int selected = -1; ///< the selected point, or -1
    ArrowScales scales;
    std::optional<sim::State> before; ///< inside a frame: the state before the last phase done
    bool isInside = false;            ///< inside a frame, with velocities shown; the learner can hide them
    bool hasPulls = false;            ///< whether any force arrow is drawn
    bool pullsAreAll = false;         ///< `gathered` has all forces, not only those of the frame so far
    int outsidePointedAt = -1;        ///< the point of the edge marker under the mouse, or -1
    bool focusVisible = false;        ///< the view has the keyboard focus, and its frame shows
    QFont text;                       ///< captions and labels
    QFont figures;                    ///< important numbers

    const sim::State &state() const { return picture.state; }
    int points() const { return picture.interval ? picture.state.pointCount() : 0; }
    const lessons::View &view() const { return *picture.view; }
    bool isCrowd() const { return points() > crowdPoints; }
    bool showsVelocities() const { return extras.velocities || isInside; }
    /// Returns whether any arrow of a velocity can be drawn: with those of all bodies, or for a formula.
    bool hasVelocityArrows() const;
    double radius(int point) const { return view().bodies[static_cast<std::size_t>(point)].radius; }
    bool isBody(int point) const { return shape(point) == lessons::BodyView::Shape::body; }
    /// Returns whether the point is drawn as something else, so that it cannot be dragged.
    bool isHidden(int point) const { return shape(point) == lessons::BodyView::Shape::none; }
    lessons::BodyView::Shape shape(int point) const
    {
        return view().bodies[static_cast<std::size_t>(point)].shape;
    }
    /// Returns the sum of the forces on the selected body.
    sim::Vec2 sumOnSelected() const;
    bool hasSum() const { return selected >= 0 && gathered.size() > 1; }
};

/// Returns the points with trails: the bodies, or all points if there are no bodies.
std::vector<int> trailed(const SceneContent &shown);

/// Returns the name for the sum of the forces.
QString sumWords(const SceneContent &shown);

/// The largest length of an arrow, screen px.
constexpr double longestArrow = 100.0;

/// Returns the unit of a legend's arrow: 1, 2 or 5 times a power of ten. With it, the longest arrow is at
/// most `room` screen px long. If `settled` fits well enough, it returns that.
double arrowUnit(double longest, std::optional<double> settled, double room = longestArrow);

/// The length of the legend's arrow, screen px.
constexpr double unitArrow = 38.0;

/// Updates the scales of `shown`, which shows frame `frame`. Scales that still fit are kept, so that arrows
/// of two moments can be compared.
void measureArrows(SceneContent &shown, std::int64_t frame);

}
