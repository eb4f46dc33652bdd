#pragma once

#include "sim/effect.h"

#include <vector>

namespace sim {

/// One directed link: `mover` is pulled, `anchor` is what it is pulled to (or by).
struct Link
{
    int mover = 0;
    int anchor = 0;
};

/// So many links are computed in one go: what they come to fits the nearest cache.
constexpr int longestRun = 256;

/// A run of links whose points follow each other in memory. From one link to the next the mover is `moverStep` farther
/// and the anchor `anchorStep`: both 1, or one of them 0.
struct LinkRun
{
    int mover = 0;  ///< of the first link
    int anchor = 0; ///< of the first link
    int count = 0;  ///< 1 to longestRun
    int moverStep = 1;
    int anchorStep = 1;

    Link link(int i) const { return {mover + moverStep * i, anchor + anchorStep * i}; }
};

/// A run, and whether the links that lead the other way (each from its anchor to its mover) are taken with it. What its
/// movers feel is added first, then what its anchors feel.
struct Stroke
{
    LinkRun run;
    bool bothWays = false;
};

/// Neighbouring movers whose links make runs: first the first link of each, then the second of each, and so on; or one
/// mover, whose links make runs one after the other. Either way a point's pulls come in the order of its links.
struct LinkBand
{
    Points movers;
    std::vector<LinkRun> runs;
};

/// Links as runs. Both lists hold every link once.
class LinkRuns
{
public:
    /// `links`: ordered by mover.
    explicit LinkRuns(const std::vector<Link> &links);

    /// Whether `movers` are all points that any link moves.
    bool areAll(Points movers) const
    {
        return m_bands.empty() ||
               (movers.first <= m_bands.front().movers.first && movers.end() >= m_bands.back().movers.end());
    }
    /// All links, those that answer each other together where the order of each point's pulls allows it.
    const std::vector<Stroke> &strokes() const { return m_strokes; }

    /// Calls `visit(run)` for the runs of `movers` only.
    template <class Visit>
    void forEach(Points movers, Visit &&visit) const
    {
        for (auto band = from(movers.first); band != m_bands.end() && band->movers.first < movers.end();
             ++band) {
            for (const LinkRun &run : band->runs)
                visit(run.moverStep == 0 ? run : part(run, movers));
        }
    }

private:
    std::vector<LinkBand>::const_iterator from(int point) const;
    static LinkRun part(const LinkRun &run, Points movers);

    std::vector<LinkBand> m_bands; ///< in the order of their movers
    std::vector<Stroke> m_strokes;
};

}
