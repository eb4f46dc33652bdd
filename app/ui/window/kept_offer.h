#pragma once

#include "app/model/scene_keeper.h"
#include "app/ui/theme/theme.h"

#include <QObject>
#include <QPointer>

#include <memory>
#include <vector>

namespace app {

class ExperimentFiles;
class KeptList;
class Notice;

/// Keeps what is not saved, and offers what programs before have left: in a notice at the start and where a learner
/// begins to build, and at any time as a list.
class KeptOffer : public QObject
{
    Q_OBJECT

public:
    /// All must outlive it.
    KeptOffer(Session &session, ExperimentFiles &files, Notice &notice, const Theme &theme);

    /// Keeps in `folder` from now on, `within` ms, and offers what is there of programs before. Runs that are open in this
    /// session, as a window before has handed it over, are not offered.
    void keepIn(const QString &folder, int within);
    /// Shows all that is there of programs before, or says that nothing is.
    void showList();

private:
    void offer();
    /// Offers the scene that was kept of the open step, where that is one that is built. Once.
    void offerBuilt();
    void askAbout(const KeptScene &scene);
    void askAboutAll(const std::vector<KeptScene> &scenes);
    std::vector<KeptScene> installed() const;
    /// Whether the run that was kept is open here.
    bool isOpen(const KeptScene &scene) const;
    void forgetWhatIsOpen();
    void recover(const KeptScene &scene);
    void erase(const KeptScene &scene);
    /// Opens it, and goes to the end of its run, or to frame `upTo` if that is before it.
    void open(const KeptScene &scene, std::int64_t upTo);
    void drop(const KeptScene &scene);

    Session &m_session;
    ExperimentFiles &m_files;
    Notice &m_notice;
    const Theme &m_theme;
    std::unique_ptr<SceneKeeper> m_keeper; ///< null: nothing is kept
    std::vector<KeptScene> m_scenes;       ///< by programs before, and neither opened nor deleted yet
    QPointer<KeptList> m_list;
    bool m_hasOfferedBuilt = false;
    bool m_isOpening = false; ///< a kept scene: it is not offered meanwhile
};

}
