#include "app/model/learning/prediction_truth.h"

#include "app/model/learning/run_setup.h"

#include <QStringList>

#include <algorithm>
#include <cmath>

namespace app {

namespace {

using Asked = lessons::Question::Kind;

constexpr double goodDistance = 10.0; ///< px
constexpr double goodShare = 0.02;
constexpr double goodDifference = 0.5;

/// Returns a number of a run, by output steps, for as many as `count`.
std::vector<double> curveOf(const lessons::RunSetup &setup, const lessons::Step &step, const QString &number,
                            std::size_t count, const sim::ShouldContinue &shouldContinue)
{
    FollowedRun run(step, scriptFor(setup, step));
    const MomentNumber value = run.number(number);
    std::vector<double> curve{value.at(run.moment())};
    while (curve.size() < count && (!shouldContinue || shouldContinue()) && run.advance())
        curve.push_back(value.at(run.moment()));
    return curve;
}

}

std::optional<PredictionTruth> truthOf(const lessons::Prediction &prediction, const lessons::Step &step,
                                       const sim::ShouldContinue &shouldContinue)
{
    const lessons::Question &question = prediction.question;
    FollowedRun run(step, scriptFor(prediction.run, step));
    std::optional<MomentNumber> number;
    int point = -1;
    if (question.kind == Asked::place)
        point = run.point(question.of);
    else if (!question.asksFrames())
        number = run.number(question.of);
    std::vector<double> curve;
    const auto visit = [&] {
        if (question.kind == Asked::curve)
            curve.push_back(number->at(run.moment()));
    };
    const std::optional<RunEnd> end = runToEnd(run, prediction.run, shouldContinue, visit);
    if (!end)
        return std::nullopt;
    PredictionTruth truth{end->frame, end->isReached};
    if (point >= 0)
        truth.answer.place = run.state().positionOf(point);
    else
        truth.answer.number = number ? number->at(run.moment()) : static_cast<double>(end->frame);
    if (question.kind != Asked::curve)
        return truth;
    truth.curves.push_back(curve);
    for (const lessons::RunSetup &other : prediction.otherCurves)
        truth.curves.push_back(curveOf(other, step, question.of, curve.size(), shouldContinue));
    return truth;
}

std::array<int, 3> curveOrder(const lessons::Prediction &prediction)
{
    static constexpr std::array<int, 3> orders[] = {{0, 1, 2}, {1, 0, 2}, {1, 2, 0},
                                                    {0, 2, 1}, {2, 0, 1}, {2, 1, 0}};
    unsigned sum = 0;
    for (const QChar letter : prediction.id)
        sum = 31U * sum + letter.unicode();
    return orders[sum % std::size(orders)];
}

bool isGood(const lessons::Question &question, const PredictedAnswer &said, const PredictedAnswer &found)
{
    switch (question.kind) {
    case Asked::place:
        return sim::length(said.place - found.place) <= goodDistance;
    case Asked::number:
        return std::abs(said.number - found.number) <=
               std::max(goodDifference, goodShare * std::abs(found.number));
    case Asked::curve:
        break;
    }
    return said.curve == found.curve;
}

QString notedAnswer(const lessons::Question &question, const PredictedAnswer &answer)
{
    switch (question.kind) {
    case Asked::place:
        return QStringLiteral("%1, %2").arg(answer.place.x, 0, 'f', 1).arg(answer.place.y, 0, 'f', 1);
    case Asked::number:
        return QString::number(answer.number, 'g', 10);
    case Asked::curve:
        break;
    }
    return QString::number(answer.curve);
}

std::optional<PredictedAnswer> answerInNote(const lessons::Question &question, const QString &text)
{
    PredictedAnswer answer;
    const QStringList parts = text.split(',');
    bool isFirst = false, isSecond = true;
    const double first = parts[0].trimmed().toDouble(&isFirst);
    switch (question.kind) {
    case Asked::place:
        answer.place = {first, parts.value(1).trimmed().toDouble(&isSecond)};
        break;
    case Asked::number:
        answer.number = first;
        break;
    case Asked::curve:
        answer.curve = static_cast<int>(first);
        isSecond = first >= 0.0 && first <= 2.0;
        break;
    }
    return isFirst && isSecond ? std::optional(answer) : std::nullopt;
}

QString notedKind(const lessons::Question &question)
{
    switch (question.kind) {
    case Asked::place:
        return QStringLiteral("place");
    case Asked::number:
        return QStringLiteral("number");
    case Asked::curve:
        break;
    }
    return QStringLiteral("curve");
}

}
