#include "app/ui/time/run_view.h"

#include "app/model/session/comparison_runs.h"
#include "sim/run/script/composed_interval.h"

#include <algorithm>
#include <map>

namespace app {

namespace {

/// Converts the learner's input events to intervals.
class InputReader
{
public:
    explicit InputReader(const sim::Timeline &timeline) : m_timeline(timeline)
    {
        for (const sim::EffectPtr &effect : timeline.track().interval().scene.effects) {
            if (effect->kind() == sim::EffectKind::wind)
                m_pointerKind = sim::EffectKind::wind;
        }
    }

    std::vector<Stretch> read()
    {
        for (const sim::Event &event : m_timeline.script().input)
            std::visit([&](const auto &what) { take(event.frame, what); }, event.what);
        return std::move(m_all);
    }

private:
    /// Kinds of input that can overlap in time.
    enum Channel { drag, pointer, left, right, up, down, channels };

    /// Returns the frame at which an input begins or ends: the frame before the first one that it changes.
    std::int64_t before(std::int64_t frame) const
    {
        return std::max<std::int64_t>(0, frame - m_timeline.track().framesPerOutput());
    }

    void set(Channel channel, std::int64_t frame, bool on, sim::EffectKind kind = sim::EffectKind::driver)
    {
        int &open = m_open[channel];
        if (open >= 0) {
            Stretch &last = m_all[static_cast<std::size_t>(open)];
            last.to = before(frame);
            last.goesOn = false;
        }
        open = -1;
        if (!on)
            return;
        open = static_cast<int>(m_all.size());
        m_all.push_back({before(frame), before(frame), kind, true});
    }

    void take(std::int64_t frame, const sim::Grab &) { set(drag, frame, true); }
    void take(std::int64_t, const sim::Move &) {}
    void take(std::int64_t frame, const sim::Release &) { set(drag, frame, false); }
    void take(std::int64_t frame, const sim::Pointer &event)
    {
        if (event.down != (m_open[pointer] >= 0))
            set(pointer, frame, event.down, m_pointerKind);
    }
    void take(std::int64_t frame, const sim::Target &)
    {
        m_all.push_back({before(frame), before(frame), sim::EffectKind::driver, false});
    }
    void take(std::int64_t, const sim::Gust &) {}
    void take(std::int64_t frame, const sim::Key &event)
    {
        const Channel channel = event.key == &sim::Keys::left    ? left
                                : event.key == &sim::Keys::right ? right
                                : event.key == &sim::Keys::up    ? up
                                                                 : down;
        if (event.down != (m_open[channel] >= 0))
            set(channel, frame, event.down);
    }
    void take(std::int64_t, const sim::Set &) {}

    const sim::Timeline &m_timeline;
    sim::EffectKind m_pointerKind = sim::EffectKind::driver;
    std::vector<Stretch> m_all;
    int m_open[channels] = {-1, -1, -1, -1, -1, -1}; ///< indices into m_all
};

void goOn(RunView &view)
{
    for (Stretch &stretch : view.input) {
        if (stretch.goesOn)
            stretch.to = std::max(view.computed, stretch.from);
    }
}

std::vector<Fork> forksOf(const sim::Timeline &timeline, const Branches &branches, const Branch *shown)
{
    std::map<std::int64_t, Fork> byFrame;
    for (const Branch &branch : branches.all()) {
        if (&branch == shown)
            continue;
        const std::int64_t at = lastShared(timeline.script(), *branch.script);
        Fork &fork = byFrame[at];
        fork.at = at;
        fork.branches.push_back(branch.id);
    }
    std::vector<Fork> forks;
    for (auto &[at, fork] : byFrame)
        forks.push_back(std::move(fork));
    return forks;
}

}

RunView runViewOf(const sim::Timeline &timeline, const ComparisonRuns &comparisons, bool isPlaying)
{
    RunView view;
    view.at = timeline.cursor().frame;
    view.computed = timeline.computed();
    view.input = InputReader(timeline).read();
    goOn(view);
    view.playing = isPlaying;
    const sim::Track *comparison = timeline.comparison();
    const Branch *branch = comparisons.shown();
    if (comparison && branch) {
        const std::int64_t shared = timeline.forkFrame() - timeline.track().framesPerOutput();
        view.comparison = ComparisonRun{std::max<std::int64_t>(0, shared), comparison->computed(),
                                        branch->name, branch->id};
    }
    view.forks = forksOf(timeline, comparisons.branches(), view.comparison ? branch : nullptr);
    return view;
}

void follow(RunView &view, const sim::Timeline &timeline)
{
    view.at = timeline.cursor().frame;
    view.computed = timeline.computed();
    goOn(view);
    if (view.comparison && timeline.comparison())
        view.comparison->end = timeline.comparison()->computed();
}

}
