#include "lessons/api/lesson.h"
#include "steps.h"

#include <QObject>

class WalkingGait : public QObject, public lessons::Lesson
{
    Q_OBJECT
    Q_PLUGIN_METADATA(IID SpringstepLesson_iid FILE "lesson.json")
    Q_INTERFACES(lessons::Lesson)

public:
    std::vector<lessons::Step> steps() const override
    {
        using namespace walking_gait;
        return {bonesStep(),    legsStep(),       feetBelowStep(), curvedLegsStep(),
                swingStep(),    bodyPulledStep(), groundStep(),    moreFeetStep(),
                steeringStep(), wallsStep(),      companyStep()};
    }
};

#include "lesson.moc"
