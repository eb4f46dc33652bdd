#pragma once

#include "sim/effect.h"

#include <vector>

namespace sim {

/// One directed link: `mover` is pulled, `anchor` is what it is pulled to (or by).
struct Link
{
    int mover = 0;
    int anchor = 0;
    friend bool operator==(const Link &, const Link &) = default;
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

/// Which links a call takes.
enum class Take {
    movers, ///< those of the movers it is given, as Force::add() does
    part,   ///< those of a part, as Force::addPart() does
};

/// One of the two rows of points of a run.
struct LinkEnds
{
    int first = 0; ///< of the first link
    int step = 0;  ///< from one link to the next, 0 or 1
};

/// Links as runs. Each of the lists holds every link once.
class LinkRuns
{
public:
    /// `links`: ordered by mover.
    explicit LinkRuns(const std::vector<Link> &links);

    /// All links, those that answer each other together where the order of each point's pulls allows it.
    const std::vector<Stroke> &strokes() const { return m_strokes; }

    /// Calls `visit(stroke)` for the links of `movers`.
    template <class Visit>
    void forEach(Points movers, Visit &&visit) const
    {
        if (areAll(movers)) {
            for (const Stroke &stroke : m_strokes)
                visit(stroke);
            return;
        }
        for (auto band = from(movers.first); band != m_bands.end() && band->movers.first < movers.end();
             ++band) {
            for (const LinkRun &run : band->runs)
                visit(Stroke{clipped(run, {run.mover, run.moverStep}, movers), false});
        }
    }

    /// The same in parts that are taken in ascending order: calls `visit(stroke)` for the links between points of
    /// `part` and points of it or of earlier ones.
    template <class Visit>
    void forEachPart(Points part, Visit &&visit) const
    {
        if (m_parts.empty()) {
            forEach(part, visit); // the order of some point's pulls does not allow it
            return;
        }
        for (auto one = partFrom(part.first); one != m_parts.end() && one->high.first < part.end(); ++one) {
            const LinkRun run = clipped(one->stroke.run, one->high, part);
            if (run.count > 0)
                visit(Stroke{run, one->stroke.bothWays});
        }
    }

private:
    struct Part
    {
        Stroke stroke;
        LinkEnds high;
    };

    /// Whether `movers` are all points that any link moves.
    bool areAll(Points movers) const
    {
        return m_bands.empty() ||
               (movers.first <= m_bands.front().movers.first && movers.end() >= m_bands.back().movers.end());
    }
    std::vector<LinkBand>::const_iterator from(int point) const;
    std::vector<Part>::const_iterator partFrom(int point) const;
    /// What is left of `run` where its ends `end` are among `points`.
    static LinkRun clipped(const LinkRun &run, LinkEnds end, Points points);
    std::vector<Part> partsOf(const std::vector<Link> &links) const;

    std::vector<LinkBand> m_bands; ///< in the order of their movers
    std::vector<Stroke> m_strokes;
    std::vector<Part> m_parts; ///< the strokes in the order of their high ends; empty where that will not do
};

}
