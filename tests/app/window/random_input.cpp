#include "tests/app/window/random_input.h"

#include "tests/app/support/user_input.h"

#include <QAction>
#include <QApplication>
#include <QDialog>
#include <QMouseEvent>
#include <QPointer>
#include <QTest>
#include <QTimer>
#include <QWheelEvent>

#include <array>

namespace {

constexpr int remembered = 30; ///< inputs
constexpr int answerMilliseconds = 5;
constexpr int mostAnswers = 12; ///< keys for a dialog or menu before it is closed

constexpr std::array plainKeys{
    Qt::Key_Space, Qt::Key_Left,   Qt::Key_Right, Qt::Key_Up,    Qt::Key_Down,      Qt::Key_Tab,
    Qt::Key_Enter, Qt::Key_Escape, Qt::Key_Home,  Qt::Key_End,   Qt::Key_PageDown,  Qt::Key_F1,
    Qt::Key_F2,    Qt::Key_F5,     Qt::Key_F6,    Qt::Key_F7,    Qt::Key_F8,        Qt::Key_F9,
    Qt::Key_F11,   Qt::Key_Delete, Qt::Key_Plus,  Qt::Key_Minus, Qt::Key_Backspace, Qt::Key_BracketLeft,
    Qt::Key_H,     Qt::Key_V,      Qt::Key_P,     Qt::Key_N,     Qt::Key_S,         Qt::Key_T,
    Qt::Key_F,     Qt::Key_Menu};
constexpr std::array drawnModifiers{Qt::NoModifier,    Qt::NoModifier,      Qt::NoModifier,
                                    Qt::ShiftModifier, Qt::ControlModifier, Qt::AltModifier};

}

RandomUser::RandomUser(QWidget &window, unsigned seed) : m_window(window), m_dice(seed)
{
    QTimer::singleShot(answerMilliseconds, this, &RandomUser::answer);
}

void RandomUser::note(const QString &what)
{
    m_done << what;
    if (m_done.size() > remembered)
        m_done.removeFirst();
}

void RandomUser::act()
{
    using Action = void (RandomUser::*)();
    static constexpr std::array<Action, 13> actions{
        &RandomUser::key,   &RandomUser::key,   &RandomUser::key,    &RandomUser::type, &RandomUser::click,
        &RandomUser::click, &RandomUser::click, &RandomUser::drag,   &RandomUser::drag, &RandomUser::wheel,
        &RandomUser::hover, &RandomUser::hover, &RandomUser::command};
    if (below(60) == 0)
        resize();
    else
        (this->*actions[static_cast<std::size_t>(below(static_cast<int>(actions.size())))])();
    QCoreApplication::processEvents();
}

QWidget *RandomUser::someWindow()
{
    QList<QWidget *> open;
    for (QWidget *widget : QApplication::topLevelWidgets()) {
        if (widget->isVisible() && widget != &m_window)
            open << widget;
    }
    return open.isEmpty() || below(3) > 0 ? &m_window : open.at(below(static_cast<int>(open.size())));
}

QWidget *RandomUser::somewhere(QPoint &at)
{
    QWidget *top = someWindow();
    if (!top->isVisible() || top->width() < 1 || top->height() < 1)
        return nullptr;
    const QPoint place(below(top->width()), below(top->height()));
    QWidget *child = top->childAt(place);
    QWidget *widget = child ? child : top;
    at = widget->mapFrom(top, place);
    return widget;
}

void RandomUser::key()
{
    QWidget *to = QApplication::focusWidget();
    if (!to || !to->isVisible())
        to = &m_window;
    const Qt::Key pressed = plainKeys[static_cast<std::size_t>(below(static_cast<int>(plainKeys.size())))];
    const Qt::KeyboardModifier with =
        drawnModifiers[static_cast<std::size_t>(below(static_cast<int>(drawnModifiers.size())))];
    note(QString("key %1+%2 in %3")
             .arg(static_cast<int>(with), 0, 16)
             .arg(QKeySequence(pressed).toString(), to->metaObject()->className()));
    QTest::keyClick(to, pressed, with);
}

void RandomUser::type()
{
    QWidget *to = QApplication::focusWidget();
    if (!to || !to->isVisible())
        to = &m_window;
    static const QStringList texts{"0",   "1e9", "-3.5", "frame == 7", "foot0.y > 3",
                                   "abc", "nan", "0.85", "40"};
    const QString text = texts.at(below(static_cast<int>(texts.size())));
    note(QString("type %1 in %2").arg(text, to->metaObject()->className()));
    QTest::keyClicks(to, text);
}

void RandomUser::click()
{
    QPoint at;
    QPointer<QWidget> to = somewhere(at);
    if (!to)
        return;
    const Qt::MouseButton button = below(6) == 0 ? Qt::RightButton : Qt::LeftButton;
    note(QString("click %1 %2 in %3").arg(at.x()).arg(at.y()).arg(to->metaObject()->className()));
    if (button == Qt::RightButton) {
        QContextMenuEvent menu(QContextMenuEvent::Mouse, at, to->mapToGlobal(at));
        QApplication::sendEvent(to, &menu);
    } else if (below(8) == 0) {
        QTest::mouseDClick(to, button, {}, at);
    } else {
        QTest::mouseClick(to, button, {}, at);
    }
}

void RandomUser::drag()
{
    QPoint at;
    QPointer<QWidget> to = somewhere(at);
    if (!to)
        return;
    note(QString("drag %1 %2 in %3").arg(at.x()).arg(at.y()).arg(to->metaObject()->className()));
    QTest::mousePress(to, Qt::LeftButton, {}, at);
    for (int i = 0; i < 4 && to; ++i) {
        at += QPoint(below(161) - 80, below(161) - 80);
        tests::moveMouse(*to, at, Qt::LeftButton);
        QCoreApplication::processEvents();
    }
    if (to)
        QTest::mouseRelease(to, Qt::LeftButton, {}, at);
}

void RandomUser::wheel()
{
    QPoint at;
    QWidget *to = somewhere(at);
    if (!to)
        return;
    note(QString("wheel in %1").arg(to->metaObject()->className()));
    QWheelEvent turn(at, to->mapToGlobal(at), {}, {0, 120 * (below(2) * 2 - 1)}, Qt::NoButton, {},
                     Qt::NoScrollPhase, false);
    QApplication::sendEvent(to, &turn);
}

void RandomUser::hover()
{
    QPoint at;
    QWidget *to = somewhere(at);
    if (!to)
        return;
    note(QString("hover in %1").arg(to->metaObject()->className()));
    tests::moveMouse(*to, at);
}

void RandomUser::command()
{
    QList<QAction *> all;
    for (QAction *action : m_window.findChildren<QAction *>()) {
        if (action->isEnabled() && !action->menu() && action->shortcut() != QKeySequence("Ctrl+Q"))
            all << action;
    }
    QAction *action = all.at(below(static_cast<int>(all.size())));
    note(QString("command %1").arg(action->text()));
    action->trigger();
}

void RandomUser::resize()
{
    note("resize");
    m_window.resize(400 + below(1600), 400 + below(800));
}

void RandomUser::answer()
{
    // A new timer each time: an answer may open another dialog, and no timer fires within its own slot.
    QTimer::singleShot(answerMilliseconds, this, &RandomUser::answer);
    QWidget *waits = QApplication::activePopupWidget();
    if (!waits)
        waits = QApplication::activeModalWidget();
    if (!waits) {
        m_answered = 0;
        return;
    }
    if (++m_answered > mostAnswers) {
        note(QString("close %1").arg(waits->metaObject()->className()));
        waits->close();
        return;
    }
    static constexpr std::array keys{Qt::Key_Down,   Qt::Key_Up,    Qt::Key_Tab,
                                     Qt::Key_Return, Qt::Key_Right, Qt::Key_A};
    const Qt::Key pressed = keys[static_cast<std::size_t>(below(static_cast<int>(keys.size())))];
    QWidget *focus = waits->focusWidget();
    note(QString("answer %1 in %2").arg(QKeySequence(pressed).toString(), waits->metaObject()->className()));
    QTest::keyClick(focus ? focus : waits, pressed);
}
