// Where the last start left off: the step that was open, and all of the scene where a choice needs a new start.

#include "window_bench.h"

#include "app/model/scene_keeper.h"
#include "app/ui/film/film_dialog.h"
#include "app/ui/film/film_name.h"

#include <QDir>
#include <QLineEdit>
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

/// A session on which one window opens after the other.
struct Desk
{
    void open()
    {
        window.reset();
        window.emplace(session, theme);
        window->resize(1280, 800);
        window->show();
        QCoreApplication::processEvents();
    }
    QString sentence() const { return window->findChild<Notice *>()->sentence(); }

    LessonLibrary library = LessonLibrary::load({LESSON_DIR});
    Theme theme{Scheme::light};
    Session session{library};
    std::optional<MainWindow> window;
};

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

    void anotherSizeKeepsTheSceneAndWhatIsNotSaved_data()
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
    void anotherSizeKeepsTheSceneAndWhatIsNotSaved()
    {
        QFETCH(QString, lesson);
        QFETCH(QString, step);
        QFETCH(int, mode);
        const QTemporaryDir folder;
        Desk desk;
        Session &session = desk.session;
        session.openStep(lesson, step);
        desk.open();
        desk.window->setMode(MainWindow::Mode(mode));
        desk.window->keepScenesIn(folder.path(), soon);
        session.goTo({30, 0});
        session.setParameter("damp", 0.7);
        session.goTo({70, 0});
        session.goTo({40, 0});
        const double damp = session.parameter("damp");
        QAction *size = sizeOf(*desk.window, 125);
        QVERIFY(size);
        const sim::State state = session.timeline().state();
        size->trigger(); // nothing is asked: nothing is lost
        QVERIFY(!desk.window->isVisible());
        const std::optional<Left> left = desk.window->left();
        QVERIFY(left);
        desk.open();
        desk.window->goOn(*left);
        desk.window->keepScenesIn(folder.path(), soon);
        QCOMPARE(session.lesson().id, lesson);
        QCOMPARE(session.step().id, step);
        QCOMPARE(int(desk.window->mode()), mode);
        QCOMPARE(session.timeline().cursor().frame, 40);
        QCOMPARE(session.timeline().computed(), 70);
        QVERIFY(sim::sameBits(session.timeline().state(), state));
        QCOMPARE(session.parameter("damp"), damp);
        QVERIFY2(desk.sentence().isEmpty(),
                 qPrintable(desk.sentence())); // the run that is open is not offered
        QVERIFY(desk.window->isWindowModified());
        // It is kept against a crash again.
        const std::vector<KeptScene> kept = keptScenes(folder.path());
        QVERIFY(kept.empty()); // none without a program that runs
        QCOMPARE(QDir(folder.path()).entryList(QDir::Dirs | QDir::NoDotAndDotDot).size(), 1);
    }

    void whatTheHandDidBeforeTheNextFrameIsStillSeen()
    {
        Desk desk;
        desk.open();
        const auto place = [&] { return desk.session.picture().state.positionOf(0); };
        const sim::Vec2 before = place();
        desk.session.grab("foot");
        desk.session.moveHand({before.x - 60.0, before.y + 40.0});
        const sim::Vec2 moved = place();
        QVERIFY(moved != before);
        desk.window->startAgain();
        QVERIFY(!desk.session.isHolding());
        const std::optional<Left> left = desk.window->left();
        desk.open();
        desk.window->goOn(*left);
        QCOMPARE(desk.session.timeline().cursor().frame, 0);
        QVERIFY(place() == moved);
    }

    void aSavedFileStaysTheFileOfItsStep()
    {
        const QTemporaryDir folder;
        Desk desk;
        desk.session.openStep("two_body", "mutual");
        desk.open();
        desk.session.setParameter("k", 0.15);
        desk.session.goTo({25, 0});
        QVERIFY(desk.window->saveFile(folder.path() + "/mine.json"));
        desk.session.openStep("single_spring", "offset"); // and back later
        desk.window->startAgain();
        const std::optional<Left> left = desk.window->left();
        desk.open();
        desk.window->goOn(*left);
        desk.session.openStep("two_body", "mutual");
        QCOMPARE(desk.session.parameter("k"), 0.15);
        QVERIFY(desk.window->windowTitle().contains("mine"));
        QVERIFY(!desk.window->isWindowModified());
    }

    void aFilmThatIsBeingMadeIsNotStoppedUnasked()
    {
        const QTemporaryDir folder;
        Bench bench;
        bench.session.goTo({30, 0});
        for (QAction *one : bench.window.findChildren<QAction *>()) {
            if (one->text() == "&Film of the run…")
                one->trigger();
        }
        auto *film = bench.window.findChild<FilmDialog *>();
        QVERIFY(film);
        film->findChild<FilmName *>()->field().setText(folder.path() + "/run.gif");
        for (QPushButton *button : film->findChildren<QPushButton *>()) {
            if (button->isDefault())
                QTest::mouseClick(button, Qt::LeftButton);
        }
        QVERIFY2(film->isMaking(), qPrintable(film->said()));
        sizeOf(bench.window, 125)->trigger();
        QVERIFY(bench.window.isVisible() && film->isMaking());
        QVERIFY(bench.notice.sentence().contains("125"));
        QVERIFY(bench.answer("Start again now"));
        QVERIFY(bench.window.left());
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
