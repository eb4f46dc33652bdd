// The Accuracy panel, driven as a learner drives it, over a made-up study.

#include "app/model/accuracy_words.h"
#include "measure_bench.h"
#include "sim/methods/methods.h"

#include <QAccessible>
#include <QPushButton>
#include <QtTest>

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
};

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
    QVERIFY2(said.contains(QString::fromStdString(best->way.method->title())), qPrintable(said));
    QVERIFY2(said.contains("Yours "), qPrintable(said));
}

void AccuracyPanelTest::useItAdoptsTheCheapestWay()
{
    Bench bench;
    QVERIFY(bench.measured());
    const sim::Way best = bench.study.accuracy()->cheapest(0.1)->way;
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
    const sim::StepSize quarter = sim::StepSize::of(0.25);
    QTest::mouseClick(&bench.plot(), Qt::LeftButton, {}, bench.spotOf("semi_implicit_euler", quarter));
    QCOMPARE(bench.method(), "semi_implicit_euler");
    QCOMPARE(bench.step(), quarter);
    QCOMPARE(bench.study.inUse()->way.step, quarter);
}

void AccuracyPanelTest::hoverTellsAllAboutASpot()
{
    Bench bench;
    QVERIFY(bench.measured());
    const QPoint spot = bench.spotOf("semi_implicit_euler", sim::StepSize::of(0.5));
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
    const auto chosen = [&] { return bench.study.accuracy()->rows[plot.chosen()->row].way; };
    QTest::keyClick(&plot, Qt::Key_Right);
    QCOMPARE(chosen().method->id(), "semi_implicit_euler"); // what is in use comes first
    QCOMPARE(chosen().step, sim::StepSize::of(1.0));
    QTest::keyClick(&plot, Qt::Key_Right);
    QTest::keyClick(&plot, Qt::Key_Right);
    QCOMPARE(chosen().step, sim::StepSize::of(0.25));
    QTest::keyClick(&plot, Qt::Key_Left);
    QCOMPARE(chosen().step, sim::StepSize::of(0.5));
    QCOMPARE(bench.step(), sim::StepSize::of(1.0)); // nothing is adopted by looking
    QTest::keyClick(&plot, Qt::Key_Return);
    QCOMPARE(bench.method(), "semi_implicit_euler");
    QCOMPARE(bench.step(), sim::StepSize::of(0.5));
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
        row.way = {sim::findMethod("semi_implicit_euler"), sim::StepSize::of(1.0)};
        row.outcome = sim::Outcome::measured;
        row.nsPerFrame = 100.0;
    }
    QVERIFY(verdictOn(still, 0.1, nullptr).startsWith("Nothing moves here"));
    still.rows[1].error = 1e-9;
    QVERIFY(!verdictOn(still, 0.1, nullptr).startsWith("Nothing moves here"));
}

QTEST_MAIN(AccuracyPanelTest)
#include "tst_accuracy_panel.moc"
