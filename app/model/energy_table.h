#pragma once

#include "app/model/energy_course.h"

#include <QByteArray>

namespace app {

// What is counted of a run, as comma-separated text: a row each frame, every account a column. Empty while nothing is
// counted.

/// What there is (in what moves, by height, in springs), what each account brought since the start, and by how much
/// that may be off.
QByteArray energyTable(const EnergyCourse &course);
/// The momentum, and what each account brought of it, to the right and down.
QByteArray momentumTable(const EnergyCourse &course);

}
