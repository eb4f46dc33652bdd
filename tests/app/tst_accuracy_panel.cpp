// The Accuracy panel, driven as a learner drives it, over a made-up study.

#include "app/model/accuracy_words.h"
#include "app/model/telling_methods.h"
#include "measure_bench.h"
#include "sim/methods/methods.h"

#include <QAccessible>
#include <QPushButton>
#include <QtTest>

#include <set>

using namespace app;
using measure_bench::Bench;

class AccuracyPanelTest : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase() { prepareProgram(); }
    void theCardNamesTheCheapestWayWithinTheTarget();
    void useItAdoptsTheCheapestWay();
    void aClickOnASpotAdoptsItsMethodAndStep();
    void hoverTellsAllAboutASpot();
    void arrowKeysWalkThroughTheSpotsAndEnterAdopts();
    void theTargetFollowsTheMouse();
    void theTargetFollowsPlusAndMinus();
    void aTargetThatNothingReachesIsSaid();
    void aScreenReaderHearsWhatIsChosen();
    void cancelStopsAndMeasureAgainGoesOn();
    void whereNothingMovesTheVerdictSaysSo();
    void aBeginnerSeesThreeMethodsAndTheTimeOfAFrame();
    void allMethodsAreAClickAwayAndThatIsRemembered();
    void theWayInUseIsAlwaysShown();
    void theTellingMethodsAreTheCheapestAndTheMostExact();
    void timesHaveOneUnit_data();
    void timesHaveOneUnit();
};

namespace {

std::set<std::string> methodsOf(const Bench &bench, const SpotPlot &plot)
{
    std::set<std::string> shown;
    for (const Spot &spot : plot.spots())
        shown.insert(bench.study.accuracy()->rows[spot.row].setup.method->id());
    return shown;
}

}

void AccuracyPanelTest::aBeginnerSeesThreeMethodsAndTheTimeOfAFrame()
{
    Bench bench;
    bench.panel.setShowsAll(false);
    QVERIFY(bench.measured());
    WorkPrecisionPlot &plot = bench.plot();
    // By hand: the cheapest that stays within 0.1 px, and what is off least.
    const sim::AccuracyRow *cheapest = nullptr;
    for (const sim::AccuracyRow &row : bench.study.accuracy()->rows) {
        const bool fits = row.outcome == sim::Outcome::measured && row.error <= 0.1;
        if (fits && (!cheapest || row.nsPerFrame < cheapest->nsPerFrame))
            cheapest = &row;
    }
    const std::set<std::string> shown = methodsOf(bench, plot);
    QCOMPARE(shown.size(), std::size_t(3));
    QVERIFY(shown.count(bench.world.session.step().script().method->id()));
    QVERIFY(shown.count(cheapest->setup.method->id()));
    // A frame of 30 a second has 33,333 microseconds: right of all marks, and in sight.
    QVERIFY(plot.showsFrame());
    for (const Spot &spot : plot.spots())
        QVERIFY(spot.place.x() < 1e6 / 30.0);
    QVERIFY(plot.xAxis->coordToPixel(1e6 / 30.0) < plot.axisRect()->right());
    QVERIFY(!bench.panel.findChild<QLabel *>("failure")->isVisible());
    QVERIFY(plot.height() > bench.panel.height() / 2);
}

void AccuracyPanelTest::allMethodsAreAClickAwayAndThatIsRemembered()
{
    Bench bench;
    bench.panel.setShowsAll(false);
    QVERIFY(bench.measured());
    auto *all = bench.panel.findChild<QPushButton *>("allMethods");
    QTest::mouseClick(all, Qt::LeftButton);
    QCOMPARE(methodsOf(bench, bench.plot()).size(), sim::allMethods().size());
    QVERIFY(bench.panel.findChild<QLabel *>("failure")->isVisible());
    const AccuracyPanel next(bench.study, bench.world.theme);
    QVERIFY(next.showsAll());
    auto *fewer = bench.panel.findChild<QPushButton *>("fewerMethods");
    QVERIFY(fewer->isVisible() && !all->isVisible());
    fewer->setFocus();
    QTest::keyClick(fewer, Qt::Key_Space);
    QCOMPARE(methodsOf(bench, bench.plot()).size(), std::size_t(3));
    const AccuracyPanel again(bench.study, bench.world.theme);
    QVERIFY(!again.showsAll());
}

void AccuracyPanelTest::theWayInUseIsAlwaysShown()
{
    Bench bench;
    bench.panel.setShowsAll(false);
    QVERIFY(bench.measured());
    for (const sim::MethodPtr &method : sim::allMethods()) {
        const bool adapts = method->stepping() == sim::Stepping::adaptive;
        bench.world.session.use(method,
                                adapts ? sim::StepSize::withTolerance(1e-2) : sim::StepSize::ofLength(0.5));
        QVERIFY2(methodsOf(bench, bench.plot()).count(method->id()), method->id().c_str());
    }
}

void AccuracyPanelTest::theTellingMethodsAreTheCheapestAndTheMostExact()
{
    const auto row = [](const char *method, double error, double ns) {
        sim::AccuracyRow made;
        made.setup = {sim::findMethod(method), sim::StepSize::ofLength(1.0)};
        made.outcome = sim::Outcome::measured;
        made.error = error;
        made.nsPerFrame = ns;
        return made;
    };
    sim::Accuracy found;
    found.rows = {row("published", 5.0, 20.0), row("semi_implicit_euler", 4.0, 20.0),
                  row("velocity_verlet", 0.05, 30.0), row("midpoint", 0.04, 60.0), row("rk4", 1e-4, 90.0)};
    using Names = std::vector<std::string>;
    QCOMPARE(tellingMethods(found, "published", 0.1), (Names{"published", "velocity_verlet", "rk4"}));
    // Where one method is both, the next most exact one of another order joins it.
    QCOMPARE(tellingMethods(found, "published", 0.01), (Names{"published", "rk4", "midpoint"}));
    QCOMPARE(tellingMethods(found, "rk4", 0.01), (Names{"rk4", "midpoint", "semi_implicit_euler"}));
    QCOMPARE(tellingMethods({}, "rk4", 0.1), Names{"rk4"});
}

void AccuracyPanelTest::timesHaveOneUnit_data()
{
    QTest::addColumn<double>("ns");
    QTest::addColumn<QString>("shown");
    QTest::newRow("a little") << 31.4 << "0.031\u2009µs";
    QTest::newRow("thousands of nanoseconds") << 7922.0 << "7.9\u2009µs";
    QTest::newRow("milliseconds") << 16.7e6 << "16700\u2009µs";
}

void AccuracyPanelTest::timesHaveOneUnit()
{
    QFETCH(double, ns);
    QTEST(duration(ns), "shown");
}

void AccuracyPanelTest::theCardNamesTheCheapestWayWithinTheTarget()
{
    Bench bench;
    QVERIFY(bench.measured());
    // By hand, from what the study made up.
    const sim::AccuracyRow *best = nullptr;
    for (const sim::AccuracyRow &row : bench.study.accuracy()->rows) {
        const bool near = row.outcome == sim::Outcome::measured && row.error <= 0.1;
        if (near && (!best || row.nsPerFrame < best->nsPerFrame))
            best = &row;
    }
    QVERIFY(best);
    const QString said = bench.panel.verdict();
    QVERIFY2(said.startsWith("To be within 0.1 px, this scene costs "), qPrintable(said));
    QVERIFY2(said.contains(QString::fromStdString(best->setup.method->title())), qPrintable(said));
    QVERIFY2(said.contains("Yours "), qPrintable(said));
}

void AccuracyPanelTest::useItAdoptsTheCheapestWay()
{
    Bench bench;
    QVERIFY(bench.measured());
    const sim::MethodSetup best = bench.study.accuracy()->cheapest(0.1)->setup;
    auto *use = bench.panel.findChild<QPushButton *>("use");
    QVERIFY(use->isVisible());
    QTest::mouseClick(use, Qt::LeftButton);
    QCOMPARE(bench.method(), best.method->id());
    QCOMPARE(bench.step(), best.step);
    QVERIFY(!use->isVisible());
    QVERIFY(bench.panel.verdict().contains("nothing is cheaper than what you use"));
}

void AccuracyPanelTest::aClickOnASpotAdoptsItsMethodAndStep()
{
    Bench bench;
    QVERIFY(bench.measured());
    const sim::StepSize quarter = sim::StepSize::ofLength(0.25);
    QTest::mouseClick(&bench.plot(), Qt::LeftButton, {}, bench.spotOf("semi_implicit_euler", quarter));
    QCOMPARE(bench.method(), "semi_implicit_euler");
    QCOMPARE(bench.step(), quarter);
    QCOMPARE(bench.study.inUse()->setup.step, quarter);
}

void AccuracyPanelTest::hoverTellsAllAboutASpot()
{
    Bench bench;
    QVERIFY(bench.measured());
    const QPoint spot = bench.spotOf("semi_implicit_euler", sim::StepSize::ofLength(0.5));
    QTest::mouseMove(&bench.plot(), spot);
    QTRY_VERIFY(bench.plot().chosen());
    const QString said = bench.plot().sentence();
    for (const char *part : {"Semi-implicit Euler", "1/2 frame", "off", "±", "forces"})
        QVERIFY2(said.contains(part), qPrintable(said));
    QTest::mouseMove(&bench.plot(), QPoint(2, 2));
    QTRY_VERIFY(!bench.plot().chosen());
}

void AccuracyPanelTest::arrowKeysWalkThroughTheSpotsAndEnterAdopts()
{
    Bench bench;
    bench.world.session.setMethod("semi_implicit_euler");
    QVERIFY(bench.measured());
    WorkPrecisionPlot &plot = bench.plot();
    plot.setFocus(Qt::TabFocusReason);
    const auto chosen = [&] { return bench.study.accuracy()->rows[plot.chosen()->row].setup; };
    QTest::keyClick(&plot, Qt::Key_Right);
    QCOMPARE(chosen().method->id(), "semi_implicit_euler"); // what is in use comes first
    QCOMPARE(chosen().step, sim::StepSize::ofLength(1.0));
    QTest::keyClick(&plot, Qt::Key_Right);
    QTest::keyClick(&plot, Qt::Key_Right);
    QCOMPARE(chosen().step, sim::StepSize::ofLength(0.25));
    QTest::keyClick(&plot, Qt::Key_Left);
    QCOMPARE(chosen().step, sim::StepSize::ofLength(0.5));
    QCOMPARE(bench.step(), sim::StepSize::ofLength(1.0)); // nothing is adopted by looking
    QTest::keyClick(&plot, Qt::Key_Return);
    QCOMPARE(bench.method(), "semi_implicit_euler");
    QCOMPARE(bench.step(), sim::StepSize::ofLength(0.5));
    QTest::keyClick(&plot, Qt::Key_Down);
    QVERIFY(chosen().method->id() != "semi_implicit_euler");
}

void AccuracyPanelTest::theTargetFollowsTheMouse()
{
    Bench bench;
    QVERIFY(bench.measured());
    WorkPrecisionPlot &plot = bench.plot();
    QCOMPARE(plot.target(), 0.1);
    const QPoint from = plot.targetHandle().center().toPoint();
    const double y1 = plot.yAxis->pixelToCoord(from.y() - 40) / plot.yAxis->pixelToCoord(from.y());
    QVERIFY(y1 > 1.0);
    QTest::mousePress(&plot, Qt::LeftButton, {}, from);
    QMouseEvent move(QEvent::MouseMove, from - QPoint(0, 40), plot.mapToGlobal(from - QPoint(0, 40)),
                     Qt::NoButton, Qt::LeftButton, {});
    QApplication::sendEvent(&plot, &move);
    QTest::mouseRelease(&plot, Qt::LeftButton, {}, from - QPoint(0, 40));
    QVERIFY(plot.target() > 0.1);
    QVERIFY2(!bench.panel.verdict().contains("within 0.1 px"), qPrintable(bench.panel.verdict()));
}

void AccuracyPanelTest::theTargetFollowsPlusAndMinus()
{
    Bench bench;
    QVERIFY(bench.measured());
    bench.plot().setFocus();
    QTest::keyClick(&bench.plot(), Qt::Key_Minus);
    QCOMPARE(bench.plot().target(), 0.05);
    QTest::keyClick(&bench.plot(), Qt::Key_Minus);
    QCOMPARE(bench.plot().target(), 0.02);
    QTest::keyClick(&bench.plot(), Qt::Key_Minus);
    QCOMPARE(bench.plot().target(), 0.01);
    QTest::keyClick(&bench.plot(), Qt::Key_Plus);
    QCOMPARE(bench.plot().target(), 0.02);
    QVERIFY(bench.panel.verdict().contains("0.02 px"));
}

void AccuracyPanelTest::aTargetThatNothingReachesIsSaid()
{
    Bench bench;
    QVERIFY(bench.measured());
    bench.plot().setTarget(1e-10);
    QVERIFY(!bench.study.accuracy()->cheapest(1e-10));
    QVERIFY2(bench.panel.verdict().startsWith("Nothing here comes within"),
             qPrintable(bench.panel.verdict()));
    QVERIFY(!bench.panel.findChild<QPushButton *>("use")->isVisible());
}

void AccuracyPanelTest::aScreenReaderHearsWhatIsChosen()
{
    Bench bench;
    QVERIFY(bench.measured());
    bench.plot().setFocus(Qt::TabFocusReason);
    QAccessibleInterface *access = QAccessible::queryAccessibleInterface(&bench.plot());
    QVERIFY(access);
    QVERIFY(access->text(QAccessible::Value).contains("Arrow keys"));
    QTest::keyClick(&bench.plot(), Qt::Key_Right);
    QVERIFY(access->text(QAccessible::Value).contains("step "));
    QCOMPARE(access->text(QAccessible::Name), QString("Error against time"));
}

void AccuracyPanelTest::cancelStopsAndMeasureAgainGoesOn()
{
    Bench bench;
    QVERIFY(bench.measured());
    auto *button = bench.panel.findChild<QPushButton *>("measure");
    bench.puppet.held = true;
    QTest::mouseClick(button, Qt::LeftButton);
    QCOMPARE(button->text(), QString("Cancel"));
    QTRY_COMPARE(bench.puppet.begun.load(), 2);
    QTest::mouseClick(button, Qt::LeftButton);
    QCOMPARE(bench.study.stage(), AccuracyStudy::Stage::cancelled);
    QTRY_COMPARE(bench.puppet.stopped.load(), 1);
    QVERIFY(bench.study.accuracy()); // what was measured stays
    bench.puppet.held = false;
    QTest::mouseClick(button, Qt::LeftButton);
    QVERIFY(bench.measured());
    QCOMPARE(bench.puppet.begun.load(), 3);
}

void AccuracyPanelTest::whereNothingMovesTheVerdictSaysSo()
{
    sim::Accuracy still;
    still.span = still.horizon = 200;
    still.rows.resize(2);
    for (sim::AccuracyRow &row : still.rows) {
        row.setup = {sim::findMethod("semi_implicit_euler"), sim::StepSize::ofLength(1.0)};
        row.outcome = sim::Outcome::measured;
        row.nsPerFrame = 100.0;
    }
    QVERIFY(verdictOn(still, 0.1, nullptr).startsWith("Nothing moves here"));
    still.rows[1].error = 1e-9;
    QVERIFY(!verdictOn(still, 0.1, nullptr).startsWith("Nothing moves here"));
}

QTEST_MAIN(AccuracyPanelTest)
#include "tst_accuracy_panel.moc"
