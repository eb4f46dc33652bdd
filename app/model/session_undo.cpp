// What a learner did, undone and done again.

#include "app/model/same_run.h"
#include "app/model/session.h"

#include <algorithm>

namespace app {

/// A run is nothing but its script: with the script it had before, every frame has the bits it had before.
class Session::RunChange : public QUndoCommand
{
public:
    RunChange(Session &session, const Deed &deed, sim::Script before)
        : QUndoCommand(deed.what), m_session(session), m_deed(deed), m_number(session.m_gesture),
          m_before(std::move(before)), m_after(session.m_timeline->script())
    {
        setObsolete(sameScript(m_before, m_after));
    }

    int id() const override { return 1; }

    bool mergeWith(const QUndoCommand *command) override
    {
        const auto &next = static_cast<const RunChange &>(*command);
        if (m_deed.gesture.isEmpty() || next.m_deed.gesture != m_deed.gesture || next.m_number != m_number)
            return false;
        m_after = next.m_after;
        setObsolete(sameScript(m_before, m_after));
        return true;
    }

    void undo() override { m_session.restore(m_before, tr("undone: %1").arg(m_deed.what)); }

    void redo() override
    {
        if (m_isDone)
            m_session.restore(m_after, tr("before: %1").arg(m_deed.before));
        m_isDone = true; // by whoever keeps it
    }

private:
    Session &m_session;
    Deed m_deed;
    int m_number; ///< of its gesture
    sim::Script m_before;
    sim::Script m_after;
    bool m_isDone = false;
};

void Session::remember(const Deed &deed, sim::Script before)
{
    m_deeds.push(new RunChange(*this, deed, std::move(before)));
}

void Session::restore(const sim::Script &script, const QString &ghost)
{
    const auto opens = [&](const lessons::Parameter &one) {
        const std::string id = one.id.toStdString();
        const sim::Values &now = m_timeline->script().values;
        return one.opens && script.values.has(id) && now.has(id) && script.values[id] != now[id];
    };
    const std::vector<lessons::Parameter> &all = step().parameters;
    if (std::any_of(all.begin(), all.end(), opens)) {
        pause();
        start(script, {});
        return;
    }
    m_holding = false;
    m_keys = {};
    m_pointerDown.reset();
    change(ghost, [&](sim::Timeline &timeline) { return timeline.replace(script); });
}

void Session::undo()
{
    letGo();
    letUp();
    endGesture();
    if (!m_deeds.canUndo())
        return;
    const QString what = m_deeds.undoText();
    m_deeds.undo();
    emit said(tr("Undone: %1.").arg(what));
}

void Session::redo()
{
    endGesture();
    if (!m_deeds.canRedo())
        return;
    const QString what = m_deeds.redoText();
    m_deeds.redo();
    emit said(tr("Done again: %1.").arg(what));
}

}
