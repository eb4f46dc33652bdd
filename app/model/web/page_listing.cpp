#include "app/model/web/page_listing.h"

#include "app/listing/listing_method.h"
#include "app/model/listing/line_values.h"
#include "app/model/run/run_program.h"
#include "app/model/text/json_writer.h"
#include "sim/run/script/composed_interval.h"

namespace app {

namespace {

constexpr std::size_t memoryOfListing = std::size_t{1} << 20; ///< bytes: the run is never sought back

/// Returns the program that computes a run of `script`, or null.
std::shared_ptr<const listing::Program> programFor(const lessons::Step &step, const sim::Script &script)
{
    if (std::shared_ptr<const listing::Program> own = programOf(script.method))
        return own;
    const bool isOwnMethod =
        script.method->id() == step.method.toStdString() && script.step == sim::StepSize();
    if (step.listing.text.isEmpty() || !isOwnMethod)
        return nullptr;
    return compiledFor(script, step.listing.text).program;
}

}

std::unique_ptr<PageListing> PageListing::of(const lessons::Step &step, const sim::Script &script)
{
    std::shared_ptr<const listing::Program> program = programFor(step, script);
    if (!program)
        return nullptr;
    return std::unique_ptr<PageListing>(new PageListing(std::move(program), script));
}

PageListing::PageListing(std::shared_ptr<const listing::Program> program, const sim::Script &script)
    : m_program(std::move(program))
{
    if (!m_program->remembers() || programOf(script.method))
        return;
    sim::Script own = script;
    own.method = std::make_shared<const listing::ListingMethod>(m_program);
    m_remembered.emplace(std::move(own), memoryOfListing);
}

std::vector<std::byte> PageListing::memoryAt(std::int64_t frame)
{
    m_remembered->seek({frame, 0});
    return m_remembered->state().memory;
}

void PageListing::add(const sim::Track &track, const sim::State &before)
{
    const std::int64_t frame = track.cursor().frame - 1;
    sim::State start = track.stateAfterInput(before, frame);
    if (m_remembered && frame > 0)
        start.memory = memoryAt(frame);
    const ListingFrame traced(m_program, track.interval().scene, start, frame);
    for (const LineChip &chip : valuesAfter(traced, traced.count()).chips) {
        Line &line = m_lines[chip.line];
        if (!line.texts.empty() && line.texts.back() == chip.text)
            continue;
        line.at.push_back(m_count);
        line.texts.push_back(chip.text);
    }
    ++m_count;
}

void PageListing::write(JsonWriter &json) const
{
    json.beginObject("listing");
    json.field("text", m_program->text());
    json.beginList("lines");
    for (const auto &[number, line] : m_lines) {
        json.beginObject(JsonWriter::Layout::oneLine);
        json.field("line", number);
        json.beginList("steps"); // from one text to the next, frames
        std::int64_t last = 0;
        for (const std::int64_t at : line.at) {
            json.value(at - last);
            last = at;
        }
        json.endList();
        json.list("texts", line.texts);
        json.endObject();
    }
    json.endList();
    json.endObject();
}

}
