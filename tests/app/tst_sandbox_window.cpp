// Building in the window, with a mouse and with keys alone.

#include "app/model/workbench.h"
#include "app/ui/effects/effect_list.h"
#include "app/ui/effects/effects_panel.h"
#include "app/ui/panels/number_box.h"
#include "app/ui/sandbox/build_panel.h"
#include "app/ui/sandbox/example_gallery.h"
#include "app/ui/sandbox/property_row.h"
#include "app/ui/sandbox/scene_builder.h"
#include "app/ui/scene/scene_view.h"
#include "app/ui/window/main_window.h"
#include "panels_bench.h"
#include "studies.h"

#include <QAction>
#include <QCheckBox>
#include <QLabel>
#include <QPushButton>
#include <QToolButton>
#include <QtTest>

#include <cmath>

using namespace app;

namespace {

struct Bench
{
    explicit Bench(QSize size = {1280, 800}) { show(window, size); }

    Session &session() { return world.session; }
    SceneView &view() const { return *window.findChild<SceneView *>(); }
    Workbench &bench() const { return *window.findChild<Workbench *>(); }
    BuildPanel &panel() const { return *window.findChild<BuildPanel *>(); }
    const sim::Blueprint &plan() const { return bench().plan(); }
    QPoint on(sim::Vec2 place) const { return Camera(view().viewportTransform()).at(place).toPoint(); }

    void build() { window.setMode(MainWindow::Mode::build); }
    void click(sim::Vec2 place, Qt::KeyboardModifiers keys = {})
    {
        QTest::mouseClick(view().viewport(), Qt::LeftButton, keys, on(place));
    }
    void drag(sim::Vec2 from, sim::Vec2 to)
    {
        QTest::mousePress(view().viewport(), Qt::LeftButton, {}, on(from));
        QTest::mouseMove(view().viewport(), on({(from.x + to.x) / 2, (from.y + to.y) / 2}));
        QTest::mouseMove(view().viewport(), on(to));
        QTest::mouseRelease(view().viewport(), Qt::LeftButton, {}, on(to));
    }
    void key(int key, Qt::KeyboardModifiers modifiers = {})
    {
        QTest::keyClick(&view(), Qt::Key(key), modifiers);
    }
    PropertyRow *row(const QString &id) const
    {
        for (PropertyRow *one : panel().rows()) {
            if (one->property().about.id == id)
                return one;
        }
        return nullptr;
    }
    QCheckBox *effect(const QString &text) const
    {
        for (QCheckBox *one : panel().findChildren<QCheckBox *>()) {
            if (one->text() == text)
                return one;
        }
        return nullptr;
    }
    QPushButton *button(const QString &text) const
    {
        for (QPushButton *one : panel().findChildren<QPushButton *>()) {
            if (one->text() == text)
                return one;
        }
        return nullptr;
    }

    World world{LessonLibrary::load({LESSON_DIR})};
    MainWindow window{world.session, world.theme, noStudy, noCost};
};

bool isNear(sim::Vec2 a, sim::Vec2 b, double most)
{
    return sim::length(a - b) <= most;
}

}

class SandboxWindow : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase() { prepareProgram(); }

    void theWayThereAndBack()
    {
        Bench bench;
        bench.session().openStep("two_body", "mutual");
        QVERIFY(!bench.panel().isVisible());
        QTest::keyClick(&bench.window, Qt::Key_F7);
        QVERIFY(bench.session().isWorkshop());
        QVERIFY(bench.panel().isVisible());
        QVERIFY(bench.window.mode() == MainWindow::Mode::build);
        QTest::mouseClick(bench.button("Lessons"), Qt::LeftButton);
        QCOMPARE(bench.session().step().id, QString("mutual"));
        QVERIFY(bench.window.mode() == MainWindow::Mode::learn);
        QVERIFY(!bench.panel().isVisible());
    }

    void startingAfreshWithALinkChosenAndEnergyOnShow()
    {
        Bench bench;
        bench.build();
        bench.window.showEnergy(true);
        bench.bench().setTool(BuildTool::spring);
        for (const double x : {100.0, 150.0, 200.0, 250.0})
            bench.bench().use({x, 100}, -1);
        QVERIFY(!bench.bench().chosen().springs.empty());
        QCoreApplication::processEvents();
        // The plot of energy is drawn anew before the bench hears of the other scene.
        QTest::keyClick(&bench.window, Qt::Key_R, Qt::ControlModifier);
        QVERIFY(bench.bench().chosen().isEmpty());
        QVERIFY(bench.plan().springs.size() < 3);
    }

    void aSceneIsTakenThereByItsKey()
    {
        Bench bench;
        bench.session().openStep("multi_foot", "any_number");
        QTest::keyClick(&bench.window, Qt::Key_B, Qt::ControlModifier);
        QVERIFY(bench.session().isWorkshop());
        QCOMPARE(bench.plan().points.size(), std::size_t(6));
        QVERIFY(bench.panel().isVisible());
        QTest::keyClick(&bench.window, Qt::Key_F5);
        QCOMPARE(bench.session().step().id, QString("any_number"));
    }

    void thePictureStaysUnderThePointerAsLongAsAllIsSeen()
    {
        Bench bench;
        bench.build();
        const auto stage = [&] { return bench.session().picture().look->stage; };
        const QRectF before = stage();
        const QPoint middle = bench.on({270, 200});
        bench.key(Qt::Key_P);
        const QPointF nearTop(bench.view().viewport()->width() / 2.0, 40.0);
        bench.click(Camera(bench.view().viewportTransform()).back(nearTop));
        QVERIFY(stage() != before); // else nothing would have moved anyway
        QCOMPARE(bench.on({270, 200}), middle);
        bench.session().setParameter("floor", 900); // is not seen, and the next part shows it
        bench.click(Camera(bench.view().viewportTransform()).back({nearTop.x(), 2.0}));
        QVERIFY(bench.on({270, 200}) != middle);
        QVERIFY(bench.view().viewport()->rect().contains(bench.on({270, 900})));
    }

    void linksAreDraggedOneAfterTheOther()
    {
        Bench bench;
        bench.build();
        bench.key(Qt::Key_P);
        for (const sim::Vec2 place : {sim::Vec2{100, 100}, {160, 100}, {130, 50}})
            bench.click(place);
        bench.key(Qt::Key_T);
        bench.drag({100, 100}, {160, 100});
        bench.drag({160, 100}, {130, 50}); // from where the last one ended
        bench.drag({130, 50}, {100, 100});
        QCOMPARE(bench.plan().sticks.size(), std::size_t(3));
        QVERIFY(bench.bench().first());
        bench.click({100, 100}); // there a click ends it
        QVERIFY(!bench.bench().first());
    }

    void aMouseBuilds()
    {
        Bench bench;
        bench.build();
        const std::size_t points = bench.plan().points.size();
        bench.key(Qt::Key_P);
        bench.click({100, 100});
        bench.click({160, 100});
        QCOMPARE(bench.plan().points.size(), points + 2);
        QVERIFY(isNear(bench.plan().points[points].x, {100, 100}, 1.5));
        bench.key(Qt::Key_S);
        bench.click({100, 100});
        bench.click({160, 100});
        QCOMPARE(bench.plan().springs.size(), std::size_t(2));
        QVERIFY(bench.bench().first()); // the next one would go on from here
        bench.key(Qt::Key_Escape);
        QVERIFY(!bench.bench().first());
        bench.key(Qt::Key_T);
        bench.drag({160, 100}, {220, 140}); // in one drag, to a point that is made
        QCOMPARE(bench.plan().sticks.size(), std::size_t(1));
        QCOMPARE(bench.plan().points.size(), points + 3);
        bench.key(Qt::Key_Escape);
        bench.key(Qt::Key_N);
        bench.click({100, 100});
        QVERIFY(bench.plan().points[points].fixed);
        bench.key(Qt::Key_F);
        bench.click({220, 140});
        bench.click({220, 200});
        QCOMPARE(bench.plan().feet.size(), std::size_t(1));
        QCOMPARE(bench.plan().gaits.size(), std::size_t(1));
    }

    void aMouseChoosesAndDrags()
    {
        Bench bench;
        bench.build();
        const sim::Vec2 place = bench.plan().points[1].x;
        bench.drag(place, {place.x + 40, place.y - 20});
        QVERIFY(isNear(bench.plan().points[1].x, {place.x + 40, place.y - 20}, 2.5));
        QCOMPARE(bench.session().deeds().count(), 1);                               // one drag, one entry
        QCOMPARE(bench.session().timeline().script().input.size(), std::size_t(0)); // no hand did it
        bench.click({10, 10});
        QVERIFY(bench.bench().chosen().isEmpty());
        const sim::Vec2 middle = 0.5 * (bench.plan().points[0].x + bench.plan().points[1].x);
        bench.click(middle);
        QVERIFY(bench.bench().chosen() == (Chosen{{}, {0}, {}}));
        bench.drag({200, 20}, {500, 300}); // a box
        QVERIFY(bench.bench().chosen() == (Chosen{{0, 1}, {0}, {}}));
        bench.click(bench.plan().points[0].x, Qt::ShiftModifier);
        QVERIFY(bench.bench().chosen() == (Chosen{{1}, {0}, {}}));
    }

    void keysAloneBuild()
    {
        Bench bench;
        bench.build();
        bench.view().setFocus();
        const std::size_t points = bench.plan().points.size();
        bench.key(Qt::Key_P);
        bench.key(Qt::Key_Left);
        bench.key(Qt::Key_Return);
        QCOMPARE(bench.plan().points.size(), points + 1);
        QVERIFY(bench.session().timeline().at() == sim::Cursor{}); // no arrow went to the timeline
        bench.key(Qt::Key_S);
        bench.key(Qt::Key_Return); // begins at the point that the cross is on
        QVERIFY(bench.bench().first());
        for (int i = 0; i < 5; ++i)
            bench.key(Qt::Key_Right);
        bench.key(Qt::Key_Down, Qt::ShiftModifier);
        bench.key(Qt::Key_Return);
        QCOMPARE(bench.plan().points.size(), points + 2);
        QCOMPARE(bench.plan().springs.size(), std::size_t(2));
        const sim::Vec2 way = bench.plan().points[points + 1].x - bench.plan().points[points].x;
        QVERIFY(isNear(way, {50, 1}, 1e-9));
        bench.key(Qt::Key_Escape);
        bench.key(Qt::Key_Escape);
        QVERIFY(bench.bench().tool() == BuildTool::select);
        bench.key(Qt::Key_BracketRight);
        const std::vector<int> chosen = bench.bench().chosen().points;
        QCOMPARE(chosen.size(), std::size_t(1));
        const sim::Vec2 before = bench.plan().points[std::size_t(chosen[0])].x;
        bench.key(Qt::Key_Right, Qt::AltModifier);
        QVERIFY(isNear(bench.plan().points[std::size_t(chosen[0])].x, {before.x + 10, before.y}, 1e-9));
        bench.key(Qt::Key_BraceRight, Qt::ShiftModifier);
        QCOMPARE(bench.bench().chosen().springs.size(), std::size_t(1));
        QTest::keyClick(&bench.window, Qt::Key_Delete);
        QCOMPARE(bench.plan().springs.size(), std::size_t(1));
        QTest::keyClick(&bench.window, Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(bench.plan().springs.size(), std::size_t(2));
        QTest::keyClick(&bench.window, Qt::Key_A, Qt::ControlModifier);
        QTest::keyClick(&bench.window, Qt::Key_J, Qt::ControlModifier);
        QCOMPARE(bench.plan().points.size(), 2 * (points + 2));
    }

    void whatIsChosenIsSetInItsFields()
    {
        Bench bench;
        bench.build();
        bench.click(bench.plan().points[1].x);
        PropertyRow *mass = bench.row("mass");
        QVERIFY(mass);
        type(*mass->findChild<NumberBox *>(), "2.5");
        QCOMPARE(bench.plan().points[1].mass, 2.5);
        type(*bench.row("size")->findChild<NumberBox *>(), "5000"); // too wide
        QCOMPARE(bench.plan().points[1].size, 1000.0);
        bench.session().undo();
        QCOMPARE(bench.plan().points[1].size, 24.0);
        QTest::mouseClick(bench.row("fixed")->findChild<QCheckBox *>(), Qt::LeftButton, {}, {8, 8});
        QVERIFY(!bench.plan().points[1].fixed); // nothing could move then: refused
        QVERIFY(!bench.row("fixed")->findChild<QCheckBox *>()->isChecked());
        const sim::Vec2 middle = 0.5 * (bench.plan().points[0].x + bench.plan().points[1].x);
        bench.click(middle);
        type(*bench.row("k")->findChild<NumberBox *>(), "0.3");
        QCOMPARE(bench.plan().springs[0].k, 0.3);
        for (const PropertyRow *row : bench.panel().rows())
            QVERIFY(!row->toolTip().isEmpty());
    }

    void whatDiffersShowsNoNumberUntilOneIsTyped()
    {
        Bench bench;
        bench.build();
        QTest::keyClick(&bench.window, Qt::Key_A, Qt::ControlModifier);
        NumberBox &size = *bench.row("size")->findChild<NumberBox *>();
        QCOMPARE(size.text(), QString());
        QTest::keyClick(&size, Qt::Key_Up); // from no number to no other
        size.clearFocus();
        QCOMPARE(bench.session().deeds().count(), 0);
        NumberBox &x = *bench.row("x")->findChild<NumberBox *>();
        type(x, "0");
        QCOMPARE(x.text(), QString("0"));
        for (const sim::BuiltPoint &one : bench.plan().points)
            QCOMPARE(one.x.x, 0.0);
        bench.session().undo();
        QCOMPARE(bench.plan().points[1].x.x, 340.0);
    }

    void theToolInHandSaysWhatToClick()
    {
        Bench bench;
        bench.build();
        bench.click(bench.plan().points[1].x);
        bench.key(Qt::Key_F);
        const QLabel *hint = nullptr;
        for (const QLabel *one : bench.panel().findChildren<QLabel *>()) {
            if (one->isVisible() && one->text() == "Click a body, then each of its feet.")
                hint = one;
        }
        QVERIFY(hint); // though what is chosen has properties
        QTRY_VERIFY(bench.row("mass")->isVisible());
        bench.click(bench.plan().points[1].x);
        QVERIFY2(bench.panel().hint().startsWith("Click each of its feet"), qPrintable(bench.panel().hint()));
    }

    void aRampIsPlacedByItsNumbersAndHoldsWhatFalls()
    {
        Bench bench;
        bench.build();
        const auto colorAt = [&](sim::Vec2 place) {
            return bench.view().picture().pixelColor(bench.on(place));
        };
        const QColor air = colorAt({105, 305});
        QTest::mouseClick(bench.effect("Ramp"), Qt::LeftButton, {}, {8, 8});
        const ParameterPanel &numbers = *bench.window.findChild<ParameterPanel *>();
        type(*rowOf(numbers, "ramp")->findChild<NumberBox *>(), "-30");
        type(*rowOf(numbers, "ramp_x")->findChild<NumberBox *>(), "100");
        type(*rowOf(numbers, "ramp_y")->findChild<NumberBox *>(), "200");
        QVERIFY(colorAt({105, 305}) != air); // it falls to the right from there: that place is inside
        QCOMPARE(colorAt({405, 305}), air);
        bench.session().goTo({200, 0});
        const sim::State &now = bench.session().timeline().now();
        const sim::Vec2 from = now.at(1) - sim::Vec2{100, 200};
        const double rad = 30.0 / 180.0 * 3.141592653589793;
        QVERIFY(from.x * std::sin(rad) - from.y * std::cos(rad) > 12.0 - 1e-6); // half of its width
        bench.session().rewind();
        bench.session().undo();
        bench.session().undo();
        bench.session().undo();
        bench.session().undo();
        QVERIFY(!bench.bench().has("ramp"));
        QCOMPARE(colorAt({105, 305}), air);
    }

    void buildingWaitsForTheStart()
    {
        Bench bench;
        bench.build();
        bench.session().goTo({12, 0});
        QVERIFY(bench.panel().hint().contains("frame 12"));
        const std::size_t points = bench.plan().points.size();
        bench.key(Qt::Key_P);
        bench.click({100, 100});
        QCOMPARE(bench.plan().points.size(), points);
        QTest::mouseClick(bench.button("Go to the start"), Qt::LeftButton);
        bench.click({100, 100});
        QCOMPARE(bench.plan().points.size(), points + 1);
    }

    void aHandStillTakesWhatMoves()
    {
        Bench bench;
        bench.build();
        bench.session().goTo({5, 0});
        const sim::State &now = bench.session().timeline().now();
        const sim::Vec2 place = now.at(1);
        bench.drag(place, {place.x + 50, place.y});
        QVERIFY(!bench.session().timeline().script().input.empty());
    }

    void effectsAreChosenInThePanelAndInTheLedger()
    {
        Bench bench;
        bench.build();
        QCheckBox *wind = bench.effect("Wind");
        QVERIFY(wind && !wind->isChecked());
        QVERIFY(!rowOf(*bench.window.findChild<ParameterPanel *>(), "wind"));
        QTest::mouseClick(wind, Qt::LeftButton, {}, {8, 8});
        QVERIFY(bench.bench().has("breeze"));
        QVERIFY(rowOf(*bench.window.findChild<ParameterPanel *>(), "wind"));
        bench.window.showEffects(true);
        EffectsPanel &ledger = *bench.window.findChild<EffectsPanel *>();
        EffectListModel &lines = ledger.findChild<EffectList *>()->lines();
        const auto rowOfLine = [&](const QString &id) {
            for (int i = 0; i < lines.rowCount(); ++i) {
                if (lines.lines()[std::size_t(i)].id == id)
                    return i;
            }
            return -1;
        };
        QTRY_VERIFY(rowOfLine("push") >= 0);
        QVERIFY(lines.lines()[std::size_t(rowOfLine("push"))].role == EffectRole::offered);
        lines.setData(lines.index(rowOfLine("push")), Qt::Checked, Qt::CheckStateRole);
        QTRY_VERIFY(bench.bench().has("push"));
        bench.session().undo();
        QVERIFY(!bench.bench().has("push"));
    }

    void anExampleIsOneClickAway()
    {
        Bench bench;
        bench.build();
        QTest::mouseClick(bench.button("Examples"), Qt::LeftButton);
        ExampleGallery &gallery = bench.panel().gallery();
        QVERIFY(gallery.isVisible());
        QCOMPARE(gallery.cards().size(), std::size_t(10));
        QTest::keyClick(gallery.cards()[0], Qt::Key_Right);
        QTest::mouseClick(gallery.cards()[2], Qt::LeftButton);
        QVERIFY(!gallery.isVisible());
        QCOMPARE(bench.plan().points.size(), std::size_t(30)); // the jelly
        bench.session().undo();
        QCOMPARE(bench.plan().points.size(), std::size_t(2));
    }

    void everythingHasAName()
    {
        Bench bench;
        bench.build();
        bench.click(bench.plan().points[1].x);
        for (const QWidget *one : bench.panel().findChildren<QWidget *>()) {
            const bool isControl =
                qobject_cast<const QAbstractButton *>(one) || qobject_cast<const QAbstractSpinBox *>(one);
            if (!isControl || !one->isVisible())
                continue;
            const auto *button = qobject_cast<const QAbstractButton *>(one);
            QVERIFY2(!one->accessibleName().isEmpty() || (button && !button->text().isEmpty()),
                     one->metaObject()->className());
            QVERIFY2(!one->toolTip().isEmpty() || !one->parentWidget()->toolTip().isEmpty(),
                     qPrintable(one->accessibleName()));
        }
    }
};

QTEST_MAIN(SandboxWindow)
#include "tst_sandbox_window.moc"
