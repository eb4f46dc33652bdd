#include "app/ui/scene/thumbnail.h"

#include "app/ui/scene/scene_view.h"

namespace app {

namespace {

constexpr int enlargement = 4; ///< lines and dots are made for pictures this much larger

/// A lesson with nothing but this step, which begins with these values.
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
    session.goTo({frames, 0});
    return QPixmap::fromImage(
        view.picture().scaled(size, Qt::KeepAspectRatioByExpanding, Qt::SmoothTransformation));
}

}
