// Every lesson step gives the same bits with every instruction set, on one thread and on two, and with and
// without sleeping.

#include "tests/suite.h"

#include <QProcess>
#include <QTest>

#include <memory>
#include <vector>

namespace {

/// A setup of lesson_hashes.
struct HashSetup
{
    QString instructions; ///< value of SPRINGSTEP_INSTRUCTIONS; empty: the widest instruction set
    QString threads;      ///< number of threads; empty: as in the app, with sleeping
};

}

class SameBits : public QObject
{
    Q_OBJECT

    /// One process per setup. All run at the same time, to use all cores.
    std::vector<std::unique_ptr<QProcess>> m_programs;

    static std::vector<HashSetup> setups()
    {
        std::vector<HashSetup> all;
        for (const char *instructions : {"baseline", ""}) {
            for (const char *threads : {"", "1", "2"})
                all.push_back({QString::fromUtf8(instructions), QString::fromUtf8(threads)});
        }
        all.push_back({"avx2", {}});
        return all;
    }

    /// Returns the output lines of process `number`. The first line names the instruction set.
    QStringList printed(std::size_t number)
    {
        QProcess &program = *m_programs[number];
        program.waitForFinished(-1);
        if (program.exitStatus() != QProcess::NormalExit || program.exitCode() != 0)
            return {};
        return QString::fromLocal8Bit(program.readAllStandardOutput()).split('\n', Qt::SkipEmptyParts);
    }

    QStringList m_first; ///< output of the first setup

private slots:
    void initTestCase()
    {
        for (const HashSetup &setup : setups()) {
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

    void setupsGiveTheSameBits_data()
    {
        QTest::addColumn<std::size_t>("number");
        const std::vector<HashSetup> all = setups();
        for (std::size_t i = 1; i < all.size(); ++i) {
            const QString instructions = all[i].instructions.isEmpty() ? "widest" : all[i].instructions;
            const QString computation =
                all[i].threads.isEmpty() ? "with sleeping" : all[i].threads + " threads";
            QTest::addRow("%s, %s", qPrintable(instructions), qPrintable(computation)) << i;
        }
    }
    void setupsGiveTheSameBits()
    {
        QFETCH(std::size_t, number);
        const HashSetup setup = setups()[number];
        const QStringList lines = printed(number);
        QCOMPARE(lines.size(), m_first.size());
        if (setup.instructions != "baseline" && lines.first() == "baseline")
            QSKIP("this machine has no wider instructions");
        for (qsizetype i = 1; i < lines.size(); ++i)
            QCOMPARE(lines[i], m_first[i]);
    }
};

SUITE(tst_same_bits, SameBits)
#include "tst_same_bits.moc"
