// Ground, sky and trees, a camera that follows, and earlier moments.

#include "app/ui/scene/layers/layers.h"
#include "app/ui/scene/layers/tree_painter.h"
#include "app/ui/scene/scene_bar.h"
#include "lessons/api/view/view.h"
#include "tests/app/scene/drawn_scenes.h"
#include "tests/app/scene/scene_support.h"
#include "tests/suite.h"

#include <QAction>
#include <QMenu>
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
    drawn_scenes::letGlide(scene, {speed, 0.0});
    View view = drawn_scenes::feetOnly(scene);
    view.bodies[0] = {Shape::body, 15.0};
    view.ground = 400.0;
    view.followedPoint = 0;
    return drawn_scenes::step(id, scene, view);
}

QPointF onScreen(const SceneFixture &fixture, sim::Vec2 place)
{
    return fixture.view.viewportTransform().map(QPointF(place.x, place.y));
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
QImage paintedTree(const drawn_scenes::Tree &tree, const Theme &theme, double zoom)
{
    SceneContent shown;
    shown.picture.view = std::make_shared<const View>(tree.view);
    shown.picture.state = tree.scene.start;
    QImage image(static_cast<int>(600 * zoom), static_cast<int>(500 * zoom), QImage::Format_RGB32);
    image.fill(theme.tokens().scene);
    QPainter painter(&image);
    painter.setRenderHint(QPainter::Antialiasing);
    const Camera camera(QTransform::fromScale(zoom, zoom));
    TreePainter().draw({painter, shown, theme, camera, QRectF(image.rect())}, shown.picture.view,
                       shown.picture.state);
    return image;
}

/// The near ground below a tree in a picture of 600 x 500 px.
QImage paintedGround(const SceneContent &shown, const Theme &theme)
{
    QImage image(600, 500, QImage::Format_RGB32);
    image.fill(theme.tokens().scene);
    QPainter painter(&image);
    TreePainter tree;
    drawNearGround({painter, shown, theme, Camera(QTransform()), QRectF(image.rect())}, tree);
    return image;
}

}

class SceneOutdoorsTest : public QObject
{
    Q_OBJECT

private slots:
    void groundIsDrawnAtItsHeight();
    void distancesScrollWithThePicture();
    void noDistanceIsCutAtTheEdge();
    void aNameHidesNoPartOfADistance();
    void thePictureFollowsWhatWalks();
    void thePictureStaysWhileItsWalkerIsInTheMiddle();
    void thePannedViewStaysWhereItIs();
    void aPictureThatWasMovedComesBackWhenItsLastBodyHasLeft();
    void aTreeEndsWhereItsBranchesDo();
    void aFarTreeCoversAsMuchAsANearOne_data();
    void aFarTreeCoversAsMuchAsANearOne();
    void branchesThatAreTooSmallAreMerged_data();
    void branchesThatAreTooSmallAreMerged();
    void anOpenSkyHasNoGrid();
    void aWholeTreeShowsAtFirst_data();
    void aWholeTreeShowsAtFirst();
    void aGhostBelowTheGroundShowsThrough();
    void onionSkinsAreWhereThePointsWere();
    void theLearnersChoiceOfDrawingsWinsOverTheSteps();
};

void SceneOutdoorsTest::groundIsDrawnAtItsHeight()
{
    SceneFixture fixture({walker(0.0)});
    const QImage image = fixture.image();
    const int y = static_cast<int>(std::round(onScreen(fixture, {0, 400}).y()));
    const Tokens &t = fixture.theme.tokens();
    for (const int x : {3, 90, 300, 590}) {
        QCOMPARE(image.pixelColor(x, y), t.contact);
        QVERIFY(image.pixelColor(x, y - 3) != t.contact);
    }
    QCOMPARE(image.pixelColor(5, y + 40), t.win);
    QCOMPARE(image.pixelColor(5, y - 3), t.scene);
}

void SceneOutdoorsTest::distancesScrollWithThePicture()
{
    SceneFixture fixture({walker(0.0)});
    const auto ticks = [&fixture] {
        const QImage image = fixture.image();
        const int y = static_cast<int>(std::round(onScreen(fixture, {0, 400}).y())) + 11; // below the hatch
        std::vector<int> all;
        for (int x = 1; x < image.width() - 1; ++x) {
            if (qGray(image.pixel(x, y)) < 120 && (all.empty() || x > all.back() + 2))
                all.push_back(x);
        }
        return all;
    };
    const auto expected = [&fixture] {
        std::vector<int> all;
        for (int at = -1000; at <= 2000; at += 100) {
            const int x = static_cast<int>(std::round(onScreen(fixture, {double(at), 0}).x()));
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
    fixture.press({40, 60}, Qt::MiddleButton);
    fixture.move({40 - 137, 60}, Qt::MiddleButton);
    fixture.release({40 - 137, 60}, Qt::MiddleButton);
    QVERIFY(agree(ticks(), expected()));
}

void SceneOutdoorsTest::aNameHidesNoPartOfADistance()
{
    sim::Scene scene = scenes::pointsAt({{300, 385}});
    View view = drawn_scenes::feetOnly(scene);
    view.bodies[0] = {Shape::body, 15.0};
    view.ground = 400.0;
    SceneFixture fixture({drawn_scenes::step("stand", scene, view)});
    const QImage image = fixture.image();
    const int top = static_cast<int>(std::round(onScreen(fixture, {0, 400}).y())) + 15; // below the ticks
    // The left part of a number: the name begins 8 px left of the middle.
    const auto dark = [&](double place) {
        const int middle = static_cast<int>(std::round(onScreen(fixture, {place, 0}).x()));
        int count = 0;
        for (int y = top; y < top + 16; ++y) {
            for (int x = middle - 24; x < middle - 9; ++x)
                count += qGray(image.pixel(x, y)) < 190 ? 1 : 0;
        }
        return count;
    };
    QVERIFY(dark(200) > 0);
    QVERIFY(dark(400) > 0);
    QCOMPARE(dark(300), 0);
}

void SceneOutdoorsTest::noDistanceIsCutAtTheEdge()
{
    SceneFixture fixture({walker(0.0)});
    constexpr int belowTicks = 15, lineHeight = 16; // px
    const int top = static_cast<int>(std::round(onScreen(fixture, {0, 400}).y())) + belowTicks;
    const auto isDark = [](const QImage &image, int x, int y) { return qGray(image.pixel(x, y)) < 190; };
    for (int moved = 0; moved < 160; moved += 8) {
        const QImage image = fixture.image();
        int dark = 0;
        for (int y = top; y < top + lineHeight; ++y) {
            for (int x = 0; x < image.width(); ++x)
                dark += isDark(image, x, y) ? 1 : 0;
            for (const int x : {0, 1, image.width() - 2, image.width() - 1})
                QVERIFY2(!isDark(image, x, y), qPrintable(QString("moved by %1 px").arg(moved)));
        }
        QVERIFY(dark > 50); // the other numbers
        fixture.press({200, 60}, Qt::MiddleButton);
        fixture.move({200 - 8, 60}, Qt::MiddleButton);
        fixture.release({200 - 8, 60}, Qt::MiddleButton);
    }
}

void SceneOutdoorsTest::thePictureFollowsWhatWalks()
{
    SceneFixture fixture({walker(17.0)});
    const double y = onScreen(fixture, {0, 400}).y();
    const double zoom = fixture.view.zoom();
    const double width = fixture.view.viewport()->width();
    for (const std::int64_t frame : {1, 10, 11, 200, 199, 5000, 40, 0}) {
        fixture.goTo(frame);
        const sim::Vec2 at = fixture.place("p0");
        QCOMPARE(at.x, 270.0 + 17.0 * static_cast<double>(frame));
        const double x = onScreen(fixture, at).x();
        // The walker is in the middle or behind it, so more is visible ahead of it than behind.
        QVERIFY2(x >= 0.33 * width && x <= 0.5 * width + 1.0, qPrintable(QString::number(x)));
        QVERIFY(std::abs(onScreen(fixture, {0, 400}).y() - y) < 1e-9);
    }
    QCOMPARE(fixture.view.zoom(), zoom);
}

void SceneOutdoorsTest::thePictureStaysWhileItsWalkerIsInTheMiddle()
{
    SceneFixture fixture({walker(1.0)});
    const QTransform before = fixture.view.viewportTransform();
    fixture.goTo(20);
    QCOMPARE(fixture.view.viewportTransform(), before);
}

void SceneOutdoorsTest::thePannedViewStaysWhereItIs()
{
    SceneFixture fixture({walker(17.0)});
    fixture.press({40, 60}, Qt::MiddleButton);
    fixture.move({40 + 90, 60}, Qt::MiddleButton);
    fixture.release({40 + 90, 60}, Qt::MiddleButton);
    const QTransform before = fixture.view.viewportTransform();
    fixture.goTo(5);
    QCOMPARE(fixture.view.viewportTransform(), before);
    fixture.view.fit();
    const double width = fixture.view.viewport()->width();
    const double x = onScreen(fixture, fixture.place("p0")).x();
    QVERIFY(x >= 0.33 * width && x <= 0.5 * width + 1.0);
    fixture.goTo(300);
    QVERIFY(onScreen(fixture, fixture.place("p0")).x() <= 0.5 * width + 1.0);
}

void SceneOutdoorsTest::aPictureThatWasMovedComesBackWhenItsLastBodyHasLeft()
{
    SceneFixture fixture({walker(17.0)});
    fixture.view.zoomIn();
    const double zoom = fixture.view.zoom();
    fixture.press({40, 60}, Qt::MiddleButton);
    fixture.move({40 + 90, 60}, Qt::MiddleButton);
    fixture.release({40 + 90, 60}, Qt::MiddleButton);
    const QRect view = fixture.view.viewport()->rect();
    QTransform before = fixture.view.viewportTransform();
    int moves = 0;
    for (int frame = 1; frame <= 100; ++frame) {
        const bool stays =
            view.adjusted(20, 20, -20, -20)
                .contains(onScreen(fixture, fixture.place("p0")).toPoint() + QPoint(qRound(0.17 * zoom), 0));
        fixture.session.playback().frameForward();
        QVERIFY(view.contains(onScreen(fixture, fixture.place("p0")).toPoint()));
        moves += fixture.view.viewportTransform() != before ? 1 : 0;
        QVERIFY(!stays || fixture.view.viewportTransform() == before);
        before = fixture.view.viewportTransform();
    }
    QVERIFY2(moves >= 3 && moves <= 20, qPrintable(QString::number(moves)));
    QCOMPARE(fixture.view.zoom(), zoom);
    fixture.session.playback().goTo({0, 0});
    QVERIFY(view.contains(onScreen(fixture, fixture.place("p0")).toPoint()));
}

void SceneOutdoorsTest::aTreeEndsWhereItsBranchesDo()
{
    drawn_scenes::Tree tree = drawn_scenes::tree(5);
    tree.view.sky = View::Sky::paper;
    SceneFixture fixture({drawn_scenes::step("tree", tree.scene, tree.view)});
    const QImage image = fixture.image();
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
    const QColor paper = fixture.theme.tokens().scene;
    const auto at = [&](double along) {
        return image.pixelColor(
            onScreen(fixture, tip + along * sim::Vec2{std::cos(a), std::sin(a)}).toPoint());
    };
    QVERIFY(at(-2.0) != paper);
    QVERIFY(at(-12.0) != paper);
    QCOMPARE(at(6.0), paper);
    // The trunk is as thick as it says, and tapers.
    const auto width = [&](double y) {
        int count = 0;
        const QPoint middle = onScreen(fixture, {270, y}).toPoint();
        for (int x = -40; x <= 40; ++x)
            count += image.pixelColor(middle + QPoint(x, 0)) == fixture.theme.tokens().body ? 1 : 0;
        return count * 100.0 / fixture.view.zoom();
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
    drawn_scenes::Tree tree = drawn_scenes::tree(forks);
    tree.view.sky = View::Sky::paper;
    const double near = ink(paintedTree(tree, theme, 4.0)); // all branches are wider than a px there
    const double far = ink(paintedTree(tree, theme, zoom));
    qInfo("ink: near %.4f, far %.4f", near, far);
    QVERIFY(near > 0.005);
    QVERIFY(std::abs(far / near - 1.0) < 0.15);
}

void SceneOutdoorsTest::branchesThatAreTooSmallAreMerged_data()
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

void SceneOutdoorsTest::branchesThatAreTooSmallAreMerged()
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
    const drawn_scenes::Tree tree = drawn_scenes::tree(3);
    SceneFixture fixture({drawn_scenes::step("tree", tree.scene, tree.view)});
    const QImage before = fixture.image();
    QVERIFY(before.pixelColor(2, 2) != fixture.theme.tokens().scene);
    QVERIFY(before.pixelColor(2, 2) != before.pixelColor(2, 200));
    Extras extras = fixture.view.extras();
    extras.grid = !extras.grid;
    fixture.view.setExtras(extras);
    QVERIFY(fixture.image() == before);
    fixture.theme.setScheme(Scheme::dark);
    QVERIFY(qGray(fixture.image().pixel(2, 2)) < qGray(before.pixel(2, 2)));
    // It is painted again for another size.
    fixture.view.resize(900, 470);
    QVERIFY(fixture.image().pixelColor(880, 100) != QColor(Qt::black));
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
    const drawn_scenes::Tree tree = drawn_scenes::tree(7);
    SceneFixture fixture({drawn_scenes::step("tree", tree.scene, tree.view)});
    fixture.view.resize(size);
    const QRectF view(fixture.view.viewport()->rect());
    for (int i = 0; i < tree.scene.start.pointCount(); ++i) {
        const double a = tree.scene.start.angle[i] * std::numbers::pi / 180.0;
        const double length = tree.view.tree->length[static_cast<std::size_t>(i)];
        QVERIFY(view.contains(onScreen(fixture, tree.scene.start.positionOf(i) +
                                                    length * sim::Vec2{std::cos(a), std::sin(a)})));
    }
    QVERIFY2(onScreen(fixture, {270, 400}).y() < view.height() - 50.0, "no ground below the trunk");
}

void SceneOutdoorsTest::aGhostBelowTheGroundShowsThrough()
{
    const Theme theme(Scheme::light);
    const drawn_scenes::Tree tree = drawn_scenes::tree(0);
    SceneContent shown;
    shown.picture.view = std::make_shared<const View>(tree.view);
    shown.picture.state = tree.scene.start; // stands upright
    const QImage meadow = paintedGround(shown, theme);
    shown.comparison = shown.picture;
    QCOMPARE(paintedGround(shown, theme), meadow);
    shown.comparison->state.angle[0] = 60.0; // bent to the right and down
    const QImage image = paintedGround(shown, theme);
    const QPoint along(295, 443); // half-way along the ghost's trunk
    int drawn = 0;
    for (int x = -12; x <= 12; ++x)
        drawn += image.pixel(along + QPoint(x, 0)) != meadow.pixel(along + QPoint(x, 0)) ? 1 : 0;
    QVERIFY2(drawn >= 2, qPrintable(QString::number(drawn)));
    shown.extras.comparison = false;
    QCOMPARE(paintedGround(shown, theme), meadow);
}

void SceneOutdoorsTest::onionSkinsAreWhereThePointsWere()
{
    lessons::Step step = walker(6.0);
    const View plain = step.view({}, {});
    step.view = [plain](const sim::Scene &, const sim::Values &) {
        View view = plain;
        view.showsOnionSkins = true;
        view.followedPoint = -1;
        return view;
    };
    SceneFixture fixture({step});
    QVERIFY(fixture.view.extras().onion);
    fixture.goTo(30);
    while (fixture.view.zoom() > 150.0) // all seven are in the picture
        fixture.view.zoomOut();
    fixture.view.bringBack("p0");
    Extras extras = fixture.view.extras();
    extras.grid = extras.trails = false;
    fixture.view.setExtras(extras);
    const QImage with = fixture.image();
    extras.onion = false;
    fixture.view.setExtras(extras);
    const QImage without = fixture.image();
    // Six of them, at frames 28, 24, ... 8, each 30 px wide; the body itself covers the latest ones.
    const double radius = 15.0;
    double fainter = 5.0 * 256.0;
    for (const int frame : {24, 20, 16, 12, 8}) {
        const QPoint left = onScreen(fixture, {270.0 + 6.0 * frame - radius, 360}).toPoint();
        double ink = 0.0; // all of it: where between two pixels an outline lies does not count
        for (int x = -2; x <= 2; ++x)
            ink += 255.0 - qGray(with.pixel(left + QPoint(x, 0)));
        QVERIFY(ink > 5.0 && ink < fainter);
        fainter = ink;
        QCOMPARE(without.pixelColor(left), fixture.theme.tokens().scene);
    }
    const QPoint before = onScreen(fixture, {270.0 + 6.0 * 4 - radius, 360}).toPoint();
    QVERIFY(with.rect().contains(before));
    QCOMPARE(with.pixelColor(before), fixture.theme.tokens().scene); // a seventh is not shown
}

void SceneOutdoorsTest::theLearnersChoiceOfDrawingsWinsOverTheSteps()
{
    const auto showing = [](const char *id, bool all) {
        lessons::Step step = walker(1.0, id);
        const View plain = step.view({}, {});
        step.view = [plain, all](const sim::Scene &, const sim::Values &) {
            View view = plain;
            view.showsOnionSkins = view.showsVelocities = all;
            return view;
        };
        return step;
    };
    SceneFixture fixture({showing("plain", false), showing("full", true), showing("other", true)});
    SceneBar bar(fixture.session.run(), fixture.session.editor(), fixture.session.code(), fixture.theme);
    bar.attach(fixture.view, fixture.fit);
    const auto isChecked = [&bar](const QString &text) {
        for (const QMenu *menu : bar.findChildren<QMenu *>()) {
            for (const QAction *action : menu->actions()) {
                if (action->text() == text)
                    return action->isChecked();
            }
        }
        return false;
    };
    QVERIFY(!fixture.view.extras().onion && !fixture.view.extras().velocities);
    fixture.session.openStep("scene", "full");
    QVERIFY(fixture.view.extras().onion && fixture.view.extras().velocities);
    QVERIFY(isChecked("Onion skins") && isChecked("Velocity arrows"));
    fixture.session.openStep("scene", "plain");
    QVERIFY(!fixture.view.extras().onion && !isChecked("Onion skins"));
    fixture.session.openStep("scene", "full");
    Extras extras = fixture.view.extras();
    extras.onion = false;
    fixture.view.setExtras(extras);
    fixture.session.openStep("scene", "other");
    QVERIFY2(!fixture.view.extras().onion, "the learner switched it off");
    QVERIFY2(fixture.view.extras().velocities, "the learner did not touch it");
}

SUITE(tst_scene_outdoors, SceneOutdoorsTest)
#include "tst_scene_outdoors.moc"
