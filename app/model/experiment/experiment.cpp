#include "app/model/experiment/experiment.h"

#include "app/model/files/whole_file.h"
#include "app/model/text/quoting.h"

#include <QCoreApplication>
#include <QFileInfo>

namespace app {

namespace {

struct ExperimentText
{
    Q_DECLARE_TR_FUNCTIONS(ExperimentText)
};

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
    return parseExperiment(readWholeFile(path, largestExperiment), QFileInfo(path).fileName(), library);
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
