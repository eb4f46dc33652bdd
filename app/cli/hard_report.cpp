#include "app/cli/hard_report.h"

#include "app/model/text/json_writer.h"
#include "app/model/text/sentences.h"

#include <QCoreApplication>
#include <QStringList>

#include <algorithm>

namespace app {

namespace {

struct HardReportText
{
    Q_DECLARE_TR_FUNCTIONS(HardReportText)
};

/// Returns why a case is not claimed and why it failed. Empty if it is claimed and holds.
QString whyOf(const sim::Verdict &verdict)
{
    QStringList reasons;
    for (const std::optional<sim::Error> &why : {verdict.claim.why, verdict.why}) {
        const QString reason = why ? sentenceFor(*why) : QString();
        if (!reason.isEmpty() && !reasons.contains(reason))
            reasons << reason;
    }
    return reasons.join(' ');
}

QString timeOf(const sim::Verdict &verdict)
{
    return verdict.frames > 0 ? QString::number(verdict.nsPerFrame, 'f', 0) : QStringLiteral("-");
}

}

QString hardJson(const std::vector<HardRow> &rows)
{
    JsonWriter json(4);
    json.beginObject();
    json.beginList("rows");
    for (const HardRow &row : rows) {
        const sim::Verdict &verdict = row.verdict;
        json.beginObject();
        json.field("case", row.hardCase);
        json.field("method", row.method);
        json.field("claims", verdict.claim.isMade);
        json.field("holds", verdict.holds);
        json.field("why", whyOf(verdict));
        json.field("frames", verdict.frames);
        json.field("ns_per_frame", verdict.frames > 0 ? std::optional(verdict.nsPerFrame) : std::nullopt);
        json.endObject();
    }
    json.endList();
    json.endObject();
    return QString::fromUtf8(json.text()) + '\n';
}

QString hardHeading(const sim::HardCase &hard)
{
    return QString::fromStdString(hard.id) + ": " + phrase(hard.title) + '\n' + phrase(hard.story) + "\n  " +
           HardReportText::tr("method").leftJustified(22) + HardReportText::tr("claims").leftJustified(8) +
           HardReportText::tr("holds").leftJustified(8) + HardReportText::tr("frames").rightJustified(9) +
           HardReportText::tr("ns/frame").rightJustified(12) + '\n';
}

QString hardLine(const HardRow &row)
{
    const sim::Verdict &verdict = row.verdict;
    const QString holds = verdict.holds        ? HardReportText::tr("holds")
                          : verdict.isBroken() ? HardReportText::tr("BROKEN")
                                               : HardReportText::tr("fails");
    const QString why = whyOf(verdict);
    return "  " + QString::fromStdString(row.method).leftJustified(22) +
           (verdict.claim.isMade ? HardReportText::tr("claims") : QStringLiteral("-")).leftJustified(8) +
           holds.leftJustified(8) + QString::number(verdict.frames).rightJustified(9) +
           timeOf(verdict).rightJustified(12) + (why.isEmpty() ? QString() : "  " + why) + '\n';
}

QString hardSummary(const std::vector<HardRow> &rows)
{
    QStringList broken;
    for (const HardRow &row : rows) {
        if (row.verdict.isBroken())
            broken << QString::fromStdString(row.method) + " in " + QString::fromStdString(row.hardCase);
    }
    const auto claims =
        std::count_if(rows.begin(), rows.end(), [](const HardRow &row) { return row.verdict.claim.isMade; });
    const QString text = HardReportText::tr("%1 of %2 runs are claimed").arg(claims).arg(rows.size());
    if (broken.isEmpty())
        return text + HardReportText::tr(", and all of those hold.") + '\n';
    return text +
           HardReportText::tr(", and %1 of those fail: %2.").arg(broken.size()).arg(broken.join(", ")) + '\n';
}

}
