#include "app/cli/cost_report.h"

#include "app/cli/accuracy_report.h"

#include <QCoreApplication>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <cmath>

namespace app {

namespace {

struct Text
{
    Q_DECLARE_TR_FUNCTIONS(Cost)
};

QString idOf(const sim::EffectCost &one)
{
    return QString::fromStdString(one.effect->id());
}

double perPoint(const sim::EffectCost &one)
{
    return one.points > 0 ? one.ns / one.points : 0.0;
}

QJsonObject effectJson(const sim::EffectCost &one)
{
    return {{"id", idOf(one)},      {"ns_per_frame", one.ns},
            {"points", one.points}, {"ns_per_point", perPoint(one)},
            {"spread", one.spread}, {"evaluations", one.evaluations}};
}

QJsonObject unusedJson(const UnusedEffect &unused)
{
    return {{"id", unused.id}, {"ns_per_frame", 0}, {"points", 0},      {"ns_per_point", 0},
            {"spread", 0},     {"evaluations", 0},  {"why", unused.why}};
}

/// A time in ns: from one digit after the point for small ones to none.
QString nanoseconds(double ns)
{
    return QString::number(ns, 'f', std::abs(ns) < 1000.0 ? 1 : 0);
}

QString share(double part, double whole)
{
    return whole > 0.0 ? Text::tr("%1 %").arg(std::lround(100.0 * part / whole)) : QStringLiteral("-");
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
    QString text =
        Text::tr("%1, %2, %3")
            .arg(report.experiment, QString::fromStdString(report.method->id()), stepText(report.step)) +
        "\n\n";
    text += line(Text::tr("effect"), {Text::tr("points"), Text::tr("times/frame"), Text::tr("ns/frame"),
                                      Text::tr("+-"), Text::tr("ns/point"), Text::tr("share")});
    for (const sim::EffectCost &one : cost.effects)
        text += effectLine(one, cost.ns);
    text += line(Text::tr("the method itself"),
                 {none, none, nanoseconds(cost.restNs), nanoseconds(cost.restSpread), none,
                  share(cost.restNs, cost.ns)});
    text += line(Text::tr("whole frame"), {none, none, nanoseconds(cost.ns), nanoseconds(cost.spread)});
    for (const UnusedEffect &unused : report.unused)
        text += line(unused.id, {"0", "0", "0", none, none, none}).trimmed() + "  " + unused.why + '\n';
    return text + '\n' +
           Text::tr("Each line is measured by itself; effects and method come to %1 of the whole frame.")
               .arg(share(cost.sum(), cost.ns)) +
           '\n';
}

QString costJson(const CostReport &report)
{
    QJsonArray effects;
    for (const sim::EffectCost &one : report.cost.effects)
        effects.append(effectJson(one));
    for (const UnusedEffect &unused : report.unused)
        effects.append(unusedJson(unused));
    QJsonObject object{{"experiment", report.experiment},
                       {"method", QString::fromStdString(report.method->id())},
                       {"frame_ns", report.cost.ns},
                       {"frame_spread", report.cost.spread},
                       {"effects", effects},
                       {"rest_ns", report.cost.restNs},
                       {"rest_spread", report.cost.restSpread},
                       {"rounds", report.cost.rounds}};
    if (report.step.isAdaptive())
        object["tolerance"] = report.step.tolerance;
    else
        object["h"] = report.step.h;
    return QString::fromUtf8(QJsonDocument(object).toJson());
}

}
