#pragma once

#include "sim/effects/effect_description.h"
#include "sim/scene/input_reader.h"

namespace sim {

namespace described {
extern const Description pointer;
}

/// Puts a point where the pointer is, from the first time that the pointer is known. List it first: the point then
/// stands there before anything else looks.
class CarriedByPointer : public Described<Driver, described::pointer>, public InputReader
{
public:
    explicit CarriedByPointer(int point) : m_point(point) {}

    std::vector<Region> regions(Directions directions) const override;
    int count(const State &state, Points points) const override;
    Sees sees() const override { return Sees::scene; }
    bool reads(Signal signal) const override { return signal == Signal::pointer; }
    void drive(State &state, double h) const override;
    std::vector<Live> explain(const State &before, const State &after, int point) const override;

private:
    int m_point;
};

}
