#include "sim/analysis/settling/settling.h"

#include "sim/base/error.h"
#include "sim/run/track.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace sim {

namespace {

constexpr std::size_t coarsest = 8; ///< cells from place to place of the first grid
constexpr int quietFrames = 60;     ///< after these without motion, nothing more is expected
constexpr double motionless = 1e-6; ///< px or degrees a frame
constexpr double farAway = 1e8;     ///< px or degrees; only motion that grows gets there
constexpr double growing = 2.0;     ///< of the last third's fastest motion, to that of the first
constexpr std::int64_t observedFrames = 2 * Settling::mostFrames;

/// Where the points of a run are, and how branches stand.
struct Pose
{
    Eigen::ArrayX2d position;
    Eigen::ArrayXd angle;
};

double largest(const Eigen::ArrayXd &numbers)
{
    return numbers.size() > 0 ? numbers.maxCoeff() : 0.0;
}

/// Returns the largest displacement of a point (px) or turn of a branch (degrees) between two poses. Infinite if they
/// have different numbers of points.
double distance(const Pose &a, const Pose &b)
{
    if (a.position.rows() != b.position.rows() || a.angle.size() != b.angle.size())
        return HUGE_VAL;
    const Eigen::ArrayXd squares = (a.position - b.position).square().rowwise().sum();
    const Eigen::ArrayXd turn = (a.angle - b.angle).abs();
    return std::max(std::sqrt(largest(squares)), largest(turn));
}

bool isFar(const Pose &pose)
{
    return std::max(largest(pose.position.abs().rowwise().maxCoeff()), largest(pose.angle.abs())) > farAway;
}

/// The motion of a run after its last input.
struct Observation
{
    std::vector<Pose> poses;             ///< at the end of each output step, from the last input on
    std::array<double, 3> fastest = {};  ///< motion a frame, in each third
    std::optional<Settling::Kind> early; ///< known before the end
};

Pose poseOf(const State &state)
{
    return {state.position, state.angle};
}

/// Runs on from the frame `from` until the motion grows, has ended, or was observed long enough. Returns nothing if it
/// was cancelled.
std::optional<Observation> observe(Track &run, std::int64_t from, const ShouldContinue &shouldContinue)
{
    Observation seen;
    if (!run.seek({from, 0}, shouldContinue))
        return std::nullopt;
    seen.poses.push_back(poseOf(run.state()));
    const int frames = run.framesPerOutput();
    std::int64_t quiet = 0;
    while (!run.stop() && run.cursor().frame < from + observedFrames && quiet < quietFrames) {
        const std::int64_t before = run.cursor().frame;
        if (!run.seek({before + frames, 0}, shouldContinue))
            return std::nullopt;
        if (run.stop())
            break;
        seen.poses.push_back(poseOf(run.state()));
        const double motion = distance(seen.poses.back(), *(seen.poses.end() - 2)) / frames;
        const auto third = static_cast<std::size_t>(3 * (before - from) / observedFrames);
        seen.fastest.at(std::min<std::size_t>(third, 2)) =
            std::max(seen.fastest.at(std::min<std::size_t>(third, 2)), motion);
        quiet = motion < motionless ? quiet + frames : 0;
        if (isFar(seen.poses.back())) {
            seen.early = Settling::Kind::grows;
            break;
        }
    }
    if (run.stop())
        seen.early =
            run.stop()->reason == StopReason::stepFailed ? Settling::Kind::fails : Settling::Kind::grows;
    return seen;
}

}

std::int64_t lastInputFrame(const Script &script)
{
    return script.input.empty() ? 0 : script.input.back().frame;
}

std::optional<Settling> settlingOf(const Script &script, const ShouldContinue &shouldContinue)
{
    Track run(script, 0);
    const int frames = run.framesPerOutput();
    const std::int64_t from = (lastInputFrame(script) + frames - 1) / frames * frames;
    const std::optional<Observation> seen = observe(run, from, shouldContinue);
    if (!seen)
        return std::nullopt;
    if (seen->early)
        return Settling{*seen->early};
    if (seen->fastest[2] > Settling::slowest && seen->fastest[2] > growing * seen->fastest[0])
        return Settling{Settling::Kind::grows};
    const Pose &end = seen->poses.back();
    std::size_t rest = seen->poses.size() - 1; // the first output from which on it rests
    while (rest > 0 && distance(seen->poses[rest - 1], end) <= Settling::nearRest &&
           distance(seen->poses[rest - 1], seen->poses[rest]) < Settling::slowest * frames)
        --rest;
    const auto settled = static_cast<std::int64_t>(rest) * frames;
    if (settled > Settling::mostFrames)
        return Settling{Settling::Kind::moves};
    return Settling{Settling::Kind::settles, settled};
}

Script settlingScript(Script script, const std::string &x, const std::string &y, std::int64_t mostInput)
{
    std::erase_if(script.input, [&](const Event &event) {
        const Set *set = std::get_if<Set>(&event.what);
        return event.frame > mostInput || (set && (set->parameter == x || set->parameter == y));
    });
    return script;
}

std::optional<std::size_t> SettlingMap::nearestKnown(std::size_t column, std::size_t row) const
{
    for (std::size_t grid = 1; grid <= coarsest; grid *= 2) {
        const auto nearest = [grid](std::size_t place, std::size_t count) {
            return std::min((place + grid / 2) / grid * grid, (count - 1) / grid * grid);
        };
        const std::size_t index = indexOf(nearest(column, x.values.size()), nearest(row, y.values.size()));
        if (cells[index])
            return index;
    }
    return std::nullopt;
}

SettlingMap settlingMap(const Script &script, MapAxis x, MapAxis y, const SettlingProgress &progress,
                        const ShouldContinue &shouldContinue)
{
    SettlingMap map{std::move(x), std::move(y), {}};
    const std::size_t columns = map.x.values.size(), rows = map.y.values.size();
    map.cells.resize(columns * rows);
    Script changed = script;
    for (std::size_t grid = coarsest; grid > 0; grid /= 2) {
        for (std::size_t row = 0; row < rows; row += grid) {
            for (std::size_t column = 0; column < columns; column += grid) {
                if (map.cells[map.indexOf(column, row)])
                    continue; // of a coarser grid
                changed.values.set(map.x.parameter, map.x.values[column]);
                changed.values.set(map.y.parameter, map.y.values[row]);
                try {
                    map.cells[map.indexOf(column, row)] = settlingOf(changed, shouldContinue);
                } catch (const Error &) {
                    // It stays unknown.
                }
                if (!progress(map))
                    return map;
            }
        }
        map.stride = grid;
    }
    return map;
}

}
