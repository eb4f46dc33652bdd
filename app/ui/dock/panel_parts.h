#pragma once

#include <QString>

class QHBoxLayout;
class QLabel;
class QVBoxLayout;
class QWidget;

namespace app {

/// Gives a widget the background of panels.
void styleAsPanel(QWidget &widget);

/// Returns a layout without margins, whose parts are one below the other, `spacing` px apart.
QVBoxLayout *makeColumn(QWidget *widget, int spacing = 0);

/// Returns a layout without margins, whose parts are side by side, `spacing` px apart.
QHBoxLayout *makeRow(QWidget *widget, int spacing);

/// Returns a label whose text wraps. The style sheet knows it by `objectName`.
QLabel *makeTextLabel(const QString &objectName, const QString &text, QWidget *parent);

}
