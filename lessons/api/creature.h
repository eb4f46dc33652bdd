#pragma once

#include "sim/scenes/creatures.h"

/// Brings the creature builders of sim/scenes into the namespace of the lessons, so that shown code stays
/// short.
namespace lessons {

using scenes::add;
using scenes::bodyWidth;
using scenes::creature;
using scenes::creatureOnHandle;
using scenes::crowd;
using scenes::crowdByParts;
using scenes::footWidth;
using scenes::halfWidths;
using scenes::isBody;
using scenes::pair;
using scenes::pairOnHandle;
using scenes::placeFeet;
using scenes::singleFoot;

}
