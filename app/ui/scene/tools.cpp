#include "app/ui/scene/tools.h"

#include "sim/run/script/composed_interval.h"
#include "sim/scene/input_reader.h"

#include <algorithm>

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

std::optional<sim::Signal> signalOf(lessons::Does what)
{
    switch (what) {
    case lessons::Does::pointer:
        return sim::Signal::pointer;
    case lessons::Does::target:
        return sim::Signal::target;
    case lessons::Does::keys:
        return sim::Signal::keys;
    case lessons::Does::hand:
    case lessons::Does::gust:
        break;
    }
    return std::nullopt;
}

}

bool Tools::can(lessons::Does what) const
{
    const std::optional<sim::Signal> signal = signalOf(what);
    if (!signal || !m_session.step().can(what))
        return false;
    // A step can show many scenes. Where nothing reads the pointer, a click must not become part of the run.
    const std::vector<sim::EffectPtr> &effects = m_session.timeline().track().shown().scene.effects;
    return std::any_of(effects.begin(), effects.end(), [&](const sim::EffectPtr &one) {
        const auto *reader = dynamic_cast<const sim::InputReader *>(one.get());
        return reader && reader->reads(*signal);
    });
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
