#include "app/model/listing/line_stepper.h"

#include "app/model/run/run_program.h"
#include "app/model/run/same_run.h"
#include "app/model/session/preview.h"
#include "sim/run/script/composed_interval.h"

#include <algorithm>
#include <utility>

namespace app {

namespace {

/// Points times frames from the last keyframe that a frame in the past may cost.
constexpr std::int64_t mostPointFrames = 200'000;
constexpr std::size_t memoryOfRemembered = std::size_t{4} << 20;

}

std::shared_ptr<const ListingFrame> LineStepper::frameFrom(const sim::Track &track, const sim::State &end,
                                                           std::int64_t frame, Traced &traced) const
{
    const std::shared_ptr<const listing::Program> program = m_code.program();
    if (!program)
        return nullptr;
    const auto interval = track.intervalAt(frame + 1);
    const sim::State start = track.stateAfterInput(end, frame);
    const bool isSame = traced.frame && traced.frame->frame() == frame && traced.program == program &&
                        traced.interval == interval && sim::sameBits(traced.start, start);
    if (!isSame) {
        sim::State remembered = start;
        if (!programOf(track.script().method))
            remembered.memory = memoryAt(track.script(), program, frame);
        traced = {interval, program, start,
                  std::make_shared<const ListingFrame>(program, interval->scene, remembered, frame)};
    }
    return traced.frame;
}

std::vector<std::byte> LineStepper::memoryAt(const sim::Script &script,
                                             const std::shared_ptr<const listing::Program> &program,
                                             std::int64_t frame) const
{
    if (!program->remembers() || frame == 0)
        return {};
    sim::Script own = script;
    own.method = std::make_shared<const listing::ListingMethod>(program);
    // The input of a drag grows with each frame, and what comes before stays.
    const bool isSame = m_remembered && programOf(m_remembered->script().method) == program &&
                        sameButForInput(m_remembered->script(), own);
    const std::int64_t from = isSame ? sim::firstDifference(m_remembered->script().input, own.input) : 0;
    if (!isSame || from <= 1) {
        m_remembered.emplace(std::move(own), memoryOfRemembered);
    } else if (m_remembered->script().input != own.input) {
        sim::Track::NewInput input = m_remembered->prepareInput(std::move(own.input), from);
        m_remembered->seek({std::min(from - 1, m_remembered->computed()), 0});
        m_remembered->replaceInput(std::move(input));
    }
    m_remembered->seek({frame, 0});
    return m_remembered->state().memory;
}

std::shared_ptr<const ListingFrame> LineStepper::nextFrame() const
{
    const sim::Track &track = m_run.timeline().track();
    if (!isAvailable() || track.cursor().phase != 0)
        return nullptr;
    return frameFrom(track, track.state(), track.cursor().frame, m_next);
}

int LineStepper::count() const
{
    const std::shared_ptr<const ListingFrame> frame = nextFrame();
    return frame ? frame->count() : 0;
}

LineStepper::Shown LineStepper::shown() const
{
    if (m_index > 0 && !m_preview.isActive())
        return {nextFrame(), m_index, true};
    const sim::Track &track = m_preview.run().track();
    const std::int64_t last = track.cursor().frame - 1;
    if (!isAvailable() || track.cursor().phase != 0 || last < 0)
        return {};
    // Playing forward, the last frame has often been the next one just before.
    if (m_next.frame && m_next.frame->frame() == last && !(m_last.frame && m_last.frame->frame() == last))
        m_last = m_next;
    if ((last - track.cachedFrameBefore(last)) * track.state().pointCount() > mostPointFrames)
        return {};
    const std::shared_ptr<const ListingFrame> frame = frameFrom(track, track.stateAt(last), last, m_last);
    return {frame, frame ? frame->count() : 0, false};
}

LinesAhead LineStepper::ahead() const
{
    const bool isHere = m_run.timeline().cursor() == sim::Cursor{m_at, 0};
    return {nextFrame(), isHere ? m_index : 0};
}

int LineStepper::nextLine() const
{
    const std::shared_ptr<const ListingFrame> frame = nextFrame();
    return frame && m_index < frame->count() ? frame->line(m_index).line : 0;
}

void LineStepper::set(int index)
{
    const std::shared_ptr<const ListingFrame> frame = nextFrame();
    m_index = frame ? std::clamp(index, 0, std::max(0, frame->count() - 1)) : 0;
    m_at = m_run.timeline().cursor().frame;
    m_state.reset();
    if (m_index > 0)
        m_state = frame->stateAfter(m_index);
    m_run.changes().announce(ChangeKind::cursor);
}

bool LineStepper::pauseOutsidePhases()
{
    m_playback.pause();
    m_playback.clearBreakHit();
    const sim::Cursor at = m_run.timeline().cursor();
    if (at.phase == 0)
        return false;
    m_playback.goTo({at.frame, 0});
    return true;
}

void LineStepper::goTo(int index)
{
    const ChangeNotifier::Batch batch(m_run.changes());
    pauseOutsidePhases();
    const std::shared_ptr<const ListingFrame> frame = nextFrame();
    if (!frame)
        return;
    if (index < frame->count()) {
        set(index);
    } else if (frame->error() || !frame->isComplete()) {
        set(frame->count() - 1);
        if (frame->error())
            m_run.showMessage(mistakeSentence(*frame->error()));
    } else {
        m_playback.frameForward();
    }
}

void LineStepper::forward()
{
    goTo(m_index + 1);
}

void LineStepper::back()
{
    const ChangeNotifier::Batch batch(m_run.changes());
    if (pauseOutsidePhases() || !isAvailable())
        return;
    if (m_index > 0) {
        set(m_index - 1);
        return;
    }
    const std::int64_t frame = m_run.timeline().cursor().frame;
    if (frame == 0)
        return;
    m_goesToEndOf = frame - 1;
    m_playback.frameBack();
    arrive();
}

void LineStepper::arrive()
{
    const sim::Cursor at = m_run.timeline().cursor();
    if (m_goesToEndOf < 0 || m_playback.goal())
        return; // the frame before is still being computed
    if (at == sim::Cursor{std::exchange(m_goesToEndOf, -1), 0})
        set(count() - 1);
}

void LineStepper::stepOver()
{
    const std::shared_ptr<const ListingFrame> frame = nextFrame();
    goTo(frame && m_index < frame->count() ? frame->nextWithin(m_index, frame->line(m_index).depth)
                                           : m_index + 1);
}

void LineStepper::stepOut()
{
    const std::shared_ptr<const ListingFrame> frame = nextFrame();
    goTo(frame && m_index < frame->count() ? frame->nextWithin(m_index, frame->line(m_index).depth - 1)
                                           : m_index + 1);
}

bool LineStepper::runTo(int line)
{
    const ChangeNotifier::Batch batch(m_run.changes());
    pauseOutsidePhases();
    const std::shared_ptr<const ListingFrame> frame = nextFrame();
    if (!frame)
        return false;
    const auto find = [line](const ListingFrame &in, int from) {
        const auto begin = in.lines().begin() + std::min(from, in.count());
        const auto found =
            std::find_if(begin, in.lines().end(), [&](const auto &one) { return one.line == line; });
        return found == in.lines().end() ? -1 : static_cast<int>(found - in.lines().begin());
    };
    const int here = find(*frame, m_index + 1);
    if (here >= 0) {
        m_playback.runToLine(here);
        return true;
    }
    if (!frame->error() && frame->isComplete()) {
        const sim::Track &track = m_run.timeline().track();
        Traced traced;
        const std::shared_ptr<const ListingFrame> following =
            frameFrom(track, frame->stateAfter(frame->count()), frame->frame() + 1, traced);
        const int there = following ? find(*following, 0) : -1;
        if (there >= 0) {
            m_playback.frameForward();
            // A breakpoint or the end of the run can come first.
            if (m_run.timeline().cursor() == sim::Cursor{frame->frame() + 1, 0} && !m_playback.breakHit())
                m_playback.runToLine(there);
            return true;
        }
    }
    m_run.showMessage(tr("Line %1 does not run in this frame, nor in the next one.").arg(line));
    return false;
}

void LineStepper::follow()
{
    arrive();
    const sim::Cursor at = m_run.timeline().cursor();
    if (m_index == 0)
        return;
    const std::shared_ptr<const ListingFrame> before = m_next.frame;
    const bool isHere = isAvailable() && at == sim::Cursor{m_at, 0};
    const std::shared_ptr<const ListingFrame> now = isHere ? nextFrame() : nullptr;
    if (now && now == before)
        return;
    // With other numbers, the same place in the frame is still of use; in another text it is not.
    const bool isSameText = now && before && now->program().text() == before->program().text();
    set(isSameText ? m_index : 0);
}

}
