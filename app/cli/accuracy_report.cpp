#include "app/cli/accuracy_report.h"

#include "app/model/analysis/accuracy_study.h"
#include "app/model/text/quoting.h"
#include "app/model/text/sentences.h"
#include "sim/pipeline/method.h"

#include <QCoreApplication>

namespace app {

namespace {

struct AccuracyReportText
{
    Q_DECLARE_TR_FUNCTIONS(AccuracyReportText)
};

QString id(const sim::MethodSetup &setup)
{
    return QString::fromStdString(setup.method->id());
}

QString setupText(const sim::MethodSetup &setup)
{
    return id(setup) + ", " + stepText(setup.step);
}

QString shortNumber(double value)
{
    return withoutPadding(QString::number(value, 'g', 3));
}

QString microseconds(double ns)
{
    return shortNumber(ns / 1000.0);
}

const sim::AccuracyRow *rowOf(const sim::Accuracy &found, const sim::MethodSetup &setup)
{
    for (const sim::AccuracyRow &row : found.rows) {
        if (sameSetup(row.setup, setup))
            return &row;
    }
    return nullptr;
}

QString titleLine(const QString &method)
{
    return method.leftJustified(22) + AccuracyReportText::tr("step").leftJustified(16) +
           AccuracyReportText::tr("error, px").rightJustified(11) +
           AccuracyReportText::tr("forces/frame").rightJustified(14) +
           AccuracyReportText::tr("ns/frame").rightJustified(12) +
           AccuracyReportText::tr("+-").rightJustified(9) + '\n';
}

QString rowLine(const sim::AccuracyRow &row, const sim::MethodSetup &inUse)
{
    QString line = id(row.setup).leftJustified(22) + stepText(row.setup.step).leftJustified(16);
    if (row.outcome == sim::Outcome::unstable)
        return line + AccuracyReportText::tr("unstable").rightJustified(11) + '\n';
    if (row.outcome == sim::Outcome::tooLong)
        return line + AccuracyReportText::tr("takes too long").rightJustified(16) + '\n';
    if (row.outcome != sim::Outcome::measured)
        return {};
    line += shortNumber(row.error).rightJustified(11) +
            QString::number(row.evaluations, 'f', 2).rightJustified(14) +
            QString::number(row.nsPerFrame, 'f', 0).rightJustified(12) +
            QString::number(row.spread, 'f', 0).rightJustified(9);
    line += row.front ? QStringLiteral("  *") : QString();
    return line + (sameSetup(row.setup, inUse) ? "  " + AccuracyReportText::tr("in use") : QString()) + '\n';
}

/// Returns a line per row, and the reason for a method that cannot compute the scene.
QString rowLines(const AccuracyReport &report)
{
    QString text;
    const sim::Method *refused = nullptr;
    for (const sim::AccuracyRow &row : report.found.rows) {
        text += rowLine(row, report.inUse);
        if (row.outcome != sim::Outcome::doesNotFit || refused == row.setup.method.get())
            continue;
        refused = row.setup.method.get();
        text += id(row.setup).leftJustified(22) + sentenceFor(*row.why) + '\n';
    }
    return text;
}

QString referenceSentence(const sim::ReferenceRun &reference)
{
    const QString apart = shortNumber(reference.disagreement);
    if (reference.discontinuity)
        return AccuracyReportText::tr("This scene has no exact motion to compare with, because %1 acts once "
                                      "per step. Each method is therefore compared with itself at a finer "
                                      "step (%2), which differs by up to %3 px from the next coarser one.")
            .arg(quoted(QString::fromStdString(reference.discontinuity->id())), stepText(reference.step),
                 apart);
    return AccuracyReportText::tr(
               "Errors are distances from %1 (%2). Its check, %3 (%4), differs from it by up to %5 px.")
        .arg(QString::fromStdString(reference.method), stepText(reference.step),
             QString::fromStdString(reference.check), stepText(reference.checkStep), apart);
}

QString horizonSentence(const sim::Accuracy &found)
{
    const QString start =
        AccuracyReportText::tr("Errors are given up to frame %1 of %2").arg(found.horizon).arg(found.span);
    switch (found.reference.end) {
    case sim::ReferenceRun::End::span:
        break;
    case sim::ReferenceRun::End::diverged:
        return start + AccuracyReportText::tr(": after that, the reference and its check disagree.");
    case sim::ReferenceRun::End::notFinite:
        return start + AccuracyReportText::tr(": after that, the reference is no longer finite.");
    case sim::ReferenceRun::End::tooLong:
        return start + AccuracyReportText::tr(": computing the reference beyond that would take too long.");
    }
    return start + '.';
}

QString cheapestSentence(const sim::Accuracy &found, double error)
{
    const QString within = shortNumber(error);
    const sim::AccuracyRow *row = found.cheapest(error);
    if (!row)
        return AccuracyReportText::tr("No method stays within an error of %1 px.").arg(within);
    return AccuracyReportText::tr("The cheapest way to stay within an error of %1 px costs %2 \u00b5s a "
                                  "frame: %3, with an error of %4 px.")
        .arg(within, microseconds(row->nsPerFrame), setupText(row->setup), shortNumber(row->error));
}

QString inUseSentence(const AccuracyReport &report)
{
    const sim::AccuracyRow *row = rowOf(report.found, report.inUse);
    if (!row || row->outcome != sim::Outcome::measured)
        return AccuracyReportText::tr("No error was measured for the method in use, %1: see the table.")
            .arg(setupText(report.inUse));
    return AccuracyReportText::tr("The method in use, %1, costs %2 \u00b5s a frame, with an error of %3 px.")
        .arg(setupText(report.inUse), microseconds(row->nsPerFrame), shortNumber(row->error));
}

}

QString stepText(sim::StepSize step)
{
    return step.isAdaptive() ? AccuracyReportText::tr("tolerance %1").arg(toleranceNumber(step.tolerance))
                             : AccuracyReportText::tr("h %1").arg(exactNumber(step.h));
}

QString accuracyTable(const AccuracyReport &report)
{
    const sim::Accuracy &found = report.found;
    QStringList lines = {report.experiment, referenceSentence(found.reference), horizonSentence(found), {}};
    lines.push_back(titleLine(AccuracyReportText::tr("method")) + rowLines(report));
    lines.push_back(AccuracyReportText::tr("* on the front: nothing cheaper is as accurate."));
    if (found.noisy())
        lines.push_back(AccuracyReportText::tr("This machine is busy with other things: times vary by %1 %.")
                            .arg(std::lround(100.0 * found.noise)));
    if (found.isExact())
        lines.push_back(
            AccuracyReportText::tr("Nothing moves here unless you do something, so there is no error to "
                                   "measure. Save a run in which you do something, and measure that file."));
    else if (found.horizon > 0)
        lines += {cheapestSentence(found, report.tolerance.value_or(0.1)), inUseSentence(report)};
    return lines.join('\n') + '\n';
}

}
