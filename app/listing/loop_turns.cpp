#include "app/listing/loop_turns.h"

#include <algorithm>
#include <cstddef>

namespace listing {

namespace {

/// A run of a loop, from its first line to its last.
struct LoopRun
{
    int line = 0;
    int turns = 0;
    bool isInHead = true;
    std::vector<std::pair<std::size_t, std::size_t>> entries; ///< index of a traced line and of its LoopTurn
};

/// The loops of one call that are running, outermost first.
using RunningLoops = std::vector<LoopRun>;

void end(LoopRun &run, std::vector<TracedLine> &lines)
{
    for (const auto &[line, loop] : run.entries)
        lines[line].loops[loop].turns = run.turns;
}

void endFrom(RunningLoops &running, std::size_t first, std::vector<TracedLine> &lines)
{
    while (running.size() > first) {
        end(running.back(), lines);
        running.pop_back();
    }
}

}

void countLoopTurns(std::vector<TracedLine> &lines)
{
    std::vector<RunningLoops> calls; // by depth
    for (std::size_t i = 0; i < lines.size(); ++i) {
        TracedLine &line = lines[i];
        const auto depth = static_cast<std::size_t>(line.depth);
        while (calls.size() > depth + 1) { // calls that have returned
            endFrom(calls.back(), 0, lines);
            calls.pop_back();
        }
        calls.resize(depth + 1);
        RunningLoops &running = calls[depth];
        for (std::size_t j = 0; j < line.loops.size(); ++j) {
            if (j < running.size() && running[j].line != line.loops[j].line)
                endFrom(running, j, lines);
            if (j >= running.size())
                running.push_back({line.loops[j].line, 0, true, {}});
            LoopRun &run = running[j];
            const bool isInBody = line.loops[j].turn > 0;
            if (isInBody && run.isInHead)
                ++run.turns;
            run.isInHead = !isInBody;
            line.loops[j].turn = run.turns;
            run.entries.push_back({i, j});
            if (!isInBody)
                endFrom(running, j + 1, lines);
        }
        endFrom(running, line.loops.size(), lines);
    }
    for (RunningLoops &running : calls)
        endFrom(running, 0, lines);
    for (TracedLine &line : lines)
        std::erase_if(line.loops, [](const LoopTurn &loop) { return loop.turn == 0; });
}

}
