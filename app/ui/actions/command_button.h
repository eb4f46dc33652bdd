#pragma once

#include "app/ui/theme/theme.h"

class QToolButton;

namespace app {

class Command;

/// Makes a button trigger a command and follow its icon, name, tooltip and enabled state. The icon is drawn in
/// the colour `ink` of the theme. A button that also shows whether the command is checked uses
/// QToolButton::setDefaultAction instead.
void showCommand(QToolButton &button, Command &command, const Theme &theme,
                 QColor Tokens::*ink = &Tokens::ink2);

}
