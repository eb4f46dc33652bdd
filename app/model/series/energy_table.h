#pragma once

#include "app/model/series/energy_series.h"

#include <QByteArray>

namespace app {

// Exports the balances of a run as comma-separated text, with one row per frame and one column per account. Empty if
// nothing is counted.

/// Returns the stored energies (kinetic, from height, in springs), the energy that each account has added since the
/// start, and the error estimates.
QByteArray energyTable(const EnergySeries &series);
/// Returns the momentum, and the momentum that each account has added, to the right and down.
QByteArray momentumTable(const EnergySeries &series);

}
