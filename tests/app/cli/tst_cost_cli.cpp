#include "tests/app/cli/program.h"
#include "tests/suite.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QSet>
#include <QTemporaryDir>
#include <QTest>

#include <sys/types.h>

using namespace program;

namespace {

QStringList idsOf(const QJsonObject &report)
{
    QStringList ids;
    for (const QJsonValue &effect : report["effects"].toArray())
        ids << effect["id"].toString();
    return ids;
}

QJsonObject effectOf(const QJsonObject &report, const QString &id)
{
    for (const QJsonValue &effect : report["effects"].toArray()) {
        if (effect["id"].toString() == id)
            return effect.toObject();
    }
    return {};
}

}

/// `springstep cost`: its output in all formats. Times cannot be tested here; tst_instructions counts instructions.
class TestCostCli : public QObject
{
    Q_OBJECT

private slots:
    void badUseIsOneSentenceAndExitCode2_data()
    {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<QString>("begins");
        const auto row = [](const char *name, const QStringList &arguments, const QString &begins) {
            QTest::newRow(name) << QStringList{"cost"} + arguments << begins;
        };
        row("no name", {}, "springstep: cost takes FILE|LESSON/STEP; ");
        row("two names", {"a/b", "c/d"}, "springstep: cost takes FILE|LESSON/STEP; ");
        row("an option that is not there", {"a/b", "--fast"}, "springstep: Unknown option 'fast'");
        row("neither file nor step", {"gravity"},
            "\"gravity\" is neither a file nor a step; name a step as ");
        row("a lesson that is not there", {"soft/body"}, "there is no lesson \"soft\"; there is ");
        row("a frame that is no number", {"a/b", "--frame", "ten"},
            "springstep: --frame is \"ten\"; it can be 0 to ");
        row("a frame below 0", {"a/b", "--frame", "-1"}, "springstep: --frame is \"-1\"; it can be 0 to ");
    }
    void badUseIsOneSentenceAndExitCode2()
    {
        QFETCH(QStringList, arguments);
        QFETCH(QString, begins);
        const Answer answer = springstep(arguments);
        QVERIFY2(answer.err.startsWith(begins, Qt::CaseInsensitive), qPrintable(answer.err));
        checkRefusal(answer);
    }

    void jsonHasTheDocumentedShape()
    {
        const Answer answer = springstep({"cost", "gravity_walls/gravity", "--json", "--frame", "20"});
        QCOMPARE(answer.err, QString());
        QCOMPARE(answer.code, 0);
        const QJsonObject report = json(answer);
        QCOMPARE(report["experiment"].toString(), "gravity_walls/gravity");
        QCOMPARE(report["method"].toString(), "published");
        QCOMPARE(report["h"].toDouble(), 1.0);
        for (const char *number : {"frame_ns", "frame_spread", "rest_ns", "rest_spread"})
            QVERIFY2(report[QLatin1String(number)].isDouble(), number);
        QVERIFY(report["frame_ns"].toDouble() > 0.0);
        QVERIFY(report["rounds"].toInt() >= 9);
        for (const QJsonValue &value : report["effects"].toArray()) {
            const QJsonObject effect = value.toObject();
            QCOMPARE(effect.size(), 6);
            QCOMPARE(effect["points"].toInt(), 5); // four feet and a body
            QCOMPARE(effect["evaluations"].toDouble(), 1.0);
            QVERIFY(effect["spread"].toDouble() >= 0.0);
            QCOMPARE(effect["ns_per_point"].toDouble(), effect["ns_per_frame"].toDouble() / 5);
        }
        const QStringList ids = idsOf(report);
        QCOMPARE(QSet<QString>(ids.begin(), ids.end()),
                 (QSet<QString>{"radial_spring", "gravity", "damping", "walls"}));
    }

    void aFileIsMeasuredWithItsMethodStepAndEffects()
    {
        const QTemporaryDir folder;
        const QString path =
            fileWith(folder.path(), "\"method\": \"rk4\", \"h\": 0.5, \"effects\": [\"damping\"]");
        const QJsonObject report = json(springstep({"cost", path, "--json"}));
        QCOMPARE(report["method"].toString(), "rk4");
        QCOMPARE(report["h"].toDouble(), 0.5);
        QCOMPARE(effectOf(report, "radial_spring")["evaluations"].toDouble(), 8.0); // four stages, two steps
        const QJsonObject off = effectOf(report, "damping");
        QCOMPARE(off["why"].toString(), "switched off");
        for (const char *number : {"ns_per_frame", "ns_per_point", "points", "evaluations", "spread"})
            QCOMPARE(off[QLatin1String(number)].toDouble(-1.0), 0.0);
    }

    void reportHasAToleranceInsteadOfAStep()
    {
        const QTemporaryDir folder;
        const QString path = fileWith(folder.path(), "\"method\": \"dormand_prince\", \"tolerance\": 0.01");
        const QJsonObject report = json(springstep({"cost", path, "--json"}));
        QCOMPARE(report["tolerance"].toDouble(), 0.01);
        QVERIFY(!report.contains("h"));
        QVERIFY(effectOf(report, "radial_spring")["evaluations"].toDouble() > 1.0);
    }

    void theTableIsReadable()
    {
        const QTemporaryDir folder;
        const QString path = fileWith(folder.path(), "\"effects\": [\"damping\"]");
        const Answer answer = springstep({"cost", path});
        QCOMPARE(answer.err, QString());
        QCOMPARE(answer.code, 0);
        const QStringList lines = answer.out.split('\n');
        QCOMPARE(lines[0], path + ", published, h 1");
        QVERIFY(lines[2].startsWith("effect ") && lines[2].endsWith("share"));
        QVERIFY(lines[3].startsWith("radial_spring "));
        QCOMPARE(lines[3].size(), lines[2].size());
        QVERIFY(lines[4].startsWith("the method itself "));
        QVERIFY(lines[5].startsWith("whole frame "));
        QVERIFY(lines[6].startsWith("damping ") && lines[6].endsWith("switched off"));
        QVERIFY(lines[8].startsWith("Each line is measured separately. Effects and method together take "));
    }

    void framesThatTheRunDoesNotReachAreRefused()
    {
        const QTemporaryDir folder;
        const QString path =
            fileWith(folder.path(), "\"method\": \"explicit_euler\", \"parameters\": {\"k\": 1, "
                                    "\"damp\": 1}");
        const Answer answer = springstep({"cost", path, "--frame", "1000000"});
        QCOMPARE(answer.code, 2);
        QVERIFY2(answer.err.startsWith("The run does not reach frame 1000000. "), qPrintable(answer.err));
        QVERIFY(answer.err.endsWith("Give an earlier frame.\n"));
    }

    void interruptingStopsCleanly()
    {
        QProcess process;
        process.setProcessEnvironment(bareEnvironment());
        process.start(PROGRAM, {"cost", "walking_gait/company", "--frame", "10000000", "--json"});
        QVERIFY(process.waitForStarted());
        QVERIFY(interrupt(process)); // what it computes takes many seconds
        QCOMPARE(process.exitCode(), 130);
        QCOMPARE(QString::fromUtf8(process.readAllStandardOutput()), QString());
        QCOMPARE(QString::fromUtf8(process.readAllStandardError()), QString("Stopped before the end.\n"));
    }
};

SUITE(tst_cost_cli, TestCostCli)
#include "tst_cost_cli.moc"
