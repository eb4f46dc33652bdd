#pragma once

#include "lessons/api/step.h"
#include "lessons/api/view/view.h"
#include "sim/run/script/composed_interval.h"
#include "sim/run/script/composed_intervals.h"

#include <memory>
#include <vector>

namespace app {

/// What there is to draw of one run at one moment.
struct Picture
{
    std::shared_ptr<const sim::ComposedInterval> interval;
    sim::State state;
    std::shared_ptr<const lessons::View> view; ///< one and the same for all states of a segment
    std::vector<lessons::Overlay> overlays;
};

}
