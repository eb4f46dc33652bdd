#include "app/ui/actions/edit_commands.h"

#include "app/model/session/run_editor.h"
#include "app/ui/actions/command_list.h"

namespace app {

EditCommands::EditCommands(RunEditor &editor, CommandList &list)
    : undo(list.add(tr("&Undo"), {QKeySequence("Ctrl+Z")}, KeyGroup::changes)),
      redo(list.add(tr("&Redo"), {QKeySequence("Ctrl+Shift+Z"), QKeySequence("Ctrl+Y")}, KeyGroup::changes)),
      copyText(list.add(tr("&Copy the experiment as text"), {QKeySequence("Ctrl+Shift+C")},
                        KeyGroup::experiments)),
      pasteText(list.add(tr("&Paste an experiment"), {QKeySequence("Ctrl+Shift+V")}, KeyGroup::experiments)),
      copyPicture(list.add(tr("Copy the p&icture of the scene"), {QKeySequence("Ctrl+Shift+P")},
                           KeyGroup::experiments)),
      m_editor(editor)
{
    undo->setObjectName("undo");
    undo->setIconName("undo");
    redo->setObjectName("redo");
    redo->setIconName("redo");
    connect(undo, &QAction::triggered, &editor, &RunEditor::undo);
    connect(redo, &QAction::triggered, &editor, &RunEditor::redo);
    connect(&editor.undoStack(), &QUndoStack::indexChanged, this, &EditCommands::follow);
    follow();
}

void EditCommands::follow()
{
    const QUndoStack &edits = m_editor.undoStack();
    const QString undone = edits.undoText();
    const QString redone = edits.redoText();
    undo->setEnabled(edits.canUndo());
    redo->setEnabled(edits.canRedo());
    undo->setText(undone.isEmpty() ? tr("&Undo") : tr("&Undo: %1").arg(undone));
    redo->setText(redone.isEmpty() ? tr("&Redo") : tr("&Redo: %1").arg(redone));
    undo->setHelp(undone.isEmpty() ? tr("There is nothing to undo in this step") : QString());
    redo->setHelp(redone.isEmpty() ? tr("There is nothing to redo") : QString());
}

}
