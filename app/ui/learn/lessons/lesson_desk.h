#pragma once

#include "app/model/session/session.h"

#include <QObject>

#include <optional>

class QWidget;

namespace app {

class Command;
class CommandList;
class Document;
class Notice;
class YourLessons;

/// The lessons without C++ of a window: opens them, begins new ones, and shows a change of their files at the same step and
/// frame. Their mistakes are shown as notices.
class LessonDesk : public QObject
{
    Q_OBJECT

public:
    /// Adds its commands to `list`. Dialogs belong to `window`, which owns this object. All arguments must outlive it. There are
    /// no lessons until setLessons().
    LessonDesk(Session &session, Document &document, CommandList &list, Notice &notice, QWidget &window);

    /// The command that begins a new lesson with the open scene.
    Command &begin() const { return m_begin; }
    /// The command that takes the open lesson out of the list.
    Command &forget() const { return m_forget; }

    /// `lessons` must outlive this object.
    void setLessons(YourLessons &lessons);
    /// Opens the first step of a lesson. If it has a mistake, that is shown and nothing changes.
    void open(const QString &path);
    /// Asks for a folder, writes a lesson with the open scene there, and opens it here and in the desktop's editor.
    void askNew();
    /// Takes the open lesson out of the list and opens the first one. Its files stay, and it can be put back.
    void removeOpen();

private:
    /// The step that was open before a lesson is replaced.
    struct Left
    {
        QString lesson;
        QString step;
        sim::Cursor at;
        bool isReplaced = false;
    };

    void leave(const LessonEntry &lesson);
    void comeBack(const LessonEntry &lesson, const QStringList &others);
    void follow();

    Session &m_session;
    Document &m_document;
    Command &m_begin;
    Command &m_forget;
    Notice &m_notice;
    QWidget &m_window;
    YourLessons *m_lessons = nullptr;
    std::optional<Left> m_left;
};

}
