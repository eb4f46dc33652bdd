#include "lessons/api/lesson.h"
#include "explanations.h"
#include "steps.h"

#include <QObject>

class AccuracyLesson : public QObject, public lessons::Lesson
{
    Q_OBJECT
    Q_PLUGIN_METADATA(IID SpringstepLesson_iid FILE "lesson.json")
    Q_INTERFACES(lessons::Lesson)

public:
    std::vector<lessons::Step> steps() const override
    {
        return lessons::taught({accuracy::bigStep(), accuracy::energyStep(), accuracy::halveStep(),
                                accuracy::adaptStep(), accuracy::bounceStep(), accuracy::budgetStep(),
                                accuracy::crowdStep()},
                               accuracy::teaching());
    }
};

#include "lesson.moc"
