#pragma once

#include "app/model/session/edit_history.h"
#include "app/model/session/open_run.h"

#include <QElapsedTimer>
#include <QObject>

#include <optional>

namespace app {

/// What became of a run that an edit replaced.
enum class Replaced {
    forgotten,  ///< it had no frames besides those that it shares with the new run
    branch,     ///< it becomes a branch
    comparison, ///< it becomes a branch, and is the timeline's comparison already
};

/// The branches of the open step, and the branch that is shown as the run's ghost.
class ComparisonRuns : public QObject
{
    Q_OBJECT

public:
    ComparisonRuns(OpenRun &run, EditHistory &history) : m_run(run), m_history(history) {}

    const Branches &branches() const { return m_branches; }
    /// Returns the branch that is shown as the ghost, or will be when it is computed; null if there is none.
    const Branch *shown() const { return m_branches.find(m_shown); }
    /// Returns whether that branch is still being computed.
    bool isComputing() const { return m_coming.has_value(); }
    /// Returns the name of the ghost, for example "before: damp 0.85"; empty if there is none.
    QString comparisonName() const
    {
        return m_run.timeline().comparison() && shown() ? shown()->name : QString();
    }
    /// Shows a branch as the ghost. It is computed in slices, so that the window never waits. If no branch has this
    /// id, the ghost disappears.
    void show(int branch);
    /// Stops computing the branch that is to be shown.
    void cancel();

    // Edits that can be undone
    void keep(int branch, bool kept);
    void rename(int branch, const QString &name);
    void remove(int branch);
    /// Deletes the branch that is shown as the ghost.
    void removeShown() { remove(m_shown); }

    // For edits of the run
    RunSnapshot snapshot() const;
    /// Replaces all branches. No ghost is shown any longer.
    void reset(Branches branches);
    /// Records that the edit `label` replaced the run of `before`, which was computed up to frame `computed`.
    void recordEdit(const EditLabel &label, const RunSnapshot &before, std::int64_t computed,
                    Replaced replaced);
    /// Returns the run of `before` as a new branch. It is called `name`, unless the learner has named it.
    Branch branchOf(const RunSnapshot &before, std::int64_t computed, const QString &name);
    /// Shows the newest branch.
    void showNewest() { show(m_lastId); }
    /// Removes the oldest branches that are not kept, if there are too many.
    void limit() { m_branches.limit(); }
    /// Replaces all branches. The timeline's comparison, if there is one, is the run of `comparison`.
    void restore(Branches branches, const sim::Script *comparison);
    /// As restore(), for the same run. A branch that is back is shown, if no other one is.
    void restoreBranches(const Branches &branches);
    /// Numbers the branches of a file so that no id is used twice.
    Branches renumbered(const Branches &branches) { return branches.renumbered(m_lastId); }

private:
    void change(const QString &what, const std::function<void(Branches &)> &edit);
    void computeSlice();
    /// Removes the ghost if its branch does not exist any longer.
    void hideRemoved();

    OpenRun &m_run;
    EditHistory &m_history;
    Branches m_branches;
    int m_lastId = 0;
    int m_shown = 0;                    ///< id of the branch that is the ghost, or will be
    std::optional<sim::Track> m_coming; ///< its run, while that is computed towards the cursor
    bool m_isSliceDue = false;          ///< whether the next slice of computing is scheduled
    QElapsedTimer m_sinceReport;        ///< of its progress
};

}
