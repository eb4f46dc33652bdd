// The room that the window asks for: all panels go into a small screen, and what does not fit in less steps aside.

#include "app/ui/panels/learn_panel.h"
#include "app/ui/panels/lesson_list.h"
#include "app/ui/panels/narration.h"
#include "app/ui/panels/narration_text.h"
#include "app/ui/scene/scene_view.h"
#include "app/ui/window/main_window.h"
#include "panels_bench.h"
#include "studies.h"

#include <QAccessible>
#include <QAction>
#include <QDockWidget>
#include <QHelpEvent>
#include <QLabel>
#include <QLayout>
#include <QScrollArea>
#include <QSettings>
#include <QToolButton>
#include <QToolTip>
#include <QtTest>

using namespace app;

namespace {

struct Bench
{
    explicit Bench(QSize size, const char *lesson = "gravity_walls", const char *step = "gravity")
    {
        session.openStep(lesson, step);
        show(window, size);
    }
    QDockWidget &dock(const char *name) { return *window.findChild<QDockWidget *>(name); }
    QAction &action(const char *name) { return *window.findChild<QAction *>(name); }
    bool isRail() const { return window.findChild<LearnPanel *>()->form() == LearnPanel::Form::rail; }
    /// As a window manager does that asks nobody.
    void force(QSize size)
    {
        window.setMinimumSize(1, 1);
        window.resize(size);
        QTest::qWait(20);
    }
    void openAll()
    {
        for (const char *name : {"showEnergy", "showEffects", "showPlots", "showBranches"}) {
            if (!action(name).isChecked())
                action(name).trigger();
        }
        QTest::qWait(20);
    }
    /// Drags the line between two panels.
    void dragSeparator(QPoint from, QPoint by)
    {
        QTest::mousePress(&window, Qt::LeftButton, {}, from);
        QMouseEvent move(QEvent::MouseMove, from + by, window.mapToGlobal(from + by), Qt::NoButton,
                         Qt::LeftButton, {});
        QApplication::sendEvent(&window, &move);
        QTest::qWait(50); // the main window moves its separators by a timer
        QTest::mouseRelease(&window, Qt::LeftButton, {}, from + by);
    }
    /// px between the title of the step and its text.
    int gapUnderTitle()
    {
        auto *text = window.findChild<Narration *>()->findChild<NarrationText *>();
        auto *title = window.findChild<Narration *>()->findChild<QLabel *>("stepTitle");
        return text->y() - title->geometry().bottom() - 1;
    }
    /// Where everything stands that the size of the window moves.
    QString places() const
    {
        QStringList all;
        const auto add = [&](const QString &name, const QWidget &widget) {
            const QRect place(widget.mapTo(&window, QPoint()), widget.size());
            all << QString("%1 %2,%3 %4x%5")
                       .arg(name)
                       .arg(place.x())
                       .arg(place.y())
                       .arg(place.width())
                       .arg(place.height());
        };
        for (const QDockWidget *one : window.findChildren<QDockWidget *>()) {
            if (one->isVisible() && !one->visibleRegion().isEmpty())
                add(one->objectName(), *one);
        }
        add("centre", *window.centralWidget());
        add("list", *window.findChild<LessonList *>());
        if (!isRail())
            add("text", *window.findChild<Narration *>()->findChild<NarrationText *>());
        all.sort();
        return all.join(" | ");
    }
    QString shown() const
    {
        QStringList names;
        for (const QDockWidget *one : window.findChildren<QDockWidget *>()) {
            if (!one->isHidden())
                names << one->objectName();
        }
        names.sort();
        return names.join(' ');
    }

    World world{LessonLibrary::load({LESSON_DIR})};
    MainWindow window{world.session, world.theme, noStudy, noCost};
    Session &session = world.session;
};

/// Logical px of windows: screens of 1024 x 768 to 2560 x 1440 px at 100, 150 and 200 %.
constexpr QSize sizes[] = {{1280, 800},  {1024, 768}, {1280, 720}, {1600, 900}, {1920, 1080},
                           {2560, 1440}, {1707, 960}, {1067, 600}, {960, 540},  {800, 600}};

QString nameOf(QSize size)
{
    return QString("%1 x %2").arg(size.width()).arg(size.height());
}

/// The panels that are seen, and the scene's part: none of them may lie over another, or outside of the window.
QString overlaps(const MainWindow &window)
{
    std::vector<std::pair<QString, QRect>> places{
        {"centre", QRect(window.centralWidget()->mapTo(&window, QPoint()), window.centralWidget()->size())}};
    for (const QDockWidget *one : window.findChildren<QDockWidget *>()) {
        if (one->isVisible() && !one->visibleRegion().isEmpty())
            places.push_back({one->objectName(), one->geometry()});
    }
    for (std::size_t i = 0; i < places.size(); ++i) {
        if (!window.rect().contains(places[i].second))
            return places[i].first + " is cut off";
        for (std::size_t j = 0; j < i; ++j) {
            if (places[i].second.intersects(places[j].second))
                return places[i].first + " lies over " + places[j].first;
        }
    }
    return {};
}

}

class RoomTest : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase() { prepareProgram(); }
    void init() { QSettings().clear(); }

    void allPanelsGoIntoASmallScreenInEachLesson_data()
    {
        QTest::addColumn<MainWindow::Mode>("mode");
        QTest::addColumn<bool>("reasons");
        QTest::newRow("learn") << MainWindow::Mode::learn << false;
        QTest::newRow("measure, stability") << MainWindow::Mode::measure << true;
    }

    void allPanelsGoIntoASmallScreenInEachLesson()
    {
        QFETCH(const MainWindow::Mode, mode);
        QFETCH(const bool, reasons);
        Bench bench({1280, 800});
        bench.window.setMode(mode);
        bench.openAll();
        bench.window.showStability(reasons);
        const QString before = bench.shown();
        for (const LessonEntry &lesson : bench.world.library.lessons) {
            for (const lessons::Step &step : lesson.steps) {
                const bool isOfMany = &step == &lesson.steps.back() || lesson.id == "walking_gait";
                if (!isOfMany)
                    continue; // these have most to show
                bench.session.openStep(lesson.id, step.id);
                QCoreApplication::sendPostedEvents(nullptr, QEvent::LayoutRequest);
                const QSize least = bench.window.layout()->totalMinimumSize();
                QVERIFY2(
                    least.width() <= 1280 && least.height() <= 800,
                    qPrintable(QString("%1: %2 x %3").arg(step.id).arg(least.width()).arg(least.height())));
                QCOMPARE(bench.window.size(), QSize(1280, 800));
                QCOMPARE(bench.shown(), before); // nothing had to go
            }
        }
    }

    void aWindowThatIsMadeSmallerThanItCanBeHasNoPanelOverAnother_data()
    {
        QTest::addColumn<MainWindow::Mode>("mode");
        QTest::addColumn<QSize>("size");
        const auto row = [](const char *name, MainWindow::Mode mode, int width, int height) {
            QTest::newRow(name) << mode << QSize(width, height);
        };
        row("learn", MainWindow::Mode::learn, 700, 500);
        row("measure", MainWindow::Mode::measure, 700, 500);
        row("build", MainWindow::Mode::build, 700, 500);
        row("narrow", MainWindow::Mode::learn, 520, 1000);
        row("low", MainWindow::Mode::measure, 1600, 440);
    }

    void aWindowThatIsMadeSmallerThanItCanBeHasNoPanelOverAnother()
    {
        QFETCH(const MainWindow::Mode, mode);
        QFETCH(const QSize, size);
        Bench bench({1280, 800});
        bench.window.setMode(mode);
        bench.openAll();
        const QString before = bench.shown();
        const bool wasRail = bench.isRail();
        bench.force(size);
        QCOMPARE(bench.window.size(), size);
        QCOMPARE(overlaps(bench.window), QString());
        QVERIFY(bench.window.findChild<SceneView *>()->width() >= 320);
        bench.force({1280, 800});
        QCOMPARE(bench.shown(), before); // all of it is back
        QCOMPARE(bench.isRail(), wasRail);
        QCOMPARE(overlaps(bench.window), QString());
        QCOMPARE(bench.window.findChild<SceneView *>()->minimumSize(), QSize(480, 220));
    }

    void whatComesBackIsAsBroadAndHighAsBefore()
    {
        Bench bench({1280, 800});
        const QSize before = bench.dock("parameters").size();
        QVERIFY(before.width() >= 380);
        const auto isCodeInFront = [&] { return !bench.dock("code").visibleRegion().isEmpty(); };
        QVERIFY(isCodeInFront());
        bench.force({700, 500});
        QVERIFY(bench.dock("code").isHidden());
        bench.force({1280, 800});
        const auto isAsBefore = [&] { // they come back one after the other
            const QSize after = bench.dock("parameters").size();
            return std::abs(after.width() - before.width()) <= 2 &&
                   std::abs(after.height() - before.height()) <= 2;
        };
        QTRY_VERIFY(isAsBefore());
        QTRY_VERIFY(isCodeInFront());
        QVERIFY(isAsBefore());
    }

    void aWindowThatComesBackToItsSizeIsAsItWas_data()
    {
        QTest::addColumn<QSize>("size");
        // Of each of them to all others and back: the usual ones, and the smallest.
        for (const QSize size : {sizes[0], sizes[1], sizes[4], sizes[8], sizes[9]})
            QTest::newRow(qPrintable(nameOf(size))) << size;
    }

    void aWindowThatComesBackToItsSizeIsAsItWas()
    {
        QFETCH(const QSize, size);
        Bench bench(size, "single_spring", "fixed_centre");
        QTest::qWait(50);
        const QString before = bench.places();
        QCOMPARE(bench.gapUnderTitle(), 5);
        for (const QSize other : sizes) {
            bench.force(other);
            QCOMPARE(overlaps(bench.window), QString());
            QTRY_VERIFY2(bench.isRail() || bench.gapUnderTitle() == 5, qPrintable(nameOf(other)));
            bench.force(size);
            QTRY_COMPARE(bench.places(), before);
        }
    }

    void panelsAreWiderInAWideWindow()
    {
        Bench bench({1280, 800});
        QCOMPARE(bench.dock("lessons").width(), 280);
        QCOMPARE(bench.dock("code").width(), 400);
        bench.force({1920, 1080});
        QTRY_COMPARE(bench.dock("lessons").width(), 320);
        QTRY_COMPARE(bench.dock("code").width(), 480);
        bench.force({1280, 800});
        QTRY_COMPARE(bench.dock("lessons").width(), 280);
        QTRY_COMPARE(bench.dock("code").width(), 400);
    }

    void panelsAreAsTheLearnerLeftThemInAnyWindow()
    {
        int code = 0, parameters = 0;
        {
            Bench bench({1280, 800});
            bench.dragSeparator(bench.dock("code").geometry().topLeft() + QPoint(-3, 200), {-30, 0});
            QCOMPARE(bench.dock("code").width(), 430);
            bench.dragSeparator(bench.dock("parameters").geometry().topLeft() + QPoint(100, -3), {0, -40});
            code = bench.dock("code").width();
            parameters = bench.dock("parameters").height();
            bench.force({1920, 1080});
            QTRY_COMPARE(bench.dock("code").width(), code);
            QTRY_COMPARE(bench.dock("lessons").width(), 320);
            bench.force({800, 700});
            bench.force({1280, 800});
            QTRY_COMPARE(bench.dock("code").width(), code);
            QTRY_COMPARE(bench.dock("parameters").height(), parameters);
            QVERIFY(bench.window.close());
        }
        Bench bench({1280, 800});
        QCOMPARE(bench.dock("code").width(), code);
        QCOMPARE(bench.dock("parameters").height(), parameters);
        bench.action("resetLayout").trigger();
        QTRY_COMPARE(bench.dock("code").width(), 400);
        QVERIFY(bench.dock("parameters").height() != parameters);
    }

    void whatIsAskedForInASmallWindowMakesOthersStepAside()
    {
        Bench bench({1280, 800});
        bench.force({760, 500});
        QVERIFY(bench.isRail());
        QVERIFY(!bench.dock("code").isHidden());
        QTest::mouseClick(bench.window.findChild<QToolButton *>("unfold"), Qt::LeftButton);
        QTest::qWait(20);
        QVERIFY(!bench.isRail());
        QVERIFY(bench.dock("code").isHidden());
        QCOMPARE(overlaps(bench.window), QString());
        QTest::keyClick(&bench.window, Qt::Key_2, Qt::ControlModifier); // and the code again
        QTest::qWait(20);
        QVERIFY(!bench.dock("code").isHidden());
        QCOMPARE(overlaps(bench.window), QString());
    }

    void parametersHaveTheHeightThatTheyNeedAndNoMore_data()
    {
        QTest::addColumn<QSize>("size");
        QTest::newRow("small") << QSize(1280, 800);
        QTest::newRow("wide") << QSize(1920, 1080);
    }

    void parametersHaveTheHeightThatTheyNeedAndNoMore()
    {
        QFETCH(const QSize, size);
        Bench bench(size, "walking_gait", "swing");
        const QDockWidget &parameters = bench.dock("parameters");
        QVERIFY2(
            std::abs(parameters.height() - parameters.sizeHint().height()) <= 2,
            qPrintable(QString("%1 for %2").arg(parameters.height()).arg(parameters.sizeHint().height())));
    }

    void accuracyStaysInAMeasureOfHalfTheSize()
    {
        Bench bench({1280, 800}, "accuracy", "halve");
        bench.window.setMode(MainWindow::Mode::measure);
        bench.force({960, 540}); // a full HD screen at 200 %
        QVERIFY(!bench.dock("accuracy").visibleRegion().isEmpty());
        QVERIFY(bench.dock("parameters").isHidden());
        QCOMPARE(overlaps(bench.window), QString());
    }

    void whatSteppedAsideIsNotForgotten()
    {
        QString before;
        {
            Bench bench({1280, 800});
            before = bench.shown();
            bench.force({500, 430});
            QVERIFY(bench.shown() != before);
            QVERIFY(bench.window.close());
        }
        const Bench bench({1280, 800});
        QCOMPARE(bench.shown(), before);
        QVERIFY(!bench.isRail());
    }

    void textAndThingsToTryAreReadInALowWindow()
    {
        Bench bench({1280, 720}, "walking_gait", "swing");
        QCOMPARE(bench.window.height(), 720);
        const auto *text =
            bench.window.findChild<QWidget *>("tries")->parentWidget()->findChild<QScrollArea *>();
        QVERIFY2(text->height() >= 200, qPrintable(QString::number(text->height()))); // ten lines
    }

    void aSmallMeasureHasARailAndTheRestAsTabs()
    {
        Bench bench({1280, 800});
        QTest::keyClick(&bench.window, Qt::Key_F6);
        QTest::qWait(20);
        QVERIFY(bench.isRail());
        QCOMPARE(bench.dock("lessons").width(), 44);
        for (const char *tab : {"effects", "energy", "code", "plots"})
            QVERIFY2(bench.window.tabifiedDockWidgets(&bench.dock("accuracy")).contains(&bench.dock(tab)),
                     tab);
        QVERIFY(!bench.dock("accuracy").visibleRegion().isEmpty());
        QVERIFY(bench.dock("accuracy").width() >= 560);
        QVERIFY(bench.window.findChild<SceneView *>()->width() >= 480);
        QTest::keyClick(&bench.window, Qt::Key_F5);
        QTest::qWait(20);
        QVERIFY(!bench.isRail());
        QCOMPARE(bench.dock("lessons").width(), 280);
    }

    void aWideMeasureHasTheWholeList()
    {
        Bench bench({1920, 1080});
        QTest::keyClick(&bench.window, Qt::Key_F6);
        QVERIFY(!bench.isRail());
    }

    void theRailIsChosenByHandAndKept()
    {
        {
            Bench bench({1280, 800});
            QTest::mouseClick(bench.window.findChild<QToolButton *>("fold"), Qt::LeftButton);
            QVERIFY(bench.isRail());
            QTest::keyClick(&bench.window, Qt::Key_F6);
            QVERIFY(bench.isRail());
            QTest::keyClick(&bench.window, Qt::Key_1, Qt::ControlModifier | Qt::ShiftModifier);
            QVERIFY(!bench.isRail());
            QVERIFY(bench.window.close());
        }
        Bench bench({1280, 800});
        QVERIFY(bench.isRail());
        QTest::qWait(20);
        QCOMPARE(bench.dock("lessons").width(), 44);
        QTest::keyClick(&bench.window, Qt::Key_F6);
        QVERIFY(!bench.isRail());
        bench.action("resetLayout").trigger();
        QVERIFY(bench.isRail());
        QTest::keyClick(&bench.window, Qt::Key_F5);
        bench.action("resetLayout").trigger();
        QVERIFY(!bench.isRail());
    }

    void arrangementsComeBackWhileThePanelsAreStillToBeLaidOut()
    {
        Bench bench({1280, 800});
        bench.openAll();
        const QString open = bench.shown();
        for (const QSize size : {QSize(700, 500), QSize(1000, 700), QSize(1280, 800), QSize(800, 900)}) {
            bench.force(size);
            for (const auto mode : {MainWindow::Mode::measure, MainWindow::Mode::learn,
                                    MainWindow::Mode::build, MainWindow::Mode::learn}) {
                bench.window.layout()->invalidate(); // as a panel does that wants another size
                bench.window.setMode(mode);
            }
        }
        bench.force({1280, 800});
        QCOMPARE(bench.shown(), open);
        QCOMPARE(overlaps(bench.window), QString());
    }

    void theMarksOfTheRailOpenStepsByMouseAndKeysAndSayWhatTheyAre()
    {
        Bench bench({1280, 800});
        bench.action("lessonRail").trigger();
        QTest::qWait(20);
        auto *list = bench.window.findChild<LessonList *>();
        const QAbstractItemModel &model = *list->model();
        const QModelIndex lesson = model.index(3, 0); // the open one
        QTest::mouseClick(list->viewport(), Qt::LeftButton, {},
                          list->visualRect(model.index(0, 0, lesson)).center());
        QCOMPARE(bench.session.step().id, QString("walls"));
        list->setFocus();
        list->setCurrentIndex(model.index(0, 0, lesson));
        QTest::keyClick(list, Qt::Key_Down);
        QTest::keyClick(list, Qt::Key_Return);
        QCOMPARE(bench.session.step().id, QString("gravity"));
        QHelpEvent help(QEvent::ToolTip, list->visualRect(lesson).center(),
                        list->viewport()->mapToGlobal(list->visualRect(lesson).center()));
        QApplication::sendEvent(list->viewport(), &help);
        QTRY_COMPARE(QToolTip::text(), QString("Gravity and walls, 0 of 2 steps done"));
        QToolTip::hideText();
    }

    void theRailGoesToTheNeighboursAndToTheSummary()
    {
        Bench bench({1280, 800}, "gravity_walls", "walls");
        bench.action("lessonRail").trigger();
        QTest::qWait(20);
        auto *back = bench.window.findChild<QToolButton *>("railBack");
        auto *next = bench.window.findChild<QToolButton *>("railNext");
        for (const QToolButton *button : {back, next}) {
            QVERIFY(button->isVisible() && button->focusPolicy() & Qt::TabFocus);
            QVERIFY(!button->accessibleName().isEmpty() && !button->toolTip().isEmpty());
        }
        QTest::mouseClick(next, Qt::LeftButton);
        QCOMPARE(bench.session.step().id, QString("gravity"));
        QTest::mouseClick(back, Qt::LeftButton);
        QCOMPARE(bench.session.step().id, QString("walls"));
        QTest::mouseClick(next, Qt::LeftButton);
        QTest::mouseClick(next, Qt::LeftButton); // after the last step, what was learnt
        QVERIFY(!bench.isRail());
    }
};

QTEST_MAIN(RoomTest)
#include "tst_room.moc"
