#include "lessons/api/lesson.h"
#include "explanations.h"
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
        return lessons::taught({two_body::mutualStep(), two_body::legLineStep()}, two_body::teaching());
    }
};

#include "lesson.moc"
