// A learner who reads, and uses the mouse in the picture.

#include "tests/app/by_hand/learner.h"

#include "app/ui/learn/learn_panel.h"
#include "app/ui/learn/lessons/lesson_list.h"
#include "app/ui/learn/lessons/lesson_model.h"
#include "app/ui/learn/narration_text.h"
#include "app/ui/learn/step/narration.h"
#include "app/ui/learn/step/try_row.h"
#include "app/ui/learn/step_button.h"
#include "app/ui/learn/why_box.h"
#include "app/ui/scene/body_drag.h"
#include "app/ui/scene/scene_view.h"
#include "lessons/api/checks/drag_gesture.h"

#include <QTest>
#include <QToolButton>

#include <algorithm>
#include <stdexcept>

using namespace app;

namespace support {

namespace {

constexpr int framesUnseen = 20; ///< that a run goes on before the picture is painted again
constexpr int enoughToGrab = 4;  ///< px on the screen: less is a click
constexpr int awayFromBody = 45; ///< px on the screen

void sendMouse(QWidget *to, QEvent::Type type, QPoint at, Qt::MouseButton button, Qt::MouseButtons buttons)
{
    QMouseEvent event(type, QPointF(at), QPointF(to->mapToGlobal(at)), button, buttons, Qt::NoModifier);
    QApplication::sendEvent(to, &event);
}

}

void settle()
{
    QCoreApplication::processEvents();
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete); // what was replaced is gone
}

Learner::Learner(Session &session, MainWindow &window)
    : m_session(session), m_window(window), m_view(*window.findChild<SceneView *>())
{
}

void Learner::begin(std::size_t number)
{
    m_number = number;
    leavePicture();
    comeBack(); // a list that dropped down before may close only now
    QTest::keyClick(&m_window, Qt::Key_R, Qt::ControlModifier);
    settle();
}

void Learner::openRow(const QString &title, const QModelIndex &parent)
{
    auto *list = m_window.findChild<LessonList *>();
    for (int i = 0; i < list->model()->rowCount(parent); ++i) {
        const QModelIndex row = list->model()->index(i, 0, parent);
        if (row.data().toString() != title)
            continue;
        list->scrollTo(row);
        QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, list->visualRect(row).center());
        settle();
        return;
    }
    throw std::runtime_error("the list does not have " + title.toStdString());
}

void Learner::openLesson(const QString &title)
{
    openRow(title, {});
}

void Learner::openStep(const QString &title)
{
    openRow(title, m_window.findChild<LessonList *>()->lessons().openLesson());
}

QString Learner::narration() const
{
    return m_window.findChild<Narration *>()->findChild<NarrationText *>()->toPlainText();
}

QStringList Learner::hints()
{
    for (auto *lamp : m_window.findChild<Narration *>()->findChildren<QToolButton *>("hint"))
        QTest::mouseClick(lamp, Qt::LeftButton);
    settle();
    QStringList all;
    for (const auto *hint : m_window.findChild<Narration *>()->findChildren<NarrationText *>("hintText")) {
        if (hint->isVisible())
            all << hint->toPlainText();
    }
    return all;
}

QStringList Learner::answers()
{
    QStringList all;
    for (auto *box : m_window.findChild<Narration *>()->findChildren<WhyBox *>()) {
        QTest::mouseClick(box->findChild<WhyButton *>(), Qt::LeftButton);
        const auto *answer = box->findChild<NarrationText *>();
        all << (answer->isVisible() ? answer->toPlainText() : QString());
    }
    return all;
}

bool Learner::sees(std::size_t number) const
{
    const auto rows = m_window.findChild<Narration *>()->findChildren<TryRow *>();
    return static_cast<qsizetype>(number) < rows.size() && rows[static_cast<qsizetype>(number)]->isChecked();
}

void Learner::pressNext()
{
    for (auto *next : m_window.findChild<LearnPanel *>()->findChildren<StepButton *>("next")) {
        if (next->isVisible()) {
            QTest::mouseClick(next, Qt::LeftButton);
            break;
        }
    }
    settle();
}

bool Learner::done() const
{
    return m_session.progress().isDone(m_session.lesson().id, m_session.step().id,
                                       static_cast<int>(m_number));
}

void Learner::look()
{
    if (++m_unseen < framesUnseen)
        return;
    m_unseen = 0;
    settle();
}

QPoint Learner::onScreen(sim::Vec2 place) const
{
    return m_view.viewportTransform().map(QPointF(place.x, place.y)).toPoint();
}

QPoint Learner::inPicture(sim::Vec2 place) const
{
    const QRect picture = m_view.viewport()->rect().adjusted(2, 2, -2, -2);
    const QPoint seen = onScreen(place);
    return {std::clamp(seen.x(), picture.left(), picture.right()),
            std::clamp(seen.y(), picture.top(), picture.bottom())};
}

int Learner::bodyAt(QPoint place) const
{
    return BodyDrag::bodyAt(m_view.shown(), Camera(m_view.viewportTransform()), place);
}

void Learner::press(QPoint place)
{
    m_pointer = place;
    m_isDown = true;
    // A press of a real mouse activates the window and sets the focus, too.
    if (!m_window.isActiveWindow())
        QApplication::setActiveWindow(&m_window);
    m_view.viewport()->setFocus(Qt::MouseFocusReason);
    sendMouse(m_view.viewport(), QEvent::MouseButtonPress, place, Qt::LeftButton, Qt::LeftButton);
}

void Learner::move(QPoint place)
{
    m_pointer = place;
    sendMouse(m_view.viewport(), QEvent::MouseMove, place, Qt::NoButton,
              m_isDown ? Qt::LeftButton : Qt::NoButton);
}

void Learner::releaseButton()
{
    m_isDown = false;
    sendMouse(m_view.viewport(), QEvent::MouseButtonRelease, m_pointer, Qt::LeftButton, Qt::NoButton);
}

void Learner::bringIntoView(const std::string &body)
{
    if (!m_view.viewport()->rect().contains(onScreen(at(body)))) {
        QTest::keyClick(&m_window, Qt::Key_0, Qt::ControlModifier);
        settle();
    }
}

void Learner::grab(const std::string &body)
{
    m_held = body;
    bringIntoView(body);
    const QPoint place = onScreen(at(body));
    press(place);
    move(place + QPoint(enoughToGrab, 0)); // a click alone holds nothing
    const QString wanted = QString::fromStdString(body);
    if (m_session.selected() != wanted || !m_session.input().isHolding())
        throw std::runtime_error("the mouse cannot take " + body);
}

void Learner::movePointer(sim::Vec2 to)
{
    move(inPicture(to));
}

void Learner::release()
{
    releaseButton();
}

QPoint Learner::freePlaceNear(QPoint place) const
{
    const int pointed = m_view.shown().picture.view->pointerPoint;
    for (const QPoint &way : {QPoint(0, 0), QPoint(0, -1), QPoint(1, 0), QPoint(-1, 0), QPoint(0, 1)}) {
        const QPoint free = place + awayFromBody * way;
        const int body = bodyAt(free);
        if (m_view.viewport()->rect().contains(free) && (body < 0 || body == pointed))
            return free;
    }
    throw std::runtime_error("no free place to press");
}

void Learner::point(sim::Vec2 where, bool down)
{
    if (!m_isDown && down)
        press(freePlaceNear(inPicture(where)));
    move(onScreen(where)); // with the button down it may go past the edge
    if (!down && m_isDown)
        releaseButton();
}

void Learner::target(sim::Vec2 where)
{
    press(freePlaceNear(inPicture(where)));
    releaseButton();
}

}
