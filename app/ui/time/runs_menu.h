#pragma once

#include "app/model/session.h"
#include "app/ui/theme/theme.h"

#include <QMenu>

namespace app {

/// The other runs of a step, newest first, each with a menu of what can be done with it. Filled when it is about to be
/// seen.
class RunsMenu : public QMenu
{
    Q_OBJECT

public:
    RunsMenu(Session &session, const Theme &theme, QWidget *parent = nullptr);

    /// Fills it with what can be done with one branch alone, in place of all.
    void showOnly(int branch);
    /// Fills it with some of the branches.
    void showOnly(std::vector<int> branches);
    /// Opens it right above a widget.
    void popupAbove(const QWidget &widget);

signals:
    /// The two runs are to be compared in numbers.
    void compareWanted();

private:
    void fill();
    void addRun(const Branch &branch);
    void addDeeds(QMenu &menu, const Branch &branch);
    void askName(int branch);

    Session &m_session;
    const Theme &m_theme;
    std::vector<int> m_only; ///< empty: all
};

}
