#include "app/ui/scene/layers/scene_content.h"

#include "lessons/api/view/view.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>
#include <cmath>

namespace app {

namespace {

/// screen px. Velocity arrows may be longer than force arrows: damping removes a tenth of a velocity, which
/// must be visible.
constexpr double longestVelocity = 140.0;
constexpr double finestPull = 0.01;     ///< px/frame^2, the smallest unit of the legend's arrow
constexpr double finestVelocity = 0.01; ///< px/frame, likewise
/// The fraction of the longest arrow below which the scale is renewed.
constexpr double worthKeeping = 0.15;
constexpr std::int64_t saidFor = 15; ///< frames for which the legend mentions a changed scale

sim::Vec2 rowOf(const Eigen::ArrayX2d &values, int point)
{
    return {values(point, 0), values(point, 1)};
}

double longestPull(const SceneContent &shown)
{
    double longest = 0.0;
    for (const sim::ForceSnapshot &one : shown.gathered) {
        if (shown.isCrowd() && shown.selected >= 0)
            longest = std::max(longest, sim::length(rowOf(one.acceleration, shown.selected)));
        for (int i = shown.isCrowd() ? shown.points() : 0; i < shown.points(); ++i)
            longest = std::max(longest, sim::length(rowOf(one.acceleration, i)));
    }
    if (shown.hasSum())
        longest = std::max(longest, sim::length(shown.sumOnSelected()));
    if (shown.extras.overlays) {
        for (const lessons::Overlay &overlay : shown.picture.overlays) {
            if (overlay.shape == lessons::Overlay::Shape::arrow)
                longest = std::max(longest, sim::length(overlay.b));
        }
    }
    return longest;
}

/// Renews `scale`, unless an arrow of `longest` still fits.
void renew(ArrowScale &scale, double longest, double room, double finest, std::int64_t frame)
{
    if (scale.before && std::abs(frame - scale.changed) > saidFor)
        scale.before.reset();
    if (!(longest > 0.0))
        return;
    const std::optional<double> settled = scale.isUsed ? std::optional(scale.unit) : std::nullopt;
    const double unit = std::max(finest, arrowUnit(longest, settled, room));
    if (settled && unit != scale.unit) {
        scale.before = scale.unit;
        scale.changed = frame;
    }
    scale.unit = unit;
    scale.isUsed = true;
}

double fastest(const SceneContent &shown)
{
    if (shown.isCrowd())
        return shown.selected >= 0 ? sim::length(shown.state().velocityOf(shown.selected)) : 0.0;
    double most = 0.0;
    for (int i = 0; i < shown.points(); ++i) {
        most = std::max(most, sim::length(shown.state().velocityOf(i)));
        if (shown.before)
            most = std::max(most, sim::length(shown.before->velocityOf(i)));
    }
    return most;
}

}

std::vector<int> trailed(const SceneContent &shown)
{
    const std::deque<Trail::Mark> &marks = shown.trail.marks();
    if (!shown.extras.trails || marks.size() < 2 || marks.back().position.rows() != shown.points())
        return {};
    std::vector<int> bodies, all;
    for (int i = 0; i < shown.points(); ++i) {
        if (shown.isBody(i))
            bodies.push_back(i);
        if (!shown.isHidden(i))
            all.push_back(i);
    }
    return bodies.empty() ? all : bodies;
}

sim::Vec2 SceneContent::sumOnSelected() const
{
    sim::Vec2 sum;
    for (const sim::ForceSnapshot &one : gathered)
        sum = sum + rowOf(one.acceleration, selected);
    return sum;
}

bool SceneContent::hasVelocityArrows() const
{
    return showsVelocities() ||
           std::any_of(highlights.begin(), highlights.end(), [](const lessons::Highlight &one) {
               return one.kind == lessons::Highlight::Kind::velocity;
           });
}

double arrowUnit(double longest, std::optional<double> settled, double room)
{
    const double least = longest * unitArrow / room;
    if (!(least > 0.0) || !std::isfinite(least))
        return settled.value_or(1.0);
    if (settled && least <= *settled && least >= worthKeeping * *settled)
        return *settled;
    const double power = std::pow(10.0, std::floor(std::log10(least)));
    for (const double step : std::array{1.0, 2.0, 5.0}) {
        if (step * power >= least)
            return step * power;
    }
    return 10.0 * power;
}

void measureArrows(SceneContent &shown, std::int64_t frame)
{
    const double pull = longestPull(shown);
    shown.hasPulls = pull > 0.0;
    // Resting bodies still have tiny forces, around 1e-9, and creep. The minimum keeps these from growing
    // into arrows.
    renew(shown.scales.pull, pull, longestArrow, finestPull, frame);
    if (shown.hasVelocityArrows())
        renew(shown.scales.velocity, fastest(shown), longestVelocity, finestVelocity, frame);
}

QString sumWords(const SceneContent &shown)
{
    return shown.pullsAreAll ? QCoreApplication::translate("SceneOverlay", "sum of all pulls")
                             : QCoreApplication::translate("SceneOverlay", "sum so far");
}

}
