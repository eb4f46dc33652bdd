// After any sequence of seeks, drags and edits the state is that of a fresh run with the same script.

#include "support.h"

#include "sim/methods/methods.h"

#include <QTest>

using namespace sim;
using support::Dice;

namespace {

Script creature(double h = 1.0)
{
    return support::script(support::sample("creature in a room"), "published", h);
}

/// The state at `timeline`'s cursor in a run of its script that knows nothing of how it came about.
State freshState(const Timeline &timeline)
{
    Track fresh(timeline.script(), 0);
    fresh.seek(timeline.at());
    return fresh.at() == timeline.at() ? fresh.now() : State{};
}

std::string bodyName(Dice &dice)
{
    return dice.chance(0.3) ? "body" : "foot" + std::to_string(dice.whole(0, 4));
}

void useHand(Timeline &timeline, Dice &dice)
{
    const double what = dice.real(0, 1);
    if (what < 0.35)
        timeline.hand(Grab{bodyName(dice)});
    else if (what < 0.8)
        timeline.hand(Move{{dice.real(0, 540), dice.real(0, 400)}});
    else
        timeline.hand(Release{});
}

void setSomething(Timeline &timeline, Dice &dice)
{
    struct Range
    {
        const char *parameter;
        double low, high;
    };
    static constexpr Range ranges[] = {{"k", 0.05, 0.3},
                                       {"damp", 0.7, 0.95},
                                       {"gravity", 0.0, 1.0},
                                       {"radius", 10.0, 80.0},
                                       {"feet", 1.0, 5.0}};
    const Range &range = ranges[dice.whole(0, 4)];
    timeline.set(range.parameter, dice.real(range.low, range.high));
}

void replaceSomething(Timeline &timeline, Dice &dice)
{
    Script script = timeline.script();
    if (dice.chance(0.4))
        script.method = allMethods()[std::size_t(dice.whole(0, int(allMethods().size()) - 1))];
    const bool adaptive = script.method->stepping() == Stepping::adaptive;
    if (adaptive != script.step.adaptive() || (adaptive && dice.chance(0.4)))
        script.step = support::stepFor(*script.method, 1.0);
    else if (!adaptive && dice.chance(0.4))
        script.step =
            StepSize::of(std::vector<double>{1.0, 0.5, 1.0 / 3, 2.0}[std::size_t(dice.whole(0, 3))]);
    if (dice.chance(0.3))
        script.effectsOff = {dice.chance(0.5) ? "gravity" : "walls"};
    if (dice.chance(0.3))
        script.bodies["foot0"] = {{dice.real(100, 400), 150}, Vec2{dice.real(-5, 5), 0}};
    timeline.replace(std::move(script));
}

void doSomething(Timeline &timeline, Dice &dice)
{
    const double what = dice.real(0, 1);
    if (what < 0.35)
        timeline.seek({dice.whole(0, 60), dice.chance(0.6) ? 0 : dice.whole(0, 25)});
    else if (what < 0.45)
        dice.chance(0.5) ? timeline.stepPhase() : timeline.stepPhaseBack();
    else if (what < 0.55)
        dice.chance(0.7) ? timeline.stepRow() : timeline.stepRowBack();
    else if (what < 0.8)
        useHand(timeline, dice);
    else if (what < 0.92)
        setSomething(timeline, dice);
    else
        replaceSomething(timeline, dice);
}

}

class TestAnyHistory : public QObject
{
    Q_OBJECT

private slots:
    void anyHistoryGivesTheStateOfAFreshRun_data()
    {
        QTest::addColumn<int>("budget");
        QTest::newRow("nearly no memory") << 8000; // two starts of the largest state, a method's of order 8
        QTest::newRow("some memory") << 30'000;
        QTest::newRow("all is kept") << 100'000'000;
    }
    void anyHistoryGivesTheStateOfAFreshRun()
    {
        QFETCH(int, budget);
        for (std::uint64_t seed = 1; seed <= 200; ++seed) {
            Dice dice(seed);
            Timeline timeline(creature(), std::size_t(budget));
            for (int i = 0; i < 25; ++i) {
                doSomething(timeline, dice);
                const std::string found = support::difference(timeline.now(), freshState(timeline));
                QVERIFY2(
                    found.empty(),
                    qPrintable(
                        QString("seed %1, act %2: %3").arg(seed).arg(i).arg(QString::fromStdString(found))));
                QVERIFY(timeline.keptBytes() <= std::size_t(budget));
            }
        }
    }
};

QTEST_APPLESS_MAIN(TestAnyHistory)
#include "tst_any_history.moc"
