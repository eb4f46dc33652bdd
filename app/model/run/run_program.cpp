#include "app/model/run/run_program.h"

#include "app/listing/listing_method.h"
#include "app/model/run/rule_error.h"
#include "app/model/text/listing_text.h"
#include "app/model/text/sentences.h"
#include "sim/run/script/composed_interval.h"

#include <QCoreApplication>

namespace app {

namespace {

struct RunProgramText
{
    Q_DECLARE_TR_FUNCTIONS(RunProgramText)
};

}

std::shared_ptr<const listing::Program> programOf(const sim::MethodPtr &method)
{
    const auto *listed = dynamic_cast<const listing::ListingMethod *>(method.get());
    return listed ? listed->programPtr() : nullptr;
}

listing::Compiled compiledFor(const sim::Script &script, const QString &code)
{
    return listing::Program::compile(code.toStdString(),
                                     listing::vocabularyOf(sim::sceneOf(script, script.values)));
}

std::optional<listing::RunError> runErrorOf(const sim::Track &track)
{
    const std::shared_ptr<const listing::Program> program = programOf(track.script().method);
    if (!program || !track.stop())
        return {};
    const std::int64_t frame = track.stop()->frame;
    sim::State state = track.stateAfterInput(track.stateAt(frame), frame);
    const auto interval = track.intervalAt(frame + track.framesPerOutput());
    return program->run(state, listing::bind(program->vocabulary(), interval->scene));
}

QString mistakeSentence(const listing::RunError &error)
{
    return RunProgramText::tr("Line %1 of your code: %2")
        .arg(QString::number(error.line), listingSentence(error.sentence));
}

QString endSentence(const sim::Track &track)
{
    const std::int64_t frame = track.stop()->frame;
    const auto stopped = [frame](const QString &mistake) {
        return RunProgramText::tr("Stopped at frame %1. %2").arg(QString::number(frame), mistake);
    };
    if (const std::optional<listing::RunError> error = runErrorOf(track))
        return stopped(mistakeSentence(*error));
    if (const std::optional<listing::RuleError> error = ruleErrorOf(track))
        return stopped(ruleMistakeSentence(*error, track.intervalAt(frame + track.framesPerOutput())->scene));
    return sentenceFor(*track.stop());
}

}
