#pragma once

#include "app/ui/scene/scene_view.h"
#include "app/ui/window/main_window.h"

#include <QApplication>
#include <QtTest>

/// What suites of the whole window share: the window on the real lessons, with a study that takes no time.
namespace quick_bench {

using namespace app;

/// In place of a study that takes seconds: one row, and a reference 5 px from where the scene starts.
inline sim::Accuracy quickStudy(const sim::Script &script, const sim::StudyPlan &plan,
                                const sim::StudyProgress &)
{
    sim::Accuracy found;
    found.span = found.horizon = plan.frames;
    found.reference.disagreement = 2e-11;
    const sim::State start = sim::sceneOf(script, script.values).start;
    std::vector<sim::Vec2> places;
    for (int i = 0; i < start.points(); ++i)
        places.push_back(start.at(i) + sim::Vec2{3.0, 4.0});
    found.reference.places.assign(static_cast<std::size_t>(plan.frames + 1), places);
    sim::AccuracyRow row;
    row.way = *plan.inUse;
    row.outcome = sim::Outcome::measured;
    row.error = 3.7;
    row.nsPerFrame = 250.0;
    found.rows = {row};
    return found;
}

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
        const sim::Vec2 at = picture.state.at(picture.segment->scene.find(body));
        return view.mapFromScene(at.x, at.y);
    }
    std::int64_t frame() const { return session.timeline().at().frame; }
    int phase() const { return session.timeline().at().phase; }
};

}
