#pragma once

#include <cmath>
#include <cstdint>
#include <map>
#include <string>

namespace sim {

/// The numbers a scene is made from: parameters by id (a choice by its position), and the seed of all that is
/// random.
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

private:
    std::map<std::string, double> m_numbers;
};

}
