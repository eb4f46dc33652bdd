#include "app/ui/window/kept_offer.h"

#include "app/model/refusal.h"
#include "app/model/same_run.h"
#include "app/ui/panels/dialog_place.h"
#include "app/ui/window/experiment_files.h"
#include "app/ui/window/kept_list.h"
#include "app/ui/window/notice.h"
#include "sim/base/error.h"

#include <QScopedValueRollback>

#include <algorithm>
#include <limits>

namespace app {

namespace {

bool isOneFile(const KeptScene &a, const KeptScene &b)
{
    return a.file == b.file;
}

}

KeptOffer::KeptOffer(Session &session, ExperimentFiles &files, Notice &notice, const Theme &theme)
    : m_session(session), m_files(files), m_notice(notice), m_theme(theme)
{
}

void KeptOffer::keepIn(const QString &folder, int within)
{
    m_scenes = keptScenes(folder);
    m_keeper = std::make_unique<SceneKeeper>(m_session, m_files.document(), folder, within);
    connect(m_keeper.get(), &SceneKeeper::failed, &m_notice, &Notice::say);
    connect(&m_session, &Session::stepOpened, this, &KeptOffer::offerBuilt, Qt::UniqueConnection);
    forgetWhatIsOpen();
    if (m_notice.sentence().isEmpty()) // else there is something to read first; they stay in the list
        offer();
}

std::vector<KeptScene> KeptOffer::installed() const
{
    std::vector<KeptScene> all;
    std::copy_if(m_scenes.begin(), m_scenes.end(), std::back_inserter(all), [this](const KeptScene &one) {
        const LessonEntry *lesson = m_session.library().lesson(one.name.lesson);
        return lesson && lesson->step(one.name.step); // a lesson that is not installed now may come back
    });
    return all;
}

void KeptOffer::offer()
{
    const std::vector<KeptScene> scenes = installed();
    if (scenes.size() == 1)
        askAbout(scenes.front());
    else if (!scenes.empty())
        askAboutAll(scenes);
}

void KeptOffer::offerBuilt()
{
    if (!m_session.isWorkshop() || m_isOpening || m_hasOfferedBuilt || !m_notice.sentence().isEmpty())
        return;
    const StepName name = m_files.document().name();
    const auto found = std::find_if(m_scenes.begin(), m_scenes.end(),
                                    [&](const KeptScene &one) { return one.name == name; });
    if (found == m_scenes.end())
        return;
    m_hasOfferedBuilt = true;
    askAbout(KeptScene(*found));
}

void KeptOffer::askAbout(const KeptScene &scene)
{
    const LessonEntry *lesson = m_session.library().lesson(scene.name.lesson);
    const QString what = tr("“%1: %2”").arg(lesson->title, lesson->step(scene.name.step)->title);
    const QString sentence =
        scene.wasEnded ? tr("Springstep was ended by something else. Your scene of %1 from %2 is here.")
                       : tr("Your scene of %1 from %2 was not saved. It is here.");
    m_notice.ask(
        sentence.arg(what, timeOf(scene.when)),
        {{tr("Open it"), tr("Go on with it"), [this, scene] { recover(scene); }},
         {tr("Forget it"), tr("Delete it; it will not be offered again"), [this, scene] { erase(scene); }}});
}

void KeptOffer::askAboutAll(const std::vector<KeptScene> &scenes)
{
    const bool wasEnded =
        std::any_of(scenes.begin(), scenes.end(), [](const KeptScene &one) { return one.wasEnded; });
    const QString sentence =
        wasEnded ? tr("Springstep was ended by something else. %1 scenes that were not saved are here.")
                 : tr("%1 scenes that were not saved are here.");
    m_notice.ask(sentence.arg(scenes.size()),
                 {{tr("Show them"), tr("Shows a list, from which each can be recovered or deleted"),
                   [this] { showList(); }}});
}

void KeptOffer::showList()
{
    if (m_scenes.empty()) {
        emit m_session.said(tr("There is no scene to recover."));
        return;
    }
    if (!m_list) {
        m_list = new KeptList(m_session.library(), m_theme, m_notice.window());
        connect(m_list, &KeptList::recovers, this, &KeptOffer::recover);
        connect(m_list, &KeptList::deletes, this, &KeptOffer::erase);
    }
    m_notice.say({});
    placeOverParent(*m_list);
    m_list->show();
    m_list->raise();
    m_list->activateWindow();
    m_list->list(m_scenes);
}

void KeptOffer::recover(const KeptScene &scene)
{
    m_files.unlessLost([this, scene] { open(scene, std::numeric_limits<std::int64_t>::max()); });
}

void KeptOffer::erase(const KeptScene &scene)
{
    forget(scene);
    drop(scene);
}

void KeptOffer::drop(const KeptScene &scene)
{
    std::erase_if(m_scenes, [&](const KeptScene &one) { return isOneFile(one, scene); });
    if (!m_list || !m_list->isVisible())
        return;
    if (m_scenes.empty())
        m_list->close();
    else
        m_list->list(m_scenes);
}

bool KeptOffer::isOpen(const KeptScene &scene) const
{
    const Document &document = m_files.document();
    if (scene.wasEnded || !document.isChanged(scene.name))
        return false;
    try {
        const Experiment kept = readExperiment(scene.file, m_session.library());
        const std::optional<Experiment> mine = document.experimentOf(scene.name);
        return mine && sameScript(kept.script, mine->script) && sameMarked(kept.branches, mine->branches);
    } catch (const Refusal &) {
        return false;
    } catch (const sim::Error &) {
        return false;
    }
}

void KeptOffer::forgetWhatIsOpen()
{
    const auto open = std::stable_partition(m_scenes.begin(), m_scenes.end(),
                                            [this](const KeptScene &scene) { return !isOpen(scene); });
    std::for_each(open, m_scenes.end(), [this](const KeptScene &scene) {
        m_keeper->takeOver(scene.name, scene.when); // it is never nowhere
        forget(scene);
    });
    m_scenes.erase(open, m_scenes.end());
}

void KeptOffer::open(const KeptScene &scene, std::int64_t upTo)
{
    const QScopedValueRollback opening(m_isOpening, true);
    std::int64_t frames = 0;
    const bool isOpen = m_files.opens([&] {
        const Experiment experiment = readExperiment(scene.file, m_session.library());
        frames = experiment.frames;
        m_files.document().open(experiment);
    });
    if (!isOpen)
        return;
    m_session.goTo({std::min(frames, upTo), 0});
    m_keeper->takeOver(scene.name, scene.when); // it is never nowhere
    forget(scene);
    drop(scene);
}

}
