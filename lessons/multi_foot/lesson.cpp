#include "lessons/api/lesson.h"
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
        return {multi_foot::twoFeetStep(), multi_foot::anyNumberStep(), multi_foot::grownFeetStep()};
    }
};

#include "lesson.moc"
