#include "app/model/experiment.h"
#include "sim/methods/methods.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QRandomGenerator>
#include <QTemporaryDir>
#include <QTest>

#include <limits>

using namespace app;

namespace {

const LessonLibrary &library()
{
    static const LessonLibrary loaded = LessonLibrary::load({LESSON_DIR});
    return loaded;
}

QByteArray read(const QString &path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

QStringList publishedFiles()
{
    QStringList paths;
    for (const QFileInfo &info : QDir(TEST_DATA "/published").entryInfoList({"*.json"}))
        paths.push_back(info.absoluteFilePath());
    return paths;
}

QString refusalOf(const QString &path)
{
    try {
        readExperiment(path, library());
        return {};
    } catch (const Refusal &refusal) {
        return refusal.sentence();
    }
}

/// Fails unless the two run alike.
void compareExperiments(const Experiment &a, const Experiment &b)
{
    QCOMPARE(a.lesson, b.lesson);
    QCOMPARE(a.step, b.step);
    QCOMPARE(a.frames, b.frames);
    QVERIFY(a.script.values == b.script.values);
    QVERIFY(a.script.bodies == b.script.bodies);
    QVERIFY(a.script.effectsOff == b.script.effectsOff);
    QCOMPARE(a.script.method->id(), b.script.method->id());
    QVERIFY(a.script.step == b.script.step);
    QVERIFY(a.script.input == b.script.input);
    QVERIFY(sameMarked(a.branches, b.branches));
    for (std::size_t i = 0; i < a.branches.all().size(); ++i)
        QCOMPARE(a.branches.all()[i].end, b.branches.all()[i].end);
}

void compareAfterRoundTrip(const Experiment &experiment)
{
    const QByteArray text = experimentText(experiment, library());
    const Experiment back = parseExperiment(text, "x.json", library());
    compareExperiments(back, experiment);
    QCOMPARE(experimentText(back, library()), text);
}

/// Feet, with one of everything that a file can have.
Experiment everything()
{
    Experiment experiment = newExperiment("multi_foot", "any_number", library());
    sim::Script &script = experiment.script;
    experiment.frames = mostFrames;
    script.method = newExperiment("multi_foot", "any_number", library()).script.method;
    script.step = sim::StepSize::of(1.0 / 3.0);
    script.values.set("k", 0.1 + 0.2);
    script.values.set("feet", 7.0);
    script.values.seed = std::uint64_t{1} << 53;
    script.bodies["foot6"] = {{1.0 / 3.0, -0.0}, sim::Vec2{std::numeric_limits<double>::denorm_min(), -1e22}};
    script.bodies["body"] = {{std::numeric_limits<double>::max(), 123456789012345678.0}, {}};
    script.effectsOff = {script.build(script.values).effects.front()->id()};
    script.input = {{0, sim::Grab{"foot0"}},         {0, sim::Move{{-1.5, 2e-7}}}, {3, sim::Grab{"body"}},
                    {4, sim::Set{"damp", 0.95}},     {4, sim::Set{"feet", 9.0}},   {5, sim::Release{}},
                    {10'000'000, sim::Grab{"foot8"}}};
    return experiment;
}

Branch branchOf(const QString &name, bool isNamed, bool isKept, sim::Script script)
{
    return {1, name, isNamed, isKept, 77, std::make_shared<const sim::Script>(std::move(script))};
}

/// The same with three runs beside it: one shares its first frames, two share nothing, as their parameters are others.
Experiment withBranches(double h = 1.0 / 3.0)
{
    Experiment experiment = everything();
    experiment.script.step = sim::StepSize::of(h);
    sim::Script forked = experiment.script;
    forked.input.resize(6);
    forked.input.push_back({8, sim::Grab{"foot1"}});
    forked.input.push_back({8, sim::Move{{0.1 + 0.2, 1e-300}}});
    sim::Script other = experiment.script;
    other.values.set("k", 1.0 / 3.0);
    other.effectsOff.clear();
    sim::Script untouched = newExperiment("multi_foot", "any_number", library()).script;
    experiment.branches.add(branchOf("softer “here”", true, false, forked));
    experiment.branches.add(branchOf("before: k 0.2", false, true, other));
    experiment.branches.add(branchOf("as published", true, true, untouched));
    experiment.branches.setOwn({"mine", "mine", true, 0});
    return experiment;
}

/// A file with one branch, whose fields begin on line 6.
QByteArray withBranch(const QByteArray &fields)
{
    return "{\n\"format\": \"springstep-experiment/1\",\n\"lesson\": \"multi_foot\", \"step\": "
           "\"any_number\",\n"
           "\"input\": [{\"frame\": 4, \"event\": \"grab\", \"body\": \"body\"}],\n\"branches\": [{\n" +
           fields + "\n}]}";
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

    void everyFieldComesBackExactly() { compareAfterRoundTrip(everything()); }

    void runsBesideItComeBackExactly_data()
    {
        QTest::addColumn<double>("h");
        QTest::newRow("a third of a frame") << 1.0 / 3.0;
        QTest::newRow("a frame") << 1.0;
        QTest::newRow("five frames") << 5.0;
    }
    void runsBesideItComeBackExactly()
    {
        QFETCH(double, h);
        const Experiment experiment = withBranches(h);
        compareAfterRoundTrip(experiment);
        const QByteArray text = experimentText(experiment, library());
        QCOMPARE(text.count("\"fork\": "), 1);
        QVERIFY(text.contains(h == 5.0 ? "\"fork\": 6" : "\"fork\": 8"));
    }

    void whatIsNeitherNamedNorKeptIsNotWritten()
    {
        Experiment experiment = everything();
        const QByteArray before = experimentText(experiment, library());
        experiment.branches.add(
            branchOf("passing", false, false, newExperiment("multi_foot", "any_number", library()).script));
        QCOMPARE(experimentText(experiment, library()), before);
        experiment.branches.setOwn({"after: k 0.3", {}, false, 7});
        QCOMPARE(experimentText(experiment, library()), before);
    }

    void aBranchByHandNeedsLittle()
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

    void aBranchThatIsWrongIsRefusedWithItsLine_data()
    {
        QTest::addColumn<QByteArray>("fields");
        QTest::addColumn<QString>("sentence");
        const auto row = [](const char *name, const char *fields, const char *sentence) {
            QTest::newRow(name) << QByteArray(fields) << QString(sentence);
        };
        row("no name", "\"fork\": 9",
            "line 5: a branch has no \"name\"; it takes a text that tells it from others.");
        row("a name of nothing", "\"name\": \" \"", "line 6: \"name\" has 0 letters; it can have 1 to 200.");
        row("an event before the fork",
            "\"name\": \"a\", \"fork\": 9,\n\"input\": [{\"frame\": 8, \"event\": \"release\"}]",
            "line 7: frame 8 comes before the branch does, whose \"fork\" is 9; begin there or later.");
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
            "line 7: \"kept\" is 1; it takes true or false.");
    }
    void aBranchThatIsWrongIsRefusedWithItsLine()
    {
        QFETCH(QByteArray, fields);
        QFETCH(QString, sentence);
        try {
            parseExperiment(withBranch(fields), "x.json", library());
            QFAIL("it was read");
        } catch (const Refusal &refusal) {
            QVERIFY2(refusal.sentence().startsWith("x.json: " + sentence), qPrintable(refusal.sentence()));
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
        QVERIFY_EXCEPTION_THROWN(experimentText(experiment, library()), Refusal);
        QByteArray list;
        for (int i = 0; i <= int(mostKeptBranches); ++i)
            list += "\"name\": \"a\"}, {";
        try {
            parseExperiment(withBranch(list + "\"name\": \"a\""), "x.json", library());
            QFAIL("it was read");
        } catch (const Refusal &refusal) {
            QCOMPARE(refusal.sentence(),
                     QString("x.json: line 5: \"branches\" has 102 runs; it can have up to 100."));
        }
    }

    void aToleranceComesBackExactly_data()
    {
        QTest::addColumn<double>("tolerance");
        for (const double tolerance : {1e-13, 0.1 + 0.2, sim::presetTolerance, 100.0})
            QTest::addRow("%g", tolerance) << tolerance;
    }
    void aToleranceComesBackExactly()
    {
        QFETCH(double, tolerance);
        Experiment experiment = newExperiment("multi_foot", "any_number", library());
        experiment.script.method = sim::findMethod("dop853");
        experiment.script.step = sim::StepSize::within(tolerance);
        compareAfterRoundTrip(experiment);
        const QByteArray text = experimentText(experiment, library());
        QVERIFY(!text.contains("\"h\""));
        QCOMPARE(text.contains("\"tolerance\""),
                 tolerance != sim::presetTolerance); // it is what there is without
    }

    void aMethodWithoutAStepGetsOneThatFits_data()
    {
        QTest::addColumn<QString>("method");
        QTest::addColumn<double>("h");
        QTest::addColumn<double>("tolerance");
        QTest::newRow("steps of one length") << "rk4" << 1.0 << 0.0;
        QTest::newRow("steps of its own") << "dop853" << 1.0 << 1e-3;
    }
    void aMethodWithoutAStepGetsOneThatFits()
    {
        QFETCH(QString, method);
        QFETCH(double, h);
        QFETCH(double, tolerance);
        const QByteArray text =
            "{\"format\": \"springstep-experiment/1\", \"lesson\": \"multi_foot\", \"step\": "
            "\"any_number\", \"method\": \"" +
            method.toUtf8() + "\"}";
        const sim::StepSize step = parseExperiment(text, "x.json", library()).script.step;
        QCOMPARE(step.h, h);
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

    void eventsThatLostTheirBodyAreLeftOut()
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
        QVERIFY(sim::sameBits(before.now(), after.now()));
    }

    void aNumberThatIsNotFiniteIsNotWritten()
    {
        Experiment experiment = newExperiment("single_spring", "radial", library());
        experiment.script.bodies["foot"] = {{std::numeric_limits<double>::quiet_NaN(), 0.0}, {}};
        QVERIFY_EXCEPTION_THROWN(experimentText(experiment, library()), Refusal);
    }

    void savingReplacesTheFileOrLeavesIt()
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
        QVERIFY_EXCEPTION_THROWN(writeExperiment(path, bad, library()), Refusal);
        compareExperiments(readExperiment(path, library()), other);
        QVERIFY_EXCEPTION_THROWN(writeExperiment(folder.filePath("no/such/folder.json"), other, library()),
                                 Refusal);
    }

    void aFileThatCannotBeReadIsNamed()
    {
        const QTemporaryDir folder;
        const QString none = folder.filePath("none.json");
        QCOMPARE(refusalOf(none), none + ": there is no such file; check its name and folder.");
        QCOMPARE(refusalOf(folder.path()),
                 folder.path() + ": this is a folder; give the file of an experiment.");
        QCOMPARE(refusalOf("/dev/zero"),
                 "/dev/zero: the file is larger than 64 MiB, which is the most for an "
                 "experiment.");
    }

    void aFileOfOneGigabyteIsRefusedUnread()
    {
        const QTemporaryDir folder;
        const QString path = folder.filePath("large.json");
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly) &&
                file.resize(qint64{1} << 30)); // takes no room: all of it a hole
        QCOMPARE(refusalOf(path),
                 path + ": the file is larger than 64 MiB, which is the most for an experiment.");
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
            texts.push_back(read(path));
        texts.push_back(experimentText(withBranches(), library()));
        int refused = 0;
        for (int i = 0; i < 500; ++i) {
            const QByteArray text = damaged(texts[random.bounded(quint32(texts.size()))], random);
            try {
                parseExperiment(text, "x.json", library());
            } catch (const Refusal &refusal) {
                ++refused;
                const QString sentence = refusal.sentence();
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

QTEST_GUILESS_MAIN(TestExperimentFile)
#include "tst_experiment_file.moc"
