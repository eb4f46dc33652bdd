// The ledger of effects: its texts, and its switches, used by mouse and keys.

#include "tests/app/panels/effects_panel_support.h"
#include "tests/suite.h"

#include <algorithm>

using namespace app;
using namespace effects_support;
using namespace effects_panel_support;

class EffectsPanelTest : public QObject
{
    Q_OBJECT

private slots:
    void linesShowTheMeasuredCosts()
    {
        EffectsFixture fixture;
        const EffectLine spring = fixture.line("body_spring");
        QCOMPARE(spring.title, "Spring");
        QCOMPARE(spring.frame, "0.0314");
        QCOMPARE(spring.spread, "±0.0003");
        QCOMPARE(spring.point, "0.0052"); // 31.4 ns / 6
        QCOMPARE(spring.points, "6");
        QCOMPARE(spring.runs, "×1");
        QCOMPARE(spring.saving, "Without “Spring” a frame would cost 0.0146\u2009µs instead of 0.0460.");
        QCOMPARE(fixture.line("damping").point, "0.0008");
        QCOMPARE(fixture.line("rest").frame, "0.0100");
        QCOMPARE(fixture.panel.caption(), "0.0460\u2009µs a frame, ±0.0020, measured now");
        QCOMPARE(fixture.panel.remark(), spring.saving); // of the costliest one
    }

    void theLastRowIsWholeAndTheFootIsInLineWithTheRest()
    {
        EffectsFixture fixture;
        auto *list = fixture.panel.findChild<EffectList *>();
        for (int height = 240; height < 300; height += 7) {
            fixture.panel.resize(560, height);
            QCoreApplication::processEvents();
            int whole = 0;
            for (int row = 0; row < list->model()->rowCount(); ++row) {
                const QRect place = list->visualRect(list->model()->index(row, 0));
                if (place.top() < list->viewport()->height()) {
                    QVERIFY2(place.bottom() < list->viewport()->height(),
                             qPrintable(QString::number(height)));
                    ++whole;
                }
            }
            QVERIFY(whole >= 2);
        }
        fixture.panel.setStyleSheet("* { color: red; }"); // as when the colours change
        const auto labels = fixture.panel.findChildren<QLabel *>();
        const auto foot = std::find_if(labels.begin(), labels.end(), [&](const QLabel *label) {
            return label->text() == fixture.panel.remark();
        });
        QVERIFY(foot != labels.end());
        QCOMPARE((*foot)->mapTo(&fixture.panel, (*foot)->contentsRect().topLeft()).x(), 16);
    }

    void figuresAreRoundedToWhatCanBeRead_data()
    {
        QTest::addColumn<double>("ns");
        QTest::addColumn<int>("points");
        QTest::addColumn<double>("evaluations");
        QTest::addColumn<QString>("frame");
        QTest::addColumn<QString>("point");
        QTest::addColumn<QString>("runs");
        QTest::newRow("small") << 0.04 << 1 << 1.0 << "0.0000"
                               << "0.0000"
                               << "×1";
        QTest::newRow("a thousand") << 1249.6 << 2 << 4.0 << "1.250"
                                    << "0.6248"
                                    << "×4";
        QTest::newRow("below a thousand") << 999.0 << 10 << 6.0 << "0.9990"
                                          << "0.0999"
                                          << "×6";
        QTest::newRow("a method that chooses its steps") << 80.0 << 4 << 13.37 << "0.0800"
                                                         << "0.0200"
                                                         << "×13.4";
        QTest::newRow("worked out with the move") << 80.0 << 4 << 0.0 << "0.0800"
                                                  << "0.0200" << QString();
        QTest::newRow("more than a millisecond") << 1249600.0 << 2 << 4.0 << "1250"
                                                 << "624.8"
                                                 << "×4";
        QTest::newRow("a hundred") << 123456.0 << 1 << 1.0 << "123.5"
                                   << "123.5"
                                   << "×1";
        QTest::newRow("no point") << 5.0 << 0 << 1.0 << "0.0050" << QString() << "×1";
    }

    void figuresAreRoundedToWhatCanBeRead()
    {
        QFETCH(double, ns);
        QFETCH(int, points);
        QFETCH(double, evaluations);
        const auto effect = std::make_shared<const sim::Damping>(0.9);
        sim::FrameCost cost;
        cost.rounds = 5;
        cost.ns = 2000.0;
        cost.effects = {{effect, points, evaluations, ns, 0.1}};
        EffectFacts facts;
        facts.listed = {effect};
        facts.cost = &cost;
        const EffectLine line = effectLines(facts).front();
        QTEST(line.frame, "frame");
        QTEST(line.point, "point");
        QTEST(line.runs, "runs");
    }

    /// The times of all effects are measured one after another, so one can come out longer than the whole.
    void anEffectThatTakesAllOfTheTimeSavesNoNumber()
    {
        const auto effect = std::make_shared<const sim::Damping>(0.9);
        sim::FrameCost cost;
        cost.rounds = 5;
        cost.ns = 2000.0;
        cost.effects = {{effect, 1, 1.0, 2003.0, 5.0}};
        EffectFacts facts;
        facts.listed = {effect};
        facts.cost = &cost;
        QCOMPARE(effectLines(facts).front().saving,
                 "Nearly all of a frame’s 2.000\u2009µs are spent in “Damping”.");
    }

    /// A scene may list two effects with one id, and one switch stands for both.
    void twoEffectsOfOneIdAreOneLine()
    {
        const auto body = std::make_shared<const sim::Damping>(0.9);
        const auto arm = std::make_shared<const sim::Damping>(0.5);
        sim::FrameCost cost;
        cost.rounds = 5;
        cost.ns = 30.0;
        cost.effects = {{body, 1, 1.0, 3.0, 0.3}, {arm, 9, 1.0, 7.0, 0.4}};
        EffectFacts facts;
        facts.listed = {body, arm};
        facts.cost = &cost;
        const std::vector<EffectLine> lines = effectLines(facts);
        QCOMPARE(lines.size(), std::size_t(2)); // and the rest
        QCOMPARE(lines[0].frame, "0.0100");
        QCOMPARE(lines[0].points, "10");
        QCOMPARE(lines[0].spread, "±0.0005"); // 0.3 and 0.4 that know nothing of each other
    }

    void switchRemovesAnEffectFromPipelineCodeAndPicture_data()
    {
        QTest::addColumn<bool>("byKey");
        QTest::newRow("mouse") << false;
        QTest::newRow("keys") << true;
    }

    void switchRemovesAnEffectFromPipelineCodeAndPicture()
    {
        QFETCH(bool, byKey);
        EffectsFixture fixture;
        const auto press = [&] {
            if (!byKey) {
                fixture.clickSwitch("body_spring");
                return;
            }
            fixture.panel.list().setFocus();
            fixture.panel.list().setCurrentIndex(fixture.index("damping"));
            while (fixture.panel.list().currentIndex().row() > fixture.row("body_spring"))
                QTest::keyClick(&fixture.panel.list(), Qt::Key_Up);
            QTest::keyClick(&fixture.panel.list(), Qt::Key_Space);
            QCoreApplication::processEvents();
        };
        QVERIFY(fixture.hasPhase("body_spring") && fixture.showsSource(springFile));
        QCOMPARE(fixture.session.presentation().picture().view->legs.size(), std::size_t(1));
        press();
        QCOMPARE(fixture.run().script().effectsOff, std::vector<std::string>{"body_spring"});
        QVERIFY(!fixture.hasPhase("body_spring"));
        QVERIFY(fixture.hasPhase("damping"));
        QVERIFY(!fixture.showsSource(springFile));
        QVERIFY(fixture.session.presentation().picture().view->legs.empty());
        QCOMPARE(fixture.line("body_spring").role, EffectRole::off);
        QCOMPARE(fixture.line("body_spring").frame, "0");
        QVERIFY(fixture.settle());
        QCOMPARE(fixture.line("damping").frame, "0.0046");
        press();
        QVERIFY(fixture.run().script().effectsOff.empty());
        QVERIFY(fixture.hasPhase("body_spring") && fixture.showsSource(springFile));
        QCOMPARE(fixture.session.presentation().picture().view->legs.size(), std::size_t(1));
    }

    /// The run follows the effects that are left: without a spring the foot does not move.
    void aSwitchedOffEffectDoesNothing()
    {
        EffectsFixture fixture;
        fixture.clickSwitch("body_spring");
        fixture.goTo(50);
        QCOMPARE(fixture.run().state().positionOf(0), (sim::Vec2{300, 210}));
    }

    void undoAndRedoRestoreTheSameBits()
    {
        EffectsFixture fixture;
        fixture.goTo(40);
        const sim::State with = fixture.run().state();
        fixture.clickSwitch("body_spring");
        const sim::State without = fixture.run().state();
        QCOMPARE(fixture.run().cursor().frame, 40);
        QVERIFY(!sim::sameBits(with, without));
        QVERIFY(fixture.session.editor().undoStack().canUndo());
        QCOMPARE(fixture.session.editor().undoStack().undoText(), "Spring off");
        fixture.session.editor().undo();
        QVERIFY(sim::sameBits(fixture.run().state(), with));
        QVERIFY(fixture.line("body_spring").isOn());
        fixture.session.editor().redo();
        QVERIFY(sim::sameBits(fixture.run().state(), without));
        QVERIFY(!fixture.session.editor().undoStack().canRedo());
    }

    void anotherStepHasNothingToUndo()
    {
        EffectsFixture fixture;
        fixture.clickSwitch("damping");
        QVERIFY(fixture.session.editor().undoStack().canUndo());
        fixture.session.openStep("legs", "puppet");
        QVERIFY(!fixture.session.editor().undoStack().canUndo());
        fixture.session.openStep("legs", "tied");
        QVERIFY(!fixture.session.editor().undoStack().canUndo());
        QVERIFY(fixture.session.editor().isOff("damping")); // the step is as it was left
    }

    void switchingOffTheOnlyDriverIsRefusedWithAMessage()
    {
        EffectsFixture fixture;
        fixture.session.openStep("legs", "puppet");
        QVERIFY(fixture.settle());
        const QSignalSpy said(&fixture.session.changes(), &ChangeNotifier::messageRequested);
        fixture.clickSwitch("pointer");
        QCOMPARE(said.count(), 1);
        QVERIFY(!said.front().front().toString().isEmpty());
        QVERIFY(fixture.run().script().effectsOff.empty());
        QVERIFY(fixture.line("pointer").isOn());
        QVERIFY(!fixture.session.editor().undoStack().canUndo());
    }

    void anEffectOfStrengthZeroIsListedWithZeroTime()
    {
        EffectsFixture fixture;
        QCOMPARE(fixture.line("gravity").role, EffectRole::idle);
        QCOMPARE(fixture.line("gravity").frame, "0");
        QCOMPARE(fixture.line("gravity").note, "changes nothing here");
        QVERIFY(!fixture.hasPhase("gravity"));
        fixture.session.editor().setParameter("gravity", 0.5);
        QVERIFY(fixture.settle());
        QCOMPARE(fixture.line("gravity").role, EffectRole::acts);
        QCOMPARE(fixture.line("gravity").frame, "0.0046");
    }

    void effectsOfOtherLessonsAreGreyed()
    {
        EffectsFixture fixture;
        const auto &lines = fixture.panel.list().lines().lines();
        QStringList absent;
        for (const EffectLine &line : lines) {
            if (line.role == EffectRole::absent)
                absent << line.title;
        }
        QCOMPARE(absent, (QStringList{"Pointer", "Walls"}));
        const EffectLine walls = lines.back();
        QCOMPARE(walls.note, "not in this scene");
        QVERIFY(walls.help.startsWith("Not in this scene"));
        QVERIFY(walls.help.contains("Walls (Rooms). Put back points that have gone past a wall"));
        const std::vector<std::string> before = fixture.run().script().effectsOff;
        const QModelIndex index = fixture.panel.list().lines().index(static_cast<int>(lines.size()) - 1);
        QVERIFY(!(index.flags() & Qt::ItemIsUserCheckable));
        fixture.clickSwitch(walls.id);
        fixture.panel.list().setFocus();
        fixture.panel.list().setCurrentIndex(fixture.index(walls.id));
        QTest::keyClick(&fixture.panel.list(), Qt::Key_Space);
        QCoreApplication::processEvents();
        QCOMPARE(fixture.run().script().effectsOff, before);
        QVERIFY(!fixture.session.editor().undoStack().canUndo());
    }

    void aScreenReaderHearsEachLine()
    {
        EffectsFixture fixture;
        const auto spoken = [&](const QString &id) {
            return fixture.index(id).data(Qt::AccessibleTextRole).toString();
        };
        QCOMPARE(spoken("body_spring"), "Spring, 0.0314\u2009µs a frame, on");
        QCOMPARE(spoken("gravity"), "Gravity, 0\u2009µs a frame, on, changes nothing here");
        QCOMPARE(spoken("rest"), "Rest of the frame, 0.0100\u2009µs a frame");
        fixture.clickSwitch("damping");
        QCOMPARE(spoken("damping"), "Damping, 0\u2009µs a frame, off");
        QVERIFY(!fixture.panel.list().accessibleName().isEmpty());
        for (int row = 0; row < fixture.panel.list().lines().rowCount(); ++row)
            QVERIFY(!fixture.panel.list().lines().index(row).data(Qt::ToolTipRole).toString().isEmpty());
    }
};

SUITE(tst_effects_panel, EffectsPanelTest)
#include "tst_effects_panel.moc"
