#include "tests/app/cli/program.h"

#include <QFile>
#include <QJsonDocument>
#include <QTest>

#include <cmath>
#include <csignal>

namespace program {

QProcessEnvironment bareEnvironment()
{
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    for (const char *name : {"DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM"})
        environment.remove(name);
    environment.insert("SPRINGSTEP_LESSONS", LESSON_DIR);
    return environment;
}

Answer runProcess(const QString &file, const QStringList &arguments, const QString &lessons)
{
    QProcess process;
    QProcessEnvironment environment = bareEnvironment();
    environment.insert("SPRINGSTEP_LESSONS", lessons);
    process.setProcessEnvironment(environment);
    process.start(file, arguments);
    if (!process.waitForFinished(300'000) || process.exitStatus() != QProcess::NormalExit)
        return {};
    return {process.exitCode(), QString::fromUtf8(process.readAllStandardOutput()),
            QString::fromUtf8(process.readAllStandardError())};
}

Answer springstep(const QStringList &arguments)
{
    return runProcess(PROGRAM, arguments);
}

QJsonObject json(const Answer &answer)
{
    return QJsonDocument::fromJson(answer.out.toUtf8()).object();
}

Answer shell(const QString &command)
{
    return runProcess("bash", {"-c", "set -o pipefail; P=\"$0\"; " + command, PROGRAM});
}

namespace {

/// Returns whether a process has installed a handler for a signal.
bool handles(qint64 process, int signal)
{
    QFile status(QString("/proc/%1/status").arg(process));
    if (!status.open(QFile::ReadOnly))
        return false;
    for (const QByteArray &line : status.readAll().split('\n')) {
        if (line.startsWith("SigCgt:"))
            return line.mid(7).trimmed().toULongLong(nullptr, 16) >> (signal - 1) & 1;
    }
    return false;
}

}

void compareTrajectories(const QString &trace, const QString &expected)
{
    const QStringList rows = trace.split('\n'), wantedRows = expected.split('\n');
    QCOMPARE(rows.size(), wantedRows.size());
    QCOMPARE(rows.first(), wantedRows.first().trimmed());
    for (qsizetype i = 1; i < rows.size() - 1; ++i) {
        const QStringList row = rows[i].split(','), wanted = wantedRows[i].trimmed().split(',');
        QCOMPARE(row.mid(0, 2), wanted.mid(0, 2));
        QCOMPARE(row.size(), wanted.size());
        for (qsizetype field = 2; field < row.size(); ++field)
            QVERIFY2(std::abs(row[field].toDouble() - wanted[field].toDouble()) <= 1e-9,
                     qPrintable(rows[i] + " | " + wantedRows[i]));
    }
}

bool interrupt(QProcess &process)
{
    if (!QTest::qWaitFor([&] { return handles(process.processId(), SIGINT); }, 30'000))
        return false;
    ::kill(static_cast<pid_t>(process.processId()), SIGINT);
    return process.waitForFinished() && process.exitStatus() == QProcess::NormalExit;
}

bool isOneLine(const QString &text)
{
    return text.endsWith(".\n") && text.count('\n') == 1;
}

void checkRefusal(const Answer &answer)
{
    QVERIFY2(isOneLine(answer.err), qPrintable(answer.err));
    QCOMPARE(answer.out, QString());
    QCOMPARE(answer.code, 2);
}

QString fileWith(const QString &folder, const QString &fields)
{
    const QString path = folder + "/experiment.json";
    QFile file(path);
    if (file.open(QIODevice::WriteOnly))
        file.write("{\n\"format\": \"springstep-experiment/1\",\n\"lesson\": \"multi_foot\",\n\"step\": "
                   "\"any_number\",\n" +
                   fields.toUtf8() + "\n}\n");
    return path;
}

}
