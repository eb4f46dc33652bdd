#include "tests/bench/results.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QRegularExpression>

namespace bench {

namespace {

std::string text(const QJsonValue &value)
{
    return value.toString().toStdString();
}

double toNanoseconds(const QString &unit)
{
    return unit == "s" ? 1e9 : unit == "ms" ? 1e6 : unit == "us" ? 1e3 : 1.0;
}

/// Returns the name of a run without the parts that describe only how it was measured.
std::string nameOf(const QJsonObject &run)
{
    static const QRegularExpression how(
        "/(iterations:\\d+|real_time|manual_time|min_time:[^/]*|process_time)");
    return run["run_name"].toString().remove(how).toStdString();
}

/// Returns the value of a run, in ns. `what` is "time" or "coefficient".
double timeOf(const QJsonObject &run, const char *what)
{
    const QString name = run["run_name"].toString();
    const bool isReal = name.contains("/real_time") || name.contains("/manual_time");
    return run[QLatin1String(isReal ? "real_" : "cpu_") + QLatin1String(what)].toDouble() *
           toNanoseconds(run["time_unit"].toString());
}

/// Replaces NaN. Google Benchmark writes it if a counter is always 0, but JSON does not have it.
QByteArray withoutNan(QByteArray json)
{
    for (const char *number : {": NaN", ": -NaN", ": Infinity", ": -Infinity"})
        json.replace(number, ": null");
    return json;
}

void addRun(const QJsonObject &run, Results &results)
{
    const std::string name = nameOf(run);
    const QString kind = run["aggregate_name"].toString();
    if (run["error_occurred"].toBool())
        results.refused[name] = text(run["error_message"]);
    else if (kind == "median" || (kind.isEmpty() && !results.medians.count(name)))
        results.medians[name] = {timeOf(run, "time"), text(run["label"])};
    else if (kind == "BigO")
        results.growths[name] = {text(run["big_o"]), timeOf(run, "coefficient"), results.growths[name].off};
    else if (kind == "RMS")
        results.growths[name].off = run["rms"].toDouble();
}

}

std::string addResults(const QByteArray &json, Results &results)
{
    QJsonParseError error{};
    const QJsonObject file = QJsonDocument::fromJson(withoutNan(json), &error).object();
    if (error.error != QJsonParseError::NoError)
        return error.errorString().toStdString();
    if (!file["benchmarks"].isArray())
        return "no benchmarks in it";
    const QJsonObject context = file["context"].toObject();
    for (const char *one : {"processor", "compiler"}) {
        if (context[one].isString())
            results.machine[one] = text(context[one]);
    }
    results.machine["cores"] = std::to_string(context["num_cpus"].toInt());
    const QJsonArray load = context["load_avg"].toArray();
    if (!load.isEmpty())
        results.machine.try_emplace("load", QString::number(load[0].toDouble(), 'f', 1).toStdString());
    for (const QJsonValue &run : file["benchmarks"].toArray())
        addRun(run.toObject(), results);
    return {};
}

}
