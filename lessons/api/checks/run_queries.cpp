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
    const int perStep = timeline.track().shown().pipeline.phasesPerStep();
    return (timeline.at().phase - 1) / perStep * perStep;
}

/// Whether `which(phase)` for any phase that is done of the step under way, inside a frame.
template <class Which>
bool anyDone(const sim::Timeline &timeline, Which &&which)
{
    const int done = timeline.at().phase;
    for (int i = done > 0 ? stepStart(timeline) : 0; i < done; ++i) {
        if (which(timeline.track().shown().pipeline.phaseAt(i)))
            return true;
    }
    return false;
}

}

sim::Vec2 placeOf(const sim::Timeline &timeline, const std::string &name)
{
    constexpr double nowhere = std::numeric_limits<double>::quiet_NaN();
    const int point = timeline.track().shown().scene.find(name);
    return point < 0 ? sim::Vec2{nowhere, nowhere} : timeline.now().at(point);
}

double distance(const sim::Timeline &timeline, const std::string &a, const std::string &b)
{
    return sim::length(placeOf(timeline, a) - placeOf(timeline, b));
}

sim::Vec2 middle(const sim::Timeline &timeline)
{
    const auto mean = timeline.now().position.colwise().mean().eval();
    return {mean[0], mean[1]};
}

sim::Vec2 momentum(const sim::Timeline &timeline)
{
    const auto sum = timeline.now().velocity.colwise().sum().eval();
    return {sum[0], sum[1]};
}

bool onStage(sim::Vec2 place)
{
    return place.x >= 0.0 && place.x <= 540.0 && place.y >= 0.0 && place.y <= 400.0;
}

bool isStill(const sim::Timeline &timeline)
{
    if (timeline.at().phase > 0 || timeline.stop())
        return false;
    const sim::FlushTiny flush;
    std::shared_ptr<const sim::Segment> segment;
    sim::State state = timeline.track().preview(segment);
    Eigen::ArrayX2d before = timeline.now().position;
    for (int row = 0; row < 2; ++row) {
        for (int phase = 0; phase < segment->pipeline.phasesPerRow(); ++phase)
            segment->pipeline.phaseAt(phase).run(state);
        if (sim::firstStuck(state) >= 0 || before.rows() != state.position.rows() ||
            !((state.position - before).abs() <= stillness).all()) // false for what is not finite, too
            return false;
        before = state.position;
    }
    return true;
}

std::int64_t frameOfSet(const sim::Timeline &timeline, const std::string &id)
{
    std::int64_t last = 0;
    for (const sim::Event &event : timeline.script().input) {
        const auto *set = std::get_if<sim::Set>(&event.what);
        if (set && set->parameter == id && event.frame <= timeline.at().frame + timeline.track().rowFrames())
            last = std::max(last, event.frame);
    }
    return last;
}

std::int64_t framesSinceSet(const sim::Timeline &timeline, const std::string &id)
{
    return std::max<std::int64_t>(0, timeline.at().frame - frameOfSet(timeline, id));
}

bool isSetTo(const sim::Timeline &timeline, const std::string &id, double value)
{
    return timeline.values().has(id) && std::abs(timeline.values()[id] - value) < 0.005;
}

sim::Vec2 takenFrom(const sim::Timeline &timeline, const Carry &carry)
{
    const int point = timeline.track().shown().scene.find(carry.body);
    const sim::State then = timeline.track().stateAt(std::max<std::int64_t>(0, carry.grabbed - 1));
    return point >= 0 && point < then.points() ? then.at(point)
           : carry.path.empty()                ? sim::Vec2{}
                                               : carry.path.front().at;
}

bool wasThrown(const sim::Timeline &timeline, const std::string &body, double leastSpeed)
{
    const std::optional<Carry> carry = lastLetGo(timeline, body);
    return carry && sim::length(carry->throwVelocity()) >= leastSpeed;
}

const sim::Phase *lastPhase(const sim::Timeline &timeline)
{
    const int done = timeline.at().phase;
    return done > 0 ? &timeline.track().shown().pipeline.phaseAt(done - 1) : nullptr;
}

bool hasMoved(const sim::Timeline &timeline, int group)
{
    return anyDone(timeline, [&](const sim::Phase &phase) {
        return phase.id == "move" && (group < 0 || phase.group == group);
    });
}

bool springPulledNothingMoved(const sim::Timeline &timeline)
{
    const bool pulled =
        anyDone(timeline, [](const sim::Phase &phase) { return phase.kind == sim::Kind::spring; });
    return pulled && !hasMoved(timeline);
}

bool differsFromGhost(const sim::Timeline &timeline, const std::string &id)
{
    if (!timeline.ghost())
        return false;
    const sim::Values &then = timeline.ghost()->shown().values;
    const sim::Values &now = timeline.track().shown().values;
    return then.has(id) && now.has(id) && then[id] != now[id];
}

bool usesMethod(const sim::Timeline &timeline, const std::string &id)
{
    return timeline.script().method->id() == id;
}

}
