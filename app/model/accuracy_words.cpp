#include "app/model/accuracy_words.h"

#include "app/model/numbers.h"
#include "app/model/sentences.h"
#include "app/model/step_words.h"
#include "sim/methods/methods.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

namespace app {

namespace {

struct Text
{
    Q_DECLARE_TR_FUNCTIONS(AccuracyWords)
};

using sim::Outcome;

constexpr double worthNaming = 10.0; ///< times the reference's own error, above which a slope means something

QString bold(const QString &text)
{
    return QStringLiteral("<b>%1</b>").arg(text.toHtmlEscaped());
}

/// How the way in use compares with the cheapest one.
QString inUseWords(const sim::AccuracyRow *inUse)
{
    if (!inUse)
        return {};
    switch (inUse->outcome) {
    case Outcome::measured:
        if (inUse->nsPerFrame > 0.0)
            return Text::tr("Yours costs %1 and is %2 off.")
                .arg(duration(inUse->nsPerFrame), pixels(inUse->error));
        return Text::tr("Yours is %1 off.").arg(pixels(inUse->error));
    case Outcome::unstable:
        return Text::tr("Yours is unstable here: its numbers grow without bound.");
    case Outcome::doesNotFit:
        return Text::tr("Yours cannot compute this scene.");
    case Outcome::tooLong:
        return Text::tr("Yours would take too long to measure.");
    case Outcome::waiting:
        break;
    }
    return {};
}

/// Whether no time is known yet, and some will be.
bool timesCome(const sim::Accuracy &accuracy)
{
    bool come = accuracy.rows.empty();
    for (const sim::AccuracyRow &row : accuracy.rows) {
        if (row.nsPerFrame > 0.0)
            return false;
        come |= row.outcome == Outcome::waiting || row.outcome == Outcome::measured;
    }
    return come;
}

const sim::AccuracyRow *mostExact(const sim::Accuracy &accuracy)
{
    const sim::AccuracyRow *best = nullptr;
    for (const sim::AccuracyRow &row : accuracy.rows) {
        if (row.outcome == Outcome::measured && (!best || row.error < best->error))
            best = &row;
    }
    return best;
}

QString nothingWithin(const sim::Accuracy &accuracy, const QString &goal)
{
    if (timesCome(accuracy))
        return Text::tr("Errors first, then times: what it costs to be within %1 will stand here.").arg(goal);
    const sim::AccuracyRow *closest = mostExact(accuracy);
    if (!closest)
        return Text::tr("Nothing here comes within %1.").arg(goal);
    return Text::tr("Nothing here comes within %1. The closest is %2: %3 off.")
        .arg(goal, bold(wayWords(closest->setup)), pixels(closest->error));
}

QString horizonRemark(const sim::Accuracy &accuracy)
{
    using End = sim::ReferenceRun::End;
    const QString upTo =
        Text::tr("Errors count up to frame %1 of %2.").arg(accuracy.horizon).arg(accuracy.span);
    switch (accuracy.reference.end) {
    case End::span:
        return {};
    case End::diverged:
        if (accuracy.reference.kind == sim::ReferenceRun::Kind::selfRefinement)
            return upTo + ' ' +
                   Text::tr("After it, even the two finest steps part: here the smallest difference grows.");
        return upTo + ' ' +
               Text::tr("After it, two very exact solutions part: here the smallest difference grows until "
                        "nobody can say where the bodies really are.");
    case End::notFinite:
        return upTo + ' ' + Text::tr("After it, the exact motion itself grows without bound.");
    case End::tooLong:
        return upTo + ' ' + Text::tr("To know the exact motion any longer would take too long.");
    }
    return {};
}

QString limitRemark(const sim::Accuracy &accuracy)
{
    const sim::ReferenceRun &reference = accuracy.reference;
    if (reference.kind != sim::ReferenceRun::Kind::selfRefinement || reference.method.empty())
        return {};
    const QString jump =
        reference.discontinuity ? phrase(reference.discontinuity->title()) : Text::tr("one of its effects");
    return Text::tr("This scene has no exact motion to compare with: %1 acts once a step, however "
                    "short the step is. So each method is compared with its own finest steps.")
        .arg(jump);
}

QString fitRemark(const sim::Accuracy &accuracy)
{
    QStringList names;
    for (const sim::AccuracyRow &row : accuracy.rows) {
        const QString name = methodTitle(*row.setup.method);
        if (row.outcome == Outcome::doesNotFit && !names.contains(name))
            names << name;
    }
    if (names.isEmpty())
        return {};
    return Text::tr("Not able to compute this scene: %1.").arg(names.join(", "));
}

}

QString pixels(double px)
{
    return Text::tr("%1\u2009px").arg(roughNumber(px));
}

QString duration(double ns)
{
    return Text::tr("%1\u2009µs").arg(roughNumber(ns / 1e3));
}

QString methodTitle(const sim::Method &method)
{
    return phrase(method.title());
}

QString wayWords(const sim::MethodSetup &setup)
{
    const QString size = stepTitle(setup.step);
    return setup.step.isAdaptive() ? Text::tr("%1, tolerance %2").arg(methodTitle(*setup.method), size)
                                   : Text::tr("%1, step %2").arg(methodTitle(*setup.method), size);
}

QString rowWords(const sim::AccuracyRow &row)
{
    QStringList lines{wayWords(row.setup)};
    switch (row.outcome) {
    case Outcome::measured:
        lines << (row.error == 0.0 ? Text::tr("Not off at all, to the last digit")
                                   : Text::tr("At most %1 off").arg(pixels(row.error)));
        break;
    case Outcome::unstable:
        lines << Text::tr("Unstable: its numbers grow without bound");
        break;
    case Outcome::doesNotFit:
        lines << (row.why ? sentenceFor(*row.why) : Text::tr("Cannot compute this scene"));
        break;
    case Outcome::tooLong:
        lines << Text::tr("Left out: it would take too long");
        break;
    case Outcome::waiting:
        lines << Text::tr("Not tried yet");
        break;
    }
    if (row.nsPerFrame > 0.0)
        lines << Text::tr("%1 ± %2 a frame").arg(duration(row.nsPerFrame), duration(row.spread));
    if (row.evaluations > 0.0)
        lines << Text::tr("Computes all forces %1 times a frame").arg(roughNumber(row.evaluations));
    if (row.front)
        lines << Text::tr("On the front: nothing is as exact for less");
    return lines.join('\n');
}

QString verdictOn(const sim::Accuracy &accuracy, double target, const sim::AccuracyRow *inUse)
{
    if (accuracy.isExact())
        return Text::tr(
            "Nothing moves here unless you do something, so nothing can be off: drag a body or change a "
            "number, then measure again.");
    if (accuracy.previewed > 0)
        return (Text::tr(
                    "A first look, at frames 0 to %1: further, the exact motion is still being computed.")
                    .arg(accuracy.previewed) +
                ' ' + inUseWords(inUse).toHtmlEscaped())
            .trimmed()
            .replace(QChar(0x2009), QChar(QChar::Nbsp));
    const QString goal = bold(pixels(target));
    const sim::AccuracyRow *best = accuracy.cheapest(target);
    QString text;
    if (best && best == inUse)
        text =
            Text::tr("To be within %1, nothing is cheaper than what you use: %2, at %3 a frame and %4 off.")
                .arg(goal, bold(wayWords(inUse->setup)), bold(duration(inUse->nsPerFrame)),
                     pixels(inUse->error));
    else if (best)
        text = Text::tr("To be within %1, this scene costs %2 a frame: %3.")
                   .arg(goal, bold(duration(best->nsPerFrame)), bold(wayWords(best->setup)));
    else
        text = nothingWithin(accuracy, goal);
    if (!best || best != inUse)
        text += ' ' + inUseWords(inUse).toHtmlEscaped();
    // Rich text breaks lines at thin spaces: a number and its unit stay together.
    return text.trimmed().replace(QChar(0x2009), QChar(QChar::Nbsp));
}

QStringList remarksOn(const sim::Accuracy &accuracy)
{
    QStringList all{limitRemark(accuracy), horizonRemark(accuracy), fitRemark(accuracy)};
    if (accuracy.noisy())
        all.prepend(
            Text::tr("The machine is busy with other things: the times differ by %1\u2009% from run to "
                     "run. Errors are not touched by that.")
                .arg(qRound(100.0 * accuracy.noise)));
    all.removeAll(QString());
    return all;
}

QString unstableWords(const sim::Accuracy &accuracy)
{
    QStringList always;
    QStringList atBigSteps;
    for (const sim::MethodPtr &method : sim::allMethods()) {
        bool fails = false;
        bool holds = false;
        for (const sim::AccuracyRow &row : accuracy.rows) {
            if (row.setup.method->id() != method->id())
                continue;
            fails |= row.outcome == Outcome::unstable;
            holds |= row.outcome == Outcome::measured;
        }
        if (fails)
            (holds ? atBigSteps : always) << methodTitle(*method);
    }
    QStringList parts;
    if (!always.isEmpty())
        parts << Text::tr("Unstable: %1").arg(always.join(", "));
    if (!atBigSteps.isEmpty())
        parts << Text::tr("unstable at big steps: %1").arg(atBigSteps.join(", "));
    QString text = parts.join(QStringLiteral("; "));
    if (!text.isEmpty())
        text[0] = text[0].toUpper();
    return text;
}

std::vector<Slope> slopesOf(const sim::Accuracy &accuracy, const sim::Method &method)
{
    std::vector<Slope> slopes;
    const sim::AccuracyRow *before = nullptr;
    for (const sim::AccuracyRow &row : accuracy.rows) {
        if (row.setup.method->id() != method.id() || row.setup.step.isAdaptive())
            continue;
        const bool counts = row.outcome == Outcome::measured && row.error > 0.0 &&
                            row.error > worthNaming * accuracy.reference.disagreement;
        if (counts && before && row.setup.step.h < before->setup.step.h)
            slopes.push_back(
                {before, &row,
                 std::log(before->error / row.error) / std::log(before->setup.step.h / row.setup.step.h)});
        before = counts ? &row : nullptr;
    }
    return slopes;
}

}
