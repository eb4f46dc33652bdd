#pragma once

#include "app/model/session/session.h"
#include "app/ui/actions/command.h"
#include "app/ui/scene/scene_view.h"
#include "tests/app/support/user_input.h"

/// Returns a library with one lesson: "creature" (two feet and a body, spring and
/// gravity), "room" (the same between walls) and "lone" (one foot, with a guide).
app::LessonLibrary sceneLibrary();

/// The scene of the window, 600 x 470 px, shown alone.
struct SceneFixture
{
    app::LessonLibrary library;
    app::Session session;
    app::Theme theme; // the application keeps its own style: the scene draws everything itself
    app::SceneView view;
    app::Command fit{"Fit", {}, &view}; ///< for the bar above the scene

    explicit SceneFixture(const char *step = "creature");
    /// Opens the first of these steps in place of those of sceneLibrary().
    explicit SceneFixture(std::vector<lessons::Step> steps);

    /// Goes to a frame and waits until it is there: distant frames are computed in slices.
    void goTo(std::int64_t frame);
    /// Returns where a body is in the viewport, px.
    QPoint onScreen(const char *body) const;
    sim::Vec2 place(const char *body) const;
    QImage image();
    /// Returns how many pixels of the picture have exactly this colour.
    int pixels(const QColor &color);
    void move(QPoint to, Qt::MouseButton button = Qt::LeftButton);
    void press(QPoint at, Qt::MouseButton button = Qt::LeftButton);
    void release(QPoint at, Qt::MouseButton button = Qt::LeftButton);
    void wheel(QPoint at, QPoint angle, QPoint pixels = {});
};
