// Random experiment files. A file is refused with a sentence, or its run shows and writes only finite numbers.
// Environment variables choose other files:
//   SPRINGSTEP_RANDOM_SEED   the seed, 1 to begin with
//   SPRINGSTEP_RANDOM_COUNT  how many
//   SPRINGSTEP_RANDOM_FIRST  the number of the first, 1 to begin with: many can be done in slices, one after the other
//   SPRINGSTEP_RANDOM_ONLY   the number of a single one

#include "tests/app/experiment/random_trial.h"
#include "tests/sizes.h"
#include "tests/suite.h"

#include <QTest>

#include <map>

using namespace random_experiments;

namespace {

constexpr std::uint64_t inARow = 250;

}

class TestRandomExperiments : public QObject
{
    Q_OBJECT

    const app::LessonLibrary m_library = app::LessonLibrary::load({LESSON_DIR});
    const Experiments m_experiments{m_library};
    const std::uint64_t m_seed = tests::setting<std::uint64_t>("SPRINGSTEP_RANDOM_SEED", 1);
    const std::uint64_t m_count =
        tests::setting<std::uint64_t>("SPRINGSTEP_RANDOM_COUNT", RANDOM_EXPERIMENTS);
    const std::uint64_t m_first = tests::setting<std::uint64_t>("SPRINGSTEP_RANDOM_FIRST", 1);
    std::map<Outcome::End, std::uint64_t> m_ends;
    std::map<QString, std::uint64_t> m_lessons;
    std::map<QString, std::uint64_t> m_methods;

    Outcome outcomeOf(std::uint64_t number)
    {
        Draw draw(m_seed, number);
        const QByteArray text = m_experiments.text(draw);
        const Outcome outcome = tried(text, m_library, draw);
        if (!outcome.fault.isEmpty())
            qWarning("Seed %llu, number %llu:\n%s", static_cast<unsigned long long>(m_seed),
                     static_cast<unsigned long long>(number), text.constData());
        return outcome;
    }

private slots:
    void initTestCase()
    {
        QVERIFY(!m_experiments.steps().empty());
        qInfo("%llu experiments from seed %llu, from number %llu", static_cast<unsigned long long>(m_count),
              static_cast<unsigned long long>(m_seed), static_cast<unsigned long long>(m_first));
    }

    void anyExperimentIsRefusedWithASentenceOrRunsAndStaysFinite_data()
    {
        QTest::addColumn<std::uint64_t>("first");
        QTest::addColumn<std::uint64_t>("end");
        if (const std::uint64_t only = tests::setting<std::uint64_t>("SPRINGSTEP_RANDOM_ONLY", 0)) {
            QTest::addRow("number %llu", static_cast<unsigned long long>(only)) << only << only + 1;
            return;
        }
        const std::uint64_t last = m_first + m_count;
        for (std::uint64_t first = m_first; first < last; first += inARow) {
            const std::uint64_t end = std::min(first + inARow, last);
            QTest::addRow("%llu to %llu", static_cast<unsigned long long>(first),
                          static_cast<unsigned long long>(end - 1))
                << first << end;
        }
    }
    void anyExperimentIsRefusedWithASentenceOrRunsAndStaysFinite()
    {
        QFETCH(std::uint64_t, first);
        QFETCH(std::uint64_t, end);
        int faults = 0;
        for (std::uint64_t number = first; number < end; ++number) {
            const Outcome outcome = outcomeOf(number);
            ++m_ends[outcome.end];
            ++m_lessons[outcome.lesson];
            ++m_methods[outcome.method];
            if (outcome.fault.isEmpty())
                continue;
            ++faults;
            qWarning("%s", qPrintable(outcome.fault));
        }
        QCOMPARE(faults, 0);
    }

    /// Makes sure that the test above covers every kind of experiment.
    void experimentsCoverEveryKindOfLessonMethodAndOutcome()
    {
        if (qEnvironmentVariableIsSet("SPRINGSTEP_RANDOM_ONLY"))
            QSKIP("one alone");
        qInfo("refused %llu, stopped %llu", static_cast<unsigned long long>(m_ends[Outcome::End::refused]),
              static_cast<unsigned long long>(m_ends[Outcome::End::stopped]));
        for (const auto &[end, count] : m_ends)
            QVERIFY2(count * 100 >= m_count, qPrintable(QString::number(int(end))));
        QCOMPARE(m_ends.size(), std::size_t(3));
        for (const Known &known : m_experiments.steps()) {
            QVERIFY2(m_lessons[known.lesson] > 0, qPrintable(known.lesson));
            for (const QString &method : known.methods)
                QVERIFY2(m_methods[method] > 0, qPrintable(method));
        }
    }

    void equalSeedsGiveEqualExperiments()
    {
        Draw one(m_seed, 7), two(m_seed, 7), other(m_seed, 8);
        QCOMPARE(m_experiments.text(one), m_experiments.text(two));
        QVERIFY(m_experiments.text(one) != m_experiments.text(other));
    }
};

SUITE(tst_random_experiments, TestRandomExperiments)
#include "tst_random_experiments.moc"
