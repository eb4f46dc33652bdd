#include "app/model/breakpoints/breakpoint_monitor.h"

#include "app/listing/tokens.h"
#include "app/model/breakpoints/condition_names.h"
#include "app/model/catalog/lists.h"
#include "app/model/code/code_listing.h"
#include "app/model/code/source_files.h"
#include "app/model/listing/assigned_paths.h"
#include "app/model/run/run_program.h"
#include "app/model/text/sentences.h"
#include "app/model/text/user_error.h"
#include "sim/run/script/composed_interval.h"
#include "sim/run/sleeping/sleep.h"

#include <QCoreApplication>

#include <algorithm>
#include <limits>
#include <utility>

namespace app {

namespace {

constexpr int allLines = std::numeric_limits<int>::max();

struct BreakpointMonitorText
{
    Q_DECLARE_TR_FUNCTIONS(BreakpointMonitorText)
};

const sim::Phase &nextPhase(const sim::Timeline &run)
{
    return run.track().nextInterval()->pipeline.phaseAt(run.cursor().phase);
}

/// Returns the types of the variables in the listing that computes a run of `step`, by name.
std::map<QString, QString> variablesOf(const lessons::Step &step, const sim::Script &script)
{
    std::string text;
    if (const auto program = programOf(script.method))
        text = program->text();
    else if (script.method->id() == step.method.toStdString() && script.step == sim::StepSize())
        text = step.listing.text.toStdString();
    const listing::Tokens tokens(text);
    std::map<QString, QString> variables;
    const auto textOf = [&](std::size_t i) { return QString::fromStdString(std::string(tokens[i].text)); };
    for (std::size_t i = 0; i + 1 < tokens.size(); ++i) {
        if (declaresVariable(tokens, i))
            variables[textOf(i + 1)] = textOf(i);
    }
    return variables;
}

QString sentenceFor(const Breakpoint &breakpoint, const sim::Timeline &run)
{
    const QString why = !breakpoint.condition.isEmpty() ? breakpoint.condition
                                                        : BreakpointMonitorText::tr("%1, line %2")
                                                              .arg(fileName(breakpoint.place->file))
                                                              .arg(breakpoint.place->line);
    return BreakpointMonitorText::tr("Stopped at frame %1 before %2: %3.")
        .arg(QString::number(run.cursor().frame), phrase(nextPhase(run).title), why);
}

/// Returns why the run stops before the line at `index` of `frame`.
QString sentenceBeforeLine(const Breakpoint &breakpoint, const ListingFrame &frame, int index)
{
    const QString number = QString::number(frame.frame()), line = QString::number(frame.line(index).line);
    return breakpoint.condition.isEmpty()
               ? BreakpointMonitorText::tr("Stopped at frame %1 before line %2 of the listing.")
                     .arg(number, line)
               : BreakpointMonitorText::tr("Stopped at frame %1 before line %2: %3.")
                     .arg(number, line, breakpoint.condition);
}

}

ConditionNames conditionNames(const lessons::Step &step, const sim::Timeline &timeline)
{
    const sim::Track &track = timeline.track();
    return {track.interval().scene, timeline.values(), track.nextInterval()->pipeline,
            condition_names::choicesOf(step), variablesOf(step, timeline.script())};
}

std::vector<int> phasesAt(const CodePlace &place, const sim::Pipeline &pipeline)
{
    SourceFiles book;
    const auto has = [&](const sim::Region &region) {
        if (QString::fromStdString(region.file) != place.file)
            return false;
        const auto text = book.text(region);
        return text && std::any_of(text->begin(), text->end(),
                                   [&](const SourceLine &line) { return line.number == place.line; });
    };
    std::vector<int> found;
    for (int i = 0; i < pipeline.phasesPerStep(); ++i) {
        const std::vector<sim::Region> &regions = pipeline.phases[static_cast<std::size_t>(i)].regions;
        if (std::any_of(regions.begin(), regions.end(), has))
            found.push_back(i);
    }
    return found;
}

void BreakpointMonitor::watch(const std::vector<Breakpoint> &breakpoints, const lessons::Step &step)
{
    m_step = &step;
    m_watched.clear();
    for (const Breakpoint &one : breakpoints) {
        if (one.isOn)
            m_watched.push_back({one, {}, {}});
    }
    m_shown = m_next = nullptr;
    m_last = {-1, 0};
    m_outputStepsOver = 0;
}

void BreakpointMonitor::fit(const sim::Timeline &run)
{
    const std::shared_ptr<const sim::ComposedInterval> shown = run.track().intervalPtr(),
                                                       next = run.track().nextInterval();
    if (shown == m_shown && next == m_next)
        return;
    m_shown = shown;
    m_next = next;
    const ConditionNames names = conditionNames(*m_step, run);
    for (Watched &one : m_watched) {
        one.condition.reset();
        one.phases.clear();
        const std::optional<CodePlace> &place = one.breakpoint.place;
        one.isOfLines = place && place->isInListing();
        if (place && !one.isOfLines)
            one.phases = phasesAt(*place, next->pipeline);
        one.isInForce = !place || one.isOfLines || !one.phases.empty();
        if (one.breakpoint.condition.isEmpty())
            continue;
        try {
            one.condition = Condition::parse(one.breakpoint.condition, names);
            one.isOfLines = one.isOfLines || one.condition->readsVariables();
        } catch (const UserError &) {
            one.isInForce = false; // a name in it does not exist here; the list of breakpoints says so
        }
    }
}

bool BreakpointMonitor::holds(const Watched &one, const sim::Timeline &run) const
{
    return one.isInForce && !one.isOfLines &&
           (!one.condition ||
            one.condition->holds({run.state(), run.cursor().frame, &nextPhase(run), {}, &run.track()}));
}

void BreakpointMonitor::checkBreakpoints(const sim::Timeline &run)
{
    fit(run);
    for (Watched &one : m_watched) {
        if (!one.isOfLines)
            one.held = !one.breakpoint.place && holds(one, run);
    }
}

sim::Cursor BreakpointMonitor::nextPlace(const sim::Timeline &run, sim::Cursor target) const
{
    const sim::Pipeline &pipeline = run.track().nextInterval()->pipeline;
    const auto mayStopAt = [&](int phase) {
        return std::any_of(m_watched.begin(), m_watched.end(), [&](const Watched &one) {
            return one.isInForce && !one.isOfLines &&
                   (!one.breakpoint.place || contains(one.phases, phase % pipeline.phasesPerStep()));
        });
    };
    const sim::Cursor at = run.cursor();
    const sim::Cursor outputEnd{at.frame + run.track().framesPerOutput(), 0};
    for (int phase = at.phase + 1; phase < pipeline.phasesPerOutput(); ++phase) {
        if (mayStopAt(phase))
            return std::min(target, {at.frame, phase});
    }
    return std::min(target, outputEnd);
}

std::optional<BreakHit> BreakpointMonitor::hitAt(const sim::Timeline &run)
{
    fit(run);
    const int phase = run.cursor().phase % m_next->pipeline.phasesPerStep();
    const Breakpoint *hit = nullptr;
    for (Watched &one : m_watched) {
        if (one.isOfLines)
            continue;
        const bool isHere = !one.breakpoint.place || contains(one.phases, phase);
        if (!isHere)
            continue;
        const bool now = holds(one, run);
        if (now && !one.held && !hit)
            hit = &one.breakpoint;
        one.held = now && !one.breakpoint.place;
    }
    if (!hit)
        return std::nullopt;
    return BreakHit{hit->id, run.cursor(), 0, sentenceFor(*hit, run)};
}

bool BreakpointMonitor::holdsBeforeLine(const Watched &one, const sim::State &state,
                                        const ListingFrame &frame, int index) const
{
    if (one.breakpoint.place && one.breakpoint.place->line != frame.line(index).line)
        return false;
    const auto number = [&](const std::string &path) { return frame.numberOf(path, index); };
    return !one.condition || one.condition->holds({state, frame.frame(), nullptr, number});
}

std::optional<BreakHit> BreakpointMonitor::hitInLines(const sim::Timeline &run, Lines lines, int mostLines)
{
    fit(run);
    const auto isWatched = [](const Watched &one) { return one.isInForce && one.isOfLines; };
    if (run.cursor().phase != 0 || std::none_of(m_watched.begin(), m_watched.end(), isWatched))
        return std::nullopt;
    const LinesAhead ahead = m_lines ? m_lines() : LinesAhead();
    if (!ahead.frame)
        return std::nullopt;
    const int begin = lines == Lines::behindCursor ? ahead.index : 0;
    const int end = std::min(ahead.frame->count(), lines == Lines::first ? 1 : mostLines);
    sim::State state = ahead.frame->stateAfter(begin);
    for (int i = begin; i < end; ++i) {
        if (i > begin)
            ahead.frame->applyLine(i - 1, state);
        const bool counts = i > begin || lines != Lines::behindCursor;
        for (Watched &one : m_watched) {
            if (!isWatched(one))
                continue;
            const bool now = holdsBeforeLine(one, state, *ahead.frame, i);
            const bool held = std::exchange(one.held, now && !one.breakpoint.place);
            if (now && !held && counts)
                return BreakHit{one.breakpoint.id, run.cursor(), i,
                                sentenceBeforeLine(one.breakpoint, *ahead.frame, i)};
        }
    }
    return std::nullopt;
}

std::optional<BreakHit> BreakpointMonitor::run(sim::Timeline &run, sim::Cursor target)
{
    if (run.cursor() != m_last)
        m_outputStepsOver = 0;
    checkBreakpoints(run);
    target.frame =
        target.frame / run.track().framesPerOutput() * run.track().framesPerOutput(); // rounded as in seek()
    std::optional<BreakHit> hit = hitInLines(run, Lines::behindCursor, allLines);
    while (!hit && run.cursor() < target) {
        const sim::Cursor wanted = nextPlace(run, target);
        run.seek(wanted);
        if (run.cursor() != wanted) { // the run ends before the target
            run.seek(target);
            break;
        }
        hit = hitAt(run);
        if (run.cursor().phase == 0)
            m_outputStepsOver = run.isFinished() ? m_outputStepsOver + 1 : 0;
        // The run arrives before the first line. The later lines are checked when the run continues.
        if (!hit)
            hit = hitInLines(run, run.cursor() < target ? Lines::all : Lines::first, allLines);
    }
    m_last = run.cursor();
    return hit;
}

std::optional<BreakHit> BreakpointMonitor::hitBeforeLine(const sim::Timeline &run, int lines)
{
    return isWatching() ? hitInLines(run, Lines::behindCursor, lines) : std::nullopt;
}

bool BreakpointMonitor::mayStillStop(const sim::Timeline &run) const
{
    const bool readsFrame = std::any_of(m_watched.begin(), m_watched.end(), [](const Watched &one) {
        return one.isInForce && one.condition && one.condition->readsFrame();
    });
    // Sleeping bodies repeat a cycle of states. After one whole cycle, all of them have been checked.
    return isWatching() &&
           (readsFrame || !run.isFinished() || m_outputStepsOver <= sim::CycleDetector::longest);
}

}
