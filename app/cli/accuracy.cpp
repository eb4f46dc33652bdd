#include "app/cli/accuracy_plot.h"
#include "app/cli/accuracy_report.h"
#include "app/cli/experiment_argument.h"
#include "app/cli/option_values.h"
#include "app/cli/terminal.h"
#include "app/model/run/run_program.h"
#include "app/model/text/quoting.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QSaveFile>

#include <algorithm>
#include <limits>

namespace app {

namespace {

struct AccuracyText
{
    Q_DECLARE_TR_FUNCTIONS(AccuracyText)
};

constexpr double mostFramesStudied = 10'000;
/// The most frames of a file that are studied by default. More take long and show little more.
constexpr std::int64_t mostFramesOfFile = 1000;

sim::StudyPlan planFor(std::optional<double> frames, bool isFile, const Experiment &experiment)
{
    sim::StudyPlan plan;
    if (frames)
        plan.frames = std::llround(*frames);
    else if (isFile)
        plan.frames = std::clamp<std::int64_t>(experiment.frames, 1, mostFramesOfFile);
    plan.secondsToPreview = std::numeric_limits<double>::infinity(); // nothing shows a preview
    plan.inUse = sim::MethodSetup{experiment.script.method, experiment.script.step};
    return plan;
}

sim::Accuracy study(const Experiment &experiment, const sim::StudyPlan &plan)
{
    listenForInterrupt();
    TerminalLine status;
    return sim::studyAccuracy(experiment.script, plan, [&status](const sim::Accuracy &, double done) {
        if (status.isDue())
            status.show(AccuracyText::tr("Measured %1 %").arg(std::lround(100.0 * done)));
        return !isInterrupted();
    });
}

/// @throws UserError: the file cannot be written
void writePlot(const QString &path, const AccuracyReport &report, const Experiment &experiment,
               const LessonLibrary &library)
{
    QSaveFile file(path);
    if (!file.open(QIODevice::WriteOnly) || !writeAccuracyPlot(file, report, experiment, library) ||
        !file.commit())
        throw UserError(
            AccuracyText::tr("%1: the picture could not be written: %2. Choose another folder or name.")
                .arg(shownPath(path), oneLine(file.errorString())));
}

}

int runAccuracy(const Arguments &arguments)
{
    const auto number = [&](const char *option, double least, double most) {
        return arguments.has(option) ? std::optional(numberOption(arguments, option, least, most))
                                     : std::nullopt;
    };
    const QString name = arguments.names[0];
    const std::optional<double> tolerance = number("tolerance", 1e-12, 1e6);
    const std::optional<double> frames = number("frames", 1, mostFramesStudied);
    const QString plot = arguments.value("svg");
    if (!plot.isEmpty() && !plot.endsWith(QStringLiteral(".svg"), Qt::CaseInsensitive))
        throw UsageError(
            AccuracyText::tr("%1 is not the name of a plot; it ends in .svg.").arg(quoted(plot)));
    const LessonLibrary library = LessonLibrary::load(LessonLibrary::folders());
    const Experiment experiment = experimentFor(name, library);
    if (programOf(experiment.script.method))
        throw UserError(
            AccuracyText::tr("%1: the run is computed by code, which has no shorter steps to compare with. "
                             "Remove \"method\" and \"code\" to measure the methods.")
                .arg(shownPath(name)));
    const sim::StudyPlan plan = planFor(frames, QFileInfo::exists(name), experiment);
    const AccuracyReport report{name, tolerance, *plan.inUse, study(experiment, plan)};
    if (isInterrupted())
        return printInterrupted();
    if (!plot.isEmpty())
        writePlot(plot, report, experiment, library);
    print(arguments.has("json") ? accuracyJson(report) : accuracyTable(report));
    return tolerance && !report.found.cheapest(*tolerance) ? exitNo : exitDone;
}

}
