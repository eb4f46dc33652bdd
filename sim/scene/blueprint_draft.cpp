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
    std::string uniqueName = name;
    const auto isTaken = [&](const BlueprintPoint &point) { return point.name == uniqueName; };
    for (int i = 2; std::any_of(blueprint.points.begin(), blueprint.points.end(), isTaken); ++i)
        uniqueName = name + std::to_string(i);
    BlueprintPoint point{uniqueName, x, {}};
    point.fixed = true;
    blueprint.points.push_back(point);
    return static_cast<int>(blueprint.points.size()) - 1;
}

void BlueprintDraft::omit(const std::string &what)
{
    if (std::find(omitted.begin(), omitted.end(), what) == omitted.end())
        omitted.push_back(what);
}

bool hasEffect(const Blueprint &blueprint, const std::string &id)
{
    return std::find(blueprint.effects.begin(), blueprint.effects.end(), id) != blueprint.effects.end();
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

Eigen::ArrayXd valuesOf(const Blueprint &blueprint, const ParameterSpec &parameter)
{
    Eigen::ArrayXd values(static_cast<Eigen::Index>(blueprint.points.size()));
    for (Eigen::Index i = 0; i < values.size(); ++i)
        values[i] = valueOf(blueprint.points[static_cast<std::size_t>(i)], parameter);
    return values;
}

Eigen::ArrayXd widths(const Blueprint &blueprint)
{
    Eigen::ArrayXd values(static_cast<Eigen::Index>(blueprint.points.size()));
    for (Eigen::Index i = 0; i < values.size(); ++i)
        values[i] = blueprint.points[static_cast<std::size_t>(i)].size;
    return values;
}

Eigen::ArrayXd halfWidths(const Blueprint &blueprint)
{
    return 0.5 * widths(blueprint);
}

std::vector<int> feetOf(const Blueprint &blueprint)
{
    std::vector<int> feet;
    for (const BlueprintFoot &foot : blueprint.feet)
        feet.push_back(foot.foot);
    std::sort(feet.begin(), feet.end());
    return feet;
}

int clockCount(const Blueprint &blueprint)
{
    return static_cast<int>(blueprint.gaits.size()) + (hasRuleClock(blueprint) ? 3 : 2);
}

int windClockOf(const Blueprint &blueprint)
{
    return static_cast<int>(blueprint.gaits.size());
}

bool hasRuleClock(const Blueprint &blueprint)
{
    return blueprint.rule && blueprint.rule.program->use().time;
}

int ruleClockOf(const Blueprint &blueprint)
{
    return windClockOf(blueprint) + 2;
}

std::vector<int> clockOf(const Blueprint &blueprint)
{
    std::vector<int> clocks(blueprint.points.size(), windClockOf(blueprint) + 1);
    for (const BlueprintFoot &foot : blueprint.feet) {
        clocks[static_cast<std::size_t>(foot.foot)] = foot.gait;
        clocks[static_cast<std::size_t>(foot.body)] = foot.gait;
    }
    return clocks;
}

std::vector<std::vector<int>> partnerClocksOf(const Blueprint &blueprint)
{
    std::map<int, std::set<int>> clocksOfBody;
    for (const BlueprintFoot &foot : blueprint.feet)
        clocksOfBody[foot.body].insert(foot.gait);
    std::vector<std::set<int>> partners(static_cast<std::size_t>(clockCount(blueprint)));
    for (const auto &[body, clocks] : clocksOfBody) {
        for (const int clock : clocks)
            partners[static_cast<std::size_t>(clock)].insert(clocks.begin(), clocks.end());
    }
    std::vector<std::vector<int>> result;
    for (std::size_t i = 0; i < partners.size(); ++i) {
        partners[i].erase(static_cast<int>(i));
        result.emplace_back(partners[i].begin(), partners[i].end());
    }
    return result;
}

}
