#include "lessons/api/lesson.h"
#include "explanations.h"
#include "steps.h"

#include <QObject>

class HardCasesLesson : public QObject, public lessons::Lesson
{
    Q_OBJECT
    Q_PLUGIN_METADATA(IID SpringstepLesson_iid FILE "lesson.json")
    Q_INTERFACES(lessons::Lesson)

public:
    std::vector<lessons::Step> steps() const override
    {
        return lessons::taught({hard_cases::limitStep(), hard_cases::runawayStep(),
                                hard_cases::manyFeetStep(), hard_cases::onePlaceStep(),
                                hard_cases::stiffStep(), hard_cases::contradictionStep(),
                                hard_cases::longRunStep(), hard_cases::tortureStep()},
                               hard_cases::teaching());
    }
};

#include "lesson.moc"
