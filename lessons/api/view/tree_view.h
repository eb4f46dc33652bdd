#pragma once

#include "sim/forward.h"

namespace lessons {

struct View;

/// Returns a view of a tree against a dusky sky. The pointer cannot drag its branches, because it makes the
/// wind; files can drag them by name.
View treeView(const sim::Tree &tree);

}
