#pragma once

#include "app/model/session/open_run.h"
#include "app/ui/code/title_actions.h"

#include <QWidget>

class QLabel;
class QPushButton;
class QHBoxLayout;

namespace app {

class Command;
class ListingEditor;
class MistakeRow;
class Playback;
class RuleCode;
class RunEditor;
class Theme;

/// A panel with the learner's rule for the scene of the sandbox. Each change is compiled after a short pause, and the run
/// is computed again. Below are the mistake, what the rule acts on, and the commands that choose where `pull` acts.
class RulePanel : public QWidget
{
    Q_OBJECT

public:
    /// All arguments must outlive it.
    RulePanel(const OpenRun &run, RunEditor &changes, const Playback &playback, RuleCode &rule,
              const Theme &theme, QWidget *parent = nullptr);
    /// Applies the text that was typed last.
    ~RulePanel() override;

    ListingEditor &editor() { return *m_editor; }
    /// Returns the buttons for the right end of the title. The code that creates the title must place them.
    QWidget *titleActions() { return m_actions.widget(); }
    /// Returns the sentence under the editor; empty if the rule has no mistake.
    QString sentence() const;
    /// Returns what the rule acts on.
    QString state() const;
    /// Adds a button for a command to the last row.
    void addCommand(Command &command);

signals:
    /// Emitted when the learner leaves the editor by keyboard.
    void left();

protected:
    void showEvent(QShowEvent *event) override;
    void hideEvent(QHideEvent *event) override;

private:
    QWidget *makeFoot();
    void follow(const Change &change);
    void refresh();
    void showMistakes();
    QString stateText() const;

    const OpenRun &m_run;
    RunEditor &m_changes;
    const Playback &m_playback;
    RuleCode &m_rule;
    ListingEditor *m_editor;
    MistakeRow *m_mistake;
    QLabel *m_state;
    QPushButton *m_switchOn;
    QHBoxLayout *m_commands = nullptr;
    TitleActions m_actions;
    QToolButton *m_delete;
    const lessons::Step *m_step = nullptr; ///< the step that is shown
};

}
