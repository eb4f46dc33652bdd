#include "sim/run/script/composed_interval.h"
#include "sim/run/script/script.h"
#include "tests/app/code/listing_support.h"
#include "tests/suite.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <string>
#include <utility>

using namespace listing_support;

namespace {

QString textAt(const CodeListing &listing, const CodeChip &chip)
{
    return listing.sections[chip.section].lines[chip.line].source.text.trimmed();
}

QList<When> whens(const std::vector<SectionMark> &marks)
{
    QList<When> all;
    for (const SectionMark &mark : marks)
        all << mark.when;
    return all;
}

std::vector<CodeChip> chipsAt(const CodeListing &listing, const sim::Timeline &run, const std::string &body)
{
    const sim::ComposedInterval &interval = run.track().interval();
    return chipsOf(listing, run.track().explainPhases(body), interval, interval.scene.find(body));
}

}

/// The values beside the shown code, and its finished, current and pending sections.
class TestCodeValues : public QObject
{
    Q_OBJECT

private slots:
    void noValueIsLost_data() { everyStepAndMethod(); }
    void noValueIsLost()
    {
        QFETCH(QString, lesson);
        QFETCH(QString, step);
        QFETCH(QString, method);
        sim::Timeline run = runOf(stepOf(lesson, step), method);
        const CodeListing listing = listingOf(stepOf(lesson, step), run);
        const int frames = run.state().pointCount() > 20 ? 10 : 60;
        // Only the phase and the name decide on which line a value is shown.
        std::set<std::pair<int, std::string>> found;
        for (int frame = 1; frame <= frames; ++frame) {
            run.nextOutputStep();
            const std::vector<std::string> &names = run.track().interval().scene.names;
            for (std::size_t i = 0; i < names.size(); i += 1 + names.size() / 12) {
                const std::string &body = names[i];
                for (const sim::PhaseExplanation &moment : run.track().explainPhases(body)) {
                    const auto section =
                        std::find_if(listing.sections.begin(), listing.sections.end(),
                                     [&](const CodeSection &one) { return one.has(moment.phase); });
                    QVERIFY(section != listing.sections.end());
                    for (const sim::LiveValue &live : moment.live) {
                        if (found.emplace(moment.phase, live.name).second)
                            QVERIFY2(lineOf(*section, live), live.name.c_str());
                    }
                }
            }
        }
        QVERIFY(!found.empty() || step == "drag"); // its foot feels no force
    }

    void valueIsShownOnTheLineThatAssignsIt_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QString>("line");
        QTest::newRow("from") << "from"
                              << "from = mover - anchor";
        QTest::newRow("angle") << "angle"
                               << "angle = atan2";
        QTest::newRow("d") << "d"
                           << "d = target - mover";
        QTest::newRow("pull") << "pull"
                              << "pull = k * d";
        QTest::newRow("v") << "v"
                           << "v = keep * v";
        QTest::newRow("x") << "x"
                           << "x = x + h * v";
        QTest::newRow("velocity") << "velocity"
                                  << "state.velocity";
    }
    void valueIsShownOnTheLineThatAssignsIt()
    {
        QFETCH(QString, name);
        QFETCH(QString, line);
        const lessons::Step &step = stepOf("single_spring", "radial");
        sim::Timeline run = runOf(step);
        run.seek({3, 0});
        const CodeListing listing = listingOf(step, run);
        const std::vector<CodeChip> chips = chipsAt(listing, run, "foot");
        const auto chip = std::find_if(chips.begin(), chips.end(),
                                       [&](const CodeChip &one) { return one.tip.startsWith(name + ':'); });
        QVERIFY(chip != chips.end());
        QVERIFY2(textAt(listing, *chip).contains(line), qPrintable(textAt(listing, *chip)));
    }

    void bounceIsShownOnTheLinesOfTheFloor()
    {
        const lessons::Step &step = stepOf("gravity_walls", "gravity");
        sim::Timeline run = runOf(step);
        const CodeListing listing = listingOf(step, run);
        for (int frame = 0; frame < 600; ++frame) {
            run.nextOutputStep();
            for (const CodeChip &chip : chipsAt(listing, run, "foot0")) {
                if (!chip.tip.startsWith("v.y"))
                    continue;
                const CodeSection &walls = listing.sections[chip.section];
                QVERIFY(walls.title.endsWith("Walls"));
                QVERIFY(textAt(listing, chip).startsWith("v.y"));
                QVERIFY(walls.lines[chip.line - 1].source.text.contains("room.floor"));
                QVERIFY(chip.text.contains("→"));
                return;
            }
        }
        QFAIL("the foot never met the floor");
    }

    void numbersHaveAboutThreeDigitsAndARealMinusSign_data()
    {
        QTest::addColumn<double>("value");
        QTest::addColumn<QString>("shown");
        QTest::newRow("zero") << 0.0 << "0";
        QTest::newRow("minus zero") << -0.0 << "0";
        QTest::newRow("hundreds") << 347.84 << "347.8";
        QTest::newRow("tens") << -55.21 << "−55.2";
        QTest::newRow("ones") << 7.318 << "7.32";
        QTest::newRow("tenths") << -0.2749 << "−0.27";
        QTest::newRow("hundredths") << 0.02749 << "0.027";
        QTest::newRow("thousandths") << 0.002749 << "0.0027";
        QTest::newRow("huge") << 1.23e9 << "1.2e9";
        QTest::newRow("tiny") << -1.23e-7 << "−1.2e−7";
        QTest::newRow("past all numbers") << std::numeric_limits<double>::infinity() << "too large";
        QTest::newRow("no number") << std::nan("") << "none";
    }
    void numbersHaveAboutThreeDigitsAndARealMinusSign()
    {
        QFETCH(double, value);
        QTEST(shownNumber(value), "shown");
    }

    void aPairHasOneScale()
    {
        QCOMPARE(shownValue(sim::Vec2{15.71, -55.24}), QString("(15.7, −55.2)"));
        QCOMPARE(shownValue(sim::Vec2{-0.18, -0.0585}), QString("(−0.18, −0.06)"));
        QCOMPARE(shownValue(sim::Vec2{100.0, -1e-16}), QString("(100.0, 0.0)"));
    }

    void setUpLinesShowTheParametersThatTheyRead()
    {
        const lessons::Step &step = stepOf("multi_foot", "any_number");
        sim::Timeline run = runOf(step);
        run.setParameter("feet", 7);
        const CodeListing listing = listingOf(step, run);
        int feet = 0;
        for (const CodeChip &chip : parameterChips(listing, step, run.values())) {
            QVERIFY(listing.sections[chip.section].role == CodeSection::Role::scene);
            const QString id = chip.text.section(' ', 0, 0);
            QVERIFY2(textAt(listing, chip).contains('"' + id + '"'), qPrintable(chip.text));
            feet += chip.text == "feet 7";
        }
        QCOMPARE(feet, 1);
    }

    void beforeTheFirstFrameNothingIsMarked()
    {
        const lessons::Step &step = stepOf("multi_foot", "any_number");
        const sim::Timeline run = runOf(step);
        const CodeListing listing = listingOf(step, run);
        QCOMPARE(whens(marksOf(listing, run, {}, 0)), QList<When>(5, When::plain));
    }

    void phaseThatJustRanIsCurrentIncludingTheLastOne_data()
    {
        QTest::addColumn<QString>("method");
        QTest::newRow("group after group") << "published";
        QTest::newRow("all at once") << "semi_implicit_euler";
    }
    void phaseThatJustRanIsCurrentIncludingTheLastOne()
    {
        QFETCH(QString, method);
        const lessons::Step &step = stepOf("gravity_walls", "gravity");
        sim::Timeline run = runOf(step, method);
        const CodeListing listing = listingOf(step, run);
        run.seek({4, 0});
        const int phases = run.track().phasesPerOutput();
        for (int phase = 0; phase < phases; ++phase) {
            run.nextPhase();
            const std::vector<SectionMark> marks = marksOf(listing, run, {}, -1);
            for (std::size_t i = 0; i < marks.size(); ++i) {
                const bool isIt = listing.sections[i].has(phase);
                QCOMPARE(marks[i].when == When::now, isIt);
                QCOMPARE(marks[i].result.has_value(), isIt);
            }
        }
        QCOMPARE(run.cursor(), (sim::Cursor{5, 0})); // what files and commands call this moment
        run.nextPhase();
        const std::vector<SectionMark> next = marksOf(listing, run, {}, -1);
        for (std::size_t i = 0; i < next.size(); ++i)
            QCOMPARE(next[i].when == When::now, listing.sections[i].has(0));
    }

    void theMarkedLineIsAFormulaOfTheEffectAndNotPlumbing_data() { everyStepAndMethod(); }
    void theMarkedLineIsAFormulaOfTheEffectAndNotPlumbing()
    {
        QFETCH(QString, lesson);
        QFETCH(QString, step);
        QFETCH(QString, method);
        sim::Timeline run = runOf(stepOf(lesson, step), method);
        const CodeListing listing = listingOf(stepOf(lesson, step), run);
        const int phases = run.track().interval().pipeline.phasesPerStep();
        run.seek({2, 0});
        int marked = 0;
        for (int phase = 0; phase < std::min(phases, 12); ++phase) {
            run.nextPhase();
            const sim::Scene &scene = run.track().interval().scene;
            for (const std::string &body : {scene.names.front(), scene.names.back()}) {
                const auto chips = chipsAt(listing, run, body);
                for (std::size_t i = 0;
                     const SectionMark &mark : marksOf(listing, run, chips, scene.find(body))) {
                    const CodeSection &section = listing.sections[i++];
                    if (!mark.result)
                        continue;
                    ++marked;
                    const QString text = section.lines[*mark.result].source.text;
                    QVERIFY2(!text.contains("force.add(") && !text.contains("torque.add("), qPrintable(text));
                    QVERIFY2(!section.lines[*mark.result].isPlumbing, qPrintable(text));
                }
            }
        }
        QVERIFY(marked > 0);
    }

    void theMarkOfASpringIsHookesLaw()
    {
        const lessons::Step &step = stepOf("single_spring", "fixed_centre");
        for (const char *method : {"published", "semi_implicit_euler"}) {
            sim::Timeline run = runOf(step, method);
            const CodeListing listing = listingOf(step, run);
            run.seek({3, 1});
            const auto marks = marksOf(listing, run, chipsAt(listing, run, "foot"), 0);
            const auto now = std::find_if(marks.begin(), marks.end(),
                                          [](const SectionMark &mark) { return mark.when == When::now; });
            QVERIFY(now != marks.end() && now->result);
            const auto &lines = listing.sections[static_cast<std::size_t>(now - marks.begin())].lines;
            QVERIFY2(lines[*now->result].source.text.contains("pull = k * d"),
                     qPrintable(lines[*now->result].source.text));
        }
    }

    void roundingErrorsAreShownAsZeroWithTheValueInTheToolTip()
    {
        const lessons::Step &step = stepOf("single_spring", "fixed_centre");
        sim::Timeline run = runOf(step, "semi_implicit_euler");
        const CodeListing listing = listingOf(step, run);
        run.seek({4, 0});
        std::vector<sim::PhaseExplanation> moments = run.track().explainPhases("foot");
        bool any = false;
        for (sim::PhaseExplanation &moment : moments) {
            for (sim::LiveValue &live : moment.live) {
                if (live.name != "pull")
                    continue;
                live.value = sim::Vec2{-3.3e-18, 1.9e-18};
                live.before.reset();
                any = true;
            }
        }
        QVERIFY(any);
        int found = 0;
        for (const CodeChip &chip : chipsOf(listing, moments, run.track().interval(), 0)) {
            if (!chip.tip.startsWith("pull: "))
                continue;
            ++found;
            QCOMPARE(chip.text, QString("(0, 0)"));
            QVERIFY2(chip.tip.contains("(−3.3e−18, 1.9e−18)"), qPrintable(chip.tip));
        }
        QCOMPARE(found, 1);
    }

    void noiseIsRelativeToTheScene()
    {
        sim::Scene scene = stepOf("single_spring", "fixed_centre")
                               .script()
                               .build(stepOf("single_spring", "fixed_centre").script().values);
        scene.start.position.setConstant(200.0);
        QCOMPARE(noiseOf(scene), 2e-10);
        scene.start.position.setConstant(-1e-6);
        QCOMPARE(noiseOf(scene), 1e-18); // what is small there is no noise
        scene.start.position.setZero();
        QCOMPARE(noiseOf(scene), 1e-12);
        const std::variant<double, sim::Vec2> pair = withoutNoise(sim::Vec2{1e-11, -3.0}, 2e-10);
        QCOMPARE(std::get<sim::Vec2>(pair).x, 0.0);
        QCOMPARE(std::get<sim::Vec2>(pair).y, -3.0);
    }

    void insideAFrameSectionsAreDoneCurrentOrPending_data()
    {
        QTest::addColumn<QString>("body");
        QTest::addColumn<int>("phase");
        QTest::addColumn<QList<When>>("sections");
        using enum When;
        // Feet: springs, damping, move; then the body: springs, damping, move.
        const auto row = [](const char *name, const char *body, int phase, const QList<When> &phases) {
            QTest::newRow(name) << body << phase << (QList<When>{plain, plain} + phases);
        };
        row("after the feet's springs", "foot0", 1, {now, next, later});
        row("after the feet's damping", "foot0", 2, {done, now, next});
        row("after the feet's move", "foot0", 3, {done, done, now});
        row("the same, seen from the body", "body", 3, {next, later, now});
        row("after the body's springs", "body", 4, {now, next, later});
        row("the same, seen from a foot", "foot0", 4, {now, done, done});
    }
    void insideAFrameSectionsAreDoneCurrentOrPending()
    {
        QFETCH(QString, body);
        QFETCH(int, phase);
        const lessons::Step &step = stepOf("multi_foot", "any_number");
        sim::Timeline run = runOf(step);
        run.seek({4, phase});
        const CodeListing listing = listingOf(step, run);
        const std::vector<CodeChip> chips = chipsAt(listing, run, body.toStdString());
        const std::vector<SectionMark> marks =
            marksOf(listing, run, chips, run.track().interval().scene.find(body.toStdString()));
        QTEST(whens(marks), "sections");
        for (std::size_t i = 0; i < marks.size(); ++i)
            QCOMPARE(marks[i].result.has_value(), marks[i].when == When::now);
    }

    void theResultIsTheLineOfTheLastValue()
    {
        const lessons::Step &step = stepOf("gravity_walls", "gravity");
        sim::Timeline run = runOf(step, "semi_implicit_euler");
        run.seek({4, 2});
        const CodeListing listing = listingOf(step, run);
        const int body = run.track().interval().scene.find("body");
        const auto marks = marksOf(listing, run, chipsAt(listing, run, "body"), body);
        const auto now = std::find_if(marks.begin(), marks.end(),
                                      [](const SectionMark &mark) { return mark.when == When::now; });
        QVERIFY(now != marks.end());
        const CodeSection &section = listing.sections[static_cast<std::size_t>(now - marks.begin())];
        QCOMPARE(section.title, QString("2 Gravity"));
        QVERIFY(section.lines[*now->result].source.text.contains("pull = "));
        QVERIFY(now->selected);
        QCOMPARE(now->note, QString("now · 5 points"));
    }

    void halfStepsAreMarkedAsWholeOnesAre()
    {
        const lessons::Step &step = stepOf("single_spring", "radial");
        sim::Script script = step.script();
        script.step = sim::StepSize::ofLength(0.5);
        sim::Timeline run(std::move(script));
        const int perStep = run.track().interval().pipeline.phasesPerStep();
        const CodeListing listing = listingOf(step, run);
        run.seek({4, 1});
        const QList<When> first = whens(marksOf(listing, run, {}, 0));
        run.seek({4, perStep + 1});
        QCOMPARE(run.cursor().phase, perStep + 1);
        QCOMPARE(whens(marksOf(listing, run, {}, 0)), first);
        QVERIFY(first.contains(When::now));
    }
};

SUITE(tst_code_values, TestCodeValues)
#include "tst_code_values.moc"
