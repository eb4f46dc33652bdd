#pragma once

#include "sim/analysis/accuracy/study.h"

#include <QString>
#include <QStringList>

namespace app {

// Texts about an accuracy study.

/// Returns a length in px as text: "3.7\u2009px", "2.1·10⁻¹¹\u2009px".
QString pixels(double px);
/// Returns a time, given in ns, as text in µs, the unit of all measured times: "0.15\u2009µs", "1300\u2009µs".
QString duration(double ns);
/// Returns a method with its step or tolerance: "RK4, step 1/4 frame"; "Dormand–Prince 5(4), tolerance
/// 0.05\u2009px".
QString setupTitle(const sim::MethodSetup &setup);
QString methodTitle(const sim::Method &method);

/// Returns everything known about a row, one fact per line.
QString rowWords(const sim::AccuracyRow &row);

/// Returns the cost of staying within `target` px, and how the setup in use compares. `inUse` is null if that setup
/// was not measured. Key values are marked with <b>.
QString verdictOn(const sim::Accuracy &accuracy, double target, const sim::AccuracyRow *inUse);

/// Returns what else a learner needs to know to read the plot. Examples are a horizon, no continuous limit, a noisy
/// machine, and methods that do not fit.
QStringList remarksOn(const sim::Accuracy &accuracy);

/// Returns which methods are unstable, at all steps or only at large ones. Empty if all are stable.
QString unstableWords(const sim::Accuracy &accuracy);

/// A method's measured order between two neighbouring step sizes: the slope of log error against log step. Only
/// methods with a fixed step have slopes, listed from coarse to fine. Rows without an error are omitted, and so are
/// errors no larger than the reference's own uncertainty.
struct Slope
{
    const sim::AccuracyRow *coarse = nullptr;
    const sim::AccuracyRow *fine = nullptr;
    double order = 0.0;
};
std::vector<Slope> slopesOf(const sim::Accuracy &accuracy, const sim::Method &method);

}
