#include "app/cli/hard_cases.h"

#include "app/cli/hard_report.h"
#include "app/cli/terminal.h"
#include "app/model/words.h"
#include "sim/catalogue/hard_cases.h"
#include "sim/methods/methods.h"

#include <QCoreApplication>
#include <QJsonArray>
#include <QJsonDocument>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace app {

namespace {

struct Text
{
    Q_DECLARE_TR_FUNCTIONS(HardCases)
};

std::vector<sim::HardCase> casesOf(const HardCasesRequest &request)
{
    std::vector<sim::HardCase> all = sim::hardCases();
    if (request.only)
        std::erase_if(all, [&](const sim::HardCase &one) { return one.id != request.only->toStdString(); });
    return all;
}

/// Refuses a case that is not there.
int refuseCase(const QString &wanted)
{
    QStringList ids;
    for (const sim::HardCase &one : sim::hardCases())
        ids << QString::fromStdString(one.id);
    say(Text::tr("There is no case %1; there is %2.").arg(quoted(wanted), quotedList(ids, wanted)));
    return exitBadUse;
}

HardRow rowOf(const sim::HardCase &hard, const sim::MethodPtr &method, bool isFull)
{
    StatusLine status;
    const auto told = [&](double done) {
        if (status.isDue())
            status.show(Text::tr("%1, %2: %3 %")
                            .arg(QString::fromStdString(hard.id), QString::fromStdString(method->id()))
                            .arg(std::lround(100.0 * done)));
        return !isInterrupted();
    };
    return {hard.id, method->id(), judge(hard, method, isFull ? hard.full : hard.brief, told)};
}

}

int hardCases(const HardCasesRequest &request)
{
    const std::vector<sim::HardCase> cases = casesOf(request);
    if (cases.empty())
        return refuseCase(*request.only);
    listenForInterrupt();
    std::vector<HardRow> rows;
    for (const sim::HardCase &hard : cases) {
        if (!request.asJson)
            print(hardHeading(hard));
        for (const sim::MethodPtr &method : sim::allMethods()) {
            rows.push_back(rowOf(hard, method, request.isFull));
            if (isInterrupted()) {
                say(Text::tr("Stopped before every case was run."));
                return exitInterrupted;
            }
            if (!request.asJson) {
                print(hardLine(rows.back()));
                std::fflush(stdout); // some take long, and those who wait read on
            }
        }
        print(request.asJson ? QString() : QStringLiteral("\n"));
    }
    QJsonArray all;
    for (const HardRow &row : rows)
        all.append(hardRowJson(row));
    print(request.asJson ? QString::fromUtf8(QJsonDocument(QJsonObject{{"rows", all}}).toJson())
                         : hardSummary(rows));
    const bool anyBroken =
        std::any_of(rows.begin(), rows.end(), [](const HardRow &row) { return row.verdict.isBroken(); });
    return anyBroken ? exitNo : exitDone;
}

}
