#pragma once

#include "app/model/code_symbols.h"

#include <string>
#include <variant>
#include <vector>

namespace app {

/// What a symbol came to over the last rows of a run, the latest last.
struct CodeHistory
{
    struct Sample
    {
        std::int64_t frame =
            0; ///< at the end of the row that computed it; for a parameter, before the row that it holds for
        std::variant<double, sim::Vec2> value;
    };
    std::vector<Sample> samples;

    bool isPair() const
    {
        return !samples.empty() && std::holds_alternative<sim::Vec2>(samples.back().value);
    }
};

constexpr int historyFrames = 120;

/// The history of `symbol` up to the cursor of `run`, for the point called `body`: the rows are computed again, so that
/// nothing is remembered while nobody asks. Of large scenes only as many rows as take some milliseconds; none where the
/// way from the nearest kept state is too far.
CodeHistory historyOf(const CodeSymbol &symbol, const sim::Track &run, const std::string &body);

}
