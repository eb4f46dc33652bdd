#pragma once

#include "sim/effects/radial_spring.h"
#include "sim/resting.h"

#include <vector>

namespace sim {

/// A spring of its own between two points, both of which feel it.
struct Spring
{
    int a = 0;
    int b = 0;
    double k = 0.0;      ///< mass/frame^2
    double length = 0.0; ///< px, at which it neither pulls nor pushes
    friend bool operator==(const Spring &, const Spring &) = default;
};

/// Springs of which each has its own stiffness and its own length: radial springs that pull both ends.
class Springs : public Force, public Resting
{
public:
    /// @throws Error "spring-without-end" (spring, end, points) when a spring ends at a point that is not there
    Springs(std::vector<Spring> springs, int points);

    std::string id() const override { return "springs"; }
    std::string title() const override { return SIM_TEXT("springs"); }
    Kind kind() const override { return Kind::spring; }
    std::vector<Region> regions(Directions directions) const override;
    int count(const State &state, Points points) const override;
    Sees sees() const override { return Sees::tied; }
    void ties(std::vector<Tie> &into) const override;
    bool idle() const override;
    void add(const State &state, Points movers, double scale, Directions directions,
             Eigen::ArrayX2d &into) const override;
    bool addSlopes(const State &state, Points movers, double scale, Directions directions,
                   Slopes &into) const override;
    std::optional<double> energy(const State &state) const override;
    bool balances(const State &state) const override;
    std::vector<Live> explain(const State &state, int mover, Directions directions) const override;
    void rests(const State &state, std::vector<RestEnd> &into) const override;

    const std::vector<Spring> &list() const { return m_springs; }

private:
    /// A spring as one of its ends sees it.
    struct End
    {
        int mover = 0;
        int anchor = 0;
        double k = 0.0;
        double length = 0.0;
    };
    template <class Visit>
    void forEach(const State &state, Points movers, Visit &&visit) const;
    std::vector<Live> explainEnd(const State &state, const End &end, Directions directions) const;

    std::vector<Spring> m_springs;
    std::vector<End> m_ends; ///< by mover; of one mover in the order of the springs
};

}
