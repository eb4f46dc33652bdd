#include "lessons/api/lesson.h"
#include "steps.h"

#include <QObject>

class TwoBody : public QObject, public lessons::Lesson
{
    Q_OBJECT
    Q_PLUGIN_METADATA(IID SpringstepLesson_iid FILE "lesson.json")
    Q_INTERFACES(lessons::Lesson)

public:
    std::vector<lessons::Step> steps() const override
    {
        using namespace two_body;
        return {mutualStep(), legLineStep()};
    }
};

#include "lesson.moc"
