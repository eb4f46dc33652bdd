#include "sim/catalogue/hard_cases.h"
#include "app/cli/hard_report.h"
#include "app/cli/terminal.h"
#include "app/cli/verbs.h"
#include "app/model/text/quoting.h"
#include "sim/methods/methods.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace app {

namespace {

struct HardCasesText
{
    Q_DECLARE_TR_FUNCTIONS(HardCasesText)
};

/// Returns the hard cases to run. @throws UserError: there is no such case
std::vector<sim::HardCase> casesFor(const Arguments &arguments)
{
    std::vector<sim::HardCase> all = sim::hardCases();
    if (!arguments.has("case"))
        return all;
    const QString wanted = arguments.value("case");
    QStringList ids;
    for (const sim::HardCase &one : all)
        ids << QString::fromStdString(one.id);
    if (!ids.contains(wanted))
        throw UserError(HardCasesText::tr("There is no case %1; there is %2.")
                            .arg(quoted(wanted), quotedList(ids, wanted)));
    std::erase_if(all, [&](const sim::HardCase &one) { return one.id != wanted.toStdString(); });
    return all;
}

HardRow rowOf(const sim::HardCase &hard, const sim::MethodPtr &method, bool isFull)
{
    TerminalLine status;
    const auto told = [&](double done) {
        if (status.isDue())
            status.show(HardCasesText::tr("%1, %2: %3 %")
                            .arg(QString::fromStdString(hard.id), QString::fromStdString(method->id()))
                            .arg(std::lround(100.0 * done)));
        return !isInterrupted();
    };
    return {hard.id, method->id(), judge(hard, method, isFull ? hard.full : hard.brief, told)};
}

}

int runHardCases(const Arguments &arguments)
{
    const std::vector<sim::HardCase> cases = casesFor(arguments);
    const bool asJson = arguments.has("json");
    listenForInterrupt();
    std::vector<HardRow> rows;
    for (const sim::HardCase &hard : cases) {
        if (!asJson)
            print(hardHeading(hard));
        for (const sim::MethodPtr &method : sim::allMethods()) {
            rows.push_back(rowOf(hard, method, arguments.has("full")));
            if (isInterrupted())
                return printInterrupted();
            if (!asJson) {
                print(hardLine(rows.back()));
                std::fflush(stdout); // some cases take long: show each row as soon as it is known
            }
        }
        print(asJson ? QString() : QStringLiteral("\n"));
    }
    print(asJson ? hardJson(rows) : hardSummary(rows));
    const bool anyBroken =
        std::any_of(rows.begin(), rows.end(), [](const HardRow &row) { return row.verdict.isBroken(); });
    return anyBroken ? exitNo : exitDone;
}

}
