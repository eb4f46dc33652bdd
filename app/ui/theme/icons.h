#pragma once

#include <QColor>
#include <QIcon>
#include <QString>

namespace app {

/// The icon `name` (assets/icons/NAME.svg, 16 grid) drawn in `color`, sharp at every size; 40 % when disabled.
/// An icon that does not exist is empty.
QIcon iconOf(const QString &name, const QColor &color);

/// The same for a button that is `off` or `on`: in high contrast what is on stands on white.
QIcon iconOf(const QString &name, const QColor &off, const QColor &on);

/// The program's sign on `ground`, drawn in `line`.
QIcon signOf(const QColor &ground, const QColor &line);

}
