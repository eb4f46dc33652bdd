#include "sim/methods/methods.h"
#include "sim/pipeline/method.h"
#include "sim/run/track.h"
#include "tests/app/experiment/experiment_support.h"
#include "tests/suite.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QRandomGenerator>
#include <QTemporaryDir>
#include <QTest>

#include <limits>

using namespace app;
using namespace experiment_support;

namespace {

QStringList publishedFiles()
{
    QStringList paths;
    for (const QFileInfo &info : QDir(TEST_DATA "/published").entryInfoList({"*.json"}))
        paths.push_back(info.absoluteFilePath());
    return paths;
}

QString readErrorOf(const QString &path)
{
    try {
        readExperiment(path, library());
        return {};
    } catch (const UserError &error) {
        return error.sentence();
    }
}

}

class TestExperimentFile : public QObject
{
    Q_OBJECT

private slots:
    void aPublishedFileIsReadAndWritten_data()
    {
        QTest::addColumn<QString>("path");
        for (const QString &path : publishedFiles())
            QTest::newRow(qPrintable(QFileInfo(path).completeBaseName())) << path;
    }
    void aPublishedFileIsReadAndWritten()
    {
        QFETCH(QString, path);
        const Experiment experiment = readExperiment(path, library());
        QVERIFY(!experiment.script.bodies.empty() || !experiment.script.input.empty());
        compareAfterRoundTrip(experiment);
    }

    void everyFieldSurvivesARoundTrip() { compareAfterRoundTrip(everything()); }

    void toleranceSurvivesARoundTrip_data()
    {
        QTest::addColumn<double>("tolerance");
        for (const double tolerance : {1e-13, 0.1 + 0.2, sim::defaultTolerance, 100.0})
            QTest::addRow("%g", tolerance) << tolerance;
    }
    void toleranceSurvivesARoundTrip()
    {
        QFETCH(double, tolerance);
        Experiment experiment = newExperiment("multi_foot", "any_number", library());
        experiment.script.method = sim::findMethod("dop853");
        experiment.script.step = sim::StepSize::withTolerance(tolerance);
        compareAfterRoundTrip(experiment);
        const QByteArray text = experimentText(experiment, library());
        QVERIFY(!text.contains("\"h\""));
        QCOMPARE(text.contains("\"tolerance\""),
                 tolerance != sim::defaultTolerance); // it is what there is without
    }

    void methodWithoutAStepGetsADefaultStepOrTolerance_data()
    {
        QTest::addColumn<QString>("method");
        QTest::addColumn<double>("tolerance");
        QTest::newRow("fixed steps") << "rk4" << 0.0;
        QTest::newRow("a method that adapts its steps") << "dop853" << 1e-3;
    }
    void methodWithoutAStepGetsADefaultStepOrTolerance()
    {
        QFETCH(QString, method);
        QFETCH(double, tolerance);
        const QByteArray text =
            "{\"format\": \"springstep-experiment/1\", \"lesson\": \"multi_foot\", \"step\": "
            "\"any_number\", \"method\": \"" +
            method.toUtf8() + "\"}";
        const sim::StepSize step = parseExperiment(text, "x.json", library()).script.step;
        QCOMPARE(step.h, 1.0);
        QCOMPARE(step.tolerance, tolerance);
    }

    void anUntouchedStepIsAShortFile()
    {
        const Experiment experiment = newExperiment("single_spring", "radial", library());
        QCOMPARE(QString(experimentText(experiment, library())), "{\n"
                                                                 " \"format\": \"springstep-experiment/1\",\n"
                                                                 " \"lesson\": \"single_spring\",\n"
                                                                 " \"step\": \"radial\",\n"
                                                                 " \"frames\": 300\n"
                                                                 "}\n");
    }

    void anEventTakesOneLine()
    {
        const QString text = experimentText(everything(), library());
        QVERIFY2(text.contains(
                     "\n  { \"frame\": 4, \"event\": \"set\", \"parameter\": \"damp\", \"value\": 0.95 },\n"),
                 qPrintable(text));
        QVERIFY(text.contains("\n  { \"frame\": 5, \"event\": \"release\" },\n"));
    }

    void eventsOfRemovedBodiesAreNotWritten()
    {
        Experiment experiment = newExperiment("multi_foot", "any_number", library());
        experiment.script.input = {{1, sim::Grab{"foot0"}}, {5, sim::Set{"feet", 3.0}},
                                   {9, sim::Grab{"foot4"}}, {9, sim::Move{{1, 2}}},
                                   {10, sim::Release{}},    {11, sim::Grab{"body"}}};
        const Experiment back = parseExperiment(experimentText(experiment, library()), "x.json", library());
        const std::vector<sim::Event> left = {{1, sim::Grab{"foot0"}},
                                              {5, sim::Set{"feet", 3.0}},
                                              {9, sim::Release{}},
                                              {11, sim::Grab{"body"}}};
        QVERIFY(back.script.input == left);
        sim::Track before(experiment.script, 0);
        sim::Track after(back.script, 0);
        before.seek({50, 0});
        after.seek({50, 0});
        QVERIFY(sim::sameBits(before.state(), after.state()));
    }

    void aNumberThatIsNotFiniteIsNotWritten()
    {
        Experiment experiment = newExperiment("single_spring", "radial", library());
        experiment.script.bodies["foot"] = {{std::numeric_limits<double>::quiet_NaN(), 0.0}, {}};
        QVERIFY_THROWS_EXCEPTION(UserError, experimentText(experiment, library()));
    }

    void savingReplacesTheFileOrLeavesItUnchanged()
    {
        const QTemporaryDir folder;
        const QString path = folder.filePath("saved.json");
        writeExperiment(path, everything(), library());
        compareExperiments(readExperiment(path, library()), everything());
        const Experiment other = newExperiment("two_body", "mutual", library());
        writeExperiment(path, other, library());
        compareExperiments(readExperiment(path, library()), other);
        QCOMPARE(QDir(folder.path()).entryList(QDir::Files), QStringList("saved.json"));
        Experiment bad = other;
        bad.script.bodies["body"] = {{std::numeric_limits<double>::infinity(), 0.0}, {}};
        QVERIFY_THROWS_EXCEPTION(UserError, writeExperiment(path, bad, library()));
        compareExperiments(readExperiment(path, library()), other);
        QVERIFY_THROWS_EXCEPTION(UserError,
                                 writeExperiment(folder.filePath("no/such/folder.json"), other, library()));
    }

    void aFileThatCannotBeReadIsNamed()
    {
        const QTemporaryDir folder;
        const QString none = folder.filePath("none.json");
        QCOMPARE(readErrorOf(none), none + ": there is no such file; check its name and folder.");
        QCOMPARE(readErrorOf(folder.path()), folder.path() + ": this is a folder; give a file.");
        QCOMPARE(readErrorOf("/dev/zero"), "/dev/zero: the file is larger than 32 MiB, the maximum.");
    }

    void aFileOfOneGigabyteIsRefusedUnread()
    {
        const QTemporaryDir folder;
        const QString path = folder.filePath("large.json");
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly) &&
                file.resize(qint64{1} << 30)); // a sparse file takes no space
        QCOMPARE(readErrorOf(path), path + ": the file is larger than 32 MiB, the maximum.");
    }

    void damagedFilesAreReadOrRefusedInOneLine()
    {
        const quint32 seed = qEnvironmentVariableIsSet("FUZZ_SEED")
                                 ? qEnvironmentVariable("FUZZ_SEED").toUInt()
                                 : QRandomGenerator::global()->generate();
        qInfo("FUZZ_SEED=%u repeats this run", seed);
        QRandomGenerator random(seed);
        std::vector<QByteArray> texts;
        for (const QString &path : publishedFiles())
            texts.push_back(contentsOf(path));
        texts.push_back(experimentText(withBranches(), library()));
        int refused = 0;
        for (int i = 0; i < 500; ++i) {
            const QByteArray text = damaged(texts[random.bounded(quint32(texts.size()))], random);
            try {
                parseExperiment(text, "x.json", library());
            } catch (const UserError &error) {
                ++refused;
                const QString sentence = error.sentence();
                QVERIFY2(sentence.startsWith("x.json: line ") && !sentence.contains('\n') &&
                             sentence.size() < 800 && sentence.endsWith('.'),
                         qPrintable(sentence));
            }
        }
        QVERIFY(refused > 100);
    }

private:
    /// A copy of `text` with one to three changes: bytes replaced, cut out, doubled, or words exchanged.
    static QByteArray damaged(QByteArray text, QRandomGenerator &random)
    {
        static const QList<QByteArray> words = {"1e308", "-1",       "null",       "{}",  "[]",
                                                "\"\"",  "true",     "1e-400",     "NaN", "\"x\"",
                                                "\x00",  "\xff\xfe", "1000000000", ",",   "\n"};
        for (quint32 changes = 1 + random.bounded(3u); changes > 0; --changes) {
            const qsizetype at = qsizetype(random.bounded(quint32(text.size())));
            const qsizetype length = qsizetype(random.bounded(20u));
            switch (random.bounded(5)) {
            case 0:
                text[at] = char(random.bounded(256));
                break;
            case 1:
                text.remove(at, length);
                break;
            case 2:
                text.insert(at, text.mid(at, length));
                break;
            case 3:
                text.replace(at, length, words[qsizetype(random.bounded(quint32(words.size())))]);
                break;
            default:
                text.truncate(at + 1);
                break;
            }
            if (text.isEmpty())
                text = " ";
        }
        return text;
    }
};

SUITE(tst_experiment_file, TestExperimentFile)
#include "tst_experiment_file.moc"
