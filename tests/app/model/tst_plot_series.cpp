// The samples and ranges that plots keep of a run, and how they follow a session.

#include "app/model/series/plot_list.h"
#include "app/model/series/plot_series.h"
#include "tests/app/model/plots_support.h"
#include "tests/suite.h"

#include <QSettings>
#include <QtTest>

#include <cmath>
#include <random>

using namespace app;
using namespace plots_support;

namespace {

const Quantity heightOfBodies{QuantityKind::placeY, {}, {}};
const Quantity sidewaysAcceleration{QuantityKind::accelerationX, "foot", {}};

struct PlottedRun
{
    explicit PlottedRun(const char *step = "pair")
    {
        session.openStep("plots", step);
        series.setQuantities({heightOfBodies, sidewaysAcceleration, {}});
        series.setActive(true);
    }
    bool isThere(std::int64_t frame)
    {
        session.playback().goTo({frame, 0});
        return QTest::qWaitFor([&] { return !session.playback().goal() && !series.isReading(); }, 20'000);
    }
    /// Returns whether each bucket has the run's values at the bucket's first frame.
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
    bool isRight() { return isRight(series.run(), session.timeline().track()); }

    LessonLibrary lessons = library();
    Session session{lessons};
    PlotSeries series{session.run(), session.playback(), session.comparisons()};
};

}

class PlotSeriesTest : public QObject
{
    Q_OBJECT

private slots:
    void init() { QSettings().clear(); }

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

    void forgottenSamplesCanBeAddedAgain()
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

    void windowContainsTheCursorAndMovesOnlyWhenItMust()
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
        QVERIFY2(moves >= 4000 / 480 && moves < 4000 / 50, qPrintable(QString::number(moves)));
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

    void rangeContainsItsNumbersAndSeldomChanges()
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
        QVERIFY2(changes > 1 && changes < 10, qPrintable(QString::number(changes)));
        const PlotRange flat = rangeAfter(range, 200.0, 200.0 + 1e-11);
        QVERIFY(flat.high - flat.low >= 1.0);
        QVERIFY(flat.low < 200.0 && flat.high > 200.0);
    }

    void samplesEqualTheRun()
    {
        PlottedRun fixture;
        QVERIFY(fixture.isThere(300));
        QCOMPARE(fixture.series.run().size(), 301);
        QVERIFY(fixture.isRight());
        QVERIFY(fixture.isThere(40)); // back: nothing is lost
        QCOMPARE(fixture.series.run().size(), 301);
        QVERIFY(fixture.isThere(1200));
        QVERIFY(fixture.series.window().first > 0);
        QVERIFY(fixture.isRight());
    }

    void aChangeIsReadAgainAndLeavesTheGhost()
    {
        PlottedRun fixture;
        QVERIFY(fixture.isThere(200));
        QVERIFY(fixture.series.comparison().isEmpty());
        QVERIFY(fixture.isThere(80));
        fixture.session.editor().setParameter("k", 0.3);
        QVERIFY(fixture.isThere(200));
        QVERIFY(fixture.isRight());
        const Samples &comparison = fixture.series.comparison();
        QCOMPARE(comparison.firstFrame(), 80); // the last moment that both share
        QCOMPARE(comparison.nextFrame(), 201);
        QVERIFY(fixture.isRight(comparison, *fixture.session.timeline().comparison()));
        const std::size_t at = fixture.series.run().bucketNear(150);
        QVERIFY(fixture.series.run().at(at, 0).first != comparison.at(comparison.bucketNear(150), 0).first);
        fixture.session.comparisons().removeShown();
        QVERIFY(fixture.series.comparison().isEmpty());
    }

    void dragInThePastIsFollowed()
    {
        PlottedRun fixture;
        QVERIFY(fixture.isThere(100));
        QVERIFY(fixture.isThere(50));
        fixture.session.input().grab("foot");
        for (int i = 0; i < 20; ++i) {
            fixture.session.input().moveTo({300.0 + i, 220.0});
            fixture.session.playback().frameForward();
        }
        fixture.session.input().release();
        QVERIFY(fixture.isThere(120));
        QVERIFY(fixture.isRight());
        QVERIFY(fixture.isRight(fixture.series.comparison(), *fixture.session.timeline().comparison()));
        fixture.session.editor().undo();
        QVERIFY(fixture.isThere(90));
        QVERIFY(fixture.isRight());
    }

    void insideAFrameTheNumbersAreThoseOfTheMoment()
    {
        PlottedRun fixture("fall");
        QVERIFY(fixture.isThere(10));
        const double before = fixture.series.now()[0];
        fixture.session.playback().phaseForward(); // forces
        QCOMPARE(fixture.series.now()[0], before);
        while (fixture.session.timeline().cursor().phase > 0)
            fixture.session.playback().phaseForward();
        QCOMPARE(fixture.session.timeline().cursor().frame, 11);
        QCOMPARE(fixture.series.now()[0], fallFrom + gravity * 11.0 * 12.0 / 2.0);
    }

    void selectingABodyReloadsItsPlots()
    {
        PlottedRun fixture;
        QVERIFY(fixture.isThere(60));
        fixture.session.select("body");
        QTRY_VERIFY(!fixture.series.isReading());
        const sim::Track &track = fixture.session.timeline().track();
        QCOMPARE(fixture.series.run().at(30, 0).first, track.stateAt(30).positionOf(1).y);
        QCOMPARE(fixture.series.run().at(30, 1).first,
                 track.stateAt(30).velocityOf(0).x - track.stateAt(29).velocityOf(0).x);
    }

    void aLongRunTakesNoMoreMemory()
    {
        PlottedRun fixture("swing");
        fixture.series.setMostSteps(PlotSeries::allSteps);
        QVERIFY(fixture.isThere(60'000));
        const Samples &samples = fixture.series.run();
        QVERIFY(samples.size() <= std::size_t(PlotSeries::mostBuckets));
        QVERIFY(samples.size() >= std::size_t(PlotSeries::mostBuckets / 2));
        QCOMPARE(samples.nextFrame(), 60'001);
        const sim::Track &track = fixture.session.timeline().track();
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

    void inactiveSeriesReadsNothing()
    {
        PlottedRun fixture;
        QVERIFY(fixture.isThere(50));
        fixture.series.setActive(false);
        const quint64 revision = fixture.series.revision();
        QVERIFY(fixture.isThere(90));
        fixture.session.editor().setParameter("k", 0.3);
        QCOMPARE(fixture.series.revision(), revision);
        fixture.series.setActive(true);
        QVERIFY(fixture.isThere(100));
        QVERIFY(fixture.isRight());
    }

    void theFirstPlotIsOfWhatMoves_data()
    {
        QTest::addColumn<double>("x");
        QTest::addColumn<double>("y");
        QTest::addColumn<QString>("shown");
        // A point is released here, on a spring to (0, 0).
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
        const sim::Script script = PlottedRun("pair").session.timeline().script();
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
            list.add({{QuantityKind::velocityY, "foot, \"5\"(x)"}, {QuantityKind::distance, {}, "body"}});
            QCOMPARE(list.plots().size(), 2);
        }
        {
            PlotList list;
            list.open(script);
            QCOMPARE(list.plots().size(), 2);
            QCOMPARE(list.plots()[1].up, (Quantity{QuantityKind::velocityY, "foot, \"5\"(x)"}));
            QCOMPARE(list.plots()[1].across, (Quantity{QuantityKind::distance, {}, "body"}));
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

    void invalidSettingsAreIgnored()
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
        QCOMPARE(list.plots().front(), (PlotSpec{{QuantityKind::speed}, {}}));
    }
};

SUITE(tst_plot_series, PlotSeriesTest)
#include "tst_plot_series.moc"
