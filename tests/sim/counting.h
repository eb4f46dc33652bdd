#pragma once

#include "sim/scene/effect.h"

#include <cstdint>
#include <memory>

namespace support {

/// A pull that is always 0, and counts for how many points it is asked for.
class Counting : public sim::Force
{
public:
    explicit Counting(std::shared_ptr<std::int64_t> count, sim::Sees sees = sim::Sees::tied)
        : m_count(std::move(count)), m_sees(sees)
    {
    }
    std::string id() const override { return "counting"; }
    std::string title() const override { return "counting"; }
    sim::Kind kind() const override { return sim::Kind::spring; }
    std::vector<sim::Region> regions(sim::Directions) const override { return {}; }
    int count(const sim::State &, sim::Points points) const override { return points.count; }
    sim::Sees sees() const override { return m_sees; }
    void add(const sim::State &, sim::Points movers, double, sim::Directions,
             Eigen::ArrayX2d &) const override
    {
        *m_count += movers.count;
    }
    std::vector<sim::Live> explain(const sim::State &, int, sim::Directions) const override { return {}; }

private:
    std::shared_ptr<std::int64_t> m_count;
    sim::Sees m_sees;
};

}
