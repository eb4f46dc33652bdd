#pragma once

#include "sim/base/direction.h"
#include "sim/effects/effect_description.h"
#include "sim/effects/pairs/links.h"
#include "sim/effects/pairs/pair_jacobian.h"
#include "sim/scene/rest_target.h"

#include <limits>
#include <memory>
#include <utility>

namespace sim {

/// What the mover of a pair feels, and how far the two are apart.
struct PairPull
{
    Vec2 pull; ///< px/frame^2, for mass 1
    /// px. Infinite where the pull needs no direction: points in one place are then nothing special.
    double length = std::numeric_limits<double>::infinity();
};

/// A force between two points, made from its law. A Law is a value with:
///
///   struct Numbers                                 what a pair has of its own (stiffness, length, ...); equal by ==
///   static constexpr bool isSymmetric                 whether a pair turned round has the exactly opposite pull
///   Pull pull(mover, anchor, numbers) const        from two places, px
///   Vec2 pullWhenCoincident(out, numbers) const        of two points in one place, which part along `out`
///   Vec2 published(mover, anchor, numbers) const   as the tutorials compute it
///   Slope jacobian(mover, anchor, numbers) const      how that changes with the mover's place; the anchor's is opposite
///   double energy(mover, anchor, numbers) const    what a pair has stored; see Force::energy()
///   std::vector<Live> live(mover, anchor, out, numbers, directions) const   the numbers of the shown code; "pull" last
///   std::vector<Region> regions(directions) const  the shown code
///   bool isIdle(numbers) const                     whether it neither pulls nor pushes, wherever the points are
///
/// and, where its numbers change with the state, `Numbers now(state, numbers) const`; where it holds points,
/// `RestTarget rest(state, pair, numbers) const`: where the mover of a pair would be at rest; and where a learner can build
/// it as springs of stiffness Numbers::k, `double restLength(numbers) const`. Its source file instantiates
/// PairForce<Law> from pair_kernels.h, so that its loops are compiled with the options of this library.
template <class Law>
class PairForce : public Force
{
public:
    using Numbers = typename Law::Numbers;

    /// `links`: in the order in which each point's pulls are added up; Pair::number is an index into `numbers`.
    PairForce(Law law, std::vector<PointPair> links, std::vector<Numbers> numbers);

    std::vector<Region> regions(DirectionRule directionRule) const override;
    bool isIdle() const override;
    int count(const State &state, PointRange points) const override;
    Dependence dependence() const override { return Dependence::coupledPoints; }
    void addCouplings(std::vector<Coupling> &into) const override;
    /// With DirectionRule::published each link on its own, mover after mover. Else each pair once, in the order of the list.
    void add(const State &state, PointRange movers, double scale, DirectionRule directionRule,
             Eigen::ArrayX2d &into) const override;
    AccelerationAdder adderFor(const std::vector<PointRange> &ranges) const override;
    bool addJacobian(const State &state, PointRange movers, double scale, DirectionRule directionRule,
                     Jacobian &jacobian) const override;
    /// None where a pair pulls one end only of two that can feel: it has no potential.
    std::optional<double> potentialEnergy(const State &state) const override;
    bool conservesMomentum(const State &state) const override;
    std::vector<LiveValue> explain(const State &state, int mover, DirectionRule directionRule) const override;
    void addRestTargets(const State &state, std::vector<RestTarget> &into) const override;
    bool addToDraft(BlueprintDraft &draft) const override;

    const Law &law() const { return m_law; }
    /// One for all links, or one a link.
    const std::vector<Numbers> &numbers() const { return m_numbers; }
    /// Ordered by mover.
    const std::vector<PointPair> &links() const { return m_links.links(); }
    /// What a pair has of its own in `state`.
    Numbers now(const State &state, int number) const
    {
        if constexpr (requires { m_law.now(state, of(number)); })
            return m_law.now(state, of(number));
        else
            return of(number);
    }

private:
    /// The pairs of a part, with the numbers of each where they are not all the same.
    struct NumberedList : PairList
    {
        std::vector<Numbers> numbers;
    };

    const Numbers &of(int number) const { return m_numbers[static_cast<std::size_t>(number)]; }
    template <class Visit>
    void forEach(const State &state, PointRange movers, Visit &&visit) const;
    Vec2 pullOf(const State &state, const PointPair &pair) const;
    std::shared_ptr<const NumberedList> listOf(const std::vector<PointRange> &ranges) const;
    void addList(const NumberedList &list, const State &state, Eigen::ArrayX2d &into) const;

    Law m_law;
    std::vector<Numbers> m_numbers;
    Links m_links;
    std::shared_ptr<const NumberedList> m_all; ///< all pairs
};

}
