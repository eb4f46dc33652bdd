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

/// The index of the first phase of the step under way.
int stepStart(const sim::Timeline &timeline)
{
    const int perStep = timeline.track().interval().pipeline.phasesPerStep();
    return (timeline.cursor().phase - 1) / perStep * perStep;
}

/// Whether `which(phase)` for any phase that is done of the step under way, inside a frame.
template <class Which>
bool anyDone(const sim::Timeline &timeline, Which &&which)
{
    const int done = timeline.cursor().phase;
    for (int i = done > 0 ? stepStart(timeline) : 0; i < done; ++i) {
        if (which(timeline.track().interval().pipeline.phaseAt(i)))
            return true;
    }
    return false;
}

}

sim::Vec2 positionOf(const sim::Timeline &timeline, const std::string &name)
{
    constexpr double nowhere = std::numeric_limits<double>::quiet_NaN();
    const int point = timeline.track().interval().scene.find(name);
    return point < 0 ? sim::Vec2{nowhere, nowhere} : timeline.state().positionOf(point);
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

bool onStage(sim::Vec2 place)
{
    return place.x >= 0.0 && place.x <= 540.0 && place.y >= 0.0 && place.y <= 400.0;
}

bool isStill(const sim::Timeline &timeline)
{
    if (timeline.cursor().phase > 0 || timeline.stop())
        return false;
    const sim::FlushDenormals flush;
    std::shared_ptr<const sim::ComposedInterval> interval;
    sim::State state = timeline.track().preview(interval);
    Eigen::ArrayX2d before = timeline.state().position;
    for (int row = 0; row < 2; ++row) {
        for (int phase = 0; phase < interval->pipeline.phasesPerOutput(); ++phase)
            interval->pipeline.phaseAt(phase).run(state);
        if (sim::firstStuckPoint(state) >= 0 || before.rows() != state.position.rows() ||
            !((state.position - before).abs() <= stillness).all()) // false for what is not finite, too
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

sim::Vec2 grabPosition(const sim::Timeline &timeline, const DragGesture &carry)
{
    const int point = timeline.track().interval().scene.find(carry.body);
    const sim::State then = timeline.track().stateAt(std::max<std::int64_t>(0, carry.grabFrame - 1));
    return point >= 0 && point < then.pointCount() ? then.positionOf(point)
           : carry.path.empty()                    ? sim::Vec2{}
                                                   : carry.path.front().position;
}

bool wasThrown(const sim::Timeline &timeline, const std::string &body, double leastSpeed)
{
    const std::optional<DragGesture> carry = lastReleased(timeline, body);
    return carry && sim::length(carry->releaseVelocity()) >= leastSpeed;
}

const sim::Phase *lastPhase(const sim::Timeline &timeline)
{
    const int done = timeline.cursor().phase;
    return done > 0 ? &timeline.track().interval().pipeline.phaseAt(done - 1) : nullptr;
}

bool hasMoved(const sim::Timeline &timeline, int group)
{
    return anyDone(timeline, [&](const sim::Phase &phase) {
        return phase.id == "move" && (group < 0 || phase.group == group);
    });
}

bool onlySpringsPulled(const sim::Timeline &timeline)
{
    const bool pulled =
        anyDone(timeline, [](const sim::Phase &phase) { return phase.kind == sim::EffectKind::spring; });
    return pulled && !hasMoved(timeline);
}

bool differsFromComparison(const sim::Timeline &timeline, const std::string &id)
{
    if (!timeline.comparison())
        return false;
    const sim::Values &then = timeline.comparison()->interval().values;
    const sim::Values &now = timeline.track().interval().values;
    return then.has(id) && now.has(id) && then[id] != now[id];
}

bool usesMethod(const sim::Timeline &timeline, const std::string &id)
{
    return timeline.script().method->id() == id;
}

}
