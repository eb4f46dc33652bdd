// The map of growth in the window, used with mouse and keys.

#include "app/ui/plots/plot_export.h"
#include "tests/app/panels/stability_panel_support.h"
#include "tests/suite.h"

#include <QAccessible>
#include <QImage>
#include <QLabel>
#include <QMenu>
#include <QTemporaryDir>

using namespace app;

namespace {

GrowthPlot &openMap(StabilityFixture &fixture, int plane)
{
    QTest::mouseClick(&fixture.gauge, Qt::LeftButton);
    QTest::mouseClick(fixture.plane(plane), Qt::LeftButton);
    fixture.waitForMap();
    return fixture.panel.plot();
}

/// Returns how much of the ink there is in 9 px of a row of the plot, in px of full ink. Antialiasing spreads a line over
/// more pixels, but keeps this sum.
double inkAcross(GrowthPlot &plot, QPointF middle, const Tokens &tokens)
{
    const QImage image = plot.grab().toImage();
    const double ratio = image.devicePixelRatio();
    const QPoint at = (middle * ratio).toPoint();
    const int reach = qRound(4.5 * ratio);
    const double ground = tokens.scene.lightnessF(), ink = tokens.ink.lightnessF();
    double sum = 0.0;
    for (int x = at.x() - reach; x <= at.x() + reach; ++x)
        sum += (ground - image.pixelColor(x, at.y()).lightnessF()) / (ground - ink);
    return sum / ratio;
}

}

class GrowthMapTest : public QObject
{
    Q_OBJECT

private slots:
    void theMapIsDrawnOnRequest();
    void theMapShowsWhereTheLearnerIsAndWas();
    void lineBetweenTriedSetupsIsDrawn_data();
    void lineBetweenTriedSetupsIsDrawn();
    void theMapTellsWhatIsUnderThePointer();
    void aClickOnTheMapGoesThere_data();
    void aClickOnTheMapGoesThere();
    void keysWalkOverTheMapAndGoThere();
    void aTipTellsWhatAClickDoes();
    void pointOfTheMapIsRoundedToValuesThatCanBeSet();
    void aMethodWithoutAMapSaysSo_data();
    void aMethodWithoutAMapSaysSo();
    void theWindowMayCloseWhileTheMapIsOpen();
    void theMapIsSavedAsPictureAndNumbers();
};

void GrowthMapTest::theMapIsDrawnOnRequest()
{
    StabilityFixture fixture;
    QTest::mouseClick(&fixture.gauge, Qt::LeftButton);
    fixture.waitForReading();
    GrowthPlot &plot = fixture.panel.plot();
    QVERIFY(!plot.isVisible());
    QVERIFY(!fixture.window.stability().isMapping());
    QTest::mouseClick(fixture.plane(0), Qt::LeftButton);
    fixture.waitForMap();
    QVERIFY(plot.isVisible());
    // At k = 0.02 all steps up to 4 frames hold; at k = 9 one of 2 frames does not.
    QVERIFY(isNear(colourAt(plot, plot.onScreen({0.02, 0.9, 0.1})), fixture.theme.tokens().scene));
    QVERIFY(!isNear(colourAt(plot, plot.onScreen({9.0, 0.9, 2.0})), fixture.theme.tokens().scene));
    QTest::mouseClick(fixture.plane(1), Qt::LeftButton);
    fixture.waitForMap();
    QCOMPARE(fixture.window.stability().map()->y.parameter, "damp");
    QVERIFY(!fixture.plane(0)->isChecked());
    QTest::mouseClick(fixture.plane(1), Qt::LeftButton);
    QVERIFY(!plot.isVisible());
    QVERIFY(!fixture.window.stability().map());
}

void GrowthMapTest::theMapShowsWhereTheLearnerIsAndWas()
{
    StabilityFixture fixture;
    GrowthPlot &plot = openMap(fixture, 1);
    const QPointF first = plot.onScreen(fixture.window.stability().tried().back());
    QVERIFY(isNear(colourAt(plot, first), fixture.theme.tokens().now));
    fixture.session.editor().setParameter("k", 0.02);
    fixture.session.editor().setParameter("damp", 0.4);
    const QPointF here = plot.onScreen(fixture.window.stability().tried().back());
    QVERIFY(here.x() < first.x() && here.y() > first.y());
    QVERIFY(isNear(colourAt(plot, here), fixture.theme.tokens().now));
    QVERIFY(!isNear(colourAt(plot, first), fixture.theme.tokens().now));
}

void GrowthMapTest::lineBetweenTriedSetupsIsDrawn_data()
{
    QTest::addColumn<int>("width");
    for (const int width : {1280, 1281, 1283, 1286, 1366})
        QTest::addRow("%d px", width) << width;
}

void GrowthMapTest::lineBetweenTriedSetupsIsDrawn()
{
    QFETCH(int, width);
    StabilityFixture fixture;
    GrowthPlot &plot = openMap(fixture, 1);
    fixture.window.resize(width, 800);
    const double top = plot.onScreen(fixture.window.stability().tried().back()).y();
    const auto between = [&] {
        const QPointF here = plot.onScreen(fixture.window.stability().tried().back());
        return QPointF(here.x(), 0.5 * (top + here.y()));
    };
    fixture.session.editor().setParameter("k", 0.02);
    fixture.session.editor().setParameter("damp", 0.4);
    tests::settle();
    // Down along k = 0.02. The line has its width of 1.5 px wherever it lies between the pixels.
    const double wide = inkAcross(plot, between(), fixture.theme.tokens());
    QVERIFY2(std::abs(wide - 1.5) < 0.15, qPrintable(QString::number(wide)));
    // Beside it there is nothing.
    const double beside = inkAcross(plot, between() + QPointF(12.0, 0.0), fixture.theme.tokens());
    QVERIFY2(std::abs(beside) < 0.15, qPrintable(QString::number(beside)));
}

void GrowthMapTest::theMapTellsWhatIsUnderThePointer()
{
    StabilityFixture fixture;
    GrowthPlot &plot = openMap(fixture, 1);
    QVERIFY(plot.wordsAt(plot.onScreen({0.05, 0.5, 1.0})).contains(": stable"));
    QVERIFY(plot.wordsAt(plot.onScreen({5.0, 0.9, 1.0})).contains("times a frame"));
    QVERIFY(plot.wordsAt({1.0, 1.0}).isEmpty());
    QVERIFY2(plot.sentence().contains(": stable"), qPrintable(plot.sentence()));
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
    StabilityFixture fixture;
    fixture.goTo(40);
    fixture.goTo(20); // so that there is a run to become the ghost
    GrowthPlot &plot = openMap(fixture, plane);
    const std::size_t tried = fixture.window.stability().tried().size();
    const QPoint there = plot.onScreen({1.0, damp, h}).toPoint();
    tests::moveMouse(plot, there);
    QCOMPARE(plot.cursor().shape(), Qt::PointingHandCursor);
    QTest::mouseClick(&plot, Qt::LeftButton, {}, there);
    // Within the cell that was hit.
    QVERIFY2(std::abs(std::log10(fixture.session.editor().parameter("k"))) < 0.05,
             qPrintable(QString::number(fixture.session.editor().parameter("k"))));
    QVERIFY(std::abs(fixture.session.editor().parameter("damp") - damp) < 0.03);
    QCOMPARE(fixture.session.timeline().script().step, sim::StepSize::ofLength(h));
    QCOMPARE(fixture.window.stability().tried().size(), tried + 1); // one change, not one for each number
    QVERIFY(fixture.session.timeline().comparison());               // the run as it was
    const sim::Values &before = fixture.session.timeline().comparison()->script().values;
    QCOMPARE(before["k"], 0.2);
    QCOMPARE(fixture.session.timeline().comparison()->script().step, sim::StepSize::ofLength(1.0));
    QCOMPARE(fixture.session.timeline().comparison()->computed(), std::int64_t(40));
}

void GrowthMapTest::keysWalkOverTheMapAndGoThere()
{
    StabilityFixture fixture;
    GrowthPlot &plot = openMap(fixture, 1);
    plot.setFocus(Qt::TabFocusReason);
    const double k = fixture.session.editor().parameter("k"),
                 damp = fixture.session.editor().parameter("damp");
    for (int i = 0; i < 3; ++i)
        QTest::keyClick(&plot, Qt::Key_Right);
    QTest::keyClick(&plot, Qt::Key_Down);
    QVERIFY2(plot.sentence().contains("press Enter to use"), qPrintable(plot.sentence()));
    QCOMPARE(fixture.session.editor().parameter("k"), k); // walking alone changes nothing
    QTest::keyClick(&plot, Qt::Key_Return);
    QVERIFY(fixture.session.editor().parameter("k") > k);
    QVERIFY(fixture.session.editor().parameter("damp") < damp);
    fixture.waitForMap();
    QAccessibleInterface *map = QAccessible::queryAccessibleInterface(&plot);
    QVERIFY(map->actionInterface()->actionNames().contains(QAccessibleActionInterface::pressAction()));
    QTest::keyClick(&plot, Qt::Key_Left);
    const double now = fixture.session.editor().parameter("k");
    map->actionInterface()->doAction(QAccessibleActionInterface::pressAction());
    QVERIFY(fixture.session.editor().parameter("k") < now);
    QVERIFY(!fixture.session.playback().isPlaying()); // the map handles Space and Enter itself
}

void GrowthMapTest::aTipTellsWhatAClickDoes()
{
    StabilityFixture fixture;
    GrowthPlot &plot = openMap(fixture, 1);
    const QString tip = plot.tipAt(plot.onScreen({1.0, 0.5, 1.0}));
    QVERIFY2(tip.startsWith(plot.wordsAt(plot.onScreen({1.0, 0.5, 1.0}))), qPrintable(tip));
    QVERIFY2(tip.contains("Click or press Enter to use k 1 and damp 0.5"), qPrintable(tip));
    QVERIFY(plot.tipAt({1.0, 1.0}).isEmpty());
}

void GrowthMapTest::pointOfTheMapIsRoundedToValuesThatCanBeSet()
{
    StabilityFixture fixture;
    const StabilityMonitor &monitor = fixture.window.stability();
    QVERIFY(monitor.settable({0.21544, 0.718, 0.27}) == (TriedSpot{0.215, 0.72, 0.25}));
    QVERIFY(monitor.settable({123.4, 0.9, 2.8}) == (TriedSpot{123.0, 0.9, 3.0}));
    QCOMPARE(monitor.settable({1e12, 0.9, 1.0}).k, fixture.session.step().parameter("k")->max);
}

void GrowthMapTest::aMethodWithoutAMapSaysSo_data()
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

void GrowthMapTest::aMethodWithoutAMapSaysSo()
{
    QFETCH(QString, lesson);
    QFETCH(QString, step);
    QFETCH(QString, method);
    QFETCH(QString, why);
    StabilityFixture fixture(qPrintable(lesson), qPrintable(step));
    fixture.session.editor().setMethod(method);
    QTest::mouseClick(&fixture.gauge, Qt::LeftButton);
    fixture.waitForReading();
    QVERIFY(!fixture.plane(0)->isEnabled() && !fixture.plane(1)->isEnabled());
    QVERIFY(!fixture.panel.plot().isVisible());
    QString said;
    for (const QLabel *label : fixture.panel.findChildren<QLabel *>("caption")) {
        if (label->isVisible() && label->text().startsWith("There is no map"))
            said = label->text();
    }
    QVERIFY2(said.contains(why), qPrintable(said));
    QCOMPARE(fixture.panel.leftOut().contains("sticks"), lesson == "rigid_constraint");
}

void GrowthMapTest::theWindowMayCloseWhileTheMapIsOpen()
{
    StabilityFixture fixture;
    fixture.session.editor().setParameter("k", 0.3);
    QTest::mouseClick(&fixture.gauge, Qt::LeftButton);
    QVERIFY(QTest::qWaitFor([&] { return !fixture.panel.remedies().empty(); }));
    QTest::mouseClick(fixture.plane(0), Qt::LeftButton); // under way when the window goes
    fixture.window.close();
    QCoreApplication::processEvents();
    QVERIFY(!fixture.window.stability().isMapping());
}

void GrowthMapTest::theMapIsSavedAsPictureAndNumbers()
{
    StabilityFixture fixture;
    auto *menu = fixture.panel.findChild<QToolButton *>("plotMenu");
    QVERIFY(!menu->isVisible()); // there is no map yet
    GrowthPlot &plot = openMap(fixture, 0);
    QVERIFY(menu->isVisible());
    QCOMPARE(menu->menu()->actions().size(), 3);
    const QTemporaryDir folder;
    const std::pair<const char *, const char *> forms[] = {
        {"a.png", "\x89PNG"}, {"a.svg", "<?xml"}, {"a.pdf", "%PDF"}};
    for (const auto &[name, begins] : forms) {
        QVERIFY(fixture.panel.exports().savePicture(folder.filePath(name)));
        QFile file(folder.filePath(name));
        QVERIFY(file.open(QIODevice::ReadOnly));
        QVERIFY2(file.readAll().startsWith(begins), name);
    }
    QImage image(folder.filePath("a.png"));
    QCOMPARE(image.width(), 2 * plot.width()); // twice as sharp as the screen
    const QPointF grown = 2.0 * plot.onScreen({9.0, 0.9, 2.0}) + QPointF(0.0, 2.0 * 32.0);
    QVERIFY(isNear(image.pixelColor(grown.toPoint()), colourAt(plot, plot.onScreen({9.0, 0.9, 2.0}))));
    fixture.panel.exports().saveNumbers(folder.filePath("a.csv"));
    QFile file(folder.filePath("a.csv"));
    QVERIFY(file.open(QIODevice::ReadOnly));
    const QStringList lines = QString::fromUtf8(file.readAll()).trimmed().split('\n');
    const sim::GrowthMap &map = *fixture.window.stability().map();
    QCOMPARE(lines[0], QString("\"k\",\"step [frames]\",\"growth [a frame]\""));
    QCOMPARE(lines.size(), qsizetype(1 + map.x.values.size() * map.y.values.size()));
    const std::size_t column = map.x.values.size() - 1, row = 2;
    const QStringList place = lines[qsizetype(1 + row * map.x.values.size() + column)].split(',');
    QCOMPARE(place[0].toDouble(), map.x.values[column]);
    QCOMPARE(place[1].toDouble(), map.y.values[row]);
    QCOMPARE(place[2].toDouble(), map.at(column, row));
}

SUITE(tst_growth_map, GrowthMapTest)
#include "tst_growth_map.moc"
