#include "lessons/api/lesson.h"
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
        using namespace hard_cases;
        return {limitStep(), runawayStep(),       manyFeetStep(), onePlaceStep(),
                stiffStep(), contradictionStep(), longRunStep(),  tortureStep()};
    }
};

#include "lesson.moc"
