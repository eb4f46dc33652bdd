#include "app/cli/accuracy_report.h"

#include "app/model/text/json_writer.h"
#include "app/model/text/sentences.h"
#include "sim/pipeline/method.h"

namespace app {

namespace {

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

void writeStepObject(const QString &name, sim::StepSize step, JsonWriter &json)
{
    json.beginObject(name);
    writeStep(step, json);
    json.endObject();
}

void writeReference(const sim::ReferenceRun &reference, JsonWriter &json)
{
    json.beginObject("reference");
    json.field("method", reference.method);
    json.field("check", reference.check);
    json.field("disagreement", reference.disagreement);
    writeStepObject("step", reference.step, json);
    writeStepObject("check_step", reference.checkStep, json);
    json.field("ends_by", endOf(reference.end));
    if (reference.discontinuity)
        json.field("no_limit", reference.discontinuity->id());
    json.endObject();
}

void writeRow(const sim::AccuracyRow &row, JsonWriter &json)
{
    const bool isMeasured = row.outcome == sim::Outcome::measured;
    const auto ifMeasured = [&](double value) { return isMeasured ? std::optional(value) : std::nullopt; };
    json.beginObject();
    json.field("method", row.setup.method->id());
    json.field("order", row.setup.method->order());
    writeStep(row.setup.step, json);
    json.field("error", ifMeasured(row.error));
    json.field("evaluations", ifMeasured(row.evaluations));
    json.field("ns_per_frame", ifMeasured(row.nsPerFrame));
    json.field("spread", ifMeasured(row.spread));
    json.field("status", statusOf(row.outcome));
    json.field("front", row.front);
    if (row.why)
        json.field("reason", sentenceFor(*row.why));
    json.endObject();
}

/// Writes the cheapest row with an error of at most `error` px, or null.
void writeCheapest(const sim::Accuracy &found, double error, JsonWriter &json)
{
    const sim::AccuracyRow *row = found.cheapest(error);
    if (!row)
        return json.null();
    json.beginObject();
    json.field("method", row->setup.method->id());
    writeStep(row->setup.step, json);
    json.field("error", row->error);
    json.field("ns_per_frame", row->nsPerFrame);
    json.endObject();
}

}

void writeStep(sim::StepSize step, JsonWriter &json)
{
    step.isAdaptive() ? json.field("tolerance", step.tolerance) : json.field("h", step.h);
}

QString accuracyJson(const AccuracyReport &report)
{
    const sim::Accuracy &found = report.found;
    JsonWriter json(4);
    json.beginObject();
    json.field("experiment", report.experiment);
    json.field("span_frames", found.span);
    writeReference(found.reference, json);
    json.field("horizon_frames", found.horizon);
    json.beginList("rows");
    for (const sim::AccuracyRow &row : found.rows)
        writeRow(row, json);
    json.endList();
    json.beginObject("cheapest");
    for (const char *error : {"1e-1", "1e-2", "1e-3", "1e-4", "1e-5", "1e-6", "1e-7", "1e-8"}) {
        json.name(error);
        writeCheapest(found, QByteArray(error).toDouble(), json);
    }
    json.endObject();
    json.field("noise", found.noise);
    if (report.tolerance) {
        json.name("within");
        writeCheapest(found, *report.tolerance, json);
    }
    json.endObject();
    return QString::fromUtf8(json.text()) + '\n';
}

}
