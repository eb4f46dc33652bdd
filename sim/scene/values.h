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

/// A rigid stick between the points `a` and `b`.
struct Stick
{
    int a = 0;
    int b = 0;
    double length = 0.0; ///< px
    double share = 0.5;  ///< fraction of a length error that `a` corrects; `b` corrects the rest
    friend bool operator==(const Stick &, const Stick &) = default;
};

/// The input from which a scene is made: parameters by id (a choice as its index) and the random seed. An
/// experiment file may also replace the number of points, the sticks or the whole scene of a lesson step.
class Values
{
public:
    /// Returns the parameter `id`.
    /// @throws std::out_of_range for an unknown id
    double operator[](const std::string &id) const { return m_numbers.at(id); }
    /// Returns the parameter `id`, rounded to a whole number.
    /// @throws std::out_of_range for an unknown id
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
    std::optional<int> points; ///< number of points; empty: that of the lesson step
    /// In the order in which they are enforced. Empty: those of the lesson step.
    std::optional<std::vector<Stick>> sticks;
    std::shared_ptr<const Blueprint> blueprint; ///< the whole scene; null: that of the lesson step

private:
    static bool sameScene(const Values &a, const Values &b)
    {
        return a.blueprint == b.blueprint || (a.blueprint && b.blueprint && *a.blueprint == *b.blueprint);
    }

    std::map<std::string, double> m_numbers;
};

}
