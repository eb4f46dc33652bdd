#include "lessons/api/checks/drag_gesture.h"

#include "lessons/api/checks/input_queries.h"
#include "sim/run/script/composed_interval.h"
#include "sim/run/timeline.h"

#include <algorithm>

namespace lessons {

namespace {

void release(std::vector<DragGesture> &all, std::int64_t frame)
{
    if (!all.empty() && !all.back().releaseFrame)
        all.back().releaseFrame = frame;
}

void moveTo(std::vector<DragGesture> &all, std::int64_t frame, sim::Vec2 to)
{
    if (all.empty() || all.back().releaseFrame)
        return;
    std::vector<PointerSample> &path = all.back().path;
    if (!path.empty() && path.back().frame == frame)
        path.back().position = to;
    else
        path.push_back({frame, to});
}

}

double DragGesture::farthest() const
{
    double farthest = 0.0;
    for (const PointerSample &sample : path)
        farthest = std::max(farthest, sim::length(sample.position - path.front().position));
    return farthest;
}

std::optional<sim::Vec2> DragGesture::positionAt(std::int64_t frame) const
{
    std::optional<sim::Vec2> found;
    for (const PointerSample &sample : path) {
        if (sample.frame <= frame)
            found = sample.position;
    }
    return found;
}

sim::Vec2 DragGesture::releaseVelocity() const
{
    if (!releaseFrame)
        return {};
    // The body is already free in the frame of its release, so its velocity comes from the frame before.
    const std::optional<sim::Vec2> last = positionAt(*releaseFrame - 1);
    const std::optional<sim::Vec2> before = positionAt(*releaseFrame - 2);
    return last && before ? *last - *before : sim::Vec2{};
}

std::vector<DragGesture> dragGestures(const sim::Timeline &timeline)
{
    std::vector<DragGesture> all;
    for (const sim::Event &event : appliedInput(timeline)) {
        if (const auto *grab = std::get_if<sim::Grab>(&event.what)) {
            release(all, event.frame);
            all.push_back({grab->body, event.frame, {}, {}});
        } else if (const auto *move = std::get_if<sim::Move>(&event.what)) {
            moveTo(all, event.frame, move->to);
        } else if (std::holds_alternative<sim::Release>(event.what)) {
            release(all, event.frame);
        }
    }
    return all;
}

std::optional<DragGesture> lastReleased(const sim::Timeline &timeline, const std::string &body)
{
    const std::vector<DragGesture> all = dragGestures(timeline);
    if (all.empty() || !all.back().releaseFrame || (!body.empty() && all.back().body != body))
        return {};
    return all.back();
}

std::string heldBody(const sim::Timeline &timeline)
{
    const int held = timeline.state().hold.point;
    return held < 0 ? std::string() : timeline.track().interval().scene.names[static_cast<std::size_t>(held)];
}

std::int64_t idleFrames(const sim::Timeline &timeline)
{
    if (timeline.state().hold.point >= 0)
        return 0;
    std::int64_t last = 0;
    for (const sim::Event &event : appliedInput(timeline)) {
        if (!std::holds_alternative<sim::Set>(event.what))
            last = event.frame;
    }
    return timeline.cursor().frame - last;
}

}
