#include "sim/effects/link_runs.h"

#include <algorithm>
#include <array>
#include <map>

namespace sim {

namespace {

using LinkIt = std::vector<Link>::const_iterator;

LinkIt endOfMover(LinkIt link, LinkIt end)
{
    return std::find_if(link, end, [mover = link->mover](const Link &other) { return other.mover != mover; });
}

/// The links of one mover, those with neighbouring anchors as one run.
std::vector<LinkRun> fan(LinkIt link, LinkIt end)
{
    std::vector<LinkRun> runs;
    for (; link != end; ++link) {
        if (!runs.empty() && runs.back().count < longestRun &&
            runs.back().anchor + runs.back().count == link->anchor)
            ++runs.back().count;
        else
            runs.push_back({link->mover, link->anchor, 1, 0, 1});
    }
    return runs;
}

/// Runs for as many movers from `link` on as have their links alike, one run for each link of a mover.
std::vector<LinkRun> sheet(LinkIt link, LinkIt end)
{
    const LinkIt first = link, firstEnd = endOfMover(link, end);
    const auto each = firstEnd - first;
    std::vector<LinkRun> runs;
    for (LinkIt one = first; one != firstEnd; ++one)
        runs.push_back({one->mover, one->anchor, 1, 1, 1});
    for (link = firstEnd; link != end && runs.front().count < longestRun; link += each) {
        const int count = runs.front().count;
        if (link->mover != first->mover + count || endOfMover(link, end) - link != each)
            break;
        const auto follows = [&](const LinkRun &run) {
            const int step = link[&run - runs.data()].anchor - (run.anchor + run.anchorStep * (count - 1));
            return count == 1 ? step == 0 || step == 1 : step == run.anchorStep;
        };
        if (!std::all_of(runs.begin(), runs.end(), follows))
            break;
        for (std::size_t i = 0; i < runs.size(); ++i) {
            if (count == 1)
                runs[i].anchorStep = link[std::ptrdiff_t(i)].anchor - runs[i].anchor;
            ++runs[i].count;
        }
    }
    return runs;
}

std::vector<LinkBand> bandsOf(const std::vector<Link> &links)
{
    std::vector<LinkBand> bands;
    for (LinkIt link = links.begin(); link != links.end();) {
        const LinkIt next = endOfMover(link, links.end());
        std::vector<LinkRun> alone = fan(link, next), together = sheet(link, links.end());
        const int movers = together.front().count;
        const bool sheets = movers > 1 && together.size() <= static_cast<std::size_t>(movers) * alone.size();
        const int taken = sheets ? movers : 1;
        bands.push_back({{link->mover, taken}, sheets ? std::move(together) : std::move(alone)});
        link += taken * (next - link);
    }
    return bands;
}

/// Whether each link of `run` has the same end higher than the other.
bool leadsOneWay(const LinkRun &run)
{
    const Link first = run.link(0), last = run.link(run.count - 1);
    return (first.mover > first.anchor && last.mover > last.anchor) ||
           (first.mover < first.anchor && last.mover < last.anchor);
}

void addLinks(const Stroke &stroke, std::vector<Link> &into)
{
    for (int i = 0; i < stroke.run.count; ++i)
        into.push_back(stroke.run.link(i));
    for (int i = 0; stroke.bothWays && i < stroke.run.count; ++i)
        into.push_back({stroke.run.link(i).anchor, stroke.run.link(i).mover});
}

/// Whether the links of each mover come in the order of their high ends. `links` are ordered by mover.
bool partsAscend(const std::vector<Link> &links)
{
    const auto high = [](const Link &link) { return std::max(link.mover, link.anchor); };
    return std::adjacent_find(links.begin(), links.end(), [&](const Link &a, const Link &b) {
               return a.mover == b.mover && high(a) > high(b);
           }) == links.end();
}

/// What a run is found by. Steps of a single link say nothing.
using Key = std::array<int, 5>;

Key keyOf(const LinkRun &run)
{
    return {run.mover, run.anchor, run.count, run.count > 1 ? run.moverStep : 0,
            run.count > 1 ? run.anchorStep : 0};
}

Key backKeyOf(const LinkRun &run)
{
    return keyOf({run.anchor, run.mover, run.count, run.anchorStep, run.moverStep});
}

/// Puts the runs of all bands in an order in which each band's come one after the other, and in which a run and the one
/// that answers it are taken together wherever that is possible.
class Order
{
public:
    explicit Order(const std::vector<LinkBand> &bands) : m_bands(bands), m_next(bands.size(), 0)
    {
        for (std::size_t band = bands.size(); band-- > 0;) {
            m_toTry.push_back(band);
            for (const LinkRun &run : bands[band].runs)
                m_bandOf.emplace(keyOf(run), band);
        }
    }

    std::vector<Stroke> strokes()
    {
        while (!m_toTry.empty()) {
            while (!m_toTry.empty()) {
                const std::size_t band = m_toTry.back();
                m_toTry.pop_back();
                while (!done(band) && goOn(band)) {
                }
            }
            // What is left waits for each other, all round: one run of each is taken by itself.
            for (std::size_t band = m_bands.size(); band-- > 0;) {
                if (!done(band)) {
                    take(band, false);
                    m_toTry.push_back(band);
                }
            }
        }
        return std::move(m_strokes);
    }

private:
    bool done(std::size_t band) const { return m_next[band] == m_bands[band].runs.size(); }
    const LinkRun &head(std::size_t band) const { return m_bands[band].runs[m_next[band]]; }

    void take(std::size_t band, bool bothWays)
    {
        m_strokes.push_back({head(band), bothWays});
        pass(band);
    }

    void pass(std::size_t band)
    {
        m_bandOf.erase(keyOf(head(band)));
        ++m_next[band];
    }

    /// Takes the next run of `band`, unless that has to wait for the one that answers it.
    bool goOn(std::size_t band)
    {
        if (headIsChain(band)) {
            takeChain(band);
            return true;
        }
        const auto answer = m_bandOf.find(backKeyOf(head(band)));
        if (answer == m_bandOf.end() || answer->second == band) {
            take(band, false);
            return true;
        }
        const std::size_t other = answer->second;
        if (keyOf(head(other)) != answer->first)
            return false;
        take(band, true);
        pass(other);
        m_toTry.push_back(other);
        return true;
    }

    /// Whether the next run leads from each point to the one before it, and the run after that to the one behind it.
    bool headIsChain(std::size_t band) const
    {
        const std::vector<LinkRun> &runs = m_bands[band].runs;
        if (m_next[band] + 1 >= runs.size())
            return false;
        const LinkRun &down = runs[m_next[band]], &up = runs[m_next[band] + 1];
        const auto isSheet = [](const LinkRun &run) { return run.moverStep == 1 && run.anchorStep == 1; };
        return down.count > 1 && isSheet(down) && isSheet(up) && down.anchor == down.mover - 1 &&
               up.anchor == up.mover + 1;
    }

    /// Both runs of a chain: each link down is answered by the one up from the point below, all but those at the ends.
    /// A point's link down comes first, as a stroke adds what its movers feel before what its anchors feel.
    void takeChain(std::size_t band)
    {
        const LinkRun down = head(band);
        const int last = down.mover + down.count - 1;
        m_strokes.push_back({{down.mover, down.anchor, 1, 1, 1}, false});
        m_strokes.push_back({{down.mover + 1, down.mover, down.count - 1, 1, 1}, true});
        m_strokes.push_back({{last, last + 1, 1, 1, 1}, false});
        pass(band);
        pass(band);
    }

    const std::vector<LinkBand> &m_bands;
    std::vector<std::size_t> m_next;     ///< of each band the first run that is not taken yet
    std::map<Key, std::size_t> m_bandOf; ///< of each run that is not taken yet
    std::vector<std::size_t> m_toTry;    ///< bands, the last one first
    std::vector<Stroke> m_strokes;
};

}

LinkRuns::LinkRuns(const std::vector<Link> &links)
    : m_bands(bandsOf(links)), m_strokes(Order(m_bands).strokes()), m_parts(partsOf(links))
{
}

std::vector<LinkRuns::Part> LinkRuns::partsOf(const std::vector<Link> &links) const
{
    std::vector<Part> parts;
    for (const Stroke &stroke : m_strokes) {
        const LinkRun &run = stroke.run;
        if (!leadsOneWay(run))
            return {};
        const bool up = run.mover > run.anchor;
        parts.push_back(
            {stroke, up ? LinkEnds{run.mover, run.moverStep} : LinkEnds{run.anchor, run.anchorStep}});
    }
    std::stable_sort(parts.begin(), parts.end(),
                     [](const Part &a, const Part &b) { return a.high.first < b.high.first; });
    std::vector<Link> taken;
    for (const Part &part : parts)
        addLinks(part.stroke, taken);
    std::stable_sort(taken.begin(), taken.end(),
                     [](const Link &a, const Link &b) { return a.mover < b.mover; });
    const bool sameOrder = std::equal(taken.begin(), taken.end(), links.begin(), links.end());
    return sameOrder && partsAscend(links) ? parts : std::vector<Part>();
}

std::vector<LinkBand>::const_iterator LinkRuns::from(int point) const
{
    return std::partition_point(m_bands.begin(), m_bands.end(),
                                [point](const LinkBand &band) { return band.movers.end() <= point; });
}

std::vector<LinkRuns::Part>::const_iterator LinkRuns::partFrom(int point) const
{
    return std::partition_point(m_parts.begin(), m_parts.end(),
                                [point](const Part &part) { return part.high.first <= point - longestRun; });
}

LinkRun LinkRuns::clipped(const LinkRun &run, LinkEnds end, Points points)
{
    LinkRun left = run;
    if (end.step == 0) {
        left.count = points.contains(end.first) ? run.count : 0;
        return left;
    }
    const int skipped = std::max(0, points.first - end.first);
    const int over = std::max(0, end.first + run.count - points.end());
    left.mover = run.link(skipped).mover;
    left.anchor = run.link(skipped).anchor;
    left.count = run.count - skipped - over;
    return left;
}

}
