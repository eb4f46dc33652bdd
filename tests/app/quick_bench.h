#pragma once

#include "app/ui/scene/scene_view.h"
#include "app/ui/window/main_window.h"
#include "tests/app/studies.h"

#include <QApplication>
#include <QtTest>

/// What suites of the whole window share: the window on the real lessons, with a study that takes no time.
namespace quick_bench {

using namespace app;

struct Bench
{
    LessonLibrary library = LessonLibrary::load({LESSON_DIR});
    Theme theme{Scheme::light};
    Session session{library};
    MainWindow window{session, theme, quickStudy};
    SceneView &view = *window.findChild<SceneView *>();

    explicit Bench(const char *lesson = "single_spring", const char *step = "fixed_centre")
    {
        theme.apply(*qApp);
        session.openStep(lesson, step);
        window.resize(1280, 800);
        window.show();
        QApplication::setActiveWindow(&window);
        view.setFocus();
        QCoreApplication::processEvents();
    }

    QPoint onScreen(const char *body) const
    {
        const Picture picture = session.picture();
        const sim::Vec2 at = picture.state.positionOf(picture.interval->scene.find(body));
        return view.mapFromScene(at.x, at.y);
    }
    std::int64_t frame() const { return session.timeline().cursor().frame; }
    int phase() const { return session.timeline().cursor().phase; }
};

}
