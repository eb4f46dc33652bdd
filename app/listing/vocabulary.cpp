#include "app/listing/vocabulary.h"

#include "app/listing/language.h"
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
    for (const std::string &id : vocabulary.parameters)
        binding.parameters.push_back(scene.values && scene.values->has(id) ? (*scene.values)[id] : 0.0);
    if (scene.values)
        binding.seed = scene.values->seed;
    binding.mass = (scene.start.inverseMass == 0.0).select(0.0, 1.0 / scene.start.inverseMass);
    binding.radius = scenes::halfWidths(scene);
    return binding;
}

}
