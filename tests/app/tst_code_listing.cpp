#include "app/model/code_marks.h"
#include "app/model/lesson_library.h"
#include "sim/methods/methods.h"

#include <QFile>
#include <QTest>

#include <algorithm>

using namespace app;

namespace {

const LessonLibrary &library()
{
    static const LessonLibrary loaded = LessonLibrary::load({LESSON_DIR});
    return loaded;
}

const lessons::Step &stepOf(const QString &lesson, const QString &step)
{
    return *library().lesson(lesson)->step(step);
}

sim::Timeline runOf(const lessons::Step &step, const QString &method = "published")
{
    sim::Script script = step.script();
    script.method = sim::findMethod(method.toStdString());
    return sim::Timeline(std::move(script));
}

CodeListing listingOf(const lessons::Step &step, const sim::Timeline &run)
{
    return app::listingOf(step, run.track().shown(), *run.script().method);
}

/// A row for every step of every lesson with every method.
void everyStepAndMethod()
{
    QTest::addColumn<QString>("lesson");
    QTest::addColumn<QString>("step");
    QTest::addColumn<QString>("method");
    for (const LessonEntry &lesson : library().lessons) {
        for (const lessons::Step &step : lesson.steps) {
            for (const sim::MethodPtr &method : sim::allMethods()) {
                const QString id = QString::fromStdString(method->id());
                QTest::addRow("%s/%s, %s", qPrintable(lesson.id), qPrintable(step.id), qPrintable(id))
                    << lesson.id << step.id << id;
            }
        }
    }
}

QStringList linesOf(const QString &file)
{
    QFile source(QStringLiteral(SOURCE_DIR "/") + file);
    return source.open(QIODevice::ReadOnly) ? QString::fromUtf8(source.readAll()).split('\n') : QStringList();
}

QString textAt(const CodeListing &listing, const CodeChip &chip)
{
    return listing.sections[chip.section].lines[chip.line].source.text.trimmed();
}

QStringList texts(const CodeListing &listing, bool onlyNew = false)
{
    QStringList all;
    for (const CodeSection &section : listing.sections) {
        for (const CodeLine &line : section.lines) {
            if (!onlyNew || line.isNew)
                all << line.source.text.simplified();
        }
    }
    return all;
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
    const sim::Segment &segment = run.track().shown();
    return chipsOf(listing, run.track().moments(body), segment, segment.scene.find(body));
}

}

/// The code that the panel shows, its values and its marks.
class TestCodeListing : public QObject
{
    Q_OBJECT

private slots:
    void thereAreLessons() { QVERIFY(library().lessons.size() >= 4); }

    void everyPhaseHasOneSectionWithLines_data() { everyStepAndMethod(); }
    void everyPhaseHasOneSectionWithLines()
    {
        QFETCH(QString, lesson);
        QFETCH(QString, step);
        QFETCH(QString, method);
        const sim::Timeline run = runOf(stepOf(lesson, step), method);
        const CodeListing listing = listingOf(stepOf(lesson, step), run);
        QVERIFY(listing.sections[0].role == CodeSection::Role::scene);
        QVERIFY(listing.sections[1].role == CodeSection::Role::order);
        for (const CodeSection &section : listing.sections)
            QVERIFY2(!section.lines.empty(), qPrintable(section.title));
        for (int phase = 0; phase < run.track().shown().pipeline.phasesPerStep(); ++phase) {
            const auto with = std::count_if(listing.sections.begin(), listing.sections.end(),
                                            [phase](const CodeSection &one) { return one.has(phase); });
            QCOMPARE(with, 1);
        }
    }

    void everyShownLineStandsInItsFileUnderItsNumber_data() { everyStepAndMethod(); }
    void everyShownLineStandsInItsFileUnderItsNumber()
    {
        QFETCH(QString, lesson);
        QFETCH(QString, step);
        QFETCH(QString, method);
        const CodeListing listing = listingOf(stepOf(lesson, step), runOf(stepOf(lesson, step), method));
        for (const CodeSection &section : listing.sections) {
            for (const CodeLine &line : section.lines) {
                const QStringList file = linesOf(line.file);
                QVERIFY2(line.source.number >= 1 && line.source.number <= file.size(), qPrintable(line.file));
                QCOMPARE(line.source.text.trimmed(), file[line.source.number - 1].trimmed());
                QVERIFY(!line.source.text.contains("//!"));
            }
        }
    }

    void indentationThatAllLinesShareIsNotShown()
    {
        SourceBook book;
        const auto order = book.text(sim::findMethod("published")->region());
        QVERIFY(order);
        QVERIFY(!order->front().text.startsWith(' '));
        QVERIFY(std::any_of(order->begin(), order->end(),
                            [](const SourceLine &line) { return line.text.startsWith("    "); }));
    }

    void aRegionThatDoesNotExistHasNoText_data()
    {
        QTest::addColumn<QString>("file");
        QTest::addColumn<QString>("marker");
        QTest::newRow("no such file") << "sim/effects/nothing.h"
                                      << "spring";
        QTest::newRow("no such marker") << "sim/effects/spring.h"
                                        << "sprung";
        QTest::newRow("a part of a marker") << "sim/effects/spring.h"
                                            << "spri";
    }
    void aRegionThatDoesNotExistHasNoText()
    {
        QFETCH(QString, file);
        QFETCH(QString, marker);
        QVERIFY(!SourceBook().text({file.toStdString(), marker.toStdString()}));
    }

    void feetAndBodyShareTheSectionsOfTheSameWork()
    {
        const lessons::Step &step = stepOf("multi_foot", "any_number");
        const CodeListing listing = listingOf(step, runOf(step));
        QStringList titles;
        for (const CodeSection &section : listing.sections)
            titles << section.title;
        const QStringList expected = {"Scene", "Published: the order", "1 Springs", "2 Damping", "3 Move"};
        QCOMPARE(titles, expected);
        QCOMPARE(listing.sections[2].phases, (std::vector<int>{0, 3}));
        QCOMPARE(listing.sections[4].phases, (std::vector<int>{2, 5}));
    }

    void noValueIsLost_data() { everyStepAndMethod(); }
    void noValueIsLost()
    {
        QFETCH(QString, lesson);
        QFETCH(QString, step);
        QFETCH(QString, method);
        sim::Timeline run = runOf(stepOf(lesson, step), method);
        const CodeListing listing = listingOf(stepOf(lesson, step), run);
        for (int frame = 1; frame <= 60; ++frame) {
            run.stepRow();
            for (const std::string &body : run.track().shown().scene.names) {
                for (const sim::Moment &moment : run.track().moments(body)) {
                    const auto section =
                        std::find_if(listing.sections.begin(), listing.sections.end(),
                                     [&](const CodeSection &one) { return one.has(moment.phase); });
                    QVERIFY(section != listing.sections.end());
                    for (const sim::Live &live : moment.live)
                        QVERIFY2(lineOf(*section, live), live.name.c_str());
                }
            }
        }
    }

    void aValueStandsOnTheLineThatAssignsIt_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QString>("line");
        QTest::newRow("from") << "from"
                              << "from = mover - anchor";
        QTest::newRow("angle") << "angle"
                               << "angle = std::atan2";
        QTest::newRow("d") << "d"
                           << "d = target - mover";
        QTest::newRow("pull") << "pull"
                              << "pull = k * d";
        QTest::newRow("v") << "v"
                           << "v = keep * v";
        QTest::newRow("x") << "x"
                           << "x = x + h * v";
        QTest::newRow("velocity") << "velocity"
                                  << "force.add";
    }
    void aValueStandsOnTheLineThatAssignsIt()
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

    void aBounceOnTheFloorStandsOnTheFloorsLines()
    {
        const lessons::Step &step = stepOf("gravity_walls", "gravity");
        sim::Timeline run = runOf(step);
        const CodeListing listing = listingOf(step, run);
        for (int frame = 0; frame < 600; ++frame) {
            run.stepRow();
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

    void numbersHaveThreeDigitsOrSoAndARealMinusSign_data()
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
    }
    void numbersHaveThreeDigitsOrSoAndARealMinusSign()
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
        run.set("feet", 7);
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

    void nothingIsNewAgainstItself_data() { everyStepAndMethod(); }
    void nothingIsNewAgainstItself()
    {
        QFETCH(QString, lesson);
        QFETCH(QString, step);
        QFETCH(QString, method);
        CodeListing listing = listingOf(stepOf(lesson, step), runOf(stepOf(lesson, step), method));
        markNew(listing, CodeListing(listing));
        QCOMPARE(listing.newLines(), 0);
        markNew(listing, CodeListing());
        QVERIFY(listing.newLines() > 0);
    }

    void theStepShowsWhatItsCodeChanged_data()
    {
        QTest::addColumn<QString>("lesson");
        QTest::addColumn<QString>("before");
        QTest::addColumn<QString>("step");
        QTest::addColumn<QString>("line"); ///< a part of one that is new
        QTest::newRow("radial") << "single_spring"
                                << "offset"
                                << "radial"
                                << "radius * out";
        QTest::newRow("any number") << "multi_foot"
                                    << "two_feet"
                                    << "any_number"
                                    << "values.whole(\"feet\")";
        QTest::newRow("gravity") << "gravity_walls"
                                 << "walls"
                                 << "gravity"
                                 << "double pull = gravity;";
    }
    void theStepShowsWhatItsCodeChanged()
    {
        QFETCH(QString, lesson);
        QFETCH(QString, before);
        QFETCH(QString, step);
        QFETCH(QString, line);
        CodeListing listing = listingOf(stepOf(lesson, step), runOf(stepOf(lesson, step)));
        const auto old = listingAtStart(stepOf(lesson, before), sim::findMethod("published"));
        QVERIFY(old);
        markNew(listing, *old);
        const QStringList had = texts(*old);
        const QStringList fresh = texts(listing, true);
        QVERIFY2(
            std::any_of(fresh.begin(), fresh.end(), [&](const QString &one) { return one.contains(line); }),
            qPrintable(fresh.join('\n')));
        QVERIFY(fresh.size() < texts(listing).size());
        for (const QString &one : fresh) {
            QVERIFY2(one.size() > 2, "a lone brace or a blank line");
            QVERIFY2(had.count(one) < texts(listing).count(one), qPrintable(one));
        }
    }

    void betweenFramesNothingIsMarked()
    {
        const lessons::Step &step = stepOf("multi_foot", "any_number");
        sim::Timeline run = runOf(step);
        const CodeListing listing = listingOf(step, run);
        run.seek({4, 0});
        QCOMPARE(whens(marksOf(listing, run, {}, 0)), QList<When>(5, When::plain));
    }

    void insideAFrameSectionsAreDoneNowOrToCome_data()
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
    void insideAFrameSectionsAreDoneNowOrToCome()
    {
        QFETCH(QString, body);
        QFETCH(int, phase);
        const lessons::Step &step = stepOf("multi_foot", "any_number");
        sim::Timeline run = runOf(step);
        run.seek({4, phase});
        const CodeListing listing = listingOf(step, run);
        const std::vector<CodeChip> chips = chipsAt(listing, run, body.toStdString());
        const std::vector<SectionMark> marks =
            marksOf(listing, run, chips, run.track().shown().scene.find(body.toStdString()));
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
        const int body = run.track().shown().scene.find("body");
        const auto marks = marksOf(listing, run, chipsAt(listing, run, "body"), body);
        const auto now = std::find_if(marks.begin(), marks.end(),
                                      [](const SectionMark &mark) { return mark.when == When::now; });
        QVERIFY(now != marks.end());
        const CodeSection &section = listing.sections[static_cast<std::size_t>(now - marks.begin())];
        QCOMPARE(section.title, QString("2 Gravity"));
        QVERIFY(section.lines[*now->result].source.text.contains("pull = gravity"));
        QVERIFY(now->selected);
        QCOMPARE(now->note, QString("now · 5 points"));
    }

    void halfStepsAreMarkedAsWholeOnesAre()
    {
        const lessons::Step &step = stepOf("single_spring", "radial");
        sim::Script script = step.script();
        script.step = sim::StepSize::of(0.5);
        sim::Timeline run(std::move(script));
        const int perStep = run.track().shown().pipeline.phasesPerStep();
        const CodeListing listing = listingOf(step, run);
        run.seek({4, 1});
        const QList<When> first = whens(marksOf(listing, run, {}, 0));
        run.seek({4, perStep + 1});
        QCOMPARE(run.at().phase, perStep + 1);
        QCOMPARE(whens(marksOf(listing, run, {}, 0)), first);
        QVERIFY(first.contains(When::now));
    }
};

QTEST_GUILESS_MAIN(TestCodeListing)
#include "tst_code_listing.moc"
