#pragma once

#include "sim/analysis/energy/balance.h"
#include "sim/run/script/script.h"

/// Helpers for the suites of the energy ledger.
namespace energy_support {

struct LedgerTotals
{
    sim::Balance balance;
    double absoluteDrift = 0.0; ///< sum over output steps of the drift's absolute value
};

/// Returns the ledger's totals for the first `frames` frames.
LedgerTotals totalsOf(const sim::Script &script, int frames);
/// Returns the ledger's balance for the first `frames` frames.
sim::Balance balanceOf(const sim::Script &script, int frames);

/// Returns a script with steps of `h` frames. An adaptive method gets a tolerance, see support::stepFor().
sim::Script scriptOf(const sim::Scene &scene, const std::string &method, double h);

/// Adds a column "method" and a row for each method for which `wanted` returns true.
void addMethodRows(bool (*wanted)(const sim::Method &));
bool anyMethod(const sim::Method &method);

}
