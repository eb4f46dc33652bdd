#pragma once

#include "app/model/run/companion_run.h"
#include "app/model/session/preview.h"

#include <QObject>

#include <optional>

namespace app {

/// Keeps the companion run of a step, if the step has one, at the moment that is shown.
class CompanionFollower : public QObject
{
public:
    CompanionFollower(OpenRun &run, const Preview &preview) : m_run(run), m_preview(preview) {}

    /// Starts the companion run of the open step.
    void open();
    /// Computes the companion run towards the shown moment, for some milliseconds. Returns whether it is there.
    bool follow();
    /// Calls follow() now, and again while the window is idle until the run is there. Announces ChangeKind::cursor each
    /// time.
    void followSoon();
    /// Returns whether the companion run is at the shown moment.
    bool isThere() const { return m_isThere; }
    /// Returns whether the next slice of computing is scheduled.
    bool isComing() const { return m_isDue; }
    /// Returns the companion run, or null if the step has none or its method cannot compute the scene.
    const sim::Track *track() const { return m_companion ? m_companion->track() : nullptr; }

private:
    OpenRun &m_run;
    const Preview &m_preview;
    std::optional<CompanionRun> m_companion;
    bool m_isThere = false;
    bool m_isDue = false;
};

}
