#include "app/model/session/edit_history.h"

#include "app/model/run/same_run.h"

#include <QCoreApplication>

namespace app {

namespace {

constexpr int undoLimit = 100;

}

class EditHistory::Edit : public QUndoCommand
{
    Q_DECLARE_TR_FUNCTIONS(EditHistory)

public:
    Edit(EditHistory &history, const EditLabel &label, RunSnapshot before, RunSnapshot after)
        : QUndoCommand(label.what), m_history(history), m_label(label), m_gesture(history.m_gesture),
          m_before(std::move(before)), m_after(std::move(after))
    {
        setObsolete(changedNothing());
    }

    int id() const override { return 1; }
    bool isOf(const QString &gesture, int number) const
    {
        return !gesture.isEmpty() && m_label.gesture == gesture && m_gesture == number;
    }

    bool mergeWith(const QUndoCommand *command) override
    {
        const auto &next = static_cast<const Edit &>(*command);
        if (!isOf(next.m_label.gesture, next.m_gesture))
            return false;
        m_after = next.m_after;
        setObsolete(changedNothing());
        return true;
    }

    void undo() override
    {
        m_history.m_restore(m_before, tr("undone: %1").arg(m_label.what), KeepRun::ifItWentOn);
    }

    void redo() override
    {
        if (m_isDone)
            m_history.m_restore(m_after, {}, KeepRun::never);
        m_isDone = true; // QUndoStack::push() calls redo(), but the edit has been made before
    }

private:
    bool changedNothing() const
    {
        return sameScript(*m_before.script, *m_after.script) &&
               m_before.branches.all() == m_after.branches.all() && m_before.draft == m_after.draft;
    }

    EditHistory &m_history;
    EditLabel m_label;
    int m_gesture;
    RunSnapshot m_before;
    RunSnapshot m_after;
    bool m_isDone = false;
};

EditHistory::EditHistory()
{
    m_stack.setUndoLimit(undoLimit);
}

void EditHistory::add(const EditLabel &label, RunSnapshot before, RunSnapshot after)
{
    m_stack.push(new Edit(*this, label, std::move(before), std::move(after)));
}

bool EditHistory::continues(const QString &gesture) const
{
    const int last = m_stack.index() - 1;
    const auto *edit = last < 0 ? nullptr : dynamic_cast<const Edit *>(m_stack.command(last));
    return edit && edit->isOf(gesture, m_gesture);
}

}
