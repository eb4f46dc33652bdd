// The map of the time to rest in the window, used with mouse and keys.

#include "app/model/analysis/settling_monitor.h"
#include "app/ui/plots/plot_export.h"
#include "app/ui/stability/settling_plot.h"
#include "tests/app/panels/stability_panel_support.h"
#include "tests/suite.h"

#include <QLabel>
#include <QTemporaryDir>

using namespace app;

namespace {

struct SettlingFixture : StabilityFixture
{
    explicit SettlingFixture(const char *lesson = "single_spring", const char *step = "fixed_centre")
        : StabilityFixture(lesson, step)
    {
    }
    const SettlingMonitor &monitor() const { return window.settling(); }
    SettlingPlot &plot() { return panel.settlingPlot(); }
    void press() { QTest::keyClick(&window, Qt::Key_L, Qt::ControlModifier | Qt::ShiftModifier); }
    /// Shows the map, and waits until there are enough cells to work with.
    SettlingPlot &openMap()
    {
        press();
        waitForCells();
        return plot();
    }
    void waitForCells()
    {
        if (!QTest::qWaitFor([&] { return monitor().map() && monitor().map()->stride > 0; }, 60'000))
            qFatal("no map");
        QCoreApplication::processEvents();
    }
    /// Returns the captions that are seen, in one text.
    QString captions() const
    {
        QString all;
        for (const QLabel *label : panel.findChildren<QLabel *>("caption")) {
            if (label->isVisible())
                all += label->text() + '\n';
        }
        return all;
    }
    double parameter(const char *id) const { return session.editor().parameter(id); }
};

}

class SettlingMapTest : public QObject
{
    Q_OBJECT

private slots:
    void theMapOpensByItsKeysAndByItsTab();
    void mapShowsTheTimeToRest();
    void aClickBeginsTheRunAgainWithBothNumbers();
    void keysMoveOverTheMapAndEnterUsesTheValues();
    void theLearnersInputIsPartOfTheMap();
    void theTwoNumbersAloneChangeOnlyTheMark();
    void coloursAreToldByTheirLightness();
    void aSceneWithoutAMapOfRestSaysSo();
    void theMapOfRestIsSavedAsPictureAndNumbers();
};

void SettlingMapTest::theMapOpensByItsKeysAndByItsTab()
{
    SettlingFixture fixture;
    QVERIFY(!fixture.monitor().isMapping()); // nothing is computed before it is asked for
    fixture.openMap();
    QVERIFY(fixture.plot().isVisible() && fixture.plane(2)->isChecked());
    QVERIFY(fixture.action("showSettling").isChecked());
    fixture.press();
    QVERIFY(!fixture.plot().isVisible() && !fixture.action("showSettling").isChecked());
    QVERIFY(!fixture.monitor().isMapping() && !fixture.monitor().map());
    QTest::mouseClick(fixture.plane(2), Qt::LeftButton);
    QVERIFY(fixture.action("showSettling").isChecked());
    QTest::mouseClick(fixture.plane(1), Qt::LeftButton); // one map at a time
    QVERIFY(!fixture.plot().isVisible() && !fixture.plane(2)->isChecked());
    QTest::mouseClick(fixture.plane(2), Qt::LeftButton);
    QVERIFY(!fixture.plane(1)->isChecked() && !fixture.panel.plot().isVisible());
    fixture.window.docks().show(Panel::stability, false);
    QVERIFY(!fixture.monitor().isActive());
}

void SettlingMapTest::mapShowsTheTimeToRest()
{
    SettlingFixture fixture;
    SettlingPlot &plot = fixture.openMap();
    // The run of a cell of the coarsest grid, computed alone, tells the same.
    const sim::SettlingMap &map = *fixture.monitor().map();
    const std::size_t column = 24, row = 40;
    const TriedSpot spot{map.x.values[column], map.y.values[row], 1.0};
    sim::Script script = fixture.session.timeline().script();
    script.values.set("k", spot.k);
    script.values.set("damp", spot.damp);
    const std::int64_t frames = sim::settlingOf(script, [] { return true; })->frames;
    const QString said = plot.wordsAt(plot.onScreen(spot));
    QVERIFY2(said.endsWith(QString(": at rest after %1 frames").arg(frames)), qPrintable(said));
    QVERIFY(plot.wordsAt(plot.onScreen({0.2, 1.0, 1.0})).endsWith("still moving after 600 frames"));
    QVERIFY(plot.wordsAt(plot.onScreen({9.0, 0.9, 1.0})).endsWith("grows without bound"));
    QVERIFY2(plot.sentence().contains("at rest after"), qPrintable(plot.sentence()));
    const QString tip = plot.tipAt(plot.onScreen(spot));
    QVERIFY2(tip.contains("Click or press Enter to begin the run again with k 0.16"), qPrintable(tip));
    QVERIFY2(tip.endsWith("and damp 0.84"), qPrintable(tip));
}

void SettlingMapTest::aClickBeginsTheRunAgainWithBothNumbers()
{
    SettlingFixture fixture;
    fixture.goTo(60);
    fixture.session.editor().setParameter("k", 0.1); // from here on only
    SettlingPlot &plot = fixture.openMap();
    const int edits = fixture.session.editor().undoStack().count();
    const QPoint there = plot.onScreen({1.0, 0.5, 1.0}).toPoint();
    QTest::mouseMove(&plot, there);
    QCOMPARE(plot.cursor().shape(), Qt::PointingHandCursor);
    QTest::mouseClick(&plot, Qt::LeftButton, {}, there);
    QVERIFY(std::abs(std::log10(fixture.parameter("k"))) < 0.05);
    QVERIFY(std::abs(fixture.parameter("damp") - 0.5) < 0.03);
    QCOMPARE(fixture.frame(), std::int64_t(0));
    QCOMPARE(fixture.session.timeline().script().values["k"], fixture.parameter("k")); // from the start
    QVERIFY(fixture.session.timeline().script().input.empty());
    QVERIFY(fixture.session.timeline().comparison()); // the run as it was
    QCOMPARE(fixture.session.editor().undoStack().count(), edits + 1);
    fixture.session.editor().undo();
    QCOMPARE(fixture.parameter("damp"), 0.9);
    QCOMPARE(fixture.session.timeline().script().values["k"], 0.2);
    QCOMPARE(fixture.session.timeline().script().input.size(), std::size_t(1));
}

void SettlingMapTest::keysMoveOverTheMapAndEnterUsesTheValues()
{
    SettlingFixture fixture;
    SettlingPlot &plot = fixture.openMap();
    plot.setFocus(Qt::TabFocusReason);
    const double k = fixture.parameter("k"), damp = fixture.parameter("damp");
    for (int i = 0; i < 3; ++i)
        QTest::keyClick(&plot, Qt::Key_Right);
    QTest::keyClick(&plot, Qt::Key_Down);
    QVERIFY2(plot.sentence().contains("press Enter to begin the run again"), qPrintable(plot.sentence()));
    QCOMPARE(fixture.parameter("k"), k); // walking alone changes nothing
    QTest::keyClick(&plot, Qt::Key_Return);
    QVERIFY(fixture.parameter("k") > k && fixture.parameter("damp") < damp);
    QVERIFY(!fixture.session.playback().isPlaying()); // the map handles Enter itself
}

void SettlingMapTest::theLearnersInputIsPartOfTheMap()
{
    SettlingFixture fixture;
    fixture.openMap();
    QVERIFY2(fixture.captions().contains("Your run from its start: after how many frames"),
             qPrintable(fixture.captions()));
    fixture.drag("foot", {60, -30});
    fixture.session.playback().pause();
    fixture.waitForCells();
    const std::vector<sim::Event> &input = fixture.session.timeline().script().input;
    QVERIFY(!input.empty());
    QCOMPARE(fixture.monitor().countedFrom(), input.back().frame);
    const QString last = QString("after frame %1, your last input").arg(input.back().frame);
    QVERIFY2(fixture.captions().contains(last), qPrintable(fixture.captions()));
}

void SettlingMapTest::theTwoNumbersAloneChangeOnlyTheMark()
{
    SettlingFixture fixture;
    SettlingPlot &plot = fixture.openMap();
    QTRY_VERIFY_WITH_TIMEOUT(!fixture.monitor().isMapping(), 60'000);
    const sim::SettlingMap *map = fixture.monitor().map();
    const QPointF before = plot.onScreen(fixture.monitor().tried().back());
    fixture.session.editor().setParameter("k", 0.05);
    fixture.session.editor().setParameter("damp", 0.5);
    tests::settle();
    QVERIFY(!fixture.monitor().isMapping());
    QCOMPARE(fixture.monitor().map(), map);
    const QPointF here = plot.onScreen(fixture.monitor().tried().back());
    QVERIFY(here.x() < before.x() && here.y() > before.y());
    QVERIFY(isNear(colourAt(plot, here), fixture.theme.tokens().now));
    fixture.session.editor().setMethod("rk4"); // another question
    QVERIFY(fixture.monitor().isMapping());
}

void SettlingMapTest::coloursAreToldByTheirLightness()
{
    SettlingFixture fixture;
    SettlingPlot &plot = fixture.openMap();
    const auto lightness = [&](double k, double damp) {
        return colourAt(plot, plot.onScreen({k, damp, 1.0})).lightnessF();
    };
    for (const Scheme scheme : {Scheme::light, Scheme::dark, Scheme::highContrast}) {
        fixture.theme.setScheme(scheme);
        tests::settle();
        const double ground = fixture.theme.tokens().scene.lightnessF();
        const double soon = std::abs(lightness(1.0, 0.28) - ground);
        const double late = std::abs(lightness(1.0, 0.94) - ground);
        QVERIFY2(late > soon + 0.2, qPrintable(QString("%1 %2").arg(soon).arg(late)));
    }
}

void SettlingMapTest::aSceneWithoutAMapOfRestSaysSo()
{
    SettlingFixture fixture("rigid_constraint", "list");
    fixture.press();
    QVERIFY(fixture.panel.isVisible() && !fixture.plot().isVisible());
    QVERIFY2(fixture.captions().contains("no map of the time to rest"), qPrintable(fixture.captions()));
    QVERIFY(!fixture.monitor().isMapping());
    fixture.session.openStep("single_spring", "fixed_centre");
    fixture.waitForCells();
    QVERIFY(fixture.plot().isVisible());
}

void SettlingMapTest::theMapOfRestIsSavedAsPictureAndNumbers()
{
    SettlingFixture fixture;
    fixture.openMap();
    const QTemporaryDir folder;
    QVERIFY(fixture.panel.exports().savePicture(folder.filePath("a.svg")));
    fixture.panel.exports().saveNumbers(folder.filePath("a.csv"));
    QFile file(folder.filePath("a.csv"));
    QVERIFY(file.open(QIODevice::ReadOnly));
    const QStringList lines = QString::fromUtf8(file.readAll()).trimmed().split('\n');
    QCOMPARE(lines[0], QString("\"k\",\"damp\",\"time to rest [frames]\",\"outcome\""));
    const sim::SettlingMap &map = *fixture.monitor().map();
    QVERIFY(lines.size() > 30);
    const QStringList place = lines[1].split(',');
    QCOMPARE(place[0].toDouble(), map.x.values[0]);
    QCOMPARE(place[1].toDouble(), map.y.values[0]);
    const bool settles = map.cells[0]->kind == sim::Settling::Kind::settles;
    QCOMPARE(place[2].isEmpty(), !settles);
    QCOMPARE(place[3] == "\"at rest\"", settles);
}

SUITE(tst_settling_map, SettlingMapTest)
#include "tst_settling_map.moc"
