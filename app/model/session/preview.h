#pragma once

#include "app/model/session/open_run.h"

#include <functional>
#include <optional>

namespace app {

/// Shows another moment of the run while the pointer is on it in the timeline or in a plot. The run itself does not
/// change.
class Preview
{
public:
    /// `isBusy` returns whether the run is on its way to another moment, so that only marking is possible.
    Preview(OpenRun &run, std::function<bool()> isBusy) : m_run(run), m_isBusy(std::move(isBusy)) {}

    /// Marks the moment `at` and shows it, until end() or the next change. If the run is busy, or the moment would take
    /// long to compute, it is only marked.
    void show(sim::Cursor at);
    /// Marks the moment `at` without showing it.
    void mark(sim::Cursor at);
    void end();
    /// Ends the preview if a moment is shown. A moment that is only marked stays marked.
    void endIfShown();

    const std::optional<sim::Cursor> &marked() const { return m_marked; }
    /// Returns whether another moment than the run's cursor is shown.
    bool isActive() const { return m_shown.has_value(); }
    /// Returns the run at the moment that is shown: the run in use, or a copy of it at the previewed moment.
    const sim::Timeline &run() const { return m_shown ? *m_shown : m_run.timeline(); }

private:
    bool canShow(sim::Cursor at) const;
    void set(sim::Cursor at, std::optional<sim::Timeline> shown);

    OpenRun &m_run;
    std::function<bool()> m_isBusy;
    std::optional<sim::Cursor> m_marked;
    std::optional<sim::Timeline> m_shown; ///< a copy of the run at the previewed moment
};

}
