#pragma once

namespace sim {

/// The step size of a run: a length or, for adaptive methods, the error that each step may make. An output
/// step is what is kept and written: one per frame, or one per step if a step is longer than a frame.
struct StepSize
{
    double h = 1.0;          ///< frames, length of a step; for adaptive methods, of an output step
    int stepsPerOutput = 1;  ///< steps per output step: n for h = 1/n
    int framesPerOutput = 1; ///< frames per output step: h if it is a whole number, else 1
    double tolerance = 0.0;  ///< px (or degrees), error per step; 0: steps have length h

    /// Returns a fixed step size of `h` frames.
    /// @throws Error "step-size" (h) unless h or 1/h is a whole number (to 1e-9) and h is from 1e-6 to 100
    static StepSize ofLength(double h);
    /// Returns an adaptive step size with the error `tolerance` (px or degrees) per step.
    /// @throws Error "tolerance" (tolerance) unless it is from 1e-13 to 100
    static StepSize withTolerance(double tolerance);
    bool isAdaptive() const { return tolerance > 0.0; }
    friend bool operator==(const StepSize &, const StepSize &) = default;
};

}
