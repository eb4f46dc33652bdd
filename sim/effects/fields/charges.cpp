#include "sim/effects/fields/charges.h"

#include "sim/effects/pairs/pair_kernels.h"
#include "sim/scene/values.h"

namespace sim {

template class PairForce<ChargeLaw>;

namespace {

/// Returns all pairs of points whose charge is not 0.
std::vector<PointPair> chargedPairs(const Eigen::ArrayXd &charge)
{
    std::vector<PointPair> pairs;
    for (int one = 0; one < charge.size(); ++one) {
        for (int other = one + 1; other < charge.size(); ++other) {
            if (charge[one] != 0.0 && charge[other] != 0.0)
                pairs.push_back({one, other, static_cast<int>(pairs.size()), true});
        }
    }
    return pairs;
}

std::vector<ChargeLaw::Numbers> numbersOf(const Eigen::ArrayXd &charge, const std::vector<PointPair> &pairs)
{
    std::vector<ChargeLaw::Numbers> numbers;
    for (const PointPair &pair : pairs)
        numbers.push_back({charge[pair.mover], charge[pair.anchor]});
    return numbers;
}

}

Charges::Charges(Eigen::ArrayXd charge, double strength, double softening)
    : DescribedEffect({strength, softening}, chargedPairs(charge), numbersOf(charge, chargedPairs(charge))),
      m_charge(std::move(charge))
{
}

Vec2 ChargeLaw::published(Vec2 one, Vec2 other, const Numbers &numbers) const
{
    const PairPull found = pull(one, other, numbers);
    return found.length < coincidenceDistance ? pullWhenCoincident(publishedDirection({}).out, numbers)
                                              : found.pull;
}

PairJacobian ChargeLaw::jacobian(Vec2 one, Vec2 other, const Numbers &numbers) const
{
    const Direction heading = direction(one - other);
    if (heading.length < coincidenceDistance)
        return {}; // the force changes its sign there, so it has no derivative
    const double force = forceAt(heading.length, numbers);
    const double across = force / heading.length;
    const double along =
        -2.0 * force * heading.length / (heading.length * heading.length + softening * softening);
    const double xy = (along - across) * heading.out.x * heading.out.y;
    return {across + (along - across) * heading.out.x * heading.out.x, xy, xy,
            across + (along - across) * heading.out.y * heading.out.y};
}

double ChargeLaw::energy(Vec2 one, Vec2 other, const Numbers &numbers) const
{
    // The integral of strength q1 q2 / (x^2 + softening^2) over x, from the distance to infinity.
    return strength * numbers.q1 * numbers.q2 * std::atan2(softening, length(one - other)) / softening;
}

std::vector<LiveValue> ChargeLaw::liveValues(Vec2 one, Vec2 other, Vec2 fallback, const Numbers &numbers,
                                             DirectionRule directionRule) const
{
    const PairPull found = pull(one, other, numbers);
    const Vec2 shownPull = directionRule == DirectionRule::published ? published(one, other, numbers)
                           : found.length < coincidenceDistance      ? pullWhenCoincident(fallback, numbers)
                                                                     : found.pull;
    return {{"from", one - other},
            {"length", found.length},
            {"force", forceAt(found.length, numbers)},
            {"pull", shownPull}};
}

namespace {

constexpr ParameterSpec chargeParameters[] = {
    {
        .id = "charge_strength",
        .name = SIM_TEXT("Charge strength"),
        .unit = SIM_TEXT("px³/frame²"),
        .help = SIM_TEXT("How hard charges push and pull each other."),
        .defaultValue = 1000.0,
        .min = 0.0,
        .max = 1e9,
        .sliderMin = 0.0,
        .sliderMax = 5000.0,
        .decimals = 0,
    },
    {
        .id = "softening",
        .name = SIM_TEXT("Softening"),
        .unit = SIM_TEXT("px"),
        .help =
            SIM_TEXT("Weakens the force where charges come closer than about this, so that it stays finite."),
        .defaultValue = 10.0,
        .min = 1.0,
        .max = 1e6,
        .sliderMin = 1.0,
        .sliderMax = 50.0,
        .decimals = 0,
    }};
constexpr ParameterSpec chargeProperties[] = {{
    .id = "charge",
    .name = SIM_TEXT("Charge"),
    .symbol = "q",
    .help = SIM_TEXT("Charges of the same sign repel each other, and others attract. 0: it carries none."),
    .defaultValue = 0.0,
    .min = -100.0,
    .max = 100.0,
    .sliderMin = -10.0,
    .sliderMax = 10.0,
    .decimals = 1,
}};
constexpr CodeVariable chargeVariables[] = {
    {"from", "px", SIM_TEXT("Where this charge is, seen from the other one.")},
    {"length", "px", SIM_TEXT("How far apart the two charges are.")},
    {"force", "px/frame²",
     SIM_TEXT("How hard they push each other apart, for a mass of 1. Below 0: they attract each other.")},
    {"pull", "px/frame²", SIM_TEXT("What all charges together add to the velocity each frame.")}};

EffectPtr makeCharges(const Blueprint &blueprint, const Values &values)
{
    return std::make_shared<Charges>(valuesOf(blueprint, chargeProperties[0]), values["charge_strength"],
                                     values["softening"]);
}

}

bool Charges::addToDraft(BlueprintDraft &draft) const
{
    draft.addEffect("charges", {{"charge_strength", law().strength}, {"softening", law().softening}});
    for (int i = 0; i < draft.state.pointCount(); ++i)
        setValue(draft.blueprint.points[static_cast<std::size_t>(i)], chargeProperties[0], m_charge[i]);
    return true;
}

namespace descriptions {
constinit const EffectDescription charges = {
    .id = "charges",
    .title = SIM_TEXT("charges"),
    .kind = EffectKind::spring,
    .purpose = SIM_TEXT("Push points with like charges apart, and pull unlike ones together: the closer they "
                        "are, the harder."),
    .parameters = chargeParameters,
    .pointProperties = chargeProperties,
    .variables = chargeVariables,
    .make = makeCharges};
}

}
