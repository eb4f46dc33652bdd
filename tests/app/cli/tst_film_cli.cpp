// `springstep film`, as a shell starts it.

#include "tests/app/cli/program.h"
#include "tests/suite.h"

#include <QDir>
#include <QImage>
#include <QImageReader>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

#include <csignal>

using namespace program;

class FilmCliTest : public QObject
{
    Q_OBJECT

private slots:
    void aFileBecomesAFilm();
    void optionsDoWhatTheySay();
    void aFrameBecomesAPicture();
    void numbersHaveTheDigitsThatTheHelpSays();
    void badUseIsOneSentenceAndCodeTwo_data();
    void badUseIsOneSentenceAndCodeTwo();
    void filmOfAStoppedRunEndsAtItsLastFrameWithExitCode1();
    void pageOfAStoppedRunIsWrittenWithExitCode1();
    void codeThatStopsARunIsNamedWithItsLine();
    void interruptingLeavesNoPartialFile_data();
    void interruptingLeavesNoPartialFile();

private:
    QTemporaryDir m_folder;
    QString file(const QString &fields) { return fileWith(m_folder.path(), fields); }
    QString out(const char *name) { return m_folder.filePath(name); }
    /// Whether a program has a file of the folder open, under whatever name.
    bool writesIn(qint64 process)
    {
        const QDir open(QString("/proc/%1/fd").arg(process));
        for (const QString &number : open.entryList(QDir::Files | QDir::System)) {
            const QString file = QFile::symLinkTarget(open.filePath(number));
            if (file.startsWith(m_folder.path()) && !file.endsWith("experiment.json"))
                return true;
        }
        return false;
    }
    QStringList there(const char *pattern) { return QDir(m_folder.path()).entryList({pattern}); }
};

void FilmCliTest::aFileBecomesAFilm()
{
    const Answer answer = springstep({"film", file("\"frames\": 20"), out("a.gif")});
    QCOMPARE(answer.code, 0);
    QCOMPARE(answer.out + answer.err, QString());
    QImageReader film(out("a.gif"));
    QCOMPARE(film.size(), QSize(640, 480));
    QCOMPARE(film.imageCount(), 21);
}

void FilmCliTest::optionsDoWhatTheySay()
{
    const QString from = file("\"frames\": 20");
    QCOMPARE(springstep({"film", from, out("b.gif"), "--size", "200x150", "--from", "3", "--to", "8", "--fps",
                         "20", "--theme", "dark"})
                 .code,
             0);
    QImageReader film(out("b.gif"));
    QCOMPARE(film.size(), QSize(200, 150));
    QCOMPARE(film.imageCount(), 6);
    const QImage first = film.read();
    QCOMPARE(film.nextImageDelay(), 50);
    QVERIFY(first.pixelColor(1, 1).lightness() < 60);
}

void FilmCliTest::aFrameBecomesAPicture()
{
    QCOMPARE(springstep({"film", file("\"h\": 2"), out("c_%03d.png"), "--to", "9", "--size", "200x150"}).code,
             0);
    QCOMPARE(there("c_*"), QStringList({"c_000.png", "c_002.png", "c_004.png", "c_006.png", "c_008.png"}));
    QCOMPARE(QImage(out("c_004.png")).size(), QSize(200, 150));
}

void FilmCliTest::numbersHaveTheDigitsThatTheHelpSays()
{
    const QString from = file("\"frames\": 20");
    for (const char *name : {"n_%d.png", "n_%04d.png"})
        QCOMPARE(springstep({"film", from, out(name), "--from", "9", "--to", "10", "--size", "200x150"}).code,
                 0);
    QCOMPARE(there("n_*"), QStringList({"n_0009.png", "n_0010.png", "n_10.png", "n_9.png"})); // by name
    const QString help = springstep({"film", "--help"}).out.simplified();
    QVERIFY2(help.contains("4 digits, such as 0007. %d writes 7, and the files do not sort by name."),
             qPrintable(help));
}

void FilmCliTest::badUseIsOneSentenceAndCodeTwo_data()
{
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<QString>("names");
    const QString from = file("\"frames\": 20");
    const auto row = [](const char *name, const QStringList &arguments, const char *names) {
        QTest::newRow(name) << arguments << QString(names);
    };
    row("no film's name", {from, out("x.mp4")}, "%04d");
    row("no name", {from}, "FILE OUT");
    row("no such file", {out("none.json"), out("x.gif")}, "no such file");
    row("a size", {from, out("x.gif"), "--size", "big"}, "--size");
    row("a theme", {from, out("x.gif"), "--theme", "pink"}, "--theme");
    row("frames the wrong way round", {from, out("x.gif"), "--from", "9", "--to", "3"}, "Swap");
    row("a frame that is none", {from, out("x.gif"), "--from", "-1"}, "--from");
    row("too fast", {from, out("x.gif"), "--fps", "60"}, "--fps");
    row("a time in pictures", {from, out("x_%d.png"), "--fps", "25"}, "--fps");
    row("a folder that is not there", {from, out("nowhere/x.gif")}, "nowhere");
    row("another ending", {from, out("x.htm")}, ".html");
    row("a page of a certain size", {from, out("x.html"), "--size", "320x200"}, "--size");
    row("a page with a theme", {from, out("x.html"), "--theme", "dark"}, "--theme");
    row("a page that plays too fast", {from, out("x.html"), "--fps", "500"}, "--fps");
    row("a page whose frames are the wrong way round", {from, out("x.html"), "--from", "9", "--to", "3"},
        "Swap");
    row("a page of a long run", {from, out("x.html"), "--to", "5000000"}, "100000 frames");
    row("a language that is none", {from, out("x.gif"), "--language", "xx"}, "en, es, fr");
    row("a film with a plot", {from, out("x.gif"), "--plot", "energy"}, "--plot is for web pages");
    row("a film with a ghost", {from, out("x.gif"), "--ghost", "before"}, "--ghost is for web pages");
    row("a plot of nothing", {from, out("x.html"), "--plot", "beauty(body)"}, "velocity_x");
    row("a plot of time", {from, out("x.html"), "--plot", "time"}, "velocity_x");
    row("a plot of a body that is none", {from, out("x.html"), "--plot", "y(nose)"}, "there is no \"nose\"");
    row("a distance to no body", {from, out("x.html"), "--plot", "distance(foot0)"}, "distance(foot0, body)");
    row("a distance to a body that is none", {from, out("x.html"), "--plot", "distance(foot0, nose)"},
        "there is no \"nose\"");
    row("a plot without values", {from, out("x.html"), "--plot", "angle(body)"}, "no value in this scene");
    row("a plot against nothing", {from, out("x.html"), "--plot", "y(body):"}, "--plot is \"\"");
    QStringList many = {from, out("x.html")};
    for (int i = 0; i < 9; ++i)
        many << "--plot"
             << "x";
    row("too many plots", many, "room for 8 plots");
    row("a ghost that is none", {from, out("x.html"), "--ghost", "before"}, "no other run");
    row("a page in a folder that is not there", {from, out("nowhere/x.html")}, "nowhere");
}

void FilmCliTest::badUseIsOneSentenceAndCodeTwo()
{
    QFETCH(QStringList, arguments);
    QFETCH(QString, names);
    const Answer answer = springstep(QStringList{"film"} + arguments);
    QVERIFY2(answer.err.contains(names), qPrintable(answer.err));
    checkRefusal(answer);
    QCOMPARE(there("x*"), QStringList());
}

void FilmCliTest::filmOfAStoppedRunEndsAtItsLastFrameWithExitCode1()
{
    const QString from = file("\"method\": \"explicit_euler\", \"parameters\": {\"k\": 1, \"damp\": 1}, "
                              "\"frames\": 100000");
    const Answer trace = springstep({"trace", from});
    QCOMPARE(trace.code, 1);
    const int last = trace.out.trimmed().section('\n', -1).section(',', 0, 0).toInt();
    QVERIFY(last > 10);
    const QString start = QString::number(last - 4);
    const Answer answer = springstep({"film", from, out("d_%d.png"), "--from", start, "--size", "200x150"});
    QCOMPARE(answer.code, 1);
    QCOMPARE(answer.err, trace.err);
    QCOMPARE(there("d_*").size(), 5);
    QVERIFY(QFile::exists(out(qPrintable(QString("d_%1.png").arg(last)))));
}

void FilmCliTest::pageOfAStoppedRunIsWrittenWithExitCode1()
{
    const QString from = file("\"method\": \"explicit_euler\", \"parameters\": {\"k\": 1, \"damp\": 1}, "
                              "\"frames\": 90000");
    const Answer trace = springstep({"trace", from});
    const Answer answer = springstep({"film", from, out("stops.html")});
    QCOMPARE(answer.code, 1);
    QCOMPARE(answer.err, trace.err);
    QCOMPARE(there("stops*"), QStringList("stops.html"));
}

void FilmCliTest::codeThatStopsARunIsNamedWithItsLine()
{
    const QString from =
        file("\"method\": \"listing\", \"code\": \"void frame()\\n{\\n    body.position.x += "
             "1 / (6 - frame_number);\\n}\\n\", \"frames\": 20");
    const Answer answer = springstep({"film", from, out("f_%d.png"), "--size", "200x150"});
    QCOMPARE(answer.code, 1);
    QVERIFY2(isOneLine(answer.err) && answer.err.contains("frame 5") &&
                 answer.err.contains("Line 3 of your code"),
             qPrintable(answer.err));
    QCOMPARE(answer.err, springstep({"trace", from}).err);
    QCOMPARE(there("f_*").size(), 6);
}

void FilmCliTest::interruptingLeavesNoPartialFile_data()
{
    QTest::addColumn<QString>("name");
    QTest::newRow("GIF") << "e.gif";
    QTest::newRow("PNG") << "e_%d.png";
}

void FilmCliTest::interruptingLeavesNoPartialFile()
{
    QFETCH(QString, name);
    QProcess process;
    process.setProcessEnvironment(bareEnvironment());
    process.start(PROGRAM, {"film", file("\"frames\": 3000"), out(qPrintable(name)), "--size", "1600x1200"});
    QVERIFY(process.waitForStarted());
    QTRY_VERIFY_WITH_TIMEOUT(writesIn(process.processId()), 60'000);
    ::kill(static_cast<pid_t>(process.processId()), SIGINT);
    QVERIFY(process.waitForFinished(60'000));
    QCOMPARE(process.exitStatus(), QProcess::NormalExit);
    QCOMPARE(process.exitCode(), 130);
    QVERIFY(QString::fromUtf8(process.readAllStandardError()).startsWith("Stopped at frame "));
    for (const QString &left : there("e*")) {
        if (left != "experiment.json")
            QVERIFY2(left.endsWith(".png") && QImage(out(qPrintable(left))).size() == QSize(1600, 1200),
                     qPrintable(left));
    }
}

SUITE(tst_film_cli, FilmCliTest)
#include "tst_film_cli.moc"
