#include "sim/effects/fields/gravity.h"

#include "sim/scene/blueprint_draft.h"
#include "sim/scene/values.h"
#include "sim/simd/point_kernels.h"

namespace sim {

/// Returns the acceleration (px/frame^2) of a falling point. Published: Creatures I, step 19.
//! [gravity]
static Vec2 fall(double gravity)
{
    // for every point; y points down
    Vec2 pull = {0, gravity};
    return pull;
}
//! [gravity]

std::vector<Region> Gravity::regions(DirectionRule) const
{
    return {{"sim/effects/fields/gravity.cpp", "gravity"}};
}

int Gravity::count(const State &state, PointRange points) const
{
    return countDynamic(state, points);
}

void Gravity::add(const State &state, PointRange movers, double scale, DirectionRule,
                  Eigen::ArrayX2d &into) const
{
    double *ay = into.data() + into.rows(); // the column of y
    updateDynamic(state.inverseMass, movers, ay,
                  [=, gravity = m_gravity](int i) { return ay[i] + scale * sim::fall(gravity).y; });
}

std::optional<double> Gravity::uniformGravity() const
{
    return sim::fall(m_gravity).y;
}

bool Gravity::addJacobian(const State &, PointRange, double, DirectionRule, Jacobian &) const
{
    return true; // gravity does not depend on position, so its Jacobian is 0
}

/// The potential energy is 0 at y = 0. Higher points have more, and y points down, hence the minus sign.
std::optional<double> Gravity::potentialEnergy(const State &state) const
{
    double sum = 0.0;
    for (int i = 0; i < state.pointCount(); ++i) {
        if (state.isDynamic(i))
            sum -= sim::fall(m_gravity).y * state.position(i, 1) / state.inverseMass[i];
    }
    return sum;
}

std::vector<LiveValue> Gravity::explain(const State &state, int mover, DirectionRule) const
{
    if (!state.isDynamic(mover))
        return {};
    return {{"pull", sim::fall(m_gravity)}};
}

bool Gravity::addToDraft(BlueprintDraft &draft) const
{
    draft.addEffect("gravity", {{"gravity", m_gravity}});
    return true;
}

namespace {

constexpr ParameterSpec gravityParameters[] = {{
    .id = "gravity",
    .name = SIM_TEXT("Gravity"),
    .symbol = "g",
    .unit = SIM_TEXT("px/frame²"),
    .help = SIM_TEXT("How much speed everything gains downwards each frame."),
    .defaultValue = 0.3,
    .min = -1e6,
    .max = 1e6,
    .sliderMin = 0.0,
    .sliderMax = 3.0,
}};

EffectPtr makeGravity(const Blueprint &, const Values &values)
{
    return std::make_shared<Gravity>(values["gravity"]);
}

}

namespace descriptions {
constinit const EffectDescription gravity = {.id = "gravity",
                                             .title = SIM_TEXT("gravity"),
                                             .kind = EffectKind::gravity,
                                             .purpose = SIM_TEXT("Pulls everything down equally."),
                                             .parameters = gravityParameters,
                                             .make = makeGravity};
}

}
