#include "app/ui/scene/tools.h"

#include "sim/effects/drivers/input_reader.h"
#include "sim/run/script/composed_interval.h"

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

std::optional<sim::InputKind> signalOf(lessons::Interaction what)
{
    switch (what) {
    case lessons::Interaction::pointer:
        return sim::InputKind::pointer;
    case lessons::Interaction::target:
        return sim::InputKind::target;
    case lessons::Interaction::keys:
        return sim::InputKind::keys;
    case lessons::Interaction::drag:
    case lessons::Interaction::gust:
        break;
    }
    return std::nullopt;
}

}

bool Tools::can(lessons::Interaction what) const
{
    const std::optional<sim::InputKind> signal = signalOf(what);
    if (!signal || !m_run.step().accepts(what))
        return false;
    // A step can show many scenes. Where nothing reads the pointer, a click must not become part of the run.
    const std::vector<sim::EffectPtr> &effects = m_run.timeline().track().interval().scene.effects;
    return std::any_of(effects.begin(), effects.end(), [&](const sim::EffectPtr &one) {
        const auto *reader = dynamic_cast<const sim::InputReader *>(one.get());
        return reader && reader->reads(*signal);
    });
}

bool Tools::any() const
{
    return can(lessons::Interaction::pointer) || can(lessons::Interaction::target);
}

bool Tools::press(sim::Vec2 place)
{
    if (can(lessons::Interaction::pointer)) {
        m_pointing = true;
        moveTo(place);
    } else if (can(lessons::Interaction::target)) {
        m_input.setTarget(place);
        m_playback.reportIfPaused();
    }
    return any();
}

void Tools::moveTo(sim::Vec2 place)
{
    if (!m_pointing)
        return;
    m_input.setPointer(place, true);
    m_playback.reportIfPaused(); // after each change, which clears the status bar
}

void Tools::release()
{
    m_pointing = false;
    m_input.releaseAll();
}

bool Tools::wants(const QKeyEvent &key) const
{
    const bool plain = (key.modifiers() & ~Qt::KeypadModifier) == Qt::NoModifier;
    return plain && steeringKey(key.key()) && can(lessons::Interaction::keys) && m_playback.isPlaying();
}

bool Tools::key(const QKeyEvent &key, bool down)
{
    bool sim::Keys::*steering = steeringKey(key.key());
    if (!steering || !can(lessons::Interaction::keys) || (down && !wants(key)))
        return false;
    if (!key.isAutoRepeat())
        m_input.setKey(steering, down);
    return true;
}

sim::Vec2 Tools::pointer(sim::Vec2 middle) const
{
    return m_run.timeline().state().input.pointer.value_or(middle);
}

bool Tools::isDown() const
{
    const sim::InputState &outside = m_run.timeline().state().input;
    return outside.pointer && outside.pointerDown;
}

bool Tools::nudge(sim::Vec2 by, sim::Vec2 middle)
{
    if (can(lessons::Interaction::pointer))
        m_input.setPointer(pointer(middle) + by, isDown());
    else if (can(lessons::Interaction::target))
        m_input.setTarget(m_run.timeline().state().input.target + by);
    return any();
}

bool Tools::togglePointer(sim::Vec2 middle)
{
    if (!can(lessons::Interaction::pointer))
        return false;
    m_input.setPointer(pointer(middle), !isDown());
    return true;
}

}
