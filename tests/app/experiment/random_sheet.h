#pragma once

#include "tests/app/experiment/random_experiment.h"

namespace random_experiments {

/// The text of an experiment on a step. `methods`: the ids of all there are. `wrong`: the share of its things that are
/// past what they can be.
QByteArray sheet(Draw &draw, const Known &known, const QStringList &methods, double wrong);

/// Returns extreme numbers, as text.
const std::vector<QByteArray> &extremes();

}
