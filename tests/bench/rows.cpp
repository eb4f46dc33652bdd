#include "tests/bench/rows.h"

#include "tests/bench/peers/creature_in_air.h"

namespace bench {

namespace {

const char *const byHand = "AVX2 by hand";

std::string withCommas(int number)
{
    const std::string digits = std::to_string(number);
    std::string text;
    for (std::size_t i = 0; i < digits.size(); ++i) {
        if (i > 0 && (digits.size() - i) % 3 == 0)
            text += ',';
        text += digits[i];
    }
    return text;
}

/// Returns the argument at the end of a benchmark's name.
std::string argument(int value)
{
    return std::string("/").append(std::to_string(value));
}

void addCreatures(std::vector<Row> &rows)
{
    for (const int count : {100, 1'000, 10'000}) {
        const std::string size = argument(count);
        rows.push_back({withCommas(count) + " creatures, a frame through scene and pipeline",
                        "creatures" + size, "creatures_limit" + size, byHand, Ratio::oursByTheirs, 1.5,
                        1.25});
    }
    for (const int count : {100, 1'000, 10'000}) {
        const std::string size = argument(count);
        rows.push_back({"the same " + withCommas(count) + " without gravity and walls",
                        "creatures_in_air" + size, "creatures_in_air_loop" + size,
                        "a loop that never had them", Ratio::oursByTheirs, 1.1, 1.0});
    }
    for (const int count : {100, 1'000, 10'000}) {
        const std::string size = argument(count);
        rows.push_back({withCommas(count) + " creatures as built in the sandbox", "creatures_built" + size,
                        "creatures" + size, "the same in a lesson", Ratio::oursByTheirs, 1.1, 1.0});
    }
    rows.push_back({"one creature, a whole frame", "frameSemiImplicit", "", "", Ratio::time, 150.0, 60.0});
    rows.push_back({"the same", "frameSemiImplicit", "plainSemiImplicit", "a plain loop"});
    rows.push_back(
        {"one creature, by the published rule", "framePublished", "plainPublished", "a plain loop"});
}

void addClothAndTrees(std::vector<Row> &rows)
{
    for (const int side : {32, 64, 128, 256}) {
        const std::string size = argument(side), points = std::to_string(side);
        rows.push_back({"cloth of " + points + " x " + points + ", explicit", "clothExplicit" + size,
                        "clothLimit" + size, byHand, Ratio::oursByTheirs, 2.0, 1.5});
    }
    for (const int forks : {7, 11, 15, 19}) {
        const std::string size = argument(forks);
        rows.push_back({"tree of " + withCommas((2 << forks) - 1) + " branches in the wind", "tree" + size,
                        "treeLimit" + size, byHand, Ratio::oursByTheirs, 1.6, 1.3});
    }
}

void addEngines(std::vector<Row> &rows)
{
    struct Engine
    {
        const char *name, *title;
        double atLeast, aim;
    };
    for (const Engine engine : {Engine{"box2d", "Box2D 2.4", 50.0, 100.0},
                                Engine{"chipmunk", "Chipmunk, Debian's, with its assertions", 20.0, 40.0}}) {
        for (const int count : {100, 1'000, 10'000}) {
            const std::string size = argument(count);
            rows.push_back({withCommas(count) + " creatures on the same springs", "creatures" + size,
                            engine.name + size, engine.title, Ratio::theirsByOurs, engine.atLeast,
                            engine.aim});
        }
    }
}

void addBlocks(std::vector<Row> &rows)
{
    for (const int count : {1'000, 10'000, 100'000}) {
        const std::string size = std::to_string(count);
        rows.push_back({withCommas(count) + " creatures, in blocks", "crowd_in_blocks_" + size,
                        "crowd_by_pass_" + size, "pass by pass"});
    }
}

void addThreads(std::vector<Row> &rows)
{
    for (const int count : {1'000, 10'000, 100'000}) {
        const std::string size = std::to_string(count);
        // Below 10,000 there is little to gain, so there is no target.
        const bool asked = count >= 10'000;
        rows.push_back({withCommas(count) + " creatures, two threads, by the clock",
                        "crowd_two_threads_" + size, "crowd_one_thread_" + size, "one thread",
                        Ratio::theirsByOurs, asked ? 1.7 : 0.0, asked ? 1.9 : 0.0});
    }
}

void addSolvers(std::vector<Row> &rows)
{
    for (const auto &[team, title] : {std::pair("odeint", "odeint"), std::pair("cvode", "CVODE")}) {
        for (const double error : air::errors) {
            const std::string exponent = std::to_string(std::lround(std::log10(error)));
            rows.push_back({"a creature in the air, 200 frames within 1e" + exponent + " px",
                            air::nameOf(air::teams.front(), error), air::nameOf(team, error), title,
                            Ratio::theirsByOurs, 1.0, 1.2});
        }
    }
    rows.push_back(
        {"cloth of 64 x 64, k h^2 = 1e6: conjugate gradients", "clothOurs", "clothEigen", "Eigen's"});
    rows.push_back({"the same", "clothOurs", "clothCholesky", "Eigen's sparse Cholesky"});
}

/// The target is 60 pictures a second.
void addDrawing(std::vector<Row> &rows)
{
    constexpr double picture = 1e9 / 60.0; // ns
    rows.push_back(
        {"paint 5,000 points with legs", "paintAllCreatures/833", "", "", Ratio::time, picture, picture});
    rows.push_back({"paint 32,767 branches", "paintWholeTree/14", "", "", Ratio::time, picture, picture});
    constexpr double soon = 0.25e9; // ns
    rows.push_back({"from the start to the first painted frame", "startUp", "", "", Ratio::time, soon, soon});
}

void addHistory(std::vector<Row> &rows)
{
    rows.push_back({"any frame of ten minutes, default budget", "seekAnywhere/18000", "computeStraight/18000",
                    "computed straight"});
    rows.push_back({"the same with 64 KiB of history", "seekTinyBudget/18000", "computeStraight/18000",
                    "computed straight"});
    rows.push_back(
        {"ten minutes with every frame kept", "tenMinutesAllKept", "tenMinutesNoHistory", "with none"});
    rows.push_back({"live values of a body", "liveValues", "playFrame", "a frame played"});
    rows.push_back({"a frame with a body in the hand", "dragFrame", "playFrame", "a frame played"});
}

/// A row for each step whose listing was measured.
void addListings(std::vector<Row> &rows, const Measurements &medians)
{
    static const std::string listing = "listing/";
    for (const auto &[name, median] : medians) {
        if (!name.starts_with(listing))
            continue;
        const std::string step = name.substr(listing.size());
        rows.push_back(
            {"a frame of the listing " + step, name, "listing_compiled/" + step, "the compiled pipeline"});
    }
}

GrowingRow counted(const char *work, const char *name, const char *item, const std::vector<int> &sizes)
{
    GrowingRow row{work, name, item, {}, {}};
    for (const int size : sizes) {
        row.arguments.push_back(std::to_string(size));
        row.sizes.push_back(size);
    }
    return row;
}

/// Returns a row for a square, by the number of points per side.
GrowingRow square(const char *work, const char *name, const std::vector<int> &sides)
{
    GrowingRow row = counted(work, name, "point", sides);
    for (double &size : row.sizes)
        size *= size;
    return row;
}

/// Returns a row for a full tree, by its levels of forks.
GrowingRow tree(const char *work, const char *name, const std::vector<int> &forks)
{
    GrowingRow row = counted(work, name, "branch", forks);
    for (double &size : row.sizes)
        size = std::exp2(size + 1) - 1;
    return row;
}

}

std::vector<Row> allRows(const Measurements &medians)
{
    std::vector<Row> rows;
    addCreatures(rows);
    addClothAndTrees(rows);
    addEngines(rows);
    addBlocks(rows);
    addThreads(rows);
    addSolvers(rows);
    addHistory(rows);
    addDrawing(rows);
    addListings(rows, medians);
    return rows;
}

std::vector<GrowingRow> allGrowingRows()
{
    const std::vector<int> crowd = {100, 1'000, 10'000};
    return {
        counted("creatures", "creatures", "creature", crowd),
        counted("creatures by hand", "creatures_limit", "creature", crowd),
        counted("creatures, Box2D", "box2d", "creature", crowd),
        counted("creatures, Chipmunk", "chipmunk", "creature", crowd),
        square("cloth, explicit", "clothExplicit", {32, 64, 128, 256}),
        square("cloth by hand", "clothLimit", {32, 64, 128, 256}),
        tree("tree in the wind", "tree", {7, 11, 15, 19}),
        tree("tree by hand", "treeLimit", {7, 11, 15, 19}),
        tree("tree by the published formula", "treePublished", {7, 11, 15}),
        tree("tree that swings", "treeThatSwings", {7, 11, 15}),
        counted("seek to any frame of a run", "seekAnywhere", "", {1'000, 18'000, 108'000}),
        counted("compute up to any frame", "computeStraight", "frame of the run", {1'000, 18'000, 108'000}),
        counted("many feet on one body", "feetOnOneBody", "foot", {10, 100, 1'000, 10'000}),
        counted("a chain of sticks", "chain", "stick", {10, 100, 1'000}),
        square("stiff cloth, backward Euler", "clothImplicit", {16, 32, 64}),
        counted("creatures within 1e-6 px, rkn86", "exactCreatures", "creature", {1, 10, 100}),
        counted("creatures in a room within 0.001 px, rkn86", "exactCrowd", "creature", {1, 10, 100}),
        counted("paint creatures", "paintAllCreatures", "creature", {1, 80, 200, 833, 10'000, 100'000}),
        tree("paint a tree", "paintWholeTree", {7, 11, 12, 13, 14, 16}),
    };
}

}
