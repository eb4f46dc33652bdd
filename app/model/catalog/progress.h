#pragma once

#include <QObject>
#include <QSet>
#include <QString>
#include <QStringList>

namespace app {

/// A record of which things to try are done, by "lesson/step/number". It is kept between starts of the program.
class Progress : public QObject
{
    Q_OBJECT

public:
    explicit Progress(QObject *parent = nullptr);

    bool isDone(const QString &lesson, const QString &step, int number) const;
    void markDone(const QString &lesson, const QString &step, int number);
    void forgetAll();
    /// Removes the ticks of one lesson, and returns them.
    QStringList forgetLesson(const QString &lesson);
    /// Restores the ticks that forgetLesson() returned.
    void giveBack(const QStringList &ticks);

signals:
    void changed();

private:
    void save() const;

    QSet<QString> m_done;
};

}
