#include "app/model/code/code_history.h"
#include "app/model/code/code_targets.h"
#include "app/model/text/user_error.h"
#include "sim/base/random.h"
#include "sim/run/script/composed_interval.h"
#include "sim/run/script/script.h"
#include "tests/app/code/listing_support.h"
#include "tests/suite.h"

#include <algorithm>
#include <cmath>
#include <set>

using namespace listing_support;

namespace {

QStringList namesOf(const QString &line)
{
    QStringList names;
    for (const CodeWord &word : wordsOf(line)) {
        if (line.mid(word.from, word.length) != word.name)
            return {};
        names << word.name;
    }
    return names;
}

std::vector<ParameterSpot> spotsOf(const lessons::Step &step, const sim::Timeline &run)
{
    return parameterSpots(listingOf(step, run), step, run.track().interval());
}

/// Returns the state with all points moved, so that some are beyond each wall.
sim::State anywhere(sim::State state, int number)
{
    for (int i = 0; i < state.pointCount(); ++i) {
        const auto share = [&](int which) { return sim::uniform(7, number, 4 * i + which); };
        state.place(i, {1000.0 * share(0) - 200.0, 1000.0 * share(1) - 200.0});
        state.setVelocity(i, {40.0 * share(2) - 20.0, 40.0 * share(3) - 20.0});
    }
    // Steered effects depend on the speed and on a pressed key.
    (number % 2 == 0 ? state.input.keys.left : state.input.keys.right) = true;
    for (double &speed : state.gaitSpeed)
        speed = 0.4 * sim::uniform(8, number, 0) - 0.2;
    return state;
}

/// A symbol of the first line of the listing that contains `line`, at `word` in it.
std::optional<CodeSymbol> symbolOf(const lessons::Step &step, const sim::Timeline &run, const QString &line,
                                   const QString &word, int point = 0)
{
    const CodeListing listing = listingOf(step, run);
    const sim::ComposedInterval &interval = run.track().interval();
    for (std::size_t s = 0; s < listing.sections.size(); ++s) {
        for (std::size_t i = 0; i < listing.sections[s].lines.size(); ++i) {
            const QString text = listing.sections[s].lines[i].source.text;
            if (text.contains(line))
                return symbolAt(listing, s, i, text.indexOf(word), parameterSpots(listing, step, interval),
                                step, interval, point);
        }
    }
    return std::nullopt;
}

}

/// The symbols of the shown code: their meaning, their history, and the parameters that they set.
class TestCodeSymbols : public QObject
{
    Q_OBJECT

private slots:
    void wordsAreFoundWhereTheyStand_data()
    {
        QTest::addColumn<QString>("line");
        QTest::addColumn<QStringList>("names");
        QTest::newRow("assignment") << "Vec2 d = target - mover;"
                                    << QStringList{"Vec2", "d", "target", "mover"};
        QTest::newRow("members") << "if (x.x > room.right - half) {"
                                 << QStringList{"x.x", "room.right", "half"};
        QTest::newRow("calls are none")
            << "Vec2 out = direction(from);" << QStringList{"Vec2", "out", "from"};
        QTest::newRow("templates are none")
            << "add<Walls>(scene, room);" << QStringList{"Walls", "scene", "room"};
        QTest::newRow("less than") << "if (x.x < room.left)" << QStringList{"x.x", "room.left"};
        QTest::newRow("comment") << "k * d; // by k" << QStringList{"k", "d"};
        QTest::newRow("parameter") << "double k = values[\"k\"];"
                                   << QStringList{"double", "k", "values[\"k\"]"};
        QTest::newRow("whole parameter")
            << "int n = values.integer(\"feet\");" << QStringList{"int", "n", "values.integer(\"feet\")"};
        QTest::newRow("numbers") << "double a = 0.5 * 1e3;" << QStringList{"double", "a"};
        QTest::newRow("nothing") << "" << QStringList();
    }
    void wordsAreFoundWhereTheyStand()
    {
        QFETCH(QString, line);
        QTEST(namesOf(line), "names");
    }

    void parametersAndTheirVariablesAreFound()
    {
        const lessons::Step &step = stepOf("gravity_walls", "gravity");
        const sim::Timeline run = runOf(step);
        const CodeListing listing = listingOf(step, run);
        QStringList found;
        for (const ParameterSpot &spot : spotsOf(step, run)) {
            const CodeSection &section = listing.sections[spot.section];
            found << section.title.section(' ', -1) + ' ' + spot.word.name + ' ' + spot.word.parameter;
        }
        for (const char *one :
             {"Scene values[\"k\"] k", "Scene k k", "Scene values[\"floor\"] floor", "Scene room.floor floor",
              "Scene feet feet", "Springs k k", "Springs radius radius", "Gravity gravity gravity",
              "Walls room.floor floor", "Walls room.bounce bounce"})
            QVERIFY2(found.contains(one), one);
        // A variable of that name that holds something else.
        QVERIFY(!found.contains("Scene right right"));
        QVERIFY(!found.contains("Walls half half"));
    }

    void aNameThatTheCodeRecomputesIsNoParameter()
    {
        // The code has a variable of the parameter's name as well: the share that is left after one step.
        const lessons::Step &step = stepOf("codeling", "motor");
        const sim::Timeline run = runOf(step);
        const CodeListing listing = listingOf(step, run);
        int spots = 0;
        for (const ParameterSpot &spot : spotsOf(step, run)) {
            if (spot.word.parameter != "keep")
                continue;
            ++spots;
            QVERIFY(listing.sections[spot.section].role == CodeSection::Role::scene);
        }
        QVERIFY(spots > 0);
        const auto keep = symbolOf(step, run, "v = keep * v", "keep");
        QVERIFY(keep && keep->parameter.isEmpty() && keep->phase >= 0);
    }

    void everyParameterInAPhasesCodeChangesWhatThePhaseDoes()
    {
        int seen = 0;
        for (const LessonEntry &lesson : library().lessons) {
            for (const lessons::Step &step : lesson.steps) {
                sim::Timeline run = runOf(step, step.method);
                if (run.state().pointCount() > 200)
                    continue;
                const CodeListing listing = listingOf(step, run);
                std::set<std::pair<std::size_t, QString>> pairs;
                for (const ParameterSpot &spot : spotsOf(step, run)) {
                    if (listing.sections[spot.section].role == CodeSection::Role::phase)
                        pairs.insert({spot.section, spot.word.parameter});
                }
                for (const auto &[section, id] : pairs) {
                    seen += 1;
                    const lessons::Parameter &one = *step.parameter(id);
                    const double other = one.defaultValue == one.sliderMax ? one.sliderMin : one.sliderMax;
                    sim::Values values = step.defaultValues();
                    values.set(id.toStdString(), other);
                    const sim::Timeline changed(step.scriptWith(values, run.script().method));
                    const auto phase = static_cast<std::size_t>(listing.sections[section].phases.front());
                    const auto &before = run.track().interval().pipeline.phases;
                    const auto &after = changed.track().interval().pipeline.phases;
                    if (after.size() != before.size())
                        continue; // it is idle with the other value: it surely matters
                    bool differs = false;
                    run.seek({0, 0});
                    for (int frame = 0; frame < 200 && !differs; ++frame) {
                        sim::State a = anywhere(run.state(), frame);
                        sim::State b = a;
                        before[phase].run(a);
                        after[phase].run(b);
                        differs = !sim::sameBits(a, b);
                        run.nextPhase();
                    }
                    QVERIFY2(differs, qPrintable(lesson.id + '/' + step.id + ' ' + id));
                }
            }
        }
        QVERIFY(seen > 50);
    }

    void aSymbolHasANameAUnitAndASentence_data()
    {
        QTest::addColumn<QString>("line");
        QTest::addColumn<QString>("word");
        QTest::addColumn<QString>("unit");
        QTest::addColumn<bool>("parameter");
        QTest::newRow("pull") << "pull = k * d"
                              << "pull"
                              << "px/frame²" << false;
        QTest::newRow("k") << "pull = k * d"
                           << "k"
                           << "1/frame²" << true;
        QTest::newRow("d") << "pull = k * d"
                           << "d;"
                           << "px" << false;
        QTest::newRow("x") << "x = x + h * v"
                           << "x"
                           << "px" << false;
        QTest::newRow("v") << "v = keep * v"
                           << "v"
                           << "px/frame" << false;
    }
    void aSymbolHasANameAUnitAndASentence()
    {
        QFETCH(QString, line);
        QFETCH(QString, word);
        QFETCH(bool, parameter);
        const lessons::Step &step = stepOf("gravity_walls", "gravity");
        const sim::Timeline run = runOf(step);
        const auto symbol = symbolOf(step, run, line, word);
        QVERIFY(symbol);
        QTEST(symbol->unit, "unit");
        QCOMPARE(!symbol->parameter.isEmpty(), parameter);
        QVERIFY(symbol->what.endsWith('.'));
    }

    void historyOfEverySymbolCanBeRead_data() { everyStepAndMethod(); }
    void historyOfEverySymbolCanBeRead()
    {
        QFETCH(QString, lesson);
        QFETCH(QString, step);
        QFETCH(QString, method);
        const lessons::Step &its = stepOf(lesson, step);
        sim::Timeline run = runOf(its, method);
        if (run.state().pointCount() > 200)
            QSKIP("too many points to look back at each word");
        run.seek({3, 1});
        const CodeListing listing = listingOf(its, run);
        const sim::ComposedInterval &interval = run.track().interval();
        const std::vector<ParameterSpot> spots = parameterSpots(listing, its, interval);
        int found = 0;
        for (std::size_t s = 0; s < listing.sections.size(); ++s) {
            for (std::size_t i = 0; i < listing.sections[s].lines.size(); ++i) {
                for (const CodeWord &word : wordsOf(listing.sections[s].lines[i].source.text)) {
                    const auto symbol = symbolAt(listing, s, i, word.from, spots, its, interval, 0);
                    if (!symbol)
                        continue;
                    ++found;
                    for (const auto &sample :
                         historyOf(*symbol, run.track(), interval.scene.names[0]).samples)
                        QVERIFY(sample.frame <= 4); // a row of one phase is done by now
                }
            }
        }
        QVERIFY(found > 0);
    }

    void aWordWithoutANumberIsNoSymbol()
    {
        const lessons::Step &step = stepOf("gravity_walls", "gravity");
        const sim::Timeline run = runOf(step);
        QVERIFY(!symbolOf(step, run, "Vec2 d = target", "Vec2"));
        QVERIFY(!symbolOf(step, run, "pull = k * d", "="));
        QVERIFY(!symbolOf(step, run, "Scene scene", "scene"));
    }

    void aHistoryHasTheNumbersOfEachFrame_data()
    {
        QTest::addColumn<double>("h");
        QTest::addColumn<int>("phase");
        QTest::newRow("between frames") << 1.0 << 0;
        QTest::newRow("inside a frame, before the phase") << 1.0 << 1;
        QTest::newRow("inside a frame, after it") << 1.0 << 4;
        QTest::newRow("half steps") << 0.5 << 0;
    }
    void aHistoryHasTheNumbersOfEachFrame()
    {
        QFETCH(double, h);
        QFETCH(int, phase);
        const lessons::Step &step = stepOf("gravity_walls", "gravity");
        sim::Script script = step.script();
        script.method = sim::findMethod("semi_implicit_euler");
        script.step = sim::StepSize::ofLength(h);
        sim::Timeline run(script);
        const auto symbol = symbolOf(step, run, "x = x + h * v", "x");
        QVERIFY(symbol);
        run.seek({140, phase});
        const CodeHistory history = historyOf(*symbol, run.track(), "foot1");
        // Places change in one phase only: the walls are not met by this foot in a frame that counts here.
        const bool isDone = phase > symbol->phase;
        QCOMPARE(history.samples.size(), std::size_t(historyFrames + isDone));
        QCOMPARE(history.samples.back().frame, std::int64_t(140 + isDone));
        QVERIFY(history.isPair());
        sim::Timeline other(script);
        for (const CodeHistory::Sample &sample : history.samples) {
            const int last = script.step.stepsPerOutput * other.track().interval().pipeline.phasesPerStep() -
                             other.track().interval().pipeline.phasesPerStep();
            other.seek({sample.frame - 1, last + symbol->phase + 1});
            const sim::Vec2 there = other.state().positionOf(1);
            QCOMPARE(std::get<sim::Vec2>(sample.value), there);
        }
    }

    void aPartOfAPairHasItsOwnHistory()
    {
        const lessons::Step &step = stepOf("gravity_walls", "gravity");
        sim::Timeline run = runOf(step);
        const auto symbol = symbolOf(step, run, "v.y *=", "v.y");
        QVERIFY(symbol);
        run.seek({100, 0});
        const CodeHistory history = historyOf(*symbol, run.track(), "foot0");
        QVERIFY(!history.isPair());
        // The walls change it where the foot meets one, and nowhere else.
        std::vector<std::pair<std::int64_t, double>> expected, got;
        sim::Timeline other = runOf(step);
        for (std::int64_t frame = 0; frame < 100; ++frame) {
            other.seek({frame, symbol->phase});
            const sim::State before = other.state();
            other.seek({frame, symbol->phase + 1});
            if (before.velocityOf(0) != other.state().velocityOf(0))
                expected.push_back({frame + 1, other.state().velocityOf(0).y});
        }
        for (const CodeHistory::Sample &sample : history.samples)
            got.push_back({sample.frame, std::get<double>(sample.value)});
        QVERIFY(!got.empty());
        QVERIFY(got == expected);
    }

    void aParametersHistoryStepsWhereItWasSet()
    {
        const lessons::Step &step = stepOf("gravity_walls", "gravity");
        sim::Timeline run = runOf(step);
        run.seek({10, 0});
        run.setParameter("gravity", 2.0);
        run.seek({20, 0});
        const auto symbol = symbolOf(step, run, "Vec2 pull = {0, gravity}", "gravity");
        QVERIFY(symbol);
        const std::vector<CodeHistory::Sample> samples = historyOf(*symbol, run.track(), "foot0").samples;
        QVERIFY(samples.size() > 1);
        for (const CodeHistory::Sample &sample : samples)
            QCOMPARE(std::get<double>(sample.value), sample.frame < 10 ? 0.5 : 2.0);
    }
};

SUITE(tst_code_symbols, TestCodeSymbols)
#include "tst_code_symbols.moc"
