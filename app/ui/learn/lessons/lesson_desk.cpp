#include "app/ui/learn/lessons/lesson_desk.h"

#include "app/model/files/document.h"
#include "app/model/files/recent_files.h"
#include "app/model/lesson_folders/lesson_writer.h"
#include "app/model/lesson_folders/your_lessons.h"
#include "app/model/text/quoting.h"
#include "app/ui/actions/command_list.h"
#include "app/ui/dialogs/ask_file.h"
#include "app/ui/dialogs/notice.h"
#include "app/ui/dialogs/report_errors.h"

#include <QDesktopServices>
#include <QUrl>

namespace app {

LessonDesk::LessonDesk(Session &session, Document &document, CommandList &list, Notice &notice,
                       QWidget &window)
    : QObject(&window), m_session(session), m_document(document),
      m_begin(*list.add(tr("New &lesson from this scene…"), {QKeySequence("Ctrl+Shift+T")},
                        KeyGroup::experiments)),
      m_forget(*list.add(tr("Re&move this lesson from the list"), {QKeySequence("Ctrl+Shift+Del")},
                         KeyGroup::experiments)),
      m_notice(notice), m_window(window)
{
    m_begin.setHelp(tr("Write a small lesson with this scene into a folder, to go on with an editor"));
    m_forget.setHelp(tr("Take the open lesson out of your lessons; its files stay where they are"));
    connect(&m_begin, &QAction::triggered, this, &LessonDesk::askNew);
    connect(&m_forget, &QAction::triggered, this, &LessonDesk::removeOpen);
    session.onChange(ChangeKind::step, this, &LessonDesk::follow);
    follow();
}

void LessonDesk::setLessons(YourLessons &lessons)
{
    m_lessons = &lessons;
    connect(&lessons, &YourLessons::changed, &m_session, &Session::announceTexts);
    connect(&lessons, &YourLessons::aboutToReplace, this, &LessonDesk::leave);
    connect(&lessons, &YourLessons::replaced, this, &LessonDesk::comeBack);
    connect(&lessons, &YourLessons::mistakeChanged, &m_notice, &Notice::showMessage);
    const QString sentence = lessons.mistake().isEmpty() ? lessons.farewell() : lessons.mistake();
    if (!sentence.isEmpty())
        m_notice.showMessage(sentence);
    follow();
}

void LessonDesk::follow()
{
    m_begin.setObstacle(m_lessons ? QString() : tr("There is no place for lessons of your own"));
    m_forget.setObstacle(m_lessons && !m_session.lesson().source.isEmpty()
                             ? QString()
                             : tr("The open lesson is not one of yours"));
}

void LessonDesk::open(const QString &path)
{
    if (!m_lessons) {
        m_notice.showMessage(m_begin.obstacle());
        return;
    }
    QString source;
    const bool isOpen = attempt(m_notice, tr("Could not open the lesson: %1"), [&] {
        const LessonEntry &lesson = m_lessons->open(path);
        m_session.openStep(lesson.id, lesson.steps.front().id);
        source = lesson.source;
    });
    if (!isOpen)
        return;
    m_notice.showMessage({});
    addRecentFile(source);
}

void LessonDesk::askNew()
{
    const QString folder = askWhereToSave(&m_window, tr("Choose a new folder for the lesson"),
                                          QStringLiteral("my_lesson"), tr("Folder of a lesson (*)"));
    if (folder.isEmpty() || !attempt(m_notice, tr("Could not begin a lesson: %1"), [&] {
            writeLesson(m_session.experiment(), folder, m_session.library());
        }))
        return;
    open(folder);
    const bool isShown = QDesktopServices::openUrl(QUrl::fromLocalFile(folder));
    m_session.showMessage(
        (isShown
             ? tr("The lesson is in %1. Write its texts in first.md: each time you save, they change here.")
             : tr("The lesson is in %1. Open its first.md in an editor: each time you save, it changes "
                  "here."))
            .arg(shownPath(folder)));
}

void LessonDesk::removeOpen()
{
    const QString source = m_session.lesson().source;
    const LessonEntry &first = m_session.library().lessons.front();
    m_session.openStep(first.id, first.steps.front().id);
    m_lessons->remove(source);
    m_notice.ask(tr("%1 is no longer in the list. Its files are still there.").arg(shownPath(source)),
                 {{tr("Put it back"), tr("Opens the lesson again"), [this, source] { open(source); }}});
}

void LessonDesk::leave(const LessonEntry &lesson)
{
    const bool isOpen = &lesson == &m_session.lesson();
    m_left = Left{m_session.lesson().id, m_session.step().id, m_session.timeline().cursor(), isOpen};
    const LessonEntry &other = m_session.library().lessons.front();
    if (isOpen)
        m_session.openStep(other.id, other.steps.front().id);
}

void LessonDesk::comeBack(const LessonEntry &lesson, const QStringList &others)
{
    const Left left = m_left.value_or(Left{});
    m_left.reset();
    attempt(m_notice, tr("Could not show the lesson: %1"), [&] {
        for (const QString &id : others) {
            // A step that was open before would have its old scene again.
            if (m_session.experimentOf(lesson.id, id))
                m_document.open(
                    Experiment{.lesson = lesson.id, .step = id, .script = lesson.step(id)->script()});
        }
    });
    if (!left.isReplaced) {
        if (m_session.lesson().id != left.lesson || m_session.step().id != left.step)
            m_session.openStep(left.lesson, left.step);
        return;
    }
    const lessons::Step *same = lesson.step(left.step);
    m_session.openStep(lesson.id, same ? same->id : lesson.steps.front().id);
    if (same)
        m_session.playback().goTo(others.contains(same->id) ? sim::Cursor{left.at.frame, 0} : left.at);
}

}
