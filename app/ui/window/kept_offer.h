#pragma once

#include "app/model/scene_keeper.h"
#include "app/ui/window/left.h"

#include <QObject>

#include <memory>
#include <optional>
#include <vector>

namespace app {

class ExperimentFiles;
class Notice;

/// Keeps what is not saved, and offers what programs before have left, one after the other.
class KeptOffer : public QObject
{
    Q_OBJECT

public:
    /// All must outlive it.
    KeptOffer(Session &session, ExperimentFiles &files, Notice &notice);

    /// What a window before left of the open step is opened by keepIn() in place of being offered.
    void goOnWith(const Left &from) { m_from = from; }
    /// Keeps in `folder` from now on, `within` ms, and offers what is there of programs before.
    void keepIn(const QString &folder, int within);

private:
    void offer();
    /// Opens what the window before has left of the open step, when this one goes on with it. Returns whether it did.
    bool openWhatWasLeft();
    /// Opens it, and goes to the end of its run, or to frame `upTo` if that is before it.
    void open(const KeptScene &scene, std::int64_t upTo);

    Session &m_session;
    ExperimentFiles &m_files;
    Notice &m_notice;
    std::unique_ptr<SceneKeeper> m_keeper; ///< null: nothing is kept
    std::vector<KeptScene> m_scenes;       ///< by programs before, and not offered yet
    std::optional<Left> m_from;
};

}
