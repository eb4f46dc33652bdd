#include "app/ui/scene/drawing/caption.h"

#include "app/model/text/sentences.h"
#include "sim/run/script/composed_interval.h"

#include <QCoreApplication>
#include <QStringList>

namespace app {

namespace {

struct CaptionText
{
    Q_DECLARE_TR_FUNCTIONS(CaptionText)
};

/// A summary of the phases done so far in a step.
struct Account
{
    QStringList moved;            ///< titles of the groups that have moved
    QStringList still;            ///< titles of the groups that have yet to move
    bool pulled = false;          ///< a force has acted since the last move
    bool turnedIntoSpeed = false; ///< something other than a force has changed velocities since the last move
    bool anyMove = false;
    QString placed; ///< the title of the last phase that may have moved points outside the move phases
};

/// Returns whether an effect of `phase` may move points by itself.
bool placesPoints(const sim::Phase &phase)
{
    const sim::Effect *effect = phase.effect.get();
    return dynamic_cast<const sim::Driver *>(effect) || dynamic_cast<const sim::Constraint *>(effect) ||
           dynamic_cast<const sim::Contact *>(effect);
}

/// Returns whether any point has moved or turned since the start of the present frame.
bool anyIsElsewhere(const sim::Timeline &timeline)
{
    const sim::State begun = timeline.track().stateAt(timeline.cursor().frame);
    const sim::State &now = timeline.state();
    return begun.pointCount() != now.pointCount() || !(begun.position == now.position).all() ||
           (begun.angle.rows() == now.angle.rows() && !(begun.angle == now.angle).all());
}

/// Returns whether a velocity has changed since the start of the present frame.
bool anyHasNewVelocity(const sim::Timeline &timeline)
{
    const sim::State begun = timeline.track().stateAt(timeline.cursor().frame);
    const sim::State &now = timeline.state();
    return begun.pointCount() != now.pointCount() || !(begun.velocity == now.velocity).all();
}

QString afterPlacing(const QString &phase, bool hasNewVelocity)
{
    return hasNewVelocity
               ? CaptionText::tr("after %1, points have moved directly, and velocities have changed.")
                     .arg(phase)
               : CaptionText::tr("after %1, points have moved directly, without a velocity.").arg(phase);
}

Account accountOf(const sim::ComposedInterval &interval, int done)
{
    Account account;
    for (int i = 0; i < interval.pipeline.phasesPerStep(); ++i) {
        const sim::Phase &phase = interval.pipeline.phaseAt(i);
        if (phase.consumesAcceleration) {
            const auto group = static_cast<std::size_t>(phase.group);
            const QString title = phase.group < 0 ? QString() : phrase(interval.scene.groups[group].title);
            (i < done ? account.moved : account.still) << title;
        }
        if (i >= done)
            continue;
        account.anyMove |= phase.consumesAcceleration;
        if (placesPoints(phase))
            account.placed = phrase(phase.title);
        if (phase.consumesAcceleration)
            account.pulled = account.turnedIntoSpeed = false;
        else if (dynamic_cast<const sim::Force *>(phase.effect.get()))
            account.pulled = true;
        else
            account.turnedIntoSpeed = true;
    }
    return account;
}

/// Returns the caption before anything has moved. `nothing`: the sentence that nothing has moved, in the
/// frame or in its present step.
QString beforeAnyMove(const Account &account, bool gathers, const QString &nothing)
{
    if (account.pulled && !gathers)
        return CaptionText::tr("pulls change the velocities directly, %1.").arg(nothing);
    if (account.pulled && !account.turnedIntoSpeed)
        return CaptionText::tr("accelerations are being added up, %1.").arg(nothing);
    return CaptionText::tr("velocities have changed, %1.").arg(nothing);
}

QString afterSomeMove(const Account &account, const sim::Pipeline &pipeline, int done)
{
    if (!account.still.isEmpty())
        return CaptionText::tr("already moved: %1; not yet moved: %2.")
            .arg(account.moved.join(", "), account.still.join(", "));
    if (done < pipeline.phasesPerStep())
        return CaptionText::tr("everything has moved; next: %1.").arg(phrase(pipeline.phaseAt(done).title));
    return CaptionText::tr("everything has moved.");
}

}

QString frameCaption(const sim::Timeline &timeline)
{
    const sim::Cursor at = timeline.cursor();
    if (at.phase <= 0)
        return {};
    const sim::ComposedInterval &interval = timeline.track().interval();
    const sim::Pipeline &pipeline = interval.pipeline;
    const int done = at.phase % pipeline.phasesPerStep();
    const int steps = at.phase / pipeline.phasesPerStep();
    const int all = pipeline.step.stepsPerOutput;
    if (done == 0)
        return CaptionText::tr("Inside frame %1: %2 of %3 steps are done.").arg(at.frame).arg(steps).arg(all);
    const Account account = accountOf(interval, done);
    const bool gathers = timeline.state().acceleration.rows() > 0;
    const QString nothing =
        steps > 0 ? CaptionText::tr("nothing has moved in it yet") : CaptionText::tr("nothing has moved yet");
    const bool isPlaced = !account.anyMove && !account.placed.isEmpty() && anyIsElsewhere(timeline);
    const QString what = isPlaced          ? afterPlacing(account.placed, anyHasNewVelocity(timeline))
                         : account.anyMove ? afterSomeMove(account, pipeline, done)
                                           : beforeAnyMove(account, gathers, nothing);
    if (all > 1)
        return CaptionText::tr("Inside frame %1, step %2 of %3: %4")
            .arg(at.frame)
            .arg(steps + 1)
            .arg(all)
            .arg(what);
    return CaptionText::tr("Inside frame %1: %2").arg(at.frame).arg(what);
}

}
