#include "app/ui/film/moment_picture.h"

#include "app/ui/film/step_alone.h"
#include "app/ui/scene/scene_view.h"

#include <QCoreApplication>
#include <QElapsedTimer>
#include <QResizeEvent>

namespace app {

namespace {

constexpr QSize momentSize{324, 240}; ///< the shape of the stage
constexpr double momentScale = 2.0;   ///< image px per px of the page
constexpr qint64 mostMilliseconds = 4000;

}

QImage pictureOfMoment(const Experiment &experiment, sim::Cursor at, const LessonLibrary &library)
{
    const LessonLibrary alone = stepAlone(experiment, library);
    Session session(alone);
    const Theme theme(Scheme::light);
    SceneView view(session, theme); // before the run goes on: it shows the area of the step
    view.setFixedSize(momentSize);
    QResizeEvent resized(momentSize, {}); // a hidden view gets no resize event, but needs its size
    QCoreApplication::sendEvent(&view, &resized);
    session.open(experiment);
    session.select({});
    session.playback().goTo(at);
    QElapsedTimer clock;
    clock.start();
    while (session.playback().goal() || session.presentation().isCompanionComing()) {
        if (clock.elapsed() > mostMilliseconds)
            return {};
        QCoreApplication::processEvents(QEventLoop::ExcludeUserInputEvents);
    }
    return view.picture(momentScale);
}

}
