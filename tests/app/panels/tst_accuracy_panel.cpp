// The Accuracy panel, driven as a learner drives it, over a made-up study.

#include "app/model/analysis/representative_methods.h"
#include "app/model/text/accuracy_text.h"
#include "app/ui/accuracy/work_precision_layout.h"
#include "sim/methods/methods.h"
#include "tests/app/panels/accuracy_support.h"
#include "tests/suite.h"

#include <QAccessible>
#include <QPushButton>
#include <QtTest>

#include <set>

using namespace app;
using namespace tests;
using accuracy_support::AccuracyFixture;

class AccuracyPanelTest : public QObject
{
    Q_OBJECT

private slots:
    void verdictNamesTheCheapestSetupWithinTheTarget();
    void useItAdoptsTheCheapestWay();
    void clickOnAMarkAdoptsItsMethodAndStep();
    void hoverTellsAllAboutASpot();
    void arrowKeysWalkThroughTheSpotsAndEnterAdopts();
    void theTargetFollowsTheMouse();
    void theTargetFollowsPlusAndMinus();
    void verdictSaysThatNoMethodReachesTheTarget();
    void aScreenReaderHearsWhatIsChosen();
    void cancelStopsAndMeasureAgainGoesOn();
    void verdictSaysThatNothingMoves();
    void aBeginnerSeesThreeMethods();
    void axisIncludesTheTimeOfAFrameIfItIsNear();
    void allMethodsAreAClickAwayAndThatIsRemembered();
    void methodInUseIsAlwaysShown();
    void representativeMethodsAreTheCheapestAndTheMostAccurate();
    void timesHaveOneUnit_data();
    void timesHaveOneUnit();
};

namespace {

std::set<std::string> methodsOf(const AccuracyFixture &fixture, const StudyPlot &plot)
{
    std::set<std::string> shown;
    for (const Spot &spot : plot.spots())
        shown.insert(fixture.study.accuracy()->rows[spot.row].setup.method->id());
    return shown;
}

}

void AccuracyPanelTest::aBeginnerSeesThreeMethods()
{
    AccuracyFixture fixture;
    fixture.panel.setShowsAll(false);
    QVERIFY(fixture.measured());
    WorkPrecisionPlot &plot = fixture.plot();
    // Computed here: the cheapest within 0.1 px, and the most accurate one.
    const sim::AccuracyRow *cheapest = nullptr;
    for (const sim::AccuracyRow &row : fixture.study.accuracy()->rows) {
        const bool fits = row.outcome == sim::Outcome::measured && row.error <= 0.1;
        if (fits && (!cheapest || row.nsPerFrame < cheapest->nsPerFrame))
            cheapest = &row;
    }
    const std::set<std::string> shown = methodsOf(fixture, plot);
    QCOMPARE(shown.size(), std::size_t(3));
    QVERIFY(shown.count(fixture.world.session.step().script().method->id()));
    QVERIFY(shown.count(cheapest->setup.method->id()));
    // The axis ends where the marks end, with room for their names.
    double last = 0.0;
    for (const Spot &spot : plot.spots())
        last = std::max(last, plot.xAxis->coordToPixel(spot.place.x()));
    QVERIFY(!plot.showsFrame());
    QVERIFY(plot.axisRect()->right() - last < plot.axisRect()->width() / 3.0);
    QVERIFY(!fixture.panel.findChild<QLabel *>("failure")->isVisible());
    QVERIFY(plot.height() > fixture.panel.height() / 2);
}

void AccuracyPanelTest::axisIncludesTheTimeOfAFrameIfItIsNear()
{
    const AccuracyFixture fixture;
    const sim::Accuracy made = accuracy_support::madeUp(fixture.world.session.step().script(), {});
    ShownMethods shown{false, {}};
    double longest = 0.0; // ns
    for (const sim::AccuracyRow &row : made.rows) {
        shown.ids.insert(row.setup.method->id());
        longest = std::max(longest, row.nsPerFrame);
    }
    // A frame of 30 a second has 33,333 microseconds.
    for (const auto &[times, isNear] : {std::pair(32.0, true), std::pair(100.0, false)}) {
        sim::Accuracy scaled = made;
        for (sim::AccuracyRow &row : scaled.rows)
            row.nsPerFrame *= 1e9 / 30.0 / times / longest;
        const WorkPrecisionLayout layout = workPrecisionLayout(scaled, shown, 0.1, {500.0, 400.0});
        QCOMPARE(layout.most > 1e6 / 30.0, isNear);
        QVERIFY(layout.most > 1e6 / 30.0 / times); // all marks are in sight
    }
}

void AccuracyPanelTest::allMethodsAreAClickAwayAndThatIsRemembered()
{
    AccuracyFixture fixture;
    fixture.panel.setShowsAll(false);
    QVERIFY(fixture.measured());
    auto *all = fixture.panel.findChild<QPushButton *>("allMethods");
    QTest::mouseClick(all, Qt::LeftButton);
    QCOMPARE(methodsOf(fixture, fixture.plot()).size(), sim::allMethods().size());
    QVERIFY(fixture.panel.findChild<QLabel *>("failure")->isVisible());
    const AccuracyPanel next(fixture.study, fixture.world.session.preview(), fixture.world.theme);
    QVERIFY(next.showsAll());
    auto *fewer = fixture.panel.findChild<QPushButton *>("fewerMethods");
    QVERIFY(fewer->isVisible() && !all->isVisible());
    fewer->setFocus();
    QTest::keyClick(fewer, Qt::Key_Space);
    QCOMPARE(methodsOf(fixture, fixture.plot()).size(), std::size_t(3));
    const AccuracyPanel again(fixture.study, fixture.world.session.preview(), fixture.world.theme);
    QVERIFY(!again.showsAll());
}

void AccuracyPanelTest::methodInUseIsAlwaysShown()
{
    AccuracyFixture fixture;
    fixture.panel.setShowsAll(false);
    QVERIFY(fixture.measured());
    for (const sim::MethodPtr &method : sim::allMethods()) {
        const bool adapts = method->stepping() == sim::Stepping::adaptive;
        fixture.world.session.editor().use(method, adapts ? sim::StepSize::withTolerance(1e-2)
                                                          : sim::StepSize::ofLength(0.5));
        QVERIFY2(methodsOf(fixture, fixture.plot()).count(method->id()), method->id().c_str());
    }
}

void AccuracyPanelTest::representativeMethodsAreTheCheapestAndTheMostAccurate()
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
    QCOMPARE(representativeMethods(found, "published", 0.1), (Names{"published", "velocity_verlet", "rk4"}));
    // If one method is both, the next most accurate one of another order is added.
    QCOMPARE(representativeMethods(found, "published", 0.01), (Names{"published", "rk4", "midpoint"}));
    QCOMPARE(representativeMethods(found, "rk4", 0.01), (Names{"rk4", "midpoint", "semi_implicit_euler"}));
    QCOMPARE(representativeMethods({}, "rk4", 0.1), Names{"rk4"});
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

void AccuracyPanelTest::verdictNamesTheCheapestSetupWithinTheTarget()
{
    AccuracyFixture fixture;
    QVERIFY(fixture.measured());
    // Computed here from the made-up study.
    const sim::AccuracyRow *best = nullptr;
    for (const sim::AccuracyRow &row : fixture.study.accuracy()->rows) {
        const bool near = row.outcome == sim::Outcome::measured && row.error <= 0.1;
        if (near && (!best || row.nsPerFrame < best->nsPerFrame))
            best = &row;
    }
    QVERIFY(best);
    const QString said = fixture.panel.verdict();
    QVERIFY2(said.startsWith("The cheapest way to stay within an error of 0.1 px costs "), qPrintable(said));
    QVERIFY2(said.contains(QString::fromStdString(best->setup.method->title())), qPrintable(said));
    QVERIFY2(said.contains("Your setup "), qPrintable(said));
}

void AccuracyPanelTest::useItAdoptsTheCheapestWay()
{
    AccuracyFixture fixture;
    QVERIFY(fixture.measured());
    const sim::MethodSetup best = fixture.study.accuracy()->cheapest(0.1)->setup;
    auto *use = fixture.panel.findChild<QPushButton *>("use");
    QVERIFY(use->isVisible());
    QTest::mouseClick(use, Qt::LeftButton);
    QCOMPARE(fixture.method(), best.method->id());
    QCOMPARE(fixture.step(), best.step);
    QVERIFY(!use->isVisible());
    QVERIFY(fixture.panel.verdict().contains("Nothing cheaper than your setup"));
}

void AccuracyPanelTest::clickOnAMarkAdoptsItsMethodAndStep()
{
    AccuracyFixture fixture;
    QVERIFY(fixture.measured());
    const sim::StepSize quarter = sim::StepSize::ofLength(0.25);
    QTest::mouseClick(&fixture.plot(), Qt::LeftButton, {}, fixture.spotOf("semi_implicit_euler", quarter));
    QCOMPARE(fixture.method(), "semi_implicit_euler");
    QCOMPARE(fixture.step(), quarter);
    QCOMPARE(fixture.study.inUse()->setup.step, quarter);
}

void AccuracyPanelTest::hoverTellsAllAboutASpot()
{
    AccuracyFixture fixture;
    QVERIFY(fixture.measured());
    const QPoint spot = fixture.spotOf("semi_implicit_euler", sim::StepSize::ofLength(0.5));
    QTest::mouseMove(&fixture.plot(), spot);
    QTRY_VERIFY(fixture.plot().chosen());
    const QString said = fixture.plot().sentence();
    for (const char *part : {"Semi-implicit Euler", "1/2 frame", "Error", "±", "forces"})
        QVERIFY2(said.contains(part), qPrintable(said));
    QTest::mouseMove(&fixture.plot(), QPoint(2, 2));
    QTRY_VERIFY(!fixture.plot().chosen());
}

void AccuracyPanelTest::arrowKeysWalkThroughTheSpotsAndEnterAdopts()
{
    AccuracyFixture fixture;
    fixture.world.session.editor().setMethod("semi_implicit_euler");
    QVERIFY(fixture.measured());
    WorkPrecisionPlot &plot = fixture.plot();
    plot.setFocus(Qt::TabFocusReason);
    const auto chosen = [&] { return fixture.study.accuracy()->rows[plot.chosen()->row].setup; };
    QTest::keyClick(&plot, Qt::Key_Right);
    QCOMPARE(chosen().method->id(), "semi_implicit_euler"); // what is in use comes first
    QCOMPARE(chosen().step, sim::StepSize::ofLength(1.0));
    QTest::keyClick(&plot, Qt::Key_Right);
    QTest::keyClick(&plot, Qt::Key_Right);
    QCOMPARE(chosen().step, sim::StepSize::ofLength(0.25));
    QTest::keyClick(&plot, Qt::Key_Left);
    QCOMPARE(chosen().step, sim::StepSize::ofLength(0.5));
    QCOMPARE(fixture.step(), sim::StepSize::ofLength(1.0)); // nothing is adopted by looking
    QTest::keyClick(&plot, Qt::Key_Return);
    QCOMPARE(fixture.method(), "semi_implicit_euler");
    QCOMPARE(fixture.step(), sim::StepSize::ofLength(0.5));
    QTest::keyClick(&plot, Qt::Key_Down);
    QVERIFY(chosen().method->id() != "semi_implicit_euler");
}

void AccuracyPanelTest::theTargetFollowsTheMouse()
{
    AccuracyFixture fixture;
    QVERIFY(fixture.measured());
    WorkPrecisionPlot &plot = fixture.plot();
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
    QVERIFY2(!fixture.panel.verdict().contains("within 0.1 px"), qPrintable(fixture.panel.verdict()));
}

void AccuracyPanelTest::theTargetFollowsPlusAndMinus()
{
    AccuracyFixture fixture;
    QVERIFY(fixture.measured());
    fixture.plot().setFocus();
    QTest::keyClick(&fixture.plot(), Qt::Key_Minus);
    QCOMPARE(fixture.plot().target(), 0.05);
    QTest::keyClick(&fixture.plot(), Qt::Key_Minus);
    QCOMPARE(fixture.plot().target(), 0.02);
    QTest::keyClick(&fixture.plot(), Qt::Key_Minus);
    QCOMPARE(fixture.plot().target(), 0.01);
    QTest::keyClick(&fixture.plot(), Qt::Key_Plus);
    QCOMPARE(fixture.plot().target(), 0.02);
    QVERIFY(fixture.panel.verdict().contains("0.02 px"));
}

void AccuracyPanelTest::verdictSaysThatNoMethodReachesTheTarget()
{
    AccuracyFixture fixture;
    QVERIFY(fixture.measured());
    fixture.plot().setTarget(1e-10);
    QVERIFY(!fixture.study.accuracy()->cheapest(1e-10));
    QVERIFY2(fixture.panel.verdict().startsWith("No method stays within"),
             qPrintable(fixture.panel.verdict()));
    QVERIFY(!fixture.panel.findChild<QPushButton *>("use")->isVisible());
}

void AccuracyPanelTest::aScreenReaderHearsWhatIsChosen()
{
    AccuracyFixture fixture;
    QVERIFY(fixture.measured());
    fixture.plot().setFocus(Qt::TabFocusReason);
    QAccessibleInterface *access = QAccessible::queryAccessibleInterface(&fixture.plot());
    QVERIFY(access);
    QVERIFY(access->text(QAccessible::Value).contains("arrow keys"));
    QTest::keyClick(&fixture.plot(), Qt::Key_Right);
    QVERIFY(access->text(QAccessible::Value).contains("step "));
    QCOMPARE(access->text(QAccessible::Name), QString("Error against time"));
}

void AccuracyPanelTest::cancelStopsAndMeasureAgainGoesOn()
{
    AccuracyFixture fixture;
    QVERIFY(fixture.measured());
    auto *button = fixture.panel.findChild<QPushButton *>("measure");
    fixture.puppet.held = true;
    QTest::mouseClick(button, Qt::LeftButton);
    QCOMPARE(button->text(), QString("Cancel"));
    QTRY_COMPARE(fixture.puppet.begun.load(), 2);
    QTest::mouseClick(button, Qt::LeftButton);
    QCOMPARE(fixture.study.stage(), AccuracyStudy::Stage::cancelled);
    QTRY_COMPARE(fixture.puppet.stopped.load(), 1);
    QVERIFY(fixture.study.accuracy()); // what was measured stays
    fixture.puppet.held = false;
    QTest::mouseClick(button, Qt::LeftButton);
    QVERIFY(fixture.measured());
    QCOMPARE(fixture.puppet.begun.load(), 3);
}

void AccuracyPanelTest::verdictSaysThatNothingMoves()
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

SUITE(tst_accuracy_panel, AccuracyPanelTest)
#include "tst_accuracy_panel.moc"
