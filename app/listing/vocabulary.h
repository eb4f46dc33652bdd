#pragma once

#include "sim/scene/scene.h"

#include "sim/scene/values.h"

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

namespace listing {

/// The names that a scene adds to a listing: its bodies and parameters. The number of bodies in an array and the values
/// of parameters do not matter.
struct Vocabulary
{
    /// Bodies with consecutive numbers, such as "foot0", "foot1"...
    struct Array
    {
        std::string name;   ///< in the listing: "feet"
        std::string prefix; ///< of the names in the scene: "foot"
        friend bool operator==(const Array &, const Array &) = default;
    };
    std::vector<std::string> bodies; ///< single ones, such as "body"
    std::vector<Array> arrays;
    std::vector<std::string> parameters; ///< ids that are no other name of the language
    bool bodiesTurn = false;             ///< whether bodies have an angle and a spin
    bool hasCreatures = false;           ///< whether there are "creature0.body", "creature1.body"...
    /// Whether the scene remembers a gait clock; one for each creature if there are creatures.
    bool hasGait = false;
    bool hasTree = false;   ///< whether "branch0", "branch1"... are the branches of a tree
    bool hasGust = false;   ///< whether the scene remembers a gust
    bool hasSticks = false; ///< whether sticks keep bodies apart
    friend bool operator==(const Vocabulary &, const Vocabulary &) = default;
};

/// Returns the vocabulary of `scene`, which sceneOf() built. Bodies whose names are not words are left out, except
/// the body and the feet of creatures, such as "creature0.foot1". So are those with two numbers, such as "tentacle0_1".
Vocabulary vocabularyOf(const sim::Scene &scene);

/// Returns the name of the array of bodies with the names `prefix`0, `prefix`1...: "feet" for "foot".
std::string pluralOf(const std::string &prefix);

/// The functions of angles that the effects of a scene use. A listing uses the same ones, so that both have the same
/// bits.
struct AngleFunctions
{
    double (*sin)(double rad) = std::sin;
    double (*cos)(double rad) = std::cos;
    double (*atan2)(double y, double x) = std::atan2;
};

/// Where the names of a vocabulary are in a scene, and what does not change during its frames.
struct Binding
{
    struct Creature
    {
        int body = 0;
        std::vector<int> feet;
    };
    /// What does not change of a branch of a tree.
    struct Branch
    {
        double rest = 0.0;    ///< degrees
        double scale = 0.0;   ///< share of the trunk
        double length = 0.0;  ///< px
        double inertia = 0.0; ///< see sim::BranchMechanics
        int firstChild = -1;  ///< index in the array of branches
        int children = 0;
    };
    std::vector<int> bodies;              ///< point of each single body; -1: the scene has none
    std::vector<std::vector<int>> arrays; ///< points of each array
    std::vector<Creature> creatures;      ///< points of each creature
    std::vector<Branch> branches;         ///< of the array "branches", if it is a tree
    std::vector<sim::Stick> sticks;       ///< between points of the scene
    std::vector<int> otherBodies;         ///< points that have no name, but a stick ends there
    std::vector<double> parameters;       ///< value of each parameter
    AngleFunctions angleFunctions;
    double degrees = 1.0; ///< in trees: number of degrees per radian
    std::uint64_t seed = 1;
    Eigen::ArrayXd mass;   ///< per point; 0 for a handle, which forces do not move
    Eigen::ArrayXd radius; ///< px, per point
};

/// Finds the names of `vocabulary` in `scene`. A parameter that the scene does not have is 0.
Binding bind(const Vocabulary &vocabulary, const sim::Scene &scene);

}
