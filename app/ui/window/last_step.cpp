#include "app/ui/window/last_step.h"

#include "app/model/session/session.h"

#include <QSettings>

namespace app {

namespace {

constexpr const char *lessonKey = "learn/lesson";
constexpr const char *stepKey = "learn/step";

}

LastStep LastStep::load()
{
    const QSettings settings;
    return {settings.value(lessonKey).toString(), settings.value(stepKey).toString()};
}

void LastStep::store(const OpenRun &run)
{
    if (run.isSandbox())
        return;
    QSettings settings;
    settings.setValue(lessonKey, run.lesson().id);
    settings.setValue(stepKey, run.step().id);
}

void LastStep::openIn(Session &session) const
{
    const LessonEntry *entry = session.library().lesson(lesson);
    if (entry && entry->step(step))
        session.openStep(lesson, step);
}

}
