#include "tests/app/cli/program.h"

#include "sim/methods/methods.h"
#include "tests/suite.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QSet>
#include <QTest>

#include <sys/types.h>

using namespace program;

namespace {

QJsonArray rows(const Answer &answer)
{
    return QJsonDocument::fromJson(answer.out.toUtf8()).object()["rows"].toArray();
}

QJsonObject rowOf(const QJsonArray &all, const QString &method)
{
    for (const QJsonValue &row : all) {
        if (row["method"].toString() == method)
            return row.toObject();
    }
    return {};
}

}

/// `springstep hardcases`: its output in all formats.
class TestHardCasesCli : public QObject
{
    Q_OBJECT

private slots:
    void badUseIsOneSentenceAndExitCode2_data()
    {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<QString>("begins");
        const auto row = [](const char *name, const QStringList &arguments, const QString &begins) {
            QTest::newRow(name) << QStringList{"hardcases"} + arguments << begins;
        };
        row("a name", {"stiffness_1e9"}, "springstep: hardcases takes no arguments; ");
        row("a case that is not there", {"--case", "soft"}, "There is no case \"soft\"; there is \"");
        row("a case without a name", {"--case", ""}, "There is no case \"\"; there is \"");
        row("an option that is not there", {"--fast"}, "springstep: Unknown option 'fast'");
    }
    void badUseIsOneSentenceAndExitCode2()
    {
        QFETCH(QStringList, arguments);
        QFETCH(QString, begins);
        const Answer answer = springstep(arguments);
        QVERIFY2(answer.err.startsWith(begins), qPrintable(answer.err));
        checkRefusal(answer);
    }

    void jsonHasTheDocumentedShape()
    {
        const Answer answer = springstep({"hardcases", "--case", "stiffness_1e9", "--json"});
        QCOMPARE(answer.err, QString());
        QCOMPARE(answer.code, 0);
        const QJsonArray all = rows(answer);
        QVERIFY(all.size() >= 12);
        QSet<QString> methods;
        for (const QJsonValue &value : all) {
            const QJsonObject row = value.toObject();
            QCOMPARE(row.size(), 7);
            QCOMPARE(row["case"].toString(), "stiffness_1e9");
            QVERIFY(row["claims"].isBool() && row["holds"].isBool() && row["why"].isString());
            QVERIFY(row["frames"].isDouble());
            QCOMPARE(row["ns_per_frame"].isNull(), row["frames"].toInt() == 0);
            // Every case has a sentence, unless it is claimed and holds.
            const bool isPlain = row["claims"].toBool() && row["holds"].toBool();
            QVERIFY2(isPlain ? row["why"].toString().isEmpty() : row["why"].toString().endsWith('.'),
                     qPrintable(row["why"].toString()));
            methods.insert(row["method"].toString());
        }
        QCOMPARE(methods.size(), all.size());
    }

    void stiffSpringIsStableWithTheMethodsThatClaimIt()
    {
        const QJsonArray all = rows(springstep({"hardcases", "--case", "stiffness_1e9", "--json"}));
        for (const char *method : {"backward_euler", "tr_bdf2"}) {
            const QJsonObject row = rowOf(all, method);
            QVERIFY2(row["claims"].toBool() && row["holds"].toBool(), method);
        }
        for (const char *method : {"published", "rk4", "implicit_midpoint"}) {
            const QJsonObject row = rowOf(all, method);
            QVERIFY2(!row["claims"].toBool() && !row["holds"].toBool(), method);
            QVERIFY(row["why"].toString().startsWith(
                "With a step of 1, its stiffest spring (stiffness 1e+09) would "));
        }
    }

    void caseWithRefusedInputHoldsWithoutARun()
    {
        const Answer answer = springstep({"hardcases", "--case", "hand_not_a_number", "--json"});
        QCOMPARE(answer.code, 0);
        const QJsonArray all = rows(answer);
        QCOMPARE(all.size(), static_cast<qsizetype>(sim::allMethods().size()));
        for (const QJsonValue &row : all)
            QVERIFY(row["holds"].toBool() && row["frames"].toInt(-1) == 0 && row["ns_per_frame"].isNull());
    }

    void theTableIsReadable()
    {
        const Answer answer = springstep({"hardcases", "--case", "runaway_pair"});
        QCOMPARE(answer.code, 0);
        const QStringList lines = answer.out.split('\n');
        QCOMPARE(lines[0], "runaway_pair: the pair that runs away");
        QVERIFY(lines[1].endsWith('.'));
        const qsizetype holds = lines[2].indexOf("holds");
        for (const QString &line : lines.mid(3, 12))
            QVERIFY2(line.mid(holds).startsWith("holds ") || line.mid(holds).startsWith("fails "),
                     qPrintable(line));
        QVERIFY(lines[lines.size() - 2].endsWith(" runs are claimed, and all of those hold."));
    }

    void interruptingStopsCleanly()
    {
        QProcess process;
        process.setProcessEnvironment(bareEnvironment());
        process.start(PROGRAM, {"hardcases", "--case", "ten_million_frames", "--full", "--json"});
        QVERIFY(process.waitForStarted());
        QVERIFY(interrupt(process)); // what it computes takes many seconds
        QCOMPARE(process.exitCode(), 130);
        QCOMPARE(QString::fromUtf8(process.readAllStandardOutput()), QString());
        QCOMPARE(QString::fromUtf8(process.readAllStandardError()), QString("Stopped before the end.\n"));
    }
};

SUITE(tst_hard_cases_cli, TestHardCasesCli)
#include "tst_hard_cases_cli.moc"
