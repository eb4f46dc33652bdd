#pragma once

#include "sim/forward.h"

namespace lessons {

struct Look;

/// Returns a tree before a dusky sky. A hand takes hold of a branch by name only: the pointer blows.
Look treeLook(const sim::Tree &tree);

}
