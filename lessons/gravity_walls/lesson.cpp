#include "lessons/api/lesson.h"
#include "steps.h"

#include <QObject>

class GravityWalls : public QObject, public lessons::Lesson
{
    Q_OBJECT
    Q_PLUGIN_METADATA(IID SpringstepLesson_iid FILE "lesson.json")
    Q_INTERFACES(lessons::Lesson)

public:
    std::vector<lessons::Step> steps() const override
    {
        using namespace gravity_walls;
        return {wallsStep(), gravityStep()};
    }
};

#include "lesson.moc"
