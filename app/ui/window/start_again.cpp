// Starting again: with the step that was open last, and at once where a choice needs a new start.

#include "app/ui/window/experiment_files.h"
#include "app/ui/window/kept_offer.h"
#include "app/ui/window/main_window.h"
#include "app/ui/window/notice.h"

#include <QSettings>

namespace app {

namespace {

constexpr const char *lessonKey = "learn/lesson";
constexpr const char *stepKey = "learn/step";

}

void MainWindow::rememberStep()
{
    if (m_session.isWorkshop())
        return; // one goes there from a step
    QSettings().setValue(lessonKey, m_session.lesson().id);
    QSettings().setValue(stepKey, m_session.step().id);
}

void MainWindow::openLast()
{
    const QSettings settings;
    const LessonEntry *lesson = m_session.library().lesson(settings.value(lessonKey).toString());
    if (lesson && lesson->step(settings.value(stepKey).toString()))
        m_session.openStep(lesson->id, settings.value(stepKey).toString());
}

void MainWindow::offerNewStart(const QString &sentence)
{
    m_notice->ask(sentence, {{tr("Start again now"),
                              tr("Closes the window and opens it again with this scene. Undo begins anew."),
                              [this] { startAgain(); }}});
}

void MainWindow::startAgain()
{
    const sim::Timeline &timeline = m_session.timeline();
    m_leaves = Left{m_session.lesson().id, m_session.step().id, m_files->document().path(),
                    timeline.at().frame,   timeline.computed(), m_mode};
    if (!close())
        m_leaves.reset(); // there is something to save first
}

void MainWindow::goOn(const Left &from)
{
    m_session.openStep(from.lesson, from.step);
    setMode(from.mode);
    if (!from.file.isEmpty())
        openFile(from.file);
    m_session.goTo({from.frame, 0});
    m_kept->goOnWith(from);
}

}
