// After any sequence of seeks, drags and edits the state is that of a fresh run with the same script.

#include "support.h"

#include "sim/effects/springs/point_spring.h"
#include "sim/methods/methods.h"
#include "tests/sizes.h"

#include <QTest>

using namespace sim;
using support::Dice;

namespace {

Script creature(double h = 1.0)
{
    return support::script(support::sample("creature in a room"), "published", h);
}

/// Points that springs of a whole k swing about a place, undamped. By semi-implicit Euler at whole places, x' = x + v',
/// v' = v - k x comes back exactly: after 6 rows for a k of 1, 4 for 2, 3 for 3. So it sleeps in rounds.
Script rounds()
{
    support::Sample sample;
    sample.values.set("k", 1.0);
    sample.values.set("points", 2.0);
    sample.build = [](const Values &values) {
        const int points = values.integer("points");
        Scene scene = scenes::creature(points - 1);
        for (int i = 0; i < points; ++i) {
            scene.start.place(i, {100.0 + 16.0 * i, 200.0});
            scene.effects.push_back(std::make_shared<PointSpring>(i, Vec2{100.0, 200.0}, values["k"]));
        }
        return scene;
    };
    return support::script(sample, "semi_implicit_euler");
}

constexpr int histories = tests::sized(200, 70);

/// The state at `timeline`'s cursor in a run of its script that knows nothing of how it came about.
State freshState(const Timeline &timeline)
{
    Track fresh(timeline.script(), 0, Sleeping::never);
    fresh.seek(timeline.cursor());
    return fresh.cursor() == timeline.cursor() ? fresh.state() : State{};
}

std::string bodyName(Dice &dice)
{
    return dice.chance(0.3) ? "body" : "foot" + std::to_string(dice.whole(0, 4));
}

void useHand(Timeline &timeline, Dice &dice)
{
    const double what = dice.real(0, 1);
    if (what < 0.35)
        timeline.applyInput(Grab{bodyName(dice)});
    else if (what < 0.8)
        timeline.applyInput(Move{{dice.real(0, 540), dice.real(0, 400)}});
    else
        timeline.applyInput(Release{});
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
    timeline.setParameter(range.parameter, dice.real(range.low, range.high));
}

void replaceSomething(Timeline &timeline, Dice &dice)
{
    Script script = timeline.script();
    if (dice.chance(0.4))
        script.method = allMethods()[std::size_t(dice.whole(0, int(allMethods().size()) - 1))];
    const bool adaptive = script.method->stepping() == Stepping::adaptive;
    if (adaptive != script.step.isAdaptive() || (adaptive && dice.chance(0.4)))
        script.step = support::stepFor(*script.method, 1.0);
    else if (!adaptive && dice.chance(0.4))
        script.step =
            StepSize::ofLength(std::vector<double>{1.0, 0.5, 1.0 / 3, 2.0}[std::size_t(dice.whole(0, 3))]);
    if (dice.chance(0.3))
        script.effectsOff = {dice.chance(0.5) ? "gravity" : "walls"};
    if (dice.chance(0.3))
        script.bodies["foot0"] = {{dice.real(100, 400), 150}, Vec2{dice.real(-5, 5), 0}};
    timeline.replaceScript(std::move(script));
}

void doSomething(Timeline &timeline, Dice &dice)
{
    const double what = dice.real(0, 1);
    if (what < 0.35)
        timeline.seek({dice.whole(0, 60), dice.chance(0.6) ? 0 : dice.whole(0, 25)});
    else if (what < 0.45)
        dice.chance(0.5) ? timeline.nextPhase() : timeline.previousPhase();
    else if (what < 0.55)
        dice.chance(0.7) ? timeline.nextOutputStep() : timeline.previousOutputStep();
    else if (what < 0.8)
        useHand(timeline, dice);
    else if (what < 0.92)
        setSomething(timeline, dice);
    else
        replaceSomething(timeline, dice);
}

void takeBackSomething(Timeline &timeline, Dice &dice)
{
    std::vector<Event> input = timeline.script().input;
    if (!input.empty())
        input.erase(input.begin() + dice.whole(0, int(input.size()) - 1));
    timeline.replaceInput(std::move(input));
}

void startElsewhere(Timeline &timeline, Vec2 place)
{
    Script script = timeline.script();
    script.bodies["body"] = {place, {}};
    timeline.replaceScript(std::move(script));
}

/// The same for rounds().
void disturbRounds(Timeline &timeline, Dice &dice)
{
    const Vec2 place = {double(dice.whole(50, 150)), double(dice.whole(150, 250))};
    const double what = dice.real(0, 1);
    if (what < 0.45)
        timeline.seek({dice.whole(0, dice.chance(0.7) ? 20 : 200), dice.chance(0.8) ? 0 : dice.whole(0, 6)});
    else if (what < 0.55)
        dice.chance(0.5) ? timeline.nextOutputStep() : timeline.previousOutputStep();
    else if (what < 0.65)
        timeline.applyInput(Grab{dice.chance(0.5) ? "body" : "foot0"});
    else if (what < 0.75)
        timeline.applyInput(Move{place});
    else if (what < 0.85)
        timeline.applyInput(Release{});
    else if (what < 0.92)
        dice.chance(0.5) ? timeline.setParameter("k", dice.whole(1, 3))
                         : timeline.setParameter("points", dice.whole(1, 4));
    else if (what < 0.97)
        takeBackSomething(timeline, dice);
    else
        startElsewhere(timeline, place);
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
        tryHistories(creature(), budget, doSomething);
    }

    void soDoesAnyHistoryOfWhatSleepsInRounds_data() { anyHistoryGivesTheStateOfAFreshRun_data(); }
    void soDoesAnyHistoryOfWhatSleepsInRounds()
    {
        QFETCH(int, budget);
        const int slept = tryHistories(rounds(), budget, disturbRounds);
        QVERIFY2(slept > 2 * histories, qPrintable(QString::number(slept))); // else little was tried
    }

private:
    /// Returns after how many acts the run was asleep.
    static int tryHistories(const Script &script, int budget, void (*act)(Timeline &, Dice &))
    {
        int slept = 0;
        for (std::uint64_t seed = 1; seed <= std::uint64_t(histories); ++seed) {
            Dice dice(seed);
            Timeline timeline(script, std::size_t(budget));
            for (int i = 0; i < 25; ++i) {
                act(timeline, dice);
                std::string found = support::difference(timeline.state(), freshState(timeline));
                if (timeline.keyframeBytes() > std::size_t(budget))
                    found += " more is kept than may be";
                if (!found.empty()) {
                    const QString where = QString("seed %1, act %2: ").arg(seed).arg(i);
                    QTest::qFail(qPrintable(where + QString::fromStdString(found)), __FILE__, __LINE__);
                    return 0;
                }
                slept += timeline.track().sleep() ? 1 : 0;
            }
        }
        return slept;
    }
};

QTEST_APPLESS_MAIN(TestAnyHistory)
#include "tst_random_edits.moc"
