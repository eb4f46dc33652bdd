#include "app/model/learning/prediction_text.h"

#include "app/model/text/numbers.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

namespace app {

namespace {

struct PredictionText
{
    Q_DECLARE_TR_FUNCTIONS(PredictionText)
};

using Asks = lessons::Question::Kind;

/// Returns how many decimals of a number a learner reads.
int decimals(double value)
{
    const double size = std::abs(value);
    return size >= 10.0 ? 1 : size >= 1.0 ? 2 : 3;
}

/// Returns a number as exactly as a learner reads it: two to three digits, or all of a whole number.
QString shortNumber(double value)
{
    return fixedNumber(value, value == std::round(value) ? 0 : decimals(value));
}

QString withUnit(const lessons::Question &question, double value)
{
    const QString frames = value == 1.0 ? PredictionText::tr("frame") : PredictionText::tr("frames");
    const QString unit = question.asksFrames() ? frames : question.unit;
    return unit.isEmpty() ? shortNumber(value) : shortNumber(value) + QStringLiteral("\u202F") + unit;
}

/// Returns the place in the row of three at which the learner sees a curve, from 1.
int shownNumber(const lessons::Prediction &prediction, int curve)
{
    const std::array<int, 3> order = curveOrder(prediction);
    return static_cast<int>(std::find(order.begin(), order.end(), curve) - order.begin()) + 1;
}

QString differenceWords(const lessons::Question &question, double said, double found)
{
    const double difference = said - found;
    // A difference that is lost when both numbers are shown is none.
    if (std::abs(difference) < 0.5 * std::pow(10.0, -decimals(found)))
        return PredictionText::tr("exactly as you said");
    const QString size = withUnit(question, std::abs(difference));
    return difference > 0.0 ? PredictionText::tr("your number is %1 too high").arg(size)
                            : PredictionText::tr("your number is %1 too low").arg(size);
}

}

QString answerWords(const lessons::Prediction &prediction, const PredictedAnswer &answer)
{
    switch (prediction.question.kind) {
    case Asks::place:
        return PredictionText::tr("%1, %2").arg(fixedNumber(answer.place.x, 0),
                                                fixedNumber(answer.place.y, 0));
    case Asks::number:
        return withUnit(prediction.question, answer.number);
    case Asks::curve:
        break;
    }
    return PredictionText::tr("curve %1").arg(shownNumber(prediction, answer.curve));
}

QString outcomeSentence(const lessons::Prediction &prediction, const PredictedAnswer &said,
                        const PredictedAnswer &found)
{
    const QString yours = answerWords(prediction, said), real = answerWords(prediction, found);
    switch (prediction.question.kind) {
    case Asks::place:
        return PredictionText::tr("You said **%1**. It is **%2**: %3\u202Fpx away.")
            .arg(yours, real, fixedNumber(sim::length(said.place - found.place), 0));
    case Asks::number:
        return PredictionText::tr("You said **%1**. It is **%2**: %3.")
            .arg(yours, real, differenceWords(prediction.question, said.number, found.number));
    case Asks::curve:
        break;
    }
    return said.curve == found.curve ? PredictionText::tr("You said **%1**, and so it is.").arg(yours)
                                     : PredictionText::tr("You said **%1**. It is **%2**.").arg(yours, real);
}

QString notedOutcome(const Notes &notes, const QString &lesson, const QString &step,
                     const lessons::Prediction &prediction)
{
    const Note *note = notes.find(Notes::keyOf(lesson, step, QStringLiteral("predict"), prediction.id));
    if (!note || note->kind != notedKind(prediction.question))
        return {};
    const auto said = answerInNote(prediction.question, note->said);
    const auto found = answerInNote(prediction.question, note->found);
    return said && found ? outcomeSentence(prediction, *said, *found) : QString();
}

QString curveWords(const std::vector<double> &curve)
{
    if (curve.empty())
        return {};
    const auto [lowest, highest] = std::minmax_element(curve.begin(), curve.end());
    return PredictionText::tr("from %1 to %2, at most %3, at least %4")
        .arg(fixedNumber(curve.front(), 0), fixedNumber(curve.back(), 0), fixedNumber(*highest, 0),
             fixedNumber(*lowest, 0));
}

}
