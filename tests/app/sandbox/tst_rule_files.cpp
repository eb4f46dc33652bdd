// Experiment files with a rule of the learner: reading, writing, running, and the messages about mistakes.

#include "app/model/run/rule_error.h"
#include "app/model/run/run_program.h"
#include "sim/run/track.h"
#include "tests/app/experiment/experiment_support.h"
#include "tests/suite.h"

#include <QTest>

using namespace app;
using experiment_support::library;

namespace {

/// An experiment with a nail and a ball; `fields` of the scene begin on line 8.
QByteArray ruleFile(const QByteArray &fields)
{
    return "{\n\"format\": \"springstep-experiment/1\",\n\"lesson\": \"sandbox\",\n\"step\": \"build\",\n"
           "\"frames\": 40,\n\"scene\": {\n\"bodies\": { \"nail\": { \"x\": 1, \"y\": 2, \"fixed\": true }, "
           "\"ball\": { \"x\": 290, \"y\": 180, \"vx\": 1.5 } },\n" +
           fields + "\n} }\n";
}

Experiment parsed(const QByteArray &fields)
{
    return parseExperiment(ruleFile(fields), "x.json", library());
}

const QByteArray fallRule = "\"rule\": \"Vec2 force(Body me)\\n{\\n    return Vec2(0, 0.1);\\n}\\n\"";

}

class TestRuleFiles : public QObject
{
    Q_OBJECT

private slots:
    void writtenRuleIsReadAgain()
    {
        const Experiment first =
            parsed(fallRule + ",\n\"rule_links\": [{ \"a\": \"nail\", \"b\": \"ball\" }]");
        const Experiment again = parseExperiment(experimentText(first, library()), "x.json", library());
        QVERIFY(first.script.values.blueprint->rule);
        QCOMPARE(again.script.values.blueprint->rule.text(), first.script.values.blueprint->rule.text());
        QCOMPARE(again.script.values.blueprint->ruleLinks.size(), std::size_t{1});
        QVERIFY(again.script.values == first.script.values);
    }

    void badRuleIsRefusedInASentence_data()
    {
        QTest::addColumn<QByteArray>("fields");
        QTest::addColumn<QString>("sentence");
        QTest::newRow("compile")
            << QByteArray("\"rule\": \"Vec2 force(Body me)\\n{\\n    return me.velocty;\\n}\\n\"")
            << "x.json:8: \"rule\" does not compile. Line 3: 'velocty' is not a member of Body.";
        QTest::newRow("global")
            << QByteArray("\"rule\": \"double sum = 0;\\nVec2 force(Body me) { return Vec2(); }\"")
            << "x.json:8: \"rule\" does not compile. Line 1: A rule remembers nothing";
        QTest::newRow("length") << QByteArray("\"rule\": \"" + QByteArray(20'001, ' ') + "\"")
                                << "x.json:8: \"rule\" has 20001 bytes; it can have up to 20000.";
        QTest::newRow("type") << QByteArray("\"rule\": 3") << "x.json:8: ";
        QTest::newRow("link") << QByteArray(fallRule +
                                            ",\n\"rule_links\": [{ \"a\": \"nail\", \"b\": \"x\" }]")
                              << "x.json:9: there is no body \"x\"";
        QTest::newRow("both ends") << QByteArray(fallRule +
                                                 ",\n\"rule_links\": [{ \"a\": \"nail\", \"b\": \"nail\" }]")
                                   << "x.json:9: a rule link has \"nail\" at both ends";
    }
    void badRuleIsRefusedInASentence()
    {
        QFETCH(QByteArray, fields);
        QFETCH(QString, sentence);
        try {
            parsed(fields);
            QFAIL("accepted");
        } catch (const UserError &error) {
            const QString found = error.sentence();
            QVERIFY2(found.startsWith(sentence.left(8)) || found.contains(sentence.mid(8)),
                     qPrintable(found));
            QVERIFY2(found.contains(sentence.section(": ", 1)), qPrintable(found));
        }
    }

    void endOfARunNamesTheLineOfTheRule()
    {
        const Experiment experiment = parsed(
            "\"rule\": \"Vec2 force(Body me)\\n{\\n    int none = 0;\\n    return me.position.x > 300 ? "
            "Vec2(1 / none, 0) : Vec2();\\n}\\n\"");
        sim::Track track(experiment.script, std::size_t{1} << 20);
        track.seek({40, 0});
        QVERIFY(track.stop());
        const QString sentence = endSentence(track);
        QVERIFY2(sentence.contains("Line 4 of your rule, for ball: This divides by 0."),
                 qPrintable(sentence));
        QCOMPARE(ruleErrorOf(track)->me, 1);
    }

    void examplesRunFor600Frames_data()
    {
        QTest::addColumn<QString>("file");
        for (const lessons::Example &example : library().sandboxes.front().steps.front().examples) {
            const Experiment experiment = readExperiment(example.file, library());
            if (experiment.script.values.blueprint->rule)
                QTest::newRow(qPrintable(example.title)) << example.file;
        }
    }
    void examplesRunFor600Frames()
    {
        QFETCH(QString, file);
        const Experiment experiment = readExperiment(file, library());
        sim::Track track(experiment.script, std::size_t{1} << 20);
        track.seek({600, 0});
        QVERIFY2(!track.stop(), track.stop() ? qPrintable(endSentence(track)) : "");
        const Eigen::ArrayX2d &position = track.state().position;
        QVERIFY((position.col(0) > -60.0).all() && (position.col(0) < 600.0).all());
        QVERIFY((position.col(1) > -60.0).all() && (position.col(1) < 420.0).all());
        QVERIFY(position.isFinite().all());
        experiment_support::compareExperiments(
            parseExperiment(experimentText(experiment, library()), "x.json", library()), experiment);
    }

    void tenExamplesHaveARule()
    {
        int count = 0;
        for (const lessons::Example &example : library().sandboxes.front().steps.front().examples)
            count += readExperiment(example.file, library()).script.values.blueprint->rule ? 1 : 0;
        QCOMPARE(count, 10);
    }
};

SUITE(tst_rule_files, TestRuleFiles)
#include "tst_rule_files.moc"
