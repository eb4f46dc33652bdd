#pragma once

#include "sim/scenes/creatures.h"

/// The builders of creatures from sim/scenes, which lessons call without the name of that library.
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
using scenes::loneFoot;
using scenes::pair;
using scenes::pairOnHandle;
using scenes::placeFeet;

}
