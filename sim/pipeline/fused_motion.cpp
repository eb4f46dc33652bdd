#include "sim/pipeline/fused_motion.h"

#include "sim/effects/drags/damping.h"
#include "sim/pipeline/phase_builder.h"
#include "sim/simd/point_kernels.h"

#include <algorithm>
#include <optional>

namespace sim {

namespace {

/// The numbers of a fused kernel. What is missing has the number that changes no bit: a + -0.0 is a, and 1.0 * v is v.
struct FusedMotion
{
    double fall = -0.0; ///< px/frame^2
    double kick = 0.0;  ///< frames
    double keep = 1.0;
    double move = 0.0; ///< frames
};

void moveAll(const FusedMotion &motion, State &state, PointRange range)
{
    const XyColumns position(state.position), velocity(state.velocity), acceleration(state.acceleration);
    forEachPoint(state.inverseMass.data(), range,
                 [motion, x = position, v = velocity, a = acceleration](int i, bool feels) {
                     const Vec2 pull = {a.x[i], a.y[i] + motion.fall};
                     const Vec2 speed = damp(kick(v.at(i), pull, motion.kick), motion.keep);
                     const Vec2 place = move(x.at(i), speed, motion.move);
                     a.y[i] = feels ? pull.y : a.y[i];
                     v.x[i] = feels ? speed.x : v.x[i];
                     v.y[i] = feels ? speed.y : v.y[i];
                     x.x[i] = feels ? place.x : x.x[i];
                     x.y[i] = feels ? place.y : x.y[i];
                 });
}

/// How many of the kernels from `first` on are such a motion, its numbers and its points. 0: none.
std::size_t motionAt(const std::vector<StepKernel> &all, std::size_t first, FusedMotion &motion,
                     PointRange &points)
{
    using Does = PointOperation::Kind;
    std::size_t next = first;
    const auto take = [&](Does does) -> std::optional<double> {
        const std::optional<PointOperation> step =
            next < all.size() ? all[next].kernel.operation : std::nullopt;
        if (!step || step->kind != does || (next > first && step->points != points))
            return {};
        points = step->points;
        ++next;
        return step->amount;
    };
    motion = {};
    motion.fall = take(Does::addGravity).value_or(motion.fall);
    const std::optional<double> kick = take(Does::kick);
    motion.keep = take(Does::damp).value_or(motion.keep);
    const std::optional<double> move = take(Does::move);
    if (!kick || !move)
        return 0;
    motion.kick = *kick;
    motion.move = *move;
    return next - first;
}

}

std::vector<StepKernel> fusedKernels(const std::vector<Phase> &phases)
{
    std::vector<StepKernel> all, fewer;
    for (const Phase &phase : phases) {
        for (const Kernel &kernel : phase.kernels)
            all.push_back({phase.points, kernel});
    }
    for (std::size_t i = 0; i < all.size();) {
        FusedMotion motion;
        PointRange points;
        const std::size_t count = motionAt(all, i, motion, points);
        if (count == 0) {
            fewer.push_back(std::move(all[i++]));
            continue;
        }
        fewer.push_back({points, kernelOf(points, [motion](State &state, PointRange range) {
                             moveAll(motion, state, range);
                         })});
        i += count;
    }
    return fewer;
}

}
