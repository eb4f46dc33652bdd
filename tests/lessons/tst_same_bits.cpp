// The same input gives the same bits whatever instructions a machine has: every step of every lesson, run with the
// widest ones that there are and with those that every machine has.

#include <QProcess>
#include <QTest>

class SameBits : public QObject
{
    Q_OBJECT

    /// What lesson_hashes prints, line by line. The first line says which instructions it ran with.
    static QStringList hashesWith(const QString &instructions)
    {
        QProcess program;
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.insert("SPRINGSTEP_INSTRUCTIONS", instructions);
        program.setProcessEnvironment(environment);
        program.start(LESSON_HASHES, QStringList());
        program.waitForFinished(-1);
        if (program.exitStatus() != QProcess::NormalExit || program.exitCode() != 0)
            return {};
        return QString::fromLocal8Bit(program.readAllStandardOutput()).split('\n', Qt::SkipEmptyParts);
    }

private slots:
    void instructionsChangeNoBitOfAnyLesson()
    {
        const QStringList baseline = hashesWith("baseline"), widest = hashesWith({});
        QVERIFY(baseline.size() > 50);
        QCOMPARE(baseline.first(), QString("baseline"));
        if (widest.value(0) != "wide")
            QSKIP("this machine has no wider instructions");
        QCOMPARE(widest.mid(1), baseline.mid(1));
    }
};

QTEST_GUILESS_MAIN(SameBits)
#include "tst_same_bits.moc"
