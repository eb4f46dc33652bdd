#pragma once

#include "app/model/session/open_run.h"
#include "app/model/session/preview.h"
#include "sim/scene/state.h"

#include <QObject>

#include <optional>

namespace app {

class RunEditor;

/// What the user does in the scene while the run goes on: dragging bodies, moving the pointer, setting targets and
/// pressing keys. It becomes part of the run at the cursor.
class UserInput : public QObject
{
    Q_OBJECT

public:
    UserInput(OpenRun &run, const Preview &preview, RunEditor &editor)
        : m_run(run), m_preview(preview), m_editor(editor)
    {
    }

    /// Makes `body` the one whose values are shown.
    void select(const QString &body) { m_run.select(body); }
    /// Takes hold of a body and selects it. A name that does not exist changes nothing.
    void grab(const QString &body);
    /// Drags the held body to `to`, px.
    void moveTo(sim::Vec2 to);
    void release();
    bool isHolding() const { return m_isHolding; }

    // Steps that do not accept these (see lessons::Interaction) ignore them. Positions are in px.
    void setPointer(sim::Vec2 at, bool isDown);
    void setTarget(sim::Vec2 target);
    void setKey(bool sim::Keys::*key, bool isDown);

    /// Returns whether the user holds a body or has the pointer's button down.
    bool isActive() const { return m_isHolding || m_pointerDown.has_value(); }
    /// Releases the body, all keys and the pointer's button, as when the window loses the focus.
    void releaseAll();
    /// Forgets what is held, because the run is replaced by one in which it is not.
    void forget();
    /// Returns where recorded input holds a body or has the pointer's button down at the moment shown, px. Empty if it
    /// does not, and while the user does so now.
    std::optional<sim::Vec2> recordedPointer() const;

private:
    OpenRun &m_run;
    const Preview &m_preview;
    RunEditor &m_editor;
    bool m_isHolding = false;
    sim::Keys m_keys;                       ///< those that the user holds down
    std::optional<sim::Vec2> m_pointerDown; ///< where the user has the pointer's button down
};

}
