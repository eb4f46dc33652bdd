#pragma once

#include "sim/analysis/accuracy/study.h"

#include <QString>
#include <QStringList>

namespace app {

// What a study of accuracy says, in words.

/// "3.7\u2009px", "2.1·10⁻¹¹\u2009px".
QString pixels(double px);
/// Returns nanoseconds in the unit of all times that are measured: "0.15\u2009µs", "1300\u2009µs".
QString duration(double ns);
/// "RK4, step 1/4 frame"; "Dormand–Prince 5(4), tolerance 0.05\u2009px".
QString wayWords(const sim::MethodSetup &setup);
QString methodTitle(const sim::Method &method);

/// All that is known about a row, one thing a line.
QString rowWords(const sim::AccuracyRow &row);

/// What it costs to be within `target` px, and what the way in use (null where it was not measured) does; with
/// <b> round what matters.
QString verdictOn(const sim::Accuracy &accuracy, double target, const sim::AccuracyRow *inUse);

/// What else a learner must know to read the plot: a horizon, no continuous limit, a noisy machine, methods that
/// do not fit.
QStringList remarksOn(const sim::Accuracy &accuracy);

/// Which methods are unstable, at all steps or at big ones; empty where none is.
QString unstableWords(const sim::Accuracy &accuracy);

/// The slope of log error against log step between each two rungs of a method that has steps, from coarse to fine:
/// its measured order. Rungs without an error, and errors as small as what the reference leaves open, are left out.
struct Slope
{
    const sim::AccuracyRow *coarse = nullptr;
    const sim::AccuracyRow *fine = nullptr;
    double order = 0.0;
};
std::vector<Slope> slopesOf(const sim::Accuracy &accuracy, const sim::Method &method);

}
