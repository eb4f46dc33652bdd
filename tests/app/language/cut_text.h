#pragma once

#include <QStringList>

class QWidget;

/// Returns the widgets in `window` whose texts do not have the space that they need, with what is missing.
QStringList cutIn(QWidget &window);
