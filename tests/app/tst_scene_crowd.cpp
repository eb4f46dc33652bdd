// How scenes of many creatures are shown.

#include "app/ui/scene/arrows.h"
#include "lessons/api/creature.h"
#include "lessons/api/view/creature_view.h"
#include "look_scenes.h"
#include "scene_bench.h"
#include "sim/effects/fields/gravity.h"

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
        lessons::View look = lessons::crowdByPartsView(scene, count);
        look.stage = QRectF(0, 0, 100.0 * std::min(count, 40), 100.0 * (1 + count / 40));
        look.room = sim::Room{0.0, look.stage.right(), look.stage.bottom(), 1.0};
        return look;
    };
    return step;
}

struct Bench : SceneBench
{
    explicit Bench(int creatures) : SceneBench(std::vector{crowdStep()})
    {
        session.setParameter("creatures", creatures);
        QApplication::processEvents();
    }
};

/// How dark a picture is at a place, from 0 to 255.
int ink(const QImage &image, QPoint at)
{
    return 255 - qGray(image.pixel(at));
}

}

class SceneCrowdTest : public QObject
{
    Q_OBJECT

    QTemporaryDir m_settings;

private slots:
    void initTestCase() { useOwnSettings(m_settings); }

    void aSceneThatGrowsIsShownWhole();
    void aPictureThatWasMovedStaysWhereItIs();
    void everyBodyIsInThePicture();
    void legsLeadFromBodiesToFeet();
    void onlyTheSelectedBodyHasArrows();
    void aCrowdLeavesNoTrail();
    void goingBackComesToTheVeryState();
};

void SceneCrowdTest::aSceneThatGrowsIsShownWhole()
{
    Bench bench(5);
    const double before = bench.view.zoom();
    bench.session.setParameter("creatures", 800);
    QVERIFY(bench.view.zoom() < 0.5 * before);
    const QRect view = bench.view.viewport()->rect();
    for (const QPointF corner : {QPointF(0, 0), QPointF(4000, 0), QPointF(0, 2100), QPointF(4000, 2100)})
        QVERIFY(view.contains(bench.view.viewportTransform().map(corner).toPoint()));
    bench.session.setParameter("creatures", 5);
    QCOMPARE(bench.view.zoom(), before);
}

void SceneCrowdTest::aPictureThatWasMovedStaysWhereItIs()
{
    Bench bench(5);
    bench.view.zoomIn();
    const QTransform before = bench.view.viewportTransform();
    bench.session.setParameter("creatures", 800);
    QVERIFY(bench.view.viewportTransform() == before);
}

void SceneCrowdTest::everyBodyIsInThePicture()
{
    Bench bench(800);
    const QImage image = bench.image();
    for (int i = 120; i < 800; ++i) { // before, the name of the selected one lies over some
        const QPoint at = bench.onScreen(("creature" + std::to_string(i) + ".body").c_str());
        QVERIFY2(ink(image, at) > 100, qPrintable(QString::number(i)));
    }
}

/// Zoomed in, so that the middle of a leg is far from both discs.
void SceneCrowdTest::legsLeadFromBodiesToFeet()
{
    Bench bench(800);
    const QString body = "creature410.body";
    bench.view.bringBack(body);
    while (bench.view.zoom() < 150.0)
        bench.view.zoomIn();
    bench.view.bringBack(body);
    const QImage image = bench.image();
    for (const char *foot : {"creature410.foot0", "creature410.foot1"}) {
        const QPoint middle = 0.25 * bench.onScreen("creature410.body") + 0.75 * bench.onScreen(foot);
        QVERIFY(ink(image, middle) > 80);
    }
    const QPoint between = 0.5 * (bench.onScreen("creature410.foot0") + bench.onScreen("creature410.foot1"));
    QVERIFY(ink(image, between) < 40);
}

void SceneCrowdTest::onlyTheSelectedBodyHasArrows()
{
    Bench bench(300);
    bench.session.frameForward();
    Extras extras = bench.view.extras();
    extras.velocities = true;
    bench.view.setExtras(extras);
    const Camera camera(bench.view.viewportTransform());
    const auto arrows = velocityArrows(bench.view.shown(), camera, bench.theme);
    QCOMPARE(arrows.size(), std::size_t(1));
    bench.session.setParameter("creatures", 20);
    QCOMPARE(velocityArrows(bench.view.shown(), camera, bench.theme).size(), std::size_t(60));
}

void SceneCrowdTest::aCrowdLeavesNoTrail()
{
    Bench few(20);
    Bench many(300);
    for (int i = 0; i < 5; ++i) {
        few.session.frameForward();
        many.session.frameForward();
    }
    QVERIFY(few.view.shown().trail.marks().size() > 1);
    QVERIFY(many.view.shown().trail.marks().empty());
}

/// Back in slices, from a moment that is kept: as many frames apart as the history's memory wants it.
void SceneCrowdTest::goingBackComesToTheVeryState()
{
    Bench bench(20'000);
    bench.goTo(90);
    QVERIFY(bench.session.timeline().track().keyframeCount() < 60);
    sim::Track straight(bench.session.timeline().script(), 0);
    for (const std::int64_t frame : {61, 60, 13, 89, 0}) {
        bench.goTo(frame);
        straight.seek({frame, 0});
        QCOMPARE(bench.session.timeline().cursor().frame, frame);
        QVERIFY(sim::sameBits(bench.session.timeline().state(), straight.state()));
    }
}

QTEST_MAIN(SceneCrowdTest)
#include "tst_scene_crowd.moc"
