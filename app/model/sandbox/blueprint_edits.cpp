#include "app/model/sandbox/blueprint_edits.h"

#include "app/model/sandbox/blueprint_limits.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <set>

namespace app {

namespace {

constexpr double atLength = 0.5; ///< px: a link within this distance of its length counts as being at it

/// Returns the length of a link between two points: their distance, limited to the range of files.
double apart(const sim::Blueprint &plan, int a, int b)
{
    const double distance = sim::length(plan.points[std::size_t(a)].x - plan.points[std::size_t(b)].x);
    return std::min(distance, built::length.max);
}

/// Returns the angle of a foot as seen from its body, in whole degrees.
double angleOf(const sim::Blueprint &plan, int foot, int body, int gait)
{
    const sim::Vec2 bone = plan.points[std::size_t(body)].x - plan.points[std::size_t(foot)].x;
    const double drop = plan.gaits[std::size_t(gait)].drop;
    return std::round(std::atan2(bone.y + drop, bone.x) * 180.0 / std::numbers::pi);
}

double inverseMass(const sim::BlueprintPoint &point)
{
    return point.fixed ? 0.0 : 1.0 / point.mass;
}

bool isAmong(const std::vector<int> &sorted, int one)
{
    return std::binary_search(sorted.begin(), sorted.end(), one);
}

std::string freeName(const sim::Blueprint &plan)
{
    std::set<std::string> names;
    for (const sim::BlueprintPoint &point : plan.points)
        names.insert(point.name);
    const auto name = [](int number) { return std::string("p").append(std::to_string(number)); };
    int number = 0;
    while (names.contains(name(number)))
        ++number;
    return name(number);
}

/// Returns the new index of each point after `gone` are removed; -1 for the removed points.
std::vector<int> numbersWithout(const sim::Blueprint &plan, const std::vector<int> &gone)
{
    std::vector<int> numbers;
    int next = 0;
    for (int i = 0; i < static_cast<int>(plan.points.size()); ++i)
        numbers.push_back(isAmong(gone, i) ? -1 : next++);
    return numbers;
}

template <class Part>
void eraseNumbers(std::vector<Part> &parts, const std::vector<int> &gone)
{
    std::vector<Part> kept;
    for (int i = 0; i < static_cast<int>(parts.size()); ++i) {
        if (!isAmong(gone, i))
            kept.push_back(parts[std::size_t(i)]);
    }
    parts = std::move(kept);
}

/// Returns the indices of the links that have both ends in `points`.
template <class Link>
std::vector<int> linksAmong(const std::vector<Link> &links, const std::vector<int> &points)
{
    std::vector<int> among;
    for (int i = 0; i < static_cast<int>(links.size()); ++i) {
        if (isAmong(points, links[std::size_t(i)].a) && isAmong(points, links[std::size_t(i)].b))
            among.push_back(i);
    }
    return among;
}

std::vector<int> below(const std::vector<int> &numbers, std::size_t count)
{
    std::vector<int> kept;
    std::copy_if(numbers.begin(), numbers.end(), std::back_inserter(kept),
                 [&](int one) { return std::size_t(one) < count; });
    return kept;
}

/// Renumbers the ends of links, and drops the links that lost an end.
template <class Link>
void reconnect(std::vector<Link> &links, const std::vector<int> &numbers)
{
    std::vector<Link> kept;
    for (Link link : links) {
        link.a = numbers[std::size_t(link.a)];
        link.b = numbers[std::size_t(link.b)];
        if (link.a >= 0 && link.b >= 0)
            kept.push_back(link);
    }
    links = std::move(kept);
}

/// Copies the links that have copies of both ends. Returns the indices of the new links.
template <class Link>
std::vector<int> copyLinks(std::vector<Link> &links, const std::vector<int> &copies)
{
    std::vector<int> added;
    const std::vector<Link> old = links;
    for (Link link : old) {
        link.a = copies[std::size_t(link.a)];
        link.b = copies[std::size_t(link.b)];
        if (link.a < 0 || link.b < 0)
            continue;
        added.push_back(static_cast<int>(links.size()));
        links.push_back(link);
    }
    return added;
}

}

std::optional<int> addPoint(sim::Blueprint &plan, sim::Vec2 at)
{
    if (plan.points.size() >= built::mostPoints || !built::place.holds(at.x) || !built::place.holds(at.y))
        return {};
    sim::BlueprintPoint point;
    point.name = freeName(plan);
    point.x = at;
    plan.points.push_back(point);
    return static_cast<int>(plan.points.size()) - 1;
}

std::optional<int> addSpring(sim::Blueprint &plan, int a, int b)
{
    if (a == b || plan.springs.size() >= built::mostLinks)
        return {};
    const double k = plan.springs.empty() ? sim::BlueprintSpring().k : plan.springs.back().k;
    plan.springs.push_back({a, b, k, apart(plan, a, b)});
    return static_cast<int>(plan.springs.size()) - 1;
}

std::optional<int> addStick(sim::Blueprint &plan, int a, int b)
{
    if (a == b || plan.sticks.size() >= built::mostLinks)
        return {};
    const double ofA = inverseMass(plan.points[std::size_t(a)]);
    const double ofBoth = ofA + inverseMass(plan.points[std::size_t(b)]);
    plan.sticks.push_back({a, b, apart(plan, a, b), ofBoth == 0.0 ? 0.5 : ofA / ofBoth});
    return static_cast<int>(plan.sticks.size()) - 1;
}

std::optional<int> addRuleLink(sim::Blueprint &plan, int a, int b)
{
    const auto joinsThem = [&](const sim::BlueprintRuleLink &one) {
        return std::minmax(one.a, one.b) == std::minmax(a, b);
    };
    if (a == b || plan.ruleLinks.size() >= built::mostLinks ||
        std::any_of(plan.ruleLinks.begin(), plan.ruleLinks.end(), joinsThem))
        return {};
    plan.ruleLinks.push_back({a, b});
    return static_cast<int>(plan.ruleLinks.size()) - 1;
}

std::optional<int> addRuleLinksAmong(sim::Blueprint &plan, const std::vector<int> &points)
{
    std::set<std::pair<int, int>> linked;
    for (const sim::BlueprintRuleLink &link : plan.ruleLinks)
        linked.insert(std::minmax(link.a, link.b));
    std::vector<sim::BlueprintRuleLink> added;
    for (std::size_t i = 0; i < points.size(); ++i) {
        for (std::size_t j = i + 1; j < points.size(); ++j) {
            if (linked.insert(std::minmax(points[i], points[j])).second)
                added.push_back({points[i], points[j]});
            if (plan.ruleLinks.size() + added.size() > built::mostLinks)
                return {};
        }
    }
    plan.ruleLinks.insert(plan.ruleLinks.end(), added.begin(), added.end());
    return static_cast<int>(added.size());
}

std::optional<int> pointCalled(const sim::Blueprint &plan, const std::string &name)
{
    const auto found = std::find_if(plan.points.begin(), plan.points.end(),
                                    [&](const auto &one) { return one.name == name; });
    return found == plan.points.end() ? std::nullopt : std::optional(int(found - plan.points.begin()));
}

std::optional<int> footOf(const sim::Blueprint &plan, int point)
{
    for (std::size_t i = 0; i < plan.feet.size(); ++i) {
        if (plan.feet[i].foot == point)
            return static_cast<int>(i);
    }
    return {};
}

std::optional<int> addFoot(sim::Blueprint &plan, int foot, int body)
{
    if (foot == body || footOf(plan, foot))
        return {};
    if (plan.gaits.empty())
        plan.gaits.emplace_back();
    const int gait = static_cast<int>(plan.gaits.size()) - 1;
    plan.feet.push_back({foot, body, angleOf(plan, foot, body, gait), gait});
    return static_cast<int>(plan.feet.size()) - 1;
}

std::optional<int> addGait(sim::Blueprint &plan)
{
    if (plan.gaits.size() >= built::mostGaits)
        return {};
    plan.gaits.push_back(plan.gaits.empty() ? sim::BlueprintGait() : plan.gaits.back());
    return static_cast<int>(plan.gaits.size()) - 1;
}

void erase(sim::Blueprint &plan, const Selection &chosen)
{
    eraseNumbers(plan.springs, chosen.springs);
    eraseNumbers(plan.sticks, chosen.sticks);
    eraseNumbers(plan.ruleLinks, chosen.ruleLinks);
    const std::vector<int> numbers = numbersWithout(plan, chosen.points);
    eraseNumbers(plan.points, chosen.points);
    reconnect(plan.springs, numbers);
    reconnect(plan.sticks, numbers);
    reconnect(plan.ruleLinks, numbers);
    for (sim::BlueprintFoot &foot : plan.feet) {
        foot.foot = numbers[std::size_t(foot.foot)];
        foot.body = numbers[std::size_t(foot.body)];
    }
    std::erase_if(plan.feet, [](const sim::BlueprintFoot &foot) { return foot.foot < 0 || foot.body < 0; });
}

std::optional<Selection> duplicate(sim::Blueprint &plan, const Selection &chosen, sim::Vec2 by)
{
    sim::Blueprint next = plan;
    Selection added;
    std::vector<int> copies(plan.points.size(), -1);
    for (const int one : chosen.points) {
        const sim::BlueprintPoint &old = plan.points[std::size_t(one)];
        const std::optional<int> copy = addPoint(next, old.x + by);
        if (!copy)
            return {};
        sim::BlueprintPoint made = old;
        std::swap(made.name, next.points[std::size_t(*copy)].name);
        made.x = next.points[std::size_t(*copy)].x;
        next.points[std::size_t(*copy)] = std::move(made);
        copies[std::size_t(one)] = *copy;
        added.points.push_back(*copy);
    }
    added.springs = copyLinks(next.springs, copies);
    added.sticks = copyLinks(next.sticks, copies);
    added.ruleLinks = copyLinks(next.ruleLinks, copies);
    if (std::max({next.springs.size(), next.sticks.size(), next.ruleLinks.size()}) > built::mostLinks)
        return {};
    for (sim::BlueprintFoot foot : plan.feet) {
        foot.foot = copies[std::size_t(foot.foot)];
        foot.body = copies[std::size_t(foot.body)];
        if (foot.foot >= 0 && foot.body >= 0)
            next.feet.push_back(foot);
    }
    plan = std::move(next);
    return added;
}

void moveBy(sim::Blueprint &plan, const std::vector<int> &points, sim::Vec2 by)
{
    const sim::Blueprint before = plan;
    for (const int one : points) {
        sim::Vec2 &x = plan.points[std::size_t(one)].x;
        x = {std::clamp(x.x + by.x, built::place.min, built::place.max),
             std::clamp(x.y + by.y, built::place.min, built::place.max)};
    }
    keepTies(plan, before);
}

void keepTies(sim::Blueprint &plan, const sim::Blueprint &before)
{
    const auto follow = [&](auto &links) {
        for (auto &link : links) {
            const double was = apart(before, link.a, link.b);
            const double is = apart(plan, link.a, link.b);
            if (is != was && std::abs(link.length - was) < atLength)
                link.length = is;
        }
    };
    follow(plan.springs);
    follow(plan.sticks);
    for (sim::BlueprintFoot &foot : plan.feet) {
        const auto isMoved = [&](int point) {
            return plan.points[std::size_t(point)].x != before.points[std::size_t(point)].x;
        };
        if (isMoved(foot.foot) && !isMoved(foot.body) &&
            foot.angle == angleOf(before, foot.foot, foot.body, foot.gait))
            foot.angle = angleOf(plan, foot.foot, foot.body, foot.gait);
    }
}

Selection everything(const sim::Blueprint &plan)
{
    const auto all = [](std::size_t count) {
        std::vector<int> numbers(count);
        std::iota(numbers.begin(), numbers.end(), 0);
        return numbers;
    };
    return {all(plan.points.size()), all(plan.springs.size()), all(plan.sticks.size()),
            all(plan.ruleLinks.size())};
}

Selection inBox(const sim::Blueprint &plan, sim::Vec2 one, sim::Vec2 other)
{
    const auto between = [](double value, double a, double b) {
        return value >= std::min(a, b) && value <= std::max(a, b);
    };
    Selection chosen;
    for (int i = 0; i < static_cast<int>(plan.points.size()); ++i) {
        const sim::Vec2 x = plan.points[std::size_t(i)].x;
        if (between(x.x, one.x, other.x) && between(x.y, one.y, other.y))
            chosen.points.push_back(i);
    }
    chosen.springs = linksAmong(plan.springs, chosen.points);
    chosen.sticks = linksAmong(plan.sticks, chosen.points);
    chosen.ruleLinks = linksAmong(plan.ruleLinks, chosen.points);
    return chosen;
}

Selection within(const sim::Blueprint &plan, const Selection &chosen)
{
    return {below(chosen.points, plan.points.size()), below(chosen.springs, plan.springs.size()),
            below(chosen.sticks, plan.sticks.size()), below(chosen.ruleLinks, plan.ruleLinks.size())};
}

}
