#pragma once

#include "app/model/session.h"
#include "app/ui/scene/ruler.h"
#include "app/ui/scene/trail.h"
#include "app/ui/theme/theme.h"

#include <QFont>

#include <optional>
#include <vector>

namespace app {

/// Earlier moments are shown every so many frames, and so many of them.
constexpr int onionFrames = 4;
constexpr int onionSkins = 6;

/// Scenes of more points than this show what they are as a whole: they leave no trails, and only the selected body has
/// arrows, a label or a marker at the edge.
constexpr int crowdPoints = 600;

/// Where a far more exact solution has the points at the cursor's frame.
struct ReferencePlaces
{
    std::vector<sim::Vec2> places; ///< px, one a point
    double uncertainty = 0.0;      ///< px by which the solution itself may be off
    int farthest = -1;             ///< the point that shows and is farthest from its place; -1: none
    double distance = 0.0;         ///< px, of that point
};

/// What the scene view can show besides the creature.
struct Extras
{
    bool trails = true;
    bool velocities = false;
    bool grid = true;
    bool guides = true;
    bool eyes = true;
    bool ghost = true;
    bool onion = false;
    bool reference = true;
    bool pulls = false; ///< between two frames, too
    bool rests = false; ///< how long springs and sticks are at rest
    bool ruler = false;
    bool clock = false;
    bool still = false; ///< what only decorates does not move
};

/// What the arrow of a legend stands for. A change of it is said in the legend for as long as `before` is there.
struct ArrowScale
{
    double unit = 1.0;            ///< px/frame or px/frame^2
    std::optional<double> before; ///< what it stood for until `changed`
    std::int64_t changed = 0;     ///< the frame shown when it changed last
    bool isUsed = false;          ///< whether any arrow was drawn to it yet
};

/// What the arrows of all kinds stand for.
struct ArrowScales
{
    ArrowScale pull;     ///< px/frame^2
    ArrowScale velocity; ///< px/frame
};

/// All that is drawn at one moment: the layers and the overlay read this and nothing else.
struct Shown
{
    Picture picture;
    std::optional<Picture> ghost;             ///< only where it differs from the picture
    std::optional<ReferencePlaces> reference; ///< only while accuracy is measured on this scene
    QString ghostName;                        ///< what the ghost differs by
    std::vector<sim::ForceSnapshot> gathered; ///< inside a frame: accelerations that no move has spent yet
    QString caption; ///< what has been done inside a frame, or what the step says about the moment
    QString name;    ///< who the figure is, where there are two; stands over its stage
    sim::Vec2 shift; ///< px: how far the picture is moved from where its points are
    Trail trail;
    std::optional<Picture> past;   ///< the moment that the mouse points at in trail or skins
    std::vector<sim::State> onion; ///< earlier moments, the latest first; empty unless they are shown
    Extras extras;
    Ruler ruler;
    QString clock;     ///< the time of the run, in words
    int selected = -1; ///< a point, or -1
    ArrowScales scales;
    std::optional<sim::State> before; ///< inside a frame: the state before the last phase done
    bool isInside = false;            ///< inside a frame, where velocities show unless the learner hides them
    bool hasPulls = false;            ///< whether any arrow in px/frame^2 is drawn
    bool pullsAreAll =
        false; ///< `gathered` is all that pulls, not what a frame under way has gathered so far
    int outsidePointedAt = -1; ///< the point whose marker at the edge the mouse is on, or -1
    bool focusVisible = false; ///< the keyboard is here
    QFont text;                ///< captions and labels
    QFont figures;             ///< numbers that matter

    const sim::State &state() const { return picture.state; }
    int points() const { return picture.interval ? picture.state.pointCount() : 0; }
    const lessons::View &look() const { return *picture.look; }
    bool isCrowd() const { return points() > crowdPoints; }
    bool showsVelocities() const { return extras.velocities || isInside; }
    double radius(int point) const { return look().bodies[static_cast<std::size_t>(point)].radius; }
    bool isBody(int point) const { return shape(point) == lessons::BodyView::Shape::body; }
    /// Whether something else is drawn in the point's place, so that no hand can take it.
    bool isHidden(int point) const { return shape(point) == lessons::BodyView::Shape::none; }
    lessons::BodyView::Shape shape(int point) const
    {
        return look().bodies[static_cast<std::size_t>(point)].shape;
    }
    /// The sum of what is gathered on the selected body.
    sim::Vec2 sumOnSelected() const;
    bool hasSum() const { return selected >= 0 && gathered.size() > 1; }
};

/// The points whose trail is drawn: the bodies, or all where there are none.
std::vector<int> trailed(const Shown &shown);

/// What the sum of the pulls is called.
QString sumWords(const Shown &shown);

/// How long the longest arrow may be, in px of the screen.
constexpr double longestArrow = 100.0;

/// What the arrow of a legend stands for, so that the longest of the arrows drawn to that scale is at most `room` px of
/// the screen long: 1, 2 or 5 times a power of ten. While `settled` is given and fits well enough, it stays.
double arrowUnit(double longest, std::optional<double> settled, double room = longestArrow);

/// How long the legend's arrow is, in px of the screen.
constexpr double unitArrow = 38.0;

/// Renews the scales of `shown`, which shows frame `frame`. A scale that still fits is kept, so that arrows of two moments
/// can be compared.
void measureArrows(Shown &shown, std::int64_t frame);

}
