#pragma once

#include <QDateTime>
#include <QHash>
#include <QObject>
#include <QString>

namespace app {

/// What a learner answered to a question, and what came out. Both texts are plain numbers or words, which the window
/// puts into a sentence: "300, 220", "12.5", "2".
struct Note
{
    QString kind; ///< of the question: "place", "number", "curve", "choice", …
    QString said;
    QString found = {};
    bool isRight = false;
    QDateTime at = {}; ///< UTC
    friend bool operator==(const Note &, const Note &) = default;
};

/// The learner's notes, kept between starts of the program. Their keys: "lesson/step/predict:id",
/// "lesson/step/choice:id", "lesson/recall:id", "lesson/project:id".
class Notes : public QObject
{
    Q_OBJECT

public:
    explicit Notes(QObject *parent = nullptr);

    static QString keyOf(const QString &lesson, const QString &step, const QString &kind, const QString &id);

    /// Returns the note with this key; null if there is none. It is valid until the next change.
    const Note *find(const QString &key) const;
    /// Keeps `note` in place of an earlier one. Without a time, it gets the present one.
    void keep(const QString &key, Note note);
    void forget(const QString &key);

signals:
    void changed();

private:
    QHash<QString, Note> m_notes;
};

}
