#include "app/model/sentences.h"

#include "app/model/hard_sentences.h"
#include "sim/scene/scene.h"

#include <QCoreApplication>
#include <QLocale>
#include <QRegularExpression>

namespace app {

namespace {

struct Text
{
    Q_DECLARE_TR_FUNCTIONS(Sentences)
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
        return Text::tr(
                   "The step %1 does not fit: it can be 1 divided by a whole number, or a whole number, from "
                   "0.000001 to 100 frames.")
            .arg(value(error, "h"));
    if (error.id() == "tolerance")
        return Text::tr("The tolerance %1 does not fit: it can be from 1e-13 to 100 px.")
            .arg(value(error, "tolerance"));
    if (error.id() == "needs-tolerance")
        return Text::tr(
                   "The method %1 chooses its steps itself: give it a tolerance in px in place of a step.")
            .arg(value(error, "method"));
    if (error.id() == "needs-step")
        return Text::
            tr("The method %1 takes steps of one length: give it a step in frames in place of a tolerance.")
                .arg(value(error, "method"));
    if (error.id() == "no-limit")
        return Text::tr(
                   "%1 acts once a step, so that smaller steps make another motion from the first frame on.")
            .arg(value(error, "effect"));
    if (error.id() == "short-horizon")
        return Text::tr("There is nothing to compare with after frame %1.").arg(value(error, "frames"));
    if (error.id() == "method-does-not-fit")
        return Text::tr("The method %1 cannot compute %2: choose another method, or switch that effect off.")
            .arg(value(error, "method"), value(error, "effect"));
    if (error.id() == "needs-inertia")
        return Text::
            tr("The method %1 cannot compute this scene: parts of it go only where they are put, and have "
               "no velocity. Choose another method.")
                .arg(value(error, "method"));
    if (error.id() == "nothing-moves")
        return Text::tr("Nothing in this scene can move: leave at least one body free.");
    if (error.id() == "too-many-points")
        return Text::
            tr("This scene has %1 points. Up to %2 are computed with every method: what a few of them tell "
               "about methods holds for more of the same.")
                .arg(value(error, "points"), value(error, "most"));
    if (error.id() == "tree-too-big")
        return Text::
            tr("This tree would have more than %1 branches: make its slope smaller than %2, or its smallest "
               "branch larger than %3.")
                .arg(value(error, "most"), value(error, "slope"), value(error, "min_scale"));
    if (error.id() == "stick-without-end")
        return Text::tr(
                   "Stick %1 ends at p%2, and there is no such point: there are %3, and the first is p0.")
            .arg(value(error, "stick"), value(error, "end"), value(error, "points"));
    if (error.id() == "spring-without-end")
        return Text::tr(
                   "Spring %1 ends at p%2, and there is no such point: there are %3, and the first is p0.")
            .arg(value(error, "spring"), value(error, "end"), value(error, "points"));
    if (error.id() == "input-not-finite")
        return Text::tr(
                   "The event %1 before frame %2 has a number that is infinite or none at all: give it a "
                   "finite one.")
            .arg(value(error, "event"), value(error, "frame"));
    if (error.id() == "start-not-finite")
        return Text::tr("The start of %1 has a number that is infinite or none at all: give it a finite one.")
            .arg(bodyTitle(value(error, "body")));
    if (const QString hard = hardSentence(error); !hard.isEmpty())
        return hard;
    return Text::tr("This does not fit together: %1.").arg(QString::fromUtf8(error.what()));
}

QString pullTitle(const sim::Effect &effect, const QString &body, const QString &other)
{
    const bool isSpring = effect.kind() == sim::EffectKind::spring;
    if (other.isEmpty())
        return isSpring ? Text::tr("The spring of %1").arg(body)
                        : Text::tr("What pulls %1 (%2)").arg(body, phrase(effect.title()));
    const QString pair = Text::tr("%1 – %2").arg(body, other);
    return isSpring ? Text::tr("The spring %1").arg(pair)
                    : Text::tr("What pulls %1 (%2)").arg(pair, phrase(effect.title()));
}

QString sentenceFor(const sim::Stop &stop)
{
    const QString name = bodyTitle(QString::fromStdString(stop.body));
    const bool isPulled = dynamic_cast<const sim::Force *>(stop.effect.get()) && !stop.body.empty();
    const QString pull =
        isPulled ? pullTitle(*stop.effect, name, bodyTitle(QString::fromStdString(stop.otherBody)))
                 : QString();
    QStringList said;
    if (stop.reason == sim::StopReason::tooManySteps) {
        said << Text::tr("Stopped at frame %1: the method needs too many steps for the next one.")
                    .arg(stop.frame);
        said << (isPulled ? Text::tr("%1 pulls hardest.").arg(pull)
                          : Text::tr("What is pulled hardest is %1.").arg(name));
        said << Text::tr("Try a larger tolerance, or a method whose steps all have one length.");
        return said.join(' ');
    }
    said << (stop.body.empty()
                 ? Text::tr("Stopped at frame %1: in the next one a number is not finite.").arg(stop.frame)
                 : Text::tr(
                       "Stopped at frame %1: in the next one “%2” is too far or too fast for any number (not "
                       "finite).")
                       .arg(stop.frame)
                       .arg(name));
    if (!stop.phase.empty())
        said << Text::tr("It began in “%1”.").arg(phrase(stop.phase));
    if (isPulled)
        said << Text::tr("%1 pulls hardest.").arg(pull);
    return said.join(' ');
}

}
