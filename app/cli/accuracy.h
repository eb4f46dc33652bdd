#pragma once

#include <QString>

#include <cstdint>
#include <optional>

namespace app {

/// What `springstep accuracy` is asked.
struct AccuracyRequest
{
    QString what; ///< a file, or LESSON/STEP
    bool asJson = false;
    QString svg;                        ///< the picture to write; empty for none
    std::optional<double> tolerance;    ///< px: which is the cheapest way within it
    std::optional<std::int64_t> frames; ///< how many to study; else the file's, up to mostOwnFrames, or 200
};

constexpr std::int64_t mostStudied = 10'000;
/// A file's `frames` are for `trace`; more than these take long, and tell little more.
constexpr std::int64_t mostOwnFrames = 1000;

/// `springstep accuracy`: what error each method makes on a scene, and what it costs. Returns the exit code.
int accuracy(const AccuracyRequest &request);

}
