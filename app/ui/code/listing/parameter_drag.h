#pragma once

#include "app/model/session/run_editor.h"

#include <QObject>

#include <optional>

namespace app {

class ListingEditor;

/// Changes the parameters that a learner drags in an editor of code. A drag is undone as one edit, as that of a number is.
class ParameterDrag : public QObject
{
    Q_OBJECT

public:
    /// All arguments must outlive it. `editor` owns it.
    ParameterDrag(ListingEditor &editor, const OpenRun &run, RunEditor &changes);

    /// Tells the editor which words are parameters of the open step.
    void offer();

private:
    struct Drag
    {
        QString parameter;
        double from = 0.0;
    };

    void take(const QString &id);
    void drag(int pixels, bool fine);
    void leave(bool keep);

    ListingEditor &m_editor;
    const OpenRun &m_run;
    RunEditor &m_changes;
    std::optional<Drag> m_drag;
};

}
