#pragma once

#include "app/model/telling_methods.h"
#include "app/ui/measure/error_scale.h"
#include "app/ui/measure/spots.h"

#include <QSizeF>

namespace app {

/// Where the rows of a study stand, by what they cost and how far off they are.
struct WorkPrecisionLayout
{
    bool timed = false; ///< costs are µs a frame; before there are times, computations of all forces a frame
    std::vector<Spot> spots;
    double least = 0.01; ///< the range of costs
    double most = 100.0;
    ErrorScale errors;
};

/// What a row costs, as the layout counts it.
double costOf(const sim::AccuracyRow &row, bool timed);

/// How long a frame is on the screen, in µs: the program shows 30 a second.
constexpr double frameOnScreen = 1e6 / 30.0;

/// Lays the rows of `accuracy` that are `shown` out on an area of `size` px. `target` is an error, in px, that is in sight,
/// too. Where not all methods are shown there is room for frameOnScreen.
WorkPrecisionLayout workPrecisionLayout(const sim::Accuracy &accuracy, const ShownMethods &shown,
                                        double target, QSizeF size);

}
