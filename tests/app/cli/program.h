#pragma once

#include <QJsonObject>
#include <QProcess>
#include <QProcessEnvironment>
#include <QString>
#include <QStringList>

/// The real program, as a shell would start it, without any display.
namespace program {

/// The output and exit code of a process; `code` is -1 if it crashed or never ended.
struct Answer
{
    int code = -1;
    QString out;
    QString err;
};

QProcessEnvironment bareEnvironment();
Answer runProcess(const QString &file, const QStringList &arguments, const QString &lessons = LESSON_DIR);
Answer springstep(const QStringList &arguments);
/// Returns the JSON object that a process wrote to its standard output; empty if it wrote none.
QJsonObject json(const Answer &answer);
/// Runs `command` in a shell, in which $P is the program.
Answer shell(const QString &command);
/// Writes an experiment of the step with any number of feet into `folder`; `fields` begin on line 5.
QString fileWith(const QString &folder, const QString &fields);
/// Fails unless two traces, as CSV, have the same rows, with numbers that differ by at most 1e-9 (px, px/frame).
void compareTrajectories(const QString &trace, const QString &expected);
/// Waits until the process handles SIGINT, and sends it. Returns whether the process then ended normally.
bool interrupt(QProcess &process);
/// Returns whether `text` is one sentence.
bool isOneLine(const QString &text);
/// Fails unless the program refused its arguments: one sentence on standard error, nothing else, and exit code 2.
void checkRefusal(const Answer &answer);

}
