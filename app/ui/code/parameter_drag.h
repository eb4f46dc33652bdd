#pragma once

#include "app/model/session/run_editor.h"

#include <optional>

namespace app {

/// Changes a parameter while the learner drags it in a view of code. A drag is undone as one edit.
class ParameterDrag
{
public:
    /// Both arguments must outlive it.
    ParameterDrag(const OpenRun &run, RunEditor &changes) : m_run(run), m_changes(changes) {}

    /// Returns the ids of the parameters of the open step that can be dragged. One that restarts the run is typed, because a
    /// drag would restart the run at every value.
    QStringList parameters() const;

    /// Starts to drag a parameter of the open step.
    void take(const QString &id);

    /// Sets the parameter for the way that the mouse has gone since take(). Returns whether the parameter can be dragged.
    bool drag(int pixels, bool fine);

    /// Starts a new undo step for the next edits.
    void endGesture() { m_changes.endGesture(); }

    /// Ends the drag, and takes it back unless `keep`. Returns whether there was one.
    bool leave(bool keep);

private:
    struct Drag
    {
        QString parameter;
        double from = 0.0;
    };

    const OpenRun &m_run;
    RunEditor &m_changes;
    std::optional<Drag> m_drag;
};

}
