#pragma once

#include <QColor>
#include <QIcon>
#include <QString>

namespace app {

/// Returns the icon `name` (assets/icons/NAME.svg, 16 px grid) in `color`, sharp at every size. It has 40 %
/// opacity when disabled. Returns an empty icon if the file does not exist.
QIcon iconOf(const QString &name, const QColor &color);

/// Returns the icon of a button that can be `off` or `on`. In high contrast a button that is on has a white
/// background.
QIcon iconOf(const QString &name, const QColor &off, const QColor &on);

/// Returns the program's logo, drawn in `line` on `ground`.
QIcon signOf(const QColor &ground, const QColor &line);

}
