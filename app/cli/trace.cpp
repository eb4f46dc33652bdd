#include "app/cli/experiment_argument.h"
#include "app/cli/terminal.h"
#include "app/cli/trace_rows.h"
#include "app/cli/verbs.h"
#include "app/model/experiment/experiment.h"
#include "app/model/run/run_program.h"

#include <QCoreApplication>

#include <unistd.h>

#include <optional>

namespace app {

namespace {

struct TraceText
{
    Q_DECLARE_TR_FUNCTIONS(TraceText)
};

/// In bytes. Keyframes only shorten the search for the step that stopped being finite, so a few are enough. A small
/// budget keeps the memory constant for long runs.
constexpr std::size_t keyframeBudget = std::size_t{1} << 20;

/// Writes the rows up to frame `frames`, and sets `last` to the last written frame. Returns whether all rows were
/// written.
bool writeRows(sim::Track &track, std::int64_t frames, lessons::TraceColumns columns, Output &output,
               std::int64_t &last)
{
    TerminalLine progress;
    if (isatty(STDOUT_FILENO))
        progress.hide(); // the rows are shown there
    output.buffer() += traceTitles(columns);
    appendTraceRow(output.buffer(), track, columns);
    for (std::int64_t frame = track.framesPerOutput(); frame <= frames; frame += track.framesPerOutput()) {
        // Called within a frame, too, because one frame can take long.
        const auto goesOn = [&] {
            progress.showFrame(last, frames);
            return !isInterrupted();
        };
        if (!goesOn() || !track.seek({frame, 0}, goesOn) || track.stop())
            return false;
        appendTraceRow(output.buffer(), track, columns);
        last = frame;
        if (!output.endRow())
            return false;
    }
    return true;
}

int writeTrace(const Experiment &experiment, lessons::TraceColumns columns)
{
    std::optional<Waiting> waiting(TraceText::tr("Setting up the run"));
    sim::Track track(experiment.script, keyframeBudget);
    waiting.reset();
    Output output;
    listenForInterrupt();
    std::int64_t last = 0;
    const bool isComplete = writeRows(track, experiment.frames, columns, output, last);
    if (!output.flush()) {
        if (output.failure().isEmpty())
            return exitDone;
        printMessage(
            TraceText::tr(
                "The rows could not be written: %1. Free some disk space, or write to another folder.")
                .arg(output.failure()));
        return exitBadUse;
    }
    if (isComplete)
        return exitDone;
    if (track.stop()) {
        printMessage(endSentence(track));
        return exitNo;
    }
    return printInterrupted(last, experiment.frames);
}

}

int runTrace(const Arguments &arguments)
{
    const LessonLibrary library = LessonLibrary::load(LessonLibrary::folders());
    const Experiment experiment = experimentFromFile(arguments.names[0], library);
    const lessons::Step *step = library.lesson(experiment.lesson)->step(experiment.step);
    return writeTrace(experiment, step->traceColumns);
}

}
