#include "app/ui/window/window_keys.h"

#include "app/model/session/session.h"
#include "app/ui/actions/command_list.h"
#include "app/ui/parameters/number_box.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QKeyEvent>
#include <QLineEdit>

namespace app {

namespace {

/// Returns whether the widget with the focus uses this key itself, so that no shortcut of the window may take it.
/// Qt's own buttons, sliders and lists use arrows, Home, End or Space, but do not claim them.
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

WindowKeys::WindowKeys(QWidget &window, QWidget &scene, const CommandList &commands, Session &session)
    : m_window(window), m_scene(scene), m_commands(commands), m_session(session)
{
    window.installEventFilter(this);
    connect(qApp, &QApplication::focusChanged, this, &WindowKeys::followFocus);
}

bool WindowKeys::eventFilter(QObject *watched, QEvent *event)
{
    if (event->type() == QEvent::ShortcutOverride) {
        m_session.preview().end(); // a key acts at the cursor of the run, not at a moment that is previewed
        if (isForFocus(static_cast<QKeyEvent &>(*event))) {
            event->accept();
            return true;
        }
    } else if (event->type() == QEvent::KeyPress && showObstacle(static_cast<QKeyEvent &>(*event))) {
        return true;
    }
    return QObject::eventFilter(watched, event);
}

bool WindowKeys::isForFocus(const QKeyEvent &key) const
{
    const QWidget *focus = QApplication::focusWidget();
    return focus && focus->window() == &m_window && usesKey(*focus, key);
}

/// Says why the command of `key` is disabled, and returns whether there is one. Keys of enabled commands never get here.
bool WindowKeys::showObstacle(const QKeyEvent &key) const
{
    const QString obstacle = m_commands.obstacleOf(key.keyCombination());
    if (obstacle.isEmpty())
        return false;
    m_session.showMessage(obstacle);
    return true;
}

/// Qt passes the focus of a widget that was hidden to the next one, which Space would press.
void WindowKeys::followFocus(const QWidget *before, const QWidget *now) const
{
    if (before && now && before->window() == &m_window && now->window() == &m_window && !before->isVisible())
        m_scene.setFocus();
}

}
