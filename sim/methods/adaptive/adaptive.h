#pragma once

#include "sim/pipeline/method.h"

namespace sim {

class StepRule;

/// A method that chooses its steps so that each makes at most a given error. Its steps end where they like, also
/// past a frame: whole frames are read off the polynomial between a step's ends. A step ends early where a point
/// touches a surface or leaves one, so the jumps of a motion do not cost it its order.
class Adaptive : public Method
{
public:
    int order() const override;
    Stepping stepping() const override { return Stepping::adaptive; }
    StepLimit stepLimit() const override { return StepLimit::tolerance; }
    int evaluationsPerStep() const override { return 0; }
    std::vector<std::string> requirements() const override;
    DirectionRule directionRule() const override { return DirectionRule::regularised; }
    Region region() const override { return {"sim/methods/adaptive/adaptive_stepper.cpp", "adaptive_order"}; }
    void prepareState(State &state) const override;
    std::vector<Phase> phases(const Scene &scene, StepSize size) const override;

protected:
    /// `shown`: the source of a step, and of its numbers.
    Adaptive(const StepRule &rule, std::vector<Region> shown) : m_rule(rule), m_shown(std::move(shown)) {}

private:
    const StepRule &m_rule;
    std::vector<Region> m_shown;
};

}
