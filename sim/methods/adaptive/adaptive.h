#pragma once

#include "sim/pipeline/method.h"

namespace sim {

class StepRule;

/// A method with adaptive steps: it chooses their length so that each makes at most a given error. A step may
/// end after the next frame. Whole frames are interpolated within a step (dense output). A step ends early at
/// a contact event, where a point touches a surface or leaves it, so jumps of the motion do not reduce the
/// order.
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
    /// `shown`: the source regions of a step and its coefficients.
    Adaptive(const StepRule &rule, std::vector<Region> shown) : m_rule(rule), m_shown(std::move(shown)) {}

private:
    const StepRule &m_rule;
    std::vector<Region> m_shown;
};

}
