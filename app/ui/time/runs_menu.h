#pragma once

#include "app/model/session/comparison_runs.h"
#include "app/model/session/open_run.h"
#include "app/model/session/run_editor.h"
#include "app/ui/theme/theme.h"

#include <QMenu>

namespace app {

/// A menu of the other runs of a step, newest first, each with a submenu of its commands. It is filled before it
/// opens.
class RunsMenu : public QMenu
{
    Q_OBJECT

public:
    RunsMenu(const OpenRun &run, RunEditor &editor, ComparisonRuns &comparisons, const Theme &theme,
             QWidget *parent = nullptr);

    /// Shows only some branches; all if there are none. Of a single branch, shows only the commands.
    void showOnly(std::vector<int> branches);
    /// Opens the menu right above a widget.
    void popupAbove(const QWidget &widget);

signals:
    /// The learner wants to compare the two runs in numbers.
    void compareWanted();

private:
    void fill();
    void addRun(const Branch &branch);
    void addCommands(QMenu &menu, const Branch &branch);
    void askName(int branch);

    const OpenRun &m_run;
    RunEditor &m_editor;
    ComparisonRuns &m_comparisons;
    const Theme &m_theme;
    std::vector<int> m_only; ///< empty for all branches
};

}
