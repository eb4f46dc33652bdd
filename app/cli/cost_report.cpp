#include "app/cli/cost_report.h"

#include "app/cli/accuracy_report.h"
#include "app/model/text/json_writer.h"
#include "app/model/text/phrases.h"

#include <QCoreApplication>

#include <cmath>

namespace app {

namespace {

struct CostReportText
{
    Q_DECLARE_TR_FUNCTIONS(CostReportText)
};

QString idOf(const sim::EffectCost &one)
{
    return QString::fromStdString(one.effect->id());
}

double perPoint(const sim::EffectCost &one)
{
    return one.points > 0 ? one.ns / one.points : 0.0;
}

void writeEffect(const sim::EffectCost &one, JsonWriter &json)
{
    json.beginObject();
    json.field("id", idOf(one));
    json.field("ns_per_frame", one.ns);
    json.field("ns_per_point", perPoint(one));
    json.field("points", one.points);
    json.field("spread", one.spread);
    json.field("evaluations", one.evaluations);
    json.endObject();
}

void writeUnused(const UnusedEffect &unused, JsonWriter &json)
{
    json.beginObject();
    json.field("id", unused.id);
    for (const char *number : {"ns_per_frame", "ns_per_point", "points", "spread", "evaluations"})
        json.field(number, 0);
    json.field("why", unused.why);
    json.endObject();
}

/// Returns a time in ns, with one digit after the point if it is below 1000.
QString nanoseconds(double ns)
{
    return QString::number(ns, 'f', std::abs(ns) < 1000.0 ? 1 : 0);
}

QString share(double part, double whole)
{
    return whole > 0.0 ? CostReportText::tr("%1 %").arg(std::lround(100.0 * part / whole))
                       : QStringLiteral("-");
}

QString line(const QString &name, const QStringList &numbers)
{
    constexpr int widths[] = {8, 14, 12, 10, 10, 8};
    QString text = name.leftJustified(22);
    for (qsizetype i = 0; i < numbers.size(); ++i)
        text += numbers[i].rightJustified(widths[i]);
    return text + '\n';
}

QString effectLine(const sim::EffectCost &one, double frame)
{
    return line(idOf(one),
                {QString::number(one.points), QString::number(one.evaluations, 'g', 4), nanoseconds(one.ns),
                 nanoseconds(one.spread), QString::number(perPoint(one), 'f', 2), share(one.ns, frame)});
}

}

QString costTable(const CostReport &report)
{
    const sim::FrameCost &cost = report.cost;
    const QString none;
    QString text = listed(listed(report.experiment, QString::fromStdString(report.method->id())),
                          stepText(report.step)) +
                   "\n\n";
    text +=
        line(CostReportText::tr("effect"),
             {CostReportText::tr("points"), CostReportText::tr("times/frame"), CostReportText::tr("ns/frame"),
              CostReportText::tr("+-"), CostReportText::tr("ns/point"), CostReportText::tr("share")});
    for (const sim::EffectCost &one : cost.effects)
        text += effectLine(one, cost.ns);
    text += line(CostReportText::tr("the method itself"),
                 {none, none, nanoseconds(cost.restNs), nanoseconds(cost.restSpread), none,
                  share(cost.restNs, cost.ns)});
    text +=
        line(CostReportText::tr("whole frame"), {none, none, nanoseconds(cost.ns), nanoseconds(cost.spread)});
    for (const UnusedEffect &unused : report.unused)
        text += line(unused.id, {"0", "0", "0", none, none, none}).trimmed() + "  " + unused.why + '\n';
    return text + '\n' +
           CostReportText::tr("Each line is measured separately. Effects and method together take %1 of the "
                              "time of the whole frame.")
               .arg(share(cost.sum(), cost.ns)) +
           '\n';
}

QString costJson(const CostReport &report)
{
    JsonWriter json(4);
    json.beginObject();
    json.field("experiment", report.experiment);
    json.field("method", report.method->id());
    writeStep(report.step, json);
    json.field("frame_ns", report.cost.ns);
    json.field("frame_spread", report.cost.spread);
    json.beginList("effects");
    for (const sim::EffectCost &one : report.cost.effects)
        writeEffect(one, json);
    for (const UnusedEffect &unused : report.unused)
        writeUnused(unused, json);
    json.endList();
    json.field("rest_ns", report.cost.restNs);
    json.field("rest_spread", report.cost.restSpread);
    json.field("rounds", report.cost.rounds);
    json.endObject();
    return QString::fromUtf8(json.text()) + '\n';
}

}
