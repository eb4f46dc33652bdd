#include "app/ui/time/run_view.h"

#include "app/model/session.h"

#include <algorithm>

namespace app {

namespace {

/// Where the hand held something. It takes hold, and lets go, at the frame before the one that it first changes.
void readHand(RunView &view, const sim::Timeline &timeline)
{
    const auto before = [&](std::int64_t frame) {
        return std::max<std::int64_t>(0, frame - timeline.track().rowFrames());
    };
    for (const sim::Event &event : timeline.script().input) {
        const bool grabs = std::holds_alternative<sim::Grab>(event.what);
        if (!grabs && !std::holds_alternative<sim::Release>(event.what))
            continue;
        if (view.holding)
            view.hand.back().to = before(event.frame);
        if (grabs)
            view.hand.push_back({before(event.frame), before(event.frame)});
        view.holding = grabs;
    }
}

void holdOn(RunView &view)
{
    if (view.holding)
        view.hand.back().to = std::max(view.computed, view.hand.back().from);
}

}

RunView runViewOf(const Session &session)
{
    const sim::Timeline &timeline = session.timeline();
    RunView view;
    view.at = timeline.at().frame;
    view.computed = timeline.computed();
    readHand(view, timeline);
    holdOn(view);
    view.playing = session.isPlaying();
    if (const sim::Track *ghost = timeline.ghost()) {
        const std::int64_t shared = timeline.fork() - timeline.track().rowFrames();
        view.old = OldRun{std::max<std::int64_t>(0, shared), ghost->computed(), session.ghostName()};
    }
    return view;
}

void follow(RunView &view, const Session &session)
{
    const sim::Timeline &timeline = session.timeline();
    view.at = timeline.at().frame;
    view.computed = timeline.computed();
    holdOn(view);
    if (view.old && timeline.ghost())
        view.old->end = timeline.ghost()->computed();
}

}
