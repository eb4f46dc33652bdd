#include "app/ui/scene/tools.h"

namespace app {

namespace {

bool sim::Keys::*steeringKey(int key)
{
    switch (key) {
    case Qt::Key_Left:
        return &sim::Keys::left;
    case Qt::Key_Right:
        return &sim::Keys::right;
    case Qt::Key_Up:
        return &sim::Keys::up;
    case Qt::Key_Down:
        return &sim::Keys::down;
    default:
        return nullptr;
    }
}

}

bool Tools::any() const
{
    return can(lessons::Does::pointer) || can(lessons::Does::target);
}

bool Tools::press(sim::Vec2 place)
{
    if (can(lessons::Does::pointer)) {
        m_pointing = true;
        moveTo(place);
        m_session.sayThatTimeStands();
    } else if (can(lessons::Does::target)) {
        m_session.aim(place);
        m_session.sayThatTimeStands();
    }
    return any();
}

void Tools::moveTo(sim::Vec2 place)
{
    if (m_pointing)
        m_session.point(place, true);
}

void Tools::letUp()
{
    m_pointing = false;
    m_session.letUp();
}

bool Tools::wants(const QKeyEvent &key) const
{
    const bool plain = (key.modifiers() & ~Qt::KeypadModifier) == Qt::NoModifier;
    return plain && steeringKey(key.key()) && can(lessons::Does::keys) && m_session.isPlaying();
}

bool Tools::key(const QKeyEvent &key, bool down)
{
    bool sim::Keys::*steering = steeringKey(key.key());
    if (!steering || !can(lessons::Does::keys) || (down && !wants(key)))
        return false;
    if (!key.isAutoRepeat())
        m_session.steer(steering, down);
    return true;
}

sim::Vec2 Tools::pointer(sim::Vec2 middle) const
{
    return m_session.timeline().now().outside.pointer.value_or(middle);
}

bool Tools::isDown() const
{
    const sim::Outside &outside = m_session.timeline().now().outside;
    return outside.pointer && outside.pointerDown;
}

bool Tools::nudge(sim::Vec2 by, sim::Vec2 middle)
{
    if (can(lessons::Does::pointer))
        m_session.point(pointer(middle) + by, isDown());
    else if (can(lessons::Does::target))
        m_session.aim(m_session.timeline().now().outside.target + by);
    return any();
}

bool Tools::togglePointer(sim::Vec2 middle)
{
    if (!can(lessons::Does::pointer))
        return false;
    m_session.point(pointer(middle), !isDown());
    return true;
}

}
