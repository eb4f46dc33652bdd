#include "app/ui/dialogs/recovery_prompt.h"

#include "app/model/run/same_run.h"
#include "app/model/text/user_error.h"
#include "app/ui/dialogs/dialog_place.h"
#include "app/ui/dialogs/notice.h"
#include "app/ui/dialogs/recovery_list.h"
#include "app/ui/window/experiment_files.h"
#include "sim/base/error.h"

#include <QScopedValueRollback>

#include <algorithm>

namespace app {

RecoveryPrompt::RecoveryPrompt(const OpenRun &run, Playback &playback, const ComparisonRuns &comparisons,
                               ExperimentFiles &files, Notice &notice, const Theme &theme)
    : m_run(run), m_playback(playback), m_comparisons(comparisons), m_files(files), m_notice(notice),
      m_theme(theme)
{
    m_run.onChange(ChangeKind::step, this, &RecoveryPrompt::offerBuilt);
}

void RecoveryPrompt::autosaveIn(const QString &folder, int within)
{
    m_scenes = recoveredScenes(folder);
    m_autosave = std::make_unique<Autosave>(m_run, m_comparisons, m_files.document(), folder, within);
    connect(m_autosave.get(), &Autosave::failed, &m_notice, &Notice::showMessage);
    forgetWhatIsOpen();
    if (m_notice.sentence().isEmpty()) // otherwise a message comes first; the scenes stay in the list
        offer();
}

std::vector<RecoveredScene> RecoveryPrompt::installed() const
{
    std::vector<RecoveredScene> all;
    std::copy_if(
        m_scenes.begin(), m_scenes.end(), std::back_inserter(all), [this](const RecoveredScene &one) {
            const LessonEntry *lesson = m_run.library().lesson(one.name.lesson);
            return lesson && lesson->step(one.name.step); // kept otherwise: the lesson may be installed again
        });
    return all;
}

void RecoveryPrompt::offer()
{
    const std::vector<RecoveredScene> scenes = installed();
    if (scenes.size() == 1)
        askAbout(scenes.front());
    else if (!scenes.empty())
        askAboutAll(scenes);
}

void RecoveryPrompt::offerBuilt()
{
    if (!m_run.isSandbox() || m_isOpening || m_hasOfferedBuilt || !m_notice.sentence().isEmpty())
        return;
    const StepName name = m_files.document().name();
    const auto found = std::find_if(m_scenes.begin(), m_scenes.end(),
                                    [&](const RecoveredScene &one) { return one.name == name; });
    if (found == m_scenes.end())
        return;
    m_hasOfferedBuilt = true;
    askAbout(RecoveredScene(*found));
}

void RecoveryPrompt::askAbout(const RecoveredScene &scene)
{
    const LessonEntry *lesson = m_run.library().lesson(scene.name.lesson);
    const QString what = tr("“%1: %2”").arg(lesson->title, lesson->step(scene.name.step)->title);
    const QString sentence =
        scene.wasEnded ? tr("Springstep did not close normally. Your scene of %1 from %2 can be recovered.")
                       : tr("Your scene of %1 from %2 was not saved. It can be recovered.");
    m_notice.ask(sentence.arg(what, timeOf(scene.when)),
                 {{tr("Recover"), tr("Continue with this scene"), [this, scene] { recover(scene); }},
                  {tr("Delete"), tr("Delete this scene for good"), [this, scene] { erase(scene); }}});
}

void RecoveryPrompt::askAboutAll(const std::vector<RecoveredScene> &scenes)
{
    // The latest comes first. Older ones can be left by a program that crashed before the last one closed normally.
    const QString sentence =
        scenes.front().wasEnded ? tr("Springstep did not close normally. %1 unsaved scenes can be recovered.")
                                : tr("%1 unsaved scenes can be recovered.");
    m_notice.ask(sentence.arg(scenes.size()),
                 {{tr("Show them"), tr("Shows a list, from which each can be recovered or deleted"),
                   [this] { showList(); }}});
}

void RecoveryPrompt::showList()
{
    if (m_scenes.empty()) {
        m_run.showMessage(tr("There is no scene to recover."));
        return;
    }
    if (!m_list) {
        m_list = new RecoveryList(m_run.library(), m_theme, m_notice.window());
        connect(m_list, &RecoveryList::recovers, this, &RecoveryPrompt::recover);
        connect(m_list, &RecoveryList::deletes, this, &RecoveryPrompt::erase);
    }
    m_notice.showMessage({});
    showInFront(*m_list);
    m_list->list(m_scenes);
}

void RecoveryPrompt::recover(const RecoveredScene &scene)
{
    m_files.unlessLost([this, scene] { open(scene); });
}

void RecoveryPrompt::erase(const RecoveredScene &scene)
{
    forget(scene);
    drop(scene);
}

void RecoveryPrompt::drop(const RecoveredScene &scene)
{
    std::erase_if(m_scenes, [&](const RecoveredScene &one) { return one.file == scene.file; });
    if (!m_list || !m_list->isVisible())
        return;
    if (m_scenes.empty())
        m_list->close();
    else
        m_list->list(m_scenes);
}

bool RecoveryPrompt::isOpen(const RecoveredScene &scene) const
{
    const Document &document = m_files.document();
    if (scene.wasEnded || !document.isChanged(scene.name))
        return false;
    try {
        const Experiment kept = readExperiment(scene.file, m_run.library());
        const std::optional<Experiment> mine = document.experimentOf(scene.name);
        return mine && sameScript(kept.script, mine->script) && sameMarked(kept.branches, mine->branches);
    } catch (const UserError &) {
        return false;
    } catch (const sim::Error &) {
        return false;
    }
}

void RecoveryPrompt::forgetWhatIsOpen()
{
    const auto open = std::stable_partition(m_scenes.begin(), m_scenes.end(),
                                            [this](const RecoveredScene &scene) { return !isOpen(scene); });
    std::for_each(open, m_scenes.end(), [this](const RecoveredScene &scene) {
        m_autosave->takeOver(scene.name, scene.when); // before forget(), so that one copy always exists
        forget(scene);
    });
    m_scenes.erase(open, m_scenes.end());
}

void RecoveryPrompt::open(const RecoveredScene &scene)
{
    const QScopedValueRollback opening(m_isOpening, true);
    std::int64_t frames = 0;
    const bool isOpen = m_files.opens([&] {
        const Experiment experiment = readExperiment(scene.file, m_run.library());
        frames = experiment.frames;
        m_files.document().open(experiment);
    });
    if (!isOpen)
        return;
    m_playback.goTo({frames, 0});
    m_autosave->takeOver(scene.name, scene.when); // before forget(), so that one copy always exists
    forget(scene);
    drop(scene);
}

}
