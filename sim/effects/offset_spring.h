#pragma once

#include "sim/effects/links.h"
#include "sim/resting.h"

namespace sim {

/// A place beside a point. Published: Creatures I, step 6.
// Shown lines are short.
// clang-format off
inline
//! [offset_target]
Vec2 offsetTarget(Vec2 anchor, double offset)
{
    Vec2 target = anchor;
    target.x += offset;
    return target;
}
//! [offset_target]
// clang-format on

/// Springs from points to places that lie `offset` pixels to the right of other points.
class OffsetSpring : public Force, public Resting
{
public:
    /// k in 1/frame^2, offset in px.
    OffsetSpring(std::vector<Link> links, double k, double offset)
        : m_links(std::move(links)), m_k(k), m_offset(offset)
    {
    }

    std::string id() const override { return "offset_spring"; }
    std::string title() const override { return SIM_TEXT("spring"); }
    Kind kind() const override { return Kind::spring; }
    std::vector<Region> regions(Directions directions) const override;
    int count(const State &state, Points points) const override { return m_links.count(state, points); }
    Sees sees() const override { return Sees::tied; }
    void ties(std::vector<Tie> &into) const override { m_links.ties(into); }
    bool idle() const override { return m_k == 0.0; }
    void add(const State &state, Points movers, double scale, Directions directions,
             Eigen::ArrayX2d &into) const override;
    bool addSlopes(const State &state, Points movers, double scale, Directions directions,
                   Slopes &into) const override;
    std::optional<double> energy(const State &state) const override;
    std::vector<Live> explain(const State &state, int mover, Directions directions) const override;
    void rests(const State &state, std::vector<RestEnd> &into) const override;

    const std::vector<Link> &links() const { return m_links.list(); }
    double offset() const { return m_offset; }

private:
    Links m_links;
    double m_k;
    double m_offset;
};

}
