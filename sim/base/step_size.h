#pragma once

namespace sim {

/// The step of a run: a length, or for adaptive methods the error that each of their own steps may make. Rows are
/// what is kept and written: one a frame, or one a step when that is longer.
struct StepSize
{
    double h = 1.0;          ///< frames; for adaptive methods one row
    int stepsPerOutput = 1;  ///< steps a row: n for h = 1/n
    int framesPerOutput = 1; ///< frames a row: h itself when it is whole
    double tolerance = 0.0;  ///< px (or degrees) a step; 0: steps have length h

    /// @throws Error "step-size" (h) unless 1/h or h is whole (to 1e-9) and h is from 1e-6 to 100
    static StepSize ofLength(double h);
    /// @throws Error "tolerance" (tolerance) unless it is from 1e-13 to 100 px
    static StepSize withTolerance(double tolerance);
    bool isAdaptive() const { return tolerance > 0.0; }
    friend bool operator==(const StepSize &, const StepSize &) = default;
};

}
