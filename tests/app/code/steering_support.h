#pragma once

#include "tests/app/code/code_support.h"
#include "tests/app/support/user_input.h"

#include <QApplication>
#include <QHelpEvent>
#include <QLineEdit>

/// Shared by the suites that change the run from the code.
namespace steering_support {

using namespace code_support;

struct SteeringFixture : CodeFixture
{
    SteeringFixture() : CodeFixture("gravity_walls", "gravity")
    {
        QVERIFY(QTest::qWaitForWindowActive(&window));
    }

    sim::Cursor at() const { return session.timeline().cursor(); }
    /// Returns the middle of `word` in the first row that has `line`.
    QPoint middleOf(const QString &line, const QString &word)
    {
        const std::size_t there = row(line);
        const QString text = view().rows()[there].text;
        view().showPlace(view().placeOf(there));
        return view().wordRect(there, {text.indexOf(word), word.size(), word, {}}).center();
    }
    void drag(const QPoint &from, int pixels, Qt::KeyboardModifiers keys = {})
    {
        QTest::mousePress(view().viewport(), Qt::LeftButton, keys, from);
        for (int x = 1; x <= 4; ++x)
            move(from + QPoint(pixels * x / 4, 0), Qt::LeftButton, keys);
        QTest::mouseRelease(view().viewport(), Qt::LeftButton, keys, from + QPoint(pixels, 0));
    }
    void move(const QPoint &to, Qt::MouseButton button = Qt::NoButton, Qt::KeyboardModifiers keys = {})
    {
        tests::moveMouse(*view().viewport(), to, button, keys);
    }
    void hover(const QPoint &place)
    {
        move(place);
        QHelpEvent event(QEvent::ToolTip, place, view().viewport()->mapToGlobal(place));
        QApplication::sendEvent(view().viewport(), &event);
    }
    void goToRow(const QString &line)
    {
        view().showPlace(view().placeOf(row(line)));
        view().setFocus(Qt::TabFocusReason);
    }
    void key(Qt::Key which, Qt::KeyboardModifiers keys = {}) { QTest::keyClick(&view(), which, keys); }
    QLineEdit *editor() { return panel->findChild<QLineEdit *>("parameter"); }
};

}
