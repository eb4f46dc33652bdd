#pragma once

#include <QObject>
#include <QSet>
#include <QString>
#include <QStringList>

namespace app {

/// Which things to try are done, by "lesson/step/number"; kept from one start of the program to the next.
class Progress : public QObject
{
    Q_OBJECT

public:
    explicit Progress(QObject *parent = nullptr);

    bool isDone(const QString &lesson, const QString &step, int number) const;
    void markDone(const QString &lesson, const QString &step, int number);
    void forgetAll();
    /// Takes the ticks of one lesson away, and returns them.
    QStringList forgetLesson(const QString &lesson);
    /// Gives back what forgetLesson() returned.
    void giveBack(const QStringList &ticks);

signals:
    void changed();

private:
    void save() const;

    QSet<QString> m_done;
};

}
