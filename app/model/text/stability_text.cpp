#include "app/model/text/stability_text.h"

#include "app/model/run/run_program.h"
#include "app/model/text/accuracy_text.h"
#include "app/model/text/numbers.h"
#include "app/model/text/sentences.h"
#include "app/model/text/step_text.h"
#include "sim/run/script/composed_interval.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

namespace app {

namespace {

using sim::Bound;
using sim::Stability;

struct StabilityText
{
    Q_DECLARE_TR_FUNCTIONS(StabilityText)
};

constexpr double mostCounted = 1e6; ///< growth per frame; a larger one is not given as a number

constexpr double leastTelling = 0.01; ///< rad of the stiffest swing per step; shorter steps hardly change it

QString percent(double share)
{
    if (share >= 9.995)
        return StabilityText::tr("%1 × the limit").arg(roughNumber(share));
    // Rounding must not show a step just above or below the limit as 100 %.
    const double hundredfold = 100.0 * share;
    if (share > 1.0 && hundredfold < 100.5)
        return StabilityText::tr("%1\u2009% of the limit").arg(fixedNumber(std::max(100.1, hundredfold), 1));
    if (share < 1.0 && hundredfold >= 99.5)
        return StabilityText::tr("%1\u2009% of the limit").arg(fixedNumber(std::min(99.9, hundredfold), 1));
    return StabilityText::tr("%1\u2009% of the limit").arg(qRound(hundredfold));
}

QString frames(double h)
{
    const double whole = std::round(h);
    if (std::abs(h - 1.0) < 0.0005)
        return stepTitle(1.0);
    // Rounding must not show a limit close to a whole number of frames as that number.
    if (h < 9.95 && h != whole && roughNumber(h) == roughNumber(whole))
        return StabilityText::tr("%1\u2009"
                                 "frames")
            .arg(fixedNumber(h, 3));
    return StabilityText::tr("%1\u2009"
                             "frames")
        .arg(roughNumber(h));
}

QString nameOf(const StabilityReading &reading, int point)
{
    const auto index = static_cast<std::size_t>(point);
    return bodyTitle(QString::fromStdString(reading.interval->scene.names[index]));
}

/// Returns which effect determines the limit: "The spring foot 3 – body", "The spring of foot 0", "legs, foot 0 – body".
QString decides(const StabilityReading &reading)
{
    const sim::DominantEffect &dominant = reading.stability.dominant;
    if (!dominant.effect)
        return {};
    const QString title = pullTitle(*dominant.effect, nameOf(reading, dominant.point),
                                    dominant.other < 0 ? QString() : nameOf(reading, dominant.other));
    return StabilityText::tr("%1 sets the limit.").arg(title.toHtmlEscaped());
}

/// Returns how the motion looks past the limit.
QString manner(const StabilityReading &reading)
{
    switch (reading.stability.growthKind) {
    case sim::GrowthKind::alternating:
        return StabilityText::tr(
            "Past the limit it swings to the other side at each step, farther each time.");
    case sim::GrowthKind::oscillating:
        return StabilityText::tr("Past the limit it swings wider and wider.");
    case sim::GrowthKind::monotonic:
        break;
    }
    return StabilityText::tr(
        "Past the limit all of it drifts off, faster and faster: one end moves before the other "
        "does, so their pulls do not cancel.");
}

QString ofSteps(const StabilityReading &reading)
{
    const Stability &found = reading.stability;
    if (std::isinf(found.limit))
        return StabilityText::tr(
            "<b>Every step is stable, because of the damping.</b> However long it is, no swing grows here.");
    if (found.limit == 0.0 && found.holds())
        return found.h * std::sqrt(found.stiffness) < leastTelling
                   ? StabilityText::tr("<b>No step is stable.</b> This one is so short that the growth is "
                                       "too slow to notice.")
                   : StabilityText::tr(
                         "<b>No shorter step is stable.</b> This one is, because of the damping.");
    if (found.limit == 0.0)
        return StabilityText::tr("<b>No step is stable.</b> With this method and so little damping, small "
                                 "disturbances %1. They also grow with any shorter step.")
            .arg(growthWords(found.growth));
    if (found.holds() && found.h > found.limit)
        return StabilityText::tr("<b>%1, but still stable.</b> Steps longer than %2 are unstable, but this "
                                 "one is so long that the damping makes it stable again.")
            .arg(percent(found.share()), frames(found.limit));
    if (!found.holds())
        return StabilityText::tr("<b>%1.</b> Small disturbances %2. Steps up to %3 are stable.")
            .arg(percent(found.share()), growthWords(found.growth), frames(found.limit));
    return StabilityText::tr("<b>%1.</b> Steps up to %2 are stable here.")
        .arg(percent(found.share()), frames(found.limit));
}

}

Nearness nearnessOf(const Stability &stability)
{
    if (stability.bound != Bound::stiffness)
        return Nearness::none;
    if (!stability.holds())
        return Nearness::past;
    return stability.share() > sim::safeShare ? Nearness::near : Nearness::far;
}

QString growthWords(double growth)
{
    if (!(growth < mostCounted))
        return StabilityText::tr("grow more than a million times a frame");
    if (growth < 2.0)
        return StabilityText::tr("grow by %1\u2009% a frame").arg(roughNumber(100.0 * (growth - 1.0)));
    return StabilityText::tr("grow %1 times a frame").arg(roughNumber(growth));
}

QString gaugeWords(const StabilityReading &reading)
{
    const Stability &found = reading.stability;
    switch (found.bound) {
    case Bound::none:
        return StabilityText::tr("no limit");
    case Bound::tolerance:
        return StabilityText::tr("by its tolerance");
    case Bound::noSprings:
        return StabilityText::tr("no springs act");
    case Bound::unknown:
    case Bound::velocity:
        return StabilityText::tr("unknown here");
    case Bound::tooLarge:
        return StabilityText::tr("too many points");
    case Bound::stiffness:
        break;
    }
    if (std::isinf(found.limit))
        return StabilityText::tr("stable by damping");
    if (found.limit == 0.0)
        return found.holds() ? StabilityText::tr("just stable") : StabilityText::tr("no stable step");
    return percent(found.share());
}

QString stabilityVerdict(const StabilityReading &reading)
{
    const QString method = methodTitle(*reading.method).toHtmlEscaped();
    switch (reading.stability.bound) {
    case Bound::none:
        return StabilityText::tr(
                   "<b>%1 has no such limit.</b> Long steps are stable, however stiff the springs are; they "
                   "are only less accurate. Choose the step for the accuracy that you want.")
            .arg(method);
    case Bound::tolerance:
        return StabilityText::tr(
                   "<b>%1 keeps its own steps short enough.</b> Its tolerance, %2, limits them.")
            .arg(method, stepTitle(reading.step));
    case Bound::noSprings:
        return StabilityText::tr("<b>No springs act here.</b> The other effects have no stiffness, so no "
                                 "step is too long for them.");
    case Bound::unknown:
        if (programOf(reading.method))
            return StabilityText::tr(
                "<b>Unknown for your code.</b> The limit follows from the springs of the scene, "
                "and your code may compute anything else.");
        return StabilityText::tr("<b>Unknown here.</b> The pulls in this state are not finite numbers.");
    case Bound::velocity:
        return StabilityText::tr(
            "<b>Unknown for this rule.</b> Its force depends on velocities, and the limit is computed from "
            "positions only. Try a shorter step: if the motion stays the same, the step is short enough.");
    case Bound::tooLarge:
        return StabilityText::
            tr("<b>Too many points.</b> With more than %1 of them, finding the limit would take too long. If "
               "the creatures do not touch each other, look at only a few of them: their limit is the same.")
                .arg(sim::maxAnalysedPoints);
    case Bound::stiffness:
        break;
    }
    QStringList sentences = {ofSteps(reading), decides(reading)};
    if (std::isfinite(reading.stability.limit))
        sentences << manner(reading);
    sentences.removeAll(QString());
    return sentences.join(' ');
}

QString leftOutWords(const StabilityReading &reading)
{
    QStringList names;
    bool hasSticks = false;
    for (const sim::EffectPtr &effect : reading.stability.ignored) {
        hasSticks = hasSticks || effect->kind() == sim::EffectKind::stick;
        const QString name = phrase(effect->title());
        if (!names.contains(name))
            names << name;
    }
    if (names.isEmpty())
        return {};
    const QString said =
        StabilityText::tr("Not included: %1. They act in jumps, once per step, and have no stiffness.")
            .arg(names.join(QStringLiteral(", ")));
    const bool isMeasured = reading.sticks.has_value();
    return hasSticks && !isMeasured
               ? StabilityText::tr(
                     "%1 For sticks that carry weight, smaller steps help more than more passes.")
                     .arg(said)
               : said;
}

QString stickVerdict(const StabilityReading &reading)
{
    if (!reading.sticks)
        return {};
    const sim::StickFit &now = reading.sticks->now;
    if (std::abs(now.error) <= sim::fitting)
        return StabilityText::tr("<b>Sticks keep their lengths.</b> None was wrong by more than %1\u2009px "
                                 "in the last %2 frames.")
            .arg(roughNumber(std::abs(now.error)))
            .arg(sim::fitFrames);
    const QString said =
        now.error > 0.0
            ? StabilityText::tr("<b>Sticks are up to %1\u2009px too long:</b> %2 – %3 in the last %4 frames.")
            : StabilityText::tr(
                  "<b>Sticks are up to %1\u2009px too short:</b> %2 – %3 in the last %4 frames.");
    const QString worst = said.arg(roughNumber(std::abs(now.error)), nameOf(reading, now.a).toHtmlEscaped(),
                                   nameOf(reading, now.b).toHtmlEscaped())
                              .arg(sim::fitFrames);
    if (!reading.sticks->remedies.empty())
        return worst;
    return StabilityText::tr("%1 Neither shorter steps nor more passes halve this error. Perhaps the lengths "
                             "contradict each other.")
        .arg(worst);
}

QString remedyLabel(const sim::Remedy &remedy)
{
    switch (remedy.kind) {
    case sim::Remedy::Kind::smallerStep:
        return StabilityText::tr("Use a &step of %1").arg(stepTitle(remedy.step));
    case sim::Remedy::Kind::largerTolerance:
        return StabilityText::tr("Use a &tolerance of %1").arg(stepTitle(remedy.step));
    case sim::Remedy::Kind::moreDamping:
        return StabilityText::tr("&Damp more: %1 %2")
            .arg(QString::fromStdString(remedy.parameter), writtenNumber(remedy.value, 2));
    case sim::Remedy::Kind::moreIterations:
        return StabilityText::tr("Use %n &passes", nullptr, static_cast<int>(remedy.value));
    case sim::Remedy::Kind::stableMethod:
    case sim::Remedy::Kind::unlimitedMethod:
        break;
    }
    return StabilityText::tr("&Use %1").arg(methodTitle(*remedy.method));
}

QString remedyTitle(const sim::Remedy &remedy)
{
    return remedyLabel(remedy).remove('&');
}

QString remedyOutcome(const sim::Remedy &remedy)
{
    if (remedy.stickError)
        return StabilityText::tr("sticks are then wrong by up to %1\u2009px")
            .arg(roughNumber(*remedy.stickError));
    if (remedy.kind != sim::Remedy::Kind::unlimitedMethod)
        return remedy.share > 0.0 ? StabilityText::tr("then at %1").arg(percent(remedy.share))
                                  : StabilityText::tr("every step is then stable, because of the damping");
    return remedy.step.isAdaptive() ? StabilityText::tr("chooses its own steps")
                                    : StabilityText::tr("has no such limit");
}

}
