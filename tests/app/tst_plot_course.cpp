// What plots keep of a run: samples, windows, and how they follow a session.

#include "app/model/plot_course.h"
#include "app/model/plot_list.h"
#include "plots_bench.h"

#include <QSettings>
#include <QTemporaryDir>
#include <QtTest>

#include <cmath>
#include <random>

using namespace app;
using namespace plots_bench;

namespace {

const Quantity y{Measured::placeY, {}, {}};
const Quantity across{Measured::accelerationX, "foot", {}};

struct Bench
{
    explicit Bench(const char *step = "pair")
    {
        session.openStep("plots", step);
        course.setQuantities({y, across, {}});
        course.setWatched(true);
    }
    bool isThere(std::int64_t frame)
    {
        session.goTo({frame, 0});
        return QTest::qWaitFor([&] { return !session.goingTo() && !course.isReading(); }, 20'000);
    }
    /// Whether each bucket holds what the run itself has at its first frame.
    bool isRight(const Samples &samples, const sim::Track &track)
    {
        for (std::size_t i = 0; i < samples.size(); ++i) {
            const std::int64_t frame = samples.frameOf(i);
            const sim::State state = track.stateAt(frame);
            const double change =
                frame > 0 ? state.velocityOf(0).x - track.stateAt(frame - 1).velocityOf(0).x : std::nan("");
            const double a = samples.at(i, 1).first;
            if (samples.at(i, 0).first != state.positionOf(0).y || samples.at(i, 2).first != double(frame) ||
                !(a == change || (std::isnan(a) && std::isnan(change))))
                return false;
        }
        return true;
    }
    bool isRight() { return isRight(course.run(), session.timeline().track()); }

    LessonLibrary lessons = library();
    Session session{lessons};
    PlotCourse course{session};
};

}

class PlotCourseTest : public QObject
{
    Q_OBJECT

private slots:
    void init()
    {
        static const QTemporaryDir folder;
        QSettings::setDefaultFormat(QSettings::IniFormat);
        QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, folder.path());
        QSettings().clear();
    }

    void bucketsKeepTheFirstTheLowestAndTheHighest_data()
    {
        QTest::addColumn<int>("rows");
        QTest::addColumn<int>("thinned");
        for (const int rows : {1, 2, 7, 64, 1000, 1001}) {
            for (const int thinned : {0, 1, 3})
                QTest::addRow("%d rows, thinned %d times", rows, thinned) << rows << thinned;
        }
    }

    void bucketsKeepTheFirstTheLowestAndTheHighest()
    {
        QFETCH(int, rows);
        QFETCH(int, thinned);
        std::mt19937 random(7);
        std::uniform_real_distribution<double> any(-5.0, 5.0);
        std::vector<double> truth;
        Samples samples(1, 40, 2, 1);
        for (int i = 0; i < rows; ++i) {
            truth.push_back(any(random));
            samples.add(std::span(&truth.back(), 1));
            if (i == rows / 2) {
                for (int time = 0; time < thinned; ++time)
                    samples.thin();
            }
        }
        const std::size_t stride = std::size_t{1} << thinned;
        QCOMPARE(samples.stride(), std::int64_t(stride));
        QCOMPARE(samples.nextFrame(), 40 + 2 * rows);
        QCOMPARE(samples.size(), (truth.size() + stride - 1) / stride);
        for (std::size_t i = 0; i < samples.size(); ++i) {
            const auto from = truth.begin() + std::ptrdiff_t(i * stride);
            const auto to = truth.begin() + std::ptrdiff_t(std::min(truth.size(), (i + 1) * stride));
            QCOMPARE(samples.at(i, 0).first, *from);
            QCOMPARE(samples.at(i, 0).low, *std::min_element(from, to));
            QCOMPARE(samples.at(i, 0).high, *std::max_element(from, to));
            QCOMPARE(samples.frameOf(i), std::int64_t(40 + 2 * i * stride));
        }
    }

    void whatIsForgottenCanBeAddedAgain()
    {
        Samples samples(1, 0, 1, 4);
        for (double value = 0.0; value < 22.0; value += 1.0)
            samples.add(std::span(&value, 1));
        samples.forgetAfter(21);
        QCOMPARE(samples.nextFrame(), 22);
        samples.forgetAfter(13); // 12 to 15 share a bucket
        QCOMPARE(samples.nextFrame(), 12);
        QCOMPARE(samples.size(), 3);
        samples.forgetBefore(8);
        QCOMPARE(samples.firstFrame(), 8);
        QCOMPARE(samples.at(0, 0).first, 8.0);
        QCOMPARE(samples.nextFrame(), 12);
        samples.forgetAfter(2);
        QVERIFY(samples.isEmpty());
    }

    void aWindowHasTheCursorAndStandsStillAsLongAsItDoes()
    {
        std::mt19937 random(3);
        PlotWindow window;
        std::int64_t at = 0, computed = 0;
        int moves = 0;
        for (int i = 0; i < 4000; ++i) { // plays
            at = computed = i;
            const PlotWindow next = windowAfter(window, {at, computed, 1, 480});
            moves += next == window ? 0 : 1;
            window = next;
            QVERIFY(window.first <= at && at <= window.last && window.first >= 0);
            QVERIFY(window.last - window.first <= 480);
        }
        QVERIFY2(moves < 4000 / 50, qPrintable(QString::number(moves)));
        for (int i = 0; i < 2000; ++i) { // is dragged anywhere
            at = std::uniform_int_distribution<std::int64_t>(0, computed)(random);
            const PlotWindow next = windowAfter(window, {at, computed, 1, 480});
            QVERIFY(next.first <= at && at <= next.last && next.first >= 0);
            QCOMPARE(next.last - next.first, 480);
            if (window.first <= at && at <= window.last)
                QCOMPARE(next, window);
            window = next;
        }
    }

    void aRangeHoldsItsNumbersAndIsQuiet()
    {
        PlotRange range;
        int changes = 0;
        for (int i = 0; i < 400; ++i) { // a swing that dies away
            const double most = 30.0 * std::pow(0.99, i);
            const PlotRange next = rangeAfter(range, 200.0 - most, 200.0 + 0.9 * most);
            changes += next == range ? 0 : 1;
            range = next;
            QVERIFY(range.low <= 200.0 - most && range.high >= 200.0 + 0.9 * most);
            QVERIFY(1.9 * most > 0.3 * (range.high - range.low));
        }
        QVERIFY2(changes < 10, qPrintable(QString::number(changes)));
        const PlotRange flat = rangeAfter(range, 200.0, 200.0 + 1e-11);
        QVERIFY(flat.high - flat.low >= 1.0);
        QVERIFY(flat.low < 200.0 && flat.high > 200.0);
    }

    void samplesAreTheRunItself()
    {
        Bench bench;
        QVERIFY(bench.isThere(300));
        QCOMPARE(bench.course.run().size(), 301);
        QVERIFY(bench.isRight());
        QVERIFY(bench.isThere(40)); // back: nothing is lost
        QCOMPARE(bench.course.run().size(), 301);
        QVERIFY(bench.isThere(1200));
        QVERIFY(bench.course.window().first > 0);
        QVERIFY(bench.isRight());
    }

    void aChangeIsReadAnewAndLeavesTheGhost()
    {
        Bench bench;
        QVERIFY(bench.isThere(200));
        QVERIFY(bench.course.ghost().isEmpty());
        QVERIFY(bench.isThere(80));
        bench.session.setParameter("k", 0.3);
        QVERIFY(bench.isThere(200));
        QVERIFY(bench.isRight());
        const Samples &ghost = bench.course.ghost();
        QCOMPARE(ghost.firstFrame(), 80); // the last moment that both share
        QCOMPARE(ghost.nextFrame(), 201);
        QVERIFY(bench.isRight(ghost, *bench.session.timeline().comparison()));
        const std::size_t at = bench.course.run().bucketNear(150);
        QVERIFY(bench.course.run().at(at, 0).first != ghost.at(ghost.bucketNear(150), 0).first);
        bench.session.forgetGhost();
        QVERIFY(bench.course.ghost().isEmpty());
    }

    void aHandThatDragsWhileTheRunStandsIsFollowed()
    {
        Bench bench;
        QVERIFY(bench.isThere(100));
        QVERIFY(bench.isThere(50));
        bench.session.grab("foot");
        for (int i = 0; i < 20; ++i) {
            bench.session.moveHand({300.0 + i, 220.0});
            bench.session.frameForward();
        }
        bench.session.letGo();
        QVERIFY(bench.isThere(120));
        QVERIFY(bench.isRight());
        QVERIFY(bench.isRight(bench.course.ghost(), *bench.session.timeline().comparison()));
        bench.session.undo();
        QVERIFY(bench.isThere(90));
        QVERIFY(bench.isRight());
    }

    void insideAFrameTheNumbersAreThoseOfTheMoment()
    {
        Bench bench("fall");
        QVERIFY(bench.isThere(10));
        const double before = bench.course.now()[0];
        bench.session.phaseForward(); // forces
        QCOMPARE(bench.course.now()[0], before);
        while (bench.session.timeline().cursor().phase > 0)
            bench.session.phaseForward();
        QCOMPARE(bench.session.timeline().cursor().frame, 11);
        QCOMPARE(bench.course.now()[0], fallFrom + gravity * 11.0 * 12.0 / 2.0);
    }

    void whatFollowsTheSelectedBodyIsReadAnew()
    {
        Bench bench;
        QVERIFY(bench.isThere(60));
        bench.session.select("body");
        QTRY_VERIFY(!bench.course.isReading());
        const sim::Track &track = bench.session.timeline().track();
        QCOMPARE(bench.course.run().at(30, 0).first, track.stateAt(30).positionOf(1).y);
        QCOMPARE(bench.course.run().at(30, 1).first,
                 track.stateAt(30).velocityOf(0).x - track.stateAt(29).velocityOf(0).x);
    }

    void aLongRunTakesNoMoreMemory()
    {
        Bench bench("swing");
        bench.course.setMostRows(PlotCourse::allRows);
        QVERIFY(bench.isThere(60'000));
        const Samples &samples = bench.course.run();
        QVERIFY(samples.size() <= std::size_t(PlotCourse::mostBuckets));
        QCOMPARE(samples.nextFrame(), 60'001);
        const sim::Track &track = bench.session.timeline().track();
        for (std::size_t i = 0; i < samples.size(); i += 97) {
            double low = 1e9, high = -1e9;
            for (std::int64_t frame = samples.frameOf(i);
                 frame < std::min(samples.frameOf(i + 1), samples.nextFrame()); ++frame) {
                const double value = track.stateAt(frame).positionOf(0).y;
                low = std::min(low, value);
                high = std::max(high, value);
            }
            QCOMPARE(samples.at(i, 0).low, low);
            QCOMPARE(samples.at(i, 0).high, high);
        }
    }

    void nothingIsReadWhileNobodyLooks()
    {
        Bench bench;
        QVERIFY(bench.isThere(50));
        bench.course.setWatched(false);
        const quint64 revision = bench.course.revision();
        QVERIFY(bench.isThere(90));
        bench.session.setParameter("k", 0.3);
        QCOMPARE(bench.course.revision(), revision);
        bench.course.setWatched(true);
        QVERIFY(bench.isThere(100));
        QVERIFY(bench.isRight());
    }

    void theFirstPlotIsOfWhatMoves_data()
    {
        QTest::addColumn<double>("x");
        QTest::addColumn<double>("y");
        QTest::addColumn<QString>("shown");
        // A point on a spring to (0, 0), which lets go of it at this place.
        QTest::newRow("across") << 80.0 << 0.0 << "x";
        QTest::newRow("down") << 0.0 << 80.0 << "y";
        QTest::newRow("aslant") << 80.0 << 80.0 << "y";
        QTest::newRow("at rest") << 0.0 << 0.0 << "y";
    }
    void theFirstPlotIsOfWhatMoves()
    {
        QFETCH(double, x);
        QFETCH(double, y);
        sim::Script script;
        script.build = [x, y](const sim::Values &) {
            sim::Scene scene = scenes::singleFoot();
            scene.start.place(0, {x, y});
            scenes::add<sim::PointSpring>(scene, 0, sim::Vec2{}, 0.2);
            return scene;
        };
        script.method = sim::findMethod("semi_implicit_euler");
        QTEST(idOf(firstPlot(script).up.what), "shown");
    }

    void plotsAreKeptUntilTheyAreRemoved()
    {
        const sim::Script script = Bench("pair").session.timeline().script();
        {
            PlotList list;
            list.open(script);
            QCOMPARE(list.plots().size(), 1);
            QCOMPARE(list.plots().front(), firstPlot(script));
        }
        {
            PlotList list; // nobody has chosen: nothing is kept
            QVERIFY(list.plots().empty());
            list.open(script);
            list.add({{Measured::velocityY, "foot, \"5\"(x)"}, {Measured::distance, {}, "body"}});
            QCOMPARE(list.plots().size(), 2);
        }
        {
            PlotList list;
            list.open(script);
            QCOMPARE(list.plots().size(), 2);
            QCOMPARE(list.plots()[1].up, (Quantity{Measured::velocityY, "foot, \"5\"(x)"}));
            QCOMPARE(list.plots()[1].across, (Quantity{Measured::distance, {}, "body"}));
            list.remove(0);
            list.remove(0);
        }
        PlotList list;
        list.open(script);
        QVERIFY(list.plots().empty()); // so the learner wanted it
        for (int i = 0; i < 20; ++i)
            list.add(firstPlot(script));
        QCOMPARE(list.plots().size(), PlotList::most);
    }

    void settingsThatMakeNoSenseAreLeftOut()
    {
        QSettings settings;
        settings.beginWriteArray("plots/list", 3);
        settings.setArrayIndex(0);
        settings.setValue("up_what", "heat");
        settings.setArrayIndex(1);
        settings.setValue("up_what", "speed");
        settings.setValue("across_what", "time");
        settings.endArray();
        settings.setValue("plots/list/size", 1'000'000'000);
        const PlotList list;
        QCOMPARE(list.plots().size(), 1);
        QCOMPARE(list.plots().front(), (PlotSpec{{Measured::speed}, {}}));
    }
};

QTEST_MAIN(PlotCourseTest)
#include "tst_plot_course.moc"
