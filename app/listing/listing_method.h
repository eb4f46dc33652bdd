#pragma once

#include "app/listing/program.h"
#include "sim/pipeline/method.h"

namespace listing {

/// The effect that a phase of ListingMethod shows: the listing itself. It has no role, so other methods ignore it.
class ListingEffect : public sim::Effect
{
public:
    explicit ListingEffect(bool dependsOnTime) : m_dependsOnTime(dependsOnTime) {}

    sim::Role role() const override { return {}; }
    std::string id() const override { return "listing"; }
    std::string title() const override { return SIM_TEXT("your code"); }
    sim::EffectKind kind() const override { return sim::EffectKind::motion; }
    std::vector<sim::Region> regions(sim::DirectionRule) const override { return {}; }
    int count(const sim::State &, sim::PointRange points) const override { return points.count; }
    sim::Dependence dependence() const override
    {
        return m_dependsOnTime ? sim::Dependence::time : sim::Dependence::scene;
    }

private:
    bool m_dependsOnTime;
};

/// A method that is a program: each step runs the listing once. A step is a frame, and it has one phase. The
/// effects of the scene do not act; only their parameters reach the listing, by name.
///
/// An error in a frame sets State::stepFailed, so the run ends before that frame. Program::run() on
/// Track::stateAfterInput() of that moment returns the error.
class ListingMethod : public sim::Method
{
public:
    explicit ListingMethod(std::shared_ptr<const Program> program) : m_program(std::move(program)) {}

    const Program &program() const { return *m_program; }
    std::shared_ptr<const Program> programPtr() const { return m_program; }

    std::string id() const override { return "listing"; }
    std::string title() const override { return SIM_TEXT("Your code"); }
    int order() const override { return 1; }
    std::vector<std::string> requirements() const override { return {}; }
    sim::DirectionRule directionRule() const override { return sim::DirectionRule::published; }
    /// Returns an empty region: its source is Program::text().
    sim::Region region() const override { return {}; }
    void prepareState(sim::State &state) const override;
    /// @throws sim::Error "listing-needs-frame-steps" (h) unless a step is one frame
    std::vector<sim::Phase> phases(const sim::Scene &scene, sim::StepSize step) const override;

private:
    std::shared_ptr<const Program> m_program;
};

}
