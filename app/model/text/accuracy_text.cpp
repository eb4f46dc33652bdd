#include "app/model/text/accuracy_text.h"

#include "app/model/text/numbers.h"
#include "app/model/text/phrases.h"
#include "app/model/text/sentences.h"
#include "app/model/text/step_text.h"
#include "sim/methods/methods.h"

#include <QCoreApplication>

#include <cmath>

namespace app {

namespace {

struct AccuracyText
{
    Q_DECLARE_TR_FUNCTIONS(AccuracyText)
};

using sim::Outcome;

constexpr double worthNaming = 10.0; ///< times the reference's own error; below, a slope means nothing

QString bold(const QString &text)
{
    return QStringLiteral("<b>%1</b>").arg(text.toHtmlEscaped());
}

/// Returns how the setup in use compares with the cheapest one.
QString inUseWords(const sim::AccuracyRow *inUse)
{
    if (!inUse)
        return {};
    switch (inUse->outcome) {
    case Outcome::measured:
        if (inUse->nsPerFrame > 0.0)
            return AccuracyText::tr("Your setup costs %1 and has an error of %2.")
                .arg(duration(inUse->nsPerFrame), pixels(inUse->error));
        return AccuracyText::tr("Your setup has an error of %1.").arg(pixels(inUse->error));
    case Outcome::unstable:
        return AccuracyText::tr("Your setup is unstable here: its numbers grow without bound.");
    case Outcome::doesNotFit:
        return AccuracyText::tr("Your method cannot compute this scene.");
    case Outcome::tooLong:
        return AccuracyText::tr("Your setup would take too long to measure.");
    case Outcome::waiting:
        break;
    }
    return {};
}

/// Returns whether no time is known yet, but some will be measured.
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
        return AccuracyText::tr("Errors are measured first, then times. The cost of staying within an error "
                                "of %1 will appear here.")
            .arg(goal);
    const sim::AccuracyRow *closest = mostExact(accuracy);
    if (!closest)
        return AccuracyText::tr("No method stays within an error of %1.").arg(goal);
    return AccuracyText::tr("No method stays within an error of %1. The closest is %2, with an error of %3.")
        .arg(goal, bold(setupTitle(closest->setup)), pixels(closest->error));
}

QString horizonRemark(const sim::Accuracy &accuracy)
{
    using End = sim::ReferenceRun::End;
    const QString upTo = AccuracyText::tr("Errors are measured up to frame %1 of %2.")
                             .arg(accuracy.horizon)
                             .arg(accuracy.span);
    switch (accuracy.reference.end) {
    case End::span:
        return {};
    case End::diverged:
        if (accuracy.reference.kind == sim::ReferenceRun::Kind::selfRefinement)
            return upTo + ' ' +
                   AccuracyText::tr("After that, even the two finest steps disagree, because the smallest "
                                    "difference grows here.");
        return upTo + ' ' +
               AccuracyText::tr("After that, even two very accurate solutions disagree. The smallest "
                                "difference grows here until the true positions cannot be known.");
    case End::notFinite:
        return upTo + ' ' + AccuracyText::tr("After that, the exact motion itself grows without bound.");
    case End::tooLong:
        return upTo + ' ' + AccuracyText::tr("Computing the exact motion beyond that would take too long.");
    }
    return {};
}

QString limitRemark(const sim::Accuracy &accuracy)
{
    const sim::ReferenceRun &reference = accuracy.reference;
    if (reference.kind != sim::ReferenceRun::Kind::selfRefinement || reference.method.empty())
        return {};
    const QString jump = reference.discontinuity ? phrase(reference.discontinuity->title())
                                                 : AccuracyText::tr("one of its effects");
    return AccuracyText::tr(
               "This scene has no exact motion to compare with, because %1 acts once per step, however short "
               "the step is. Each method is therefore compared with its own finest steps.")
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
    return AccuracyText::tr("Cannot compute this scene: %1.").arg(names.join(", "));
}

}

QString pixels(double px)
{
    return pixels(roughNumber(px));
}

QString duration(double ns)
{
    return AccuracyText::tr("%1\u2009µs").arg(roughNumber(ns / 1e3));
}

QString methodTitle(const sim::Method &method)
{
    return phrase(method.title());
}

QString setupTitle(const sim::MethodSetup &setup)
{
    const QString size = stepTitle(setup.step);
    return setup.step.isAdaptive()
               ? AccuracyText::tr("%1, tolerance %2").arg(methodTitle(*setup.method), size)
               : AccuracyText::tr("%1, step %2").arg(methodTitle(*setup.method), size);
}

QString rowWords(const sim::AccuracyRow &row)
{
    QStringList lines{setupTitle(row.setup)};
    switch (row.outcome) {
    case Outcome::measured:
        lines << (row.error == 0.0 ? AccuracyText::tr("No error, to the last digit")
                                   : AccuracyText::tr("Error at most %1").arg(pixels(row.error)));
        break;
    case Outcome::unstable:
        lines << AccuracyText::tr("Unstable: its numbers grow without bound");
        break;
    case Outcome::doesNotFit:
        lines << (row.why ? sentenceFor(*row.why) : AccuracyText::tr("Cannot compute this scene"));
        break;
    case Outcome::tooLong:
        lines << AccuracyText::tr("Skipped: it would take too long");
        break;
    case Outcome::waiting:
        lines << AccuracyText::tr("Not measured yet");
        break;
    }
    if (row.nsPerFrame > 0.0)
        lines << AccuracyText::tr("%1 ± %2 a frame").arg(duration(row.nsPerFrame), duration(row.spread));
    if (row.evaluations > 0.0)
        lines << AccuracyText::tr("Computes all forces %1 times a frame").arg(roughNumber(row.evaluations));
    if (row.front)
        lines << AccuracyText::tr("On the front: nothing cheaper is as accurate");
    return lines.join('\n');
}

QString verdictOn(const sim::Accuracy &accuracy, double target, const sim::AccuracyRow *inUse)
{
    if (accuracy.isExact())
        return AccuracyText::tr("Nothing moves here unless you do something, so there is no error to "
                                "measure. Drag a body or change a number, then measure again.");
    if (accuracy.previewed > 0)
        return (AccuracyText::tr(
                    "First results, for frames 0 to %1. The exact motion after that is still being computed.")
                    .arg(accuracy.previewed) +
                ' ' + inUseWords(inUse).toHtmlEscaped())
            .trimmed()
            .replace(QChar(0x2009), QChar(QChar::Nbsp));
    const QString goal = bold(pixels(target));
    const sim::AccuracyRow *best = accuracy.cheapest(target);
    QString text;
    if (best && best == inUse)
        text = AccuracyText::tr("Nothing cheaper than your setup stays within an error of %1: %2 costs %3 a "
                                "frame, with an error of %4.")
                   .arg(goal, bold(setupTitle(inUse->setup)), bold(duration(inUse->nsPerFrame)),
                        pixels(inUse->error));
    else if (best)
        text = AccuracyText::tr("The cheapest way to stay within an error of %1 costs %2 a frame: %3.")
                   .arg(goal, bold(duration(best->nsPerFrame)), bold(setupTitle(best->setup)));
    else
        text = nothingWithin(accuracy, goal);
    if (!best || best != inUse)
        text += ' ' + inUseWords(inUse).toHtmlEscaped();
    // Rich text breaks lines at thin spaces, which would separate a number from its unit.
    return text.trimmed().replace(QChar(0x2009), QChar(QChar::Nbsp));
}

QStringList remarksOn(const sim::Accuracy &accuracy)
{
    QStringList all{limitRemark(accuracy), horizonRemark(accuracy), fitRemark(accuracy)};
    if (accuracy.noisy())
        all.prepend(AccuracyText::tr("The machine is busy with other things: the times differ by %1\u2009% "
                                     "from run to run. The errors are not affected.")
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
        parts << AccuracyText::tr("Unstable: %1").arg(always.join(", "));
    if (!atBigSteps.isEmpty())
        parts << AccuracyText::tr("unstable at large steps: %1").arg(atBigSteps.join(", "));
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
