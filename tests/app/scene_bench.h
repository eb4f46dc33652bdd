#pragma once

#include "app/model/session.h"
#include "app/ui/scene/scene_view.h"

#include <QTemporaryDir>

/// A library with one lesson made for the tests of the scene: "creature" (two feet and a body, spring and
/// gravity), "room" (the same between walls) and "lone" (one foot, with a guide).
app::LessonLibrary sceneLibrary();

/// Keeps the settings of whoever runs the tests out of them.
void useOwnSettings(const QTemporaryDir &folder);

/// A session, a theme and a view of 600 x 470 px, as the window has it.
struct SceneBench
{
    app::LessonLibrary library;
    app::Session session;
    app::Theme theme;
    app::SceneView view;

    explicit SceneBench(const char *step = "creature");
    /// With these steps in place of the library's, the first one open.
    explicit SceneBench(std::vector<lessons::Step> steps);

    /// Goes to a frame, and waits until it is there: far ones are approached in slices.
    void goTo(std::int64_t frame);
    /// Where a body is on the screen.
    QPoint onScreen(const char *body) const;
    sim::Vec2 place(const char *body) const;
    QImage image();
    /// How many pixels of the picture have exactly this colour.
    int pixels(const QColor &color);
    void move(QPoint to, Qt::MouseButton button = Qt::LeftButton);
    void press(QPoint at, Qt::MouseButton button = Qt::LeftButton);
    void release(QPoint at, Qt::MouseButton button = Qt::LeftButton);
    void wheel(QPoint at, QPoint angle, QPoint pixels = {});
};
