#pragma once

#include "app/model/files/autosave.h"
#include "app/ui/theme/theme.h"

#include <QObject>
#include <QPointer>

#include <memory>
#include <vector>

namespace app {

class ExperimentFiles;
class RecoveryList;
class Notice;

/// Autosaves unsaved scenes, and offers the ones that earlier program starts left. It offers them in a notice
/// at the start and when a learner opens a sandbox, and at any time in a list.
class RecoveryPrompt : public QObject
{
    Q_OBJECT

public:
    /// All arguments must outlive it.
    RecoveryPrompt(const OpenRun &run, Playback &playback, const ComparisonRuns &comparisons,
                   ExperimentFiles &files, Notice &notice, const Theme &theme);

    /// Starts to autosave in `folder`, within `within` ms of a change, and offers the scenes left there
    /// by earlier starts. Runs that are open in this session already, handed over by an earlier window, are
    /// not offered.
    void autosaveIn(const QString &folder, int within);
    /// Shows all scenes left by earlier starts, or says that there are none.
    void showList();

private:
    void offer();
    /// Offers the autosaved scene of the open step once, if the step is a sandbox.
    void offerBuilt();
    void askAbout(const RecoveredScene &scene);
    void askAboutAll(const std::vector<RecoveredScene> &scenes);
    std::vector<RecoveredScene> installed() const;
    /// Returns whether the autosaved run is open in this window.
    bool isOpen(const RecoveredScene &scene) const;
    void forgetWhatIsOpen();
    void recover(const RecoveredScene &scene);
    void erase(const RecoveredScene &scene);
    /// Opens the scene and goes to the end of its run.
    void open(const RecoveredScene &scene);
    void drop(const RecoveredScene &scene);

    const OpenRun &m_run;
    Playback &m_playback;
    const ComparisonRuns &m_comparisons;
    ExperimentFiles &m_files;
    Notice &m_notice;
    const Theme &m_theme;
    std::unique_ptr<Autosave> m_autosave; ///< null: autosave is off
    std::vector<RecoveredScene> m_scenes; ///< from earlier starts, neither opened nor deleted yet
    QPointer<RecoveryList> m_list;
    bool m_hasOfferedBuilt = false;
    bool m_isOpening = false; ///< while an autosaved scene is being opened, it is not offered
};

}
