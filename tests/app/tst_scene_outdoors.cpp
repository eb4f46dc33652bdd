// Ground, sky and trees, a camera that follows, and earlier moments.

#include "app/ui/scene/scene_bar.h"
#include "app/ui/scene/tree_painter.h"
#include "lessons/api/view/view.h"
#include "look_scenes.h"
#include "scene_bench.h"

#include <QAction>
#include <QMenu>
#include <QTemporaryDir>
#include <QtTest>

#include <cmath>
#include <numbers>

using namespace app;
using lessons::View;
using Shape = lessons::BodyView::Shape;

namespace {

/// One disc that goes to the right at `speed` px/frame, 40 px above an endless ground.
lessons::Step walker(double speed, const char *id = "walk")
{
    sim::Scene scene = scenes::pointsAt({{270, 360}});
    look_scenes::letGlide(scene, {speed, 0.0});
    View look = look_scenes::feetOnly(scene);
    look.bodies[0] = {Shape::body, 15.0};
    look.ground = 400.0;
    look.followedPoint = 0;
    return look_scenes::step(id, scene, look);
}

QPointF onScreen(const SceneBench &bench, sim::Vec2 place)
{
    return bench.view.viewportTransform().map(QPointF(place.x, place.y));
}

/// The part of a picture that is not white.
double ink(const QImage &image)
{
    double sum = 0.0;
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x)
            sum += 1.0 - qGray(image.pixel(x, y)) / 255.0;
    }
    return sum / (image.width() * image.height());
}

/// A tree on white paper, in black, `zoom` times as large, in a picture of 600 x 500 px of the scene.
QImage paintedTree(const look_scenes::Tree &tree, const Theme &theme, double zoom)
{
    Shown shown;
    shown.picture.look = std::make_shared<const View>(tree.look);
    shown.picture.state = tree.scene.start;
    QImage image(static_cast<int>(600 * zoom), static_cast<int>(500 * zoom), QImage::Format_RGB32);
    image.fill(theme.tokens().scene);
    QPainter painter(&image);
    painter.setRenderHint(QPainter::Antialiasing);
    const Camera camera(QTransform::fromScale(zoom, zoom));
    TreePainter().draw({painter, shown, theme, camera, QRectF(image.rect())}, shown.picture.look,
                       shown.picture.state);
    return image;
}

}

class SceneOutdoorsTest : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase() { useOwnSettings(m_settings); }
    void theGroundLiesWhereItSays();
    void distancesScrollWithThePicture();
    void thePictureFollowsWhatWalks();
    void thePictureStaysWhileItsWalkerIsInTheMiddle();
    void whoMovesThePictureIsNotPulledBack();
    void aPictureThatWasMovedComesBackWhenItsLastBodyHasLeft();
    void aTreeEndsWhereItsBranchesDo();
    void aFarTreeCoversAsMuchAsANearOne_data();
    void aFarTreeCoversAsMuchAsANearOne();
    void whatIsTooSmallIsMerged_data();
    void whatIsTooSmallIsMerged();
    void anOpenSkyHasNoGrid();
    void aWholeTreeShowsAtFirst_data();
    void aWholeTreeShowsAtFirst();
    void onionSkinsAreWhereThePointsWere();
    void whatAStepShowsIsTheLearnersChoiceAfterAll();

private:
    QTemporaryDir m_settings;
};

void SceneOutdoorsTest::theGroundLiesWhereItSays()
{
    SceneBench bench({walker(0.0)});
    const QImage image = bench.image();
    const int y = static_cast<int>(std::round(onScreen(bench, {0, 400}).y()));
    const Tokens &t = bench.theme.tokens();
    for (const int x : {3, 90, 300, 590}) {
        QCOMPARE(image.pixelColor(x, y), t.contact);
        QVERIFY(image.pixelColor(x, y - 3) != t.contact);
    }
    QCOMPARE(image.pixelColor(5, y + 40), t.win);
    QCOMPARE(image.pixelColor(5, y - 3), t.scene);
}

void SceneOutdoorsTest::distancesScrollWithThePicture()
{
    SceneBench bench({walker(0.0)});
    const auto ticks = [&bench] {
        const QImage image = bench.image();
        const int y = static_cast<int>(std::round(onScreen(bench, {0, 400}).y())) + 11; // below the hatch
        std::vector<int> all;
        for (int x = 1; x < image.width() - 1; ++x) {
            if (qGray(image.pixel(x, y)) < 120 && (all.empty() || x > all.back() + 2))
                all.push_back(x);
        }
        return all;
    };
    const auto expected = [&bench] {
        std::vector<int> all;
        for (int at = -1000; at <= 2000; at += 100) {
            const int x = static_cast<int>(std::round(onScreen(bench, {double(at), 0}).x()));
            if (x > 1 && x < 598)
                all.push_back(x);
        }
        return all;
    };
    const auto agree = [](const std::vector<int> &a, const std::vector<int> &b) {
        return a.size() == b.size() && std::equal(a.begin(), a.end(), b.begin(), [](int one, int other) {
                   return std::abs(one - other) <= 1;
               });
    };
    QVERIFY(expected().size() >= 3U);
    QVERIFY(agree(ticks(), expected()));
    bench.press({40, 60}, Qt::MiddleButton);
    bench.move({40 - 137, 60}, Qt::MiddleButton);
    bench.release({40 - 137, 60}, Qt::MiddleButton);
    QVERIFY(agree(ticks(), expected()));
}

void SceneOutdoorsTest::thePictureFollowsWhatWalks()
{
    SceneBench bench({walker(17.0)});
    const double y = onScreen(bench, {0, 400}).y();
    const double zoom = bench.view.zoom();
    const double width = bench.view.viewport()->width();
    for (const std::int64_t frame : {1, 10, 11, 200, 199, 5000, 40, 0}) {
        bench.goTo(frame);
        const sim::Vec2 at = bench.place("p0");
        QCOMPARE(at.x, 270.0 + 17.0 * static_cast<double>(frame));
        const double x = onScreen(bench, at).x();
        // In the middle or behind it: there is more to see of where it goes than of where it was.
        QVERIFY2(x >= 0.33 * width && x <= 0.5 * width + 1.0, qPrintable(QString::number(x)));
        QVERIFY(std::abs(onScreen(bench, {0, 400}).y() - y) < 1e-9);
    }
    QCOMPARE(bench.view.zoom(), zoom);
}

void SceneOutdoorsTest::thePictureStaysWhileItsWalkerIsInTheMiddle()
{
    SceneBench bench({walker(1.0)});
    const QTransform before = bench.view.viewportTransform();
    bench.goTo(20);
    QCOMPARE(bench.view.viewportTransform(), before);
}

void SceneOutdoorsTest::whoMovesThePictureIsNotPulledBack()
{
    SceneBench bench({walker(17.0)});
    bench.press({40, 60}, Qt::MiddleButton);
    bench.move({40 + 90, 60}, Qt::MiddleButton);
    bench.release({40 + 90, 60}, Qt::MiddleButton);
    const QTransform before = bench.view.viewportTransform();
    bench.goTo(5);
    QCOMPARE(bench.view.viewportTransform(), before);
    bench.view.fit();
    const double width = bench.view.viewport()->width();
    const double x = onScreen(bench, bench.place("p0")).x();
    QVERIFY(x >= 0.33 * width && x <= 0.5 * width + 1.0);
    bench.goTo(300);
    QVERIFY(onScreen(bench, bench.place("p0")).x() <= 0.5 * width + 1.0);
}

void SceneOutdoorsTest::aPictureThatWasMovedComesBackWhenItsLastBodyHasLeft()
{
    SceneBench bench({walker(17.0)});
    bench.view.zoomIn();
    const double zoom = bench.view.zoom();
    bench.press({40, 60}, Qt::MiddleButton);
    bench.move({40 + 90, 60}, Qt::MiddleButton);
    bench.release({40 + 90, 60}, Qt::MiddleButton);
    const QRect view = bench.view.viewport()->rect();
    QTransform before = bench.view.viewportTransform();
    int moves = 0;
    for (int frame = 1; frame <= 100; ++frame) {
        const bool stays =
            view.adjusted(20, 20, -20, -20)
                .contains(onScreen(bench, bench.place("p0")).toPoint() + QPoint(qRound(0.17 * zoom), 0));
        bench.session.frameForward();
        QVERIFY(view.contains(onScreen(bench, bench.place("p0")).toPoint()));
        moves += bench.view.viewportTransform() != before ? 1 : 0;
        QVERIFY(!stays || bench.view.viewportTransform() == before);
        before = bench.view.viewportTransform();
    }
    QVERIFY2(moves >= 3 && moves <= 20, qPrintable(QString::number(moves)));
    QCOMPARE(bench.view.zoom(), zoom);
    bench.session.goTo({0, 0});
    QVERIFY(view.contains(onScreen(bench, bench.place("p0")).toPoint()));
}

void SceneOutdoorsTest::aTreeEndsWhereItsBranchesDo()
{
    look_scenes::Tree tree = look_scenes::tree(5);
    tree.look.sky = View::Sky::paper;
    SceneBench bench({look_scenes::step("tree", tree.scene, tree.look)});
    const QImage image = bench.image();
    // The outermost tip on the left: each fork turns by 28 degrees once more.
    sim::Vec2 tip{270, 400};
    double angle = -90.0;
    double length = 100.0;
    for (int i = 0; i <= 5; ++i) {
        const double a = angle * std::numbers::pi / 180.0;
        tip = tip + length * sim::Vec2{std::cos(a), std::sin(a)};
        angle -= 28.0;
        length *= 0.8;
    }
    const double a = (angle + 28.0) * std::numbers::pi / 180.0;
    const QColor paper = bench.theme.tokens().scene;
    const auto at = [&](double along) {
        return image.pixelColor(onScreen(bench, tip + along * sim::Vec2{std::cos(a), std::sin(a)}).toPoint());
    };
    QVERIFY(at(-2.0) != paper);
    QVERIFY(at(-12.0) != paper);
    QCOMPARE(at(6.0), paper);
    // The trunk is as thick as it says, and tapers.
    const auto width = [&](double y) {
        int count = 0;
        const QPoint middle = onScreen(bench, {270, y}).toPoint();
        for (int x = -40; x <= 40; ++x)
            count += image.pixelColor(middle + QPoint(x, 0)) == bench.theme.tokens().body ? 1 : 0;
        return count * 100.0 / bench.view.zoom();
    };
    QVERIFY(std::abs(width(399.0) - 13.0) < 2.5);
    QVERIFY(width(310.0) < width(390.0));
}

void SceneOutdoorsTest::aFarTreeCoversAsMuchAsANearOne_data()
{
    QTest::addColumn<int>("forks");
    QTest::addColumn<double>("zoom");
    QTest::newRow("a small tree at half size") << 6 << 0.5;
    QTest::newRow("a small tree, far away") << 6 << 0.1;
    QTest::newRow("a large tree at half size") << 11 << 0.5;
    QTest::newRow("a large tree, far away") << 11 << 0.1;
}

void SceneOutdoorsTest::aFarTreeCoversAsMuchAsANearOne()
{
    QFETCH(int, forks);
    QFETCH(double, zoom);
    const Theme theme(Scheme::light);
    look_scenes::Tree tree = look_scenes::tree(forks);
    tree.look.sky = View::Sky::paper;
    const double near = ink(paintedTree(tree, theme, 4.0)); // all branches are wider than a px there
    const double far = ink(paintedTree(tree, theme, zoom));
    qInfo("ink: near %.4f, far %.4f", near, far);
    QVERIFY(near > 0.005);
    QVERIFY(std::abs(far / near - 1.0) < 0.15);
}

void SceneOutdoorsTest::whatIsTooSmallIsMerged_data()
{
    QTest::addColumn<double>("length");
    QTest::addColumn<double>("width");
    QTest::addColumn<int>("every");
    QTest::newRow("what shows") << 5.0 << 1.0 << 1;
    QTest::newRow("just") << 0.7 << 0.3 << 1;
    QTest::newRow("a third as wide") << 5.0 << 0.1 << 3;
    QTest::newRow("half as long") << 0.35 << 1.0 << 2;
    QTest::newRow("both") << 0.35 << 0.1 << 6;
    QTest::newRow("nothing at all") << 0.0 << 0.0 << 64 * 64;
}

void SceneOutdoorsTest::whatIsTooSmallIsMerged()
{
    QFETCH(double, length);
    QFETCH(double, width);
    QFETCH(int, every);
    const Thinning thinning = thinningOf(length, width);
    QCOMPARE(thinning.every, every);
    QCOMPARE(thinning.longer * thinning.stronger, every);
    int drawn = 0;
    for (int branch = 0; branch < 100000; ++branch)
        drawn += isDrawn(branch, every) ? 1 : 0;
    QVERIFY(std::abs(drawn * every / 1e5 - 1.0) < 5.0 * std::sqrt(every / 1e5)); // five standard deviations
}

void SceneOutdoorsTest::anOpenSkyHasNoGrid()
{
    const look_scenes::Tree tree = look_scenes::tree(3);
    SceneBench bench({look_scenes::step("tree", tree.scene, tree.look)});
    const QImage before = bench.image();
    QVERIFY(before.pixelColor(2, 2) != bench.theme.tokens().scene);
    QVERIFY(before.pixelColor(2, 2) != before.pixelColor(2, 200));
    Extras extras = bench.view.extras();
    extras.grid = !extras.grid;
    bench.view.setExtras(extras);
    QVERIFY(bench.image() == before);
    bench.theme.setScheme(Scheme::dark);
    QVERIFY(qGray(bench.image().pixel(2, 2)) < qGray(before.pixel(2, 2)));
    // It is painted anew for another size.
    bench.view.resize(900, 470);
    QVERIFY(bench.image().pixelColor(880, 100) != QColor(Qt::black));
}

void SceneOutdoorsTest::aWholeTreeShowsAtFirst_data()
{
    QTest::addColumn<QSize>("size");
    QTest::newRow("the window's") << QSize(600, 470);
    QTest::newRow("narrow") << QSize(300, 500);
    QTest::newRow("wide") << QSize(1280, 560);
}

void SceneOutdoorsTest::aWholeTreeShowsAtFirst()
{
    QFETCH(QSize, size);
    const look_scenes::Tree tree = look_scenes::tree(7);
    SceneBench bench({look_scenes::step("tree", tree.scene, tree.look)});
    bench.view.resize(size);
    const QRectF view(bench.view.viewport()->rect());
    for (int i = 0; i < tree.scene.start.pointCount(); ++i) {
        const double a = tree.scene.start.angle[i] * std::numbers::pi / 180.0;
        const double length = tree.look.tree->length[static_cast<std::size_t>(i)];
        QVERIFY(view.contains(
            onScreen(bench, tree.scene.start.positionOf(i) + length * sim::Vec2{std::cos(a), std::sin(a)})));
    }
    QVERIFY2(onScreen(bench, {270, 400}).y() < view.height() - 50.0, "no ground below the trunk");
}

void SceneOutdoorsTest::onionSkinsAreWhereThePointsWere()
{
    lessons::Step step = walker(6.0);
    const View plain = step.view({}, {});
    step.view = [plain](const sim::Scene &, const sim::Values &) {
        View look = plain;
        look.showsOnionSkins = true;
        look.followedPoint = -1;
        return look;
    };
    SceneBench bench({step});
    QVERIFY(bench.view.extras().onion);
    bench.goTo(30);
    while (bench.view.zoom() > 150.0) // all seven are in the picture
        bench.view.zoomOut();
    bench.view.bringBack("p0");
    Extras extras = bench.view.extras();
    extras.grid = extras.trails = false;
    bench.view.setExtras(extras);
    const QImage with = bench.image();
    extras.onion = false;
    bench.view.setExtras(extras);
    const QImage without = bench.image();
    // Six of them, at frames 28, 24, ... 8, each 30 px wide; the body itself covers the latest ones.
    const double radius = 15.0;
    double fainter = 5.0 * 256.0;
    for (const int frame : {24, 20, 16, 12, 8}) {
        const QPoint left = onScreen(bench, {270.0 + 6.0 * frame - radius, 360}).toPoint();
        double ink = 0.0; // all of it: where between two pixels an outline lies does not count
        for (int x = -2; x <= 2; ++x)
            ink += 255.0 - qGray(with.pixel(left + QPoint(x, 0)));
        QVERIFY(ink > 5.0 && ink < fainter);
        fainter = ink;
        QCOMPARE(without.pixelColor(left), bench.theme.tokens().scene);
    }
    const QPoint before = onScreen(bench, {270.0 + 6.0 * 4 - radius, 360}).toPoint();
    QVERIFY(with.rect().contains(before));
    QCOMPARE(with.pixelColor(before), bench.theme.tokens().scene); // a seventh is not shown
}

void SceneOutdoorsTest::whatAStepShowsIsTheLearnersChoiceAfterAll()
{
    const auto showing = [](const char *id, bool all) {
        lessons::Step step = walker(1.0, id);
        const View plain = step.view({}, {});
        step.view = [plain, all](const sim::Scene &, const sim::Values &) {
            View look = plain;
            look.showsOnionSkins = look.showsVelocities = all;
            return look;
        };
        return step;
    };
    SceneBench bench({showing("plain", false), showing("full", true), showing("other", true)});
    SceneBar bar(bench.session, bench.theme);
    bar.attach(bench.view);
    const auto isChecked = [&bar](const QString &text) {
        for (const QMenu *menu : bar.findChildren<QMenu *>()) {
            for (const QAction *action : menu->actions()) {
                if (action->text() == text)
                    return action->isChecked();
            }
        }
        return false;
    };
    QVERIFY(!bench.view.extras().onion && !bench.view.extras().velocities);
    bench.session.openStep("scene", "full");
    QVERIFY(bench.view.extras().onion && bench.view.extras().velocities);
    QVERIFY(isChecked("Onion skins") && isChecked("Velocity arrows"));
    bench.session.openStep("scene", "plain");
    QVERIFY(!bench.view.extras().onion && !isChecked("Onion skins"));
    bench.session.openStep("scene", "full");
    Extras extras = bench.view.extras();
    extras.onion = false;
    bench.view.setExtras(extras);
    bench.session.openStep("scene", "other");
    QVERIFY2(!bench.view.extras().onion, "the learner switched it off");
    QVERIFY2(bench.view.extras().velocities, "the learner did not touch it");
}

QTEST_MAIN(SceneOutdoorsTest)
#include "tst_scene_outdoors.moc"
