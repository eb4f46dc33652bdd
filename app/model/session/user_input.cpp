#include "app/model/session/user_input.h"

#include "app/model/session/run_editor.h"
#include "sim/run/script/composed_interval.h"

#include <cmath>

namespace app {

namespace {

/// The label of grabbing, dragging and releasing a body.
EditLabel dragLabel(const QString &body)
{
    const QString hand = UserInput::tr("your hand");
    return {UserInput::tr("Drag %1").arg(bodyTitle(body)), hand, QStringLiteral(":hand"), hand};
}

bool isFinite(sim::Vec2 place)
{
    return std::isfinite(place.x) && std::isfinite(place.y);
}

}

void UserInput::grab(const QString &body)
{
    if (m_run.timeline().track().interval().scene.find(body.toStdString()) < 0)
        return;
    const ChangeNotifier::Batch batch(m_run.changes());
    m_run.select(body);
    m_isHolding = true;
    m_editor.edit(dragLabel(body), [&](sim::Timeline &timeline) {
        return timeline.applyInput(sim::Grab{body.toStdString()});
    });
}

void UserInput::moveTo(sim::Vec2 to)
{
    if (!m_isHolding || !isFinite(to))
        return;
    m_editor.edit(dragLabel(m_run.selected()),
                  [&](sim::Timeline &timeline) { return timeline.applyInput(sim::Move{to}); });
}

void UserInput::release()
{
    if (!m_isHolding)
        return;
    m_isHolding = false;
    m_editor.edit(dragLabel(m_run.selected()),
                  [](sim::Timeline &timeline) { return timeline.applyInput(sim::Release{}); });
    m_editor.endGesture();
}

void UserInput::setPointer(sim::Vec2 at, bool isDown)
{
    if (!m_run.step().accepts(lessons::Interaction::pointer) || !isFinite(at))
        return;
    m_pointerDown = isDown ? std::optional(at) : std::nullopt;
    m_editor.edit({tr("Move pointer"), tr("the pointer"), QStringLiteral(":pointer"), tr("the pointer")},
                  [&](sim::Timeline &timeline) {
                      return timeline.applyInput(sim::Pointer{at, isDown});
                  });
    if (!isDown)
        m_editor.endGesture();
}

void UserInput::setTarget(sim::Vec2 target)
{
    if (!m_run.step().accepts(lessons::Interaction::target) || !isFinite(target))
        return;
    m_editor.edit({tr("Set target"), tr("the target"), {}, tr("the target")},
                  [&](sim::Timeline &timeline) { return timeline.applyInput(sim::Target{target}); });
}

void UserInput::setKey(bool sim::Keys::*key, bool isDown)
{
    if (!m_run.step().accepts(lessons::Interaction::keys) || m_keys.*key == isDown)
        return;
    m_keys.*key = isDown;
    m_editor.edit({tr("Press arrow keys"), tr("the keys"), QStringLiteral(":keys"), tr("the keys")},
                  [&](sim::Timeline &timeline) {
                      return timeline.applyInput(sim::Key{key, isDown});
                  });
    if (m_keys == sim::Keys{})
        m_editor.endGesture();
}

void UserInput::releaseAll()
{
    const ChangeNotifier::Batch batch(m_run.changes());
    release();
    for (const auto key : {&sim::Keys::left, &sim::Keys::right, &sim::Keys::up, &sim::Keys::down})
        setKey(key, false);
    if (m_pointerDown)
        setPointer(*m_pointerDown, false);
}

void UserInput::forget()
{
    m_isHolding = false;
    m_keys = {};
    m_pointerDown.reset();
}

std::optional<sim::Vec2> UserInput::recordedPointer() const
{
    if (!m_preview.isActive() && (isActive() || m_run.timeline().hasPendingInput()))
        return {};
    const sim::State &now = m_preview.run().state();
    if (now.hold.point >= 0)
        return now.positionOf(now.hold.point);
    return now.input.pointerDown ? now.input.pointer : std::nullopt;
}

}
