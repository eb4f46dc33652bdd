#include "app/ui/time/run_position.h"

#include "app/model/text/phrases.h"
#include "app/model/text/sentences.h"
#include "sim/run/script/composed_interval.h"

#include <QCoreApplication>

namespace app {

namespace {

struct RunPositionText
{
    Q_DECLARE_TR_FUNCTIONS(RunPositionText)
};

}

Position positionOf(const sim::Timeline &timeline)
{
    const sim::Cursor at = timeline.cursor();
    const std::shared_ptr<const sim::ComposedInterval> interval = timeline.track().nextInterval();
    Position position;
    position.frame = at.frame;
    position.steps = interval->pipeline.step.stepsPerOutput;
    position.phases = interval->pipeline.phasesPerStep();
    if (at.phase > 0) {
        // After the last phase of a step, show this step as completed and not the next one: its result is on
        // the screen.
        position.step = (at.phase - 1) / position.phases;
        position.done = at.phase - position.step * position.phases;
    }
    return position;
}

Position endOf(const sim::Timeline &timeline)
{
    const sim::Pipeline &pipeline = timeline.track().interval().pipeline;
    Position position;
    position.frame = timeline.cursor().frame;
    position.steps = pipeline.step.stepsPerOutput;
    position.step = position.steps - 1;
    position.phases = pipeline.phasesPerStep();
    position.done = position.phases;
    return position;
}

QString stepOf(const Position &position)
{
    if (position.steps == 1)
        return {};
    return RunPositionText::tr("step %1 of %2").arg(position.step + 1).arg(position.steps);
}

QString progressOf(const Position &position)
{
    if (!position.isInside())
        return {};
    const QString phases =
        RunPositionText::tr("%1 of %2 phases done").arg(position.done).arg(position.phases);
    return position.steps == 1 ? phases : listed(stepOf(position), phases);
}

QString shortProgressOf(const Position &position)
{
    if (!position.isInside())
        return {};
    const QString phases = partOf(QString::number(position.done), QString::number(position.phases));
    return position.steps == 1 ? phases : listed(stepOf(position), phases);
}

QString sentenceOf(const sim::Timeline &timeline)
{
    const Position position = positionOf(timeline);
    if (!position.isInside())
        return RunPositionText::tr("Frame %1").arg(position.frame);
    const std::shared_ptr<const sim::ComposedInterval> interval = timeline.track().nextInterval();
    const QString last = phrase(interval->pipeline.phaseAt(position.done - 1).title);
    return RunPositionText::tr("Frame %1, after %2, %3").arg(position.frame).arg(last, progressOf(position));
}

}
