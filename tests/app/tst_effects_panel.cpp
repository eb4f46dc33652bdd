// The ledger of effects: its words, and its switches driven as a learner drives them.

#include "effects_panel_bench.h"

using namespace app;
using namespace effects_bench;
using namespace effects_panel_bench;

class EffectsPanelTest : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase() { prepareProgram(); }

    void figuresAreThoseOfTheMeter()
    {
        Bench bench;
        const EffectLine spring = bench.line("body_spring");
        QCOMPARE(spring.title, "Spring");
        QCOMPARE(spring.frame, "0.0314");
        QCOMPARE(spring.spread, "±0.0003");
        QCOMPARE(spring.point, "0.0052"); // 31.4 ns / 6
        QCOMPARE(spring.points, "6");
        QCOMPARE(spring.runs, "×1");
        QCOMPARE(spring.saving, "Without “Spring” a frame would cost 0.0146\u2009µs in place of 0.0460.");
        QCOMPARE(bench.line("damping").point, "0.0008");
        QCOMPARE(bench.line("rest").frame, "0.0100");
        QCOMPARE(bench.panel.caption(), "0.0460\u2009µs a frame, ±0.0020, measured now");
        QCOMPARE(bench.panel.remark(), spring.saving); // of the costliest one
    }

    void theLastRowIsWholeAndTheFootIsInLineWithTheRest()
    {
        Bench bench;
        auto *list = bench.panel.findChild<EffectList *>();
        for (int height = 240; height < 300; height += 7) {
            bench.panel.resize(560, height);
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
        bench.panel.setStyleSheet("* { color: red; }"); // as when the colours change
        for (const QLabel *label : bench.panel.findChildren<QLabel *>()) {
            if (label->text() == bench.panel.remark())
                QCOMPARE(label->mapTo(&bench.panel, label->contentsRect().topLeft()).x(), 16);
        }
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

    void aSwitchTakesItOutOfPipelineCodeAndPicture_data()
    {
        QTest::addColumn<bool>("byKey");
        QTest::newRow("mouse") << false;
        QTest::newRow("keys") << true;
    }

    void aSwitchTakesItOutOfPipelineCodeAndPicture()
    {
        QFETCH(bool, byKey);
        Bench bench;
        const auto press = [&] {
            if (!byKey) {
                bench.clickSwitch("body_spring");
                return;
            }
            bench.panel.list().setFocus();
            bench.panel.list().setCurrentIndex(bench.index("damping"));
            while (bench.panel.list().currentIndex().row() > bench.row("body_spring"))
                QTest::keyClick(&bench.panel.list(), Qt::Key_Up);
            QTest::keyClick(&bench.panel.list(), Qt::Key_Space);
            QCoreApplication::processEvents();
        };
        QVERIFY(bench.hasPhase("body_spring") && bench.showsSource(springFile));
        QCOMPARE(bench.session().picture().look->legs.size(), std::size_t(1));
        press();
        QCOMPARE(bench.run().script().effectsOff, std::vector<std::string>{"body_spring"});
        QVERIFY(!bench.hasPhase("body_spring"));
        QVERIFY(bench.hasPhase("damping"));
        QVERIFY(!bench.showsSource(springFile));
        QVERIFY(bench.session().picture().look->legs.empty());
        QCOMPARE(bench.line("body_spring").role, EffectRole::off);
        QCOMPARE(bench.line("body_spring").frame, "0");
        QVERIFY(bench.settle());
        QCOMPARE(bench.line("damping").frame, "0.0046");
        press();
        QVERIFY(bench.run().script().effectsOff.empty());
        QVERIFY(bench.hasPhase("body_spring") && bench.showsSource(springFile));
        QCOMPARE(bench.session().picture().look->legs.size(), std::size_t(1));
    }

    /// What was switched off runs by the rule that is left: without a spring the foot stays where it is.
    void whatIsSwitchedOffDoesNothing()
    {
        Bench bench;
        bench.clickSwitch("body_spring");
        bench.session().goTo({50, 0});
        QCOMPARE(bench.run().state().positionOf(0), (sim::Vec2{300, 210}));
    }

    void undoBringsTheVeryBitsBack()
    {
        Bench bench;
        bench.session().goTo({40, 0});
        const sim::State with = bench.run().state();
        bench.clickSwitch("body_spring");
        const sim::State without = bench.run().state();
        QCOMPARE(bench.run().cursor().frame, 40);
        QVERIFY(!sim::sameBits(with, without));
        QVERIFY(bench.session().deeds().canUndo());
        QCOMPARE(bench.session().deeds().undoText(), "Spring off");
        bench.session().undo();
        QVERIFY(sim::sameBits(bench.run().state(), with));
        QVERIFY(bench.line("body_spring").isOn());
        bench.session().redo();
        QVERIFY(sim::sameBits(bench.run().state(), without));
        QVERIFY(!bench.session().deeds().canRedo());
    }

    void anotherStepBeginsTheListAnew()
    {
        Bench bench;
        bench.clickSwitch("damping");
        QVERIFY(bench.session().deeds().canUndo());
        bench.session().openStep("legs", "puppet");
        QVERIFY(!bench.session().deeds().canUndo());
        bench.session().openStep("legs", "tied");
        QVERIFY(!bench.session().deeds().canUndo());
        QVERIFY(bench.session().isOff("damping")); // the step is as it was left
    }

    void withoutWhatNothingMovesItSaysSo()
    {
        Bench bench;
        bench.session().openStep("legs", "puppet");
        QVERIFY(bench.settle());
        const QSignalSpy said(&bench.session(), &Session::said);
        bench.clickSwitch("pointer");
        QCOMPARE(said.count(), 1);
        QVERIFY(!said.front().front().toString().isEmpty());
        QVERIFY(bench.run().script().effectsOff.empty());
        QVERIFY(bench.line("pointer").isOn());
        QVERIFY(!bench.session().deeds().canUndo());
    }

    void whatIsSetToNothingIsListedWithNought()
    {
        Bench bench;
        QCOMPARE(bench.line("gravity").role, EffectRole::idle);
        QCOMPARE(bench.line("gravity").frame, "0");
        QCOMPARE(bench.line("gravity").note, "changes nothing here");
        QVERIFY(!bench.hasPhase("gravity"));
        bench.session().setParameter("gravity", 0.5);
        QVERIFY(bench.settle());
        QCOMPARE(bench.line("gravity").role, EffectRole::acts);
        QCOMPARE(bench.line("gravity").frame, "0.0046");
    }

    void whatOtherLessonsKnowIsGreyed()
    {
        Bench bench;
        const auto &lines = bench.panel.list().lines().lines();
        QStringList absent;
        for (const EffectLine &line : lines) {
            if (line.role == EffectRole::absent)
                absent << line.title;
        }
        QCOMPARE(absent, (QStringList{"Pointer", "Walls"}));
        const EffectLine walls = lines.back();
        QCOMPARE(walls.note, "not in this scene");
        QVERIFY(walls.help.startsWith("Not in this scene"));
        QVERIFY(walls.help.contains("Walls (Rooms). Put back what has gone past a wall"));
        const std::vector<std::string> before = bench.run().script().effectsOff;
        const QModelIndex index = bench.panel.list().lines().index(static_cast<int>(lines.size()) - 1);
        QVERIFY(!(index.flags() & Qt::ItemIsUserCheckable));
        bench.clickSwitch(walls.id);
        bench.panel.list().setFocus();
        bench.panel.list().setCurrentIndex(bench.index(walls.id));
        QTest::keyClick(&bench.panel.list(), Qt::Key_Space);
        QCoreApplication::processEvents();
        QCOMPARE(bench.run().script().effectsOff, before);
        QVERIFY(!bench.session().deeds().canUndo());
    }

    void aScreenReaderHearsEachLine()
    {
        Bench bench;
        const auto spoken = [&](const QString &id) {
            return bench.index(id).data(Qt::AccessibleTextRole).toString();
        };
        QCOMPARE(spoken("body_spring"), "Spring, 0.0314\u2009µs a frame, on");
        QCOMPARE(spoken("gravity"), "Gravity, 0\u2009µs a frame, on, changes nothing here");
        QCOMPARE(spoken("rest"), "Rest of the frame, 0.0100\u2009µs a frame");
        bench.clickSwitch("damping");
        QCOMPARE(spoken("damping"), "Damping, 0\u2009µs a frame, off");
        QVERIFY(!bench.panel.list().accessibleName().isEmpty());
        for (int row = 0; row < bench.panel.list().lines().rowCount(); ++row)
            QVERIFY(!bench.panel.list().lines().index(row).data(Qt::ToolTipRole).toString().isEmpty());
    }
};

QTEST_MAIN(EffectsPanelTest)
#include "tst_effects_panel.moc"
