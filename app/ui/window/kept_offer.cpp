#include "app/ui/window/kept_offer.h"

#include "app/ui/window/experiment_files.h"
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

KeptOffer::KeptOffer(Session &session, ExperimentFiles &files, Notice &notice)
    : m_session(session), m_files(files), m_notice(notice)
{
}

void KeptOffer::keepIn(const QString &folder, int within)
{
    m_scenes = keptScenes(folder);
    m_keeper = std::make_unique<SceneKeeper>(m_session, m_files.document(), folder, within);
    connect(m_keeper.get(), &SceneKeeper::failed, &m_notice, &Notice::say);
    if (openWhatWasLeft())
        return;
    if (m_notice.sentence().isEmpty()) // else there is something to read first; they stay for the next start
        offer();
}

void KeptOffer::offer()
{
    if (m_scenes.empty())
        return;
    const KeptScene scene = m_scenes.front();
    m_scenes.erase(m_scenes.begin());
    const LessonEntry *lesson = m_session.library().lesson(scene.name.lesson);
    const lessons::Step *step = lesson ? lesson->step(scene.name.step) : nullptr;
    if (!step) { // of a lesson that is not installed now: it may come back
        offer();
        return;
    }
    const QString what = tr("“%1: %2”").arg(lesson->title, step->title);
    const QString sentence =
        scene.wasEnded ? tr("Springstep was ended by something else. Your scene of %1 from %2 is here.")
                       : tr("Your scene of %1 from %2 was not saved. It is here.");
    const auto goOn = [this, scene] {
        m_files.unlessLost([this, scene] { open(scene, std::numeric_limits<std::int64_t>::max()); });
    };
    const auto drop = [this, scene] {
        forget(scene);
        offer();
    };
    m_notice.ask(sentence.arg(what, timeOf(scene.when)),
                 {{tr("Open it"), tr("Go on with it"), goOn},
                  {tr("Forget it"), tr("Delete it; it will not be offered again"), drop}});
}

bool KeptOffer::openWhatWasLeft()
{
    if (!m_from)
        return false;
    const auto mine = std::find_if(m_scenes.begin(), m_scenes.end(), [&](const KeptScene &scene) {
        return scene.name == m_files.document().name() && !scene.wasEnded;
    });
    if (mine == m_scenes.end())
        return false;
    const KeptScene scene = *mine;
    m_scenes.erase(mine);
    open(scene, m_from->computed);
    m_session.goTo({m_from->frame, 0});
    return true;
}

void KeptOffer::open(const KeptScene &scene, std::int64_t upTo)
{
    std::int64_t frames = 0;
    const bool isOpen = m_files.opens([&] {
        const Experiment experiment = readExperiment(scene.file, m_session.library());
        frames = experiment.frames;
        m_files.document().open(experiment);
    });
    if (!isOpen)
        return;
    m_session.goTo({std::min(frames, upTo), 0});
    m_keeper->keepNow(); // it is never nowhere
    forget(scene);
    offer();
}

}
