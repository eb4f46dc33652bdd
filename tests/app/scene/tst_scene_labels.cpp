// Names, numbers and signs in the picture do not overlap.

#include "app/model/text/sentences.h"
#include "app/ui/scene/drawing/body_text.h"
#include "app/ui/scene/drawing/label_places.h"
#include "app/ui/scene/drawing/overlay_labels.h"
#include "app/ui/scene/hud/free_area.h"
#include "app/ui/scene/hud/hud.h"
#include "app/ui/scene/place_picker.h"
#include "lessons/api/view/view.h"
#include "tests/app/scene/drawn_scenes.h"
#include "tests/app/scene/scene_support.h"

#include "app/model/text/numbers.h"
#include "tests/suite.h"

#include <QtTest>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>

using namespace app;

class SceneLabelsTest : public QObject
{
    Q_OBJECT

private slots:
    void signsAtTheEdgeDoNotOverlap_data();
    void signsAtTheEdgeDoNotOverlap();
    void namesDoNotOverlap_data();
    void namesDoNotOverlap();
    void aNameCoversNoArrow_data();
    void aNameCoversNoArrow();
    void aNameIsNotCutAtTheEdge_data();
    void aNameIsNotCutAtTheEdge();
    void aLabelOfAThingAtRestStays();
    void labelDoesNotJumpBackAndForth();
    void aPredictionCoversNothing_data();
    void aPredictionCoversNothing();
    void theLineToAPredictionLeavesTheNameReadable();
    void aPullThatIsNotSeenHasNoName();
    void aBoxCoversAPartOfALine_data();
    void aBoxCoversAPartOfALine();
    void namesAndNumbersAreReadable_data();
    void namesAndNumbersAreReadable();
    void arrowsHaveAReadableScale_data();
    void arrowsHaveAReadableScale();
};

void SceneLabelsTest::signsAtTheEdgeDoNotOverlap_data()
{
    QTest::addColumn<QPointF>("middle");
    QTest::addColumn<int>("least");
    QTest::newRow("all in one direction") << QPointF(2000, 200) << 1;
    QTest::newRow("to all sides") << QPointF(275, 240) << 2;
    QTest::newRow("far beyond") << QPointF(4e5, -3e5) << 1;
    QTest::newRow("so far that its square is no number") << QPointF(1e200, -1e200) << 1;
}

void SceneLabelsTest::signsAtTheEdgeDoNotOverlap()
{
    QFETCH(QPointF, middle);
    QFETCH(int, least);
    SceneFixture fixture;
    SceneContent shown;
    shown.picture = fixture.session.presentation().picture();
    shown.text = fixture.theme.ui(12);
    const Camera camera(QTransform().translate(300, 235).scale(12, 12).translate(-middle.x(), -middle.y()));
    const QRectF view(0, 0, 600, 470);
    const QRectF free = view.adjusted(12, 40, -12, -48);
    const std::vector<EdgeMarker> markers = edgeMarkers(shown, camera, view, free, {});
    QVERIFY(static_cast<int>(markers.size()) >= least);
    int bodies = 0;
    for (std::size_t i = 0; i < markers.size(); ++i) {
        bodies += markers[i].bodies;
        QVERIFY2(!markers[i].text.contains("inf"), qPrintable(markers[i].text));
        QVERIFY(free.adjusted(-1, -1, 1, 1).contains(markers[i].label));
        for (std::size_t j = 0; j < i; ++j)
            QVERIFY(!markers[i].label.intersects(markers[j].label));
    }
    QCOMPARE(bodies, 3);
}

void SceneLabelsTest::namesDoNotOverlap_data()
{
    QTest::addColumn<int>("frame");
    QTest::addColumn<int>("phase");
    QTest::newRow("at the start") << 0 << 0;
    QTest::newRow("in the middle of a swing") << 3 << 0;
    QTest::newRow("inside a frame") << 3 << 1;
}

void SceneLabelsTest::namesDoNotOverlap()
{
    QFETCH(int, frame);
    QFETCH(int, phase);
    SceneFixture fixture("lone");
    fixture.session.playback().goTo({frame, phase});
    SceneContent shown;
    shown.picture = fixture.session.presentation().picture();
    shown.gathered = fixture.session.presentation().forces();
    shown.text = fixture.theme.ui(12);
    shown.selected = 0;
    const Camera camera(fixture.view.viewportTransform());
    const QRectF view(fixture.view.viewport()->rect());
    const QRectF name = nameBox(shown, camera, view);
    QCOMPARE(name.isEmpty(), phase > 0); // a card stands in its place
    const std::vector<OverlayLabel> labels = overlayLabels(shown, camera, fixture.theme, view);
    QCOMPARE(labels.size(), 1U);
    QVERIFY(!labels[0].box.intersects(name));
    const auto bodies = bodyBoxes(shown, camera);
    QCOMPARE(bodies.size(), 1U);
    QVERIFY(!labels[0].box.intersects(bodies[0]));
}

void SceneLabelsTest::aNameCoversNoArrow_data()
{
    QTest::addColumn<double>("degrees");
    for (int degrees = 0; degrees < 360; degrees += 30)
        QTest::addRow("%d degrees", degrees) << double(degrees);
}

void SceneLabelsTest::aNameCoversNoArrow()
{
    QFETCH(double, degrees);
    SceneFixture fixture("lone");
    SceneContent shown;
    shown.picture = fixture.session.presentation().picture();
    shown.text = fixture.theme.ui(12);
    const double angle = degrees * std::numbers::pi / 180.0;
    const sim::Vec2 pull = {3.0 * std::cos(angle), 3.0 * std::sin(angle)};
    shown.picture.overlays = {{.shape = lessons::Overlay::Shape::arrow,
                               .a = shown.state().positionOf(0),
                               .b = pull,
                               .label = "a pull with a long name"}};
    const Camera camera(fixture.view.viewportTransform());
    const QRectF view(fixture.view.viewport()->rect());
    const std::vector<OverlayLabel> labels = overlayLabels(shown, camera, fixture.theme, view);
    QCOMPARE(labels.size(), 1U);
    const std::vector<QLineF> strokes = explainingStrokes(shown, camera, fixture.theme);
    QCOMPARE(strokes.size(), 1U);
    QVERIFY(strokes[0].length() > 100.0);
    QCOMPARE(lengthWithin(strokes[0], labels[0].box), 0.0);
}

void SceneLabelsTest::aNameIsNotCutAtTheEdge_data()
{
    QTest::addColumn<QPointF>("anchor");
    QTest::newRow("left") << QPointF(20.0, 200.0);
    QTest::newRow("right") << QPointF(590.0, 200.0);
    QTest::newRow("a corner") << QPointF(5.0, 465.0);
    QTest::newRow("with a body where there is room") << QPointF(300.0, 200.0);
}

void SceneLabelsTest::aNameIsNotCutAtTheEdge()
{
    QFETCH(QPointF, anchor);
    const QRectF area(0.0, 0.0, 600.0, 470.0);
    LabelPlaces places({QRectF(anchor + QPointF(2.0, -150.0), QSizeF(400.0, 300.0))});
    const QRectF box = places.beside(anchor, {120.0, 16.0}, area);
    QVERIFY2(area.contains(box), qPrintable(QString("x %1, y %2").arg(box.x()).arg(box.y())));
}

void SceneLabelsTest::aLabelOfAThingAtRestStays()
{
    const QRectF area(0.0, 0.0, 600.0, 470.0);
    const QSizeF size(117.3, 15.7);
    const auto boxesAt = [&](QPointF at) {
        const QRectF body(at - QPointF(20.0, 20.0), QSizeF(40.0, 40.0));
        return std::array{LabelPlaces({}).beside(at, size, area), LabelPlaces({body}).beside(at, size, area),
                          LabelPlaces({body}).within(area, at - QPointF(58.65, 7.85), size)};
    };
    for (int i = 0; i < 200; ++i) {
        const QPointF at(4.1 + 2.93 * i, 3.7 + 2.31 * i);
        const auto first = boxesAt(at);
        for (int frame = 1; frame < 20; ++frame) { // it moves by rounding errors
            const auto boxes = boxesAt(at + frame * QPointF(1.3e-10, -0.7e-10));
            for (std::size_t k = 0; k < boxes.size(); ++k) {
                const QPointF moved = boxes[k].topLeft() - first[k].topLeft();
                QVERIFY2(std::hypot(moved.x(), moved.y()) < 1e-6,
                         qPrintable(QString("%1, %2").arg(at.x()).arg(at.y())));
                QVERIFY(area.adjusted(-1e-9, -1e-9, 1e-9, 1e-9).contains(boxes[k]));
            }
        }
    }
}

void SceneLabelsTest::labelDoesNotJumpBackAndForth()
{
    SceneFixture fixture("lone");
    SceneContent shown;
    shown.picture = fixture.session.presentation().picture();
    shown.text = fixture.theme.ui(12);
    shown.selected = 0;
    const Camera camera(fixture.view.viewportTransform());
    const QRectF view(fixture.view.viewport()->rect());
    const sim::Vec2 centre = camera.back(view.center());
    struct Place
    {
        QPointF at; ///< of the label, from the arrow's end
        int last;   ///< the last frame that shows it there
    };
    int compared = 0;
    for (int path = 0; path < 240; ++path) {  // the foot creeps to rest
        const double angle = 2.399963 * path; // rad, the golden angle
        const sim::Vec2 away = {std::cos(angle), std::sin(angle)};
        const sim::Vec2 way = {std::cos(2.0 * angle), std::sin(2.0 * angle)};
        const sim::Vec2 from = centre + (20.0 + path % 80) / camera.zoom * away;
        std::vector<Place> places;
        for (int frame = 0; frame < 200; ++frame) {
            const sim::Vec2 foot = from + 0.05 * frame / camera.zoom * way;
            shown.picture.state.place(0, foot);
            shown.picture.overlays = {{.shape = lessons::Overlay::Shape::arrow,
                                       .a = foot,
                                       .b = 0.02 * (centre - foot),
                                       .label = "a pull with a long name"}};
            const auto labels = overlayLabels(shown, camera, fixture.theme, view);
            if (labels.empty())
                continue; // the arrow is too short
            const QLineF arrow = explainingStrokes(shown, camera, fixture.theme).back();
            const QPointF at = labels[0].box.topLeft() - arrow.p2();
            const auto isBack = [&](const Place &one) {
                return QLineF(at, one.at).length() < 1.0 && frame - one.last <= 30; // 1.5 px later
            };
            ++compared;
            if (!places.empty() && isBack(places.back())) {
                places.back().last = frame;
                continue;
            }
            QVERIFY2(std::none_of(places.begin(), places.end(), isBack),
                     qPrintable(QString("path %1, frame %2").arg(path).arg(frame)));
            places.push_back({at, frame});
        }
    }
    QVERIFY(compared > 10'000);
}

void SceneLabelsTest::aPredictionCoversNothing_data()
{
    QTest::addColumn<QPointF>("miss");
    QTest::newRow("exact") << QPointF(0, 0);
    QTest::newRow("on the name of the body") << QPointF(10, 20);
    QTest::newRow("on the spring") << QPointF(-15, -5);
    QTest::newRow("to the left, beyond the spring") << QPointF(-80, 0);
    QTest::newRow("far to the right") << QPointF(230, 0);
    QTest::newRow("far below") << QPointF(0, 180);
}

void SceneLabelsTest::aPredictionCoversNothing()
{
    QFETCH(QPointF, miss);
    SceneFixture fixture("lone");
    SceneContent shown;
    shown.picture = fixture.session.presentation().picture();
    auto withSpring = std::make_shared<lessons::View>(*shown.picture.view);
    withSpring->springs = {{.a = 0, .b = -1, .at = {270, 200}}};
    shown.picture.view = withSpring;
    shown.text = fixture.theme.ui(12);
    shown.selected = 0;
    const sim::Vec2 foot = shown.state().positionOf(0);
    shown.reference = ReferencePlaces{.places = {foot + sim::Vec2{4, 0}}, .farthest = 0, .distance = 4.0};
    const Camera camera(fixture.view.viewportTransform());
    const QRectF view(fixture.view.viewport()->rect());
    const SceneContent noCompanion;
    const LabelPlaces places = Hud(shown, noCompanion, fixture.theme).labelPlaces(camera, view);
    QVERIFY(!places.isFree(nameBox(shown, camera, view)));
    const QPointF onSpring = camera.at((0.5) * (foot + sim::Vec2{270, 200}));
    QVERIFY(!places.isFree({onSpring - QPointF(2, 2), onSpring + QPointF(2, 2)}));

    const sim::Vec2 said = foot + sim::Vec2{miss.x(), miss.y()};
    const OverlayLabel label =
        predictionLabel({said, foot}, camera, freeArea(shown, view), places, shown.text);
    QVERIFY2(places.isFree(label.box), qPrintable(QString("%1, %2").arg(label.box.x()).arg(label.box.y())));
    QVERIFY(view.contains(label.box));
    QVERIFY(!label.box.contains(camera.at(said)) && !label.box.contains(camera.at(foot)));
    QVERIFY(label.text.contains(QString::number(std::lround(sim::length(said - foot)))));
}

void SceneLabelsTest::theLineToAPredictionLeavesTheNameReadable()
{
    SceneFixture fixture("lone");
    SceneContent shown;
    shown.picture = fixture.session.presentation().picture();
    shown.text = fixture.theme.ui(12);
    shown.selected = 0;
    const Camera camera(fixture.view.viewportTransform());
    const QRectF view(fixture.view.viewport()->rect());
    const SceneContent noCompanion;
    const QRectF name = nameBox(shown, camera, view);
    const sim::Vec2 foot = shown.state().positionOf(0), said = foot + sim::Vec2{0, 180};
    const QLineF whole(camera.at(said), camera.at(foot));
    QVERIFY(lengthWithin(whole, name) > 0.0);
    const std::vector<QRectF> texts = Hud(shown, noCompanion, fixture.theme).textBoxes(camera, view);
    const std::vector<QLineF> lines = predictionLines({said, foot}, camera, texts);
    QCOMPARE(lines.size(), 2U);
    QCOMPARE(lines.front().p1(), whole.p1());
    QCOMPARE(lines.back().p2(), whole.p2());
    for (const QLineF &line : lines)
        QCOMPARE(lengthWithin(line, name), 0.0);
}

void SceneLabelsTest::aPullThatIsNotSeenHasNoName()
{
    SceneFixture fixture("lone");
    SceneContent shown;
    shown.picture = fixture.session.presentation().picture();
    shown.text = fixture.theme.ui(12);
    const Camera camera(fixture.view.viewportTransform());
    const QRectF view(fixture.view.viewport()->rect());
    for (const auto &[pull, labels] : {std::pair{3.0, 1U}, {0.0, 0U}}) {
        shown.picture.overlays = {{.shape = lessons::Overlay::Shape::arrow,
                                   .a = shown.state().positionOf(0),
                                   .b = {pull, 0.0},
                                   .label = "a pull"}};
        QCOMPARE(overlayLabels(shown, camera, fixture.theme, view).size(), labels);
    }
}

void SceneLabelsTest::aBoxCoversAPartOfALine_data()
{
    QTest::addColumn<QLineF>("line");
    QTest::addColumn<double>("covered");
    QTest::newRow("through the middle") << QLineF(-5, 2, 20, 2) << 10.0;
    QTest::newRow("beside") << QLineF(-5, 5, 20, 5) << 0.0;
    QTest::newRow("within") << QLineF(8, 1, 5, 1) << 3.0;
    QTest::newRow("ends inside") << QLineF(5, -3, 5, 1) << 1.0;
    QTest::newRow("corner to corner") << QLineF(0, 0, 10, 4) << std::sqrt(116.0);
    QTest::newRow("past a corner") << QLineF(-2, 1, 1, -2) << 0.0;
}

void SceneLabelsTest::aBoxCoversAPartOfALine()
{
    QFETCH(QLineF, line);
    QFETCH(double, covered);
    QVERIFY(std::abs(lengthWithin(line, QRectF(0, 0, 10, 4)) - covered) < 1e-12);
}

void SceneLabelsTest::namesAndNumbersAreReadable_data()
{
    QTest::addColumn<QString>("shown");
    QTest::addColumn<QString>("expected");
    QTest::newRow("a numbered foot") << bodyTitle("foot12") << "foot 12";
    QTest::newRow("a foot of one of several") << bodyTitle("creature1.foot0") << "creature 1, foot 0";
    QTest::newRow("a letter") << bodyTitle("p12") << "p12";
    QTest::newRow("a link of a tentacle") << bodyTitle("tentacle2_5") << "tentacle 2, 5";
    QTest::newRow("minus") << fixedNumber(-3.26, 1) << "−3.3";
    QTest::newRow("no minus nought") << fixedNumber(-0.01, 1) << "0.0";
    QTest::newRow("almost nothing") << shownMagnitude(0.0004) << "< 0.01";
    QTest::newRow("nothing") << shownMagnitude(0.0) << "0.00";
    QTest::newRow("at rest") << bodySentence("foot0", {310, 240}, {0.01, 0})
                             << "foot 0 at (310, 240), at rest";
    QTest::newRow("moving") << bodySentence("foot0", {310, -240}, {0, 2.3})
                            << "foot 0 at (310, −240), moving 2.3 px a frame";
    QTest::newRow("as far as numbers reach")
        << bodySentence("foot0", {1.7e308, -2e200}, {1e308, -1e308})
        << "foot 0 at (1.7·10³⁰⁸, −2·10²⁰⁰), moving 1.4·10³⁰⁸ px a frame";
    QTest::newRow("faster than numbers reach") << bodySentence("foot0", {0, 0}, {1.7e308, 1.7e308})
                                               << "foot 0 at (0, 0), moving 1.8·10³⁰⁸ px a frame";
}

void SceneLabelsTest::namesAndNumbersAreReadable()
{
    QFETCH(QString, shown);
    QFETCH(QString, expected);
    QCOMPARE(shown, expected);
}

void SceneLabelsTest::arrowsHaveAReadableScale_data()
{
    QTest::addColumn<double>("longest");
    QTest::addColumn<double>("settled");
    QTest::addColumn<double>("unit");
    QTest::newRow("of a calm scene") << 2.3 << 0.0 << 1.0;
    QTest::newRow("of a strong pull") << 34.0 << 0.0 << 20.0;
    QTest::newRow("of a weak one") << 0.004 << 0.0 << 0.002;
    QTest::newRow("of nothing") << 0.0 << 0.0 << 1.0;
    QTest::newRow("that still fits stays") << 2.3 << 5.0 << 5.0;
    QTest::newRow("that is too small goes") << 2.3 << 0.5 << 1.0;
    QTest::newRow("that is far too large goes") << 2.3 << 50.0 << 1.0;
}

void SceneLabelsTest::arrowsHaveAReadableScale()
{
    QFETCH(double, longest);
    QFETCH(double, settled);
    QFETCH(double, unit);
    QCOMPARE(arrowUnit(longest, settled > 0.0 ? std::optional(settled) : std::nullopt), unit);
}

SUITE(tst_scene_labels, SceneLabelsTest)
#include "tst_scene_labels.moc"
