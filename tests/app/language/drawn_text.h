#pragma once

#include <QStringList>

class QWidget;

/// The texts that a visible widget draws itself, without those of the widgets in it, as they come: cut with an ellipsis where
/// they were.
QStringList drawnBy(QWidget &widget);
