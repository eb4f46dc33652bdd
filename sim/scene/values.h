#pragma once

#include "sim/scene/blueprint.h"

#include <cmath>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace sim {

/// A rigid stick between two points.
struct Stick
{
    int a = 0;
    int b = 0;
    double length = 0.0; ///< px
    double share = 0.5;  ///< of a wrong length, the part that `a` makes good; `b` does the rest
    friend bool operator==(const Stick &, const Stick &) = default;
};

/// What a scene is made from: parameters by id (a choice by its position), the seed of all that is random, and the
/// points and sticks, or the whole scene, that a file gives in place of the step's own.
class Values
{
public:
    /// @throws std::out_of_range for an id that is not there
    double operator[](const std::string &id) const { return m_numbers.at(id); }
    int integer(const std::string &id) const { return static_cast<int>(std::lround(m_numbers.at(id))); }
    bool has(const std::string &id) const { return m_numbers.contains(id); }
    void set(const std::string &id, double value) { m_numbers[id] = value; }
    const std::map<std::string, double> &all() const { return m_numbers; }
    friend bool operator==(const Values &a, const Values &b)
    {
        return a.m_numbers == b.m_numbers && a.seed == b.seed && a.points == b.points &&
               a.sticks == b.sticks && sameScene(a, b);
    }

    std::uint64_t seed = 1;
    std::optional<int> points;                  ///< how many
    std::optional<std::vector<Stick>> sticks;   ///< in the order in which they are enforced
    std::shared_ptr<const Blueprint> blueprint; ///< of the whole scene; null: the step sets it up

private:
    static bool sameScene(const Values &a, const Values &b)
    {
        return a.blueprint == b.blueprint || (a.blueprint && b.blueprint && *a.blueprint == *b.blueprint);
    }

    std::map<std::string, double> m_numbers;
};

}
