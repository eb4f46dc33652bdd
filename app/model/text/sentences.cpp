#include "app/model/text/sentences.h"

#include "sim/scene/scene.h"

#include <QCoreApplication>
#include <QLocale>
#include <QRegularExpression>

#include <algorithm>
#include <array>

namespace app {

namespace {

/// A sentence for the errors with an id. Its %1, %2, ... are the values of the error with these names.
struct ErrorSentence
{
    const char *id;
    const char *text;
    std::array<const char *, 5> values = {};
};

struct SentencesText
{
    Q_DECLARE_TR_FUNCTIONS(SentencesText)

public:
    static constexpr ErrorSentence errors[] = {
        {"step-size",
         QT_TR_NOOP("The step %1 is not allowed. It can be a whole number of frames, or 1 divided by a whole "
                    "number, from 0.000001 to 100 frames."),
         {"h"}},
        {"tolerance",
         QT_TR_NOOP("The tolerance %1 is not allowed. It can be from 1e-13 to 100 px."),
         {"tolerance"}},
        {"needs-tolerance",
         QT_TR_NOOP("The method %1 chooses its own steps. Choose a tolerance in px instead of a step."),
         {"method"}},
        {"listing-needs-frame-steps",
         QT_TR_NOOP("Your code computes whole frames, so its step cannot be %1. Choose a step of 1 frame."),
         {"h"}},
        {"needs-step",
         QT_TR_NOOP("The method %1 has fixed steps. Choose a step in frames instead of a tolerance."),
         {"method"}},
        {"no-limit",
         QT_TR_NOOP(
             "%1 acts once per step, so smaller steps give a different motion from the first frame on."),
         {"effect"}},
        {"short-horizon", QT_TR_NOOP("There is nothing to compare with after frame %1."), {"frames"}},
        {"method-does-not-fit",
         QT_TR_NOOP("The method %1 cannot compute %2: choose another method, or switch that effect off."),
         {"method", "effect"}},
        {"needs-inertia",
         QT_TR_NOOP("The method %1 cannot compute this scene, because parts of it have no velocity of their "
                    "own. Choose another method."),
         {"method"}},
        {"nothing-moves", QT_TR_NOOP("Nothing in this scene can move. Leave at least one body free.")},
        {"too-many-points",
         QT_TR_NOOP("This scene has %1 points, and at most %2 can be measured with every method. Measure a "
                    "smaller scene of the same kind: its results are valid for this one, too."),
         {"points", "most"}},
        {"tree-too-big",
         QT_TR_NOOP("This tree would have more than %1 branches: make its slope smaller than %2, or its "
                    "smallest branch larger than %3."),
         {"most", "slope", "min_scale"}},
        {"stick-without-end",
         QT_TR_NOOP(
             "Stick %1 ends at p%2, but there is no such point. There are %3 points, and the first is p0."),
         {"stick", "end", "points"}},
        {"spring-without-end",
         QT_TR_NOOP(
             "Spring %1 ends at p%2, but there is no such point. There are %3 points, and the first is p0."),
         {"spring", "end", "points"}},
        {"input-not-finite",
         QT_TR_NOOP("The event %1 before frame %2 has a value that is infinite or not a number. Give it a "
                    "finite number."),
         {"event", "frame"}},
        {"start-not-finite",
         QT_TR_NOOP("The start of %1 has a value that is infinite or not a number. Give it a finite number."),
         {"body"}},
        // Why a method does not claim a hard case
        {"claim-one-by-one",
         QT_TR_NOOP("It moves one body after the other, so the pulls between them do not cancel.")},
        {"claim-no-room",
         QT_TR_NOOP(
             "It looks for the moment when a body leaves the walls, but here a body never leaves them.")},
        {"claim-too-many-steps",
         QT_TR_NOOP("It would need about %1 steps in a frame, but stops after %2."),
         {"steps", "most"}},
        {"claim-adds-up",
         QT_TR_NOOP("Without damping, the errors of its steps add up: to %1 px in %2 frames at worst."),
         {"off", "frames"}},
        {"claim-stirs",
         QT_TR_NOOP("Because its steps may have errors of %1 px, it never comes fully to rest: it moves by "
                    "up to %2 px a frame."),
         {"tolerance", "stirred"}},
        {"claim-grows",
         QT_TR_NOOP("With a step of %1, its stiffest spring (stiffness %2) would swing from %3 px to %4 px, "
                    "and farther."),
         {"h", "k", "apart", "left"}},
        {"claim-longer-step",
         QT_TR_NOOP(
             "Its sticks are only tested with steps up to %1. With a step of %2, their errors are larger."),
         {"most", "h"}},
        {"claim-rings",
         QT_TR_NOOP("With a step of %1, its stiffest spring (stiffness %2) would not stop swinging: of %3 "
                    "px, %4 px would be left after %5 frames."),
         {"h", "k", "apart", "left", "frames"}},
        // What failed in a hard case
        {"hard-not-finite",
         QT_TR_NOOP(
             "After frame %1, the position of %2 is no longer a finite number: it overflowed in \"%3\"."),
         {"frame", "body", "phase"}},
        {"hard-too-many-steps",
         QT_TR_NOOP("After frame %1, the method needs more steps for one frame than allowed."),
         {"frame"}},
        {"hard-too-far", QT_TR_NOOP("At frame %1, %2 is more than %3 px away."), {"frame", "body", "reach"}},
        {"hard-drifts",
         QT_TR_NOOP("At frame %1, the centre of mass has moved %2 px, although nothing pushed it."),
         {"frame", "drift"}},
        {"hard-stick",
         QT_TR_NOOP("At frame %1, the length of the stick between %2 and %3 is wrong by %4 px, more than the "
                    "expected %5 px."),
         {"frame", "a", "b", "error", "most"}},
        {"hard-moves", QT_TR_NOOP("At the end, %1 still moves %2 px a frame."), {"body", "speed"}},
        {"hard-elsewhere", QT_TR_NOOP("At the end, %1 is %2 px from where it should rest."), {"body", "off"}},
        {"hard-length",
         QT_TR_NOOP("At the end, the distance between %1 and %2 is wrong by %3 px."),
         {"a", "b", "off"}},
        {"hard-not-the-same", QT_TR_NOOP("A second run differs from the first one at frame %1."), {"frame"}},
        {"hard-not-refused", QT_TR_NOOP("This input should be rejected, but it was accepted.")},
        {"hard-does-not-end",
         QT_TR_NOOP("The run should stop and name the number that is not finite, but it does not.")},
    };
};

/// Returns a value of an error in the learner's language.
QString value(const sim::Error &error, const std::string &name)
{
    const auto found = error.values().find(name);
    if (found == error.values().end())
        return {};
    if (name == "phase")
        return phrase(found->second);
    const QString text = QString::fromStdString(found->second);
    return name == "body" || name == "a" || name == "b" ? bodyTitle(text) : text;
}

}

QString phrase(const std::string &text)
{
    return QCoreApplication::translate("sim", text.c_str());
}

QString capitalised(QString text)
{
    if (!text.isEmpty())
        text[0] = text[0].toUpper();
    return text;
}

QString withinSentence(const QString &name)
{
    return QLocale().language() == QLocale::German ? name : name.toLower();
}

QString bodyTitle(const QString &name)
{
    QStringList parts;
    static const QRegularExpression joints(QStringLiteral("[._]"));
    for (const QString &part : name.split(joints)) {
        qsizetype digits = 0;
        while (digits < part.size() && part[part.size() - 1 - digits].isDigit())
            ++digits;
        const QString word = phrase(part.left(part.size() - digits).toStdString());
        // A letter and its number stay together, as in formulas: "p3".
        const QString gap = digits == 0 || word.size() <= 1 ? QString() : QStringLiteral(" ");
        parts << word + gap + part.right(digits);
    }
    return parts.join(QStringLiteral(", "));
}

QString sentenceFor(const sim::Error &error)
{
    const auto *found = std::find_if(std::begin(SentencesText::errors), std::end(SentencesText::errors),
                                     [&](const ErrorSentence &one) { return one.id == error.id(); });
    if (found == std::end(SentencesText::errors))
        return SentencesText::tr("These settings do not fit together: %1.")
            .arg(QString::fromUtf8(error.what()));
    QString sentence = SentencesText::tr(found->text);
    for (const char *name : found->values) {
        if (name)
            sentence = sentence.arg(value(error, name));
    }
    return sentence;
}

QString pullTitle(const sim::Effect &effect, const QString &body, const QString &other)
{
    const bool isSpring = effect.kind() == sim::EffectKind::spring;
    if (other.isEmpty())
        return isSpring ? SentencesText::tr("The spring of %1").arg(body)
                        : SentencesText::tr("The force on %1 (%2)").arg(body, phrase(effect.title()));
    const QString pair = SentencesText::tr("%1 – %2").arg(body, other);
    return isSpring ? SentencesText::tr("The spring %1").arg(pair)
                    : SentencesText::tr("The force on %1 (%2)").arg(pair, phrase(effect.title()));
}

QString sentenceFor(const sim::Stop &stop)
{
    const QString name = bodyTitle(QString::fromStdString(stop.body));
    const bool isPulled = dynamic_cast<const sim::Force *>(stop.effect.get()) && !stop.body.empty();
    const QString pull =
        isPulled ? pullTitle(*stop.effect, name, bodyTitle(QString::fromStdString(stop.otherBody)))
                 : QString();
    if (stop.reason == sim::StopReason::stepFailed)
        return SentencesText::tr("Stopped at frame %1: your code has a mistake that stops the next frame.")
            .arg(stop.frame);
    QStringList said;
    if (stop.reason == sim::StopReason::tooManySteps) {
        said << SentencesText::tr("Stopped at frame %1: the method needs too many steps for the next frame.")
                    .arg(stop.frame);
        said << (isPulled ? SentencesText::tr("%1 is strongest.").arg(pull)
                          : SentencesText::tr("The strongest force acts on %1.").arg(name));
        said << SentencesText::tr("Try a larger tolerance, or a method with fixed steps.");
        return said.join(' ');
    }
    said << (stop.body.empty()
                 ? SentencesText::tr("Stopped at frame %1: in the next frame, a number is not finite.")
                       .arg(stop.frame)
                 : SentencesText::tr("Stopped at frame %1: in the next frame, “%2” is too far away or too "
                                     "fast for a number (not finite).")
                       .arg(stop.frame)
                       .arg(name));
    if (!stop.phase.empty())
        said << SentencesText::tr("It began in “%1”.").arg(phrase(stop.phase));
    if (isPulled)
        said << SentencesText::tr("%1 is strongest.").arg(pull);
    return said.join(' ');
}

}
