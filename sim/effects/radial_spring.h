#pragma once

#include "sim/effects/links.h"
#include "sim/effects/spring.h"
#include "sim/resting.h"

namespace sim {

/// A radial spring's pull, with what it was found from.
struct RadialPull
{
    Vec2 from;      ///< px, the anchor seen from which the mover lies along `heading`
    Vec2 target;    ///< px
    SpringPull end; ///< the plain spring to that target
};

/// A spring to the nearest place that is `radius` pixels away from `anchor`, in the direction in which `mover`
/// already is. `direction(d)` gives it. k in 1/frame^2.
/// Published: Creatures I, step 7.
// Shown lines are short.
// clang-format off
template <class HeadingOf>
//! [radial_spring]
RadialPull radialSpring(
    Vec2 mover, Vec2 anchor, double k,
    double radius, HeadingOf direction)
{
    Vec2 from = mover - anchor;
    Vec2 out = direction(from);
    Vec2 reach = radius * out;
    Vec2 target = anchor + reach;
    auto end = spring(mover, target, k);
    return {from, target, end};
}
//! [radial_spring]
// clang-format on

/// Springs that keep points at a distance from other points, in whatever direction they are.
class RadialSpring : public Force, public Resting
{
public:
    /// k in 1/frame^2, radius (the rest length) in px.
    RadialSpring(std::vector<Link> links, double k, double radius)
        : m_links(std::move(links)), m_k(k), m_radius(radius)
    {
    }

    std::string id() const override { return "radial_spring"; }
    std::string title() const override { return SIM_TEXT("springs"); }
    Kind kind() const override { return Kind::spring; }
    std::vector<Region> regions(Directions directions) const override;
    int count(const State &state, Points points) const override { return m_links.count(state, points); }
    Sees sees() const override { return Sees::tied; }
    void ties(std::vector<Tie> &into) const override { m_links.ties(into); }
    bool idle() const override { return m_k == 0.0; }
    void add(const State &state, Points movers, double scale, Directions directions,
             Eigen::ArrayX2d &into) const override;
    void addPart(const State &state, Points part, double scale, Directions directions,
                 Eigen::ArrayX2d &into) const override;
    bool addSlopes(const State &state, Points movers, double scale, Directions directions,
                   Slopes &into) const override;
    std::optional<double> energy(const State &state) const override;
    bool balances(const State &state) const override;
    std::vector<Live> explain(const State &state, int mover, Directions directions) const override;
    void rests(const State &state, std::vector<RestEnd> &into) const override;

    const std::vector<Link> &links() const { return m_links.list(); }
    double k() const { return m_k; }
    double radius() const { return m_radius; }

private:
    template <class HeadingOf>
    Vec2 pullOf(const State &state, const Link &link, HeadingOf direction) const;
    void addRuns(Take take, const State &state, Points points, double scale, Eigen::ArrayX2d &into) const;

    Links m_links;
    double m_k;
    double m_radius;
};

}
