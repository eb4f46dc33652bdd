// Arrangements of the window: each preset has its own, and the scene can be alone.

#include "app/ui/parameters/parameter_panel.h"
#include "app/ui/parameters/parameter_row.h"
#include "app/ui/time/timeline_strip.h"
#include "app/ui/time/transport_bar.h"
#include "app/ui/window/focus_parameters.h"
#include "app/ui/window/scene_card.h"
#include "tests/app/support/two_lessons.h"
#include "tests/app/support/window_fixture.h"
#include "tests/suite.h"

#include <QAbstractSpinBox>
#include <QAction>
#include <QDockWidget>
#include <QMenu>
#include <QScrollArea>
#include <QScrollBar>
#include <QSettings>
#include <QtTest>

using namespace app;
using namespace tests;

namespace {

struct LayoutFixture : WindowFixture
{
    explicit LayoutFixture(QSize size = {1280, 800})
        : WindowFixture({.lesson = "one", .step = "first", .size = size, .library = twoLessons()})
    {
    }
    /// Triggers an entry of the menu that arranges panels.
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
};

}

class LayoutsTest : public QObject
{
    Q_OBJECT

private slots:
    void init() { QSettings().clear(); }

    void movedDocksStayMovedInTheirPresetOnly()
    {
        LayoutFixture fixture;
        fixture.key(Qt::Key_F6);
        QCOMPARE(fixture.areaOf("accuracy"), Qt::RightDockWidgetArea);
        fixture.move("Parameters", "to the left");
        QCOMPARE(fixture.areaOf("parameters"), Qt::LeftDockWidgetArea);
        fixture.key(Qt::Key_F5);
        QCOMPARE(fixture.areaOf("parameters"), Qt::RightDockWidgetArea);
        QVERIFY(fixture.dock("accuracy").isHidden());
        fixture.key(Qt::Key_F6);
        QCOMPARE(fixture.areaOf("parameters"), Qt::LeftDockWidgetArea);
        QVERIFY(!fixture.dock("accuracy").isHidden());
    }

    void everyPresetIsFoundAgainAtTheNextStart()
    {
        {
            LayoutFixture fixture;
            fixture.move("Code", "to the left");
            fixture.key(Qt::Key_F6);
            fixture.move("Parameters", "below the picture");
            fixture.window.close();
        }
        LayoutFixture fixture;
        QCOMPARE(fixture.areaOf("code"), Qt::LeftDockWidgetArea);
        QCOMPARE(fixture.areaOf("parameters"), Qt::RightDockWidgetArea);
        fixture.key(Qt::Key_F6);
        QCOMPARE(fixture.areaOf("parameters"), Qt::BottomDockWidgetArea);
        fixture.key(Qt::Key_F5);
        QCOMPARE(fixture.areaOf("code"), Qt::LeftDockWidgetArea);
    }

    void noParameterIsCutInTwoBesideTheAccuracy()
    {
        WindowFixture fixture({.lesson = "accuracy", .step = "budget"});
        fixture.key(Qt::Key_F6);
        settle();
        const auto *area = fixture.part<ParameterPanel>().findChild<QScrollArea *>();
        QVERIFY(area->verticalScrollBar()->isVisible());
        for (const auto *row : area->findChildren<ParameterRow *>()) {
            const int top = row->mapTo(area->viewport(), QPoint()).y();
            const bool isIn = top >= 0 && top + ParameterRow::height <= area->viewport()->height();
            QVERIFY2(isIn || top + 6 > area->viewport()->height(), qPrintable(row->parameter().name));
        }
    }

    void plotsThatWereMovedStayWhereTheyArePut()
    {
        LayoutFixture fixture;
        fixture.move("Plots", "below the picture");
        QCOMPARE(fixture.areaOf("plots"), Qt::BottomDockWidgetArea);
        fixture.window.docks().show(Panel::plots, false);
        fixture.window.docks().show(Panel::plots, true);
        QCOMPARE(fixture.areaOf("plots"), Qt::BottomDockWidgetArea);
        fixture.key(Qt::Key_F6);
        fixture.key(Qt::Key_F5);
        QCOMPARE(fixture.areaOf("plots"), Qt::BottomDockWidgetArea);
        QVERIFY(!fixture.dock("plots").isHidden());
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
        LayoutFixture fixture(size);
        const int lessons = fixture.dock("lessons").width(), code = fixture.dock("code").width();
        fixture.move("Code", "to the left");
        fixture.key(Qt::Key_F6);
        const bool hadEnergy = !fixture.dock("energy").isHidden();
        fixture.move("Accuracy", "below the picture");
        fixture.action("resetLayout").trigger();
        QCoreApplication::processEvents();
        QCOMPARE(fixture.areaOf("accuracy"), Qt::RightDockWidgetArea);
        QCOMPARE(!fixture.dock("energy").isHidden(), hadEnergy);
        fixture.key(Qt::Key_F5);
        QCOMPARE(fixture.areaOf("code"), Qt::LeftDockWidgetArea); // that one was not asked
        fixture.action("resetLayout").trigger();
        settle();
        QCOMPARE(fixture.areaOf("code"), Qt::RightDockWidgetArea);
        QVERIFY2(std::abs(fixture.dock("lessons").width() - lessons) <= 2,
                 qPrintable(QString::number(fixture.dock("lessons").width())));
        QVERIFY2(std::abs(fixture.dock("code").width() - code) <= 2,
                 qPrintable(QString::number(fixture.dock("code").width())));
        QVERIFY(fixture.dock("accuracy").isHidden() && fixture.dock("energy").isHidden());
    }

    void panelsCanBeDraggedOnlyWhileTheyAreUnlocked()
    {
        LayoutFixture fixture;
        const QList<QDockWidget *> docks = fixture.window.findChildren<QDockWidget *>();
        for (const QDockWidget *one : docks)
            QVERIFY(!(one->features() & QDockWidget::DockWidgetMovable));
        fixture.action("movable").trigger();
        for (const QDockWidget *one : docks) {
            QVERIFY(one->features() & QDockWidget::DockWidgetMovable);
            QVERIFY2(one->titleBarWidget()->sizeHint().height() >= 16, qPrintable(one->objectName()));
        }
        fixture.action("movable").trigger();
        for (const QDockWidget *one : docks)
            QVERIFY(!(one->features() & QDockWidget::DockWidgetMovable));
        QVERIFY(fixture.dock("lessons").titleBarWidget()->sizeHint().height() <= 0);
        QVERIFY(fixture.dock("code").titleBarWidget()->sizeHint().height() > 20);
    }

    void theSceneAloneHasThreeParametersACardAndItsTimeInOneRow()
    {
        LayoutFixture fixture;
        fixture.session.openStep("two", "many");
        auto *timeline = fixture.window.findChild<TimelineStrip *>();
        auto *transport = fixture.window.findChild<TransportBar *>();
        auto *scene = &fixture.view;
        const int before = scene->height();
        const int lessons = fixture.dock("lessons").width(), code = fixture.dock("code").width();
        QVERIFY(!transport->isAncestorOf(timeline));
        fixture.key(Qt::Key_F11);
        for (const QDockWidget *one : fixture.window.findChildren<QDockWidget *>())
            QVERIFY2(one->isHidden(), qPrintable(one->objectName()));
        auto *parameters = fixture.window.findChild<FocusParameters *>();
        QVERIFY(parameters);
        QCOMPARE(parameters->rows().size(), std::size_t{3});
        for (const ParameterRow *row : parameters->rows())
            QVERIFY(row->isVisible());
        QVERIFY(transport->isAncestorOf(timeline));
        QVERIFY(timeline->isVisible() && timeline->height() <= transport->height());
        QVERIFY(transport->rect().contains(timeline->geometry()));
        QVERIFY(scene->height() > before);
        auto *card = fixture.window.findChild<SceneCard *>();
        QVERIFY(card->isVisible());
        fixture.key(Qt::Key_F11);
        QTRY_VERIFY(!fixture.window.findChild<FocusParameters *>());
        QVERIFY(!card->isVisible());
        QVERIFY(!transport->isAncestorOf(timeline));
        QCOMPARE(scene->height(), before);
        QVERIFY(!fixture.dock("lessons").isHidden() && !fixture.dock("code").isHidden());
        QCOMPARE(fixture.dock("lessons").width(), lessons);
        QCOMPARE(fixture.dock("code").width(), code);
    }

    void theParametersAboveTheSceneAreChangedByKeysAndMouse()
    {
        LayoutFixture fixture;
        fixture.key(Qt::Key_F11);
        auto *parameters = fixture.window.findChild<FocusParameters *>();
        ParameterRow *k = parameters->rows().front();
        QCOMPARE(k->parameter().id, QString("k"));
        typeInto(*k->findChild<QAbstractSpinBox *>(), "0.45");
        QCOMPARE(fixture.session.editor().parameter("k"), 0.45);
        fixture.session.editor().setParameter("k", 0.1);
        QTRY_COMPARE(k->findChild<QAbstractSpinBox *>()->text().toDouble(), 0.1);
        fixture.session.openStep("two", "many"); // from within the scene alone
        QCOMPARE(parameters->rows().size(), std::size_t{3});
    }

    void theTimelineInTheRowIsScrubbedLikeTheOther()
    {
        LayoutFixture fixture;
        fixture.goTo(80);
        fixture.key(Qt::Key_F11);
        auto *timeline = fixture.window.findChild<TimelineStrip *>();
        const QPoint place(qRound(timeline->axis().xOf(30)), 25);
        QTest::mouseClick(timeline, Qt::LeftButton, {}, place);
        QTRY_COMPARE(fixture.session.timeline().cursor().frame, timeline->axis().frameAt(place.x()));
        timeline->setFocus();
        QTest::keyClick(timeline, Qt::Key_Right, Qt::ShiftModifier);
        QCOMPARE(fixture.session.timeline().cursor().phase, 1);
    }

    void theCardSaysWhatThereIsToTryUntilItIsDone()
    {
        LayoutFixture fixture;
        fixture.session.openStep("one", "first");
        fixture.key(Qt::Key_F11);
        auto *card = fixture.window.findChild<SceneCard *>();
        QCOMPARE(card->sentence(), QString("Wait five frames."));
        QCOMPARE(card->accessibleName(), QString("The first step: Wait five frames."));
        fixture.session.playback().play();
        QTRY_VERIFY(card->sentence().startsWith("Done"));
        fixture.session.playback().pause();
        fixture.session.openStep("one", "second"); // nothing to try: what the step is about
        QCOMPARE(card->sentence(), QString("A spring pulls the foot to the cross."));
    }

    void theCardLetsTheMouseThrough()
    {
        LayoutFixture fixture;
        fixture.key(Qt::Key_F11);
        auto *card = fixture.window.findChild<SceneCard *>();
        const QPoint middle = card->mapTo(&fixture.window, card->rect().center());
        QVERIFY(fixture.window.childAt(middle) != card &&
                !card->isAncestorOf(fixture.window.childAt(middle)));
    }

    void aPresetEndsTheSceneAloneAndAWindowThatClosesThereKeepsItsPanels()
    {
        {
            LayoutFixture fixture;
            fixture.key(Qt::Key_F11);
            fixture.key(Qt::Key_F6);
            QVERIFY(!fixture.action("sceneOnly").isChecked());
            QVERIFY(!fixture.dock("accuracy").isHidden());
            fixture.key(Qt::Key_F5);
            fixture.key(Qt::Key_F11);
            fixture.window.close();
        }
        LayoutFixture fixture;
        QVERIFY(!fixture.dock("lessons").isHidden());
        QVERIFY(!fixture.dock("code").isHidden());
    }
};

SUITE(tst_layouts, LayoutsTest)
#include "tst_layouts.moc"
