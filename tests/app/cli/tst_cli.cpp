#include "sim/methods/methods.h"
#include "tests/app/cli/program.h"
#include "tests/suite.h"

#include <QDir>
#include <QFile>
#include <QImage>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>

#include <set>

using namespace program;

/// The output and the exit codes of the command line.
class TestCli : public QObject
{
    Q_OBJECT

private slots:

    void badUseIsOneSentenceAndExitCode2_data()
    {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<QString>("sentence");
        const auto row = [](const char *name, const QStringList &arguments, const QString &sentence) {
            QTest::newRow(name) << arguments << sentence;
        };
        row("the window without a display", {},
            "there is no display for the window; set DISPLAY, or use a verb that needs none: lessons, "
            "check, trace, accuracy, hardcases, cost, screenshot, film, notebook, handout.");
        row("a verb with a slip", {"tracee", "x"},
            "there is no verb \"tracee\"; the verbs are lessons, check, trace, accuracy, "
            "hardcases, cost, screenshot, film, notebook, handout.");
        row("neither verb nor file", {"lesons"},
            "there is no verb and no file \"lesons\"; the verbs are lessons, check, trace, accuracy, "
            "hardcases, cost, screenshot, film, notebook, handout.");
        row("two files", {SOURCE_DIR "/README.md", "b"}, "the window opens one file; leave out \"b\".");
        row("an unknown option", {"--fast"}, "Unknown option 'fast'; see springstep --help.");
        row("an unknown option of a verb", {"lessons", "--xml"},
            "Unknown option 'xml'; see springstep lessons --help.");
        row("trace of nothing", {"trace"}, "trace takes FILE; see springstep trace --help.");
        row("trace of two files", {"trace", "a", "b"}, "trace takes FILE; see springstep trace --help.");
        row("lessons with a name", {"lessons", "a"},
            "lessons takes no arguments; see springstep lessons --help.");
        row("screenshot without a picture", {"screenshot", "two_body/mutual"},
            "screenshot takes LESSON/STEP OUT.png; see springstep screenshot --help.");
        row("screenshot of a lesson", {"screenshot", "two_body", "a.png"},
            "\"two_body\" is not a step; name it as LESSON/STEP, as \"springstep lessons\" lists them.");
        row("screenshot of a frame below 0", {"screenshot", "a/b", "a.png", "--frame", "-1"},
            "--frame is \"-1\"; it can be a whole number from 0 to 10000000.");
        row("screenshot of a huge frame", {"screenshot", "a/b", "a.png", "--frame", "10000001"},
            "--frame is \"10000001\"; it can be a whole number from 0 to 10000000.");
        row("screenshot without a size", {"screenshot", "a/b", "a.png", "--size", "0x0"},
            "--size is \"0x0\"; it can be WIDTHxHEIGHT in pixels, each from 100 to 9999, such as 1280x800.");
        row("screenshot in blue", {"screenshot", "a/b", "a.png", "--theme", "blue"},
            "--theme is \"blue\"; it can be \"light\", \"dark\" or \"contrast\".");
        row("screenshot in a mode that is none", {"screenshot", "a/b", "a.png", "--mode", "dance"},
            "--mode is \"dance\"; it can be \"learn\" or \"measure\".");
    }
    void badUseIsOneSentenceAndExitCode2()
    {
        QFETCH(QStringList, arguments);
        QFETCH(QString, sentence);
        const Answer answer = springstep(arguments);
        QCOMPARE(answer.err, "springstep: " + sentence + '\n');
        checkRefusal(answer);
    }

    void aBadFileIsOneSentenceAndExitCode2()
    {
        const Answer bad = springstep({"trace", fileWith("\"parameters\": {\n\"damp\": 1.4}")});
        QCOMPARE(bad.err, "experiment.json: line 6: \"damp\" is 1.4; it can be 0 to 1.\n");
        QCOMPARE(bad.out, QString());
        QCOMPARE(bad.code, 2);
        const Answer long_ = springstep({"trace", fileWith("\"frames\": 10000001")});
        QVERIFY(isOneLine(long_.err));
        QCOMPARE(long_.code, 2);
        const Answer none = springstep({"trace", "none.json"});
        QCOMPARE(none.err, "none.json: there is no such file; check its name and folder.\n");
        QCOMPARE(none.code, 2);
    }

    void screenshotNeedsNoDisplay()
    {
        const QString picture = m_folder.filePath("picture.png");
        const Answer answer = springstep({"screenshot", "two_body/mutual", "--frame", "20", "--phase", "1",
                                          "--size", "1000x700", picture});
        QCOMPARE(answer.err, QString());
        QCOMPARE(answer.code, 0);
        QFile file(picture);
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QByteArray header = file.read(24);
        QVERIFY(header.startsWith("\x89PNG"));
        QCOMPARE(header.mid(16), QByteArray::fromHex("000003e8000002bc")); // 1000 x 700
    }

    void screenshotInsideAFrameShowsItsPhases()
    {
        const QString picture = m_folder.filePath("phase.png");
        const Answer answer = springstep({"screenshot", "two_body/mutual", "--frame", "20", "--phase", "2",
                                          "--size", "1280x800", picture});
        QCOMPARE(answer.code, 0);
        const QImage strip = QImage(picture).copy(310, 745, 540, 14); // below the timeline
        std::set<QRgb> colors;
        for (int x = 0; x < strip.width(); ++x)
            colors.insert(strip.pixel(x, strip.height() / 2));
        QVERIFY(colors.size() > 10);
    }

    void screenshotOfAMissingStepListsTheStepsOfTheLesson()
    {
        const Answer answer = springstep({"screenshot", "two_body/sideways", m_folder.filePath("none.png")});
        QCOMPARE(answer.err,
                 "springstep: The lesson \"two_body\" has no step \"sideways\"; it has \"mutual\", "
                 "\"leg_line\".\n");
        QCOMPARE(answer.code, 2);
    }

    void helpAndVersionExitWithCode0()
    {
        for (const QStringList &arguments : {QStringList{"--help"},
                                             {"lessons", "--help"},
                                             {"trace", "-h"},
                                             {"accuracy", "--help"},
                                             {"screenshot", "--help"}}) {
            const Answer answer = springstep(arguments);
            QCOMPARE(answer.code, 0);
            QVERIFY2(answer.out.startsWith("Usage: springstep "), qPrintable(answer.out));
        }
        const Answer version = springstep({"--version"});
        QCOMPARE(version.code, 0);
        QVERIFY(QRegularExpression("\\Aspringstep \\d+\\.\\d+\\.\\d+\n\\z").match(version.out).hasMatch());
    }

    void lessonsListsStepsParametersAndMethods()
    {
        const Answer answer = springstep({"lessons"});
        QCOMPARE(answer.code, 0);
        QCOMPARE(answer.err, QString());
        for (const char *wanted :
             {"single_spring/radial", "two_body/mutual", "sandbox/build", "damp", "semi_implicit_euler"})
            QVERIFY2(answer.out.contains(wanted), wanted);
    }

    void lessonsAsJsonHasTheDocumentedShape()
    {
        const Answer answer = springstep({"lessons", "--json"});
        QCOMPARE(answer.code, 0);
        const QJsonObject all = QJsonDocument::fromJson(answer.out.toUtf8()).object();
        QCOMPARE(all.keys(), QStringList({"lessons", "methods"}));
        int order = 0;
        QStringList ids;
        for (const QJsonValue &lesson : all["lessons"].toArray()) {
            ids << lesson["id"].toString();
            QCOMPARE(lesson.toObject().keys(), QStringList({"id", "order", "steps", "title"}));
            QVERIFY(lesson["order"].toInt() > order);
            order = lesson["order"].toInt();
            for (const QJsonValue &step : lesson["steps"].toArray()) {
                QCOMPARE(step.toObject().keys(), QStringList({"id", "parameters", "title"}));
                for (const QJsonValue &parameter : step["parameters"].toArray()) {
                    const QStringList keys = parameter.toObject().keys();
                    if (keys.contains("choices")) {
                        QCOMPARE(keys, QStringList({"choices", "default", "id"}));
                        QVERIFY(parameter["choices"].toArray().contains(parameter["default"]));
                        continue;
                    }
                    QCOMPARE(keys, QStringList({"default", "id", "max", "min", "unit"}));
                    QVERIFY(parameter["default"].isDouble() && parameter["unit"].isString());
                }
            }
        }
        QVERIFY(order > 0);
        // Everything that a file can name is listed, also the sandbox.
        for (const QString &plugin : QDir(LESSON_DIR).entryList({"liblesson_*.so"})) {
            const QString id = plugin.mid(10).chopped(3);
            QVERIFY2(ids.removeOne(id), qPrintable(id));
        }
        QCOMPARE(ids, QStringList());
        QCOMPARE(std::size_t(all["methods"].toArray().size()), sim::allMethods().size());
        QCOMPARE(all["methods"][0].toObject().keys(), QStringList({"id", "needs", "order"}));
        QCOMPARE(all["methods"][0]["id"].toString(), "published");
        QCOMPARE(all["methods"][0]["needs"].toArray(), QJsonArray{"groups"});
    }

    void aFileThatIsNoLessonIsNamedAndTheRestWorks()
    {
        const QTemporaryDir folder;
        QFile file(folder.filePath("libnone.so"));
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write("none") == 4);
        file.close();
        const Answer answer = runProcess(PROGRAM, {"lessons"}, folder.path() + ':' + LESSON_DIR);
        QCOMPARE(answer.code, 0);
        QVERIFY(answer.out.contains("single_spring/radial"));
        QCOMPARE(answer.err, folder.filePath("libnone.so") +
                                 ": It is not a plugin, or it is damaged; install it "
                                 "again, or move it to another folder.\n");
    }

private:
    QString fileWith(const QString &fields) const { return program::fileWith(m_folder.path(), fields); }

    QTemporaryDir m_folder;
};

SUITE(tst_cli, TestCli)
#include "tst_cli.moc"
