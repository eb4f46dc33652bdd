#include "tests/bench/table.h"

#include <algorithm>
#include <cstdio>
#include <optional>

namespace bench {

namespace {

template <class... Arguments>
std::string format(const char *how, Arguments... arguments)
{
    char text[64];
    std::snprintf(text, sizeof text, how, arguments...);
    return text;
}

/// Returns a number with three digits, or two if it is small.
std::string digits(double value)
{
    if (value < 0.0995)
        return format("%.2g", value);
    const int behind = value >= 99.95 ? 0 : value >= 9.995 ? 1 : 2;
    return format("%.*f", behind, value);
}

std::string time(double nanoseconds)
{
    if (nanoseconds < 1e3)
        return digits(nanoseconds) + " ns";
    if (nanoseconds < 1e6)
        return digits(nanoseconds / 1e3) + " \u00b5s";
    return digits(nanoseconds / 1e6) + " ms";
}

std::string goal(const Row &row, double value)
{
    if (value <= 0.0)
        return "";
    return row.ratio == Ratio::time ? time(value) : format("%gx", value);
}

/// Returns how a figure compares with its target.
std::string verdict(const Row &row, double figure)
{
    if (row.atLeast <= 0.0)
        return "";
    const bool upwards = row.ratio == Ratio::theirsByOurs;
    const auto reaches = [&](double asked) { return upwards ? figure >= asked : figure <= asked; };
    return reaches(row.aim) ? "aim" : reaches(row.atLeast) ? "enough" : "**missed**";
}

using Cells = std::vector<std::string>;

/// Returns the number of terminal columns of a text: its UTF-8 bytes without continuation bytes.
std::size_t widthOf(const std::string &text)
{
    return static_cast<std::size_t>(
        std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xC0) != 0x80; }));
}

/// Returns a Markdown table whose columns are also aligned as plain text. The first line is the head; numbers
/// are right-aligned.
std::string drawn(const std::vector<Cells> &lines, const std::string &alignment)
{
    std::vector<std::size_t> widths(alignment.size(), 4);
    for (const Cells &cells : lines) {
        for (std::size_t i = 0; i < widths.size(); ++i)
            widths[i] = std::max(widths[i], widthOf(cells[i]));
    }
    std::string all;
    for (std::size_t row = 0; row < lines.size(); ++row) {
        all += "|";
        for (std::size_t i = 0; i < widths.size(); ++i) {
            const std::string space(widths[i] - widthOf(lines[row][i]), ' ');
            all.append(" ")
                .append(alignment[i] == 'r' ? space + lines[row][i] : lines[row][i] + space)
                .append(" |");
        }
        all += "\n";
        if (row > 0)
            continue;
        all += "|";
        for (std::size_t i = 0; i < widths.size(); ++i)
            all.append(" ").append(widths[i] - 1, '-').append(alignment[i] == 'r' ? ": |" : "- |");
        all += "\n";
    }
    return all;
}

const QuantityKind *find(const Results &results, const std::string &name)
{
    const auto found = results.medians.find(name);
    return found == results.medians.end() ? nullptr : &found->second;
}

std::optional<Cells> cellsOf(const Row &row, const Results &results)
{
    const QuantityKind *ours = find(results, row.ours);
    if (row.ratio == Ratio::time) {
        if (!ours)
            return {};
        const double figure = ours->nanoseconds;
        return Cells{time(figure),       goal(row, row.atLeast),
                     goal(row, row.aim), verdict(row, figure),
                     row.work,           "ours",
                     time(figure),       ""};
    }
    const QuantityKind *theirs = find(results, row.theirs);
    if (!ours || !theirs)
        return {};
    const bool upwards = row.ratio == Ratio::theirsByOurs;
    const double figure =
        upwards ? theirs->nanoseconds / ours->nanoseconds : ours->nanoseconds / theirs->nanoseconds;
    return Cells{digits(figure) + "x",
                 goal(row, row.atLeast),
                 goal(row, row.aim),
                 verdict(row, figure),
                 row.work,
                 upwards ? row.title + " / ours" : "ours / " + row.title,
                 time(ours->nanoseconds),
                 time(theirs->nanoseconds)};
}

/// Returns the cost of an item at each size, and how the cost grows with the size.
std::optional<Cells> cellsOf(const GrowingRow &row, const Results &results)
{
    const auto growth = results.growths.find(row.name);
    if (growth == results.growths.end())
        return {};
    std::string sizes, costs;
    int measured = 0;
    for (std::size_t i = 0; i < row.sizes.size(); ++i) {
        const QuantityKind *one = find(results, row.name + "/" + row.arguments[i]);
        if (!one)
            continue;
        ++measured;
        sizes += (sizes.empty() ? "" : ", ") + format("%.0f", row.sizes[i]);
        costs += (costs.empty() ? "" : ", ") +
                 time(row.item.empty() ? one->nanoseconds : one->nanoseconds / row.sizes[i]);
    }
    if (measured < 3)
        return {}; // with too few sizes, every function fits
    const std::string as = growth->second.as == "(1)" ? "not at all" : growth->second.as;
    return Cells{as,    format("%.0f %%", 100.0 * growth->second.off), row.work, sizes,
                 costs, row.item.empty() ? "in all" : "a " + row.item};
}

/// Returns the benchmarks that did not run, grouped by reason.
std::string refusals(const Results &results)
{
    std::map<std::string, std::string> names;
    for (const auto &[name, why] : results.refused)
        names[why].append(names[why].empty() ? "" : ", ").append(name);
    std::string all;
    for (const auto &[why, which] : names)
        all.append("\n").append(which).append(" did not run: ").append(why).append("\n");
    return all;
}

std::string machineLine(const Results &results)
{
    const auto of = [&](const char *key) {
        const auto found = results.machine.find(key);
        return found == results.machine.end() ? std::string("?") : found->second;
    };
    return of("processor") + ", " + of("cores") + " cores, " + of("compiler") + "; load " + of("load") +
           " when it began\n";
}

}

std::string table(const Results &results, const std::vector<Row> &rows,
                  const std::vector<GrowingRow> &growing)
{
    std::vector<Cells> lines = {{"ratio", "at least", "aim", "", "work", "of", "ours", "the other"}};
    for (const Row &row : rows) {
        if (const auto cells = cellsOf(row, results))
            lines.push_back(*cells);
    }
    std::vector<Cells> growth = {{"grows as", "off by", "work", "sizes", "cost", ""}};
    for (const GrowingRow &row : growing) {
        if (const auto cells = cellsOf(row, results))
            growth.push_back(*cells);
    }
    std::string all = machineLine(results);
    if (lines.size() > 1)
        all.append("\n").append(drawn(lines, "rrrlllrr"));
    if (growth.size() > 1)
        all.append("\n").append(drawn(growth, "lrllll"));
    return all + refusals(results);
}

}
