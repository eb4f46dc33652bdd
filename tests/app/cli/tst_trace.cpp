#include "tests/app/cli/program.h"
#include "tests/app/support/files.h"
#include "tests/suite.h"

#include <QDir>
#include <QFile>
#include <QProcess>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>

#include <csignal>
#include <sys/types.h>

using namespace program;

/// `springstep trace`: the rows of a run, and every way in which a run can end.
class TestTrace : public QObject
{
    Q_OBJECT

private slots:
    void tracePrintsThePublishedTrajectory_data()
    {
        QTest::addColumn<QString>("path");
        for (const QFileInfo &info : QDir(TEST_DATA "/published").entryInfoList({"*.json"}))
            QTest::newRow(qPrintable(info.completeBaseName())) << info.absoluteFilePath();
    }

    void tracePrintsThePublishedTrajectory()
    {
        QFETCH(QString, path);
        const Answer answer = springstep({"trace", path});
        QCOMPARE(answer.code, 0);
        QCOMPARE(answer.err, QString());
        compareTrajectories(answer.out, tests::contentsOf(path.chopped(5) + ".csv"));
    }

    void aBuiltSceneIsTraced()
    {
        QTemporaryDir folder;
        QFile file(folder.filePath("built.json"));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(
            "{ \"format\": \"springstep-experiment/1\", \"lesson\": \"sandbox\", \"step\": \"build\",\n"
            "\"frames\": 40, \"parameters\": { \"gravity\": 0.25 },\n"
            "\"scene\": { \"bodies\": { \"stone\": { \"x\": 7, \"y\": 3, \"vx\": 2, \"mass\": 5 } },\n"
            "\"effects\": [\"gravity\"] } }");
        file.close();
        const Answer answer = springstep({"trace", file.fileName()});
        QCOMPARE(answer.err, QString());
        QCOMPARE(answer.code, 0);
        const QStringList rows = answer.out.trimmed().split('\n');
        QCOMPARE(rows.size(), qsizetype(42));
        QCOMPARE(rows.first(), QString("frame,body,x,y,vx,vy"));
        for (int n = 0; n <= 40; ++n) // the sum of the speeds 1 g, 2 g ... n g
            QCOMPARE(rows[n + 1], QStringLiteral("%1,stone,%2,%3,2,%4")
                                      .arg(n)
                                      .arg(7 + 2 * n)
                                      .arg(3 + 0.25 * n * (n + 1) / 2)
                                      .arg(0.25 * n));
    }

    void rowsAreAtMultiplesOfTheStep_data()
    {
        QTest::addColumn<QString>("fields");
        QTest::addColumn<QStringList>("frames");
        QTest::newRow("h = 1") << "\"frames\": 3" << QStringList{"0", "1", "2", "3"};
        QTest::newRow("h = 2") << "\"frames\": 7, \"h\": 2" << QStringList{"0", "2", "4", "6"};
        QTest::newRow("h = 0.25") << "\"frames\": 2, \"h\": 0.25" << QStringList{"0", "1", "2"};
        QTest::newRow("no frame") << "\"frames\": 0" << QStringList{"0"};
        QTest::newRow("a step longer than the run") << "\"frames\": 7, \"h\": 100" << QStringList{"0"};
    }

    void rowsAreAtMultiplesOfTheStep()
    {
        QFETCH(QString, fields);
        QFETCH(QStringList, frames);
        const Answer answer = springstep({"trace", fileWith(fields)});
        QCOMPARE(answer.code, 0);
        QStringList seen;
        for (const QString &row : answer.out.split('\n', Qt::SkipEmptyParts).mid(1)) {
            if (!seen.contains(row.section(',', 0, 0)))
                seen.push_back(row.section(',', 0, 0));
        }
        QCOMPARE(seen, frames);
        QCOMPARE(answer.out.count('\n'), 1 + 6 * frames.size()); // five feet and the body
    }

    void eachFrameHasOneRowPerBodyInTheScene()
    {
        const Answer answer = springstep(
            {"trace",
             fileWith(
                 "\"frames\": 5, \"input\": [{\"frame\": 3, \"event\": \"set\", \"parameter\": \"feet\", "
                 "\"value\": 2}, {\"frame\": 5, \"event\": \"set\", \"parameter\": \"feet\", \"value\": "
                 "6}]")});
        QCOMPARE(answer.code, 0);
        QStringList lastFrames;
        for (const char *frame : {"2", "3", "5"})
            lastFrames.push_back(QString::number(answer.out.count(QString("\n%1,").arg(frame))));
        QCOMPARE(lastFrames, QStringList({"6", "3", "7"}));
    }

    void nonFiniteRunExitsWithCode1()
    {
        const Answer answer =
            springstep({"trace", fileWith("\"frames\": 100000, \"parameters\": {\"feet\": 60, \"k\": 1}")});
        QCOMPARE(answer.code, 1);
        QVERIFY2(isOneLine(answer.err), qPrintable(answer.err));
        const auto match = QRegularExpression("\\AStopped at frame (\\d+): in the next frame, “(foot "
                                              "\\d+|body)” is too far away or too fast for "
                                              "a number \\(not finite\\). It began in “\\w+”. The spring "
                                              "(foot \\d+ – body|body – foot \\d+) "
                                              "is strongest.\n\\z")
                               .match(answer.err);
        QVERIFY2(match.hasMatch(), qPrintable(answer.err));
        const QString lastRow = answer.out.trimmed().section('\n', -1);
        QCOMPARE(lastRow.section(',', 0, 1), match.captured(1) + ",body");
        QVERIFY(!answer.out.contains("nan") && !answer.out.contains("inf"));
    }

    void runWithTooManyStepsExitsWithCode1()
    {
        const Answer answer = springstep(
            {"trace", fileWith("\"frames\": 100, \"method\": \"dormand_prince\", \"tolerance\": 1e-9, "
                               "\"parameters\": {\"feet\": 60, \"k\": 1e9}")});
        QCOMPARE(answer.code, 1);
        QVERIFY2(isOneLine(answer.err), qPrintable(answer.err));
        const auto match =
            QRegularExpression("\\AStopped at frame (\\d+): the method needs too many steps for the next "
                               "frame. The spring (foot \\d+ – body|body – foot \\d+) is strongest. Try a "
                               "larger tolerance, or a method with fixed steps.\n\\z")
                .match(answer.err);
        QVERIFY2(match.hasMatch(), qPrintable(answer.err));
        QCOMPARE(answer.out.trimmed().section('\n', -1).section(',', 0, 1), match.captured(1) + ",body");
    }

    void closedPipeEndsTheRunQuietly()
    {
        const Answer answer =
            shell("$P trace '" + fileWith("\"frames\": 10000000") + "' | head -n 3; exit ${PIPESTATUS[0]}");
        QCOMPARE(answer.code, 0);
        QCOMPARE(answer.err, QString());
        QCOMPARE(answer.out.count('\n'), 3);
    }

    void fullDiskIsReported()
    {
        const Answer answer = shell("$P trace '" + fileWith("\"frames\": 3") + "' > /dev/full");
        QCOMPARE(answer.code, 2);
        QVERIFY(isOneLine(answer.err));
    }

    void interruptingEndsWithAWholeRow()
    {
        QProcess process;
        process.setProcessEnvironment(bareEnvironment());
        process.start(PROGRAM, {"trace", fileWith("\"frames\": 10000000")});
        QVERIFY(process.waitForReadyRead());
        ::kill(static_cast<pid_t>(process.processId()), SIGINT);
        QVERIFY(process.waitForFinished());
        QCOMPARE(process.exitCode(), 130);
        const QString out = QString::fromUtf8(process.readAllStandardOutput());
        QVERIFY(out.endsWith('\n'));
        const QString lastRow = out.chopped(1).section('\n', -1);
        QCOMPARE(lastRow.section(',', 1, 1), "body");
        QCOMPARE(lastRow.count(','), 5);
        QVERIFY(QString::fromUtf8(process.readAllStandardError()).startsWith("Stopped at frame "));
    }

    void numbersDoNotDependOnTheLocale()
    {
        const QString file = TEST_DATA "/published/two_body-mutual.json";
        const Answer plain = shell("LC_ALL=C $P trace " + file);
        const Answer german = shell("LC_ALL=de_DE.UTF-8 $P trace " + file);
        QCOMPARE(plain.code, 0);
        QCOMPARE(german.out, plain.out);
    }

    void experimentCanBeReadFromAPipe()
    {
        const QString file = TEST_DATA "/published/two_body-mutual.json";
        const Answer answer = shell("$P trace <(cat " + file + ")");
        QCOMPARE(answer.err, QString());
        QCOMPARE(answer.out, springstep({"trace", file}).out);
    }

private:
    QString fileWith(const QString &fields) const { return program::fileWith(m_folder.path(), fields); }

    QTemporaryDir m_folder;
};

SUITE(tst_trace, TestTrace)
#include "tst_trace.moc"
