#pragma once

#include "app/model/analysis/representative_methods.h"
#include "app/ui/accuracy/error_scale.h"
#include "app/ui/plots/spot_plot.h"

#include <QSizeF>

namespace app {

/// The places of a study's rows in the plot of error against time.
struct WorkPrecisionLayout
{
    bool timed = false; ///< costs are µs a frame; before there are times, computations of all forces a frame
    std::vector<Spot> spots;
    double least = 0.01; ///< the range of costs
    double most = 100.0;
    ErrorScale errors;
};

/// Returns the cost of a row: µs a frame if `timed`, otherwise computations of all forces a frame.
double costOf(const sim::AccuracyRow &row, bool timed);

/// The time that a frame is on the screen, in µs: the program shows 30 a second.
constexpr double frameOnScreen = 1e6 / 30.0;

/// Returns the layout of the rows of `accuracy` that are `shown`, on an area of `size` px. The error `target`, in px,
/// is in sight, too, and so is frameOnScreen if it is near the rows and not all methods are shown.
WorkPrecisionLayout workPrecisionLayout(const sim::Accuracy &accuracy, const ShownMethods &shown,
                                        double target, QSizeF size);

}
