#include "app/ui/window/focus_keys.h"

#include "app/ui/parameters/number_box.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QComboBox>
#include <QKeyEvent>
#include <QLineEdit>

namespace app {

bool usesKey(const QWidget &focus, const QKeyEvent &key)
{
    const bool isPlain = (key.modifiers() & ~(Qt::KeypadModifier | Qt::ShiftModifier)) == Qt::NoModifier;
    if (!isPlain)
        return false;
    const bool isArrow = key.key() >= Qt::Key_Left && key.key() <= Qt::Key_Down;
    const bool isMove = isArrow || key.key() == Qt::Key_Home || key.key() == Qt::Key_End;
    const bool isSpace = key.key() == Qt::Key_Space;
    if (qobject_cast<const NumberBox *>(&focus) && isSpace)
        return false; // a number has no space, so the key plays
    if (qobject_cast<const QLineEdit *>(&focus) || qobject_cast<const QAbstractSpinBox *>(&focus))
        return isMove || !key.text().isEmpty();
    if (qobject_cast<const QAbstractSlider *>(&focus))
        return isMove;
    if (qobject_cast<const QAbstractItemView *>(&focus))
        return isMove || isSpace;
    if (qobject_cast<const QComboBox *>(&focus))
        return isArrow || isSpace;
    return qobject_cast<const QAbstractButton *>(&focus) && isSpace;
}

}
