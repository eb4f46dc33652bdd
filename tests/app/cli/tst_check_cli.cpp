// `springstep check`: lessons without C++ from the command line.

#include "app/model/lesson_folders/lesson_package.h"
#include "tests/app/cli/program.h"
#include "tests/app/support/files.h"
#include "tests/app/support/zip_writer.h"
#include "tests/suite.h"

#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QTemporaryDir>
#include <QTest>

using namespace program;

namespace {

const QString lessonExamples = QStringLiteral(SOURCE_DIR "/lessons/examples/");

/// Copies an example into `folder`, and replaces a text in one of its files.
void copyChanged(const QString &example, const QString &folder, const QString &changed,
                 const QByteArray &from, const QByteArray &to)
{
    for (const QFileInfo &info : QDir(lessonExamples + example).entryInfoList(QDir::Files)) {
        QFile in(info.filePath()), out(folder + '/' + info.fileName());
        QVERIFY(in.open(QIODevice::ReadOnly) && out.open(QIODevice::WriteOnly));
        QByteArray content = in.readAll();
        if (info.fileName() == changed)
            content.replace(from, to);
        out.write(content);
    }
}

}

class TestCheckCli : public QObject
{
    Q_OBJECT

private slots:
    void aFolderPasses()
    {
        const Answer answer = springstep({"check", lessonExamples + "pendulum_clock"});
        QVERIFY2(answer.code == 0 && answer.err.isEmpty(), qPrintable(answer.out + answer.err));
        QVERIFY(answer.out.startsWith(
            "pendulum_clock: A pendulum clock (steps: 3; languages besides the first: de, es, fr)\n"));
        QVERIFY(answer.out.contains(
            "  ok    swing   listing                   same motion as semi_implicit_euler\n"));
    }

    void aZipPassesAsJson()
    {
        const QTemporaryDir dir;
        const QString zip = dir.filePath("caterpillar" + app::lessonEnding);
        tests::writeFile(zip, tests::zipOf(app::readLessonFiles(lessonExamples + "caterpillar").all));
        const Answer answer = springstep({"check", zip, "--json"});
        QCOMPARE(answer.code, 0);
        const QJsonObject found = json(answer);
        QVERIFY(found["good"].toBool());
        QCOMPARE(found["languages"].toArray(), QJsonArray({"de", "es", "fr"}));
        QVERIFY(found["checked"].toArray().size() > 10);
        QCOMPARE(QDir(dir.path()).entryList(QDir::Files).size(), 1);
    }

    void failedThingToTryGivesExitCode1()
    {
        const QTemporaryDir dir;
        copyChanged("pendulum_clock", dir.path(), "clock.md", "- drag bob: 310, 296, 40",
                    "- drag bob: 271, 300, 40");
        const Answer answer = springstep({"check", dir.path()});
        QCOMPARE(answer.code, 1);
        QVERIFY2(answer.out.contains("FAIL  clock   try         grows"), qPrintable(answer.out));
        QVERIFY(answer.out.contains("wait until it swings 90 px wide"));
    }

    void languagesThatDifferAreNamed()
    {
        const QTemporaryDir dir;
        copyChanged("pendulum_clock", dir.path(), "swing.de.md", "- bob: 190, 286.3", "- bob: 200, 286.3");
        const Answer answer = springstep({"check", dir.path()});
        QCOMPARE(answer.code, 2);
        QVERIFY2(
            answer.err.contains("pendulum_clock, step \"swing\": the languages differ in their predictions."),
            qPrintable(answer.err));
    }

    void aMistakeNamesItsPlaceAndTheRemedy_data()
    {
        QTest::addColumn<QString>("file");
        QTest::addColumn<QByteArray>("from");
        QTest::addColumn<QByteArray>("to");
        QTest::addColumn<QString>("said");
        const auto row = [](const char *name, const char *file, const char *from, const char *to,
                            const QString &said) {
            QTest::newRow(name) << QString(file) << QByteArray(from) << QByteArray(to) << said;
        };
        row("a concept that no step explains", "clock.md", "Rests on: pendulum_length", "Rests on: pendulm",
            "the concept “limit_swing” rests on “pendulm”, which no step explains.");
        row("a heading without a space", "swing.md", "## Try {#let_go}", "##Try {#let_go}",
            "/swing.md, line 15: a space is missing after “#”. Write the heading as in “## Learnt”.");
        row("a drag of nothing", "swing.md", "- drag bob: 350, 286, 10", "- drag: 350, 286, 10",
            "/swing.md, line 38: nothing says which body to drag. Write its name, as in “- drag foot: 350, "
            "286, 10”.");
        row("a decimal comma", "swing.md", "- gravity: 1.2", "- gravity: 1,2",
            "gravity cannot be \"1,2\". It can be a number from -1000000 to 1000000.");
        row("a gap within a gap", "swing.code", "//<", "// <",
            "/swing.code: line 23: this gap begins inside another one. Write “//<” where that one ends.");
        row("a comma too many", "lesson.json", "\"clock\"]", "\"clock\",]",
            "/lesson.json: line 12: nothing follows the last comma before this ]; remove the comma.");
    }
    void aMistakeNamesItsPlaceAndTheRemedy()
    {
        QFETCH(QString, file);
        QFETCH(QByteArray, from);
        QFETCH(QByteArray, to);
        QFETCH(QString, said);
        const QTemporaryDir dir;
        copyChanged("pendulum_clock", dir.path(), file, from, to);
        const Answer answer = springstep({"check", dir.path()});
        QVERIFY2(answer.err.contains(said), qPrintable(answer.err));
        checkRefusal(answer);
    }

    void badInputIsOneSentence_data()
    {
        QTest::addColumn<QString>("path");
        QTest::addColumn<QString>("said");
        QTest::newRow("nothing there") << "/nowhere/at/all"
                                       << "there is no such folder or file";
        QTest::newRow("a folder without a lesson") << SOURCE_DIR "/lessons/examples"
                                                   << "there is no lesson.json";
        QTest::newRow("no zip")
            << lessonExamples + "pendulum_clock/swing.md"
            << "this is not a zip, or its end is missing. Choose the lesson.json or the zip of a lesson";
        QTest::newRow("a lesson in C++") << SOURCE_DIR "/lessons/two_body"
                                         << "lesson.json";
    }

    void badInputIsOneSentence()
    {
        QFETCH(QString, path);
        QFETCH(QString, said);
        const Answer answer = springstep({"check", path});
        QCOMPARE(answer.code, 2);
        QVERIFY(answer.out.isEmpty());
        QVERIFY2(isOneLine(answer.err) && answer.err.contains(said), qPrintable(answer.err));
    }
};

SUITE(tst_check_cli, TestCheckCli)
#include "tst_check_cli.moc"
