// The program under attack, as a shell starts it: very little memory, files that are too large on purpose, names that
// contain control characters, and work that would take for ever.

#include "tests/app/cli/program.h"
#include "tests/sizes.h"
#include "tests/suite.h"

#include <QDir>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <sys/resource.h>
#include <unistd.h>

using namespace program;

namespace {

constexpr int mebi = 1 << 20;

/// Returns the output of the program with `mebibytes` of address space.
Answer within(int mebibytes, const QStringList &arguments)
{
    QProcess process;
    process.setProcessEnvironment(bareEnvironment());
    process.setChildProcessModifier([mebibytes] {
        const rlimit memory = {rlim_t(mebibytes) * mebi, rlim_t(mebibytes) * mebi};
        const rlimit noCore = {0, 0};
        setrlimit(RLIMIT_CORE, &noCore);
        setrlimit(RLIMIT_AS, &memory);
    });
    process.start(PROGRAM, arguments);
    if (!process.waitForFinished(300'000) || process.exitStatus() != QProcess::NormalExit)
        return {};
    return {process.exitCode(), QString::fromUtf8(process.readAllStandardOutput()),
            QString::fromUtf8(process.readAllStandardError())};
}

/// The program, with a terminal as its stderr.
class OnTerminal
{
public:
    explicit OnTerminal(const QStringList &arguments)
        : m_terminal(posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK))
    {
        grantpt(m_terminal);
        unlockpt(m_terminal);
        const QByteArray name = ptsname(m_terminal);
        m_process.setProcessEnvironment(bareEnvironment());
        m_process.setStandardOutputFile(QProcess::nullDevice());
        m_process.setChildProcessModifier([name] {
            const int other = ::open(name.constData(), O_RDWR | O_NOCTTY);
            ::dup2(other, STDERR_FILENO);
        });
        m_process.start(PROGRAM, arguments);
    }
    ~OnTerminal()
    {
        m_process.kill();
        m_process.waitForFinished();
        ::close(m_terminal);
    }

    /// Returns everything that was shown so far.
    const QByteArray &shown()
    {
        char piece[4096];
        for (ssize_t count = 0; (count = ::read(m_terminal, piece, sizeof piece)) > 0;)
            m_shown.append(piece, count);
        return m_shown;
    }
    /// Returns the last line, where the cursor is.
    QByteArray left()
    {
        const QByteArray all = shown();
        return all.mid(all.lastIndexOf("\x1b[K") + 3).trimmed();
    }
    void interrupt() { ::kill(pid_t(m_process.processId()), SIGINT); }
    QProcess &process() { return m_process; }

private:
    QProcess m_process;
    int m_terminal;
    QByteArray m_shown;
};

/// An experiment in the sandbox: `bodies` of them, a spring between each and the next ten; `more` fields.
QByteArray crowd(int bodies, const QByteArray &more)
{
    QByteArray text =
        "{\"format\": \"springstep-experiment/1\", \"lesson\": \"sandbox\", \"step\": \"build\",\n"
        "\"scene\": {\"bodies\": {";
    for (int i = 0; i < bodies; ++i)
        text += (i > 0 ? ",\n\"b" : "\n\"b") + QByteArray::number(i) +
                "\": {\"x\": " + QByteArray::number(20 * (i % 40)) +
                ", \"y\": " + QByteArray::number(20 * (i / 40)) + "}";
    text += "}, \"springs\": [";
    for (int i = 0; i < bodies; ++i) {
        for (int k = 1; k <= 10; ++k)
            text += (i + k > 1 ? ",\n" : "\n") + QByteArray("{\"a\": \"b") + QByteArray::number(i) +
                    "\", \"b\": \"b" + QByteArray::number((i + 37 * k) % bodies) +
                    "\", \"k\": 0.3, \"length\": 20}";
    }
    return text + "]}" + more + "}";
}

/// Input that sets a parameter `times` times: to one of `values`, a frame later each time.
QByteArray sets(int times, int values)
{
    QByteArray input = ", \"input\": [";
    for (int i = 0; i < times; ++i)
        input += (i > 0 ? ",\n" : "\n") + QByteArray("{\"frame\": ") + QByteArray::number(i + 1) +
                 ", \"event\": \"set\", \"parameter\": \"damp\", \"value\": " +
                 QByteArray::number(0.5 + 0.4 * (i % values) / values, 'g', 12) + "}";
    return input + "]";
}

}

class AttackTest : public QObject
{
    Q_OBJECT

private slots:
    void runningOutOfMemoryGivesOneErrorLine_data();
    void runningOutOfMemoryGivesOneErrorLine();
    void tooLargeExperimentIsRefusedInLimitedMemory_data();
    void tooLargeExperimentIsRefusedInLimitedMemory();
    void namesDoNotSteerTheTerminal_data();
    void namesDoNotSteerTheTerminal();
    void longWorkShowsProgressAndCanBeInterrupted_data();
    void longWorkShowsProgressAndCanBeInterrupted();

private:
    QString fileWith(const char *name, const QByteArray &text)
    {
        QFile file(m_folder.filePath(name));
        return file.open(QFile::WriteOnly) && file.write(text) == text.size() ? file.fileName() : QString();
    }
    /// The least memory, in MiB, with which the program and its lessons start.
    int least()
    {
        for (int mebibytes = 60; m_least == 0 && mebibytes < 2000; mebibytes += 10) {
            const Answer answer = within(mebibytes, {"trace", m_folder.filePath("small.json")});
            if (answer.code == 0)
                m_least = mebibytes;
        }
        return m_least;
    }

    QTemporaryDir m_folder;
    int m_least = 0;
};

void AttackTest::runningOutOfMemoryGivesOneErrorLine_data()
{
    QTest::addColumn<QByteArray>("text");
    const QByteArray start =
        "{\"format\": \"springstep-experiment/1\", \"lesson\": \"multi_foot\", \"step\": \"any_number\",\n";
    QByteArray keys = start;
    for (int i = 0; i < 400'000; ++i)
        keys += "\"key" + QByteArray::number(i) + "\": 0,\n";
    QTest::newRow("keys") << keys + "\"end\": 0}";
    QTest::newRow("lists") << start + "\"input\": [" + QByteArray("[],").repeated(1'900'000) + "0]}";
    QTest::newRow("a text") << start + "\"name\": \"" + QByteArray(30 * mebi, 'x') + "\"}";
    QByteArray events = start + "\"input\": [\n";
    for (int i = 0; i < 100'000; ++i)
        events += "{\"frame\": " + QByteArray::number(i) +
                  ", \"event\": \"set\", \"parameter\": \"k\", \"value\": 0." +
                  QByteArray::number(1 + i % 9) + "},\n";
    QTest::newRow("events") << events + "{\"frame\": 100000, \"event\": \"grab\", \"body\": \"body\"}]}";
    QTest::newRow("a crowd") << crowd(1000, ", \"method\": \"backward_euler\", \"frames\": 2");
}

void AttackTest::runningOutOfMemoryGivesOneErrorLine()
{
    if (tests::isSanitized)
        QSKIP("AddressSanitizer wants terabytes of address space");
    QFETCH(QByteArray, text);
    fileWith("small.json", "{\"format\": \"springstep-experiment/1\", \"lesson\": \"multi_foot\", \"step\": "
                           "\"any_number\", \"frames\": 1}");
    QVERIFY(least() > 0);
    const QString path = fileWith("large.json", text);
    int without = 0;
    for (int more = 1; more < 200; more += more < 40 ? 8 : 60) {
        const Answer answer = within(least() + more, {"trace", path});
        const QByteArray told =
            QString("%1 MiB: %2: %3").arg(least() + more).arg(answer.code).arg(answer.err).toUtf8();
        QVERIFY2(answer.code == 0 || answer.code == 2, told);
        QVERIFY2(answer.code == 0 ? answer.err.isEmpty() : isOneLine(answer.err), told);
        without += answer.err.contains("not enough memory") ? 1 : 0;
    }
    QVERIFY(without > 0); // otherwise nothing was tested
}

void AttackTest::tooLargeExperimentIsRefusedInLimitedMemory_data()
{
    QTest::addColumn<QByteArray>("piece");
    QTest::addColumn<QString>("sentence");
    QTest::newRow("keys") << QByteArray() << "at most 2097152 values";
    QTest::newRow("objects") << QByteArray("{\"a\":0},") << "at most 2097152 values";
    QTest::newRow("events") << QByteArray(
                                   "{\"frame\":1,\"event\":\"set\",\"parameter\":\"k\",\"value\":0.5},")
                            << "at most 2097152 values";
    QTest::newRow("bytes") << QByteArray(1000, ' ') << "larger than 32 MiB";
}

void AttackTest::tooLargeExperimentIsRefusedInLimitedMemory()
{
    if (tests::isSanitized)
        QSKIP("AddressSanitizer wants terabytes of address space");
    QFETCH(QByteArray, piece);
    QFETCH(QString, sentence);
    fileWith("small.json", "{\"format\": \"springstep-experiment/1\", \"lesson\": \"multi_foot\", \"step\": "
                           "\"any_number\", \"frames\": 1}");
    QByteArray text = "{\"input\": [";
    if (piece.isEmpty()) {
        text += '{';
        for (int i = 0; i < 2'500'000; ++i)
            text += '"' + QByteArray::number(i, 36) + "\":0,";
    } else {
        text += piece.repeated(
            sentence.contains("larger") ? 34'000 : std::min<qsizetype>(31 * mebi / piece.size(), 3'000'000));
    }
    constexpr int enough = 420; // MiB on top of what the program itself takes
    const Answer answer = within(least() + enough, {"trace", fileWith("large.json", text)});
    QCOMPARE(answer.code, 2);
    QVERIFY2(isOneLine(answer.err) && answer.err.contains(sentence), qPrintable(answer.err));
}

void AttackTest::namesDoNotSteerTheTerminal_data()
{
    QTest::addColumn<QStringList>("arguments");
    const QString bad = QString("x\x1b]0;y\x07\n") + QChar(0x2028) + QChar(0x202e) + "z";
    const auto row = [&](const char *name, const QStringList &arguments) {
        QTest::newRow(name) << arguments;
    };
    row("a verb", {bad});
    row("two of them", {bad, bad});
    row("an option", {"trace", "--" + bad});
    row("a file of trace", {"trace", m_folder.filePath(bad)});
    row("a file of film", {"film", m_folder.filePath(bad), m_folder.filePath("a.gif")});
    row("a film", {"film", m_folder.filePath("none.json"), bad});
    row("a step", {"accuracy", "two_body/" + bad});
    row("a lesson", {"cost", bad + "/mutual"});
    row("a case", {"hardcases", "--case", bad});
    row("a case that is nearly there", {"hardcases", "--case", "stif"});
    row("a number", {"cost", "two_body/mutual", "--frame", bad});
    row("a picture", {"screenshot", "two_body/" + bad, m_folder.filePath("a.png")});
    row("a size", {"screenshot", "two_body/mutual", m_folder.filePath("a.png"), "--size", bad});
    row("a long file", {"trace", m_folder.filePath(QString("x").repeated(10'000))});
    row("a long case", {"hardcases", "--case", QString("x").repeated(10'000)});
    row("a lesson in a file",
        {"trace", fileWith("lesson.json", "{\"format\": \"springstep-experiment/1\", \"lesson\": "
                                          "\"x\\u001b]0;y\\u0007\\n\\u2028\"}")});
    row("a body in a file of many",
        {"trace", fileWith("body.json", crowd(1000, ", \"input\": [{\"frame\": 1, \"event\": "
                                                    "\"grab\", \"body\": \"b1000\\u2028\"}]"))});
}

void AttackTest::namesDoNotSteerTheTerminal()
{
    QFETCH(QStringList, arguments);
    const Answer answer = springstep(arguments);
    QCOMPARE(answer.code, 2);
    QVERIFY2(isOneLine(answer.err) && answer.err.size() > 20 && answer.err.size() < 500,
             qPrintable(answer.err));
    for (const QChar c : answer.err.chopped(1))
        QVERIFY2(c.isPrint() && c.category() != QChar::Separator_Line, qPrintable(answer.err));
}

void AttackTest::longWorkShowsProgressAndCanBeInterrupted_data()
{
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<QByteArray>("progress");
    QTest::addColumn<QByteArray>("end");
    const QString stiff =
        fileWith("stiff.json", crowd(1000, ", \"method\": \"backward_euler\", \"frames\": 10000000"));
    const QString many =
        fileWith("many.json", crowd(1000, ", \"frames\": 10000000" + sets(100'000, 100'000)));
    const QString film = m_folder.filePath("a.webm");
    const auto row = [](const char *name, const QStringList &arguments, const char *progress,
                        const char *end) {
        QTest::newRow(name) << arguments << QByteArray(progress) << QByteArray(end);
    };
    row("trace", {"trace", stiff}, "Frame ", "Stopped at frame ");
    row("reading", {"trace", many}, "Reading ", "Stopped: Reading ");
    row("film", {"film", stiff, film}, "Frame ", "Stopped at frame ");
    row("the end of a long film", {"film", stiff, m_folder.filePath("a.gif"), "--from", "9999990"}, "Frame ",
        "Stopped at frame ");
    row("accuracy", {"accuracy", stiff}, "Measured ", "Stopped before the end.");
    row("cost of a late frame", {"cost", stiff, "--frame", "10000000"}, "Frame ", "Stopped before the end.");
    row("hardcases", {"hardcases", "--full"}, "%", "Stopped before the end.");
}

void AttackTest::longWorkShowsProgressAndCanBeInterrupted()
{
    QFETCH(QStringList, arguments);
    QFETCH(QByteArray, progress);
    QFETCH(QByteArray, end);
    OnTerminal terminal(arguments);
    QTRY_VERIFY2_WITH_TIMEOUT(terminal.shown().contains(progress), terminal.shown().constData(), 120'000);
    terminal.interrupt();
    QTRY_COMPARE_WITH_TIMEOUT(terminal.process().state(), QProcess::NotRunning, 60'000);
    QCOMPARE(terminal.process().exitStatus(), QProcess::NormalExit);
    QCOMPARE(terminal.process().exitCode(), 130);
    QVERIFY2(terminal.left().contains(end), terminal.shown().constData());
    QCOMPARE(QDir(m_folder.path()).entryList({"a.*"}), QStringList());
}

SUITE(tst_attack, AttackTest)
#include "tst_attack.moc"
