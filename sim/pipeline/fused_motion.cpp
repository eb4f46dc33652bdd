#include "sim/pipeline/fused_motion.h"

#include "sim/effects/drags/damping.h"
#include "sim/pipeline/phase_builder.h"
#include "sim/simd/point_kernels.h"

#include <algorithm>
#include <optional>

namespace sim {

namespace {

/// The numbers of a fused kernel. The defaults of gravity and damping change no bit (a + -0.0, 1.0 * v).
struct FusedMotion
{
    double gravity = -0.0;      ///< px/frame^2
    double kick = 0.0;          ///< frames
    double dampingFactor = 1.0; ///< fraction of the velocity that remains
    double move = 0.0;          ///< frames
};

void moveAll(const FusedMotion &motion, State &state, PointRange range)
{
    const XyColumns position(state.position), velocity(state.velocity), acceleration(state.acceleration);
    forEachPoint(state.inverseMass.data(), range,
                 [motion, x = position, v = velocity, a = acceleration](int i, bool isDynamic) {
                     const Vec2 newA = {a.x[i], a.y[i] + motion.gravity};
                     const Vec2 newV = damp(kick(v.at(i), newA, motion.kick), motion.dampingFactor);
                     const Vec2 newX = move(x.at(i), newV, motion.move);
                     a.y[i] = isDynamic ? newA.y : a.y[i];
                     v.x[i] = isDynamic ? newV.x : v.x[i];
                     v.y[i] = isDynamic ? newV.y : v.y[i];
                     x.x[i] = isDynamic ? newX.x : x.x[i];
                     x.y[i] = isDynamic ? newX.y : x.y[i];
                 });
}

/// Returns how many kernels from index `first` on can be fused; 0 if none. Sets `motion` to their numbers and
/// `points` to their points.
std::size_t fusibleKernels(const std::vector<StepKernel> &kernels, std::size_t first, FusedMotion &motion,
                           PointRange &points)
{
    using Kind = PointOperation::Kind;
    std::size_t next = first;
    const auto takeNext = [&](Kind kind) -> std::optional<double> {
        const std::optional<PointOperation> operation =
            next < kernels.size() ? kernels[next].kernel.operation : std::nullopt;
        if (!operation || operation->kind != kind || (next > first && operation->points != points))
            return {};
        points = operation->points;
        ++next;
        return operation->amount;
    };
    motion = {};
    motion.gravity = takeNext(Kind::addGravity).value_or(motion.gravity);
    const std::optional<double> kick = takeNext(Kind::kick);
    motion.dampingFactor = takeNext(Kind::damp).value_or(motion.dampingFactor);
    const std::optional<double> move = takeNext(Kind::move);
    if (!kick || !move)
        return 0;
    motion.kick = *kick;
    motion.move = *move;
    return next - first;
}

}

std::vector<StepKernel> fusedKernels(const std::vector<Phase> &phases)
{
    std::vector<StepKernel> all, fused;
    for (const Phase &phase : phases) {
        for (const Kernel &kernel : phase.kernels)
            all.push_back({phase.points, kernel});
    }
    for (std::size_t i = 0; i < all.size();) {
        FusedMotion motion;
        PointRange points;
        const std::size_t count = fusibleKernels(all, i, motion, points);
        if (count == 0) {
            fused.push_back(std::move(all[i++]));
            continue;
        }
        fused.push_back({points, kernelOf(points, [motion](State &state, PointRange range) {
                             moveAll(motion, state, range);
                         })});
        i += count;
    }
    return fused;
}

}
