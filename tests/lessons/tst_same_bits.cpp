// The same input gives the same bits whatever instructions a machine has, on one thread and on two, and whether what
// rests sleeps or is computed again and again: every step of every lesson.

#include <QProcess>
#include <QTest>

#include <memory>
#include <vector>

namespace {

/// How lesson_hashes runs.
struct Way
{
    QString instructions; ///< as SPRINGSTEP_INSTRUCTIONS says it; empty: the widest that there are
    QString threads;      ///< empty: as the app runs, which lets sleep what rests
};

}

class SameBits : public QObject
{
    Q_OBJECT

    /// All ways at once: a machine has more than one processor.
    std::vector<std::unique_ptr<QProcess>> m_programs;

    static std::vector<Way> ways()
    {
        std::vector<Way> all;
        for (const char *instructions : {"baseline", ""}) {
            for (const char *threads : {"", "1", "2"})
                all.push_back({QString::fromUtf8(instructions), QString::fromUtf8(threads)});
        }
        all.push_back({"avx2", {}});
        return all;
    }

    /// What program number `number` prints, line by line. The first line says which instructions it ran with.
    QStringList printed(std::size_t number)
    {
        QProcess &program = *m_programs[number];
        program.waitForFinished(-1);
        if (program.exitStatus() != QProcess::NormalExit || program.exitCode() != 0)
            return {};
        return QString::fromLocal8Bit(program.readAllStandardOutput()).split('\n', Qt::SkipEmptyParts);
    }

    QStringList m_first;

private slots:
    void initTestCase()
    {
        for (const Way &setup : ways()) {
            auto program = std::make_unique<QProcess>();
            QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
            environment.insert("SPRINGSTEP_INSTRUCTIONS", setup.instructions);
            program->setProcessEnvironment(environment);
            const QStringList arguments =
                setup.threads.isEmpty() ? QStringList() : QStringList{setup.threads};
            program->start(LESSON_HASHES, arguments);
            m_programs.push_back(std::move(program));
        }
        m_first = printed(0);
        QVERIFY(m_first.size() > 50);
        QCOMPARE(m_first.first(), QString("baseline"));
    }

    void everyWayComesToTheSameBits_data()
    {
        QTest::addColumn<std::size_t>("number");
        const std::vector<Way> all = ways();
        for (std::size_t i = 1; i < all.size(); ++i) {
            const QString instructions = all[i].instructions.isEmpty() ? "widest" : all[i].instructions;
            const QString how = all[i].threads.isEmpty() ? "asleep" : all[i].threads + " threads";
            QTest::addRow("%s, %s", qPrintable(instructions), qPrintable(how)) << i;
        }
    }
    void everyWayComesToTheSameBits()
    {
        QFETCH(std::size_t, number);
        const Way setup = ways()[number];
        const QStringList lines = printed(number);
        QCOMPARE(lines.size(), m_first.size());
        if (setup.instructions != "baseline" && lines.first() == "baseline")
            QSKIP("this machine has no wider instructions");
        for (qsizetype i = 1; i < lines.size(); ++i)
            QCOMPARE(lines[i], m_first[i]);
    }
};

QTEST_GUILESS_MAIN(SameBits)
#include "tst_same_bits.moc"
