#include "app/model/sandbox/sandbox_properties.h"

#include "app/model/sandbox/property_ranges.h"
#include "app/model/text/phrases.h"
#include "app/model/text/sentences.h"
#include "lessons/api/parameters.h"
#include "sim/scene/blueprint_draft.h"

#include <QCoreApplication>

#include <cmath>
#include <functional>

namespace app {

namespace {

using Ranges = PropertyRanges;

struct SandboxPropertiesText
{
    Q_DECLARE_TR_FUNCTIONS(SandboxPropertiesText)
};

/// Returns the property as a parameter that a field can show.
lessons::Parameter parameterOf(const PropertyRange &named)
{
    lessons::Parameter parameter;
    parameter.id = QString::fromLatin1(named.id);
    parameter.name = Ranges::tr(named.name);
    parameter.unit = Ranges::tr(named.unit);
    parameter.help = Ranges::tr(named.help);
    parameter.min = parameter.sliderMin = named.span.min;
    parameter.max = parameter.sliderMax = named.span.max;
    parameter.decimals = named.decimals;
    return parameter;
}

/// Returns a property of the selected parts in one list. `parts(plan)` is the list, and `numbers(chosen)` are the
/// selected indices. `read(part)` and `write(part, value)` access the property of one part.
template <class Parts, class Numbers, class Read, class Write>
SandboxProperty propertyOf(lessons::Parameter about, Parts parts, Numbers numbers, Read read, Write write)
{
    SandboxProperty property;
    property.about = std::move(about);
    property.get = [=](const sim::Blueprint &plan, const Selection &chosen) -> std::optional<double> {
        std::optional<double> common;
        for (const int one : std::invoke(numbers, chosen)) {
            if (std::size_t(one) >= std::invoke(parts, plan).size())
                return {};
            const double value = read(std::invoke(parts, plan)[std::size_t(one)]);
            if (common && *common != value)
                return {};
            common = value;
        }
        return common;
    };
    property.set = [=](sim::Blueprint &plan, const Selection &chosen, double value) {
        for (const int one : std::invoke(numbers, chosen)) {
            if (std::size_t(one) >= std::invoke(parts, plan).size())
                return;
            write(std::invoke(parts, plan)[std::size_t(one)], value);
        }
    };
    return property;
}

/// Returns the same for a property that is a data member `field` of the part.
template <class Parts, class Numbers, class Field>
SandboxProperty propertyOf(const PropertyRange &named, Parts parts, Numbers numbers, Field field)
{
    const auto read = [field](auto part) { return static_cast<double>(std::invoke(field, part)); };
    const auto write = [field](auto &part, double value) {
        auto &number = std::invoke(field, part);
        number = static_cast<std::remove_reference_t<decltype(number)>>(value);
    };
    return propertyOf(parameterOf(named), parts, numbers, read, write);
}

/// Returns a coordinate property that also updates the links of the points that it moves, as a drag does.
SandboxProperty placed(SandboxProperty coordinate)
{
    constexpr double noise = 1e-9; // px: rounding errors of a drag
    coordinate.get = [get = coordinate.get](const sim::Blueprint &plan, const Selection &chosen) {
        const std::optional<double> value = get(plan, chosen);
        return value && std::abs(*value) < noise ? std::optional(0.0) : value;
    };
    coordinate.set = [set = coordinate.set](sim::Blueprint &plan, const Selection &chosen, double value) {
        const sim::Blueprint before = plan;
        set(plan, chosen, value);
        keepTies(plan, before);
    };
    return coordinate;
}

/// Collects properties and gives each its section.
class Collector
{
public:
    void begin(const QString &section) { m_section = section; }
    void add(SandboxProperty property)
    {
        property.section = m_section;
        m_all.push_back(std::move(property));
    }
    void addTruth(SandboxProperty property)
    {
        property.isTruth = true;
        add(std::move(property));
    }
    std::vector<SandboxProperty> take() { return std::move(m_all); }

private:
    QString m_section;
    std::vector<SandboxProperty> m_all;
};

/// Returns the name of a point as shown in the view.
QString titleOf(const sim::Blueprint &plan, int point)
{
    return bodyTitle(QString::fromStdString(plan.points[std::size_t(point)].name));
}

void addPoints(Collector &all, const sim::Blueprint &plan, const Selection &chosen)
{
    const auto of = [](const PropertyRange &named, auto field) {
        return propertyOf(named, &sim::Blueprint::points, &Selection::points, field);
    };
    const std::size_t count = chosen.points.size();
    all.begin(count == 1 ? SandboxPropertiesText::tr("Point %1").arg(titleOf(plan, chosen.points.front()))
                         : pointCount(static_cast<std::int64_t>(count)));
    all.add(placed(of(
        Ranges::x, [](auto &point) -> auto & { return point.x.x; })));
    all.add(placed(of(
        Ranges::y, [](auto &point) -> auto & { return point.x.y; })));
    all.add(of(Ranges::mass, &sim::BlueprintPoint::mass));
    all.add(of(Ranges::size, &sim::BlueprintPoint::size));
    all.addTruth(of(Ranges::fixed, &sim::BlueprintPoint::fixed));
    all.add(of(
        Ranges::vx, [](auto &point) -> auto & { return point.v.x; }));
    all.add(of(
        Ranges::vy, [](auto &point) -> auto & { return point.v.y; }));
}

/// Adds the point properties that effects read, while these effects are in the scene.
void addSettings(Collector &all, const sim::Blueprint &plan, sim::EffectList known)
{
    for (const sim::EffectDescription *effect : known) {
        if (!sim::hasEffect(plan, effect->id))
            continue;
        for (const sim::ParameterSpec &parameter : effect->pointProperties) {
            const auto read = [&parameter](const auto &point) { return sim::valueOf(point, parameter); };
            const auto write = [&parameter](auto &point, double value) {
                sim::setValue(point, parameter, value);
            };
            all.add(propertyOf(lessons::parameterFromSpec(parameter), &sim::Blueprint::points,
                               &Selection::points, read, write));
        }
    }
}

void addSprings(Collector &all, const Selection &chosen)
{
    const std::size_t count = chosen.springs.size();
    all.begin(count == 1 ? SandboxPropertiesText::tr("Spring")
                         : SandboxPropertiesText::tr("%1 springs").arg(count));
    all.add(propertyOf(Ranges::stiffness, &sim::Blueprint::springs, &Selection::springs,
                       &sim::BlueprintSpring::k));
    all.add(propertyOf(Ranges::length, &sim::Blueprint::springs, &Selection::springs,
                       &sim::BlueprintSpring::length));
}

void addSticks(Collector &all, const Selection &chosen)
{
    const std::size_t count = chosen.sticks.size();
    all.begin(count == 1 ? SandboxPropertiesText::tr("Stick")
                         : SandboxPropertiesText::tr("%1 sticks").arg(count));
    all.add(propertyOf(Ranges::length, &sim::Blueprint::sticks, &Selection::sticks,
                       &sim::BlueprintStick::length));
    all.add(
        propertyOf(Ranges::share, &sim::Blueprint::sticks, &Selection::sticks, &sim::BlueprintStick::share));
}

void addFootOf(Collector &all, const sim::Blueprint &plan, int foot)
{
    const sim::BlueprintFoot &one = plan.feet[std::size_t(foot)];
    const auto theFoot = [foot](const Selection &) { return std::vector<int>{foot}; };
    const int gait = one.gait;
    const auto theGait = [gait](const Selection &) { return std::vector<int>{gait}; };
    const auto ofGait = [&](const PropertyRange &named, auto field) {
        return propertyOf(named, &sim::Blueprint::gaits, theGait, field);
    };
    all.begin(SandboxPropertiesText::tr("Foot of %1").arg(titleOf(plan, one.body)));
    all.add(propertyOf(Ranges::angle, &sim::Blueprint::feet, theFoot, &sim::BlueprintFoot::angle));
    PropertyRange groups = Ranges::group;
    groups.span.max = double(plan.gaits.size()) - 1.0;
    SandboxProperty group = propertyOf(groups, &sim::Blueprint::feet, theFoot, &sim::BlueprintFoot::gait);
    group.about.isInteger = true;
    all.add(std::move(group));
    all.begin(SandboxPropertiesText::tr("Gait group %1").arg(gait));
    all.add(ofGait(Ranges::stiffness, &sim::BlueprintGait::k));
    all.add(ofGait(Ranges::leg, &sim::BlueprintGait::leg));
    all.add(ofGait(Ranges::drop, &sim::BlueprintGait::drop));
    all.add(ofGait(Ranges::gaitSpeed, &sim::BlueprintGait::speed));
    all.add(ofGait(Ranges::gaitStart, &sim::BlueprintGait::start));
    all.addTruth(ofGait(Ranges::pullsBody, &sim::BlueprintGait::pullsBody));
}

}

std::vector<SandboxProperty> propertiesOf(const sim::Blueprint &plan, const Selection &chosen,
                                          sim::EffectList known)
{
    Collector all;
    if (!chosen.points.empty()) {
        addPoints(all, plan, chosen);
        addSettings(all, plan, known);
    }
    if (chosen.points.size() == 1) {
        if (const std::optional<int> foot = footOf(plan, chosen.points.front()))
            addFootOf(all, plan, *foot);
    }
    if (!chosen.springs.empty())
        addSprings(all, chosen);
    if (!chosen.sticks.empty())
        addSticks(all, chosen);
    return all.take();
}

}
