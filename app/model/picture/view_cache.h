#pragma once

#include "app/model/session/picture.h"
#include "lessons/api/step.h"
#include "lessons/api/view/view.h"
#include "sim/run/timeline.h"

#include <deque>
#include <memory>

namespace app {

/// A cache of scene views, each made once: for the run, its comparison run, its companion, and the result of an
/// edit.
class ViewCache
{
public:
    /// Returns the view of `interval`, which belongs to a run of `script` in `step`.
    std::shared_ptr<const lessons::View> of(const lessons::Step &step, const sim::Script &script,
                                            const std::shared_ptr<const sim::ComposedInterval> &interval);

private:
    struct Made
    {
        std::weak_ptr<const sim::ComposedInterval> interval;
        std::shared_ptr<const lessons::View> view;
    };

    std::deque<Made> m_made; ///< the most recent ones
};

}
