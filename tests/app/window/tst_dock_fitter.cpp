// The dock fitter: all panels fit into a small screen. In a smaller window, some panels are hidden or become tabs.

#include "app/ui/learn/learn_panel.h"
#include "app/ui/learn/lessons/lesson_list.h"
#include "app/ui/learn/narration_text.h"
#include "app/ui/learn/step/narration.h"
#include "tests/app/support/window_fixture.h"
#include "tests/suite.h"

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
using namespace tests;

namespace {

struct FitterFixture : WindowFixture
{
    explicit FitterFixture(QSize size, const char *lesson = "gravity_walls", const char *step = "gravity")
        : WindowFixture({.lesson = lesson, .step = step, .size = size})
    {
    }
    bool isRail() const { return window.findChild<LearnPanel *>()->form() == LearnPanel::Form::rail; }
    /// Resizes the window as a window manager does that ignores its minimum size.
    void force(QSize size)
    {
        window.setMinimumSize(1, 1);
        window.resize(size);
        settle();
    }
    void openAll()
    {
        for (const char *name : {"showEnergy", "showEffects", "showPlots", "showBranches"}) {
            if (!action(name).isChecked())
                action(name).trigger();
        }
        settle();
    }
    /// Drags the line between two panels.
    void dragSeparator(QPoint from, QPoint by)
    {
        QTest::mousePress(&window, Qt::LeftButton, {}, from);
        moveMouse(window, from + by, Qt::LeftButton);
        settle(); // the main window moves its separators by a timer
        QTest::mouseRelease(&window, Qt::LeftButton, {}, from + by);
    }
    /// px between the title of the step and its text.
    int gapUnderTitle()
    {
        auto *text = window.findChild<Narration *>()->findChild<NarrationText *>();
        auto *title = window.findChild<Narration *>()->findChild<QLabel *>("stepTitle");
        return text->y() - title->geometry().bottom() - 1;
    }
    /// Returns the geometry of everything that depends on the size of the window.
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
};

/// Logical px of windows: screens of 1024 x 768 to 2560 x 1440 px at 100, 150 and 200 %.
constexpr QSize screenSizes[] = {{1280, 800},  {1024, 768}, {1280, 720}, {1600, 900}, {1920, 1080},
                                 {2560, 1440}, {1707, 960}, {1067, 600}, {960, 540},  {800, 600}};

QString sizeName(QSize size)
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
        FitterFixture fixture({1280, 800});
        fixture.window.setMode(mode);
        fixture.openAll();
        fixture.window.docks().show(Panel::stability, reasons);
        const QStringList before = fixture.shownDocks();
        for (const LessonEntry &lesson : fixture.library.lessons) {
            for (const lessons::Step &step : lesson.steps) {
                const bool isOfMany = &step == &lesson.steps.back() || lesson.id == "walking_gait";
                if (!isOfMany)
                    continue; // these have most to show
                fixture.session.openStep(lesson.id, step.id);
                QCoreApplication::sendPostedEvents(nullptr, QEvent::LayoutRequest);
                const QSize least = fixture.window.layout()->totalMinimumSize();
                QVERIFY2(
                    least.width() <= 1280 && least.height() <= 800,
                    qPrintable(QString("%1: %2 x %3").arg(step.id).arg(least.width()).arg(least.height())));
                QCOMPARE(fixture.window.size(), QSize(1280, 800));
                QCOMPARE(fixture.shownDocks(), before); // no dock had to be hidden
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
        FitterFixture fixture({1280, 800});
        fixture.window.setMode(mode);
        fixture.openAll();
        const QStringList before = fixture.shownDocks();
        const bool wasRail = fixture.isRail();
        fixture.force(size);
        QCOMPARE(fixture.window.size(), size);
        QCOMPARE(overlaps(fixture.window), QString());
        QVERIFY(fixture.view.width() >= 320);
        fixture.force({1280, 800});
        QCOMPARE(fixture.shownDocks(), before); // all of it is back
        QCOMPARE(fixture.isRail(), wasRail);
        QCOMPARE(overlaps(fixture.window), QString());
        QCOMPARE(fixture.view.minimumSize(), QSize(480, 220));
    }

    void inTheSmallestWindowTheModesHaveTheirNames_data()
    {
        QTest::addColumn<QString>("language");
        for (const char *language : {"", "de", "es", "fr"})
            QTest::newRow(*language ? language : "en") << QString(language);
    }

    void inTheSmallestWindowTheModesHaveTheirNames()
    {
        QFETCH(const QString, language);
        WindowFixture fixture({.language = language});
        fixture.window.resize(fixture.window.minimumSize());
        settle();
        QCOMPARE(fixture.window.size(), fixture.window.minimumSize());
        const auto modes = fixture.part<QFrame>("modes").findChildren<QToolButton *>("mode");
        QCOMPARE(modes.size(), 3);
        for (const QToolButton *mode : modes)
            QVERIFY2(mode->width() >= mode->sizeHint().width(), qPrintable(mode->text()));
        const auto &more = fixture.part<QToolButton>("qt_menubar_ext_button");
        QVERIFY(more.isVisible() && more.iconSize().width() <= more.width());
        QVERIFY(!more.toolTip().isEmpty() && more.accessibleName() == more.toolTip());
    }

    void docksComeBackInTheirFormerSize()
    {
        FitterFixture fixture({1280, 800});
        const QSize before = fixture.dock("parameters").size();
        QVERIFY(before.width() >= 380);
        const auto isCodeInFront = [&] { return !fixture.dock("code").visibleRegion().isEmpty(); };
        QVERIFY(isCodeInFront());
        fixture.force({700, 500});
        QVERIFY(fixture.dock("code").isHidden());
        fixture.force({1280, 800});
        const auto isAsBefore = [&] { // they come back one after the other
            const QSize after = fixture.dock("parameters").size();
            return std::abs(after.width() - before.width()) <= 2 &&
                   std::abs(after.height() - before.height()) <= 2;
        };
        QTRY_VERIFY(isAsBefore());
        QTRY_VERIFY(isCodeInFront());
        QVERIFY(isAsBefore());
    }

    void resizingBackRestoresTheLayout_data()
    {
        QTest::addColumn<QSize>("size");
        // Each of these sizes is changed to every other and back: the usual ones, and the smallest.
        for (const QSize size :
             {screenSizes[0], screenSizes[1], screenSizes[4], screenSizes[8], screenSizes[9]})
            QTest::newRow(qPrintable(sizeName(size))) << size;
    }

    void resizingBackRestoresTheLayout()
    {
        QFETCH(const QSize, size);
        FitterFixture fixture(size, "single_spring", "fixed_centre");
        settle();
        const QString before = fixture.places();
        QCOMPARE(fixture.gapUnderTitle(), 5);
        for (const QSize other : screenSizes) {
            fixture.force(other);
            QCOMPARE(overlaps(fixture.window), QString());
            QTRY_VERIFY2(fixture.isRail() || fixture.gapUnderTitle() == 5, qPrintable(sizeName(other)));
            fixture.force(size);
            QTRY_COMPARE(fixture.places(), before);
        }
    }

    void panelsAreWiderInAWideWindow()
    {
        FitterFixture fixture({1280, 800});
        QCOMPARE(fixture.dock("lessons").width(), 280);
        QCOMPARE(fixture.dock("code").width(), 400);
        fixture.force({1920, 1080});
        QTRY_COMPARE(fixture.dock("lessons").width(), 320);
        QTRY_COMPARE(fixture.dock("code").width(), 480);
        fixture.force({1280, 800});
        QTRY_COMPARE(fixture.dock("lessons").width(), 280);
        QTRY_COMPARE(fixture.dock("code").width(), 400);
    }

    void panelsAreAsTheLearnerLeftThemInAnyWindow()
    {
        int code = 0, parameters = 0;
        {
            FitterFixture fixture({1280, 800});
            fixture.dragSeparator(fixture.dock("code").geometry().topLeft() + QPoint(-3, 200), {-30, 0});
            QCOMPARE(fixture.dock("code").width(), 430);
            fixture.dragSeparator(fixture.dock("parameters").geometry().topLeft() + QPoint(100, -3),
                                  {0, -40});
            code = fixture.dock("code").width();
            parameters = fixture.dock("parameters").height();
            fixture.force({1920, 1080});
            QTRY_COMPARE(fixture.dock("code").width(), code);
            QTRY_COMPARE(fixture.dock("lessons").width(), 320);
            fixture.force({800, 700});
            fixture.force({1280, 800});
            QTRY_COMPARE(fixture.dock("code").width(), code);
            QTRY_COMPARE(fixture.dock("parameters").height(), parameters);
            QVERIFY(fixture.window.close());
        }
        FitterFixture fixture({1280, 800});
        QCOMPARE(fixture.dock("code").width(), code);
        QCOMPARE(fixture.dock("parameters").height(), parameters);
        fixture.action("resetLayout").trigger();
        QTRY_COMPARE(fixture.dock("code").width(), 400);
        QVERIFY(fixture.dock("parameters").height() != parameters);
    }

    void aDockOpenedInASmallWindowHidesOthers()
    {
        FitterFixture fixture({1280, 800});
        fixture.force({760, 500});
        QVERIFY(fixture.isRail());
        QVERIFY(!fixture.dock("code").isHidden());
        QTest::mouseClick(fixture.window.findChild<QToolButton *>("unfold"), Qt::LeftButton);
        settle();
        QVERIFY(!fixture.isRail());
        QVERIFY(fixture.dock("code").isHidden());
        QCOMPARE(overlaps(fixture.window), QString());
        QTest::keyClick(&fixture.window, Qt::Key_2, Qt::ControlModifier); // and the code again
        settle();
        QVERIFY(!fixture.dock("code").isHidden());
        QCOMPARE(overlaps(fixture.window), QString());
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
        FitterFixture fixture(size, "walking_gait", "swing");
        const QDockWidget &parameters = fixture.dock("parameters");
        QVERIFY2(
            std::abs(parameters.height() - parameters.sizeHint().height()) <= 2,
            qPrintable(QString("%1 for %2").arg(parameters.height()).arg(parameters.sizeHint().height())));
    }

    void accuracyStaysInAMeasureOfHalfTheSize()
    {
        FitterFixture fixture({1280, 800}, "accuracy", "halve");
        fixture.window.setMode(MainWindow::Mode::measure);
        fixture.force({960, 540}); // a full HD screen at 200 %
        QVERIFY(!fixture.dock("accuracy").visibleRegion().isEmpty());
        QVERIFY(fixture.dock("parameters").isHidden());
        QCOMPARE(overlaps(fixture.window), QString());
    }

    void hiddenDocksComeBackInALargeWindow()
    {
        QStringList before;
        {
            FitterFixture fixture({1280, 800});
            before = fixture.shownDocks();
            fixture.force({500, 430});
            QVERIFY(fixture.shownDocks() != before);
            QVERIFY(fixture.window.close());
        }
        const FitterFixture fixture({1280, 800});
        QCOMPARE(fixture.shownDocks(), before);
        QVERIFY(!fixture.isRail());
    }

    void textAndThingsToTryAreReadInALowWindow()
    {
        FitterFixture fixture({1280, 720}, "walking_gait", "swing");
        QCOMPARE(fixture.window.height(), 720);
        const auto *text = fixture.window.findChild<Narration *>()->findChild<QScrollArea *>();
        QVERIFY2(text->height() >= 200, qPrintable(QString::number(text->height()))); // ten lines
    }

    void aSmallMeasureHasARailAndTheRestAsTabs()
    {
        FitterFixture fixture({1280, 800});
        QTest::keyClick(&fixture.window, Qt::Key_F6);
        settle();
        QVERIFY(fixture.isRail());
        QCOMPARE(fixture.dock("lessons").width(), 44);
        for (const char *tab : {"effects", "energy", "code", "plots"})
            QVERIFY2(
                fixture.window.tabifiedDockWidgets(&fixture.dock("accuracy")).contains(&fixture.dock(tab)),
                tab);
        QVERIFY(!fixture.dock("accuracy").visibleRegion().isEmpty());
        QVERIFY(fixture.dock("accuracy").width() >= 560);
        QVERIFY(fixture.view.width() >= 480);
        QTest::keyClick(&fixture.window, Qt::Key_F5);
        settle();
        QVERIFY(!fixture.isRail());
        QCOMPARE(fixture.dock("lessons").width(), 280);
    }

    void aWideMeasureHasTheWholeList()
    {
        FitterFixture fixture({1920, 1080});
        QTest::keyClick(&fixture.window, Qt::Key_F6);
        QVERIFY(!fixture.isRail());
    }

    void theRailIsChosenByHandAndKept()
    {
        {
            FitterFixture fixture({1280, 800});
            QTest::mouseClick(fixture.window.findChild<QToolButton *>("fold"), Qt::LeftButton);
            QVERIFY(fixture.isRail());
            QTest::keyClick(&fixture.window, Qt::Key_F6);
            QVERIFY(fixture.isRail());
            QTest::keyClick(&fixture.window, Qt::Key_1, Qt::ControlModifier | Qt::ShiftModifier);
            QVERIFY(!fixture.isRail());
            QVERIFY(fixture.window.close());
        }
        FitterFixture fixture({1280, 800});
        QVERIFY(fixture.isRail());
        settle();
        QCOMPARE(fixture.dock("lessons").width(), 44);
        QTest::keyClick(&fixture.window, Qt::Key_F6);
        QVERIFY(!fixture.isRail());
        fixture.action("resetLayout").trigger();
        QVERIFY(fixture.isRail());
        QTest::keyClick(&fixture.window, Qt::Key_F5);
        fixture.action("resetLayout").trigger();
        QVERIFY(!fixture.isRail());
    }

    void arrangementsComeBackWhileThePanelsAreStillToBeLaidOut()
    {
        FitterFixture fixture({1280, 800});
        fixture.openAll();
        const QStringList open = fixture.shownDocks();
        for (const QSize size : {QSize(700, 500), QSize(1000, 700), QSize(1280, 800), QSize(800, 900)}) {
            fixture.force(size);
            for (const auto mode : {MainWindow::Mode::measure, MainWindow::Mode::learn,
                                    MainWindow::Mode::build, MainWindow::Mode::learn}) {
                fixture.window.layout()->invalidate(); // as a panel does that wants another size
                fixture.window.setMode(mode);
            }
        }
        fixture.force({1280, 800});
        QCOMPARE(fixture.shownDocks(), open);
        QCOMPARE(overlaps(fixture.window), QString());
    }

    void theMarksOfTheRailOpenStepsByMouseAndKeysAndSayWhatTheyAre()
    {
        FitterFixture fixture({1280, 800});
        fixture.action("lessonRail").trigger();
        settle();
        auto *list = fixture.window.findChild<LessonList *>();
        const QAbstractItemModel &model = *list->model();
        const QModelIndex lesson = model.index(3, 0); // the open one
        QTest::mouseClick(list->viewport(), Qt::LeftButton, {},
                          list->visualRect(model.index(0, 0, lesson)).center());
        QCOMPARE(fixture.session.step().id, QString("walls"));
        list->setFocus();
        list->setCurrentIndex(model.index(0, 0, lesson));
        QTest::keyClick(list, Qt::Key_Down);
        QTest::keyClick(list, Qt::Key_Return);
        QCOMPARE(fixture.session.step().id, QString("gravity"));
        QHelpEvent help(QEvent::ToolTip, list->visualRect(lesson).center(),
                        list->viewport()->mapToGlobal(list->visualRect(lesson).center()));
        QApplication::sendEvent(list->viewport(), &help);
        QTRY_COMPARE(QToolTip::text(), QString("Gravity and walls, 0 of 2 steps done"));
        QToolTip::hideText();
    }

    void theRailGoesToTheNeighboursAndToTheSummary()
    {
        FitterFixture fixture({1280, 800}, "gravity_walls", "walls");
        fixture.action("lessonRail").trigger();
        settle();
        auto *back = fixture.window.findChild<QToolButton *>("railBack");
        auto *next = fixture.window.findChild<QToolButton *>("railNext");
        for (const QToolButton *button : {back, next}) {
            QVERIFY(button->isVisible() && button->focusPolicy() & Qt::TabFocus);
            QVERIFY(!button->accessibleName().isEmpty() && !button->toolTip().isEmpty());
        }
        QTest::mouseClick(next, Qt::LeftButton);
        QCOMPARE(fixture.session.step().id, QString("gravity"));
        QTest::mouseClick(back, Qt::LeftButton);
        QCOMPARE(fixture.session.step().id, QString("walls"));
        QTest::mouseClick(next, Qt::LeftButton);
        QTest::mouseClick(next, Qt::LeftButton); // after the last step, what was learnt
        QVERIFY(!fixture.isRail());
    }
};

SUITE(tst_dock_fitter, RoomTest)
#include "tst_dock_fitter.moc"
