#pragma once

#include "sim/effect.h"

namespace sim {

/// The entries of `slopes` without what would push points on where they are pushed already. A spring that is pressed
/// together turns over: across it, its pull grows with the way, and by such slopes a step leads anywhere. In each pull
/// that part is left out, so that with 1 on the diagonal the matrix of an implicit method is positive definite (for
/// pulls between equal masses; for others it is so in the energy that the masses make).
/// Source: Teran et al., "Robust quasistatic finite elements and flesh simulation", 2005, section 5 (the same for
/// elements); Choi and Ko, "Stable but responsive cloth", 2002, section 4.2 (for springs).
std::vector<Slopes::Entry> calmed(const Slopes &slopes, int points);

}
