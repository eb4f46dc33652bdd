#include "app/ui/scene/shown.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>
#include <cmath>

namespace app {

namespace {

constexpr double longestArrow = 100.0; ///< px of the screen
constexpr double finestPull = 0.01;    ///< px/frame^2, the least that the legend's arrow stands for
constexpr double worthKeeping = 0.15;  ///< of longestArrow: below, a kept scale makes arrows too short

sim::Vec2 rowOf(const Eigen::ArrayX2d &values, int point)
{
    return {values(point, 0), values(point, 1)};
}

double longestPull(const Shown &shown)
{
    double longest = 0.0;
    for (const sim::Gathered &one : shown.gathered) {
        if (shown.isCrowd() && shown.selected >= 0)
            longest = std::max(longest, sim::length(rowOf(one.acceleration, shown.selected)));
        for (int i = shown.isCrowd() ? shown.points() : 0; i < shown.points(); ++i)
            longest = std::max(longest, sim::length(rowOf(one.acceleration, i)));
    }
    if (shown.hasSum())
        longest = std::max(longest, sim::length(shown.sumOnSelected()));
    if (shown.extras.guides) {
        for (const lessons::Guide &guide : shown.picture.guides) {
            if (guide.shape == lessons::Guide::Shape::arrow)
                longest = std::max(longest, sim::length(guide.b));
        }
    }
    return longest;
}

double fastest(const Shown &shown)
{
    if (shown.isCrowd())
        return shown.selected >= 0 ? sim::length(shown.state().speed(shown.selected)) : 0.0;
    double most = 0.0;
    for (int i = 0; i < shown.points(); ++i)
        most = std::max(most, sim::length(shown.state().speed(i)));
    return most;
}

}

std::vector<int> trailed(const Shown &shown)
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

sim::Vec2 Shown::sumOnSelected() const
{
    sim::Vec2 sum;
    for (const sim::Gathered &one : gathered)
        sum = sum + rowOf(one.acceleration, selected);
    return sum;
}

double arrowUnit(double longest, std::optional<double> settled)
{
    const double least = longest * unitArrow / longestArrow;
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

void measureArrows(Shown &shown, bool playing)
{
    const auto settled = [&](double unit) { return playing ? std::optional(unit) : std::nullopt; };
    const double pull = longestPull(shown);
    shown.hasPulls = pull > 0.0;
    // What rests still feels pulls of a billionth: those are not blown up to arrows.
    shown.pullUnit = std::max(finestPull, arrowUnit(pull, settled(shown.pullUnit)));
    shown.velocityUnit = arrowUnit(fastest(shown), settled(shown.velocityUnit));
}

QString sumWords(const Shown &shown)
{
    return shown.pullsAreAll ? QCoreApplication::translate("SceneOverlay", "sum of all pulls")
                             : QCoreApplication::translate("SceneOverlay", "sum so far");
}

}
