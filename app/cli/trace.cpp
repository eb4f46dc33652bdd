#include "app/cli/trace.h"

#include "app/cli/terminal.h"
#include "app/model/experiment.h"
#include "app/model/sentences.h"

#include <QCoreApplication>

#include <charconv>

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

void appendRow(std::string &text, const sim::Track &track)
{
    const sim::State &state = track.now();
    for (int point = 0; point < state.points(); ++point) {
        append(text, track.at().frame);
        text += ',';
        text += track.shown().scene.names[static_cast<std::size_t>(point)];
        for (const double value :
             {state.at(point).x, state.at(point).y, state.speed(point).x, state.speed(point).y}) {
            text += ',';
            append(text, value);
        }
        text += '\n';
    }
}

/// Writes the rows up to frame `frames`. Returns whether all were written; if not, the caller asks why.
bool writeRows(sim::Track &track, std::int64_t frames, Output &output)
{
    Progress progress(frames);
    output.buffer() += "frame,body,x,y,vx,vy\n";
    appendRow(output.buffer(), track);
    for (std::int64_t frame = track.rowFrames(); frame <= frames; frame += track.rowFrames()) {
        if (isInterrupted())
            return false;
        track.seek({frame, 0});
        if (track.stop())
            return false;
        appendRow(output.buffer(), track);
        if (!output.rowDone())
            return false;
        progress.at(frame);
    }
    return true;
}

int writeTrace(const Experiment &experiment)
{
    sim::Track track(experiment.script, historyBudget);
    Output output;
    listenForInterrupt();
    const bool isWhole = writeRows(track, experiment.frames, output);
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
    say(Text::tr("Stopped at frame %1 of %2.").arg(track.at().frame).arg(experiment.frames));
    return exitInterrupted;
}

}

int trace(const QString &file)
{
    try {
        const LessonLibrary library = LessonLibrary::load(LessonLibrary::folders());
        return writeTrace(readExperiment(file, library));
    } catch (const Refusal &refusal) {
        say(refusal.sentence());
        return exitBadUse;
    }
}

}
