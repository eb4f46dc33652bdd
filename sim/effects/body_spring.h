#pragma once

#include "sim/effects/links.h"

namespace sim {

/// Springs from points to other points, wherever those are.
class BodySpring : public Force
{
public:
    /// k in 1/frame^2.
    BodySpring(std::vector<Link> links, double k) : m_links(std::move(links)), m_k(k) {}

    std::string id() const override { return "body_spring"; }
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
    bool balances(const State &state) const override;
    std::vector<Live> explain(const State &state, int mover, Directions directions) const override;

    const std::vector<Link> &links() const { return m_links.list(); }
    double k() const { return m_k; }

private:
    Links m_links;
    double m_k;
};

}
