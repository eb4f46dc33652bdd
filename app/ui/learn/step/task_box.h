#pragma once

#include "app/model/listing/task_desk.h"
#include "app/ui/learn/fold_box.h"

#include <vector>

class QToolButton;

namespace app {

class ButtonFlow;
class NarrationText;

/// A task in the step's listing, folded to its title. Unfolded, it shows its text. While the learner writes, it also shows
/// what is still wrong, hints, and the way to the solution.
class TaskBox : public FoldBox
{
    Q_OBJECT

public:
    /// `task` must be one of the open step, and all arguments must outlive this object.
    TaskBox(TaskDesk &desk, const lessons::CodeTask &task, const Theme &theme, QWidget *parent = nullptr);

    const lessons::CodeTask &task() const { return m_task; }
    /// Shows the present state of the desk. Returns whether the height can be another.
    bool refresh();

signals:
    /// Emitted when the learner starts to write, so the listing should be shown.
    void started();

protected:
    void fill() override;

private:
    bool isActive() const { return m_desk.task() == &m_task; }

    TaskDesk &m_desk;
    const lessons::CodeTask &m_task;
    NarrationText *m_sentence = nullptr;
    std::vector<NarrationText *> m_hints;
    ButtonFlow *m_buttons = nullptr; ///< stays in view while the box is scrolled
    QToolButton *m_start = nullptr;
    QToolButton *m_hint = nullptr;
    QToolButton *m_solution = nullptr;
    QToolButton *m_stop = nullptr;
};

}
