#include "app/cli/trace.h"

#include "app/cli/experiment_named.h"
#include "app/cli/terminal.h"
#include "app/model/experiment.h"
#include "app/model/sentences.h"
#include "sim/run/script/composed_interval.h"

#include <QCoreApplication>

#include <charconv>
#include <optional>

namespace app {

namespace {

struct Text
{
    Q_DECLARE_TR_FUNCTIONS(Trace)
};

/// Kept states only shorten the way back to where numbers stopped being finite: a little is enough, and memory
/// stays the same however long the run is.
constexpr std::size_t historyBudget = std::size_t{1} << 20;

/// In the fewest digits, 17 at most, that are read back as the same number; whatever the locale.
template <class Number>
void append(std::string &text, Number value)
{
    char digits[32];
    const auto [end, error] = std::to_chars(digits, digits + sizeof digits, value);
    text.append(digits, end);
}

const char *titles(lessons::TraceColumns columns)
{
    switch (columns) {
    case lessons::TraceColumns::position:
        return "frame,body,x,y\n";
    case lessons::TraceColumns::positionAndAngle:
        return "frame,body,x,y,angle\n";
    case lessons::TraceColumns::positionAndVelocity:
        break;
    }
    return "frame,body,x,y,vx,vy\n";
}

void appendRow(std::string &text, const sim::Track &track, lessons::TraceColumns columns)
{
    const sim::State &state = track.state();
    const auto cell = [&text](double value) {
        text += ',';
        append(text, value);
    };
    for (int point = 0; point < state.pointCount(); ++point) {
        append(text, track.cursor().frame);
        text += ',';
        text += track.interval().scene.names[static_cast<std::size_t>(point)];
        cell(state.positionOf(point).x);
        cell(state.positionOf(point).y);
        if (columns == lessons::TraceColumns::positionAndAngle)
            cell(state.angle[point]);
        if (columns == lessons::TraceColumns::positionAndVelocity) {
            cell(state.velocityOf(point).x);
            cell(state.velocityOf(point).y);
        }
        text += '\n';
    }
}

/// Writes the rows up to frame `frames`, and sets `last` to the last one. Returns whether all were written; if not, the
/// caller asks why.
bool writeRows(sim::Track &track, std::int64_t frames, lessons::TraceColumns columns, Output &output,
               std::int64_t &last)
{
    RunProgress progress(frames);
    output.buffer() += titles(columns);
    appendRow(output.buffer(), track, columns);
    for (std::int64_t frame = track.framesPerOutput(); frame <= frames; frame += track.framesPerOutput()) {
        // Asked within a row, too: one can take long.
        const auto goesOn = [&] {
            progress.at(last);
            return !isInterrupted();
        };
        if (!goesOn() || !track.seek({frame, 0}, goesOn) || track.stop())
            return false;
        appendRow(output.buffer(), track, columns);
        last = frame;
        if (!output.rowDone())
            return false;
    }
    return true;
}

int writeTrace(const Experiment &experiment, lessons::TraceColumns columns)
{
    std::optional<Waiting> waiting(Text::tr("Setting up the run"));
    sim::Track track(experiment.script, historyBudget);
    waiting.reset();
    Output output;
    listenForInterrupt();
    std::int64_t last = 0;
    const bool isWhole = writeRows(track, experiment.frames, columns, output, last);
    if (!output.flush()) {
        if (output.failure().isEmpty())
            return exitDone;
        say(Text::tr("The rows cannot be written: %1. Make room, or write to another place.")
                .arg(output.failure()));
        return exitBadUse;
    }
    if (isWhole)
        return exitDone;
    if (track.stop()) {
        say(sentenceFor(*track.stop()));
        return exitNo;
    }
    say(Text::tr("Stopped at frame %1 of %2.").arg(last).arg(experiment.frames));
    return exitInterrupted;
}

}

int trace(const QString &file)
{
    try {
        const LessonLibrary library = LessonLibrary::load(LessonLibrary::folders());
        const Experiment experiment = experimentIn(file, library);
        const lessons::Step *step = library.lesson(experiment.lesson)->step(experiment.step);
        return writeTrace(experiment, step->traceColumns);
    } catch (const Refusal &refusal) {
        say(refusal.sentence());
        return exitBadUse;
    }
}

}
