#pragma once

#include <QStringList>

class QWidget;

/// Returns a line for each widget in `window` whose text is cut: its class, its text, and how many px are missing.
QStringList cutIn(QWidget &window);
