#include "sim/run/script/output_step.h"

#include "sim/run/script/composed_interval.h"
#include "sim/run/script/state_transfer.h"

#include <algorithm>

namespace sim {

namespace {

/// Discards the time that an adaptive method has computed ahead, because it does not include the new input.
void discardStepsAhead(State &state)
{
    for (AdaptiveStep &lastStep : state.adaptiveSteps)
        lastStep.start = lastStep.end = 0.0;
    state.restingContacts.setZero();
}

void release(State &state, const Scene &scene)
{
    const int draggedPoint = state.hold.point;
    if (draggedPoint < 0)
        return;
    state.place(draggedPoint, state.hold.hand);
    state.inverseMass[draggedPoint] = scene.start.inverseMass[draggedPoint];
    state.hold = {};
}

void applyDrag(State &state, const Scene &scene, const Event &event)
{
    if (const Grab *grab = std::get_if<Grab>(&event.what)) {
        release(state, scene);
        const int point = scene.find(grab->body);
        if (point < 0)
            return;
        state.hold = {point, state.positionOf(point)};
        state.inverseMass[point] = 0.0;
    } else if (const Move *move = std::get_if<Move>(&event.what)) {
        if (state.hold.point >= 0)
            state.hold.hand = move->to;
    } else if (std::holds_alternative<Release>(event.what)) {
        release(state, scene);
    }
}

void apply(State &state, const Scene &scene, const Event &event)
{
    if (const auto *pointer = std::get_if<Pointer>(&event.what)) {
        state.input.pointer = pointer->at;
        state.input.pointerDown = pointer->down;
    } else if (const auto *target = std::get_if<Target>(&event.what)) {
        state.input.target = target->at;
        state.input.newTargets.push_back(target->at);
    } else if (const auto *gust = std::get_if<Gust>(&event.what)) {
        state.input.gust = gust->degrees;
    } else if (const auto *key = std::get_if<Key>(&event.what)) {
        state.input.keys.*key->key = key->down;
    } else {
        applyDrag(state, scene, event);
    }
}

/// Returns the first event after the output step that ends at `frame`. Events at frame 0 belong to the first
/// output step.
auto firstAfter(const Script &script, std::int64_t frame)
{
    return std::upper_bound(script.input.begin(), script.input.end(), frame == 0 ? -1 : frame,
                            [](std::int64_t at, const Event &event) { return at < event.frame; });
}

}

bool setsParameters(const Script &script, std::int64_t outputEnd)
{
    for (auto event = firstAfter(script, outputEnd - script.step.framesPerOutput);
         event != script.input.end() && event->frame <= outputEnd; ++event) {
        if (std::holds_alternative<Set>(event->what))
            return true;
    }
    return false;
}

void beginOutputStep(State &state, const Script &script,
                     const std::shared_ptr<const ComposedInterval> &before,
                     const std::shared_ptr<const ComposedInterval> &now, std::int64_t outputEnd)
{
    const int framesPerOutput = script.step.framesPerOutput;
    // Setting a parameter to its current value also transfers the state, although the interval may be the
    // same object.
    if (before != now || setsParameters(script, outputEnd))
        state = transferState(state, before->scene, now->scene);
    if (state.hold.point >= 0)
        discardStepsAhead(state);
    state.frame = outputEnd;
    state.input.gust.reset();
    state.input.newTargets.clear();
    for (auto event = firstAfter(script, outputEnd - framesPerOutput);
         event != script.input.end() && event->frame <= outputEnd; ++event) {
        apply(state, now->scene, *event);
        discardStepsAhead(state);
    }
    const int draggedPoint = state.hold.point;
    if (draggedPoint < 0)
        return;
    state.hold.positionBefore = state.positionOf(draggedPoint);
    state.hold.velocityBefore = state.velocityOf(draggedPoint);
    if (now->scene.start.isDynamic(draggedPoint) && now->scene.movesByVelocity(draggedPoint))
        state.setVelocity(draggedPoint,
                          (1.0 / framesPerOutput) * (state.hold.hand - state.positionOf(draggedPoint)));
    state.place(draggedPoint, state.hold.hand);
}

std::vector<int> grabbedPoints(const Script &script, const Scene &scene, std::int64_t outputEnd)
{
    std::vector<int> points;
    for (auto event = firstAfter(script, outputEnd - script.step.framesPerOutput);
         event != script.input.end() && event->frame <= outputEnd; ++event) {
        if (const Grab *grab = std::get_if<Grab>(&event->what))
            points.push_back(scene.find(grab->body));
    }
    return points;
}

std::optional<std::int64_t> nextInputFrame(const Script &script, std::int64_t frame)
{
    const auto event = firstAfter(script, frame);
    if (event == script.input.end())
        return {};
    return outputStepEnd(event->frame, script.step.framesPerOutput);
}

}
