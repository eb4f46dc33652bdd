#include "lessons/api/lesson.h"
#include "explanations.h"
#include "steps.h"

#include <QObject>

class MultiFoot : public QObject, public lessons::Lesson
{
    Q_OBJECT
    Q_PLUGIN_METADATA(IID SpringstepLesson_iid FILE "lesson.json")
    Q_INTERFACES(lessons::Lesson)

public:
    std::vector<lessons::Step> steps() const override
    {
        return lessons::taught(
            {multi_foot::twoFeetStep(), multi_foot::anyNumberStep(), multi_foot::grownFeetStep()},
            multi_foot::teaching());
    }
};

#include "lesson.moc"
