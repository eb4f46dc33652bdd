#include "tests/app/scene/scene_support.h"

#include "lessons/api/creature.h"
#include "lessons/api/parameters.h"
#include "lessons/api/view/creature_view.h"
#include "sim/effects/contacts/walls.h"
#include "sim/effects/drags/damping.h"
#include "sim/effects/fields/gravity.h"
#include "sim/effects/springs/point_spring.h"
#include "sim/run/script/composed_interval.h"

#include <QApplication>
#include <QMouseEvent>
#include <QTest>
#include <QWheelEvent>

using namespace app;

namespace {

constexpr sim::Room room = {20.0, 520.0, 400.0, 0.6};

sim::Scene pulledCreature(const sim::Values &values)
{
    sim::Scene scene = scenes::creature(2);
    scenes::placeFeet(scene, {{310, 240}, {230, 250}});
    scenes::add<sim::PointSpring>(scene, 0, sim::Vec2{270, 200}, values["k"]);
    scenes::add<sim::Gravity>(scene, values["gravity"]);
    scenes::add<sim::Damping>(scene, values["damp"]);
    return scene;
}

sim::Scene creatureInARoom(const sim::Values &values)
{
    sim::Scene scene = pulledCreature(values);
    scenes::add<sim::Walls>(scene, room, scenes::halfWidths(scene));
    return scene;
}

sim::Scene loneFoot(const sim::Values &values)
{
    sim::Scene scene = scenes::singleFoot();
    scene.start.place(0, {300, 210});
    scenes::add<sim::PointSpring>(scene, 0, sim::Vec2{270, 200}, values["k"]);
    return scene;
}

lessons::Step stepCalled(const char *id, sim::Scene (*scene)(const sim::Values &))
{
    lessons::Step step;
    step.id = id;
    step.title = id;
    step.parameters = {lessons::stiffness(), lessons::damping(), lessons::gravity()};
    step.scene = scene;
    step.view = [](const sim::Scene &built, const sim::Values &) {
        return lessons::creatureViewWithLegs(built);
    };
    return step;
}

}

LessonLibrary sceneLibrary()
{
    lessons::Step inRoom = stepCalled("room", creatureInARoom);
    inRoom.view = [](const sim::Scene &scene, const sim::Values &) {
        lessons::View view = lessons::creatureViewWithLegs(scene);
        view.room = room;
        return view;
    };
    lessons::Step lone = stepCalled("lone", loneFoot);
    lone.view = [](const sim::Scene &scene, const sim::Values &) { return lessons::creatureView(scene); };
    lone.overlays = [](const sim::Scene &, const sim::State &state, const sim::Values &) {
        using Shape = lessons::Overlay::Shape;
        return std::vector<lessons::Overlay>{
            {.shape = Shape::ring, .a = {270, 200}, .size = 30.0},
            {.shape = Shape::line, .a = {270, 200}, .b = state.positionOf(0), .label = "dx"}};
    };
    LessonEntry entry;
    entry.id = "scene";
    entry.steps = {stepCalled("creature", pulledCreature), inRoom, lone};
    LessonLibrary library;
    library.lessons = {entry};
    return library;
}

namespace {

LessonLibrary sceneLibraryOf(std::vector<lessons::Step> steps)
{
    LessonEntry entry;
    entry.id = "scene";
    entry.steps = std::move(steps);
    LessonLibrary library;
    library.lessons = {entry};
    return library;
}

}

SceneFixture::SceneFixture(const char *step) : SceneFixture(sceneLibrary().lessons.front().steps)
{
    session.openStep("scene", step);
    QApplication::processEvents();
}

SceneFixture::SceneFixture(std::vector<lessons::Step> steps)
    : library(sceneLibraryOf(std::move(steps))), session(library), theme(Scheme::light), view(session, theme)
{
    QObject::connect(&fit, &QAction::triggered, &view, &SceneView::fit);
    view.resize(600, 470);
    view.show();
    view.setFocus();
    QApplication::processEvents();
}

void SceneFixture::goTo(std::int64_t frame)
{
    session.playback().goTo({frame, 0});
    QVERIFY(QTest::qWaitFor([&] { return !session.playback().goal(); }, 60'000));
}

QPoint SceneFixture::onScreen(const char *body) const
{
    const sim::Vec2 at = place(body);
    return view.viewportTransform().map(QPointF(at.x, at.y)).toPoint();
}

sim::Vec2 SceneFixture::place(const char *body) const
{
    const Picture picture = session.presentation().picture();
    return picture.state.positionOf(picture.interval->scene.find(body));
}

QImage SceneFixture::image()
{
    QImage image(view.size(), QImage::Format_RGB32);
    view.viewport()->render(&image);
    return image;
}

int SceneFixture::pixels(const QColor &color)
{
    const QImage picture = image();
    int count = 0;
    for (int y = 0; y < picture.height(); ++y) {
        for (int x = 0; x < picture.width(); ++x)
            count += picture.pixel(x, y) == color.rgb() ? 1 : 0;
    }
    return count;
}

void SceneFixture::move(QPoint to, Qt::MouseButton button)
{
    tests::moveMouse(*view.viewport(), to, button);
}

void SceneFixture::press(QPoint at, Qt::MouseButton button)
{
    QMouseEvent event(QEvent::MouseButtonPress, QPointF(at), QPointF(view.mapToGlobal(at)), button, button,
                      Qt::NoModifier);
    QApplication::sendEvent(view.viewport(), &event);
}

void SceneFixture::release(QPoint at, Qt::MouseButton button)
{
    QMouseEvent event(QEvent::MouseButtonRelease, QPointF(at), QPointF(view.mapToGlobal(at)), button,
                      Qt::NoButton, Qt::NoModifier);
    QApplication::sendEvent(view.viewport(), &event);
}

void SceneFixture::wheel(QPoint at, QPoint angle, QPoint pixels)
{
    QWheelEvent event(QPointF(at), QPointF(view.mapToGlobal(at)), pixels, angle, Qt::NoButton, Qt::NoModifier,
                      Qt::NoScrollPhase, false);
    QApplication::sendEvent(view.viewport(), &event);
}
