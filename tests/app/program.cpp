#include "tests/app/program.h"

#include <QFile>
#include <QProcess>

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

Answer shell(const QString &command)
{
    return runProcess("bash", {"-c", "set -o pipefail; P=\"$0\"; " + command, PROGRAM});
}

bool isOneLine(const QString &text)
{
    return text.endsWith(".\n") && text.count('\n') == 1;
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
