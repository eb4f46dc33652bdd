// Other runs in the window, by mouse and keys: the timeline's marks, the menu of runs, and two runs compared.

#include "app/model/same_run.h"
#include "app/ui/branches/branches_panel.h"
#include "app/ui/branches/difference_plot.h"
#include "app/ui/energy/energy_panel.h"
#include "app/ui/plots/plot_export.h"
#include "app/ui/time/name_field.h"
#include "app/ui/time/runs_menu.h"
#include "app/ui/time/timeline_strip.h"
#include "app/ui/time/transport_bar.h"
#include "app/ui/window/main_window.h"
#include "branches_bench.h"
#include "panels_bench.h"
#include "studies.h"

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

namespace {

struct Bench
{
    explicit Bench(QSize size = {1280, 800}) { show(window, size); }

    void fork(std::int64_t end, std::int64_t at, double gravity)
    {
        session().goTo({end, 0});
        session().goTo({at, 0});
        session().setParameter("gravity", gravity);
        session().endGesture();
    }
    Session &session() { return world.session; }
    const std::vector<Branch> &branches() { return session().branches().all(); }
    TimelineStrip &strip() { return *window.findChild<TimelineStrip *>(); }
    /// The mark of a fork, below the track.
    QPoint mark(std::int64_t frame) { return {qRound(strip().axis().xOf(frame)) + 4, 38}; }
    QToolButton *button() { return window.findChild<QToolButton *>("runsButton"); }
    RunsMenu &menu() { return window.findChild<TransportBar *>()->runs(); }
    BranchesPanel &panel() { return *window.findChild<BranchesPanel *>(); }
    QMenu *openMenu() { return qobject_cast<QMenu *>(QApplication::activePopupWidget()); }

    World world{branches_bench::library()};
    MainWindow window{world.session, world.theme, noStudy, noCost};
};

}

class BranchesPanelTest : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase() { prepareProgram(); }

    void cleanup()
    {
        while (QApplication::activePopupWidget())
            QApplication::activePopupWidget()->close();
    }

    void aClickBelowTheTrackTakesTheCursorNowhere()
    {
        Bench bench;
        bench.fork(100, 60, 0.75);
        bench.session().showBeside(0);
        bench.session().goTo({90, 0});
        QVERIFY(bench.strip().hintAt(bench.mark(60)).contains("before: gravity 0.5"));
        QTest::mouseClick(&bench.strip(), Qt::LeftButton, {}, bench.mark(60));
        QCOMPARE(bench.session().beside(), &bench.branches().front());
        QCOMPARE(bench.session().timeline().cursor().frame, 90);
        QVERIFY(bench.session().timeline().comparison());
        QTest::mouseClick(&bench.strip(), Qt::LeftButton, {},
                          {bench.mark(60).x(), 25}); // the track still scrubs
        QTRY_VERIFY(bench.session().timeline().cursor().frame < 70);
    }

    void severalRunsAtOneForkAreChosenFromAMenu()
    {
        Bench bench;
        bench.fork(100, 60, 0.75);
        bench.fork(100, 60, 1.0);
        bench.session().showBeside(0);
        QVERIFY(bench.strip().hintAt(bench.mark(60)).startsWith("2 other runs"));
        QTest::mouseClick(&bench.strip(), Qt::LeftButton, {}, bench.mark(60));
        QTRY_VERIFY(bench.openMenu());
        QCOMPARE(bench.openMenu()->actions().front()->text(), "before: gravity 0.75, parts at frame 60");
        QTest::keyClick(bench.openMenu(), Qt::Key_Down);  // the newest run
        QTest::keyClick(bench.openMenu(), Qt::Key_Right); // its menu: show beside
        QTest::keyClick(bench.openMenu(), Qt::Key_Return);
        QCOMPARE(bench.session().ghostName(), "before: gravity 0.75");
    }

    void theMenuOfRunsIsReachedByKeysAndGoesBack()
    {
        Bench bench;
        QVERIFY(!bench.button()->isEnabled());
        QVERIFY(bench.button()->toolTip().startsWith("Go back in time"));
        QCOMPARE(bench.menu().actions().front()->text(), "No other run yet");
        bench.fork(100, 60, 0.75);
        QVERIFY(bench.button()->isEnabled());
        QVERIFY(bench.button()->accessibleName().startsWith("Other runs"));
        const sim::Script old = *bench.branches().front().script;
        QTest::keyClick(&bench.window, Qt::Key_R, Qt::ControlModifier | Qt::ShiftModifier);
        QTRY_COMPARE(bench.openMenu(), &bench.menu());
        QTest::keyClick(bench.openMenu(), Qt::Key_Down);
        QTest::keyClick(bench.openMenu(), Qt::Key_Right);
        QTest::keyClick(bench.openMenu(), Qt::Key_G); // Go back to it
        QVERIFY(sameScript(bench.session().timeline().script(), old));
        QCOMPARE(bench.branches().size(), std::size_t(1));
        QTest::keyClick(&bench.window, Qt::Key_Z, Qt::ControlModifier);
        QVERIFY(!sameScript(bench.session().timeline().script(), old));
    }

    void aRunIsKeptNamedAndDeletedByMouse()
    {
        Bench bench;
        bench.fork(100, 60, 0.75);
        const int id = bench.branches().front().id;
        const auto choose = [&](const QString &text) {
            const QPoint dots(bench.mark(60).x() + 40, 40);
            QContextMenuEvent ask(QContextMenuEvent::Mouse, dots, bench.strip().mapToGlobal(dots));
            QApplication::sendEvent(&bench.strip(), &ask);
            QMenu *menu = bench.openMenu();
            for (QAction *action : menu->actions()) {
                if (action->text().remove('&') == text) {
                    QTest::mouseClick(menu, Qt::LeftButton, {}, menu->actionGeometry(action).center());
                    return;
                }
            }
            QFAIL(qPrintable(text));
        };
        choose("Keep");
        QVERIFY(bench.branches().front().isKept);
        choose("Rename…");
        auto *field = qobject_cast<NameField *>(QApplication::activePopupWidget());
        QVERIFY(field);
        auto *edit = field->findChild<QLineEdit *>();
        QVERIFY(!edit->accessibleName().isEmpty());
        QTest::keyClicks(edit, "heavy & slow");
        QTest::keyClick(edit, Qt::Key_Return);
        QCOMPARE(bench.session().branches().find(id)->name, "heavy & slow");
        bench.menu().popup({0, 0});
        QCOMPARE(bench.menu().actions().front()->text(), "heavy && slow, parts at frame 60, kept");
        bench.menu().close();
        choose("Delete");
        QVERIFY(bench.branches().empty());
        QTest::keyClick(&bench.window, Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(bench.branches().size(), std::size_t(1));
    }

    void escapeLeavesTheName()
    {
        Bench bench;
        bench.fork(100, 60, 0.75);
        NameField field("as it was", bench.world.theme, &bench.window);
        field.setAttribute(Qt::WA_DeleteOnClose, false);
        QSignalSpy named(&field, &NameField::named);
        field.popupAt({10, 10});
        QTest::keyClicks(field.findChild<QLineEdit *>(), "another");
        QTest::keyClick(field.findChild<QLineEdit *>(), Qt::Key_Escape);
        QVERIFY(!field.isVisible());
        QCOMPARE(named.count(), 0);
    }

    void nothingIsLookedAtBehindAnotherTab()
    {
        Bench bench;
        bench.fork(100, 60, 0.75);
        bench.session().goTo({90, 0});
        bench.window.showBranches(true);
        bench.window.showEnergy(true);
        auto *energy = bench.window.findChild<EnergyPanel *>();
        bench.window.findChild<QDockWidget *>("energy")->raise();
        QTRY_VERIFY(energy->course().last() == 90);
        const std::int64_t looked = bench.panel().course().next();
        bench.session().goTo({100, 0});
        QTRY_VERIFY(energy->course().last() == 100);
        QCOMPARE(bench.panel().course().next(), looked);
        bench.window.showBranches(true); // to the front
        QTRY_VERIFY(bench.panel().course().next() > looked);
        bench.session().frameForward();
        QCoreApplication::processEvents();
        QCOMPARE(energy->course().last(), 100);
    }

    void theFieldForANameStaysOnTheScreen()
    {
        Bench bench;
        NameField field("a run", bench.world.theme, &bench.window);
        field.setAttribute(Qt::WA_DeleteOnClose, false);
        const QRect screen = QGuiApplication::primaryScreen()->availableGeometry();
        field.popupAt(screen.bottomRight());
        QVERIFY2(screen.contains(field.geometry()), qPrintable(QDebug::toString(field.geometry())));
    }

    void escapeGivesUpARunThatIsStillComputed()
    {
        Bench bench;
        bench.fork(100, 60, 0.75);
        const int id = bench.branches().front().id;
        bench.session().showBeside(0);
        bench.session().goTo({400'000, 0});
        QTRY_VERIFY_WITH_TIMEOUT(!bench.session().goingTo(), 60'000);
        bench.session().showBeside(id);
        QVERIFY(bench.session().isBringing());
        QTest::keyClick(&bench.window, Qt::Key_Escape);
        QVERIFY(!bench.session().isBringing());
        QVERIFY(!bench.session().beside());
        QCOMPARE(bench.session().timeline().cursor().frame, 400'000);
        QCOMPARE(bench.branches().size(), std::size_t(1));
    }

    void twoRunsAreComparedInThePanel()
    {
        Bench bench;
        QVERIFY(!bench.panel().isVisible());
        QTest::keyClick(&bench.window, Qt::Key_B, Qt::ControlModifier | Qt::ShiftModifier);
        QVERIFY(bench.panel().isVisible());
        QVERIFY(bench.panel().sentence().startsWith("There is no other run"));
        bench.fork(100, 60, 0.75);
        QVERIFY(bench.panel().sentence().startsWith("No difference up to frame 60"));
        bench.session().goTo({80, 0});
        QTRY_COMPARE(bench.panel().sentence(), "Largest: 53\u2009px apart, foot, at frame 80.");
        QCOMPARE(bench.panel().plot().accessibleDescription(), bench.panel().sentence());
        bench.session().select("body");
        QToolButton *body = nullptr;
        for (QToolButton *one : bench.panel().findChildren<QToolButton *>()) {
            QVERIFY2(!one->toolTip().isEmpty(), qPrintable(one->text()));
            body = one->text() == "body" ? one : body;
        }
        QVERIFY(body);
        QTest::mouseClick(body, Qt::LeftButton);
        QTRY_VERIFY(bench.panel().sentence().startsWith("No difference up to frame 80"));
        QTest::keyClick(&bench.window, Qt::Key_B, Qt::ControlModifier | Qt::ShiftModifier);
        QVERIFY(!bench.panel().isVisible());
    }

    void theDifferenceIsSavedAsPictureAndNumbers()
    {
        Bench bench;
        bench.window.showBranches(true);
        PlotExport &exports = bench.panel().exports();
        QSignalSpy said(&exports, &PlotExport::said);
        QSignalSpy failed(&exports, &PlotExport::failed);
        const QTemporaryDir folder;
        exports.saveNumbers(folder.filePath("none.csv")); // nothing is compared yet
        QCOMPARE(failed.count(), 1);
        bench.fork(100, 60, 0.75);
        QVERIFY(!QFile::exists(folder.filePath("none.csv")));
        bench.session().goTo({90, 0});
        QTRY_COMPARE(bench.panel().course().samples().size(), std::size_t(31));
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
        const sim::State now = bench.session().timeline().track().stateAt(90);
        const sim::State before = bench.session().timeline().comparison()->stateAt(90);
        const QStringList last = lines[31].split(',');
        QCOMPARE(last[0].toInt(), 90);
        QCOMPARE(last[1].toDouble(), std::hypot(now.positionOf(0).x - before.positionOf(0).x,
                                                now.positionOf(0).y - before.positionOf(0).y));
        QCOMPARE(last[2], QString("\"foot\""));
    }

    void aPressInThePlotGoesToItsFrame()
    {
        Bench bench;
        bench.window.showBranches(true);
        bench.fork(100, 60, 0.75);
        bench.session().goTo({90, 0});
        DifferencePlot &plot = bench.panel().plot();
        QTRY_COMPARE(bench.panel().course().samples().size(), std::size_t(31));
        plot.replot();
        const QPoint place(qRound(plot.xAxis->coordToPixel(70)), plot.height() / 2);
        QTest::mouseClick(&plot, Qt::LeftButton, {}, place);
        QTRY_COMPARE(bench.session().timeline().cursor().frame, 70);
        auto *go = bench.panel().findChildren<QToolButton *>().back();
        QCOMPARE(go->text(), "Go there");
        QTest::mouseClick(go, Qt::LeftButton);
        QTRY_COMPARE(bench.session().timeline().cursor().frame, 90);
    }
};

QTEST_MAIN(BranchesPanelTest)
#include "tst_branches_panel.moc"
