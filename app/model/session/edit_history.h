#pragma once

#include "app/model/run/branches.h"
#include "app/model/session/edit_label.h"

#include <QUndoStack>

#include <functional>
#include <memory>
#include <optional>
#include <utility>

namespace app {

/// The run in use with its branches: everything that an edit changes. A run is nothing but its script: with the same
/// script, every frame has the same bits again.
struct RunSnapshot
{
    std::shared_ptr<const sim::Script> script;
    Branches branches;
    std::optional<QString> draft =
        {}; ///< the text of the listing that does not compute the run; see OpenRun::draft()
};

/// When a replaced run becomes a branch.
enum class KeepRun {
    ifItWentOn, ///< if it has frames after the last one that both runs share
    always,
    never, ///< it is a branch already
};

/// The edits of the open step that can be undone.
class EditHistory
{
public:
    /// Puts a snapshot in place of the run in use, which becomes a branch called `replacedName`.
    using Restore =
        std::function<void(const RunSnapshot &to, const QString &replacedName, KeepRun keepReplaced)>;

    EditHistory();

    void setRestore(Restore restore) { m_restore = std::move(restore); }
    /// Adds an edit that has been made already. An edit that changed nothing is not added.
    void add(const EditLabel &label, RunSnapshot before, RunSnapshot after);
    /// Returns whether an edit with this gesture would be merged with the last one.
    bool continues(const QString &gesture) const;
    /// The next edit is not merged with the last one, even if both belong to the same kind of gesture.
    void endGesture() { ++m_gesture; }
    QUndoStack &stack() { return m_stack; }
    const QUndoStack &stack() const { return m_stack; }

private:
    class Edit;

    QUndoStack m_stack;
    Restore m_restore;
    int m_gesture = 0; ///< number of the current gesture
};

}
