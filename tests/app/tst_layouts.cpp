// Arrangements of the window: each preset has its own, and the scene can be alone.

#include "app/ui/panels/parameter_row.h"
#include "app/ui/scene/scene_view.h"
#include "app/ui/time/timeline_strip.h"
#include "app/ui/time/transport_bar.h"
#include "app/ui/window/focus_parameters.h"
#include "app/ui/window/main_window.h"
#include "app/ui/window/scene_card.h"
#include "panels_bench.h"
#include "studies.h"

#include <QAbstractSpinBox>
#include <QAction>
#include <QDockWidget>
#include <QMenu>
#include <QSettings>
#include <QtTest>

using namespace app;

namespace {

struct Bench
{
    explicit Bench(QSize size = {1280, 800}) { show(window, size); }

    QDockWidget &dock(const char *name) { return *window.findChild<QDockWidget *>(name); }
    QAction &action(const char *name) { return *window.findChild<QAction *>(name); }
    void key(Qt::Key key, Qt::KeyboardModifiers modifiers = {})
    {
        QTest::keyClick(&window, key, modifiers);
        QCoreApplication::processEvents();
    }
    /// Takes an entry of the menu that arranges panels.
    void move(const QString &panel, const QString &where)
    {
        auto *menu = window.findChild<QMenu *>("arrange");
        menu->popup({});
        for (QAction *one : menu->actions()) {
            if (one->menu() && one->text() == panel)
                menu = one->menu();
        }
        for (QAction *one : menu->actions()) {
            if (one->text().remove('&') == where)
                one->trigger();
        }
        while (QWidget *open = QApplication::activePopupWidget())
            open->close();
        window.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&window));
        window.setFocus();
    }
    Qt::DockWidgetArea areaOf(const char *name) { return window.dockWidgetArea(&dock(name)); }

    World world;
    MainWindow window{world.session, world.theme, noStudy, noCost};
    Session &session = world.session;
};

}

class LayoutsTest : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase() { prepareProgram(); }
    void init() { QSettings().clear(); }

    void whatIsMovedInAPresetStaysThereAndOnlyThere()
    {
        Bench bench;
        bench.key(Qt::Key_F6);
        QCOMPARE(bench.areaOf("accuracy"), Qt::RightDockWidgetArea);
        bench.move("Parameters", "to the left");
        QCOMPARE(bench.areaOf("parameters"), Qt::LeftDockWidgetArea);
        bench.key(Qt::Key_F5);
        QCOMPARE(bench.areaOf("parameters"), Qt::RightDockWidgetArea);
        QVERIFY(bench.dock("accuracy").isHidden());
        bench.key(Qt::Key_F6);
        QCOMPARE(bench.areaOf("parameters"), Qt::LeftDockWidgetArea);
        QVERIFY(!bench.dock("accuracy").isHidden());
    }

    void everyPresetIsFoundAgainAtTheNextStart()
    {
        {
            Bench bench;
            bench.move("Code", "to the left");
            bench.key(Qt::Key_F6);
            bench.move("Parameters", "below the picture");
            bench.window.close();
        }
        Bench bench;
        QCOMPARE(bench.areaOf("code"), Qt::LeftDockWidgetArea);
        QCOMPARE(bench.areaOf("parameters"), Qt::RightDockWidgetArea);
        bench.key(Qt::Key_F6);
        QCOMPARE(bench.areaOf("parameters"), Qt::BottomDockWidgetArea);
        bench.key(Qt::Key_F5);
        QCOMPARE(bench.areaOf("code"), Qt::LeftDockWidgetArea);
    }

    void plotsThatWereMovedStayWhereTheyArePut()
    {
        Bench bench;
        bench.move("Plots", "below the picture");
        QCOMPARE(bench.areaOf("plots"), Qt::BottomDockWidgetArea);
        bench.window.showPlots(false);
        bench.window.showPlots(true);
        QCOMPARE(bench.areaOf("plots"), Qt::BottomDockWidgetArea);
        bench.key(Qt::Key_F6);
        bench.key(Qt::Key_F5);
        QCOMPARE(bench.areaOf("plots"), Qt::BottomDockWidgetArea);
        QVERIFY(!bench.dock("plots").isHidden());
    }

    void aPresetIsPutBackToWhatItWasAtFirstAlone_data()
    {
        QTest::addColumn<QSize>("size");
        QTest::newRow("small") << QSize(1280, 800);
        QTest::newRow("wide") << QSize(1920, 1080);
    }

    void aPresetIsPutBackToWhatItWasAtFirstAlone()
    {
        QFETCH(QSize, size);
        Bench bench(size);
        const int lessons = bench.dock("lessons").width(), code = bench.dock("code").width();
        bench.move("Code", "to the left");
        bench.key(Qt::Key_F6);
        const bool hadEnergy = !bench.dock("energy").isHidden();
        bench.move("Accuracy", "below the picture");
        bench.action("resetLayout").trigger();
        QCoreApplication::processEvents();
        QCOMPARE(bench.areaOf("accuracy"), Qt::RightDockWidgetArea);
        QCOMPARE(!bench.dock("energy").isHidden(), hadEnergy);
        bench.key(Qt::Key_F5);
        QCOMPARE(bench.areaOf("code"), Qt::LeftDockWidgetArea); // that one was not asked
        bench.action("resetLayout").trigger();
        QTest::qWait(50);
        QCOMPARE(bench.areaOf("code"), Qt::RightDockWidgetArea);
        QVERIFY2(std::abs(bench.dock("lessons").width() - lessons) <= 2,
                 qPrintable(QString::number(bench.dock("lessons").width())));
        QVERIFY2(std::abs(bench.dock("code").width() - code) <= 2,
                 qPrintable(QString::number(bench.dock("code").width())));
        QVERIFY(bench.dock("accuracy").isHidden() && bench.dock("energy").isHidden());
    }

    void panelsCanBeDraggedOnlyWhileTheyAreUnlocked()
    {
        Bench bench;
        const QList<QDockWidget *> docks = bench.window.findChildren<QDockWidget *>();
        for (const QDockWidget *one : docks)
            QVERIFY(!(one->features() & QDockWidget::DockWidgetMovable));
        bench.action("movable").trigger();
        for (const QDockWidget *one : docks) {
            QVERIFY(one->features() & QDockWidget::DockWidgetMovable);
            QVERIFY2(one->titleBarWidget()->sizeHint().height() >= 16, qPrintable(one->objectName()));
        }
        bench.action("movable").trigger();
        for (const QDockWidget *one : docks)
            QVERIFY(!(one->features() & QDockWidget::DockWidgetMovable));
        QVERIFY(bench.dock("lessons").titleBarWidget()->sizeHint().height() <= 0);
        QVERIFY(bench.dock("code").titleBarWidget()->sizeHint().height() > 20);
    }

    void theSceneAloneHasThreeParametersACardAndItsTimeInOneRow()
    {
        Bench bench;
        bench.session.openStep("two", "many");
        auto *timeline = bench.window.findChild<TimelineStrip *>();
        auto *transport = bench.window.findChild<TransportBar *>();
        auto *scene = bench.window.findChild<SceneView *>();
        const int before = scene->height();
        const int lessons = bench.dock("lessons").width(), code = bench.dock("code").width();
        QVERIFY(!transport->isAncestorOf(timeline));
        bench.key(Qt::Key_F11);
        for (const QDockWidget *one : bench.window.findChildren<QDockWidget *>())
            QVERIFY2(one->isHidden(), qPrintable(one->objectName()));
        auto *parameters = bench.window.findChild<FocusParameters *>();
        QVERIFY(parameters);
        QCOMPARE(parameters->rows().size(), std::size_t{3});
        for (const ParameterRow *row : parameters->rows())
            QVERIFY(row->isVisible());
        QVERIFY(transport->isAncestorOf(timeline));
        QVERIFY(timeline->isVisible() && timeline->height() <= transport->height());
        QVERIFY(transport->rect().contains(timeline->geometry()));
        QVERIFY(scene->height() > before);
        auto *card = bench.window.findChild<SceneCard *>();
        QVERIFY(card->isVisible());
        bench.key(Qt::Key_F11);
        QTRY_VERIFY(!bench.window.findChild<FocusParameters *>());
        QVERIFY(!card->isVisible());
        QVERIFY(!transport->isAncestorOf(timeline));
        QCOMPARE(scene->height(), before);
        QVERIFY(!bench.dock("lessons").isHidden() && !bench.dock("code").isHidden());
        QCOMPARE(bench.dock("lessons").width(), lessons);
        QCOMPARE(bench.dock("code").width(), code);
    }

    void theParametersAboveTheSceneAreChangedByKeysAndMouse()
    {
        Bench bench;
        bench.key(Qt::Key_F11);
        auto *parameters = bench.window.findChild<FocusParameters *>();
        ParameterRow *k = parameters->rows().front();
        QCOMPARE(k->parameter().id, QString("k"));
        type(*k->findChild<QAbstractSpinBox *>(), "0.45");
        QCOMPARE(bench.session.parameter("k"), 0.45);
        bench.session.setParameter("k", 0.1);
        QTRY_COMPARE(k->findChild<QAbstractSpinBox *>()->text().toDouble(), 0.1);
        bench.session.openStep("two", "many"); // from within the scene alone
        QCOMPARE(parameters->rows().size(), std::size_t{3});
    }

    void theTimelineInTheRowIsScrubbedLikeTheOther()
    {
        Bench bench;
        bench.session.goTo({80, 0});
        bench.key(Qt::Key_F11);
        auto *timeline = bench.window.findChild<TimelineStrip *>();
        const QPoint place(qRound(timeline->axis().xOf(30)), 25);
        QTest::mouseClick(timeline, Qt::LeftButton, {}, place);
        QTRY_COMPARE(bench.session.timeline().cursor().frame, timeline->axis().frameAt(place.x()));
        timeline->setFocus();
        QTest::keyClick(timeline, Qt::Key_Right, Qt::ShiftModifier);
        QCOMPARE(bench.session.timeline().cursor().phase, 1);
    }

    void theCardSaysWhatThereIsToTryUntilItIsDone()
    {
        forgetProgress();
        Bench bench;
        bench.session.openStep("one", "first");
        bench.key(Qt::Key_F11);
        auto *card = bench.window.findChild<SceneCard *>();
        QCOMPARE(card->sentence(), QString("Wait five frames."));
        QCOMPARE(card->accessibleName(), QString("The first step: Wait five frames."));
        bench.session.play();
        QTRY_VERIFY(card->sentence().startsWith("Done"));
        bench.session.pause();
        bench.session.openStep("one", "second"); // nothing to try: what the step is about
        QCOMPARE(card->sentence(), QString("A spring pulls the foot to the cross."));
    }

    void theCardLetsTheMouseThrough()
    {
        Bench bench;
        bench.key(Qt::Key_F11);
        auto *card = bench.window.findChild<SceneCard *>();
        const QPoint middle = card->mapTo(&bench.window, card->rect().center());
        QVERIFY(bench.window.childAt(middle) != card && !card->isAncestorOf(bench.window.childAt(middle)));
    }

    void aPresetEndsTheSceneAloneAndAWindowThatClosesThereKeepsItsPanels()
    {
        {
            Bench bench;
            bench.key(Qt::Key_F11);
            bench.key(Qt::Key_F6);
            QVERIFY(!bench.action("sceneOnly").isChecked());
            QVERIFY(!bench.dock("accuracy").isHidden());
            bench.key(Qt::Key_F5);
            bench.key(Qt::Key_F11);
            bench.window.close();
        }
        Bench bench;
        QVERIFY(!bench.dock("lessons").isHidden());
        QVERIFY(!bench.dock("code").isHidden());
    }
};

QTEST_MAIN(LayoutsTest)
#include "tst_layouts.moc"
