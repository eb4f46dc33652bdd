// Building in the window: opening the sandbox, fields, effects and examples.

#include "app/ui/code/breakpoint_list.h"
#include "app/ui/parameters/grouped_choice.h"
#include "app/ui/time/transport_bar.h"
#include "tests/app/sandbox/sandbox_support.h"
#include "tests/suite.h"

#include <QLineEdit>
#include <QMenu>

using namespace app;
using namespace tests;
using namespace sandbox_support;

class SandboxWindow : public QObject
{
    Q_OBJECT

private slots:
    void aLengthThatADragLeftIsShownRounded()
    {
        SandboxFixture fixture;
        fixture.build();
        fixture.key(Qt::Key_S);
        fixture.drag({100, 100}, {190, 160});
        fixture.key(Qt::Key_V);
        const double length = fixture.plan().springs.back().length;
        QVERIFY(length != std::round(length));
        const auto *box = fixture.row("length")->findChild<NumberBox *>();
        QVERIFY2(!box->text().contains(QChar(0x2026)), qPrintable(box->text()));
        QVERIFY(std::abs(box->text().toDouble() - length) < 0.01);
        QVERIFY2(box->toolTip().contains(box->exactText(length)), qPrintable(box->toolTip()));
        fixture.click({100, 100}); // looking elsewhere and back changes nothing
        QCOMPARE(fixture.plan().springs.back().length, length);
    }

    void theTorturePanelAsksForACaseByItsKind()
    {
        SandboxFixture fixture;
        fixture.session.openStep("hard_cases", "torture");
        const QList<GroupedChoice *> all = fixture.window.findChildren<GroupedChoice *>();
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
        QCOMPARE(fixture.session.editor().parameter("case"), double(choice->currentIndex()));
        QCOMPARE(fixture.session.editor().undoStack().undoText(), QString("Change case"));
    }

    void keyOpensTheSandboxAndAButtonReturnsToTheLesson()
    {
        SandboxFixture fixture;
        fixture.session.openStep("two_body", "mutual");
        QVERIFY(!fixture.panel().isVisible());
        QTest::keyClick(&fixture.window, Qt::Key_F7);
        QVERIFY(fixture.session.isSandbox());
        QVERIFY(fixture.panel().isVisible());
        QVERIFY(fixture.window.mode() == MainWindow::Mode::build);
        QTest::mouseClick(fixture.button("Lessons"), Qt::LeftButton);
        QCOMPARE(fixture.session.step().id, QString("mutual"));
        QVERIFY(fixture.window.mode() == MainWindow::Mode::learn);
        QVERIFY(!fixture.panel().isVisible());
    }

    void theExampleOfAConditionNamesABodyThatIsThere()
    {
        SandboxFixture fixture;
        fixture.session.openStep("single_spring", "fixed_centre");
        QTest::keyClick(&fixture.window, Qt::Key_B, Qt::ControlModifier);
        const auto *field = fixture.window.findChild<BreakpointList *>()->field();
        QVERIFY2(field->placeholderText().contains("(foot.y"), qPrintable(field->placeholderText()));
        QTest::mouseClick(fixture.button("New"), Qt::LeftButton);
        QVERIFY2(field->placeholderText().contains("(p0.y"), qPrintable(field->placeholderText()));
    }

    void afterANumberIsTypedAndPlayingBegunSpaceStops()
    {
        SandboxFixture fixture;
        fixture.build();
        fixture.click(fixture.plan().points[1].x);
        auto *box = fixture.row("mass")->findChild<NumberBox *>();
        QTRY_VERIFY(box->isVisible());
        QTest::mouseClick(box, Qt::LeftButton);
        box->selectAll();
        QTest::keyClicks(box, "2");
        QTest::mouseClick(fixture.window.findChild<TransportBar *>()->findChild<QAbstractButton *>("play"),
                          Qt::LeftButton);
        QTRY_VERIFY(fixture.session.playback().isPlaying());
        QTRY_VERIFY(!box->isVisible());
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Space);
        QVERIFY(!QApplication::activePopupWidget());
        QVERIFY(!fixture.session.playback().isPlaying());
    }

    void selectedToolIsReadableInEveryScheme_data()
    {
        QTest::addColumn<Scheme>("scheme");
        QTest::newRow("light") << Scheme::light;
        QTest::newRow("dark") << Scheme::dark;
        QTest::newRow("high contrast") << Scheme::highContrast;
    }
    void selectedToolIsReadableInEveryScheme()
    {
        QFETCH(const Scheme, scheme);
        SandboxFixture fixture;
        fixture.build();
        fixture.theme.setScheme(scheme);
        QCoreApplication::processEvents();
        const auto tools = fixture.panel().findChildren<QToolButton *>("tool");
        QVERIFY(tools.size() > 5);
        for (QToolButton *tool : tools) {
            tool->click();
            QCOMPARE(tool->isChecked(), tool->isCheckable()); // the last two are commands, not tools
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

    void restartClearsASelectedLinkWhileEnergyIsVisible()
    {
        SandboxFixture fixture;
        fixture.build();
        fixture.window.docks().show(Panel::energy, true);
        const std::size_t springs = fixture.plan().springs.size();
        fixture.editor().setTool(BuildTool::spring);
        for (const double x : {100.0, 150.0, 200.0, 250.0})
            fixture.editor().use({x, 100}, -1);
        QVERIFY(!fixture.editor().chosen().springs.empty());
        QCoreApplication::processEvents();
        // The energy plot is drawn again before the build panel is told about the new scene.
        QTest::keyClick(&fixture.window, Qt::Key_R, Qt::ControlModifier);
        QVERIFY(fixture.editor().chosen().isEmpty());
        QCOMPARE(fixture.plan().springs.size(), springs);
    }

    void aSceneIsTakenThereByItsKey()
    {
        SandboxFixture fixture;
        fixture.session.openStep("multi_foot", "any_number");
        QTest::keyClick(&fixture.window, Qt::Key_B, Qt::ControlModifier);
        QVERIFY(fixture.session.isSandbox());
        QCOMPARE(fixture.plan().points.size(), std::size_t(6));
        QVERIFY(fixture.panel().isVisible());
        QTest::keyClick(&fixture.window, Qt::Key_F5);
        QCOMPARE(fixture.session.step().id, QString("any_number"));
    }

    void fieldsSetThePropertiesOfTheSelection()
    {
        SandboxFixture fixture;
        fixture.build();
        fixture.click(fixture.plan().points[1].x);
        PropertyRow *mass = fixture.row("mass");
        QVERIFY(mass);
        typeInto(*mass->findChild<NumberBox *>(), "2.5");
        QCOMPARE(fixture.plan().points[1].mass, 2.5);
        typeInto(*fixture.row("size")->findChild<NumberBox *>(), "5000"); // too wide
        QCOMPARE(fixture.plan().points[1].size, 1000.0);
        fixture.session.editor().undo();
        QCOMPARE(fixture.plan().points[1].size, 24.0);
        QTest::mouseClick(fixture.row("fixed")->findChild<QCheckBox *>(), Qt::LeftButton, {}, {8, 8});
        QVERIFY(!fixture.plan().points[1].fixed); // nothing could move then: refused
        QVERIFY(!fixture.row("fixed")->findChild<QCheckBox *>()->isChecked());
        const sim::Vec2 middle = 0.5 * (fixture.plan().points[0].x + fixture.plan().points[1].x);
        fixture.click(middle);
        typeInto(*fixture.row("k")->findChild<NumberBox *>(), "0.3");
        QCOMPARE(fixture.plan().springs[0].k, 0.3);
        for (const PropertyRow *row : fixture.panel().rows())
            QVERIFY(!row->toolTip().isEmpty());
    }

    void differingPropertiesShowNoNumberUntilOneIsTyped()
    {
        SandboxFixture fixture;
        fixture.build();
        QTest::keyClick(&fixture.window, Qt::Key_A, Qt::ControlModifier);
        NumberBox &size = *fixture.row("size")->findChild<NumberBox *>();
        QCOMPARE(size.text(), QString());
        QTest::keyClick(&size, Qt::Key_Up); // from no number to no other
        size.clearFocus();
        QCOMPARE(fixture.session.editor().undoStack().count(), 0);
        NumberBox &x = *fixture.row("x")->findChild<NumberBox *>();
        typeInto(x, "0");
        QCOMPARE(x.text(), QString("0"));
        for (const sim::BlueprintPoint &one : fixture.plan().points)
            QCOMPARE(one.x.x, 0.0);
        fixture.session.editor().undo();
        QCOMPARE(fixture.plan().points[1].x.x, 340.0);
    }

    void aRampIsPlacedByItsNumbersAndHoldsWhatFalls()
    {
        SandboxFixture fixture;
        fixture.build();
        const auto colorAt = [&](sim::Vec2 place) {
            return fixture.view.picture().pixelColor(fixture.on(place));
        };
        const QColor air = colorAt({105, 305});
        QTest::mouseClick(fixture.effect("Ramp"), Qt::LeftButton, {}, {8, 8});
        const ParameterPanel &numbers = *fixture.window.findChild<ParameterPanel *>();
        typeInto(*rowOf(numbers, "ramp")->findChild<NumberBox *>(), "-30");
        typeInto(*rowOf(numbers, "ramp_x")->findChild<NumberBox *>(), "100");
        typeInto(*rowOf(numbers, "ramp_y")->findChild<NumberBox *>(), "200");
        QVERIFY(colorAt({105, 305}) != air); // it falls to the right from there: that place is inside
        QCOMPARE(colorAt({405, 305}), air);
        fixture.goTo(200);
        const sim::State &now = fixture.session.timeline().state();
        const sim::Vec2 from = now.positionOf(1) - sim::Vec2{100, 200};
        const double rad = 30.0 / 180.0 * 3.141592653589793;
        QVERIFY(from.x * std::sin(rad) - from.y * std::cos(rad) > 12.0 - 1e-6); // half of its width
        fixture.session.editor().restart();
        fixture.session.editor().undo();
        fixture.session.editor().undo();
        fixture.session.editor().undo();
        fixture.session.editor().undo();
        QVERIFY(!fixture.editor().has("ramp"));
        QCOMPARE(colorAt({105, 305}), air);
    }

    void buildingWaitsForTheStart()
    {
        SandboxFixture fixture;
        fixture.build();
        fixture.goTo(12);
        QVERIFY(fixture.panel().hint().contains("frame 12"));
        fixture.session.playback().play();
        QVERIFY(fixture.panel().hint().startsWith("The scene is playing"));
        fixture.session.playback().pause();
        QVERIFY2(!fixture.panel().hint().startsWith("The scene is playing"),
                 qPrintable(fixture.panel().hint()));
        const std::size_t points = fixture.plan().points.size();
        fixture.key(Qt::Key_P);
        fixture.click({100, 100});
        QCOMPARE(fixture.plan().points.size(), points);
        QTest::mouseClick(fixture.button("Go to the start"), Qt::LeftButton);
        fixture.click({100, 100});
        QCOMPARE(fixture.plan().points.size(), points + 1);
    }

    void movingBodyCanBeDragged()
    {
        SandboxFixture fixture;
        fixture.build();
        fixture.goTo(5);
        const sim::State &now = fixture.session.timeline().state();
        const sim::Vec2 place = now.positionOf(1);
        fixture.drag(place, {place.x + 50, place.y});
        const std::vector<sim::Event> &input = fixture.session.timeline().script().input;
        QVERIFY(!input.empty());
        QVERIFY(input.front().what == decltype(sim::Event::what)(sim::Grab{fixture.plan().points[1].name}));
    }

    void effectsAreChosenInThePanelAndInTheLedger()
    {
        SandboxFixture fixture;
        fixture.build();
        QCheckBox *wind = fixture.effect("Wind");
        QVERIFY(wind && !wind->isChecked());
        QVERIFY(!rowOf(*fixture.window.findChild<ParameterPanel *>(), "wind"));
        QTest::mouseClick(wind, Qt::LeftButton, {}, {8, 8});
        QVERIFY(fixture.editor().has("breeze"));
        QVERIFY(rowOf(*fixture.window.findChild<ParameterPanel *>(), "wind"));
        fixture.window.docks().show(Panel::effects, true);
        EffectsPanel &ledger = *fixture.window.findChild<EffectsPanel *>();
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
        QTRY_VERIFY(fixture.editor().has("push"));
        fixture.session.editor().undo();
        QVERIFY(!fixture.editor().has("push"));
    }

    void anExampleIsOneClickAway()
    {
        SandboxFixture fixture;
        fixture.build();
        QTest::mouseClick(fixture.button("Examples"), Qt::LeftButton);
        ExampleGallery &gallery = fixture.panel().gallery();
        QVERIFY(gallery.isVisible());
        QCOMPARE(gallery.cards().size(), fixture.session.step().examples.size());
        QTest::keyClick(gallery.cards()[0], Qt::Key_Right);
        QTest::mouseClick(gallery.cards()[2], Qt::LeftButton);
        QVERIFY(!gallery.isVisible());
        QCOMPARE(fixture.plan().points.size(), std::size_t(30)); // the jelly
        fixture.session.editor().undo();
        QCOMPARE(fixture.plan().points.size(), std::size_t(2));
    }

    void everythingHasAName()
    {
        SandboxFixture fixture;
        fixture.build();
        fixture.click(fixture.plan().points[1].x);
        int seen = 0;
        for (const QWidget *one : fixture.panel().findChildren<QWidget *>()) {
            const bool isControl =
                qobject_cast<const QAbstractButton *>(one) || qobject_cast<const QAbstractSpinBox *>(one);
            if (!isControl || !one->isVisible())
                continue;
            ++seen;
            const auto *button = qobject_cast<const QAbstractButton *>(one);
            QVERIFY2(!one->accessibleName().isEmpty() || (button && !button->text().isEmpty()),
                     one->metaObject()->className());
            QVERIFY2(!one->toolTip().isEmpty() || !one->parentWidget()->toolTip().isEmpty(),
                     qPrintable(one->accessibleName()));
        }
        QVERIFY(seen > 0);
    }
};

SUITE(tst_sandbox_window, SandboxWindow)
#include "tst_sandbox_window.moc"
