// How scenes of many creatures are shown.

#include "app/ui/scene/drawing/arrows.h"
#include "lessons/api/creature.h"
#include "lessons/api/view/creature_view.h"
#include "sim/effects/fields/gravity.h"
#include "tests/app/scene/drawn_scenes.h"
#include "tests/app/scene/scene_support.h"
#include "tests/suite.h"

#include <QSignalSpy>
#include <QTest>

using namespace app;

namespace {

/// A step with the parameter "creatures", each of a body and two feet at rest, spread over a room that is so many
/// times as wide.
lessons::Step crowdStep()
{
    lessons::Step step;
    step.id = step.title = "crowd";
    lessons::Parameter creatures;
    creatures.id = "creatures";
    creatures.defaultValue = 5.0;
    creatures.min = 1.0;
    creatures.max = 1e5;
    creatures.isInteger = true;
    step.parameters = {creatures};
    step.method = "semi_implicit_euler";
    step.scene = [](const sim::Values &values) {
        const int count = values.integer("creatures");
        sim::Scene scene = scenes::crowdByParts(count, 2);
        for (int i = 0; i < count; ++i) {
            const double x = 100.0 * (i % 40) + 50.0;
            const double y = 100.0 * (i / 40) + 50.0;
            scene.start.place(i, {x, y});
            scene.start.place(count + i, {x - 20.0, y + 30.0});
            scene.start.place(2 * count + i, {x + 20.0, y + 30.0});
        }
        scenes::add<sim::Gravity>(scene, 0.1);
        return scene;
    };
    step.view = [](const sim::Scene &scene, const sim::Values &values) {
        const int count = values.integer("creatures");
        lessons::View view = lessons::crowdByPartsView(scene, count);
        view.stage = QRectF(0, 0, 100.0 * std::min(count, 40), 100.0 * (1 + count / 40));
        view.room = sim::Room{0.0, view.stage.right(), view.stage.bottom(), 1.0};
        return view;
    };
    return step;
}

struct Fixture : SceneFixture
{
    explicit Fixture(int creatures) : SceneFixture(std::vector{crowdStep()})
    {
        session.editor().setParameter("creatures", creatures);
        QApplication::processEvents();
    }
};

/// How dark a picture is at a place, from 0 to 255.
int darkness(const QImage &image, QPoint at)
{
    return 255 - qGray(image.pixel(at));
}

}

class SceneCrowdTest : public QObject
{
    Q_OBJECT

private slots:
    void aSceneThatGrowsIsShownWhole();
    void aPictureThatWasMovedStaysWhereItIs();
    void everyBodyIsInThePicture();
    void legsLeadFromBodiesToFeet();
    void onlyTheSelectedBodyHasArrows();
    void aCrowdLeavesNoTrail();
    void goingBackRestoresTheExactState();
};

void SceneCrowdTest::aSceneThatGrowsIsShownWhole()
{
    Fixture fixture(5);
    const double before = fixture.view.zoom();
    fixture.session.editor().setParameter("creatures", 800);
    QVERIFY(fixture.view.zoom() < 0.5 * before);
    const QRect view = fixture.view.viewport()->rect();
    for (const QPointF corner : {QPointF(0, 0), QPointF(4000, 0), QPointF(0, 2100), QPointF(4000, 2100)})
        QVERIFY(view.contains(fixture.view.viewportTransform().map(corner).toPoint()));
    fixture.session.editor().setParameter("creatures", 5);
    QCOMPARE(fixture.view.zoom(), before);
}

void SceneCrowdTest::aPictureThatWasMovedStaysWhereItIs()
{
    Fixture fixture(5);
    fixture.view.zoomIn();
    const QTransform before = fixture.view.viewportTransform();
    fixture.session.editor().setParameter("creatures", 800);
    QVERIFY(fixture.view.viewportTransform() == before);
}

void SceneCrowdTest::everyBodyIsInThePicture()
{
    Fixture fixture(800);
    const QImage image = fixture.image();
    for (int i = 120; i < 800; ++i) { // before, the name of the selected one lies over some
        const QPoint at = fixture.onScreen(("creature" + std::to_string(i) + ".body").c_str());
        QVERIFY2(darkness(image, at) > 100, qPrintable(QString::number(i)));
    }
}

/// Zoomed in, so that the middle of a leg is far from both discs.
void SceneCrowdTest::legsLeadFromBodiesToFeet()
{
    Fixture fixture(800);
    const QString body = "creature410.body";
    fixture.view.bringBack(body);
    while (fixture.view.zoom() < 150.0)
        fixture.view.zoomIn();
    fixture.view.bringBack(body);
    const QImage image = fixture.image();
    for (const char *foot : {"creature410.foot0", "creature410.foot1"}) {
        const QPoint middle = 0.25 * fixture.onScreen("creature410.body") + 0.75 * fixture.onScreen(foot);
        QVERIFY(darkness(image, middle) > 80);
    }
    const QPoint between =
        0.5 * (fixture.onScreen("creature410.foot0") + fixture.onScreen("creature410.foot1"));
    QVERIFY(darkness(image, between) < 40);
}

void SceneCrowdTest::onlyTheSelectedBodyHasArrows()
{
    Fixture fixture(300);
    fixture.session.playback().frameForward();
    Extras extras = fixture.view.extras();
    extras.velocities = true;
    fixture.view.setExtras(extras);
    const Camera camera(fixture.view.viewportTransform());
    const auto arrows = velocityArrows(fixture.view.shown(), camera, fixture.theme);
    QCOMPARE(arrows.size(), std::size_t(1));
    fixture.session.editor().setParameter("creatures", 20);
    QCOMPARE(velocityArrows(fixture.view.shown(), camera, fixture.theme).size(), std::size_t(60));
}

void SceneCrowdTest::aCrowdLeavesNoTrail()
{
    Fixture few(20);
    Fixture many(300);
    for (int i = 0; i < 5; ++i) {
        few.session.playback().frameForward();
        many.session.playback().frameForward();
    }
    QVERIFY(few.view.shown().trail.marks().size() > 1);
    QVERIFY(many.view.shown().trail.marks().empty());
}

/// Back in slices, from a moment that is kept: as many frames apart as the history's memory wants it.
void SceneCrowdTest::goingBackRestoresTheExactState()
{
    Fixture fixture(20'000);
    fixture.goTo(90);
    QVERIFY(fixture.session.timeline().track().keyframeCount() > 0);
    QVERIFY(fixture.session.timeline().track().keyframeCount() < 60);
    sim::Track straight(fixture.session.timeline().script(), 0);
    for (const std::int64_t frame : {61, 60, 13, 89, 0}) {
        fixture.goTo(frame);
        straight.seek({frame, 0});
        QCOMPARE(fixture.session.timeline().cursor().frame, frame);
        QVERIFY(sim::sameBits(fixture.session.timeline().state(), straight.state()));
    }
}

SUITE(tst_scene_crowd, SceneCrowdTest)
#include "tst_scene_crowd.moc"
