#include "sim/scene/blueprint_draft.h"

#include "sim/scene/effect.h"

#include <algorithm>
#include <set>

namespace sim {

void BlueprintDraft::addEffect(const std::string &effect,
                               std::initializer_list<std::pair<const char *, double>> settings)
{
    if (!hasEffect(blueprint, effect))
        blueprint.effects.push_back(effect);
    for (const auto &[id, value] : settings)
        parameters[id] = value;
}

void BlueprintDraft::addSpring(const BlueprintSpring &spring, bool pullsBoth)
{
    if (!pullsBoth && !blueprint.points[static_cast<std::size_t>(spring.b)].fixed)
        omit(SIM_TEXT("springs that pull one end only"));
    blueprint.springs.push_back(spring);
}

int BlueprintDraft::addFixedPoint(const std::string &name, Vec2 x)
{
    std::string free = name;
    const auto isTaken = [&](const BlueprintPoint &one) { return one.name == free; };
    for (int i = 2; std::any_of(blueprint.points.begin(), blueprint.points.end(), isTaken); ++i)
        free = name + std::to_string(i);
    BlueprintPoint nail{free, x, {}};
    nail.fixed = true;
    blueprint.points.push_back(nail);
    return static_cast<int>(blueprint.points.size()) - 1;
}

void BlueprintDraft::omit(const std::string &what)
{
    if (std::find(omitted.begin(), omitted.end(), what) == omitted.end())
        omitted.push_back(what);
}

bool hasEffect(const Blueprint &plan, const std::string &id)
{
    return std::find(plan.effects.begin(), plan.effects.end(), id) != plan.effects.end();
}

double valueOf(const BlueprintPoint &point, const ParameterSpec &parameter)
{
    const auto found = point.properties.find(parameter.id);
    return found == point.properties.end() ? parameter.defaultValue : found->second;
}

void setValue(BlueprintPoint &point, const ParameterSpec &parameter, double value)
{
    if (value == parameter.defaultValue)
        point.properties.erase(parameter.id);
    else
        point.properties[parameter.id] = value;
}

Eigen::ArrayXd valuesOf(const Blueprint &plan, const ParameterSpec &parameter)
{
    Eigen::ArrayXd all(static_cast<Eigen::Index>(plan.points.size()));
    for (Eigen::Index i = 0; i < all.size(); ++i)
        all[i] = valueOf(plan.points[static_cast<std::size_t>(i)], parameter);
    return all;
}

Eigen::ArrayXd widths(const Blueprint &plan)
{
    Eigen::ArrayXd all(static_cast<Eigen::Index>(plan.points.size()));
    for (Eigen::Index i = 0; i < all.size(); ++i)
        all[i] = plan.points[static_cast<std::size_t>(i)].size;
    return all;
}

Eigen::ArrayXd halfWidths(const Blueprint &plan)
{
    return 0.5 * widths(plan);
}

std::vector<int> feetOf(const Blueprint &plan)
{
    std::vector<int> feet;
    for (const BlueprintFoot &one : plan.feet)
        feet.push_back(one.foot);
    std::sort(feet.begin(), feet.end());
    return feet;
}

int clocksOf(const Blueprint &plan)
{
    return static_cast<int>(plan.gaits.size()) + 2;
}

int windClockOf(const Blueprint &plan)
{
    return static_cast<int>(plan.gaits.size());
}

std::vector<int> clockOf(const Blueprint &plan)
{
    std::vector<int> clocks(plan.points.size(), clocksOf(plan) - 1);
    for (const BlueprintFoot &one : plan.feet) {
        clocks[static_cast<std::size_t>(one.foot)] = one.gait;
        clocks[static_cast<std::size_t>(one.body)] = one.gait;
    }
    return clocks;
}

std::vector<std::vector<int>> partnerClocksOf(const Blueprint &plan)
{
    std::map<int, std::set<int>> ofBody;
    for (const BlueprintFoot &one : plan.feet)
        ofBody[one.body].insert(one.gait);
    std::vector<std::set<int>> mates(static_cast<std::size_t>(clocksOf(plan)));
    for (const auto &[body, clocks] : ofBody) {
        for (const int clock : clocks)
            mates[static_cast<std::size_t>(clock)].insert(clocks.begin(), clocks.end());
    }
    std::vector<std::vector<int>> all;
    for (std::size_t i = 0; i < mates.size(); ++i) {
        mates[i].erase(static_cast<int>(i));
        all.emplace_back(mates[i].begin(), mates[i].end());
    }
    return all;
}

}
