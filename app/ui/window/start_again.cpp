// Starting again: with the step that was open last, and at once where a choice needs a new window.

#include "app/ui/film/film_dialog.h"
#include "app/ui/window/experiment_files.h"
#include "app/ui/window/main_window.h"
#include "app/ui/window/notice.h"

#include <QAction>
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

void MainWindow::startAgainFor(const QString &sentence)
{
    if (!m_film || !m_film->isMaking()) {
        startAgain();
        return;
    }
    m_notice->ask(
        tr("%1 A film is being made.").arg(sentence),
        {{tr("Start again now"), tr("Stops the film; everything else stays"), [this] { startAgain(); }}});
}

void MainWindow::startAgain()
{
    const bool isPlaying = m_session.isPlaying();
    const auto goal = m_session.goingTo();
    m_session.letGo();
    m_session.letUp();
    m_session.endGlance();
    m_session.stopGoing(); // no time passes between two windows
    m_leaves = Left{m_files->document().saved(), m_mode, goal, isPlaying, m_focusAction->isChecked()};
    close();
}

void MainWindow::goOn(const Left &from)
{
    const QSettings settings;
    m_trip.comeBackTo(settings.value(lessonKey).toString(), settings.value(stepKey).toString());
    m_files->document().setSaved(from.saved);
    arrangeFor(from.mode); // the session is there already
    fitParameters();
    m_focusAction->setChecked(from.isSceneOnly);
    if (from.goal)
        m_session.goTo({*from.goal, 0});
    if (from.isPlaying)
        m_session.play();
}

}
