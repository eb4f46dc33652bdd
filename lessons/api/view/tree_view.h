#pragma once

#include "sim/forward.h"

namespace lessons {

struct View;

/// Returns a tree before a dusky sky. A hand takes hold of a branch by name only: the pointer blows.
View treeView(const sim::Tree &tree);

}
