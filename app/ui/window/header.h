#pragma once

#include "app/ui/theme/theme.h"

#include <QWidget>

class QHBoxLayout;
class QLabel;
class QMenuBar;

namespace app {

class Command;
struct Commands;

/// The header of the window: logo, menus, and buttons for commands.
class Header : public QWidget
{
    Q_OBJECT

public:
    /// `menus` becomes a part of the header. The other arguments must outlive it.
    Header(QMenuBar *menus, const Commands &commands, const Theme &theme, QWidget *parent);

private:
    void drawLogo(QLabel &logo);
    void addButton(QHBoxLayout &row, Command &command);
    /// Allows the menus to shrink in a narrow window. A button then opens those that do not fit.
    void letGiveWay(QMenuBar &menus);
    /// Returns the buttons that choose a mode.
    QWidget *modeSwitch(const Commands &commands);

    const Theme &m_theme;
};

}
