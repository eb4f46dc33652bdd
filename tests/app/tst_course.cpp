// What is measured of a run, and how it is shown.

#include "lessons/api/view/view.h"
#include "look_scenes.h"

#include "app/model/course.h"
#include "app/ui/panels/measure_panel.h"
#include "app/ui/panels/measure_row.h"
#include "app/ui/time/footfall_strip.h"
#include "app/ui/time/timeline_strip.h"

#include <QSettings>
#include <QStandardPaths>
#include <QtTest>

#include <limits>

using namespace app;

namespace {

constexpr double speed = 3.0; ///< px/frame
constexpr int stride = 10;    ///< frames that a foot stands, then flies
constexpr double start = 100.0;

/// Two feet that glide to the right. Foot p0 stands in frames 0 to 9, 20 to 29...; p1 in the others.
lessons::Step glide()
{
    sim::Scene scene = scenes::pointsAt({{start, 100}, {start, 150}});
    look_scenes::letGlide(scene, {speed, 0.0});
    lessons::View look = look_scenes::feetOnly(scene);
    look.feet = {0, 1};
    lessons::Step step = look_scenes::step("glide", scene, look);
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
    };
    step.isFootDown = [](const sim::Scene &, const sim::State &state, const sim::Values &, int point) {
        return state.frame / stride % 2 == point;
    };
    return step;
}

lessons::Step plain()
{
    const sim::Scene scene = scenes::pointsAt({{start, 100}});
    return look_scenes::step("plain", scene, look_scenes::feetOnly(scene));
}

/// A step that looks at its run as a whole. Its run is exact, so that only the price decides.
lessons::Step whole()
{
    sim::Scene scene = scenes::pointsAt({{start, 100}});
    look_scenes::letGlide(scene, {speed, 0.0});
    lessons::Step step = look_scenes::step("whole", scene, look_scenes::feetOnly(scene));
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

struct Bench
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
    Course course{session};
    Theme theme{Scheme::light};

    /// Goes there, and waits until all is measured.
    bool goTo(std::int64_t frame)
    {
        session.goTo({frame, 0});
        return QTest::qWaitFor(
            [&] { return !session.goingTo() && course.last() >= session.timeline().computed(); });
    }
};

}

class TestCourse : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase() { QStandardPaths::setTestModeEnabled(true); }

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
        Bench bench;
        bench.session.setStepSize(h);
        QVERIFY(bench.goTo(99));
        const std::int64_t row = bench.course.rowFrames();
        QCOMPARE(row, std::int64_t(h > 1.0 ? h : 1.0));
        for (std::int64_t frame = 0; frame <= 99; frame += row) {
            const Sample *sample = bench.course.at(frame);
            QVERIFY(sample);
            QCOMPARE(sample->measures[0], start + speed * double(frame));
            if (frame > 0)
                QCOMPARE(sample->measures[1], speed * double(row));
        }
        QVERIFY(std::isnan(bench.course.at(0)->measures[1]));
        QVERIFY(!bench.course.at(99 + row));
    }

    void whatAChangeMakesWrongIsMeasuredAgain()
    {
        Bench bench;
        QVERIFY(bench.goTo(60));
        bench.session.goTo({30, 0});
        bench.session.setParameter("k", 0.5);
        QVERIFY(bench.goTo(50));
        QCOMPARE(bench.course.last(), std::int64_t(50));
        QCOMPARE(bench.course.at(30)->measures[2], 0.0);
        QCOMPARE(bench.course.at(31)->measures[2], 0.5);
        QCOMPARE(bench.course.at(31)->measures[1], speed);
        bench.session.goTo({0, 0});
        bench.session.setParameter("k", 0.25);
        QVERIFY(bench.goTo(20));
        QCOMPARE(bench.course.at(10)->measures[2], 0.25);
    }

    void stancesAndSlipsAreThoseOfTheRun()
    {
        Bench bench;
        QVERIFY(bench.goTo(45));
        Stances stances;
        stances.follow(bench.course, 2);
        const std::vector<Stance> &first = stances.of(0);
        QCOMPARE(first.size(), std::size_t(3));
        QCOMPARE(first[0].from, std::int64_t(0));
        QCOMPARE(first[0].to, std::int64_t(stride - 1));
        QCOMPARE(first[0].slip, (stride - 1) * speed);
        QCOMPARE(first[2].from, std::int64_t(40));
        QCOMPARE(first[2].to, std::int64_t(45));
        QCOMPARE(stances.of(1).front().from, std::int64_t(stride));
    }

    void stancesThatAreReadAsTheyComeAreTheSame()
    {
        Bench bench;
        Stances followed;
        QObject::connect(&bench.course, &Course::changed, &bench.course,
                         [&] { followed.follow(bench.course, 2); });
        const auto same = [&] {
            Stances fresh;
            fresh.follow(bench.course, 2);
            return !fresh.of(0).empty() && fresh.of(0) == followed.of(0) && fresh.of(1) == followed.of(1);
        };
        for (const std::int64_t frame : {1, 2, 7, 45, 46, 90}) {
            QVERIFY(bench.goTo(frame));
            QVERIFY(same());
        }
        bench.session.goTo({33, 0});
        QVERIFY(same());
        bench.session.setParameter("k", 0.5); // what comes after is another run
        QVERIFY(same());
        QVERIFY(bench.goTo(70));
        QVERIFY(same());
        bench.session.goTo({0, 0});
        bench.session.setParameter("k", 0.25);
        QVERIFY(bench.goTo(20));
        QVERIFY(same());
    }

    void theFeetDiagramTellsWhoStandsAndGoesThere()
    {
        Bench bench;
        TimelineStrip timeline(bench.session, bench.theme);
        FootfallStrip strip(bench.session, bench.course, timeline, bench.theme);
        timeline.resize(600, 98);
        strip.resize(600, strip.sizeHint().height());
        strip.show();
        timeline.show();
        QVERIFY(bench.goTo(45));
        QCOMPARE(strip.sentence(), QString("p0 stands, slipped 15\u202Fpx. p1 is in the air."));
        QCOMPARE(strip.accessibleDescription(), strip.sentence());
        const QImage shown = strip.grab().toImage();
        const auto at = [&](std::int64_t frame, int row) {
            return shown.pixelColor(qRound(timeline.axis().xOf(frame)), 18 + 14 * row + 3);
        };
        const QColor standing = bench.theme.tokens().contact;
        QCOMPARE(at(3, 0), standing);
        QVERIFY(at(14, 0) != standing);
        QCOMPARE(at(17, 1), standing);
        QTest::mouseClick(&strip, Qt::LeftButton, {}, {qRound(timeline.axis().xOf(12)), 30});
        QCOMPARE(bench.session.timeline().cursor().frame, std::int64_t(12));
        bench.session.openStep("lesson", "plain");
        QVERIFY(strip.isHidden());
    }

    void theMeasuresStandAtTheCursor()
    {
        Bench bench;
        MeasurePanel panel(bench.session, bench.course, bench.theme);
        panel.resize(400, 300);
        panel.show();
        const QList<MeasureRow *> rows = panel.findChildren<MeasureRow *>();
        QCOMPARE(rows.size(), 4);
        QCOMPARE(rows[1]->number(), QString("–"));
        QVERIFY(bench.goTo(40));
        QTRY_COMPARE(rows[0]->number(), QString("220.0"));
        QCOMPARE(rows[1]->number(), QString("3.0"));
        QCOMPARE(rows[3]->number(), QString("0.0")); // not −0.0
        bench.session.goTo({10, 0});
        QTRY_COMPARE(rows[0]->number(), QString("130.0"));
        QCOMPARE(rows[0]->accessibleDescription(), QString("130.0 px. Where p0 is."));
        bench.session.openStep("lesson", "plain");
        QVERIFY(panel.isEmpty());
    }

    void whatLooksAtTheWholeRunIsGivenItsScript()
    {
        Bench bench;
        bench.session.openStep("lesson", "whole");
        bench.session.setStepSize(0.5);
        QVERIFY(bench.goTo(20));
        QCOMPARE(bench.course.at(20)->measures.at(0), 0.5);
        const std::vector<lessons::Overlay> guides = bench.session.picture().guides;
        QCOMPARE(guides.size(), std::size_t{1});
        QCOMPARE(guides[0].a, (sim::Vec2{20.0, 0.5}));
    }

    void aTryWithABudgetIsDoneByARunThatKeepsIt()
    {
        Bench bench;
        bench.session.progress().forgetAll();
        bench.session.openStep("lesson", "whole");
        const auto done = [&](int number) {
            return bench.session.progress().isDone("lesson", "whole", number);
        };
        bench.session.goTo({9, 0});
        QVERIFY(!done(1) && !done(3));
        bench.session.goTo({10, 0});
        QVERIFY(!done(0));
        QVERIFY(done(1));
        QVERIFY(!done(2));
        QVERIFY(done(3));
    }

    void nothingIsMeasuredWhereNothingIsAsked()
    {
        Bench bench;
        bench.session.openStep("lesson", "plain");
        bench.session.goTo({30, 0});
        QTest::qWait(20);
        QVERIFY(bench.course.isEmpty());
    }
};

int main(int count, char **arguments)
{
    QApplication application(count, arguments);
    QLocale::setDefault(QLocale::c());
    TestCourse suite;
    return QTest::qExec(&suite, count, arguments);
}
#include "tst_course.moc"
