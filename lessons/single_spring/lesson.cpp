#include "lessons/api/lesson.h"
#include "explanations.h"
#include "steps.h"

#include <QObject>

class SingleSpring : public QObject, public lessons::Lesson
{
    Q_OBJECT
    Q_PLUGIN_METADATA(IID SpringstepLesson_iid FILE "lesson.json")
    Q_INTERFACES(lessons::Lesson)

public:
    std::vector<lessons::Step> steps() const override
    {
        return lessons::taught({single_spring::dragStep(), single_spring::fixedCentreStep(),
                                single_spring::movingBodyStep(), single_spring::offsetStep(),
                                single_spring::radialStep()},
                               single_spring::teaching());
    }
};

#include "lesson.moc"
