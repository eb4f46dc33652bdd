#include "tests/app/support/user_input.h"

#include <QApplication>
#include <QMouseEvent>
#include <QTest>

namespace tests {

void moveMouse(QWidget &widget, QPointF to, Qt::MouseButtons held, Qt::KeyboardModifiers keys)
{
    QMouseEvent move(QEvent::MouseMove, to, widget.mapToGlobal(to), Qt::NoButton, held, keys);
    QApplication::sendEvent(&widget, &move);
}

void dragMouse(QWidget &widget, QPointF from, QPointF by, Qt::KeyboardModifiers keys)
{
    QTest::mousePress(&widget, Qt::LeftButton, keys, from.toPoint());
    moveMouse(widget, from + by / 2.0, Qt::LeftButton, keys);
    moveMouse(widget, from + by, Qt::LeftButton, keys);
    QTest::mouseRelease(&widget, Qt::LeftButton, keys, (from + by).toPoint());
}

void typeInto(QWidget &field, const QString &text, Qt::Key end)
{
    QTest::mouseClick(&field, Qt::LeftButton);
    QTest::keyClick(&field, Qt::Key_A, Qt::ControlModifier);
    QTest::keyClicks(&field, text);
    QTest::keyClick(&field, end);
}

}
