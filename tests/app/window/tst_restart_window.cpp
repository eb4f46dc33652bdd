// A restart restores the open step. If a choice needs a restart, the whole scene is restored as well.

#include "tests/app/support/panel_fixture.h"
#include "tests/app/support/window_fixture.h"

#include "app/model/files/autosave.h"
#include "app/ui/film/film_dialog.h"
#include "app/ui/film/film_name.h"
#include "app/ui/window/last_step.h"
#include "app/ui/window/restart.h"
#include "tests/suite.h"

#include <QDir>
#include <QLineEdit>
#include <QSettings>
#include <QTemporaryDir>

using namespace app;
using namespace tests;

namespace {

constexpr int autosaveDelay = 50; ///< ms

/// Returns the entry of View > Size of text and controls for so many percent.
QAction *sizeOf(MainWindow &window, int percent)
{
    for (QAction *action : window.findChildren<QAction *>()) {
        if (action->text() == QString("%1\u2009%").arg(percent))
            return action;
    }
    return nullptr;
}

/// A session that is shown in one window after the other, as after a choice that needs a new start.
struct RestartFixture : SessionFixture
{
    RestartFixture() : SessionFixture(LessonLibrary::load({LESSON_DIR})) {}
    void open()
    {
        window.reset();
        window.emplace(session, theme);
        show(*window, {1280, 800});
    }
    QString sentence() const { return window->findChild<Notice *>()->sentence(); }

    std::optional<MainWindow> window;
};

}

class StartAgainTest : public QObject
{
    Q_OBJECT

private slots:
    void cleanup() { QSettings().clear(); }

    void theStepThatWasOpenLastIsOpenAgain()
    {
        {
            WindowFixture fixture({"two_body", "mutual"});
            QCOMPARE(fixture.session.step().id, QString("mutual"));
        }
        const QString lesson = QSettings().value("learn/lesson").toString();
        const QString step = QSettings().value("learn/step").toString();
        WindowFixture next; // opens a step of its own
        QSettings().setValue("learn/lesson", lesson);
        QSettings().setValue("learn/step", step);
        LastStep::load().openIn(next.session);
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
        WindowFixture fixture;
        QSettings().setValue("learn/lesson", lesson);
        QSettings().setValue("learn/step", step);
        LastStep::load().openIn(fixture.session);
        QCOMPARE(fixture.session.step().id, QString("fixed_centre"));
    }

    void theSandboxIsNoStepOfALesson()
    {
        WindowFixture fixture({"two_body", "mutual"});
        fixture.window.setMode(MainWindow::Mode::build);
        QCOMPARE(fixture.session.lesson().id, QString("sandbox"));
        LastStep::load().openIn(fixture.session);
        QCOMPARE(fixture.session.step().id, QString("mutual"));
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
        RestartFixture restart;
        Session &session = restart.session;
        session.openStep(lesson, step);
        restart.open();
        restart.window->setMode(MainWindow::Mode(mode));
        restart.window->autosaveIn(folder.path(), autosaveDelay);
        session.playback().goTo({30, 0});
        session.editor().setParameter("damp", 0.7);
        session.playback().goTo({70, 0});
        session.playback().goTo({40, 0});
        const double damp = session.editor().parameter("damp");
        QAction *size = sizeOf(*restart.window, 125);
        QVERIFY(size);
        const sim::State state = session.timeline().state();
        size->trigger(); // nothing is asked: nothing is lost
        QVERIFY(!restart.window->isVisible());
        const std::optional<Handover> left = restart.window->restart().handover();
        QVERIFY(left);
        restart.open();
        restart.window->restart().continueFrom(*left);
        restart.window->autosaveIn(folder.path(), autosaveDelay);
        QCOMPARE(session.lesson().id, lesson);
        QCOMPARE(session.step().id, step);
        QCOMPARE(int(restart.window->mode()), mode);
        QCOMPARE(session.timeline().cursor().frame, 40);
        QCOMPARE(session.timeline().computed(), 70);
        QVERIFY(sim::sameBits(session.timeline().state(), state));
        QCOMPARE(session.editor().parameter("damp"), damp);
        QVERIFY2(restart.sentence().isEmpty(),
                 qPrintable(restart.sentence())); // the run that is open is not offered
        QVERIFY(restart.window->isWindowModified());
        // The scene is autosaved again.
        const std::vector<RecoveredScene> kept = recoveredScenes(folder.path());
        QVERIFY(kept.empty()); // none without a program that runs
        QCOMPARE(QDir(folder.path()).entryList(QDir::Dirs | QDir::NoDotAndDotDot).size(), 1);
    }

    void aDragBeforeTheNextFrameIsStillSeen()
    {
        RestartFixture restart;
        restart.open();
        const auto place = [&] { return restart.session.presentation().picture().state.positionOf(0); };
        const sim::Vec2 before = place();
        restart.session.input().grab("foot");
        restart.session.input().moveTo({before.x - 60.0, before.y + 40.0});
        const sim::Vec2 moved = place();
        QVERIFY(moved != before);
        restart.window->restart().start();
        QVERIFY(!restart.session.input().isHolding());
        const std::optional<Handover> left = restart.window->restart().handover();
        restart.open();
        restart.window->restart().continueFrom(*left);
        QCOMPARE(restart.session.timeline().cursor().frame, 0);
        QVERIFY(place() == moved);
    }

    void aSavedFileStaysTheFileOfItsStep()
    {
        const QTemporaryDir folder;
        RestartFixture restart;
        restart.session.openStep("two_body", "mutual");
        restart.open();
        restart.session.editor().setParameter("k", 0.15);
        restart.session.playback().goTo({25, 0});
        QVERIFY(restart.window->saveFile(folder.path() + "/mine.json"));
        restart.session.openStep("single_spring", "offset"); // and back later
        restart.window->restart().start();
        const std::optional<Handover> left = restart.window->restart().handover();
        restart.open();
        restart.window->restart().continueFrom(*left);
        restart.session.openStep("two_body", "mutual");
        QCOMPARE(restart.session.editor().parameter("k"), 0.15);
        QVERIFY(restart.window->windowTitle().contains("mine"));
        QVERIFY(!restart.window->isWindowModified());
    }

    void aFilmThatIsBeingMadeIsNotStoppedUnasked()
    {
        const QTemporaryDir folder;
        WindowFixture fixture;
        fixture.goTo(30);
        fixture.actionCalled("Film of the run…").trigger();
        auto *film = fixture.window.findChild<FilmDialog *>();
        QVERIFY(film);
        film->findChild<FilmName *>()->field().setText(folder.path() + "/run.gif");
        for (QPushButton *button : film->findChildren<QPushButton *>()) {
            if (button->isDefault())
                QTest::mouseClick(button, Qt::LeftButton);
        }
        QVERIFY2(film->isMaking(), qPrintable(film->message()));
        sizeOf(fixture.window, 125)->trigger();
        QVERIFY(fixture.window.isVisible() && film->isMaking());
        QVERIFY(fixture.notice.sentence().contains("125"));
        QVERIFY(fixture.answer("Restart now"));
        QVERIFY(fixture.window.restart().handover());
    }

    void aWindowThatIsOnlyClosedDoesNotComeBack()
    {
        WindowFixture fixture;
        fixture.window.close();
        QVERIFY(!fixture.window.restart().handover());
    }
};

SUITE(tst_restart_window, StartAgainTest)
#include "tst_restart_window.moc"
