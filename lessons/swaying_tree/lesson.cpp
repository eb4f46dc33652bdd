#include "lessons/api/lesson.h"
#include "steps.h"

#include <QObject>

class SwayingTree : public QObject, public lessons::Lesson
{
    Q_OBJECT
    Q_PLUGIN_METADATA(IID SpringstepLesson_iid FILE "lesson.json")
    Q_INTERFACES(lessons::Lesson)

public:
    std::vector<lessons::Step> steps() const override
    {
        using namespace swaying_tree;
        return {trunkStep(), branchesStep(), randomnessStep(), towardsPointerStep(), windStep(),
                restStep(),  distanceStep(), thicknessStep(),  turbulenceStep(),     realSwayStep()};
    }
};

#include "lesson.moc"
