// Where the last start left off: the step that was open, and all of the scene where a choice needs a new start.

#include "window_bench.h"

#include "app/model/scene_keeper.h"

#include <QTemporaryDir>

using namespace app;
using window_bench::Bench;

namespace {

constexpr int soon = 50; ///< ms

/// The entry of View > Size of text and controls for so many percent.
QAction *sizeOf(MainWindow &window, int percent)
{
    for (QAction *action : window.findChildren<QAction *>()) {
        if (action->text() == QString("%1\u2009%").arg(percent))
            return action;
    }
    return nullptr;
}

}

class StartAgainTest : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase() { window_bench::keepSettingsIn(m_settings.path()); }
    void cleanup() { QSettings().clear(); }

    void theStepThatWasOpenLastIsOpenAgain()
    {
        {
            Bench bench("two_body", "mutual");
            QCOMPARE(bench.session.step().id, QString("mutual"));
        }
        const QString lesson = QSettings().value("learn/lesson").toString();
        const QString step = QSettings().value("learn/step").toString();
        Bench next; // opens a step of its own
        QSettings().setValue("learn/lesson", lesson);
        QSettings().setValue("learn/step", step);
        next.window.openLast();
        QCOMPARE(next.session.lesson().id, QString("two_body"));
        QCOMPARE(next.session.step().id, QString("mutual"));
    }

    void aStepThatIsGoneOrWasNeverThereIsNotMissed_data()
    {
        QTest::addColumn<QString>("lesson");
        QTest::addColumn<QString>("step");
        QTest::newRow("first start") << ""
                                     << "";
        QTest::newRow("no such lesson") << "three_body"
                                        << "mutual";
        QTest::newRow("no such step") << "two_body"
                                      << "nutual";
    }
    void aStepThatIsGoneOrWasNeverThereIsNotMissed()
    {
        QFETCH(QString, lesson);
        QFETCH(QString, step);
        Bench bench;
        QSettings().setValue("learn/lesson", lesson);
        QSettings().setValue("learn/step", step);
        bench.window.openLast();
        QCOMPARE(bench.session.step().id, QString("fixed_centre"));
    }

    void theSandboxIsNoStepOfALesson()
    {
        Bench bench("two_body", "mutual");
        bench.window.setMode(MainWindow::Mode::build);
        QCOMPARE(bench.session.lesson().id, QString("sandbox"));
        bench.window.openLast();
        QCOMPARE(bench.session.step().id, QString("mutual"));
    }

    void anotherSizeOffersANewStartThatKeepsTheScene_data()
    {
        QTest::addColumn<QString>("lesson");
        QTest::addColumn<QString>("step");
        QTest::addColumn<int>("mode");
        QTest::newRow("a lesson") << "two_body"
                                  << "mutual" << int(MainWindow::Mode::learn);
        QTest::newRow("measuring") << "gravity_walls"
                                   << "gravity" << int(MainWindow::Mode::measure);
        QTest::newRow("building") << "sandbox"
                                  << "build" << int(MainWindow::Mode::build);
    }
    void anotherSizeOffersANewStartThatKeepsTheScene()
    {
        QFETCH(QString, lesson);
        QFETCH(QString, step);
        QFETCH(int, mode);
        const QTemporaryDir folder;
        std::optional<Left> left;
        std::optional<sim::State> state;
        double damp = 0.0;
        {
            Bench bench(qPrintable(lesson), qPrintable(step));
            bench.window.setMode(MainWindow::Mode(mode));
            bench.window.keepScenesIn(folder.path(), soon);
            bench.session.goTo({30, 0});
            bench.session.setParameter("damp", 0.7);
            bench.session.goTo({70, 0});
            bench.session.goTo({40, 0});
            damp = bench.session.parameter("damp");
            QAction *size = sizeOf(bench.window, 125);
            QVERIFY(size);
            size->trigger();
            QVERIFY(bench.notice.sentence().contains("125"));
            state = bench.session.timeline().now();
            QVERIFY(bench.answer("Start again now"));
            QVERIFY(!bench.window.isVisible());
            left = bench.window.left();
            QVERIFY(left);
        }
        Bench next;
        next.window.goOn(*left);
        next.window.keepScenesIn(folder.path(), soon);
        QCOMPARE(next.session.lesson().id, lesson);
        QCOMPARE(next.session.step().id, step);
        QCOMPARE(int(next.window.mode()), mode);
        QCOMPARE(next.session.timeline().at().frame, 40);
        QVERIFY(sim::sameBits(next.session.timeline().now(), *state));
        QCOMPARE(next.session.parameter("damp"), damp);
        QVERIFY2(next.notice.sentence().isEmpty(), qPrintable(next.notice.sentence()));
        QVERIFY(next.isMarked());
    }

    void whatTheHandDidBeforeTheNextFrameIsStillSeen()
    {
        const QTemporaryDir folder;
        std::optional<Left> left;
        sim::Vec2 place;
        const auto placeIn = [](Session &session) { return session.picture().state.at(0); };
        {
            Bench bench;
            bench.window.keepScenesIn(folder.path(), soon);
            const sim::Vec2 before = placeIn(bench.session);
            bench.drag("foot", {-60, 40});
            place = placeIn(bench.session);
            QVERIFY(place != before);
            QCOMPARE(bench.session.timeline().at().frame, 0);
            bench.window.startAgain();
            left = bench.window.left();
            QVERIFY(left);
        }
        Bench next;
        next.window.goOn(*left);
        next.window.keepScenesIn(folder.path(), soon);
        QCOMPARE(next.session.timeline().at().frame, 0);
        QVERIFY(placeIn(next.session) == place);
    }

    void aSavedFileIsOpenAgain()
    {
        const QTemporaryDir folder;
        const QString file = folder.path() + "/mine.json";
        std::optional<Left> left;
        {
            Bench bench("two_body", "mutual");
            bench.session.setParameter("k", 0.15);
            bench.session.goTo({25, 0});
            QVERIFY(bench.window.saveFile(file));
            bench.window.startAgain();
            left = bench.window.left();
            QVERIFY(left);
        }
        Bench next;
        next.window.goOn(*left);
        next.window.keepScenesIn(folder.path() + "/scenes", soon);
        QCOMPARE(next.session.step().id, QString("mutual"));
        QCOMPARE(next.session.parameter("k"), 0.15);
        QCOMPARE(next.session.timeline().at().frame, 25);
        QVERIFY(next.window.windowTitle().contains("mine"));
        QVERIFY(!next.isMarked());
    }

    void aWindowThatIsOnlyClosedDoesNotComeBack()
    {
        Bench bench;
        bench.window.close();
        QVERIFY(!bench.window.left());
    }

private:
    QTemporaryDir m_settings;
};

QTEST_MAIN(StartAgainTest)
#include "tst_start_again.moc"
