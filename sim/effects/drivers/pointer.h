#pragma once

#include "sim/effects/drivers/input_reader.h"
#include "sim/effects/effect_description.h"

namespace sim {

namespace descriptions {
extern const EffectDescription pointer;
}

/// Puts a point where the pointer is, from the first time that the pointer is known. List it first: the point then
/// stands there before anything else looks.
class CarriedByPointer : public DescribedEffect<Driver, descriptions::pointer>, public InputReader
{
public:
    explicit CarriedByPointer(int point) : m_point(point) {}

    std::vector<Region> regions(DirectionRule directionRule) const override;
    int count(const State &state, PointRange points) const override;
    Dependence dependence() const override { return Dependence::scene; }
    bool reads(InputKind signal) const override { return signal == InputKind::pointer; }
    void drive(State &state, double h) const override;
    std::vector<LiveValue> explain(const State &before, const State &after, int point) const override;

private:
    int m_point;
};

}
