#include "app/cli/hard_report.h"

#include "app/model/sentences.h"

#include <QCoreApplication>
#include <QStringList>

#include <algorithm>

namespace app {

namespace {

struct Text
{
    Q_DECLARE_TR_FUNCTIONS(HardCases)
};

/// Why it is not claimed, and what failed: empty for what is claimed and holds.
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

QJsonObject hardRowJson(const HardRow &row)
{
    const sim::Verdict &verdict = row.verdict;
    return {{"case", QString::fromStdString(row.hard)},
            {"method", QString::fromStdString(row.method)},
            {"claims", verdict.claim.isMade},
            {"holds", verdict.holds},
            {"why", whyOf(verdict)},
            {"frames", qint64(verdict.frames)},
            {"ns_per_frame", verdict.frames > 0 ? QJsonValue(verdict.nsPerFrame) : QJsonValue()}};
}

QString hardHeading(const sim::HardCase &hard)
{
    return QString::fromStdString(hard.id) + ": " + phrase(hard.title) + '\n' + phrase(hard.story) + "\n  " +
           Text::tr("method").leftJustified(22) + Text::tr("claims").leftJustified(8) +
           Text::tr("holds").leftJustified(8) + Text::tr("frames").rightJustified(9) +
           Text::tr("ns/frame").rightJustified(12) + '\n';
}

QString hardLine(const HardRow &row)
{
    const sim::Verdict &verdict = row.verdict;
    const QString holds = verdict.holds        ? Text::tr("holds")
                          : verdict.isBroken() ? Text::tr("BROKEN")
                                               : Text::tr("fails");
    const QString why = whyOf(verdict);
    return "  " + QString::fromStdString(row.method).leftJustified(22) +
           (verdict.claim.isMade ? Text::tr("claims") : QStringLiteral("-")).leftJustified(8) +
           holds.leftJustified(8) + QString::number(verdict.frames).rightJustified(9) +
           timeOf(verdict).rightJustified(12) + (why.isEmpty() ? QString() : "  " + why) + '\n';
}

QString hardSummary(const std::vector<HardRow> &rows)
{
    QStringList broken;
    for (const HardRow &row : rows) {
        if (row.verdict.isBroken())
            broken << QString::fromStdString(row.method) + " in " + QString::fromStdString(row.hard);
    }
    const auto claims =
        std::count_if(rows.begin(), rows.end(), [](const HardRow &row) { return row.verdict.claim.isMade; });
    const QString text = Text::tr("%1 of %2 runs are claimed").arg(claims).arg(rows.size());
    if (broken.isEmpty())
        return text + Text::tr(", and all of those hold.") + '\n';
    return text + Text::tr(", and %1 of those fail: %2.").arg(broken.size()).arg(broken.join(", ")) + '\n';
}

}
