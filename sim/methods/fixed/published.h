#pragma once

#include "sim/pipeline/method.h"

namespace sim {

/// The published rule, v = (v + a) damp; x += v, at any step h; group after group, each seeing what already
/// moved. Order 1. Not symmetric in action and reaction: it can make momentum from nothing.
class Published : public Method
{
public:
    std::string id() const override { return "published"; }
    std::string title() const override { return SIM_TEXT("Published"); }
    int order() const override { return 1; }
    std::vector<std::string> requirements() const override { return {"groups"}; }
    DirectionRule directionRule() const override { return DirectionRule::published; }
    Region region() const override { return {"sim/methods/fixed/published.cpp", "published_order"}; }
    void prepareState(State &state) const override;
    std::vector<Phase> phases(const Scene &scene, StepSize size) const override;
};

}
