#include "app/model/learning/notes.h"

#include <QSettings>
#include <QStringList>

namespace app {

namespace {

const char *const notesGroup = "notes";
constexpr qsizetype notesFields = 5;

QStringList fieldsOf(const Note &note)
{
    return {note.kind, note.said, note.found, note.isRight ? QStringLiteral("right") : QString(),
            note.at.toString(Qt::ISODate)};
}

}

Notes::Notes(QObject *parent) : QObject(parent)
{
    QSettings settings;
    settings.beginGroup(notesGroup);
    const QStringList keys = settings.allKeys();
    for (const QString &key : keys) {
        const QStringList fields = settings.value(key).toStringList();
        if (fields.size() == notesFields) // others are from another version of the program
            m_notes.insert(key, {fields[0], fields[1], fields[2], !fields[3].isEmpty(),
                                 QDateTime::fromString(fields[4], Qt::ISODate)});
    }
}

QString Notes::keyOf(const QString &lesson, const QString &step, const QString &kind, const QString &id)
{
    return QStringLiteral("%1/%2/%3:%4").arg(lesson, step, kind, id);
}

const Note *Notes::find(const QString &key) const
{
    const auto found = m_notes.constFind(key);
    return found == m_notes.constEnd() ? nullptr : &*found;
}

void Notes::keep(const QString &key, Note note)
{
    if (!note.at.isValid())
        note.at = QDateTime::currentDateTimeUtc();
    QSettings().setValue(QStringLiteral("%1/%2").arg(notesGroup, key), fieldsOf(note));
    m_notes.insert(key, note);
    emit changed();
}

void Notes::forget(const QString &key)
{
    if (!m_notes.remove(key))
        return;
    QSettings().remove(QStringLiteral("%1/%2").arg(notesGroup, key));
    emit changed();
}

}
