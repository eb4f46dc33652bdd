#include "app/model/catalog/progress.h"

#include <QSettings>
#include <QStringList>

namespace app {

namespace {

const char *const key = "progress/done";

QString nameOf(const QString &lesson, const QString &step, int number)
{
    return lesson + '/' + step + '/' + QString::number(number);
}

QString nameOfTask(const QString &lesson, const QString &step, const QString &task)
{
    return lesson + '/' + step + QStringLiteral("/code:") + task;
}

}

Progress::Progress(QObject *parent) : QObject(parent)
{
    const QStringList done = QSettings().value(key).toStringList();
    m_done = QSet<QString>(done.begin(), done.end());
}

bool Progress::isDone(const QString &lesson, const QString &step, int number) const
{
    return m_done.contains(nameOf(lesson, step, number));
}

void Progress::markDone(const QString &lesson, const QString &step, int number)
{
    mark(nameOf(lesson, step, number));
}

bool Progress::isWritten(const QString &lesson, const QString &step, const QString &task) const
{
    return m_done.contains(nameOfTask(lesson, step, task));
}

void Progress::markWritten(const QString &lesson, const QString &step, const QString &task)
{
    mark(nameOfTask(lesson, step, task));
}

void Progress::mark(const QString &name)
{
    if (m_done.contains(name))
        return;
    m_done.insert(name);
    save();
    emit changed();
}

QStringList Progress::forgetLesson(const QString &lesson)
{
    QStringList forgotten;
    for (const QString &one : m_done) {
        if (one.startsWith(lesson + '/'))
            forgotten.push_back(one);
    }
    for (const QString &one : forgotten)
        m_done.remove(one);
    save();
    emit changed();
    return forgotten;
}

void Progress::giveBack(const QStringList &ticks)
{
    m_done.unite(QSet<QString>(ticks.begin(), ticks.end()));
    save();
    emit changed();
}

void Progress::save() const
{
    QStringList done(m_done.begin(), m_done.end());
    done.sort();
    QSettings().setValue(key, done);
}

}
