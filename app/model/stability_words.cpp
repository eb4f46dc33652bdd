#include "app/model/stability_words.h"

#include "app/model/accuracy_words.h"
#include "app/model/numbers.h"
#include "app/model/sentences.h"
#include "app/model/step_words.h"
#include "sim/run/script/composed_interval.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

namespace app {

namespace {

using sim::Bound;
using sim::Stability;

struct Text
{
    Q_DECLARE_TR_FUNCTIONS(StabilityWords)
};

constexpr double mostCounted = 1e6; ///< growth a frame that is told as a number

constexpr double leastTelling = 0.01; ///< rad of the stiffest swing: shorter steps hardly change it

QString percent(double share)
{
    if (share >= 9.995)
        return Text::tr("%1 × the limit").arg(roughNumber(share));
    // A step just past the limit, or just below it, is not at it.
    const double hundredfold = 100.0 * share;
    if (share > 1.0 && hundredfold < 100.5)
        return Text::tr("%1\u2009% of the limit").arg(fixedNumber(std::max(100.1, hundredfold), 1));
    if (share < 1.0 && hundredfold >= 99.5)
        return Text::tr("%1\u2009% of the limit").arg(fixedNumber(std::min(99.9, hundredfold), 1));
    return Text::tr("%1\u2009% of the limit").arg(qRound(hundredfold));
}

QString frames(double h)
{
    const double whole = std::round(h);
    if (std::abs(h - 1.0) < 0.0005)
        return stepTitle(1.0);
    // A limit just below a whole number of frames would read as that.
    if (h < 9.95 && h != whole && roughNumber(h) == roughNumber(whole))
        return Text::tr("%1\u2009"
                        "frames")
            .arg(fixedNumber(h, 3));
    return Text::tr("%1\u2009"
                    "frames")
        .arg(roughNumber(h));
}

QString nameOf(const StabilityReading &reading, int point)
{
    const auto index = static_cast<std::size_t>(point);
    return bodyTitle(QString::fromStdString(reading.interval->scene.names[index]));
}

/// "The spring foot 3 – body", "The spring of foot 0", "legs, foot 0 – body".
QString culpritWords(const StabilityReading &reading)
{
    const sim::DominantEffect &dominant = reading.stability.dominant;
    if (!dominant.effect)
        return {};
    return pullTitle(*dominant.effect, nameOf(reading, dominant.point),
                     dominant.other < 0 ? QString() : nameOf(reading, dominant.other));
}

/// Which spring decides.
QString decides(const StabilityReading &reading)
{
    const QString who = culpritWords(reading);
    return who.isEmpty() ? QString() : Text::tr("%1 decides it.").arg(who.toHtmlEscaped());
}

/// What it looks like past the limit.
QString manner(const StabilityReading &reading)
{
    switch (reading.stability.growthKind) {
    case sim::GrowthKind::alternating:
        return Text::tr("Past the limit it swings to the other side at each step, farther each time.");
    case sim::GrowthKind::oscillating:
        return Text::tr("Past the limit it swings wider and wider.");
    case sim::GrowthKind::monotonic:
        break;
    }
    return Text::tr("Past the limit all of it drifts off, faster and faster: one end moves before the other "
                    "does, so their pulls do not cancel.");
}

QString ofSteps(const StabilityReading &reading)
{
    const Stability &found = reading.stability;
    if (std::isinf(found.limit))
        return Text::tr("<b>Damping holds every step.</b> However long, nothing swings up here.");
    if (found.limit == 0.0 && found.holds())
        return found.h * std::sqrt(found.stiffness) < leastTelling
                   ? Text::tr("<b>No step holds.</b> This one is so short that growth is too slow to tell.")
                   : Text::tr("<b>No shorter step holds.</b> Damping holds one as long as this.");
    if (found.limit == 0.0)
        return Text::tr("<b>No step holds.</b> With this method and so little damping, small disturbances "
                        "%1, and at any shorter step they still grow.")
            .arg(growthWords(found.growth));
    if (found.holds() && found.h > found.limit)
        return Text::tr("<b>%1, and held all the same.</b> From %2 on steps are too long, but damping holds "
                        "one as long as this.")
            .arg(percent(found.share()), frames(found.limit));
    if (!found.holds())
        return Text::tr("<b>%1.</b> Small disturbances %2. Steps up to %3 hold.")
            .arg(percent(found.share()), growthWords(found.growth), frames(found.limit));
    return Text::tr("<b>%1.</b> Steps up to %2 hold here.").arg(percent(found.share()), frames(found.limit));
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
        return Text::tr("grow more than a million times a frame");
    if (growth < 2.0)
        return Text::tr("grow by %1\u2009% a frame").arg(roughNumber(100.0 * (growth - 1.0)));
    return Text::tr("grow %1 times a frame").arg(roughNumber(growth));
}

QString gaugeWords(const StabilityReading &reading)
{
    const Stability &found = reading.stability;
    switch (found.bound) {
    case Bound::none:
        return Text::tr("no limit");
    case Bound::tolerance:
        return Text::tr("by its tolerance");
    case Bound::noSprings:
        return Text::tr("no springs act");
    case Bound::unknown:
        return Text::tr("not known here");
    case Bound::tooLarge:
        return Text::tr("too many points");
    case Bound::stiffness:
        break;
    }
    if (std::isinf(found.limit))
        return Text::tr("held by damping");
    if (found.limit == 0.0)
        return found.holds() ? Text::tr("just held") : Text::tr("no step holds");
    return percent(found.share());
}

QString stabilityVerdict(const StabilityReading &reading)
{
    const QString method = methodTitle(*reading.method).toHtmlEscaped();
    switch (reading.stability.bound) {
    case Bound::none:
        return Text::tr("<b>%1 has no such limit.</b> A long step stays bounded however stiff the springs; "
                        "it is only less exact. How exact it should be bounds the step.")
            .arg(method);
    case Bound::tolerance:
        return Text::tr("<b>%1 keeps its own steps short enough.</b> Its tolerance, %2, bounds them.")
            .arg(method, stepTitle(reading.step));
    case Bound::noSprings:
        return Text::tr("<b>No springs act here.</b> What acts has no stiffness, so no step is too long for "
                        "it.");
    case Bound::unknown:
        return Text::tr("<b>Not known here.</b> The pulls in this state are no finite numbers.");
    case Bound::tooLarge:
        return Text::tr(
                   "<b>Too many points.</b> With more than %1 of them it would take too long to find the "
                   "stiffest swing. Where nobody feels anybody, a few of them tell it for all.")
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
        Text::tr("Not part of this: %1. They act by jumps, once a step, and have no stiffness.")
            .arg(names.join(QStringLiteral(", ")));
    const bool isMeasured = reading.sticks.has_value();
    return hasSticks && !isMeasured
               ? Text::tr("%1 Sticks that bear weight err less by smaller steps than by more passes.")
                     .arg(said)
               : said;
}

QString stickVerdict(const StabilityReading &reading)
{
    if (!reading.sticks)
        return {};
    const sim::StickFit &now = reading.sticks->now;
    if (std::abs(now.error) <= sim::fitting)
        return Text::tr("<b>Sticks fit.</b> None was more than %1\u2009px wrong in the last %2 frames.")
            .arg(roughNumber(std::abs(now.error)))
            .arg(sim::fitFrames);
    const QString said =
        now.error > 0.0
            ? Text::tr("<b>Sticks are up to %1\u2009px too long:</b> %2 – %3 in the last %4 frames.")
            : Text::tr("<b>Sticks are up to %1\u2009px too short:</b> %2 – %3 in the last %4 frames.");
    const QString worst = said.arg(roughNumber(std::abs(now.error)), nameOf(reading, now.a).toHtmlEscaped(),
                                   nameOf(reading, now.b).toHtmlEscaped())
                              .arg(sim::fitFrames);
    if (!reading.sticks->remedies.empty())
        return worst;
    return Text::tr(
               "%1 Neither shorter steps nor more passes make that half as much: perhaps they cannot all "
               "have their lengths at once.")
        .arg(worst);
}

QString remedyLabel(const sim::Remedy &remedy)
{
    switch (remedy.kind) {
    case sim::Remedy::Kind::smallerStep:
        return Text::tr("Use a &step of %1").arg(stepTitle(remedy.step));
    case sim::Remedy::Kind::largerTolerance:
        return Text::tr("Use a &tolerance of %1").arg(stepTitle(remedy.step));
    case sim::Remedy::Kind::moreDamping:
        return Text::tr("&Damp more: %1 %2")
            .arg(QString::fromStdString(remedy.parameter), writtenNumber(remedy.value, 2));
    case sim::Remedy::Kind::moreIterations:
        return Text::tr("Use %n &passes", nullptr, static_cast<int>(remedy.value));
    case sim::Remedy::Kind::stableMethod:
    case sim::Remedy::Kind::unlimitedMethod:
        break;
    }
    return Text::tr("&Use %1").arg(methodTitle(*remedy.method));
}

QString remedyTitle(const sim::Remedy &remedy)
{
    return remedyLabel(remedy).remove('&');
}

QString remedyOutcome(const sim::Remedy &remedy)
{
    if (remedy.stickError)
        return Text::tr("then sticks are up to %1\u2009px wrong").arg(roughNumber(*remedy.stickError));
    if (remedy.kind != sim::Remedy::Kind::unlimitedMethod)
        return remedy.share > 0.0 ? Text::tr("then at %1").arg(percent(remedy.share))
                                  : Text::tr("then damping holds every step");
    return remedy.step.isAdaptive() ? Text::tr("keeps its own steps") : Text::tr("has no such limit");
}

}
