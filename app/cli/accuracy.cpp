#include "app/cli/accuracy.h"

#include "app/cli/accuracy_plot.h"
#include "app/cli/accuracy_report.h"
#include "app/cli/experiment_named.h"
#include "app/cli/terminal.h"
#include "app/model/sentences.h"
#include "app/model/words.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QSaveFile>

#include <algorithm>
#include <limits>

namespace app {

namespace {

struct Text
{
    Q_DECLARE_TR_FUNCTIONS(Accuracy)
};

sim::StudyPlan planFor(const AccuracyRequest &request, const Experiment &experiment)
{
    sim::StudyPlan plan;
    if (request.frames)
        plan.frames = *request.frames;
    else if (QFileInfo::exists(request.what))
        plan.frames = std::clamp<std::int64_t>(experiment.frames, 1, mostOwnFrames);
    plan.secondsToPreview = std::numeric_limits<double>::infinity(); // nobody watches
    plan.inUse = sim::MethodSetup{experiment.script.method, experiment.script.step};
    return plan;
}

sim::Accuracy study(const Experiment &experiment, const sim::StudyPlan &plan)
{
    listenForInterrupt();
    StatusLine status;
    return sim::studyAccuracy(experiment.script, plan, [&status](const sim::Accuracy &, double done) {
        if (status.isDue())
            status.show(Text::tr("Measured %1 %").arg(std::lround(100.0 * done)));
        return !isInterrupted();
    });
}

void writePlot(const QString &path, const AccuracyReport &report)
{
    QSaveFile file(path);
    const QByteArray picture = accuracyPlot(report);
    if (!file.open(QIODevice::WriteOnly) || file.write(picture) != picture.size() || !file.commit())
        throw Refusal(Text::tr("%1: the picture cannot be written: %2. Choose another folder or name.")
                          .arg(shownPath(path), oneLine(file.errorString())));
}

int answer(const AccuracyRequest &request, const LessonLibrary &library)
{
    const Experiment experiment = experimentNamed(request.what, library);
    const sim::StudyPlan plan = planFor(request, experiment);
    const AccuracyReport report{request.what, request.tolerance, *plan.inUse, study(experiment, plan)};
    if (isInterrupted()) {
        say(Text::tr("Stopped before everything was measured."));
        return exitInterrupted;
    }
    if (!request.svg.isEmpty())
        writePlot(request.svg, report);
    print(request.asJson ? accuracyJson(report) : accuracyTable(report));
    return request.tolerance && !report.found.cheapest(*request.tolerance) ? exitNo : exitDone;
}

}

int accuracy(const AccuracyRequest &request)
{
    try {
        return answer(request, LessonLibrary::load(LessonLibrary::folders()));
    } catch (const Refusal &refusal) {
        say(refusal.sentence());
    } catch (const sim::Error &error) {
        say(sentenceFor(error));
    }
    return exitBadUse;
}

}
