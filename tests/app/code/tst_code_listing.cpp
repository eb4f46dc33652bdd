#include "sim/run/script/composed_interval.h"
#include "sim/run/script/script.h"
#include "tests/app/code/listing_support.h"
#include "tests/app/support/files.h"
#include "tests/suite.h"

#include <algorithm>

using namespace listing_support;

namespace {

QStringList linesOf(const QString &file)
{
    return QString::fromUtf8(tests::contentsOf(QStringLiteral(SOURCE_DIR "/") + file)).split('\n');
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

}

/// The code that the panel shows, cut from the files that were compiled.
class TestCodeListing : public QObject
{
    Q_OBJECT

private slots:
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
        for (int phase = 0; phase < run.track().interval().pipeline.phasesPerStep(); ++phase) {
            const auto with = std::count_if(listing.sections.begin(), listing.sections.end(),
                                            [phase](const CodeSection &one) { return one.has(phase); });
            QCOMPARE(with, 1);
        }
    }

    void everyShownLineHasItsLineNumberInTheFile_data() { everyStepAndMethod(); }
    void everyShownLineHasItsLineNumberInTheFile()
    {
        QFETCH(QString, lesson);
        QFETCH(QString, step);
        QFETCH(QString, method);
        const CodeListing listing = listingOf(stepOf(lesson, step), runOf(stepOf(lesson, step), method));
        int lines = 0;
        for (const CodeSection &section : listing.sections) {
            for (const CodeLine &line : section.lines) {
                const QStringList file = linesOf(line.file);
                QVERIFY2(line.source.number >= 1 && line.source.number <= file.size(), qPrintable(line.file));
                QCOMPARE(line.source.text.trimmed(), file[line.source.number - 1].trimmed());
                QVERIFY(!line.source.text.contains("//!"));
                ++lines;
            }
        }
        QVERIFY(lines > 0);
    }

    void indentationThatAllLinesShareIsNotShown()
    {
        SourceFiles book;
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
        QTest::newRow("no such marker") << "sim/effects/pairs/spring.h"
                                        << "sprung";
        QTest::newRow("a part of a marker") << "sim/effects/pairs/spring.h"
                                            << "spri";
    }
    void aRegionThatDoesNotExistHasNoText()
    {
        QFETCH(QString, file);
        QFETCH(QString, marker);
        QVERIFY(!SourceFiles().text({file.toStdString(), marker.toStdString()}));
    }

    void feetAndBodyShareTheSectionsOfTheSameWork()
    {
        const lessons::Step &step = stepOf("multi_foot", "any_number");
        const CodeListing listing = listingOf(step, runOf(step));
        QStringList titles;
        for (const CodeSection &section : listing.sections)
            titles << section.title;
        const QStringList expected = {"Scene", "Published: order of the phases", "1 Springs", "2 Damping",
                                      "3 Move"};
        QCOMPARE(titles, expected);
        QCOMPARE(listing.sections[2].phases, (std::vector<int>{0, 3}));
        QCOMPARE(listing.sections[4].phases, (std::vector<int>{2, 5}));
    }

    void listingHasNoNewLinesComparedWithItself_data() { everyStepAndMethod(); }
    void listingHasNoNewLinesComparedWithItself()
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
                                    << "values.integer(\"feet\")";
        QTest::newRow("gravity") << "gravity_walls"
                                 << "walls"
                                 << "gravity"
                                 << "fall(double gravity)";
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

    void listingHasNoRemovedLinesComparedWithItself_data() { everyStepAndMethod(); }
    void listingHasNoRemovedLinesComparedWithItself()
    {
        QFETCH(QString, lesson);
        QFETCH(QString, step);
        QFETCH(QString, method);
        CodeListing listing = listingOf(stepOf(lesson, step), runOf(stepOf(lesson, step), method));
        markGone(listing, CodeListing(listing));
        QCOMPARE(listing.goneLines(), 0);
        CodeListing empty = listing;
        markGone(empty, CodeListing());
        QCOMPARE(empty.goneLines(), 0);
    }

    /// Without the new lines and with the removed ones, the listing has the lines of the step before.
    void removedAndUnchangedLinesAreTheStepBefore_data()
    {
        QTest::addColumn<QString>("lesson");
        QTest::addColumn<QString>("before");
        QTest::addColumn<QString>("step");
        for (const LessonEntry &lesson : library().lessons) {
            for (std::size_t i = 1; i < lesson.steps.size(); ++i)
                QTest::addRow("%s/%s", qPrintable(lesson.id), qPrintable(lesson.steps[i].id))
                    << lesson.id << lesson.steps[i - 1].id << lesson.steps[i].id;
        }
    }
    void removedAndUnchangedLinesAreTheStepBefore()
    {
        QFETCH(QString, lesson);
        QFETCH(QString, before);
        QFETCH(QString, step);
        const sim::MethodPtr method = sim::findMethod(stepOf(lesson, step).method.toStdString());
        auto listing = listingAtStart(stepOf(lesson, step), method);
        const auto old = listingAtStart(stepOf(lesson, before), method);
        QVERIFY(listing && old);
        markNew(*listing, *old);
        markGone(*listing, *old);
        QCOMPARE(kept(*listing), kept(*old));
    }

    void removedLineIsShownAtItsFormerPosition()
    {
        const auto section = [](const QStringList &lines, const QString &file) {
            CodeSection made{CodeSection::Role::phase, "1 Springs", sim::EffectKind::spring, {0}, {}};
            for (int i = 0; i < lines.size(); ++i) {
                CodeLine line;
                line.source.text = lines[i];
                line.source.number = i + 1;
                line.file = file;
                made.lines.push_back(line);
            }
            return made;
        };
        const CodeListing old{{section({"first", "gone one", "second", "gone two", "}"}, "old.h"),
                               section({"gone three"}, "other.h")}};
        CodeListing listing{{section({"new", "first", "second", "}"}, "new.h")}};
        markGone(listing, old);
        const std::vector<GoneLine> &gone = listing.sections[0].gone;
        QCOMPARE(gone.size(), std::size_t{3});
        QCOMPARE(gone[0].text, QString("gone one"));
        QCOMPARE(gone[0].before, std::size_t{2}); // before "second"
        QCOMPARE(gone[1].text, QString("gone two"));
        QCOMPARE(gone[1].before, std::size_t{3});
        QCOMPARE(gone[2].text,
                 QString("gone three")); // its section is gone as a whole: at the end of the one before
        QCOMPARE(gone[2].before, std::size_t{4});
    }

private:
    /// Returns the lines with contents, each once, without the new lines and with the removed ones, sorted.
    static QStringList kept(const CodeListing &listing)
    {
        static const QRegularExpression nothing("^[{};\\s)]*$");
        QStringList lines;
        QSet<std::pair<QString, int>> counted;
        const auto add = [&lines](const QString &text) {
            if (!nothing.match(text).hasMatch())
                lines << text.simplified();
        };
        for (const CodeSection &section : listing.sections) {
            for (const CodeLine &line : section.lines) {
                const std::pair<QString, int> place(line.file, line.source.number);
                if (!line.isNew && !counted.contains(place))
                    add(line.source.text);
                counted.insert(place);
            }
            for (const GoneLine &line : section.gone)
                add(line.text);
        }
        lines.sort();
        return lines;
    }
};

SUITE(tst_code_listing, TestCodeListing)
#include "tst_code_listing.moc"
