#pragma once

#include "sim/scene/effect.h"

#include <cstdint>
#include <memory>

namespace support {

/// A force of 0 that counts the points for which it was computed.
class CountingForce : public sim::Force
{
public:
    explicit CountingForce(std::shared_ptr<std::int64_t> count,
                           sim::Dependence dependence = sim::Dependence::coupledPoints)
        : m_count(std::move(count)), m_dependence(dependence)
    {
    }
    std::string id() const override { return "counting"; }
    std::string title() const override { return "counting"; }
    sim::EffectKind kind() const override { return sim::EffectKind::spring; }
    std::vector<sim::Region> regions(sim::DirectionRule) const override { return {}; }
    int count(const sim::State &, sim::PointRange points) const override { return points.count; }
    sim::Dependence dependence() const override { return m_dependence; }
    void add(const sim::State &, sim::PointRange movers, double, sim::DirectionRule,
             Eigen::ArrayX2d &) const override
    {
        *m_count += movers.count;
    }
    std::vector<sim::LiveValue> explain(const sim::State &, int, sim::DirectionRule) const override
    {
        return {};
    }

private:
    std::shared_ptr<std::int64_t> m_count;
    sim::Dependence m_dependence;
};

}
