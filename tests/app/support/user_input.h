#pragma once

#include <QPoint>
#include <Qt>

class QPointF;
class QString;
class QWidget;

/// Mouse and keyboard input of a user that Qt Test has no function for.
namespace tests {

/// Moves the mouse over a widget. QTest::mouseMove() does so without buttons only.
void moveMouse(QWidget &widget, QPointF to, Qt::MouseButtons held = {}, Qt::KeyboardModifiers keys = {});
/// Presses the left button at `from`, moves the mouse by `by` and releases the button.
void dragMouse(QWidget &widget, QPointF from, QPointF by, Qt::KeyboardModifiers keys = {});
/// Clicks a field, replaces its text and ends with a key.
void typeInto(QWidget &field, const QString &text, Qt::Key end = Qt::Key_Return);

}
