#include "lessons/api/checks/run_queries.h"

#include "lessons/api/checks/drag_gesture.h"
#include "sim/run/script/composed_interval.h"
#include "sim/run/timeline.h"
#include "sim/simd/flush_denormals.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lessons {

namespace {

/// Returns the index of the first phase of the step in progress.
int stepStart(const sim::Timeline &timeline)
{
    const int perStep = timeline.track().interval().pipeline.phasesPerStep();
    return (timeline.cursor().phase - 1) / perStep * perStep;
}

/// Returns whether `matches(phase)` for any computed phase of the step in progress. False between two frames.
template <class Matches>
bool anyComputedPhase(const sim::Timeline &timeline, Matches &&matches)
{
    const int done = timeline.cursor().phase;
    for (int i = done > 0 ? stepStart(timeline) : 0; i < done; ++i) {
        if (matches(timeline.track().interval().pipeline.phaseAt(i)))
            return true;
    }
    return false;
}

}

sim::Vec2 positionOf(const sim::Timeline &timeline, const std::string &name)
{
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    const int point = timeline.track().interval().scene.find(name);
    return point < 0 ? sim::Vec2{none, none} : timeline.state().positionOf(point);
}

double distance(const sim::Timeline &timeline, const std::string &a, const std::string &b)
{
    return sim::length(positionOf(timeline, a) - positionOf(timeline, b));
}

sim::Vec2 centreOfPoints(const sim::Timeline &timeline)
{
    const auto mean = timeline.state().position.colwise().mean().eval();
    return {mean[0], mean[1]};
}

sim::Vec2 momentum(const sim::Timeline &timeline)
{
    const auto sum = timeline.state().velocity.colwise().sum().eval();
    return {sum[0], sum[1]};
}

bool flewOffStage(const sim::Timeline &timeline)
{
    const sim::Vec2 centre = centreOfPoints(timeline);
    const bool onStage = centre.x >= 0.0 && centre.x <= 540.0 && centre.y >= 0.0 && centre.y <= 400.0;
    return !onStage && sim::length(momentum(timeline)) >= 2.0;
}

bool isStill(const sim::Timeline &timeline)
{
    return staysStill(timeline.track(), -1);
}

bool staysStill(const sim::Track &track, int point)
{
    if (track.cursor().phase > 0 || track.stop())
        return false;
    const sim::FlushDenormals flush;
    std::shared_ptr<const sim::ComposedInterval> interval;
    sim::State state = track.preview(interval);
    Eigen::ArrayX2d before = track.state().position;
    for (int output = 0; output < 2; ++output) {
        for (int phase = 0; phase < interval->pipeline.phasesPerOutput(); ++phase)
            interval->pipeline.phaseAt(phase).run(state);
        if (sim::firstStuckPoint(state) >= 0 || before.rows() != state.position.rows() ||
            point >= before.rows())
            return false;
        const Eigen::ArrayX2d moved = (state.position - before).abs();
        const bool stays = point < 0 ? (moved <= stillness).all() : (moved.row(point) <= stillness).all();
        if (!stays) // also false for NaN
            return false;
        before = state.position;
    }
    return true;
}

std::int64_t lastSetFrame(const sim::Timeline &timeline, const std::string &id)
{
    std::int64_t last = 0;
    for (const sim::Event &event : timeline.script().input) {
        const auto *set = std::get_if<sim::Set>(&event.what);
        if (set && set->parameter == id &&
            event.frame <= timeline.cursor().frame + timeline.track().framesPerOutput())
            last = std::max(last, event.frame);
    }
    return last;
}

std::int64_t framesSinceSet(const sim::Timeline &timeline, const std::string &id)
{
    return std::max<std::int64_t>(0, timeline.cursor().frame - lastSetFrame(timeline, id));
}

bool isSetTo(const sim::Timeline &timeline, const std::string &id, double value)
{
    return timeline.values().has(id) && std::abs(timeline.values()[id] - value) < 0.005;
}

sim::Vec2 grabPosition(const sim::Timeline &timeline, const DragGesture &drag)
{
    const int point = timeline.track().interval().scene.find(drag.body);
    const sim::State grabbed = timeline.track().stateAt(std::max<std::int64_t>(0, drag.grabFrame - 1));
    return point >= 0 && point < grabbed.pointCount() ? grabbed.positionOf(point)
           : drag.path.empty()                        ? sim::Vec2{}
                                                      : drag.path.front().position;
}

bool wasThrown(const sim::Timeline &timeline, const std::string &body, double minSpeed)
{
    const std::optional<DragGesture> drag = lastReleased(timeline, body);
    return drag && sim::length(drag->releaseVelocity()) >= minSpeed;
}

const sim::Phase *lastPhase(const sim::Timeline &timeline)
{
    const int done = timeline.cursor().phase;
    return done > 0 ? &timeline.track().interval().pipeline.phaseAt(done - 1) : nullptr;
}

bool hasMoved(const sim::Timeline &timeline, int group)
{
    return anyComputedPhase(timeline, [&](const sim::Phase &phase) {
        return phase.id == "move" && (group < 0 || phase.group == group);
    });
}

bool onlySpringsPulled(const sim::Timeline &timeline)
{
    const bool pulled = anyComputedPhase(
        timeline, [](const sim::Phase &phase) { return phase.kind == sim::EffectKind::spring; });
    return pulled && !hasMoved(timeline);
}

bool differsFromComparison(const sim::Timeline &timeline, const std::string &id)
{
    if (!timeline.comparison())
        return false;
    const sim::Values &compared = timeline.comparison()->interval().values;
    const sim::Values &current = timeline.track().interval().values;
    return compared.has(id) && current.has(id) && compared[id] != current[id];
}

bool usesMethod(const sim::Timeline &timeline, const std::string &id)
{
    return timeline.script().method->id() == id;
}

}
