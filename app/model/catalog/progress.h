#pragma once

#include <QObject>
#include <QSet>
#include <QString>
#include <QStringList>

namespace app {

/// The word in place of a step in the keys of projects, whose levels count as tasks.
inline constexpr auto projectTicks = "project";

/// A record of which things to try are done, by "lesson/step/number", and which tasks in listings are done, by
/// "lesson/step/code:id". It is kept between starts of the program.
class Progress : public QObject
{
    Q_OBJECT

public:
    explicit Progress(QObject *parent = nullptr);

    bool isDone(const QString &lesson, const QString &step, int number) const;
    void markDone(const QString &lesson, const QString &step, int number);
    /// Returns whether the learner wrote the code of the task with this id.
    bool isWritten(const QString &lesson, const QString &step, const QString &task) const;
    void markWritten(const QString &lesson, const QString &step, const QString &task);
    /// Removes the ticks of one lesson, and returns them.
    QStringList forgetLesson(const QString &lesson);
    /// Restores the ticks that forgetLesson() returned.
    void giveBack(const QStringList &ticks);

signals:
    void changed();

private:
    void mark(const QString &name);
    void save() const;

    QSet<QString> m_done;
};

}
