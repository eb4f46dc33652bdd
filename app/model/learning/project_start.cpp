#include "app/model/learning/project_start.h"

#include <QFile>

namespace app {

Experiment projectStart(const LessonEntry &lesson, const LessonLibrary &library)
{
    QByteArray text = lesson.projectStart;
    QFile file(lessons::projectStartFile(lesson.id));
    if (text.isEmpty() && file.open(QIODevice::ReadOnly))
        text = file.readAll();
    return parseExperiment(text, lesson.id + QStringLiteral("/project.json"), library);
}

}
