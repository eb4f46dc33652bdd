// The page where learners write a rule of their own for the scene of the sandbox, with mouse and keys.

#include "app/model/analysis/energy_lines.h"
#include "app/model/sandbox/sandbox.h"
#include "app/ui/code/code_pages.h"
#include "app/ui/code/listing/listing_editor.h"
#include "app/ui/code/listing/rule_panel.h"
#include "tests/app/sandbox/sandbox_support.h"
#include "tests/suite.h"

#include <QTemporaryDir>

#include <algorithm>
#include <map>

using namespace app;
using namespace tests;
using namespace sandbox_support;

namespace {

/// The sandbox with a scene of two free points and no effects: p0 of mass 2 and p1 of mass 1, 100 px apart.
struct RuleFixture : SandboxFixture
{
    static constexpr sim::Vec2 first{100, 200}, second{200, 200};

    RuleFixture()
    {
        build();
        sim::Blueprint plan;
        plan.points = {{.name = "p0", .x = first, .v = {}, .mass = 2.0, .size = 20.0},
                       {.name = "p1", .x = second, .v = {}, .mass = 1.0, .size = 20.0}};
        session.editor().build({"two points", {}, {}}, plan);
        key(Qt::Key_R);
    }

    /// Replaces the whole text by typing, and waits until it is compiled.
    void write(const QString &text)
    {
        rule.editor().setFocus();
        QTest::keyClick(&rule.editor(), Qt::Key_A, Qt::ControlModifier);
        const QStringList lines = text.split('\n');
        for (const QString &line : lines) {
            QTest::keyClicks(&rule.editor(), line);
            if (&line != &lines.back())
                QTest::keyClick(&rule.editor(), Qt::Key_Return);
        }
        compile();
    }
    /// Selects the first `word`, types `by` and waits until it is compiled.
    void replace(const QString &word, const QString &by)
    {
        const QString text = rule.editor().text();
        const auto at = static_cast<int>(text.indexOf(word));
        QVERIFY(at >= 0);
        const auto line = static_cast<int>(text.left(at).count('\n'));
        const auto column = at - static_cast<int>(text.left(at).lastIndexOf('\n')) - 1;
        rule.editor().setFocus();
        rule.editor().setSelection(line, column, line, column + static_cast<int>(word.size()));
        QTest::keyClicks(&rule.editor(), by);
        compile();
    }
    void compile()
    {
        QVERIFY(QTest::qWaitFor([this] { return !rule.editor().isPending(); }));
        settle();
    }
    sim::Vec2 position(const char *body) const
    {
        const sim::Scene &scene = session.timeline().track().interval().scene;
        return session.timeline().state().positionOf(scene.find(body));
    }
    void pressUndo() { QTest::keyClick(&window, Qt::Key_Z, Qt::ControlModifier); }
    void pressRedo() { QTest::keyClick(&window, Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier); }

    CodePages &pages = part<CodePages>();
    RulePanel &rule = pages.rule();
};

/// Returns the position after n = `frames` steps of semi-implicit Euler from rest at `from` with a constant acceleration
/// a. The displacement is a times the sum of 1 to n.
sim::Vec2 fallen(sim::Vec2 from, sim::Vec2 acceleration, int frames)
{
    return from + 0.5 * frames * (frames + 1) * acceleration;
}

const QString push = "Vec2 force(Body me) { return Vec2(0.06, 0.02); }";

}

class RulePanelTest : public QObject
{
    Q_OBJECT

private slots:
    void theKeyROpensThePageAndEscLeavesIt()
    {
        SandboxFixture fixture;
        fixture.build();
        fixture.key(Qt::Key_R);
        RulePanel &rule = fixture.part<CodePages>().rule();
        QCOMPARE(fixture.part<CodePages>().page(), CodePages::Page::rule);
        QVERIFY(rule.editor().hasFocus());
        QVERIFY(rule.editor().text().contains("Vec2 force(Body me)"));
        QVERIFY(rule.editor().text().contains("Vec2 pull(Body me, Body other)"));
        QVERIFY(rule.sentence().isEmpty());
        QVERIFY(!fixture.plan().rule); // what is there to begin with is no rule
        QTest::keyClick(&rule.editor(), Qt::Key_Escape);
        QVERIFY(fixture.view.hasFocus());
    }

    void theFirstPauseAfterTheStartLeavesTheCaret()
    {
        SessionFixture fixture(LessonLibrary::load({LESSON_DIR}));
        fixture.session.openStep("sandbox", "build"); // before the panel is made, as when the program starts
        RulePanel panel(fixture.session.run(), fixture.session.editor(), fixture.session.playback(),
                        fixture.session.rule(), fixture.theme);
        show(panel, {600, 500});
        ListingEditor &editor = panel.editor();
        editor.setFocus();
        editor.setCursorPosition(5, static_cast<int>(editor.text(5).size()) - 1);
        QTest::keyClicks(&editor, " ");
        QTRY_VERIFY(!editor.isPending());
        settle();
        QTest::keyClicks(&editor, "// here");
        QVERIFY2(editor.text(5).endsWith(" // here\n"), qPrintable(editor.text()));
    }

    void aPanelThatIsDeletedAppliesTheTypedText()
    {
        SessionFixture fixture(LessonLibrary::load({LESSON_DIR}));
        fixture.session.openStep("sandbox", "build");
        {
            RulePanel panel(fixture.session.run(), fixture.session.editor(), fixture.session.playback(),
                            fixture.session.rule(), fixture.theme);
            show(panel, {600, 500});
            panel.editor().setFocus();
            QTest::keyClicks(&panel.editor(), "// last");
            QVERIFY(panel.editor().isPending());
        }
        QVERIFY2(fixture.session.rule().text().startsWith("// last"),
                 qPrintable(fixture.session.rule().text()));
    }

    void lessonsHaveNoSuchPage()
    {
        const WindowFixture fixture;
        QVERIFY(!fixture.part<CodePages>().rule().isVisible());
        const QAbstractButton *tab = fixture.button("My rule");
        QVERIFY(!tab || !tab->isVisible());
    }

    void aTypedRuleMovesTheBodiesAtOnce()
    {
        RuleFixture fixture;
        fixture.goTo(30);
        QVERIFY(isNear(fixture.position("p0"), RuleFixture::first, 0.0));
        fixture.write(push);
        QVERIFY2(fixture.rule.sentence().isEmpty(), qPrintable(fixture.rule.sentence()));
        QVERIFY(fixture.arrives());
        QCOMPARE(fixture.frame(), 30);
        QVERIFY(isNear(fixture.position("p0"), fallen(RuleFixture::first, {0.03, 0.01}, 30), 1e-9));
        QVERIFY(isNear(fixture.position("p1"), fallen(RuleFixture::second, {0.06, 0.02}, 30), 1e-9));
        QVERIFY(fixture.session.comparisons().shown()); // the run as it was is the ghost
        QVERIFY2(fixture.rule.state().contains("every body"), qPrintable(fixture.rule.state()));
    }

    void theRuleActsUnderOtherMethods()
    {
        RuleFixture fixture;
        fixture.write(push);
        fixture.session.editor().setMethod("rk4");
        fixture.goTo(30);
        QVERIFY(isNear(fixture.position("p1"), RuleFixture::second + 450.0 * sim::Vec2{0.06, 0.02}, 1e-9));
    }

    void aMistakeIsExplainedAndTheLastRuleGoesOn()
    {
        RuleFixture fixture;
        fixture.write(push);
        fixture.goTo(20);
        const sim::Vec2 before = fixture.position("p1");
        fixture.replace("0.06", "me.mas");
        QVERIFY2(fixture.rule.sentence().startsWith("Line 1: "), qPrintable(fixture.rule.sentence()));
        QVERIFY2(fixture.rule.sentence().contains("mass"), qPrintable(fixture.rule.sentence()));
        const auto column = static_cast<int>(fixture.rule.editor().text().indexOf("mas,")) + 1;
        QVERIFY(fixture.rule.editor().isUnderlined(1, column));
        QVERIFY(isNear(fixture.position("p1"), before, 0.0));
        QVERIFY2(fixture.rule.state().contains("last rule"), qPrintable(fixture.rule.state()));
        fixture.session.playback().frameForward();
        QVERIFY(isNear(fixture.position("p1"), fallen(RuleFixture::second, {0.06, 0.02}, 21), 1e-9));
        fixture.replace("me.mas", "0.05");
        QVERIFY(fixture.rule.sentence().isEmpty());
        QVERIFY(fixture.arrives());
        QVERIFY(isNear(fixture.position("p1"), fallen(RuleFixture::second, {0.05, 0.02}, 21), 1e-9));
    }

    void undoGoesBackByPauses()
    {
        RuleFixture fixture;
        const int edits = fixture.session.editor().undoStack().count();
        fixture.write(push);
        QCOMPARE(fixture.session.editor().undoStack().count(), edits + 1);
        fixture.session.editor().endGesture(); // as after a pause
        fixture.replace("0.02", "0.04");
        QCOMPARE(fixture.session.editor().undoStack().count(), edits + 2);
        fixture.pressUndo();
        QCOMPARE(fixture.rule.editor().text(), push);
        fixture.pressUndo();
        QCOMPARE(fixture.rule.editor().text(), RuleCode::startingText());
        QVERIFY(!fixture.plan().rule);
        fixture.pressRedo();
        fixture.pressRedo();
        QVERIFY(fixture.rule.editor().text().contains("Vec2(0.06, 0.04)"));
        fixture.goTo(10);
        QVERIFY(isNear(fixture.position("p1"), fallen(RuleFixture::second, {0.06, 0.04}, 10), 1e-9));
    }

    void anEmptiedTextIsNoRuleAndStaysEmpty()
    {
        RuleFixture fixture;
        fixture.write(push);
        QTest::keyClick(&fixture.rule.editor(), Qt::Key_A, Qt::ControlModifier);
        QTest::keyClick(&fixture.rule.editor(), Qt::Key_Delete);
        fixture.compile();
        QVERIFY(fixture.rule.editor().text().isEmpty());
        QVERIFY(fixture.rule.sentence().isEmpty());
        QVERIFY(!fixture.plan().rule);
        fixture.goTo(5);
        QVERIFY(isNear(fixture.position("p0"), RuleFixture::first, 0.0));
    }

    void deletingTheRuleBringsTheStartingTextBack()
    {
        RuleFixture fixture;
        fixture.write(push);
        QTest::mouseClick(&fixture.part<QToolButton>("deleteRule"), Qt::LeftButton);
        QCOMPARE(fixture.rule.editor().text(), RuleCode::startingText());
        QVERIFY(!fixture.plan().rule);
        fixture.session.editor().undo();
        QVERIFY(fixture.plan().rule);
    }

    void aLoopWithoutEndStopsOnItsLine()
    {
        RuleFixture fixture;
        fixture.write("Vec2 force(Body me) {\nwhile (me.mass > 1) { }\nreturn Vec2(0, 0); }");
        fixture.session.playback().frameForward();
        QTRY_VERIFY(fixture.session.timeline().stop());
        QTRY_VERIFY2(fixture.rule.sentence().contains("ine 2"), qPrintable(fixture.rule.sentence()));
        QCOMPARE(fixture.rule.editor().marks().failed, 2);
    }

    void theLedgerSwitchesItOffAndThePageOnAgain()
    {
        RuleFixture fixture;
        fixture.write(push);
        fixture.window.docks().show(Panel::effects, true);
        settle();
        auto &list = fixture.part<EffectList>();
        const std::vector<EffectLine> &lines = list.lines().lines();
        const auto line = std::find_if(lines.begin(), lines.end(),
                                       [](const EffectLine &one) { return one.title == "My rule"; });
        QVERIFY(line != lines.end());
        const auto row = static_cast<int>(line - lines.begin());
        list.scrollTo(list.lines().index(row));
        const QRect place = EffectDelegate::switchRect(list.visualRect(list.lines().index(row)));
        QTest::mouseClick(list.viewport(), Qt::LeftButton, {}, place.center());
        QTRY_VERIFY(fixture.session.editor().isOff("rule"));
        fixture.goTo(10);
        QVERIFY(isNear(fixture.position("p1"), RuleFixture::second, 0.0));
        auto &on = fixture.part<QPushButton>("switchRuleOn");
        QVERIFY(on.isVisible());
        QTest::mouseClick(&on, Qt::LeftButton);
        QVERIFY(!on.isVisible());
        fixture.goTo(10);
        QVERIFY(isNear(fixture.position("p1"), fallen(RuleFixture::second, {0.06, 0.02}, 10), 1e-9));
    }

    void pullActsOnBothEndsOfADrawnLink()
    {
        RuleFixture fixture;
        fixture.write("Vec2 pull(Body me, Body other) { return 0.01 * (other.position - me.position); }");
        QVERIFY2(fixture.rule.state().contains("none yet"), qPrintable(fixture.rule.state()));
        fixture.key(Qt::Key_L);
        fixture.drag(RuleFixture::first, RuleFixture::second);
        QCOMPARE(fixture.plan().ruleLinks.size(), std::size_t(1));
        QCOMPARE(fixture.session.presentation().picture().view->ruleLinks.size(), std::size_t(1));
        QVERIFY(fixture.editor().chosen() == (Selection{{}, {}, {}, {0}}));
        fixture.goTo(12);
        double x0 = 100.0, x1 = 200.0, v0 = 0.0, v1 = 0.0;
        for (int i = 0; i < 12; ++i) {
            const double force = 0.01 * (x1 - x0);
            x0 += v0 += force / 2.0;
            x1 += v1 -= force;
        }
        QVERIFY(isNear(fixture.position("p0"), {x0, 200.0}, 1e-9));
        QVERIFY(isNear(fixture.position("p1"), {x1, 200.0}, 1e-9));
    }

    void aLinkIsChosenWithTheMouseAndDeleted()
    {
        RuleFixture fixture;
        fixture.key(Qt::Key_L);
        fixture.drag(RuleFixture::first, RuleFixture::second);
        fixture.drag(RuleFixture::second, RuleFixture::first); // they have one already
        QCOMPARE(fixture.plan().ruleLinks.size(), std::size_t(1));
        fixture.key(Qt::Key_V);
        fixture.click({150, 250});
        QVERIFY(fixture.editor().chosen().isEmpty());
        fixture.click({150, 200});
        QVERIFY(fixture.editor().chosen() == (Selection{{}, {}, {}, {0}}));
        QTest::keyClick(&fixture.window, Qt::Key_Delete);
        QVERIFY(fixture.plan().ruleLinks.empty());
        QCOMPARE(fixture.plan().points.size(), std::size_t(2));
        QCOMPARE(fixture.session.editor().undoStack().undoText(), QString("Delete rule link"));
        fixture.pressUndo();
        QCOMPARE(fixture.plan().ruleLinks.size(), std::size_t(1));
    }

    void allSelectedPointsAreLinkedByOneKey()
    {
        RuleFixture fixture;
        fixture.key(Qt::Key_P);
        fixture.click({150, 120});
        fixture.click({150, 280});
        fixture.key(Qt::Key_V);
        QTest::keyClick(&fixture.window, Qt::Key_A, Qt::ControlModifier);
        fixture.key(Qt::Key_L, Qt::ShiftModifier);
        QCOMPARE(fixture.plan().ruleLinks.size(), std::size_t(6)); // each two of four points
        fixture.key(Qt::Key_L, Qt::ShiftModifier);
        QCOMPARE(fixture.plan().ruleLinks.size(), std::size_t(6));
    }

    void ruleIsSavedWithTheExperiment()
    {
        const QTemporaryDir folder;
        const QString path = folder.filePath("rule.json");
        {
            RuleFixture fixture;
            fixture.write(push);
            fixture.key(Qt::Key_L);
            fixture.drag(RuleFixture::first, RuleFixture::second);
            QVERIFY(!fixture.rule.editor().isPending());
            QVERIFY(fixture.window.saveFile(path));
        }
        SandboxFixture later;
        later.window.openFile(path);
        CodePages &pages = later.part<CodePages>();
        QCOMPARE(pages.page(), CodePages::Page::rule); // an opened rule is shown
        QCOMPARE(pages.rule().editor().text(), push);
        QCOMPARE(later.plan().ruleLinks.size(), std::size_t(1));
        later.goTo(10);
        QVERIFY(isNear(later.session.timeline().state().positionOf(1),
                       fallen(RuleFixture::second, {0.06, 0.02}, 10), 1e-9));
    }

    void aMistakeIsSavedBesideTheLastRule()
    {
        const QTemporaryDir folder;
        const QString path = folder.filePath("draft.json");
        const QString wrong = QString(push).replace("0.06", "0.06 +");
        {
            RuleFixture fixture;
            fixture.write(push);
            fixture.replace("0.06", "0.06 +");
            QVERIFY(fixture.window.saveFile(path));
        }
        SandboxFixture later;
        later.window.openFile(path);
        QCOMPARE(later.part<CodePages>().rule().editor().text(), wrong);
        QVERIFY(!later.part<CodePages>().rule().sentence().isEmpty());
        QCOMPARE(later.plan().rule.text(), push.toStdString());
    }

    void newSceneDiscardsTheDraft()
    {
        RuleFixture fixture;
        fixture.write("Vec2 force(");
        QVERIFY(!fixture.rule.sentence().isEmpty());
        startEmpty(fixture.session.run(), fixture.session.editor());
        QCOMPARE(fixture.rule.editor().text(), RuleCode::startingText());
        QVERIFY(fixture.rule.sentence().isEmpty());
        fixture.session.editor().undo();
        QCOMPARE(fixture.rule.editor().text(), QString("Vec2 force("));
    }

    void itsWorkIsALineOfTheEnergyLedger()
    {
        RuleFixture fixture;
        fixture.write(push);
        fixture.goTo(10);
        EnergySeries series(fixture.session.run(), fixture.session.playback());
        series.setActive(true);
        QTRY_VERIFY(series.at(10));
        std::map<QString, double> amounts;
        for (const EnergyLine &line : EnergyLines(series).energyAt(10))
            amounts[line.id] = line.amount;
        QVERIFY(amounts.contains("rule"));
        // In motion after ten frames: v = 10 a, and half of mass times v squared, for both bodies.
        const double moving =
            0.5 * 2.0 * 100.0 * (0.03 * 0.03 + 0.01 * 0.01) + 0.5 * 1.0 * 100.0 * (0.06 * 0.06 + 0.02 * 0.02);
        QVERIFY(std::abs(amounts["rule"] + amounts["drift"] - moving) <= 1e-10);
        QVERIFY(std::abs(amounts["rule"] - moving) <= 0.15 * moving);
    }

    void namesAreCompleted()
    {
        RuleFixture fixture;
        fixture.window.move(-500, 0); // the screen without a display is 800 px wide
        settle();
        fixture.write("Vec2 force(Body me) { return me.po");
        QTRY_VERIFY(fixture.rule.editor().isListActive());
        QTest::keyClick(&fixture.rule.editor(), Qt::Key_Return);
        fixture.compile();
        QVERIFY(fixture.rule.editor().text().endsWith("me.position"));
    }
};

SUITE(tst_rule_panel, RulePanelTest)
#include "tst_rule_panel.moc"
