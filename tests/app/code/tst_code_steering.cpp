#include "app/model/code/code_values.h"
#include "app/ui/code/breakpoint_list.h"
#include "app/ui/code/engine/code_card.h"
#include "tests/app/code/steering_support.h"
#include "tests/app/support/waiting.h"
#include "tests/suite.h"

#include <QClipboard>
#include <QMenu>
#include <QSignalSpy>

using namespace steering_support;
using namespace tests;

/// Commands and questions about the run that start in the code itself.
class TestCodeSteering : public QObject
{
    Q_OBJECT

private slots:
    void aClickOnALineRunsToItsPhase_data()
    {
        QTest::addColumn<bool>("keyboard");
        QTest::newRow("mouse") << false;
        QTest::newRow("Enter") << true;
    }
    void aClickOnALineRunsToItsPhase()
    {
        QFETCH(bool, keyboard);
        SteeringFixture shown;
        const auto run = [&](const QString &line) {
            shown.goToRow(line);
            if (keyboard)
                shown.key(Qt::Key_Return);
            else
                QTest::mouseClick(shown.view().viewport(), Qt::LeftButton, {},
                                  shown.view().rowRect(shown.row(line)).center() + QPoint(-100, 0));
        };
        // Feet: springs, gravity, damping, move, walls; then the body: the same.
        run("Vec2 pull = {0, gravity}");
        QCOMPARE(shown.at(), (sim::Cursor{0, 2}));
        run("v = keep * v");
        QCOMPARE(shown.at(), (sim::Cursor{0, 3}));
        run("Vec2 pull = {0, gravity}");
        QCOMPARE(shown.at(), (sim::Cursor{0, 7}));
        run("Vec2 pull = {0, gravity}");
        QCOMPARE(shown.at(), (sim::Cursor{1, 2}));
        sim::Timeline straight(shown.session.timeline().script());
        straight.seek(shown.at());
        QVERIFY(sim::sameBits(straight.state(), shown.session.timeline().state()));
    }

    void runningToALineOutsideThePhasesShowsAMessage()
    {
        SteeringFixture shown;
        QSignalSpy said(&shown.session.changes(), &ChangeNotifier::messageRequested);
        shown.goToRow("Scene scene");
        shown.key(Qt::Key_Return);
        QCOMPARE(said.count(), 1);
        QVERIFY(said[0][0].toString().contains("before the first frame"));
        QCOMPARE(shown.at(), sim::Cursor{});
    }

    void selectingTextDoesNotRun()
    {
        SteeringFixture shown;
        const QPoint from = shown.middleOf("Vec2 d = target", "Vec2");
        shown.drag(from, 60);
        QVERIFY(shown.view().hasSelectedText());
        QCOMPARE(shown.at(), sim::Cursor{});
    }

    void cardShowsTheNameHistoryAndValueOfAWord()
    {
        SteeringFixture shown;
        for (int i = 0; i < 200; ++i)
            shown.session.playback().frameForward();
        shown.hover(shown.middleOf("pull = k * d", "pull"));
        const CodeCard &card = shown.panel->card();
        QVERIFY(card.isVisible());
        QCOMPARE(card.symbol().name, QString("pull"));
        QCOMPARE(card.history().samples.size(), std::size_t(historyFrames));
        // The value of the moment, as the phase explains it.
        sim::Vec2 pull;
        for (const sim::PhaseExplanation &moment : shown.session.presentation().explanations()) {
            for (const sim::LiveValue &live : moment.live) {
                if (live.name == "pull" && moment.phase == card.symbol().phase)
                    pull = std::get<sim::Vec2>(live.value);
            }
        }
        QVERIFY(card.value().startsWith(shownValue(pull, 3)));
        QVERIFY(card.value().endsWith("px/frame²"));
        QVERIFY(card.accessibleName().contains(card.value()));
        const QString before = card.value();
        shown.session.playback().frameForward();
        QVERIFY(card.isVisible() && card.value() != before);
        shown.session.select("foot2");
        QVERIFY(card.value() != before);
        shown.move({300, 2});
        QVERIFY(!card.isVisible());
    }

    void aCardHasNoTransparentCorners()
    {
        SteeringFixture shown;
        shown.session.playback().frameForward();
        shown.hover(shown.middleOf("pull = k * d", "pull"));
        CodeCard &card = const_cast<CodeCard &>(shown.panel->card());
        QImage image(card.size(), QImage::Format_ARGB32_Premultiplied);
        image.fill(Qt::transparent);
        card.render(&image, {}, {}, {}); // what the card itself paints
        for (const QPoint corner : {QPoint(0, 0), QPoint(card.width() - 1, 0), QPoint(0, card.height() - 1),
                                    QPoint(card.width() - 1, card.height() - 1)})
            QCOMPARE(image.pixelColor(corner).alpha(), 255);
    }

    void theKeyboardAsksForACard()
    {
        SteeringFixture shown;
        shown.session.playback().frameForward();
        shown.goToRow("pull = k * d");
        const QStringList words = {"pull", "k", "d"};
        const QString text = shown.view().rows()[shown.row("pull = k * d")].text;
        QStringList asked;
        for (int i = 0; i < 5; ++i) {
            shown.key(Qt::Key_Right, Qt::ControlModifier);
            shown.key(Qt::Key_I, Qt::ControlModifier);
            if (shown.panel->card().isVisible())
                asked << shown.panel->card().symbol().name;
        }
        asked.removeDuplicates();
        QCOMPARE(asked, words);
        QVERIFY(text.contains("pull"));
        shown.key(Qt::Key_Up);
        QVERIFY(!shown.panel->card().isVisible());
    }

    void cardClosesWhenTheCodeOrTheWindowBecomesInactive()
    {
        SteeringFixture shown;
        shown.session.playback().frameForward();
        shown.goToRow("pull = k * d");
        for (int i = 0; i < 5 && !shown.panel->card().isVisible(); ++i) {
            shown.key(Qt::Key_Right, Qt::ControlModifier);
            shown.key(Qt::Key_I, Qt::ControlModifier);
        }
        QVERIFY(shown.panel->card().isVisible());
        shown.panel->stops().field()->setFocus(Qt::TabFocusReason);
        QVERIFY(!shown.panel->card().isVisible());
        shown.hover(shown.middleOf("pull = k * d", "pull"));
        QVERIFY(shown.panel->card().isVisible());
        QEvent away(QEvent::WindowDeactivate);
        QApplication::sendEvent(&shown.window, &away);
        QVERIFY(!shown.panel->card().isVisible());
    }

    void cardOfAParameterNamesTheParameter()
    {
        SteeringFixture shown;
        shown.hover(shown.middleOf("Vec2 pull = {0, gravity}", "gravity"));
        QVERIFY(shown.panel->card().isVisible());
        QCOMPARE(shown.panel->card().symbol().parameter, QString("gravity"));
        QVERIFY(shown.panel->card().value().startsWith("0.5"));
    }

    void openCardCausesNoRepaint()
    {
        SteeringFixture shown;
        shown.session.playback().frameForward();
        shown.hover(shown.middleOf("pull = k * d", "pull"));
        QVERIFY(shown.panel->card().isVisible());
        QVERIFY(Activity().comesToRest(500));
        QVERIFY(shown.panel->card().isVisible());
    }

    void theMenuCopiesRunsAndStops()
    {
        SteeringFixture shown;
        const std::size_t row = shown.row("Vec2 pull = {0, gravity}");
        const auto act = [&](const QString &text) {
            const std::unique_ptr<QMenu> menu(shown.panel->menuFor(row));
            for (QAction *action : menu->actions()) {
                if (action->text().startsWith(text)) {
                    action->trigger();
                    return true;
                }
            }
            return false;
        };
        QVERIFY(act("Run to here"));
        QCOMPARE(shown.at(), (sim::Cursor{0, 2}));
        QVERIFY(act("Set breakpoint"));
        QCOMPARE(shown.session.playback().breakpoints().all().size(), std::size_t(1));
        QVERIFY(act("Remove breakpoint"));
        QVERIFY(shown.session.playback().breakpoints().all().empty());
        QVERIFY(act("Copy “2 Gravity”"));
        const QString text = QApplication::clipboard()->text();
        QVERIFY(text.contains("// sim/effects/fields/gravity.cpp:"));
        QVERIFY(text.contains("Vec2 fall(double gravity)"));
        QVERIFY(!text.contains("keep"));
        QVERIFY(act("Copy all"));
        QVERIFY(QApplication::clipboard()->text().contains("keep"));
    }

    void upAndDownGoFromLineToLine()
    {
        SteeringFixture shown;
        shown.view().setFocus(Qt::TabFocusReason);
        QCOMPARE(shown.view().row(), std::size_t(0));
        shown.key(Qt::Key_Down);
        QCOMPARE(shown.view().row(), std::size_t(1));
        shown.key(Qt::Key_Down, Qt::ControlModifier);
        QCOMPARE(shown.view().row(), shown.heading("order of the phases"));
        shown.key(Qt::Key_Down); // its lines are folded
        QCOMPARE(shown.view().row(), shown.heading("1 Springs"));
        shown.key(Qt::Key_Up, Qt::ControlModifier);
        shown.key(Qt::Key_Up, Qt::ControlModifier);
        shown.key(Qt::Key_Up, Qt::ControlModifier);
        QCOMPARE(shown.view().row(), std::size_t(0));
    }
};

SUITE(tst_code_steering, TestCodeSteering)
#include "tst_code_steering.moc"
