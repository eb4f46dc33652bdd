// The measures of a run, and how they are shown.

#include "lessons/api/view/view.h"
#include "tests/app/scene/drawn_scenes.h"

#include "app/model/series/measure_series.h"
#include "app/ui/parameters/measure_panel.h"
#include "app/ui/parameters/measure_row.h"
#include "app/ui/time/footfall_strip.h"
#include "app/ui/time/timeline_strip.h"
#include "tests/app/support/waiting.h"
#include "tests/suite.h"

#include <QSettings>
#include <QtTest>

#include <limits>

using namespace app;

namespace {

constexpr double glideSpeed = 3.0; ///< px/frame
constexpr int glideStride = 10;    ///< frames that a foot stands, then flies
constexpr double glideStart = 100.0;

/// Two feet that glide to the right. Foot p0 stands in frames 0 to 9, 20 to 29...; p1 in the others.
lessons::Step glide()
{
    sim::Scene scene = scenes::pointsAt({{glideStart, 100}, {glideStart, 150}});
    drawn_scenes::letGlide(scene, {glideSpeed, 0.0});
    lessons::View view = drawn_scenes::feetOnly(scene);
    view.feet = {0, 1};
    lessons::Step step = drawn_scenes::step("glide", scene, view);
    step.parameters = {{"k", "k", {}, {}, "k", 0.0, 0.0, 1.0, 0.0, 1.0, 2, {}}};
    step.measures = {
        {"Place", "px", "Where p0 is.", 1,
         [](const sim::Scene &, const sim::State &state, const sim::State *, const sim::Values &) {
             return state.positionOf(0).x;
         }},
        {"Way", "px", "How far p0 came in the frame.", 1,
         [](const sim::Scene &, const sim::State &state, const sim::State *before, const sim::Values &) {
             return before ? state.positionOf(0).x - before->positionOf(0).x : std::nan("");
         }},
        {"Stiffness",
         {},
         "k as it is.",
         2,
         [](const sim::Scene &, const sim::State &, const sim::State *, const sim::Values &values) {
             return values["k"];
         }},
        {"Nothing",
         {},
         "A little below nothing.",
         1,
         [](const sim::Scene &, const sim::State &, const sim::State *, const sim::Values &) {
             return -0.01;
         }},
        {"Much",
         {},
         "A number with too many digits.",
         1,
         [](const sim::Scene &, const sim::State &, const sim::State *, const sim::Values &) {
             return 4.8e10;
         }},
    };
    step.isFootDown = [](const sim::Scene &, const sim::State &state, const sim::Values &, int point) {
        return state.frame / glideStride % 2 == point;
    };
    return step;
}

lessons::Step plain()
{
    const sim::Scene scene = scenes::pointsAt({{glideStart, 100}});
    return drawn_scenes::step("plain", scene, drawn_scenes::feetOnly(scene));
}

/// A step that measures its whole run. The run is exact, so only its cost decides.
lessons::Step whole()
{
    sim::Scene scene = scenes::pointsAt({{glideStart, 100}});
    drawn_scenes::letGlide(scene, {glideSpeed, 0.0});
    lessons::Step step = drawn_scenes::step("whole", scene, drawn_scenes::feetOnly(scene));
    lessons::Measure measure = {
        .name = "Step", .unit = "frames", .help = "The step of the run.", .decimals = 2};
    measure.ofRun = [](const sim::Script &script, const sim::Scene &, const sim::State &, const sim::State *,
                       const sim::Values &) { return script.step.h; };
    step.measures = {measure};
    step.runOverlays = [](const sim::Script &script, const sim::State &, std::int64_t frame) {
        return std::vector<lessons::Overlay>{
            {.shape = lessons::Overlay::Shape::cross, .a = {double(frame), script.step.h}}};
    };
    const auto came = [](const sim::Timeline &run) { return run.cursor().frame >= 10; };
    const double anyPrice = std::numeric_limits<double>::infinity();
    step.tries = {{"For nothing.", came, lessons::Budget{1e-6, 0.0, 10}},
                  {"At any price.", came, lessons::Budget{1e-6, anyPrice, 10}},
                  {"More exact than can be.", came, lessons::Budget{-1.0, anyPrice, 10}},
                  {"Just there.", came}};
    return step;
}

struct MeasuredRun
{
    LessonLibrary library = [] {
        LessonEntry entry;
        entry.id = "lesson";
        entry.steps = {glide(), plain(), whole()};
        LessonLibrary made;
        made.lessons = {entry};
        return made;
    }();
    Session session{library};
    MeasureSeries series{session.run()};
    Theme theme{Scheme::light};

    /// Goes to a frame, and waits until everything is measured.
    bool goTo(std::int64_t frame)
    {
        session.playback().goTo({frame, 0});
        return QTest::qWaitFor(
            [&] { return !session.playback().goal() && series.last() >= session.timeline().computed(); });
    }
};

}

class TestMeasureSeries : public QObject
{
    Q_OBJECT

private slots:
    void everyComputedRowIsMeasured_data()
    {
        QTest::addColumn<double>("h");
        QTest::newRow("one step a frame") << 1.0;
        QTest::newRow("four steps a frame") << 0.25;
        QTest::newRow("three frames a step") << 3.0;
    }
    void everyComputedRowIsMeasured()
    {
        QFETCH(double, h);
        MeasuredRun fixture;
        fixture.session.editor().setStepSize(h);
        QVERIFY(fixture.goTo(99));
        const std::int64_t row = fixture.series.framesPerOutput();
        QCOMPARE(row, std::int64_t(h > 1.0 ? h : 1.0));
        for (std::int64_t frame = 0; frame <= 99; frame += row) {
            const Sample *sample = fixture.series.at(frame);
            QVERIFY(sample);
            QCOMPARE(sample->measures[0], glideStart + glideSpeed * double(frame));
            if (frame > 0)
                QCOMPARE(sample->measures[1], glideSpeed * double(row));
        }
        QVERIFY(std::isnan(fixture.series.at(0)->measures[1]));
        QVERIFY(!fixture.series.at(99 + row));
    }

    void framesAfterAChangeAreMeasuredAgain()
    {
        MeasuredRun fixture;
        QVERIFY(fixture.goTo(60));
        fixture.session.playback().goTo({30, 0});
        fixture.session.editor().setParameter("k", 0.5);
        QVERIFY(fixture.goTo(50));
        QCOMPARE(fixture.series.last(), std::int64_t(50));
        QCOMPARE(fixture.series.at(30)->measures[2], 0.0);
        QCOMPARE(fixture.series.at(31)->measures[2], 0.5);
        QCOMPARE(fixture.series.at(31)->measures[1], glideSpeed);
        fixture.session.playback().goTo({0, 0});
        fixture.session.editor().setParameter("k", 0.25);
        QVERIFY(fixture.goTo(20));
        QCOMPARE(fixture.series.at(10)->measures[2], 0.25);
    }

    void stancesAndSlipsAreThoseOfTheRun()
    {
        MeasuredRun fixture;
        QVERIFY(fixture.goTo(45));
        Stances stances;
        stances.follow(fixture.series, 2);
        const std::vector<Stance> &first = stances.of(0);
        QCOMPARE(first.size(), std::size_t(3));
        QCOMPARE(first[0].from, std::int64_t(0));
        QCOMPARE(first[0].to, std::int64_t(glideStride - 1));
        QCOMPARE(first[0].slip, (glideStride - 1) * glideSpeed);
        QCOMPARE(first[2].from, std::int64_t(40));
        QCOMPARE(first[2].to, std::int64_t(45));
        QCOMPARE(stances.of(1).front().from, std::int64_t(glideStride));
    }

    void incrementalStancesEqualFreshOnes()
    {
        MeasuredRun fixture;
        Stances followed;
        QObject::connect(&fixture.series, &MeasureSeries::changed, &fixture.series,
                         [&] { followed.follow(fixture.series, 2); });
        const auto same = [&] {
            Stances fresh;
            fresh.follow(fixture.series, 2);
            return !fresh.of(0).empty() && fresh.of(0) == followed.of(0) && fresh.of(1) == followed.of(1);
        };
        for (const std::int64_t frame : {1, 2, 7, 45, 46, 90}) {
            QVERIFY(fixture.goTo(frame));
            QVERIFY(same());
        }
        fixture.session.playback().goTo({33, 0});
        QVERIFY(same());
        fixture.session.editor().setParameter("k", 0.5); // what comes after is another run
        QVERIFY(same());
        QVERIFY(fixture.goTo(70));
        QVERIFY(same());
        fixture.session.playback().goTo({0, 0});
        fixture.session.editor().setParameter("k", 0.25);
        QVERIFY(fixture.goTo(20));
        QVERIFY(same());
    }

    void feetDiagramShowsStancesAndAClickGoesToItsFrame()
    {
        MeasuredRun fixture;
        TimelineStrip timeline(fixture.session, fixture.theme);
        FootfallStrip strip(fixture.session.run(), fixture.session.playback(), fixture.session.preview(),
                            fixture.series, timeline, fixture.theme);
        timeline.resize(600, 98);
        strip.resize(600, strip.sizeHint().height());
        strip.show();
        timeline.show();
        QVERIFY(fixture.goTo(45));
        QCOMPARE(strip.sentence(), QString("p0 stands, slipped 15\u202Fpx. p1 is in the air."));
        QCOMPARE(strip.accessibleDescription(), strip.sentence());
        const QImage shown = strip.grab().toImage();
        const auto at = [&](std::int64_t frame, int row) {
            return shown.pixelColor(qRound(timeline.axis().xOf(frame)), 18 + 14 * row + 3);
        };
        const QColor standing = fixture.theme.tokens().contact;
        QCOMPARE(at(3, 0), standing);
        QVERIFY(at(14, 0) != standing);
        QCOMPARE(at(17, 1), standing);
        QTest::mouseClick(&strip, Qt::LeftButton, {}, {qRound(timeline.axis().xOf(12)), 30});
        QCOMPARE(fixture.session.timeline().cursor().frame, std::int64_t(12));
        fixture.session.openStep("lesson", "plain");
        QVERIFY(strip.isHidden());
    }

    void measuresShowTheFrameOfTheCursor()
    {
        MeasuredRun fixture;
        MeasurePanel panel(fixture.session.run(), fixture.session.playback(), fixture.session.preview(),
                           fixture.series, fixture.theme);
        panel.resize(400, 300);
        panel.show();
        const QList<MeasureRow *> rows = panel.findChildren<MeasureRow *>();
        QCOMPARE(rows.size(), 5);
        QCOMPARE(rows[1]->number(), QString("–"));
        QVERIFY(fixture.goTo(40));
        QTRY_COMPARE(rows[0]->number(), QString("220.0"));
        QCOMPARE(rows[1]->number(), QString("3.0"));
        QCOMPARE(rows[3]->number(), QString("0.0")); // not −0.0
        QCOMPARE(rows[4]->number(), QString("4.8·10¹⁰"));
        fixture.session.playback().goTo({10, 0});
        QTRY_COMPARE(rows[0]->number(), QString("130.0"));
        QCOMPARE(rows[0]->accessibleDescription(), QString("130.0 px. Where p0 is."));
        fixture.session.openStep("lesson", "plain");
        QVERIFY(panel.isEmpty());
    }

    void aMeasureOfTheWholeRunReceivesTheScript()
    {
        MeasuredRun fixture;
        fixture.session.openStep("lesson", "whole");
        fixture.session.editor().setStepSize(0.5);
        QVERIFY(fixture.goTo(20));
        QCOMPARE(fixture.series.at(20)->measures.at(0), 0.5);
        const std::vector<lessons::Overlay> overlays = fixture.session.presentation().picture().overlays;
        QCOMPARE(overlays.size(), std::size_t{1});
        QCOMPARE(overlays[0].a, (sim::Vec2{20.0, 0.5}));
    }

    void runWithinItsBudgetTicksTheThingToTry()
    {
        MeasuredRun fixture;
        fixture.session.progress().forgetLesson("lesson");
        fixture.session.openStep("lesson", "whole");
        const auto done = [&](int number) {
            return fixture.session.progress().isDone("lesson", "whole", number);
        };
        fixture.session.playback().goTo({9, 0});
        QVERIFY(!done(1) && !done(3));
        fixture.session.playback().goTo({10, 0});
        QVERIFY(!done(0));
        QVERIFY(done(1));
        QVERIFY(!done(2));
        QVERIFY(done(3));
    }

    void stepWithoutMeasuresMeasuresNothing()
    {
        MeasuredRun fixture;
        fixture.session.openStep("lesson", "plain");
        fixture.session.playback().goTo({30, 0});
        QTRY_VERIFY(!fixture.session.playback().goal());
        tests::settle(); // so that slices of work that are due would have run
        QVERIFY(fixture.series.isEmpty());
    }
};

SUITE(tst_measure_series, TestMeasureSeries)
#include "tst_measure_series.moc"
