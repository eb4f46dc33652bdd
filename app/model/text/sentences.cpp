#include "app/model/text/sentences.h"

#include "app/model/text/hard_case_text.h"
#include "sim/scene/scene.h"

#include <QCoreApplication>
#include <QLocale>
#include <QRegularExpression>

namespace app {

namespace {

struct SentencesText
{
    Q_DECLARE_TR_FUNCTIONS(SentencesText)
};

QString value(const sim::Error &error, const char *name)
{
    const auto found = error.values().find(name);
    return found == error.values().end() ? QString() : QString::fromStdString(found->second);
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
    if (error.id() == "step-size")
        return SentencesText::tr("The step %1 is not allowed. It can be a whole number of frames, or 1 "
                                 "divided by a whole number, from 0.000001 to 100 frames.")
            .arg(value(error, "h"));
    if (error.id() == "tolerance")
        return SentencesText::tr("The tolerance %1 is not allowed. It can be from 1e-13 to 100 px.")
            .arg(value(error, "tolerance"));
    if (error.id() == "needs-tolerance")
        return SentencesText::tr(
                   "The method %1 chooses its own steps. Choose a tolerance in px instead of a step.")
            .arg(value(error, "method"));
    if (error.id() == "listing-needs-frame-steps")
        return SentencesText::tr(
                   "Your code computes whole frames, so its step cannot be %1. Choose a step of 1 frame.")
            .arg(value(error, "h"));
    if (error.id() == "needs-step")
        return SentencesText::tr(
                   "The method %1 has fixed steps. Choose a step in frames instead of a tolerance.")
            .arg(value(error, "method"));
    if (error.id() == "no-limit")
        return SentencesText::tr(
                   "%1 acts once per step, so smaller steps give a different motion from the first frame on.")
            .arg(value(error, "effect"));
    if (error.id() == "short-horizon")
        return SentencesText::tr("There is nothing to compare with after frame %1.")
            .arg(value(error, "frames"));
    if (error.id() == "method-does-not-fit")
        return SentencesText::tr(
                   "The method %1 cannot compute %2: choose another method, or switch that effect off.")
            .arg(value(error, "method"), value(error, "effect"));
    if (error.id() == "needs-inertia")
        return SentencesText::tr("The method %1 cannot compute this scene, because parts of it have no "
                                 "velocity of their own. Choose another method.")
            .arg(value(error, "method"));
    if (error.id() == "nothing-moves")
        return SentencesText::tr("Nothing in this scene can move. Leave at least one body free.");
    if (error.id() == "too-many-points")
        return SentencesText::tr(
                   "This scene has %1 points, and at most %2 can be measured with every method. Measure a "
                   "smaller scene of the same kind: its results are valid for this one, too.")
            .arg(value(error, "points"), value(error, "most"));
    if (error.id() == "tree-too-big")
        return SentencesText::
            tr("This tree would have more than %1 branches: make its slope smaller than %2, or its smallest "
               "branch larger than %3.")
                .arg(value(error, "most"), value(error, "slope"), value(error, "min_scale"));
    if (error.id() == "stick-without-end")
        return SentencesText::
            tr("Stick %1 ends at p%2, but there is no such point. There are %3 points, and the first is p0.")
                .arg(value(error, "stick"), value(error, "end"), value(error, "points"));
    if (error.id() == "spring-without-end")
        return SentencesText::
            tr("Spring %1 ends at p%2, but there is no such point. There are %3 points, and the first is p0.")
                .arg(value(error, "spring"), value(error, "end"), value(error, "points"));
    if (error.id() == "input-not-finite")
        return SentencesText::tr("The event %1 before frame %2 has a value that is infinite or not a number. "
                                 "Give it a finite number.")
            .arg(value(error, "event"), value(error, "frame"));
    if (error.id() == "start-not-finite")
        return SentencesText::tr(
                   "The start of %1 has a value that is infinite or not a number. Give it a finite number.")
            .arg(bodyTitle(value(error, "body")));
    if (const QString hard = hardSentence(error); !hard.isEmpty())
        return hard;
    return SentencesText::tr("These settings do not fit together: %1.").arg(QString::fromUtf8(error.what()));
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
