#pragma once

#include <QStringList>

class QWidget;

/// Returns the texts that a visible widget draws itself, without those of its children. Shortened texts end with an
/// ellipsis.
QStringList drawnBy(QWidget &widget);
