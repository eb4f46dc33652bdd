#include "app/ui/film/handout_export.h"

#include "app/model/experiment/experiment.h"
#include "app/model/files/whole_file.h"
#include "app/model/text/pdf.h"
#include "app/ui/dialogs/ask_file.h"
#include "app/ui/film/moment_picture.h"

#include <QCoreApplication>
#include <QProgressDialog>
#include <QTextDocument>

#include <algorithm>

namespace app {

namespace {

struct HandoutExportText
{
    Q_DECLARE_TR_FUNCTIONS(HandoutExportText)
};

}

HandoutPicture handoutPicture(const LessonLibrary &library)
{
    return [&library](const HandoutMoment &moment) {
        const Experiment experiment{
            .lesson = moment.lesson.id, .step = moment.step.id, .script = moment.script};
        return pictureOfMoment(experiment, {moment.frame, 0}, library);
    };
}

int handoutPictureCount(const LessonEntry &lesson)
{
    std::ptrdiff_t count = 0;
    for (const lessons::Step &step : lesson.steps) {
        count += 1 + std::ssize(step.predictions);
        count += std::count_if(step.predictions.begin(), step.predictions.end(), [](const auto &prediction) {
            return prediction.question.kind == lessons::Question::Kind::place;
        });
    }
    return static_cast<int>(count);
}

QString exportHandout(QWidget &window, const LessonEntry &lesson, const LessonLibrary &library)
{
    const QString path = askWhereToSave(&window, HandoutExportText::tr("Handout of the lesson"),
                                        lesson.id + ".pdf", HandoutExportText::tr("PDF (*.pdf)"));
    if (path.isEmpty())
        return {};
    QProgressDialog progress(HandoutExportText::tr("The pictures of “%1” are drawn…").arg(lesson.title),
                             HandoutExportText::tr("Cancel"), 0, handoutPictureCount(lesson), &window);
    progress.setWindowModality(Qt::WindowModal);
    const HandoutPicture draw = handoutPicture(library);
    QTextDocument document;
    const bool isWritten = writeHandout(
        document, lesson,
        [&](const HandoutMoment &moment) {
            progress.setValue(progress.value() + 1);
            return draw(moment);
        },
        [&] { return !progress.wasCanceled(); });
    if (!isWritten)
        return {};
    writeWholeFile(path, pdfOf(document, lesson.title));
    return path;
}

}
