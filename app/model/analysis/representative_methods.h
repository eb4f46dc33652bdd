#pragma once

#include "sim/analysis/accuracy/study.h"
#include "sim/pipeline/method.h"

#include <set>
#include <string>
#include <vector>

namespace app {

/// Returns the ids of the methods for a beginner to compare: `own`, the method of the step, then the cheapest method
/// with an error below `target` px, then the most accurate one. A duplicate is replaced by the next most accurate
/// method of another order. Methods without measurements are left out, except `own`.
std::vector<std::string> representativeMethods(const sim::Accuracy &accuracy, const std::string &own,
                                               double target);

/// The largest number of these methods.
constexpr std::size_t mostRepresentative = 3;

/// The methods that plots of a study show.
struct ShownMethods
{
    bool areAll = true;
    std::set<std::string> ids = {}; ///< the ids, if not all methods are shown

    bool has(const sim::Method &method) const { return areAll || ids.count(method.id()) > 0; }
    friend bool operator==(const ShownMethods &, const ShownMethods &) = default;
};

}
