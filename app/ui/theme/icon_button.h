#pragma once

#include "app/ui/theme/theme.h"

class QAbstractButton;
class QToolButton;
class QWidget;

namespace app {

/// Gives a button the icon `name` in the colour `ink` of the theme, also after the theme has changed.
void showIcon(QAbstractButton &button, const QString &name, const Theme &theme,
              QColor Tokens::*ink = &Tokens::ink2);

/// Returns a button of 28 px by 28 px that shows only an icon. An empty `icon` leaves it to the caller.
QToolButton *makeIconButton(const QString &objectName, const QString &icon, const Theme &theme,
                            QWidget *parent);

}
