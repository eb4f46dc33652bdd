#include "app/cli/accuracy_plot.h"

#include "app/model/text/quoting.h"
#include "app/ui/accuracy/work_precision_plot.h"

#include <QCoreApplication>
#include <QLocale>

namespace app {

namespace {

struct AccuracyPlotText
{
    Q_DECLARE_TR_FUNCTIONS(AccuracyPlotText)
};

constexpr QSize plotSize(960, 568); ///< px; with its title the picture has 960x600

QString titleOf(const AccuracyReport &report)
{
    const sim::ReferenceRun &reference = report.found.reference;
    return AccuracyPlotText::tr("%1: %2 frames; reference %3, accurate to %4 px")
        .arg(report.experiment)
        .arg(report.found.horizon)
        .arg(QString::fromStdString(reference.method),
             withoutPadding(QString::number(reference.disagreement, 'g', 2)));
}

}

bool writeAccuracyPlot(QIODevice &file, const AccuracyReport &report, const Experiment &experiment,
                       const LessonLibrary &library)
{
    QLocale::setDefault(QLocale::c()); // the same picture in every country
    Session session(library);
    session.open(experiment);
    AccuracyStudy study(session.run(), session.editor(),
                        [&](const sim::Script &, const sim::StudyPlan &, const sim::StudyProgress &) {
                            return report.found; // measured already
                        });
    const Theme theme(Scheme::light);
    WorkPrecisionPlot plot(study, theme);
    plot.setTarget(report.tolerance.value_or(plot.target()));
    plot.resize(plotSize);
    plot.setAttribute(Qt::WA_DontShowOnScreen);
    plot.show();
    plot.replot(); // lays its axes out in this size, on which the places of the rows depend
    study.start();
    while (study.stage() == AccuracyStudy::Stage::measuring)
        QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
    PlotPicture picture = plot.picture();
    picture.title = titleOf(report);
    return writeSvg(file, picture, theme);
}

}
