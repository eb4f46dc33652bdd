#include "lessons/api/lesson.h"
#include "steps.h"

#include <QObject>

class RigidConstraint : public QObject, public lessons::Lesson
{
    Q_OBJECT
    Q_PLUGIN_METADATA(IID SpringstepLesson_iid FILE "lesson.json")
    Q_INTERFACES(lessons::Lesson)

public:
    std::vector<lessons::Step> steps() const override
    {
        using namespace rigid_constraint;
        return {pairStep(), sharedErrorStep(), triangleStep(), listStep(), verletStep(), ragdollStep()};
    }
};

#include "lesson.moc"
