#include "tests/app/listing_bench.h"

#include <QFile>

#include <algorithm>

using namespace listing_bench;

namespace {

QStringList linesOf(const QString &file)
{
    QFile source(QStringLiteral(SOURCE_DIR "/") + file);
    return source.open(QIODevice::ReadOnly) ? QString::fromUtf8(source.readAll()).split('\n') : QStringList();
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
};

QTEST_GUILESS_MAIN(TestCodeListing)
#include "tst_code_listing.moc"
