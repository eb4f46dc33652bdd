#pragma once

#include "app/model/code/code_symbols.h"

#include <string>
#include <variant>
#include <vector>

namespace app {

/// The values of a symbol over the last output steps of a run, oldest first.
struct CodeHistory
{
    struct Sample
    {
        std::int64_t frame =
            0; ///< end of the output step that computed the value; for a parameter, start of the step that used it
        std::variant<double, sim::Vec2> value;
    };
    std::vector<Sample> samples;

    bool isPair() const
    {
        return !samples.empty() && std::holds_alternative<sim::Vec2>(samples.back().value);
    }
};

constexpr int historyFrames = 120;

/// Returns the history of `symbol` up to the cursor of `run`, for the point called `body`. The output steps are
/// computed again on request, so nothing is stored in between. For large scenes the history covers only as many steps
/// as take a few milliseconds. It is empty if the nearest keyframe is too far away.
CodeHistory historyOf(const CodeSymbol &symbol, const sim::Track &run, const std::string &body);

}
