// The map of growth, in the window, driven as a learner drives it.

#include "app/ui/plots/plot_export.h"
#include "stability_panel_bench.h"

#include <QAccessible>
#include <QImage>
#include <QLabel>
#include <QMenu>
#include <QTemporaryDir>

using namespace app;

namespace {

GrowthPlot &openMap(StabilityPanelBench &bench, int plane)
{
    QTest::mouseClick(&bench.gauge, Qt::LeftButton);
    QTest::mouseClick(bench.plane(plane), Qt::LeftButton);
    bench.mapped();
    return bench.panel.plot();
}

}

class GrowthMapTest : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase();
    void theMapIsDrawnOnRequest();
    void theMapShowsWhereTheLearnerIsAndWas();
    void theMapTellsWhatIsUnderThePointer();
    void aClickOnTheMapGoesThere_data();
    void aClickOnTheMapGoesThere();
    void keysWalkOverTheMapAndGoThere();
    void aTipTellsWhatAClickDoes();
    void aSpotOfTheMapTakesTheNearestStepThatFits();
    void whereThereIsNoMapItSaysSo_data();
    void whereThereIsNoMapItSaysSo();
    void theWindowMayCloseWhileTheMapIsOpen();
    void theMapIsSavedAsPictureAndNumbers();
};

void GrowthMapTest::initTestCase()
{
    useOwnSettings();
}

void GrowthMapTest::theMapIsDrawnOnRequest()
{
    StabilityPanelBench bench;
    QTest::mouseClick(&bench.gauge, Qt::LeftButton);
    bench.settle();
    GrowthPlot &plot = bench.panel.plot();
    QVERIFY(!plot.isVisible());
    QVERIFY(!bench.window.stability().isMapping());
    QTest::mouseClick(bench.plane(0), Qt::LeftButton);
    bench.mapped();
    QVERIFY(plot.isVisible());
    // At k = 0.02 all steps up to 4 frames hold; at k = 9 one of 2 frames does not.
    QVERIFY(isNear(colourAt(plot, plot.onScreen({0.02, 0.9, 0.1})), bench.theme.tokens().scene));
    QVERIFY(!isNear(colourAt(plot, plot.onScreen({9.0, 0.9, 2.0})), bench.theme.tokens().scene));
    QTest::mouseClick(bench.plane(1), Qt::LeftButton);
    bench.mapped();
    QCOMPARE(bench.window.stability().map()->y.parameter, "damp");
    QVERIFY(!bench.plane(0)->isChecked());
    QTest::mouseClick(bench.plane(1), Qt::LeftButton);
    QVERIFY(!plot.isVisible());
    QVERIFY(!bench.window.stability().map());
}

void GrowthMapTest::theMapShowsWhereTheLearnerIsAndWas()
{
    StabilityPanelBench bench;
    QTest::mouseClick(&bench.gauge, Qt::LeftButton);
    QTest::mouseClick(bench.plane(1), Qt::LeftButton);
    bench.mapped();
    GrowthPlot &plot = bench.panel.plot();
    const QPointF first = plot.onScreen(bench.window.stability().tried().back());
    QVERIFY(isNear(colourAt(plot, first), bench.theme.tokens().now));
    bench.session.setParameter("k", 0.02);
    bench.session.setParameter("damp", 0.4);
    const QPointF here = plot.onScreen(bench.window.stability().tried().back());
    QVERIFY(here.x() < first.x() && here.y() > first.y());
    QVERIFY(isNear(colourAt(plot, here), bench.theme.tokens().now));
    QVERIFY(!isNear(colourAt(plot, first), bench.theme.tokens().now));
    // The way between: down along k = 0.02.
    bool drawn = false;
    for (const double beside : {-1.0, 0.0, 1.0}) {
        const QPointF between(here.x() + beside, 0.5 * (first.y() + here.y()));
        drawn = drawn || isNear(colourAt(plot, between), bench.theme.tokens().ink);
    }
    QVERIFY(drawn);
}

void GrowthMapTest::theMapTellsWhatIsUnderThePointer()
{
    StabilityPanelBench bench;
    QTest::mouseClick(&bench.gauge, Qt::LeftButton);
    QTest::mouseClick(bench.plane(1), Qt::LeftButton);
    bench.mapped();
    GrowthPlot &plot = bench.panel.plot();
    QVERIFY(plot.wordsAt(plot.onScreen({0.05, 0.5, 1.0})).contains("it holds"));
    QVERIFY(plot.wordsAt(plot.onScreen({5.0, 0.9, 1.0})).contains("times a frame"));
    QVERIFY(plot.wordsAt({1.0, 1.0}).isEmpty());
    QVERIFY2(plot.sentence().contains("it holds"), qPrintable(plot.sentence()));
}

void GrowthMapTest::aClickOnTheMapGoesThere_data()
{
    QTest::addColumn<int>("plane");
    QTest::addColumn<double>("damp");
    QTest::addColumn<double>("h");
    QTest::newRow("step") << 0 << 0.9 << 0.25;
    QTest::newRow("damping") << 1 << 0.5 << 1.0;
}

void GrowthMapTest::aClickOnTheMapGoesThere()
{
    QFETCH(int, plane);
    QFETCH(double, damp);
    QFETCH(double, h);
    StabilityPanelBench bench;
    bench.session.goTo({40, 0});
    bench.session.goTo({20, 0}); // so that there is a run to become the ghost
    GrowthPlot &plot = openMap(bench, plane);
    const std::size_t tried = bench.window.stability().tried().size();
    const QPoint there = plot.onScreen({1.0, damp, h}).toPoint();
    QTest::mouseMove(&plot, there);
    QCOMPARE(plot.cursor().shape(), Qt::PointingHandCursor);
    QTest::mouseClick(&plot, Qt::LeftButton, {}, there);
    // Within the cell that was hit.
    QVERIFY2(std::abs(std::log10(bench.session.parameter("k"))) < 0.05,
             qPrintable(QString::number(bench.session.parameter("k"))));
    QVERIFY(std::abs(bench.session.parameter("damp") - damp) < 0.03);
    QCOMPARE(bench.session.timeline().script().step, sim::StepSize::ofLength(h));
    QCOMPARE(bench.window.stability().tried().size(), tried + 1); // one change, not one for each number
    QVERIFY(bench.session.timeline().comparison());               // the run as it was
    const sim::Values &before = bench.session.timeline().comparison()->script().values;
    QCOMPARE(before["k"], 0.2);
    QCOMPARE(bench.session.timeline().comparison()->script().step, sim::StepSize::ofLength(1.0));
    QCOMPARE(bench.session.timeline().comparison()->computed(), std::int64_t(40));
}

void GrowthMapTest::keysWalkOverTheMapAndGoThere()
{
    StabilityPanelBench bench;
    GrowthPlot &plot = openMap(bench, 1);
    plot.setFocus(Qt::TabFocusReason);
    const double k = bench.session.parameter("k"), damp = bench.session.parameter("damp");
    for (int i = 0; i < 3; ++i)
        QTest::keyClick(&plot, Qt::Key_Right);
    QTest::keyClick(&plot, Qt::Key_Down);
    QVERIFY2(plot.sentence().contains("Enter uses"), qPrintable(plot.sentence()));
    QCOMPARE(bench.session.parameter("k"), k); // walking alone changes nothing
    QTest::keyClick(&plot, Qt::Key_Return);
    QVERIFY(bench.session.parameter("k") > k);
    QVERIFY(bench.session.parameter("damp") < damp);
    bench.mapped();
    QAccessibleInterface *map = QAccessible::queryAccessibleInterface(&plot);
    QVERIFY(map->actionInterface()->actionNames().contains(QAccessibleActionInterface::pressAction()));
    QTest::keyClick(&plot, Qt::Key_Left);
    const double now = bench.session.parameter("k");
    map->actionInterface()->doAction(QAccessibleActionInterface::pressAction());
    QVERIFY(bench.session.parameter("k") < now);
    QVERIFY(!bench.session.isPlaying()); // Space and Enter are the map's own here
}

void GrowthMapTest::aTipTellsWhatAClickDoes()
{
    StabilityPanelBench bench;
    GrowthPlot &plot = openMap(bench, 1);
    const QString tip = plot.tipAt(plot.onScreen({1.0, 0.5, 1.0}));
    QVERIFY2(tip.startsWith(plot.wordsAt(plot.onScreen({1.0, 0.5, 1.0}))), qPrintable(tip));
    QVERIFY2(tip.contains("A click or Enter uses k 1 and damp 0.5"), qPrintable(tip));
    QVERIFY(plot.tipAt({1.0, 1.0}).isEmpty());
}

void GrowthMapTest::aSpotOfTheMapTakesTheNearestStepThatFits()
{
    StabilityPanelBench bench;
    const StabilityWatch &watch = bench.window.stability();
    QVERIFY(watch.settable({0.21544, 0.718, 0.27}) == (TriedSpot{0.215, 0.72, 0.25}));
    QVERIFY(watch.settable({123.4, 0.9, 2.8}) == (TriedSpot{123.0, 0.9, 3.0}));
    QCOMPARE(watch.settable({1e12, 0.9, 1.0}).k, bench.session.step().parameter("k")->max);
}

void GrowthMapTest::whereThereIsNoMapItSaysSo_data()
{
    QTest::addColumn<QString>("lesson");
    QTest::addColumn<QString>("step");
    QTest::addColumn<QString>("method");
    QTest::addColumn<QString>("why");
    QTest::newRow("no stiffness") << "rigid_constraint"
                                  << "list"
                                  << "published"
                                  << "it has no stiffness k";
    QTest::newRow("no springs") << "single_spring"
                                << "drag"
                                << "published"
                                << "no springs act";
    QTest::newRow("no limit") << "two_body"
                              << "mutual"
                              << "backward_euler"
                              << "for this method";
}

void GrowthMapTest::whereThereIsNoMapItSaysSo()
{
    QFETCH(QString, lesson);
    QFETCH(QString, step);
    QFETCH(QString, method);
    QFETCH(QString, why);
    StabilityPanelBench bench(qPrintable(lesson), qPrintable(step));
    bench.session.setMethod(method);
    QTest::mouseClick(&bench.gauge, Qt::LeftButton);
    bench.settle();
    QVERIFY(!bench.plane(0)->isEnabled() && !bench.plane(1)->isEnabled());
    QVERIFY(!bench.panel.plot().isVisible());
    QString said;
    for (const QLabel *label : bench.panel.findChildren<QLabel *>("caption")) {
        if (label->isVisible() && label->text().startsWith("There is no map"))
            said = label->text();
    }
    QVERIFY2(said.contains(why), qPrintable(said));
    QCOMPARE(bench.panel.leftOut().contains("sticks"), lesson == "rigid_constraint");
}

void GrowthMapTest::theWindowMayCloseWhileTheMapIsOpen()
{
    StabilityPanelBench bench;
    bench.session.setParameter("k", 0.3);
    QTest::mouseClick(&bench.gauge, Qt::LeftButton);
    QVERIFY(QTest::qWaitFor([&] { return !bench.panel.remedies().empty(); }));
    QTest::mouseClick(bench.plane(0), Qt::LeftButton); // under way when the window goes
    bench.window.close();
    QCoreApplication::processEvents();
    QVERIFY(!bench.window.stability().isMapping());
}

void GrowthMapTest::theMapIsSavedAsPictureAndNumbers()
{
    StabilityPanelBench bench;
    auto *menu = bench.panel.findChild<QToolButton *>("plotMenu");
    QVERIFY(!menu->isVisible()); // there is no map yet
    GrowthPlot &plot = openMap(bench, 0);
    QVERIFY(menu->isVisible());
    QCOMPARE(menu->menu()->actions().size(), 3);
    const QTemporaryDir folder;
    const std::pair<const char *, const char *> forms[] = {
        {"a.png", "\x89PNG"}, {"a.svg", "<?xml"}, {"a.pdf", "%PDF"}};
    for (const auto &[name, begins] : forms) {
        QVERIFY(bench.panel.exports().savePicture(folder.filePath(name)));
        QFile file(folder.filePath(name));
        QVERIFY(file.open(QIODevice::ReadOnly));
        QVERIFY2(file.readAll().startsWith(begins), name);
    }
    QImage image(folder.filePath("a.png"));
    QCOMPARE(image.width(), 2 * plot.width()); // twice as sharp as the screen
    const QPointF grown = 2.0 * plot.onScreen({9.0, 0.9, 2.0}) + QPointF(0.0, 2.0 * 32.0);
    QVERIFY(isNear(image.pixelColor(grown.toPoint()), colourAt(plot, plot.onScreen({9.0, 0.9, 2.0}))));
    bench.panel.exports().saveNumbers(folder.filePath("a.csv"));
    QFile file(folder.filePath("a.csv"));
    QVERIFY(file.open(QIODevice::ReadOnly));
    const QStringList lines = QString::fromUtf8(file.readAll()).trimmed().split('\n');
    const sim::GrowthMap &map = *bench.window.stability().map();
    QCOMPARE(lines[0], QString("\"k\",\"step [frames]\",\"growth [a frame]\""));
    QCOMPARE(lines.size(), qsizetype(1 + map.x.values.size() * map.y.values.size()));
    const std::size_t column = map.x.values.size() - 1, row = 2;
    const QStringList place = lines[qsizetype(1 + row * map.x.values.size() + column)].split(',');
    QCOMPARE(place[0].toDouble(), map.x.values[column]);
    QCOMPARE(place[1].toDouble(), map.y.values[row]);
    QCOMPARE(place[2].toDouble(), map.at(column, row));
}

QTEST_MAIN(GrowthMapTest)
#include "tst_growth_map.moc"
