// After any sequence of seeks, drags and edits the state is that of a fresh run with the same script.

#include "tests/sim/support/support.h"

#include "sim/effects/springs/point_spring.h"
#include "sim/methods/methods.h"
#include "tests/sizes.h"
#include "tests/suite.h"

#include <QTest>

using namespace sim;
using support::Dice;

namespace {

/// Returns undamped points on springs whose k and positions are whole numbers. With semi-implicit Euler, v' =
/// v - k x, x' = x + v', the states repeat exactly: after 6 output steps for k = 1, 4 for k = 2, 3 for k = 3.
/// So the run sleeps.
Script periodicScript()
{
    support::Sample sample;
    sample.values.set("k", 1.0);
    sample.values.set("points", 2.0);
    sample.build = [](const Values &values) {
        const int points = values.integer("points");
        Scene scene = scenes::creature(points - 1);
        for (int i = 0; i < points; ++i) {
            scene.start.position(i, {100.0 + 16.0 * i, 200.0});
            scene.effects.push_back(std::make_shared<PointSpring>(i, Vec2{100.0, 200.0}, values["k"]));
        }
        return scene;
    };
    return support::script(sample, "semi_implicit_euler");
}

constexpr int sequenceCount = tests::sized(200, 70);

/// Returns the state at `timeline`'s cursor in a new run of its script.
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

void drag(Timeline &timeline, Dice &dice)
{
    const double choice = dice.real(0, 1);
    if (choice < 0.35)
        timeline.applyInput(Grab{bodyName(dice)});
    else if (choice < 0.8)
        timeline.applyInput(Move{{dice.real(0, 540), dice.real(0, 400)}});
    else
        timeline.applyInput(Release{});
}

void setRandomParameter(Timeline &timeline, Dice &dice)
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

void replaceRandomSetting(Timeline &timeline, Dice &dice)
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

/// Applies a random edit to a run of a creature.
void editCreature(Timeline &timeline, Dice &dice)
{
    const double choice = dice.real(0, 1);
    if (choice < 0.35)
        timeline.seek({dice.whole(0, 60), dice.chance(0.6) ? 0 : dice.whole(0, 25)});
    else if (choice < 0.45)
        dice.chance(0.5) ? timeline.nextPhase() : timeline.previousPhase();
    else if (choice < 0.55)
        dice.chance(0.7) ? timeline.nextOutputStep() : timeline.previousOutputStep();
    else if (choice < 0.8)
        drag(timeline, dice);
    else if (choice < 0.92)
        setRandomParameter(timeline, dice);
    else
        replaceRandomSetting(timeline, dice);
}

void removeRandomEvent(Timeline &timeline, Dice &dice)
{
    std::vector<Event> input = timeline.script().input;
    if (!input.empty())
        input.erase(input.begin() + dice.whole(0, int(input.size()) - 1));
    timeline.replaceInput(std::move(input));
}

void moveStart(Timeline &timeline, Vec2 position)
{
    Script script = timeline.script();
    script.bodies["body"] = {position, {}};
    timeline.replaceScript(std::move(script));
}

/// Applies a random edit to a run of periodicScript().
void editPeriodicRun(Timeline &timeline, Dice &dice)
{
    const Vec2 position = {double(dice.whole(50, 150)), double(dice.whole(150, 250))};
    const double choice = dice.real(0, 1);
    if (choice < 0.45)
        timeline.seek({dice.whole(0, dice.chance(0.7) ? 20 : 200), dice.chance(0.8) ? 0 : dice.whole(0, 6)});
    else if (choice < 0.55)
        dice.chance(0.5) ? timeline.nextOutputStep() : timeline.previousOutputStep();
    else if (choice < 0.65)
        timeline.applyInput(Grab{dice.chance(0.5) ? "body" : "foot0"});
    else if (choice < 0.75)
        timeline.applyInput(Move{position});
    else if (choice < 0.85)
        timeline.applyInput(Release{});
    else if (choice < 0.92)
        dice.chance(0.5) ? timeline.setParameter("k", dice.whole(1, 3))
                         : timeline.setParameter("points", dice.whole(1, 4));
    else if (choice < 0.97)
        removeRandomEvent(timeline, dice);
    else
        moveStart(timeline, position);
}

}

class TestRandomEdits : public QObject
{
    Q_OBJECT

private slots:
    void anySequenceOfEditsGivesTheStateOfAFreshRun_data()
    {
        QTest::addColumn<int>("budget");
        QTest::newRow("hardly any memory")
            << 8000; // fits two of the largest states, those of a method of order 8
        QTest::newRow("some memory") << 30'000;
        QTest::newRow("everything fits") << 100'000'000;
    }
    void anySequenceOfEditsGivesTheStateOfAFreshRun()
    {
        QFETCH(int, budget);
        trySequences(support::script(support::sample("creature in a room"), "published"), budget,
                     editCreature);
    }

    void anySequenceOfEditsOnAPeriodicRunGivesTheStateOfAFreshRun_data()
    {
        anySequenceOfEditsGivesTheStateOfAFreshRun_data();
    }
    void anySequenceOfEditsOnAPeriodicRunGivesTheStateOfAFreshRun()
    {
        QFETCH(int, budget);
        const int slept = trySequences(periodicScript(), budget, editPeriodicRun);
        // With fewer sleeping states the test would hardly check sleeping.
        QVERIFY2(slept > 2 * sequenceCount, qPrintable(QString::number(slept)));
    }

private:
    /// Returns the number of edits after which the run slept.
    static int trySequences(const Script &script, int budget, void (*edit)(Timeline &, Dice &))
    {
        int slept = 0;
        for (std::uint64_t seed = 1; seed <= std::uint64_t(sequenceCount); ++seed) {
            Dice dice(seed);
            Timeline timeline(script, std::size_t(budget));
            for (int i = 0; i < 25; ++i) {
                edit(timeline, dice);
                std::string found = support::difference(timeline.state(), freshState(timeline));
                if (timeline.keyframeBytes() > std::size_t(budget))
                    found += " the budget is exceeded";
                if (!found.empty()) {
                    const QString where = QString("seed %1, edit %2: ").arg(seed).arg(i);
                    QTest::qFail(qPrintable(where + QString::fromStdString(found)), __FILE__, __LINE__);
                    return 0;
                }
                slept += timeline.track().sleep() ? 1 : 0;
            }
        }
        return slept;
    }
};

SUITE(tst_random_edits, TestRandomEdits)
#include "tst_random_edits.moc"
