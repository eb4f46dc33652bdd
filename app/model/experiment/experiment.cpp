#include "app/model/experiment/experiment.h"

#include "app/model/files/whole_file.h"
#include "app/model/text/quoting.h"

#include <QCoreApplication>
#include <QFile>
#include <QFileInfo>

namespace app {

namespace {

struct ExperimentText
{
    Q_DECLARE_TR_FUNCTIONS(ExperimentText)
};

[[noreturn]] void refuseLarge(const QString &path)
{
    throw UserError(ExperimentText::tr("%1: the file is larger than %2 MiB, the maximum for an experiment.")
                        .arg(shownPath(path), QString::number(largestExperiment >> 20)));
}

QByteArray readFile(const QString &path)
{
    const QFileInfo info(path);
    if (info.isDir())
        throw UserError(
            ExperimentText::tr("%1: this is a folder; give the file of an experiment.").arg(shownPath(path)));
    if (!info.exists())
        throw UserError(
            ExperimentText::tr("%1: there is no such file; check its name and folder.").arg(shownPath(path)));
    if (info.size() > largestExperiment)
        refuseLarge(path);
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        throw UserError(ExperimentText::tr("%1: the file could not be read: %2.")
                            .arg(shownPath(path), oneLine(file.errorString())));
    // Pipes and devices do not report a size in advance.
    const QByteArray text = file.read(largestExperiment + 1);
    if (file.error() != QFileDevice::NoError)
        throw UserError(ExperimentText::tr("%1: the file could not be read: %2.")
                            .arg(shownPath(path), oneLine(file.errorString())));
    if (text.size() > largestExperiment)
        refuseLarge(path);
    return text;
}

}

QString lessonIds(const LessonLibrary &library, const QString &given)
{
    QStringList ids;
    for (std::size_t i = 0; i < library.entries(); ++i)
        ids.push_back(library.entry(i).id);
    return quotedList(ids, given);
}

QString stepIds(const LessonEntry &lesson, const QString &given)
{
    QStringList ids;
    for (const lessons::Step &step : lesson.steps)
        ids.push_back(step.id);
    return quotedList(ids, given);
}

QString noLesson(const QString &id, const LessonLibrary &library)
{
    if (library.lessons.empty())
        return ExperimentText::tr(
                   "there is no lesson %1, as no lesson is installed; SPRINGSTEP_LESSONS can name the folder "
                   "that has them.")
            .arg(quoted(id));
    return ExperimentText::tr("there is no lesson %1; there is %2.").arg(quoted(id), lessonIds(library, id));
}

QString noStep(const QString &id, const LessonEntry &lesson)
{
    return ExperimentText::tr("the lesson %1 has no step %2; it has %3.")
        .arg(quoted(lesson.id), quoted(id), stepIds(lesson, id));
}

Experiment readExperiment(const QString &path, const LessonLibrary &library)
{
    return parseExperiment(readFile(path), QFileInfo(path).fileName(), library);
}

void writeExperiment(const QString &path, const Experiment &experiment, const LessonLibrary &library)
{
    writeWholeFile(path, experimentText(experiment, library));
}

Experiment newExperiment(const QString &lesson, const QString &step, const LessonLibrary &library)
{
    const LessonEntry *entry = library.lesson(lesson);
    const auto sentence = [](QString text) { return text.replace(0, 1, text.at(0).toUpper()); };
    if (!entry)
        throw UserError(sentence(noLesson(lesson, library)));
    const lessons::Step *found = entry->step(step);
    if (!found)
        throw UserError(sentence(noStep(step, *entry)));
    Experiment experiment;
    experiment.lesson = lesson;
    experiment.step = step;
    experiment.script = found->script();
    return experiment;
}

}
