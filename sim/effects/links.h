#pragma once

#include "sim/effects/link_runs.h"
#include "sim/effects/slope.h"

#include <algorithm>
#include <optional>
#include <vector>

namespace sim {

/// Links ordered by mover, and among one mover's in the order given: the order in which its pulls are added up.
class Links
{
public:
    explicit Links(std::vector<Link> links);

    /// Calls `visit(link)` for each link whose mover is in `movers` and feels forces.
    template <class Visit>
    void forEach(const State &state, Points movers, Visit &&visit) const
    {
        const auto before = [](const Link &link, int point) { return link.mover < point; };
        auto link = std::lower_bound(m_links.begin(), m_links.end(), movers.first, before);
        for (; link != m_links.end() && link->mover < movers.end(); ++link) {
            if (state.feels(link->mover))
                visit(*link);
        }
    }

    int count(const State &state, Points movers) const
    {
        int total = 0;
        forEach(state, movers, [&](const Link &) { ++total; });
        return total;
    }

    void ties(std::vector<Tie> &into) const
    {
        for (const Link &link : m_links)
            into.emplace_back(link.mover, link.anchor);
    }

    /// The sum of what links have stored where `potential(link)` is that of one. A pair that pulls both ways stores it
    /// once. Empty where a link pulls one end only of two that can feel: it has no potential.
    template <class Potential>
    std::optional<double> stored(const State &state, Potential &&potential) const
    {
        double sum = 0.0;
        for (std::size_t i = 0; i < m_links.size(); ++i) {
            const Link &link = m_links[i];
            if (!state.feels(link.mover))
                continue;
            if (state.feels(link.anchor) && !m_answered[i])
                return {};
            sum += (state.feels(link.anchor) ? 0.5 : 1.0) * potential(link);
        }
        return sum;
    }

    /// Whether no link that is felt leads to what can feel.
    bool areTied(const State &state) const
    {
        return std::none_of(m_links.begin(), m_links.end(), [&](const Link &link) {
            return state.feels(link.mover) && state.feels(link.anchor);
        });
    }

    /// Whether every link that is felt has another that pulls back as much.
    bool balance(const State &state) const
    {
        for (std::size_t i = 0; i < m_links.size(); ++i) {
            if (state.feels(m_links[i].mover) && !(state.feels(m_links[i].anchor) && m_answered[i]))
                return false;
        }
        return true;
    }

    const LinkRuns &runs() const { return m_runs; }
    const std::vector<Link> &list() const { return m_links; }

private:
    std::vector<Link> m_links;
    LinkRuns m_runs;
    std::vector<char> m_answered; ///< whether as many links go the other way, one entry a link
};

/// Adds `scale * pull(link)` for each link of `movers`, link after link: for pulls that are not computed
/// run by run; see addPullRuns().
template <class Pull>
void addPulls(const Links &links, const State &state, Points movers, double scale, Eigen::ArrayX2d &into,
              Pull &&pull)
{
    links.forEach(state, movers, [&](const Link &link) {
        const Vec2 a = state.inverseMass[link.mover] * pull(link);
        into(link.mover, 0) += scale * a.x;
        into(link.mover, 1) += scale * a.y;
    });
}

/// The same for how pulls change: `slope(link)` is how that of one link changes with the place of its mover; with
/// that of its anchor it changes by the opposite.
template <class SlopeOf>
void addPullSlopes(const Links &links, const State &state, Points movers, double scale, Slopes &into,
                   SlopeOf &&slope)
{
    links.forEach(state, movers, [&](const Link &link) {
        addSlopeBetween(into, link.mover, link.anchor, (scale * state.inverseMass[link.mover]) * slope(link));
    });
}

/// What the links of `mover` compute: every number when it is one link, only the sum when there are several. The
/// last number is what addPulls() adds: a mass takes its share of it.
template <class ExplainLink>
std::vector<Live> explainLinks(const Links &links, const State &state, int mover, ExplainLink &&explainLink)
{
    std::vector<Live> last;
    Vec2 sum;
    int count = 0;
    links.forEach(state, {mover, 1}, [&](const Link &link) {
        last = explainLink(link);
        Vec2 &pull = std::get<Vec2>(last.back().value);
        pull = state.inverseMass[mover] * pull;
        sum = sum + pull;
        ++count;
    });
    if (count > 1)
        return {{"pull", sum}};
    return last;
}

}
