#pragma once

#include "sim/pipeline/method.h"

namespace sim {

/// The method of the tutorials, generalised to any step h: v = (v + a) damp, x += v. Groups move one after
/// another, and each sees the new positions of the earlier ones. Order 1. Action and reaction differ, so
/// momentum is not conserved.
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
