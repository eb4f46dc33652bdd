#pragma once

#include "app/model/picture.h"
#include "lessons/api/step.h"
#include "lessons/api/view/view.h"
#include "sim/run/timeline.h"

#include <deque>
#include <memory>

namespace app {

/// How the bodies of a scene look, made once for each scene: of the run, its ghost, its companion, and what a change has
/// just made.
class LookCache
{
public:
    /// The look of `segment`, which is one of a run of `script` in `step`.
    std::shared_ptr<const lessons::View> of(const lessons::Step &step, const sim::Script &script,
                                            const std::shared_ptr<const sim::ComposedInterval> &interval);

private:
    struct Made
    {
        std::weak_ptr<const sim::ComposedInterval> interval;
        std::shared_ptr<const lessons::View> look;
    };

    std::deque<Made> m_made; ///< the last ones
};

}
