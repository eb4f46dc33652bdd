// Building in the window: the way there, fields, effects, examples.

#include "app/ui/code/stop_list.h"
#include "app/ui/panels/grouped_choice.h"
#include "app/ui/time/transport_bar.h"
#include "sandbox_bench.h"

#include <QLineEdit>
#include <QMenu>

using namespace app;
using namespace sandbox_bench;

class SandboxWindow : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase() { prepareProgram(); }

    void aLengthThatADragLeftIsShownRounded()
    {
        Bench bench;
        bench.build();
        bench.key(Qt::Key_S);
        bench.drag({100, 100}, {190, 160});
        bench.key(Qt::Key_V);
        const double length = bench.plan().springs.back().length;
        QVERIFY(length != std::round(length));
        const auto *box = bench.row("length")->findChild<NumberBox *>();
        QVERIFY2(!box->text().contains(QChar(0x2026)), qPrintable(box->text()));
        QVERIFY(std::abs(box->text().toDouble() - length) < 0.01);
        QVERIFY2(box->toolTip().contains(box->exactText(length)), qPrintable(box->toolTip()));
        bench.click({100, 100}); // looking elsewhere and back changes nothing
        QCOMPARE(bench.plan().springs.back().length, length);
    }

    void theTorturePanelAsksForACaseByItsKind()
    {
        Bench bench;
        bench.session().openStep("hard_cases", "torture");
        const QList<GroupedChoice *> all = bench.window.findChildren<GroupedChoice *>();
        QVERIFY(!all.isEmpty());
        QTRY_VERIFY(std::any_of(all.begin(), all.end(), [](const auto *one) { return one->isVisible(); }));
        GroupedChoice *choice =
            *std::find_if(all.begin(), all.end(), [](const auto *one) { return one->isVisible(); });
        const QString before = choice->currentText();
        QTest::mouseClick(choice, Qt::LeftButton);
        auto *menu = choice->findChild<QMenu *>(QString(), Qt::FindDirectChildrenOnly);
        QVERIFY(menu && menu->isVisible());
        int cases = 0;
        QMenu *other = nullptr;
        for (const QAction *group : menu->actions()) {
            QVERIFY(group->menu());
            QVERIFY2(group->menu()->actions().size() <= 15, qPrintable(group->text()));
            cases += static_cast<int>(group->menu()->actions().size());
            if (group != menu->activeAction())
                other = group->menu();
        }
        QCOMPARE(cases, choice->count());
        QVERIFY(menu->actions().size() >= 6);
        const QString wanted = other->actions().front()->text();
        menu->setActiveAction(other->menuAction());
        QTest::keyClick(menu, Qt::Key_Right);
        QTest::keyClick(other, Qt::Key_Return);
        QCOMPARE(choice->currentText(), wanted);
        QVERIFY(wanted != before);
        QCOMPARE(bench.session().parameter("case"), double(choice->currentIndex()));
        QCOMPARE(bench.session().deeds().undoText(), QString("Change case"));
    }

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

    void theExampleOfAConditionNamesABodyThatIsThere()
    {
        Bench bench;
        bench.session().openStep("single_spring", "fixed_centre");
        QTest::keyClick(&bench.window, Qt::Key_B, Qt::ControlModifier);
        const auto *field = bench.window.findChild<StopList *>()->field();
        QVERIFY2(field->placeholderText().contains("(foot.y"), qPrintable(field->placeholderText()));
        QTest::mouseClick(bench.button("New"), Qt::LeftButton);
        QVERIFY2(field->placeholderText().contains("(p0.y"), qPrintable(field->placeholderText()));
    }

    void afterANumberIsTypedAndPlayingBegunSpaceStops()
    {
        Bench bench;
        bench.build();
        bench.click(bench.plan().points[1].x);
        auto *box = bench.row("mass")->findChild<NumberBox *>();
        QTRY_VERIFY(box->isVisible());
        QTest::mouseClick(box, Qt::LeftButton);
        box->selectAll();
        QTest::keyClicks(box, "2");
        QTest::mouseClick(bench.window.findChild<TransportBar *>()->findChild<QAbstractButton *>("play"),
                          Qt::LeftButton);
        QTRY_VERIFY(bench.session().isPlaying());
        QTRY_VERIFY(!box->isVisible());
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Space);
        QVERIFY(!QApplication::activePopupWidget());
        QVERIFY(!bench.session().isPlaying());
    }

    void theToolInHandIsReadInEveryScheme_data()
    {
        QTest::addColumn<Scheme>("scheme");
        QTest::newRow("light") << Scheme::light;
        QTest::newRow("dark") << Scheme::dark;
        QTest::newRow("high contrast") << Scheme::highContrast;
    }
    void theToolInHandIsReadInEveryScheme()
    {
        QFETCH(const Scheme, scheme);
        Bench bench;
        bench.build();
        bench.world.theme.setScheme(scheme);
        QCoreApplication::processEvents();
        for (QToolButton *tool : bench.panel().findChildren<QToolButton *>("tool")) {
            tool->click();
            QVERIFY(tool->isChecked());
            const QImage image = tool->grab().toImage();
            const int ground = qGray(image.pixel(image.width() / 2, 4));
            for (const bool upper : {true, false}) { // icon and name
                int ink = 0;
                for (int y = upper ? 6 : 28; y < (upper ? 26 : 44); ++y) {
                    for (int x = 8; x < image.width() - 8; ++x)
                        ink += std::abs(qGray(image.pixel(x, y)) - ground) > 80 ? 1 : 0;
                }
                QVERIFY2(ink > 15, qPrintable(QString("%1: %2").arg(tool->text()).arg(ink)));
            }
        }
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
        for (const sim::BlueprintPoint &one : bench.plan().points)
            QCOMPARE(one.x.x, 0.0);
        bench.session().undo();
        QCOMPARE(bench.plan().points[1].x.x, 340.0);
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
        const sim::State &now = bench.session().timeline().state();
        const sim::Vec2 from = now.positionOf(1) - sim::Vec2{100, 200};
        const double rad = 30.0 / 180.0 * 3.141592653589793;
        QVERIFY(from.x * std::sin(rad) - from.y * std::cos(rad) > 12.0 - 1e-6); // half of its width
        bench.session().restart();
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
        bench.session().play();
        QVERIFY(bench.panel().hint().startsWith("The scene plays"));
        bench.session().pause();
        QVERIFY2(!bench.panel().hint().startsWith("The scene plays"), qPrintable(bench.panel().hint()));
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
        const sim::State &now = bench.session().timeline().state();
        const sim::Vec2 place = now.positionOf(1);
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
        QCOMPARE(gallery.cards().size(), bench.session().step().examples.size());
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
