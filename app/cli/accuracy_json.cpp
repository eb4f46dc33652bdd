#include "app/cli/accuracy_report.h"
#include "sim/pipeline/method.h"

#include "app/model/sentences.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

namespace app {

namespace {

QString idOf(const sim::MethodSetup &setup)
{
    return QString::fromStdString(setup.method->id());
}

void addStep(QJsonObject &object, sim::StepSize step)
{
    if (step.isAdaptive())
        object["tolerance"] = step.tolerance;
    else
        object["h"] = step.h;
}

QString statusOf(sim::Outcome outcome)
{
    switch (outcome) {
    case sim::Outcome::waiting:
        return QStringLiteral("waiting");
    case sim::Outcome::measured:
        return QStringLiteral("measured");
    case sim::Outcome::unstable:
        return QStringLiteral("unstable");
    case sim::Outcome::doesNotFit:
        return QStringLiteral("does_not_fit");
    case sim::Outcome::tooLong:
        return QStringLiteral("too_long");
    }
    return {};
}

/// What was not measured is null.
QJsonObject rowJson(const sim::AccuracyRow &row)
{
    const bool isMeasured = row.outcome == sim::Outcome::measured;
    const auto number = [&](double value) { return isMeasured ? QJsonValue(value) : QJsonValue(); };
    QJsonObject object{{"method", idOf(row.setup)},
                       {"order", row.setup.method->order()},
                       {"error", number(row.error)},
                       {"evaluations", number(row.evaluations)},
                       {"ns_per_frame", number(row.nsPerFrame)},
                       {"spread", number(row.spread)},
                       {"status", statusOf(row.outcome)},
                       {"front", row.front}};
    addStep(object, row.setup.step);
    if (row.why)
        object["reason"] = sentenceFor(*row.why);
    return object;
}

QJsonValue cheapestJson(const sim::Accuracy &found, double error)
{
    const sim::AccuracyRow *row = found.cheapest(error);
    if (!row)
        return {};
    QJsonObject object{
        {"method", idOf(row->setup)}, {"error", row->error}, {"ns_per_frame", row->nsPerFrame}};
    addStep(object, row->setup.step);
    return object;
}

QString endOf(sim::ReferenceRun::End end)
{
    switch (end) {
    case sim::ReferenceRun::End::span:
        return QStringLiteral("span");
    case sim::ReferenceRun::End::diverged:
        return QStringLiteral("parted");
    case sim::ReferenceRun::End::notFinite:
        return QStringLiteral("not_finite");
    case sim::ReferenceRun::End::tooLong:
        return QStringLiteral("too_long");
    }
    return {};
}

QJsonObject stepJson(sim::StepSize step)
{
    QJsonObject object;
    addStep(object, step);
    return object;
}

QJsonObject referenceJson(const sim::ReferenceRun &reference)
{
    QJsonObject object{{"method", QString::fromStdString(reference.method)},
                       {"check", QString::fromStdString(reference.check)},
                       {"disagreement", reference.disagreement},
                       {"step", stepJson(reference.step)},
                       {"check_step", stepJson(reference.checkStep)},
                       {"ends_by", endOf(reference.end)}};
    if (reference.discontinuity)
        object["no_limit"] = QString::fromStdString(reference.discontinuity->id());
    return object;
}

}

QString accuracyJson(const AccuracyReport &report)
{
    const sim::Accuracy &found = report.found;
    QJsonArray rows;
    for (const sim::AccuracyRow &row : found.rows)
        rows.append(rowJson(row));
    QJsonObject cheapest;
    for (const char *error : {"1e-1", "1e-2", "1e-3", "1e-4", "1e-5", "1e-6", "1e-7", "1e-8"})
        cheapest[QLatin1String(error)] = cheapestJson(found, QByteArray(error).toDouble());
    QJsonObject object{{"experiment", report.experiment},
                       {"span_frames", qint64(found.span)},
                       {"reference", referenceJson(found.reference)},
                       {"horizon_frames", qint64(found.horizon)},
                       {"rows", rows},
                       {"cheapest", cheapest},
                       {"noise", found.noise}};
    if (report.tolerance)
        object["within"] = cheapestJson(found, *report.tolerance);
    return QString::fromUtf8(QJsonDocument(object).toJson());
}

}
