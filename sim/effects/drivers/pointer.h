#pragma once

#include "sim/effects/drivers/input_reader.h"
#include "sim/effects/effect_description.h"

namespace sim {

namespace descriptions {
extern const EffectDescription pointer;
}

/// Moves a point to the pointer, as soon as the pointer's position is known. List it before all other
/// effects, so that these read the new position.
class CarriedByPointer : public DescribedEffect<Driver, descriptions::pointer>, public InputReader
{
public:
    explicit CarriedByPointer(int point) : m_point(point) {}

    std::vector<Region> regions(DirectionRule directionRule) const override;
    int count(const State &state, PointRange points) const override;
    Dependence dependence() const override { return Dependence::scene; }
    bool reads(InputKind kind) const override { return kind == InputKind::pointer; }
    void drive(State &state, double h) const override;
    std::vector<LiveValue> explain(const State &before, const State &after, int point) const override;

private:
    int m_point;
};

}
