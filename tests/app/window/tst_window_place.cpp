// The position and the contents of a window that opens again in another size or language. Each window has its own
// application, as in the program, because Qt reads the size only when an application starts.

#include "app/ui/dialogs/dialog_place.h"
#include "app/ui/dialogs/window_place.h"
#include "app/ui/film/film_dialog.h"
#include "app/ui/help/about_page.h"
#include "app/ui/map/map_page.h"
#include "app/ui/settings/size_menu.h"
#include "app/ui/window/gui.h"
#include "app/ui/window/restart.h"
#include "tests/app/support/window_fixture.h"
#include "tests/suite.h"

#include <QLabel>
#include <QScopeGuard>
#include <QScreen>
#include <QSettings>
#include <QTimer>

using namespace app;
using namespace tests;

namespace {

/// An application at the size that is kept, as the program starts it.
struct Start
{
    Start()
    {
        qputenv("QT_SCALE_FACTOR", QByteArray::number(storedSize() / 100.0));
        application.emplace(count, arguments);
    }
    ~Start() { qunsetenv("QT_SCALE_FACTOR"); }

    int count = 1;
    char name[17] = "tst_window_place";
    char *arguments[2] = {name, nullptr};
    std::optional<QApplication> application;
};

/// In px of the screen.
QRect onScreen(const QWidget &window)
{
    const double ratio = window.screen()->devicePixelRatio();
    const QRect place = window.geometry();
    return QRect(qRound(place.x() * ratio), qRound(place.y() * ratio), qRound(place.width() * ratio),
                 qRound(place.height() * ratio));
}

/// The program: windows on one session, each with an application of its own.
struct Program
{
    using Actions = std::function<void(MainWindow &, Session &)>;

    /// Opens a window like the program, performs the actions and closes it, so that the next window continues.
    void run(const Actions &actions)
    {
        QSettings().setValue("tour/seen", true);
        Start start;
        QTimer::singleShot(0, [&] {
            MainWindow *window = nullptr;
            for (QWidget *one : QApplication::topLevelWidgets())
                window = qobject_cast<MainWindow *>(one) ? static_cast<MainWindow *>(one) : window;
            QVERIFY(window && QTest::qWaitForWindowExposed(window));
            actions(*window, *work.session);
            if (window->isVisible())
                window->restart().start();
        });
        left = runWindow(*start.application, work, {}, left).handover;
        QVERIFY(left);
    }

    Work work;
    std::optional<Handover> left;
};

/// Notes whether the map of concepts was there when a window was painted for the first time.
class FirstPaint : public QObject
{
public:
    bool eventFilter(QObject *receiver, QEvent *event) override
    {
        if (event->type() == QEvent::Paint && qobject_cast<MainWindow *>(receiver) && !window) {
            window = static_cast<MainWindow *>(receiver);
            hadMap = window->findChild<MapPage *>();
        }
        return false;
    }

    MainWindow *window = nullptr; ///< null until it is painted
    bool hadMap = false;
};

QAction *actionCalled(const MainWindow &window, const QString &text)
{
    for (QAction *one : window.findChildren<QAction *>()) {
        if (one->text() == text)
            return one;
    }
    return nullptr;
}

void choose(const MainWindow &window, const QString &text)
{
    QAction *action = actionCalled(window, text);
    QVERIFY2(action, qPrintable(text));
    action->trigger();
}

}

class WindowPlaceTest : public QObject
{
    Q_OBJECT

private slots:
    void init() { QSettings().clear(); }

    void aWindowIsInsideTheScreenWithItsFrame_data()
    {
        QTest::addColumn<QRect>("wanted");
        QTest::addColumn<QRect>("expected");
        const auto row = [](const char *name, QRect wanted, QRect expected) {
            QTest::newRow(name) << wanted << expected;
        };
        // The screen is 1000 x 800; the frame is 20 px high above, 1 px wide elsewhere.
        row("fits", {100, 100, 500, 400}, {100, 100, 500, 400});
        row("too far right and down", {900, 700, 500, 400}, {499, 399, 500, 400});
        row("its title above the screen", {0, 0, 500, 400}, {1, 20, 500, 400});
        row("left of the screen", {-3000, 100, 500, 400}, {1, 100, 500, 400});
        row("larger than the screen", {50, 50, 2000, 2000}, {1, 20, 998, 779});
    }
    void aWindowIsInsideTheScreenWithItsFrame()
    {
        QFETCH(const QRect, wanted);
        QFETCH(const QRect, expected);
        QCOMPARE(insideScreen(wanted, {1, 20, 1, 1}, {0, 0, 1000, 800}), expected);
    }

    void windowKeepsItsPositionOverTenSizes_data()
    {
        QTest::addColumn<QSize>("least"); // px at 100 %
        QTest::newRow("as large as it was") << QSize(100, 100);
        QTest::newRow("larger where its contents need it") << QSize(360, 300);
    }
    void windowKeepsItsPositionOverTenSizes()
    {
        QFETCH(const QSize, least);
        const QRect first(61, 53, 601, 403);
        for (const int size : {100, 125, 150, 175, 200, 100, 200, 125, 175, 150, 100}) {
            QSettings().setValue("window/size", size);
            const Start start;
            QWidget window;
            window.setMinimumSize(least);
            WindowPlace place(window);
            if (!place.restore())
                window.setGeometry(first);
            window.show();
            QVERIFY(QTest::qWaitForWindowExposed(&window));
            QVERIFY2(window.screen()->availableGeometry().contains(window.geometry()),
                     qPrintable(QString::number(size)));
            if (size == 100)
                QCOMPARE(onScreen(window), first);
            place.keep();
        }
    }

    void aWindowThatIsMovedStaysWhereItIsPut()
    {
        for (const bool moves : {true, false}) {
            const Start start;
            QWidget window;
            WindowPlace place(window);
            if (!place.restore())
                window.setGeometry(60, 50, 500, 400);
            window.show();
            QVERIFY(QTest::qWaitForWindowExposed(&window));
            if (moves)
                window.setGeometry(160, 150, 450, 350);
            QCOMPARE(window.geometry(), QRect(160, 150, 450, 350));
            place.keep();
        }
    }

    void anotherSizeKeepsAllThatIsOpenTenTimes()
    {
        Program program;
        sim::State state;
        QRect place;
        std::int64_t computed = 0;
        program.run([&](MainWindow &window, Session &session) {
            session.openStep("two_body", "mutual");
            session.playback().goTo({30, 0});
            session.editor().setParameter("damp", 0.7);
            session.editor().setParameter("k", 0.15);
            session.playback().goTo({70, 0});
            session.editor().undo();
            session.playback().goTo({40, 2});
            state = session.timeline().state();
            computed = session.timeline().computed();
            window.setGeometry(40, 40, 700, 600);
            QTRY_COMPARE(window.size(), QSize(700, 600));
            place = onScreen(window);
            choose(window, "125\u2009%"); // at once, without a question
            QVERIFY(!window.isVisible());
        });
        for (int i = 1; i <= 10; ++i) {
            program.run([&](MainWindow &window, Session &session) {
                QVERIFY(window.findChild<Notice *>()->sentence().isEmpty());
                QCOMPARE(window.screen()->devicePixelRatio(), i % 2 ? 1.25 : 1.0);
                QCOMPARE(session.step().id, QString("mutual"));
                QCOMPARE(session.timeline().cursor(), (sim::Cursor{40, 2}));
                QCOMPARE(session.timeline().computed(), computed);
                QVERIFY(sim::sameBits(session.timeline().state(), state));
                QVERIFY(window.isWindowModified());
                if (i % 2 == 0)
                    QCOMPARE(onScreen(window), place);
                QTest::keyClick(&window, Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
                QCOMPARE(session.editor().parameter("k"), 0.15);
                QTest::keyClick(&window, Qt::Key_Z, Qt::ControlModifier);
                QTest::keyClick(&window, Qt::Key_Z, Qt::ControlModifier);
                QCOMPARE(session.editor().parameter("damp"), session.step().parameter("damp")->defaultValue);
                session.editor().redo();
                QCOMPARE(session.editor().parameter("damp"), 0.7);
                session.playback().goTo({40, 2});
                computed = session.timeline().computed();
                choose(window, i % 2 ? "100\u2009%" : "125\u2009%");
            });
        }
    }

    void anotherLanguageKeepsAllThatIsOpen()
    {
        Program program;
        program.run([&](MainWindow &window, Session &session) {
            session.openStep("two_body", "mutual");
            QCOMPARE(session.step().title, QString("Each pulls the other"));
            session.editor().setParameter("k", 0.15);
            session.playback().goTo({40, 0});
            choose(window, "Deutsch");
        });
        program.run([&](MainWindow &window, Session &session) {
            QCOMPARE(session.step().id, QString("mutual"));
            QVERIFY(session.step().title != "Each pulls the other");
            QVERIFY(window.windowTitle().contains(session.step().title));
            QCOMPARE(session.editor().parameter("k"), 0.15);
            QCOMPARE(session.timeline().cursor().frame, 40);
            session.editor().undo();
            QVERIFY(session.editor().parameter("k") != 0.15);
            session.playback().play();
            choose(window, "English");
        });
        program.run([&](MainWindow &, Session &session) {
            QCOMPARE(session.step().title, QString("Each pulls the other"));
            QVERIFY(session.playback().isPlaying());
            const std::int64_t from = session.timeline().cursor().frame;
            QTRY_VERIFY(session.timeline().cursor().frame > from + 3);
        });
    }

    void theSandboxStaysOpenAndLeadsBackToItsStep()
    {
        Program program;
        program.run([&](MainWindow &window, Session &session) {
            session.openStep("two_body", "mutual");
            window.setMode(MainWindow::Mode::build);
            QVERIFY(session.isSandbox());
            session.playback().goTo({12, 0});
            choose(window, "150\u2009%");
        });
        program.run([&](MainWindow &window, Session &session) {
            QVERIFY(session.isSandbox());
            QCOMPARE(int(window.mode()), int(MainWindow::Mode::build));
            QCOMPARE(session.timeline().cursor().frame, 12);
            window.setMode(MainWindow::Mode::learn);
            QCOMPARE(session.step().id, QString("mutual"));
        });
    }

    void theMapOpensAfterTheFirstFrame()
    {
        QSettings().setValue("tour/seen", true);
        Start start;
        FirstPaint first;
        start.application->installEventFilter(&first);
        QTimer::singleShot(0, [&] {
            const auto quit = qScopeGuard([] { QApplication::quit(); });
            QTRY_VERIFY(first.window && first.window->findChild<MapPage *>());
            QVERIFY(first.window->findChild<MapPage *>()->isVisible());
            QVERIFY(!first.hadMap);
        });
        Work work;
        QCOMPARE(runWindow(*start.application, work, {}).code, 0);
        QVERIFY(first.window);
    }

    void aDialogIsOverTheMiddleOfItsWindowEachTime()
    {
        Start start;
        QWidget window;
        window.setGeometry(100, 100, 600, 500);
        window.show();
        QVERIFY(QTest::qWaitForWindowExposed(&window));
        QDialog dialog(&window);
        dialog.resize(301, 201);
        for (int i = 0; i < 5; ++i) {
            placeOverParent(dialog);
            dialog.show();
            QVERIFY(QTest::qWaitForWindowExposed(&dialog));
            QCOMPARE(dialog.geometry().center(), window.geometry().center());
            QCOMPARE(dialog.size(), QSize(301, 201));
            dialog.close();
        }
        window.move(600, 600); // partly off the screen of 800 x 800
        placeOverParent(dialog);
        QVERIFY(window.screen()->availableGeometry().contains(dialog.geometry()));
    }

    void filmDialogOpensAtTheSamePositionEachTime()
    {
        const Start start;
        WindowFixture fixture;
        QAction &film = fixture.actionCalled("Film of the run…");
        QRect first;
        for (int i = 0; i < 5; ++i) {
            film.trigger();
            auto *dialog = fixture.window.findChild<FilmDialog *>();
            QVERIFY(dialog && QTest::qWaitForWindowExposed(dialog));
            if (i == 0)
                first = dialog->geometry();
            QCOMPARE(dialog->geometry(), first);
            QTest::keyClick(dialog, Qt::Key_Escape);
            QVERIFY(!dialog->isVisible());
        }
    }

    void aboutTellsVersionLicenceAndWhatItIsBuiltWith()
    {
        const Start start;
        QCoreApplication::setApplicationVersion("1.2.3");
        WindowFixture fixture;
        fixture.actionCalled("About Springstep").trigger();
        auto *page = fixture.window.findChild<AboutPage *>();
        QVERIFY(page && QTest::qWaitForWindowExposed(page));
        QString all;
        for (const QLabel *label : page->findChildren<QLabel *>()) {
            all += label->text() + '\n';
            QVERIFY2(label->height() >= label->heightForWidth(label->width()), qPrintable(label->text()));
        }
        for (const char *text :
             {"1.2.3", "GNU General Public License", "without any warranty", qVersion(), "QCustomPlot",
              "QScintilla", "Eigen", "RapidJSON", "giflib", "zlib", "Inter", "Hack"})
            QVERIFY2(all.contains(text), text);
        QTest::keyClick(page, Qt::Key_Escape);
        QVERIFY(!page->isVisible());
    }
};

SUITE_WITHOUT_APPLICATION(tst_window_place, WindowPlaceTest)
#include "tst_window_place.moc"
