#include "app/model/run/rule_error.h"

#include "app/model/text/listing_text.h"
#include "sim/run/script/composed_interval.h"

#include <QCoreApplication>

namespace app {

namespace {

struct RuleErrorText
{
    Q_DECLARE_TR_FUNCTIONS(RuleErrorText)
};

QString nameOf(const sim::Scene &scene, int point)
{
    return QString::fromStdString(scene.names.at(static_cast<std::size_t>(point)));
}

}

std::optional<listing::RuleError> ruleErrorOf(const sim::Track &track)
{
    if (!track.stop())
        return {};
    const std::int64_t frame = track.stop()->frame;
    const auto interval = track.intervalAt(frame + track.framesPerOutput());
    const sim::State state = track.stateAfterInput(track.stateAt(frame), frame);
    return listing::ruleErrorIn(interval->scene, *track.script().method, interval->pipeline.step, state);
}

QString ruleMistakeSentence(const listing::RuleError &error, const sim::Scene &scene)
{
    const QString line = QString::number(error.error.line), sentence = listingSentence(error.error.sentence);
    const QString me = nameOf(scene, error.me);
    if (error.other < 0)
        return RuleErrorText::tr("Line %1 of your rule, for %2: %3").arg(line, me, sentence);
    return RuleErrorText::tr("Line %1 of your rule, for %2 and %3: %4")
        .arg(line, me, nameOf(scene, error.other), sentence);
}

}
