#pragma once

#include "sim/analysis/accuracy/study.h"
#include "sim/pipeline/method.h"

#include <set>
#include <string>
#include <vector>

namespace app {

/// Returns the ids of the methods that a beginner compares, the first of them `own`, the method of the step: then the
/// cheapest one that stays within `target` px, and the most exact one. Where these are the same, the next most exact one
/// of another order takes the place. Methods that were not measured are left out, other than `own`.
std::vector<std::string> tellingMethods(const sim::Accuracy &accuracy, const std::string &own, double target);

/// How many those are at most.
constexpr std::size_t mostTelling = 3;

/// The methods that plots of a study show.
struct ShownMethods
{
    bool areAll = true;
    std::set<std::string> ids = {}; ///< those, where not all are shown

    bool has(const sim::Method &method) const { return areAll || ids.count(method.id()) > 0; }
    friend bool operator==(const ShownMethods &, const ShownMethods &) = default;
};

}
