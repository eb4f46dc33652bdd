// The branches of an experiment in its file.

#include "tests/app/experiment/experiment_support.h"
#include "tests/suite.h"

using namespace app;
using namespace experiment_support;

class TestExperimentBranches : public QObject
{
    Q_OBJECT

private slots:
    void branchesSurviveARoundTrip_data()
    {
        QTest::addColumn<double>("h");
        QTest::newRow("a third of a frame") << 1.0 / 3.0;
        QTest::newRow("a frame") << 1.0;
        QTest::newRow("five frames") << 5.0;
    }
    void branchesSurviveARoundTrip()
    {
        QFETCH(double, h);
        const Experiment experiment = withBranches(h);
        compareAfterRoundTrip(experiment);
        const QByteArray text = experimentText(experiment, library());
        QCOMPARE(text.count("\"fork\": "), 1);
        QVERIFY(text.contains(h == 5.0 ? "\"fork\": 6" : "\"fork\": 8"));
    }

    void branchesNeitherNamedNorKeptAreNotWritten()
    {
        Experiment experiment = everything();
        const QByteArray before = experimentText(experiment, library());
        experiment.branches.add(
            branchOf("passing", false, false, newExperiment("multi_foot", "any_number", library()).script));
        QCOMPARE(experimentText(experiment, library()), before);
        experiment.branches.setOwn({"after: k 0.3", {}, false, 7});
        QCOMPARE(experimentText(experiment, library()), before);
    }

    void handWrittenBranchNeedsFewFields()
    {
        const Experiment read = parseExperiment(
            withBranch(
                "\"name\": \"let go\", \"fork\": 9, \"input\": [{\"frame\": 9, \"event\": \"release\"}]"),
            "x.json", library());
        const Branch &branch = read.branches.all().front();
        QVERIFY(branch.isNamed && branch.isKept);
        QCOMPARE(branch.name, QString("let go"));
        QCOMPARE(branch.script->input.size(), std::size_t(2));
        QCOMPARE(firstDifferent(*branch.script, read.script), 9);
    }

    void invalidBranchIsRefusedWithItsLine_data()
    {
        QTest::addColumn<QByteArray>("fields");
        QTest::addColumn<QString>("sentence");
        const auto row = [](const char *name, const char *fields, const char *sentence) {
            QTest::newRow(name) << QByteArray(fields) << QString(sentence);
        };
        row("no name", "\"fork\": 9",
            "line 5: a branch has no \"name\"; add it. It must be a text that tells it from others.");
        row("a name of nothing", "\"name\": \" \"", "line 6: \"name\" has 0 letters; it can have 1 to 200.");
        row("an event before the fork",
            "\"name\": \"a\", \"fork\": 9,\n\"input\": [{\"frame\": 8, \"event\": \"release\"}]",
            "line 7: frame 8 is before the start of the branch, whose \"fork\" is 9; use frame 9 or a later "
            "one.");
        row("nothing held",
            "\"name\": \"a\", \"fork\": 4,\n\"input\": [{\"frame\": 8, \"event\": \"release\"}]",
            "line 7: nothing is held at frame 8; a \"release\" comes after a \"grab\".");
        row("parameters after a fork", "\"name\": \"a\", \"fork\": 4,\n\"parameters\": {\"k\": 0.3}",
            "line 7: a branch has no field \"parameters\"; there is \"name\", \"named\", \"kept\", \"fork\", "
            "\"frames\", \"input\".");
        row("a parameter out of range", "\"name\": \"a\",\n\"parameters\": {\"feet\": 1e9}",
            "line 7: \"feet\"");
        row("no body", "\"name\": \"a\",\n\"bodies\": {\"head\": {\"x\": 1, \"y\": 2}}",
            "line 7: there is no body \"head\" here;");
        row("a branch of a branch", "\"name\": \"a\",\n\"branches\": []", "line 7: a branch has no field");
        row("kept as a number", "\"name\": \"a\",\n\"kept\": 1",
            "line 7: \"kept\" is 1; it must be true or false.");
    }
    void invalidBranchIsRefusedWithItsLine()
    {
        QFETCH(QByteArray, fields);
        QFETCH(QString, sentence);
        try {
            parseExperiment(withBranch(fields), "x.json", library());
            QFAIL("it was read");
        } catch (const UserError &error) {
            QVERIFY2(error.sentence().startsWith("x.json: " + sentence), qPrintable(error.sentence()));
        }
    }

    void tooManyBranchesAreRefused()
    {
        Experiment experiment = everything();
        for (int i = 0; i <= int(mostKeptBranches); ++i) {
            sim::Script script = experiment.script;
            script.values.set("k", 0.001 * i);
            experiment.branches.add(branchOf(QString::number(i), true, true, script));
        }
        QVERIFY_THROWS_EXCEPTION(UserError, experimentText(experiment, library()));
        QByteArray list;
        for (int i = 0; i <= int(mostKeptBranches); ++i)
            list += "\"name\": \"a\"}, {";
        try {
            parseExperiment(withBranch(list + "\"name\": \"a\""), "x.json", library());
            QFAIL("it was read");
        } catch (const UserError &error) {
            QCOMPARE(error.sentence(),
                     QString("x.json: line 5: \"branches\" has 102 runs; it can have up to 100."));
        }
    }
};

SUITE(tst_experiment_branches, TestExperimentBranches)
#include "tst_experiment_branches.moc"
