// Other runs in the window, by mouse and keys: the timeline's marks, the menu of runs, and two runs compared.

#include "app/model/run/same_run.h"
#include "app/ui/branches/branches_panel.h"
#include "app/ui/branches/difference_plot.h"
#include "app/ui/energy/energy_panel.h"
#include "app/ui/plots/plot_export.h"
#include "app/ui/time/name_field.h"
#include "app/ui/time/runs_menu.h"
#include "app/ui/time/timeline_strip.h"
#include "app/ui/time/transport_bar.h"
#include "tests/app/model/branches_support.h"
#include "tests/app/support/window_fixture.h"
#include "tests/suite.h"

#include <QAccessible>
#include <QAction>
#include <QContextMenuEvent>
#include <QDockWidget>
#include <QLineEdit>
#include <QScreen>
#include <QTemporaryDir>
#include <QToolButton>
#include <QtTest>

#include <cmath>

using namespace app;
using namespace tests;

namespace {

struct BranchesFixture : WindowFixture
{
    explicit BranchesFixture(QSize size = {1280, 800})
        : WindowFixture(
              {.lesson = "fall", .step = "fall", .size = size, .library = branches_support::library()})
    {
    }

    void fork(std::int64_t end, std::int64_t at, double gravity)
    {
        goTo(end);
        goTo(at);
        session.editor().setParameter("gravity", gravity);
        session.editor().endGesture();
    }
    const std::vector<Branch> &branches() { return session.comparisons().branches().all(); }
    TimelineStrip &strip() { return part<TimelineStrip>(); }
    /// Returns the position of the mark of a fork, below the track.
    QPoint mark(std::int64_t frame) { return {qRound(strip().axis().xOf(frame)) + 4, 38}; }
    QToolButton *runsButton() { return &part<QToolButton>("runsButton"); }
    RunsMenu &menu() { return part<TransportBar>().runs(); }
    BranchesPanel &panel() { return part<BranchesPanel>(); }
    QMenu *openMenu() { return qobject_cast<QMenu *>(QApplication::activePopupWidget()); }
};

}

class BranchesPanelTest : public QObject
{
    Q_OBJECT

private slots:
    void cleanup()
    {
        while (QApplication::activePopupWidget())
            QApplication::activePopupWidget()->close();
    }

    void aClickBelowTheTrackDoesNotMoveTheCursor()
    {
        BranchesFixture fixture;
        fixture.fork(100, 60, 0.75);
        fixture.session.comparisons().show(0);
        fixture.goTo(90);
        QVERIFY(fixture.strip().hintAt(fixture.mark(60)).contains("before: gravity 0.5"));
        QTest::mouseClick(&fixture.strip(), Qt::LeftButton, {}, fixture.mark(60));
        QCOMPARE(fixture.session.comparisons().shown(), &fixture.branches().front());
        QCOMPARE(fixture.session.timeline().cursor().frame, 90);
        QTRY_VERIFY(fixture.session.timeline().comparison());
        QTest::mouseClick(&fixture.strip(), Qt::LeftButton, {},
                          {fixture.mark(60).x(), 25}); // the track still scrubs
        QTRY_VERIFY(fixture.session.timeline().cursor().frame < 70);
    }

    void severalRunsAtOneForkAreChosenFromAMenu()
    {
        BranchesFixture fixture;
        fixture.fork(100, 60, 0.75);
        fixture.fork(100, 60, 1.0);
        fixture.session.comparisons().show(0);
        QVERIFY(fixture.strip().hintAt(fixture.mark(60)).startsWith("2 other runs"));
        QTest::mouseClick(&fixture.strip(), Qt::LeftButton, {}, fixture.mark(60));
        QTRY_VERIFY(fixture.openMenu());
        QCOMPARE(fixture.openMenu()->actions().front()->text(),
                 "before: gravity 0.75, branches off at frame 60");
        QTest::keyClick(fixture.openMenu(), Qt::Key_Down);  // the newest run
        QTest::keyClick(fixture.openMenu(), Qt::Key_Right); // its menu: show beside
        QTest::keyClick(fixture.openMenu(), Qt::Key_Return);
        QTRY_COMPARE(fixture.session.comparisons().comparisonName(), "before: gravity 0.75");
    }

    void theMenuOfRunsIsReachedByKeysAndGoesBack()
    {
        BranchesFixture fixture;
        QVERIFY(!fixture.runsButton()->isEnabled());
        QVERIFY(fixture.runsButton()->toolTip().startsWith("Go back in time"));
        QCOMPARE(fixture.menu().actions().front()->text(), "No other run yet");
        fixture.fork(100, 60, 0.75);
        QVERIFY(fixture.runsButton()->isEnabled());
        QVERIFY(fixture.runsButton()->accessibleName().startsWith("Other runs"));
        const sim::Script old = *fixture.branches().front().script;
        QTest::keyClick(&fixture.window, Qt::Key_R, Qt::ControlModifier | Qt::ShiftModifier);
        QTRY_COMPARE(fixture.openMenu(), &fixture.menu());
        QTest::keyClick(fixture.openMenu(), Qt::Key_Down);
        QTest::keyClick(fixture.openMenu(), Qt::Key_Right);
        QTest::keyClick(fixture.openMenu(), Qt::Key_G); // Go back to it
        QVERIFY(sameScript(fixture.session.timeline().script(), old));
        QCOMPARE(fixture.branches().size(), std::size_t(1));
        QTest::keyClick(&fixture.window, Qt::Key_Z, Qt::ControlModifier);
        QVERIFY(!sameScript(fixture.session.timeline().script(), old));
    }

    void aRunIsKeptNamedAndDeletedByMouse()
    {
        BranchesFixture fixture;
        fixture.fork(100, 60, 0.75);
        const int id = fixture.branches().front().id;
        const auto choose = [&](const QString &text) {
            const QPoint dots(fixture.mark(60).x() + 40, 40);
            QContextMenuEvent ask(QContextMenuEvent::Mouse, dots, fixture.strip().mapToGlobal(dots));
            QApplication::sendEvent(&fixture.strip(), &ask);
            QMenu *menu = fixture.openMenu();
            for (QAction *action : menu->actions()) {
                if (action->text().remove('&') == text) {
                    QTest::mouseClick(menu, Qt::LeftButton, {}, menu->actionGeometry(action).center());
                    return;
                }
            }
            QFAIL(qPrintable(text));
        };
        choose("Keep");
        QVERIFY(fixture.branches().front().isKept);
        choose("Rename…");
        auto *field = qobject_cast<NameField *>(QApplication::activePopupWidget());
        QVERIFY(field);
        auto *edit = field->findChild<QLineEdit *>();
        QVERIFY(!edit->accessibleName().isEmpty());
        QTest::keyClicks(edit, "heavy & slow");
        QTest::keyClick(edit, Qt::Key_Return);
        QCOMPARE(fixture.session.comparisons().branches().find(id)->name, "heavy & slow");
        fixture.menu().popup({0, 0});
        QCOMPARE(fixture.menu().actions().front()->text(), "heavy && slow, branches off at frame 60, kept");
        fixture.menu().close();
        choose("Delete");
        QVERIFY(fixture.branches().empty());
        QTest::keyClick(&fixture.window, Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(fixture.branches().size(), std::size_t(1));
    }

    void escapeLeavesTheName()
    {
        BranchesFixture fixture;
        fixture.fork(100, 60, 0.75);
        NameField field("as it was", fixture.theme, &fixture.window);
        field.setAttribute(Qt::WA_DeleteOnClose, false);
        QSignalSpy named(&field, &NameField::named);
        field.popupAt({10, 10});
        QTest::keyClicks(field.findChild<QLineEdit *>(), "another");
        QTest::keyClick(field.findChild<QLineEdit *>(), Qt::Key_Escape);
        QVERIFY(!field.isVisible());
        QCOMPARE(named.count(), 0);
    }

    void panelBehindAnotherTabReadsNothing()
    {
        BranchesFixture fixture;
        fixture.fork(100, 60, 0.75);
        fixture.goTo(90);
        fixture.window.docks().show(Panel::branches, true);
        fixture.window.docks().show(Panel::energy, true);
        auto *energy = fixture.window.findChild<EnergyPanel *>();
        fixture.window.findChild<QDockWidget *>("energy")->raise();
        QTRY_VERIFY(energy->series().last() == 90);
        const std::int64_t looked = fixture.panel().series().next();
        fixture.goTo(100);
        QTRY_VERIFY(energy->series().last() == 100);
        QCOMPARE(fixture.panel().series().next(), looked);
        fixture.window.docks().show(Panel::branches, true); // to the front
        QTRY_VERIFY(fixture.panel().series().next() > looked);
        fixture.session.playback().frameForward();
        QCoreApplication::processEvents();
        QCOMPARE(energy->series().last(), 100);
    }

    void theFieldForANameStaysOnTheScreen()
    {
        BranchesFixture fixture;
        NameField field("a run", fixture.theme, &fixture.window);
        field.setAttribute(Qt::WA_DeleteOnClose, false);
        const QRect screen = QGuiApplication::primaryScreen()->availableGeometry();
        field.popupAt(screen.bottomRight());
        QVERIFY2(screen.contains(field.geometry()), qPrintable(QDebug::toString(field.geometry())));
    }

    void escapeCancelsARunThatIsStillComputed()
    {
        BranchesFixture fixture;
        fixture.fork(100, 60, 0.75);
        const int id = fixture.branches().front().id;
        fixture.session.comparisons().show(0);
        fixture.session.playback().goTo({400'000, 0});
        QTRY_VERIFY_WITH_TIMEOUT(!fixture.session.playback().goal(), 60'000);
        fixture.session.comparisons().show(id);
        QVERIFY(fixture.session.comparisons().isComputing());
        QTest::keyClick(&fixture.window, Qt::Key_Escape);
        QVERIFY(!fixture.session.comparisons().isComputing());
        QVERIFY(!fixture.session.comparisons().shown());
        QCOMPARE(fixture.session.timeline().cursor().frame, 400'000);
        QCOMPARE(fixture.branches().size(), std::size_t(1));
    }

    void twoRunsAreComparedInThePanel()
    {
        BranchesFixture fixture;
        QVERIFY(!fixture.panel().isVisible());
        QTest::keyClick(&fixture.window, Qt::Key_B, Qt::ControlModifier | Qt::ShiftModifier);
        QVERIFY(fixture.panel().isVisible());
        QVERIFY(fixture.panel().sentence().startsWith("There is no other run"));
        QVERIFY(!fixture.panel().plot().isVisible()); // axes without a curve
        fixture.fork(100, 60, 0.75);
        QVERIFY(fixture.panel().sentence().startsWith("No difference up to frame 60"));
        QVERIFY(fixture.panel().plot().isVisible());
        fixture.goTo(80);
        QTRY_COMPARE(fixture.panel().sentence(), "Largest: 53\u2009px apart, foot, at frame 80.");
        QCOMPARE(fixture.panel().plot().accessibleDescription(), fixture.panel().sentence());
        fixture.session.select("body");
        QToolButton *body = nullptr;
        for (QToolButton *one : fixture.panel().findChildren<QToolButton *>()) {
            QVERIFY2(!one->toolTip().isEmpty(), qPrintable(one->text()));
            body = one->text() == "body" ? one : body;
        }
        QVERIFY(body);
        QTest::mouseClick(body, Qt::LeftButton);
        QTRY_VERIFY(fixture.panel().sentence().startsWith("No difference up to frame 80"));
        QTest::keyClick(&fixture.window, Qt::Key_B, Qt::ControlModifier | Qt::ShiftModifier);
        QVERIFY(!fixture.panel().isVisible());
    }

    void theDifferenceIsSavedAsPictureAndNumbers()
    {
        BranchesFixture fixture;
        fixture.window.docks().show(Panel::branches, true);
        PlotExport &exports = fixture.panel().exports();
        QSignalSpy said(&exports, &PlotExport::messageRequested);
        QSignalSpy failed(&exports, &PlotExport::failed);
        const QTemporaryDir folder;
        exports.saveNumbers(folder.filePath("none.csv")); // nothing is compared yet
        QCOMPARE(failed.count(), 1);
        fixture.fork(100, 60, 0.75);
        QVERIFY(!QFile::exists(folder.filePath("none.csv")));
        fixture.goTo(90);
        QTRY_COMPARE(fixture.panel().series().samples().size(), std::size_t(31));
        for (const char *name : {"a.png", "a.svg", "a.pdf"})
            QVERIFY(exports.savePicture(folder.filePath(name)) &&
                    QFileInfo(folder.filePath(name)).size() > 2000);
        exports.saveNumbers(folder.filePath("a.csv"));
        QCOMPARE(said.count(), 4);
        QFile file(folder.filePath("a.csv"));
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QStringList lines = QString::fromUtf8(file.readAll()).trimmed().split('\n');
        QCOMPARE(lines.size(), 32);
        QCOMPARE(lines[0], QString("\"frame\",\"distance [px]\",\"body\""));
        const sim::State now = fixture.session.timeline().track().stateAt(90);
        const sim::State before = fixture.session.timeline().comparison()->stateAt(90);
        const QStringList last = lines[31].split(',');
        QCOMPARE(last[0].toInt(), 90);
        QCOMPARE(last[1].toDouble(), std::hypot(now.positionOf(0).x - before.positionOf(0).x,
                                                now.positionOf(0).y - before.positionOf(0).y));
        QCOMPARE(last[2], QString("\"foot\""));
    }

    void aPressInThePlotGoesToItsFrame()
    {
        BranchesFixture fixture;
        fixture.window.docks().show(Panel::branches, true);
        fixture.fork(100, 60, 0.75);
        fixture.goTo(90);
        DifferencePlot &plot = fixture.panel().plot();
        QTRY_COMPARE(fixture.panel().series().samples().size(), std::size_t(31));
        plot.replot();
        const QPoint place(qRound(plot.xAxis->coordToPixel(70)), plot.height() / 2);
        QTest::mouseClick(&plot, Qt::LeftButton, {}, place);
        QTRY_COMPARE(fixture.session.timeline().cursor().frame, 70);
        auto *go = fixture.panel().findChildren<QToolButton *>().back();
        QCOMPARE(go->text(), "Go there");
        QTest::mouseClick(go, Qt::LeftButton);
        QTRY_COMPARE(fixture.session.timeline().cursor().frame, 90);
    }
};

SUITE(tst_branches_panel, BranchesPanelTest)
#include "tst_branches_panel.moc"
