#pragma once

#include "lessons/api/view/view.h"
#include "sim/scene/rest_target.h"
#include "sim/scene/scene.h"

#include <vector>

namespace app {

/// Where a spring or stick would be at rest, as it is drawn: at one of its ends, as seen from the other.
struct RestMark
{
    sim::RestTarget rest;
    sim::EffectKind kind = sim::EffectKind::spring;
};

/// One for each spring and stick of `scene` that has a length. Of two ends that can both move it is at the one that is
/// drawn smaller: where the foot belongs, rather than where the body would have to be.
std::vector<RestMark> restMarks(const sim::Scene &scene, const sim::State &state, const lessons::View &look);
/// Whether anything in `scene` can have a mark.
bool hasRests(const sim::Scene &scene);

}
