// What is kept against a crash, and offered at the next start.

#include "app/model/document.h"
#include "app/model/scene_keeper.h"
#include "app/ui/window/main_window.h"
#include "app/ui/window/notice.h"

#include <QLocale>

#include <algorithm>
#include <limits>

namespace app {

namespace {

/// "12:41", or with the day if that is another.
QString timeOf(const QDateTime &when)
{
    const QString time = when.time().toString("HH:mm");
    if (when.date() == QDate::currentDate())
        return time;
    return QLocale().toString(when.date(), QLocale::ShortFormat) + ' ' + time;
}

}

void MainWindow::keepScenesIn(const QString &folder, int within)
{
    m_keptScenes = keptScenes(folder);
    m_keeper = std::make_unique<SceneKeeper>(m_session, *m_document, folder, within);
    connect(m_keeper.get(), &SceneKeeper::failed, m_notice, &Notice::say);
    if (openWhatWasLeft())
        return;
    if (m_notice->sentence().isEmpty()) // else there is something to read first; they stay for the next start
        offerKept();
}

void MainWindow::offerKept()
{
    if (m_keptScenes.empty())
        return;
    const KeptScene scene = m_keptScenes.front();
    m_keptScenes.erase(m_keptScenes.begin());
    const LessonEntry *lesson = m_session.library().lesson(scene.name.lesson);
    const lessons::Step *step = lesson ? lesson->step(scene.name.step) : nullptr;
    if (!step) { // of a lesson that is not installed now: it may come back
        offerKept();
        return;
    }
    const QString what = tr("“%1: %2”").arg(lesson->title, step->title);
    const QString sentence =
        scene.wasEnded ? tr("Springstep was ended by something else. Your scene of %1 from %2 is here.")
                       : tr("Your scene of %1 from %2 was not saved. It is here.");
    const auto open = [this, scene] {
        unlessLost([this, scene] { openKept(scene, std::numeric_limits<std::int64_t>::max()); });
    };
    const auto drop = [this, scene] {
        forget(scene);
        offerKept();
    };
    m_notice->ask(sentence.arg(what, timeOf(scene.when)),
                  {{tr("Open it"), tr("Go on with it"), open},
                   {tr("Forget it"), tr("Delete it; it will not be offered again"), drop}});
}

void MainWindow::openKept(const KeptScene &scene, std::int64_t upTo)
{
    std::int64_t frames = 0;
    const bool isOpen = opens([&] {
        const Experiment experiment = readExperiment(scene.file, m_session.library());
        frames = experiment.frames;
        m_document->open(experiment);
    });
    if (!isOpen)
        return;
    m_session.goTo({std::min(frames, upTo), 0});
    m_keeper->keepNow(); // it is never nowhere
    forget(scene);
    offerKept();
}

}
