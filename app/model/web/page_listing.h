#pragma once

#include "app/listing/program.h"
#include "lessons/api/step.h"
#include "sim/run/track.h"

#include <QString>

#include <map>
#include <memory>
#include <optional>
#include <vector>

namespace app {

class JsonWriter;

/// The listing that computes a run, with the values that each frame has left at its lines.
class PageListing
{
public:
    /// Returns the listing of a run of `step`: the program that is its method, or the step's listing if the step's own
    /// method computes the run. Null if there is none.
    static std::unique_ptr<PageListing> of(const lessons::Step &step, const sim::Script &script);

    /// Adds a frame without values: the first one of a run.
    void addEmpty() { ++m_count; }
    /// Adds the frame that ends at the cursor of `track`. `before` is the state one frame earlier.
    void add(const sim::Track &track, const sim::State &before);

    void write(JsonWriter &json) const;

private:
    /// The texts beside one line. Each stays until the next one.
    struct Line
    {
        std::vector<std::int64_t> at; ///< indices of frames
        std::vector<QString> texts;
    };

    PageListing(std::shared_ptr<const listing::Program> program, const sim::Script &script);
    /// Returns the variables that the listing remembers at `frame` of a run that another method computes.
    std::vector<std::byte> memoryAt(std::int64_t frame);

    std::shared_ptr<const listing::Program> m_program;
    std::optional<sim::Track> m_remembered; ///< a run of the listing; empty if the run itself is one
    std::map<int, Line> m_lines;            ///< by line, from 1
    std::int64_t m_count = 0;
};

}
