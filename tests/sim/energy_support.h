#pragma once

#include "sim/analysis/energy/balance.h"
#include "sim/run/script/script.h"

/// What the suites of the ledger share.
namespace energy_bench {

struct Run
{
    sim::Balance sum;
    double drifted = 0.0; ///< the energy's drift, each row's counted as it is without its sign
};

/// The books of the first `frames` frames.
Run accounted(const sim::Script &script, int frames);
sim::Balance balanceOf(const sim::Script &script, int frames);

/// With steps of `h` frames; for an adaptive method see support::stepFor().
sim::Script scriptOf(const sim::Scene &scene, const std::string &method, double h);

/// Rows of a table: the methods that are `wanted`.
void addMethods(bool (*wanted)(const sim::Method &));
bool every(const sim::Method &method);

}
