// What a learner did, undone and done again.

#include "app/model/same_run.h"
#include "app/model/sentences.h"
#include "app/model/session.h"
#include "sim/base/error.h"

#include <algorithm>

namespace app {

/// A run is nothing but its script: with the script it had before, every frame has the bits it had before.
class Session::RunChange : public QUndoCommand
{
public:
    RunChange(Session &session, const Deed &deed, Stand before)
        : QUndoCommand(deed.what), m_session(session), m_deed(deed), m_number(session.m_gesture),
          m_before(std::move(before)), m_after(session.stand())
    {
        setObsolete(changedNothing());
    }

    int id() const override { return 1; }

    bool mergeWith(const QUndoCommand *command) override
    {
        const auto &next = static_cast<const RunChange &>(*command);
        if (m_deed.gesture.isEmpty() || next.m_deed.gesture != m_deed.gesture || next.m_number != m_number)
            return false;
        m_after = next.m_after;
        setObsolete(changedNothing());
        return true;
    }

    void undo() override
    {
        m_session.restore(m_before, tr("undone: %1").arg(m_deed.what), Leaves::ifItWentOn);
    }

    void redo() override
    {
        if (m_isDone)
            m_session.restore(m_after, {}, Leaves::never);
        m_isDone = true; // by whoever keeps it
    }

private:
    bool changedNothing() const
    {
        return sameScript(*m_before.script, *m_after.script) &&
               m_before.branches.all() == m_after.branches.all();
    }

    Session &m_session;
    Deed m_deed;
    int m_number; ///< of its gesture
    Stand m_before;
    Stand m_after;
    bool m_isDone = false;
};

void Session::remember(const Deed &deed, Stand before)
{
    m_deeds.push(new RunChange(*this, deed, std::move(before)));
}

bool Session::opensAnew(const sim::Script &script) const
{
    const std::vector<lessons::Parameter> &all = step().parameters;
    return std::any_of(all.begin(), all.end(), [&](const lessons::Parameter &one) {
        const std::string id = one.id.toStdString();
        const sim::Values &now = m_timeline->script().values;
        return one.restartsRun && script.values.has(id) && now.has(id) && script.values[id] != now[id];
    });
}

void Session::restore(const Stand &to, const QString &left, Leaves leaves)
{
    lookNoMore();
    const Stand before = stand();
    if (sameScript(*to.script, *before.script)) {
        restoreBranches(to.branches);
        return;
    }
    const std::int64_t shared = lastShared(*to.script, *before.script);
    Branch run = leftRun(before, m_timeline->computed(), left);
    Branches branches = to.branches;
    if (leaves == Leaves::always || (leaves == Leaves::ifItWentOn && run.end > shared))
        branches.add(std::move(run));
    if (opensAnew(*to.script)) {
        pause();
        start(*to.script, {}, std::move(branches));
        return;
    }
    m_holding = false;
    m_keys = {};
    m_pointerDown.reset();
    m_goingTo.reset();
    const sim::Cursor at = m_timeline->cursor();
    bool forked = false;
    try {
        forked = replaceRun(*to.script);
    } catch (const sim::Error &error) {
        emit said(sentenceFor(error));
        return;
    }
    m_branches = std::move(branches);
    m_coming.reset();
    const Branch *branch = m_branches.find(*before.script);
    const int wasRun = branch ? branch->id : 0;
    m_beside = forked ? wasRun : 0;
    hideWhatIsGone();
    runIsAnother();
    goOnAt(at);
    if (wasRun)
        showBeside(wasRun);
}

void Session::goOnAt(sim::Cursor at)
{
    goTo(at);
    if (!goingTo() || !isPlaying())
        return;
    m_player.pause(); // first the way there
    emit playingChanged();
}

void Session::restoreBranches(const Branches &branches)
{
    const Branches were = std::exchange(m_branches, branches);
    hideWhatIsGone();
    const std::vector<Branch> &all = m_branches.all();
    const auto isBack =
        std::find_if(all.begin(), all.end(), [&](const Branch &one) { return !were.find(one.id); });
    if (!beside() && isBack != all.end())
        showBeside(isBack->id);
    emit runChanged();
    emit moved();
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
    emit said(tr("Redone: %1.").arg(what));
}

}
