#pragma once

#include <cmath>
#include <cstdint>
#include <map>
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

/// The numbers a scene is made from: parameters by id (a choice by its position), the seed of all that is random,
/// and the points and sticks that a file gives in place of the step's own.
class Values
{
public:
    /// @throws std::out_of_range for an id that is not there
    double operator[](const std::string &id) const { return m_numbers.at(id); }
    int whole(const std::string &id) const { return static_cast<int>(std::lround(m_numbers.at(id))); }
    bool has(const std::string &id) const { return m_numbers.contains(id); }
    void set(const std::string &id, double value) { m_numbers[id] = value; }
    const std::map<std::string, double> &all() const { return m_numbers; }
    friend bool operator==(const Values &, const Values &) = default;

    std::uint64_t seed = 1;
    std::optional<int> points;                ///< how many
    std::optional<std::vector<Stick>> sticks; ///< in the order in which they are enforced

private:
    std::map<std::string, double> m_numbers;
};

}
