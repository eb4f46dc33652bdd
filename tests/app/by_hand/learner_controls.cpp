// A learner's actions with keys, buttons, menus and fields.

#include "app/ui/parameters/number_box.h"
#include "app/ui/parameters/parameter_panel.h"
#include "app/ui/parameters/parameter_row.h"
#include "app/ui/scene/flat_button.h"
#include "app/ui/scene/scene_bar.h"
#include "app/ui/scene/scene_view.h"
#include "app/ui/time/frame_counter.h"
#include "app/ui/time/transport_bar.h"
#include "tests/app/by_hand/learner.h"

#include <QApplication>
#include <QComboBox>
#include <QLineEdit>
#include <QListView>
#include <QMenu>
#include <QScrollArea>
#include <QTest>
#include <QTimer>

#include <cmath>
#include <stdexcept>

using namespace app;

namespace support {

namespace {

constexpr int mostMilliseconds = 60'000; ///< that anything takes
constexpr int awayFromFields = 45;       ///< px on the screen

/// Types into a field that was clicked or that a command has opened: what it held is selected.
void replaceText(QWidget *field, const QString &text)
{
    settle();
    QTest::keyClicks(field, text);
    QTest::keyClick(field, Qt::Key_Return);
}

Qt::Key keyOf(bool sim::Keys::*key)
{
    if (key == &sim::Keys::left)
        return Qt::Key_Left;
    if (key == &sim::Keys::right)
        return Qt::Key_Right;
    return key == &sim::Keys::up ? Qt::Key_Up : Qt::Key_Down;
}

}

void Learner::leavePicture()
{
    if (m_isDown)
        release(); // there is but one hand
}

void Learner::comeBack()
{
    // Without a window manager, closing a window does not activate the window below it.
    QApplication::setActiveWindow(&m_window);
    settle();
}

QAbstractButton &Learner::button(const QWidget *part, const QString &name) const
{
    if (auto *found = part->findChild<QAbstractButton *>(name))
        return *found;
    throw std::runtime_error("no button is called " + name.toStdString());
}

void Learner::step(bool byPhase)
{
    const bool mayClick = !m_session.step().accepts(lessons::Interaction::pointer) &&
                          !m_session.step().accepts(lessons::Interaction::target);
    if (!m_view.hasFocus() && mayClick) {
        press(freePlaceNear({awayFromFields, awayFromFields})); // out of a field, and into the picture
        release();
    }
    if (m_session.playback().isPlaying() && m_session.step().accepts(lessons::Interaction::keys))
        QTest::keyClick(&m_view,
                        Qt::Key_Space); // a hand has started time, and the arrow keys steer while it runs
    // The mouse is used only if the picture does not have the focus.
    if (m_isDown || m_view.hasFocus()) {
        QTest::keyClick(&m_view, Qt::Key_Right, byPhase ? Qt::ShiftModifier : Qt::NoModifier);
    } else {
        const auto *transport = m_window.findChild<TransportBar *>();
        QTest::mouseClick(&button(transport, byPhase ? "phaseForward" : "frameForward"), Qt::LeftButton);
    }
    look();
}

void Learner::play(int frames)
{
    if (m_keys != sim::Keys{}) {
        playInTime(frames);
        return;
    }
    for (int i = 0; i < frames; ++i)
        step(false);
}

void Learner::playInTime(int frames)
{
    const std::int64_t end = run().cursor().frame + frames;
    const bool arrived =
        QTest::qWaitFor([&] { return run().cursor().frame >= end || done(); }, mostMilliseconds);
    if (!arrived)
        throw std::runtime_error("it does not play");
}

void Learner::stepPhases(int count)
{
    for (int i = 0; i < count; ++i)
        step(true);
}

void Learner::key(bool sim::Keys::*key, bool down)
{
    const bool wasDown = m_keys != sim::Keys{};
    m_keys.*key = down;
    m_view.setFocus(Qt::MouseFocusReason); // as a click into the picture does
    if (!wasDown)
        QTest::keyClick(&m_view, Qt::Key_Space); // arrow keys steer while it plays
    if (down)
        QTest::keyPress(&m_view, keyOf(key));
    else
        QTest::keyRelease(&m_view, keyOf(key));
    if (m_keys == sim::Keys{})
        QTest::keyClick(&m_view, Qt::Key_Space);
}

/// Chooses item `row` of a menu that has a submenu for each kind, by keys.
static void chooseByKind(QMenu &menu, int row)
{
    for (QAction *group : menu.actions()) {
        const auto count = static_cast<int>(group->menu()->actions().size());
        if (row >= count) {
            row -= count;
            continue;
        }
        menu.setActiveAction(group);
        QTest::keyClick(&menu, Qt::Key_Right);
        group->menu()->setActiveAction(group->menu()->actions()[row]);
        QTest::keyClick(group->menu(), Qt::Key_Return);
        return;
    }
}

void Learner::chooseFrom(QWidget &field, int row)
{
    auto &box = static_cast<QComboBox &>(field);
    QTest::mouseClick(&box, Qt::LeftButton);
    if (auto *menu = box.findChild<QMenu *>(QString(), Qt::FindDirectChildrenOnly)) {
        chooseByKind(*menu, row);
        comeBack();
        return;
    }
    QTest::keyClick(box.view(), Qt::Key_Home);
    for (int i = 0; i < row; ++i)
        QTest::keyClick(box.view(), Qt::Key_Down);
    QTest::keyClick(box.view(), Qt::Key_Return);
    comeBack();
}

void Learner::set(const std::string &parameter, double value)
{
    leavePicture();
    auto *panel = m_window.findChild<ParameterPanel *>();
    for (ParameterRow *row : panel->findChildren<ParameterRow *>()) {
        if (row->parameter().id != QString::fromStdString(parameter))
            continue;
        if (!row->isVisible())
            QTest::mouseClick(&button(panel, "disclosure"), Qt::LeftButton);
        settle();
        panel->findChild<QScrollArea *>()->ensureWidgetVisible(row);
        if (!row->parameter().choices.isEmpty()) {
            chooseFrom(*row->findChild<QComboBox *>(), static_cast<int>(value));
        } else {
            auto *box = row->findChild<NumberBox *>();
            QTest::mouseClick(box->findChild<QLineEdit *>(), Qt::LeftButton);
            replaceText(box, QString::number(value, 'g', 12));
        }
        settle(); // the row may be gone with the run that it belonged to
        if (std::abs(m_session.editor().parameter(QString::fromStdString(parameter)) - value) > 1e-9)
            throw std::runtime_error(
                "the field does not take a value for " + parameter + ": it is " +
                std::to_string(m_session.editor().parameter(QString::fromStdString(parameter))));
        return;
    }
    throw std::runtime_error("no parameter is called " + parameter);
}

void Learner::inMenu(const QString &name, const std::function<void(QMenu &)> &choose)
{
    leavePicture();
    for (auto *one : m_window.findChild<SceneBar *>()->findChildren<FlatButton *>()) {
        if (!one->accessibleName().startsWith(name))
            continue;
        // The menu has a loop of its own, in which this happens.
        QTimer::singleShot(0, one, [&] { choose(*one->menu()); });
        QTest::mouseClick(one, Qt::LeftButton);
        settle();
        comeBack();
        return;
    }
    throw std::runtime_error("no menu is called " + name.toStdString());
}

void Learner::useMethod(const std::string &id)
{
    inMenu(QStringLiteral("Method"), [&](QMenu &menu) {
        for (QAction *action : menu.actions()) {
            if (action->data().toString().toStdString() == id)
                QTest::mouseClick(&menu, Qt::LeftButton, {}, menu.actionGeometry(action).center());
        }
        menu.close();
    });
    if (run().script().method->id() != id)
        throw std::runtime_error("the menu does not have the method " + id);
}

void Learner::chooseStep(double value, bool isTolerance)
{
    inMenu(isTolerance ? QStringLiteral("Tolerance") : QStringLiteral("Step"), [&](QMenu &menu) {
        for (QAction *action : menu.actions()) {
            if (action->isVisible() && action->isCheckable() &&
                std::abs(action->data().toDouble() / value - 1.0) < 1e-9) {
                QTest::mouseClick(&menu, Qt::LeftButton, {}, menu.actionGeometry(action).center());
                return;
            }
        }
        auto *other = menu.findChild<QLineEdit *>();
        QTest::mouseClick(other, Qt::LeftButton);
        replaceText(other, QString::number(value, 'g', 12));
        menu.close();
    });
}

void Learner::useStep(double h)
{
    chooseStep(h, false);
    if (run().script().step.h != h)
        throw std::runtime_error("the menu does not have that step");
}

void Learner::useTolerance(double tolerance)
{
    chooseStep(tolerance, true);
    if (run().script().step.tolerance != tolerance)
        throw std::runtime_error("the menu does not have that tolerance");
}

void Learner::useTiming(lessons::TimeMeasurement timing)
{
    m_session.setTiming(std::move(timing));
}

void Learner::goTo(std::int64_t frame)
{
    leavePicture();
    QTest::keyClick(&m_window, Qt::Key_G, Qt::ControlModifier);
    auto *field = m_window.findChild<FrameCounter *>()->findChild<QLineEdit *>();
    if (!field)
        throw std::runtime_error("no frame can be typed");
    replaceText(field, QString::number(frame));
    if (!QTest::qWaitFor([&] { return !m_session.playback().goal(); }, mostMilliseconds))
        throw std::runtime_error("it does not get to that frame");
}

}
