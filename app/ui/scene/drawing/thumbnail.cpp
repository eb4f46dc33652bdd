#include "app/ui/scene/drawing/thumbnail.h"

#include "app/ui/scene/scene_view.h"

namespace app {

namespace {

constexpr int enlargement = 4; ///< line widths and dots are designed for images larger by this factor

/// Returns a library with one lesson that has only this step, with the given values.
LessonLibrary libraryOf(lessons::Step step, const sim::Values &values)
{
    for (lessons::Parameter &parameter : step.parameters)
        parameter.defaultValue = values[parameter.id.toStdString()];
    step.tries.clear();
    step.measures.clear();
    LessonEntry entry;
    entry.steps = {std::move(step)};
    LessonLibrary library;
    library.lessons = {std::move(entry)};
    return library;
}

}

QPixmap thumbnail(const lessons::Step &step, const sim::Values &values, const Theme &theme, QSize size,
                  int frames)
{
    const LessonLibrary library = libraryOf(step, values);
    Session session(library);
    SceneView view(session, theme);
    view.resize(enlargement * size);
    view.setExtras({false, false, false, false, true, false, false});
    view.fit();
    session.playback().goTo({frames, 0});
    return QPixmap::fromImage(
        view.picture().scaled(size, Qt::KeepAspectRatioByExpanding, Qt::SmoothTransformation));
}

}
