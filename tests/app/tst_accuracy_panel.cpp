// The Accuracy panel, driven as a learner drives it, over a made-up study.

#include "app/model/accuracy_words.h"
#include "app/ui/measure/method_ink.h"
#include "app/ui/measure/order_plot.h"
#include "app/ui/measure/plot_marks.h"
#include "app/ui/measure/run_plot.h"
#include "app/ui/plots/plot_export.h"
#include "measure_bench.h"
#include "sim/methods/methods.h"

#include <QAccessible>
#include <QPushButton>
#include <QTemporaryDir>
#include <QToolButton>
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
    void theUnstableAreMarkedAndNamed();
    void anErrorOfNothingStandsOnAFloorBelowTheNumbers();
    void namesAtLinesCoverNeitherEachOtherNorMarks();
    void theTabsShowTheThreeViews();
    void theOrderViewMeasuresTheSlope();
    void theRunViewDrawsOneRowAMethodWithTheOneInUse();
    void everyMethodHasAnInkOfItsOwn();
    void aScreenReaderHearsWhatIsChosen();
    void numbersOfTheViewThatIsSeenAreSaved();
    void thePlotIsSavedAsPdf();
    void cancelStopsAndMeasureAgainGoesOn();
    void whereNothingMovesTheVerdictSaysSo();
    void remarksSayWhatTheNumbersDependOn_data();
    void remarksSayWhatTheNumbersDependOn();
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

void AccuracyPanelTest::theUnstableAreMarkedAndNamed()
{
    Bench bench;
    QVERIFY(bench.measured());
    const sim::AccuracyRow &unstable = bench.study.accuracy()->rows.front();
    const QPoint mark = bench.spotOf(unstable.way.method->id(), unstable.way.step);
    QVERIFY(mark.y() < bench.plot().axisRect()->top() + 40);
    auto *named = bench.panel.findChild<QLabel *>("failure");
    QVERIFY(named->isVisible());
    QVERIFY(named->text().contains(QString::fromStdString(unstable.way.method->title())));
}

void AccuracyPanelTest::anErrorOfNothingStandsOnAFloorBelowTheNumbers()
{
    constexpr double height = 400.0; // px of the screen
    const ErrorScale plain = errorScale({1e-3, 1e-6, 10.0}, 30.0, height);
    QCOMPARE(plain.floor, 0.0);
    QCOMPARE(plain.lower, 1e-6 / 4.0);
    const ErrorScale scale = errorScale({1e-3, 0.0, 1e-6, 10.0, 0.0}, 30.0, height);
    QCOMPARE(scale.upper, plain.upper);
    QCOMPARE(scale.lowest, plain.lower); // the numbers of the axis end where they did
    QCOMPARE(scale.place(1e-6), 1e-6);
    QVERIFY(scale.place(0.0) < scale.lowest && scale.place(0.0) > scale.lower);
    // It takes some px, not decades: those who have errors keep most of the axis.
    const double axis = std::log10(scale.upper / scale.lower);
    QVERIFY(std::log10(scale.upper / scale.lowest) > 0.9 * axis);
    QVERIFY(std::log10(scale.lowest / scale.floor) / axis * height > 15.0);
}

void AccuracyPanelTest::namesAtLinesCoverNeitherEachOtherNorMarks()
{
    const QRectF area(0.0, 0.0, 480.0, 220.0);
    const QFont font = Theme(Scheme::light).ui(12);
    std::vector<EndLabel> labels;
    std::vector<QRectF> marks;
    for (int i = 0; i < 12; ++i) { // all end within a few px
        const QPointF end(200.0 + 3.0 * i, 100.0 + 4.0 * i);
        labels.push_back({end, QString("a method called %1").arg(i), Qt::black});
        marks.emplace_back(end.x() - 6.0, end.y() - 6.0, 12.0, 12.0);
    }
    LabelPlaces places(marks);
    const std::vector<PlacedLabel> placed = placeEndLabels(labels, font, area, places);
    QCOMPARE(placed.size(), labels.size());
    for (std::size_t i = 0; i < placed.size(); ++i) {
        QVERIFY(area.contains(placed[i].box));
        for (const QRectF &mark : marks)
            QVERIFY(!placed[i].box.intersects(mark));
        for (std::size_t j = 0; j < i; ++j)
            QVERIFY(!placed[i].box.intersects(placed[j].box));
    }
}

void AccuracyPanelTest::theTabsShowTheThreeViews()
{
    Bench bench;
    QVERIFY(bench.measured());
    const QList<QToolButton *> tabs = bench.panel.findChildren<QToolButton *>("tab");
    QCOMPARE(tabs.size(), 3);
    for (int i = 0; i < 3; ++i) {
        QTest::mouseClick(tabs[i], Qt::LeftButton);
        QCOMPARE(int(bench.panel.view()), i);
        QCOMPARE(bench.plot().isVisible(), i == 0);
        QVERIFY(!bench.panel.grab().isNull());
    }
    QVERIFY(!bench.panel.findChild<OrderPlot *>()->spots().empty());
}

void AccuracyPanelTest::theOrderViewMeasuresTheSlope()
{
    Bench bench;
    QVERIFY(bench.measured());
    const sim::MethodPtr method = sim::findMethod("semi_implicit_euler");
    QCOMPARE(OrderPlot::orderWords(*bench.study.accuracy(), *method),
             QString("Semi-implicit Euler: 1.0, as stated"));
    sim::Accuracy flat = *bench.study.accuracy();
    for (sim::AccuracyRow &row : flat.rows)
        row.error = 1.0;
    QCOMPARE(OrderPlot::orderWords(flat, *method), QString("Semi-implicit Euler: 0.0 of 1"));
}

void AccuracyPanelTest::theRunViewDrawsOneRowAMethodWithTheOneInUse()
{
    Bench bench;
    bench.world.session.use(sim::findMethod("semi_implicit_euler"), sim::StepSize::of(0.25));
    QVERIFY(bench.measured());
    bench.panel.setView(AccuracyPanel::overTheRun);
    const auto &rows = bench.panel.findChild<RunPlot *>()->rows();
    QCOMPARE(rows.size(), sim::allMethods().size());
    bool used = false;
    for (const std::size_t row : rows)
        used |= &bench.study.accuracy()->rows[row] == bench.study.inUse();
    QVERIFY(used);
}

void AccuracyPanelTest::everyMethodHasAnInkOfItsOwn()
{
    for (const Scheme scheme : {Scheme::light, Scheme::dark}) {
        const Theme theme(scheme);
        std::set<std::pair<QRgb, int>> inks;
        std::set<int> shapes;
        for (const sim::MethodPtr &method : sim::allMethods()) {
            const MethodInk ink = inkOf(*method, theme);
            inks.insert({ink.color.rgb(), ink.shape % markerShapes});
            shapes.insert(ink.shape % markerShapes);
        }
        QCOMPARE(inks.size(), sim::allMethods().size());
        QCOMPARE(shapes.size(), std::min<std::size_t>(markerShapes, sim::allMethods().size()));
    }
}

void AccuracyPanelTest::numbersOfTheViewThatIsSeenAreSaved()
{
    Bench bench;
    QVERIFY(bench.measured());
    const sim::Accuracy &found = *bench.study.accuracy();
    const QTemporaryDir folder;
    const auto saved = [&](AccuracyPanel::View view) {
        bench.panel.setView(view);
        bench.panel.exports().saveNumbers(folder.filePath("a.csv"));
        QFile file(folder.filePath("a.csv"));
        return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()).trimmed().split('\n')
                                              : QStringList();
    };
    for (const AccuracyPanel::View view : {AccuracyPanel::errorAgainstTime, AccuracyPanel::order}) {
        const QStringList lines = saved(view);
        QVERIFY(lines[0].startsWith("method,order,"));
        int line = 1;
        for (const sim::AccuracyRow &row : found.rows) {
            if (row.outcome != sim::Outcome::measured)
                continue;
            const QStringList fields = lines[line++].split(',');
            QCOMPARE(fields[0], QString("\"%1\"").arg(QString::fromStdString(row.way.method->id())));
            QCOMPARE(fields[row.way.step.adaptive() ? 3 : 2].toDouble(),
                     row.way.step.adaptive() ? row.way.step.tolerance : row.way.step.h);
            QCOMPARE(fields[4].toDouble(), row.error);
            QCOMPARE(fields[6].toDouble(), row.nsPerFrame);
            QCOMPARE(fields[8], QString(row.front ? "1" : "0"));
        }
        QCOMPARE(line, lines.size());
    }
    const QStringList run = saved(AccuracyPanel::overTheRun);
    QVERIFY2(run[0].startsWith("frame,\""), qPrintable(run[0]));
    QVERIFY(run.size() > 2);
}

void AccuracyPanelTest::thePlotIsSavedAsPdf()
{
    Bench bench;
    QVERIFY(bench.measured());
    const QTemporaryDir folder;
    QVERIFY(bench.panel.exports().savePicture(folder.filePath("a.pdf")));
    QFile file(folder.filePath("a.pdf"));
    QVERIFY(file.open(QIODevice::ReadOnly));
    QVERIFY(file.readAll().startsWith("%PDF"));
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

void AccuracyPanelTest::remarksSayWhatTheNumbersDependOn_data()
{
    QTest::addColumn<sim::Accuracy>("accuracy");
    QTest::addColumn<QString>("part");
    sim::Accuracy noisy;
    noisy.noise = 0.3;
    QTest::newRow("a noisy machine") << noisy << "busy with other things";
    sim::Accuracy chaotic;
    chaotic.span = 200;
    chaotic.horizon = 80;
    chaotic.reference.end = sim::ReferenceRun::End::parted;
    QTest::newRow("a horizon") << chaotic << "up to frame 80 of 200";
    sim::Accuracy jumping;
    jumping.reference.kind = sim::ReferenceRun::Kind::ownRefinement;
    jumping.reference.method = "own_refinement";
    QTest::newRow("no continuous limit") << jumping << "no exact motion to compare with";
    sim::Accuracy unfit;
    unfit.rows.resize(1);
    unfit.rows[0].way.method = sim::findMethod("semi_implicit_euler");
    unfit.rows[0].outcome = sim::Outcome::doesNotFit;
    QTest::newRow("a method that does not fit") << unfit << "Semi-implicit Euler";
}

void AccuracyPanelTest::remarksSayWhatTheNumbersDependOn()
{
    QFETCH(sim::Accuracy, accuracy);
    QFETCH(QString, part);
    World world;
    AccuracyStudy study(world.session, [&](const sim::Script &, const sim::StudyPlan &,
                                           const sim::StudyProgress &) { return accuracy; });
    AccuracyPanel panel(study, world.theme);
    show(panel, {560, 560});
    QTRY_COMPARE(study.stage(), AccuracyStudy::Stage::done);
    QVERIFY2(panel.remarks().contains(part), qPrintable(panel.remarks()));
}

QTEST_MAIN(AccuracyPanelTest)
#include "tst_accuracy_panel.moc"
