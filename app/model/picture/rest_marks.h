#pragma once

#include "lessons/api/view/view.h"
#include "sim/scene/rest_target.h"
#include "sim/scene/scene.h"

#include <vector>

namespace app {

/// The rest position of a spring or stick, drawn at one of its ends as seen from the other.
struct RestMark
{
    sim::RestTarget rest;
    sim::EffectKind kind = sim::EffectKind::spring;
};

/// Returns one mark for each spring and stick of `scene` that has a length. If both ends can move, the mark is at
/// the end that is drawn smaller. It shows where the foot belongs, rather than where the body would have to be.
std::vector<RestMark> restMarks(const sim::Scene &scene, const sim::State &state, const lessons::View &view);
/// Returns whether anything in `scene` can have a mark.
bool hasRests(const sim::Scene &scene);

}
