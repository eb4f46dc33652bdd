#include "app/listing/vocabulary.h"

#include "app/listing/language.h"
#include "sim/effects/constraints/sticks.h"
#include "sim/effects/contacts/room_limits.h"
#include "sim/effects/drivers/gust.h"
#include "sim/effects/tree/joints.h"
#include "sim/effects/tree/torsion.h"
#include "sim/effects/tree/tree_wind.h"
#include "sim/scene/values.h"
#include "sim/scenes/creatures.h"

#include <algorithm>
#include <map>
#include <set>

namespace listing {

namespace {

/// Returns the name without the digits at its end.
std::string prefixOf(const std::string &name)
{
    const std::size_t last = name.find_last_not_of("0123456789");
    return last == std::string::npos ? std::string() : name.substr(0, last + 1);
}

using PointsByName = std::map<std::string, int>;

/// Returns the points called `prefix`0, `prefix`1... up to the first number that the scene does not have.
std::vector<int> pointsOf(const std::string &prefix, const PointsByName &pointOf)
{
    std::vector<int> points;
    for (auto found = pointOf.find(prefix + "0"); found != pointOf.end();
         found = pointOf.find(prefix + std::to_string(points.size())))
        points.push_back(found->second);
    return points;
}

std::vector<Binding::Creature> creaturesOf(const PointsByName &pointOf)
{
    std::vector<Binding::Creature> creatures;
    for (;;) {
        const std::string name = "creature" + std::to_string(creatures.size());
        const auto body = pointOf.find(name + ".body");
        if (body == pointOf.end())
            return creatures;
        creatures.push_back({body->second, pointsOf(name + ".foot", pointOf)});
    }
}

template <class Type>
const Type *find(const sim::Scene &scene)
{
    for (const sim::EffectPtr &effect : scene.effects) {
        if (const auto *found = dynamic_cast<const Type *>(effect.get()))
            return found;
    }
    return nullptr;
}

std::vector<Binding::Branch> branchesOf(const sim::Tree &tree)
{
    const sim::BranchMechanics mechanics = sim::branchMechanicsOf(tree, 1.0);
    std::vector<Binding::Branch> branches;
    branches.reserve(tree.scale.size());
    for (std::size_t i = 0; i < tree.scale.size(); ++i) {
        const double inertia = mechanics.inertia[static_cast<Eigen::Index>(i)];
        branches.push_back({tree.rest[i], tree.scale[i], tree.baseLength * tree.scale[i], inertia,
                            tree.firstChild[i], tree.children[i]});
    }
    return branches;
}

std::vector<sim::Stick> sticksOf(const sim::Scene &scene)
{
    std::vector<sim::Stick> all;
    for (const sim::Sticks *sticks : sim::sticksAmong(scene.effects))
        all.insert(all.end(), sticks->list().begin(), sticks->list().end());
    return all;
}

/// Returns the ends of `sticks` that are not among the named bodies of `binding`.
std::vector<int> unnamedEnds(const std::vector<sim::Stick> &sticks, const Binding &binding)
{
    std::set<int> named(binding.bodies.begin(), binding.bodies.end()), unnamed;
    for (const std::vector<int> &array : binding.arrays)
        named.insert(array.begin(), array.end());
    for (const Binding::Creature &creature : binding.creatures) {
        named.insert(creature.body);
        named.insert(creature.feet.begin(), creature.feet.end());
    }
    for (const sim::Stick &stick : sticks) {
        for (const int end : {stick.a, stick.b}) {
            if (!named.contains(end))
                unnamed.insert(end);
        }
    }
    return {unnamed.begin(), unnamed.end()};
}

/// Trees use faster sine and cosine functions for their many branches. A gust uses those of the C library.
AngleFunctions angleFunctionsOf(const sim::Scene &scene)
{
    namespace portable = sim::portable;
    const auto *joints = find<sim::Joints>(scene);
    if (!joints || find<sim::GustFront>(scene))
        return {};
    const auto *wind = find<sim::TreeWind>(scene);
    const bool isFastWind = wind && wind->formula() == sim::TreeFormula::corrected;
    const auto atan2 = isFastWind ? portable::fast::atan2 : portable::atan2;
    if (joints->degrees() == sim::publishedDegrees)
        return {portable::sin, portable::cos, atan2};
    return {portable::fast::sin, portable::fast::cos, atan2};
}

}

std::string pluralOf(const std::string &prefix)
{
    if (prefix == "foot")
        return "feet";
    if (prefix == "p")
        return "points";
    for (const char *end : {"ch", "sh", "s", "x"}) {
        if (prefix.ends_with(end))
            return prefix + "es";
    }
    return prefix + "s";
}

Vocabulary vocabularyOf(const sim::Scene &scene)
{
    Vocabulary vocabulary;
    const std::set<std::string> names(scene.names.begin(), scene.names.end());
    std::set<std::string> taken;
    vocabulary.hasCreatures = names.contains("creature0.body");
    if (vocabulary.hasCreatures)
        taken.insert("creatures");
    for (const std::string &name : scene.names) {
        const std::string prefix = prefixOf(name);
        if (prefix.ends_with('_') && prefix != name)
            continue; // one of many arrays, whose number would matter
        const bool isInArray = prefix != name && !prefix.empty() && names.contains(prefix + "0");
        const std::string word = isInArray ? pluralOf(prefix) : name;
        if (!isUsableName(word) || !taken.insert(word).second)
            continue;
        if (isInArray)
            vocabulary.arrays.push_back({word, prefix});
        else
            vocabulary.bodies.push_back(word);
    }
    if (scene.values) {
        for (const auto &[id, value] : scene.values->all()) {
            if (isUsableName(id) && taken.insert(id).second)
                vocabulary.parameters.push_back(id);
        }
    }
    const auto *joints = find<sim::Joints>(scene);
    vocabulary.hasTree = joints && joints->tree().branchCount() == scene.start.pointCount();
    vocabulary.hasGust = find<sim::GustFront>(scene) != nullptr;
    vocabulary.hasSticks = find<sim::Sticks>(scene) != nullptr;
    vocabulary.bodiesTurn = scene.start.angle.rows() > 0;
    vocabulary.hasGait = vocabulary.hasCreatures ? scene.start.gait.rows() > 0 : scene.start.gait.rows() == 1;
    return vocabulary;
}

Binding bind(const Vocabulary &vocabulary, const sim::Scene &scene)
{
    PointsByName pointOf;
    for (std::size_t i = 0; i < scene.names.size(); ++i)
        pointOf.emplace(scene.names[i], static_cast<int>(i));
    Binding binding;
    for (const std::string &name : vocabulary.bodies) {
        const auto found = pointOf.find(name);
        binding.bodies.push_back(found == pointOf.end() ? -1 : found->second);
    }
    for (const Vocabulary::Array &array : vocabulary.arrays)
        binding.arrays.push_back(pointsOf(array.prefix, pointOf));
    if (vocabulary.hasCreatures)
        binding.creatures = creaturesOf(pointOf);
    if (const auto *joints = find<sim::Joints>(scene); vocabulary.hasTree && joints) {
        binding.branches = branchesOf(joints->tree());
        binding.degrees = joints->degrees();
    }
    if (vocabulary.hasSticks)
        binding.sticks = sticksOf(scene);
    binding.otherBodies = unnamedEnds(binding.sticks, binding);
    binding.angleFunctions = angleFunctionsOf(scene);
    for (const std::string &id : vocabulary.parameters)
        binding.parameters.push_back(scene.values && scene.values->has(id) ? (*scene.values)[id] : 0.0);
    if (scene.values)
        binding.seed = scene.values->seed;
    binding.mass = (scene.start.inverseMass == 0.0).select(0.0, 1.0 / scene.start.inverseMass);
    const auto *room = find<sim::RoomLimits>(scene);
    binding.radius = room ? room->halfWidths() : scenes::halfWidths(scene);
    return binding;
}

}
