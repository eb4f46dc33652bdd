#pragma once

#include "app/model/series/difference_series.h"

namespace app {

/// Returns the largest difference and its place: "Largest: 12 px apart, foot 3, at frame 97." Otherwise returns why
/// there is no difference to show.
QString differenceSentence(const DifferenceSeries &series);

/// Returns one menu line for a branch: its name, where it departs from the run, and whether it is kept.
QString branchLine(const Branch &branch, const sim::Script &run);

}
