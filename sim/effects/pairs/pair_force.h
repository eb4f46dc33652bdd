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

/// The pull on the mover of a pair, with the distance of the two points.
struct PairPull
{
    Vec2 pull; ///< mass px/frame^2
    /// px, distance of the points. Infinite if the pull needs no direction: coincident points then need no
    /// special case.
    double length = std::numeric_limits<double>::infinity();
};

/// A force between pairs of points, defined by a law. A Law is a value type with these members. Positions are
/// in px.
///
///   struct Numbers
///       The numbers of one pair, such as its stiffness and length. Comparable with ==.
///   static constexpr bool isSymmetric
///       Whether swapping mover and anchor gives exactly the opposite pull.
///   PairPull pull(mover, anchor, numbers) const
///       Returns the pull on the mover.
///   Vec2 pullWhenCoincident(out, numbers) const
///       Returns the pull on the mover if the points coincide. They separate along `out`.
///   Vec2 published(mover, anchor, numbers) const
///       Returns the pull on the mover as the tutorials compute it.
///   PairJacobian jacobian(mover, anchor, numbers) const
///       Returns the derivative of the pull by the position of the mover. By the anchor it is the negative.
///   double energy(mover, anchor, numbers) const
///       Returns the potential energy of the pair; see Force::potentialEnergy().
///   std::vector<LiveValue> liveValues(mover, anchor, out, numbers, directionRule) const
///       Returns the values of the shown code. The last one is "pull".
///   std::vector<Region> regions(directionRule) const
///       Returns the shown code.
///   bool isIdle(numbers) const
///       Returns whether the pull is 0 at all positions.
///
/// These members are optional:
///
///   Numbers currentNumbers(state, numbers) const
///       Returns the numbers in `state`, if they change with the state.
///   RestTarget restTarget(state, pair, numbers) const
///       Returns the rest target of the mover. A force without it adds no rest targets.
///   double restLength(numbers) const
///       Returns the length (px) of a spring of stiffness Numbers::k that expresses the pair in a blueprint.
///
/// The source file of a law instantiates PairForce<Law> from pair_kernels.h, so that its loops are compiled
/// with the options of this library.
template <class Law>
class PairForce : public Force
{
public:
    using Numbers = typename Law::Numbers;

    /// Takes `links` in the order in which the pulls on each point are added. PointPair::index is an index
    /// into `numbers`.
    PairForce(Law law, std::vector<PointPair> links, std::vector<Numbers> numbers);

    std::vector<Region> regions(DirectionRule directionRule) const override;
    bool isIdle() const override;
    int count(const State &state, PointRange points) const override;
    Dependence dependence() const override { return Dependence::coupledPoints; }
    void addCouplings(std::vector<Coupling> &into) const override;
    /// With DirectionRule::published, computes every link separately, sorted by mover. Otherwise computes
    /// each pair once.
    void add(const State &state, PointRange movers, double scale, DirectionRule directionRule,
             Eigen::ArrayX2d &into) const override;
    AccelerationAdder adderFor(const std::vector<PointRange> &ranges) const override;
    bool addJacobian(const State &state, PointRange movers, double scale, DirectionRule directionRule,
                     Jacobian &jacobian) const override;
    /// Returns nothing if a pair pulls only one of two dynamic points: such a force has no potential.
    std::optional<double> potentialEnergy(const State &state) const override;
    bool conservesMomentum(const State &state) const override;
    std::vector<LiveValue> explain(const State &state, int mover, DirectionRule directionRule) const override;
    void addRestTargets(const State &state, std::vector<RestTarget> &into) const override;
    bool addToDraft(BlueprintDraft &draft) const override;

    const Law &law() const { return m_law; }
    /// Returns the numbers that PointPair::index refers to.
    const std::vector<Numbers> &numbers() const { return m_numbers; }
    /// Returns all links, sorted by mover.
    const std::vector<PointPair> &links() const { return m_links.links(); }
    /// Returns the numbers with the given index, with the values that they have in `state`.
    Numbers currentNumbers(const State &state, int index) const
    {
        if constexpr (requires { m_law.currentNumbers(state, storedNumbers(index)); })
            return m_law.currentNumbers(state, storedNumbers(index));
        else
            return storedNumbers(index);
    }

private:
    /// Pairs with their numbers: one entry per pair, or a single entry if all pairs have equal numbers.
    struct NumberedList : PairList
    {
        std::vector<Numbers> numbers;
    };

    const Numbers &storedNumbers(int index) const { return m_numbers[static_cast<std::size_t>(index)]; }
    template <class Visit>
    void forEachLink(const State &state, PointRange movers, Visit &&visit) const;
    /// Returns the pull on the mover of `pair` by the regularised rule, in mass px/frame^2.
    Vec2 pullOf(const State &state, const PointPair &pair) const;
    /// Returns the pairs between points of `ranges`; see Links::batches().
    std::shared_ptr<const NumberedList> listOf(const std::vector<PointRange> &ranges) const;
    /// Adds the accelerations (px/frame^2) that the pairs of `list` cause to the rows of `into`.
    void addList(const NumberedList &list, const State &state, Eigen::ArrayX2d &into) const;

    Law m_law;
    std::vector<Numbers> m_numbers;
    Links m_links;
    std::shared_ptr<const NumberedList> m_all; ///< all pairs
};

}
