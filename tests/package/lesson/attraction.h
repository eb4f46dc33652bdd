#pragma once

#include "sim/effects/effect_description.h"

extern const sim::EffectDescription attractionDescription;

/// The attraction of a planet at a fixed place: the acceleration falls with the square of the distance.
class Attraction : public sim::DescribedEffect<sim::Force, attractionDescription>
{
public:
    /// `strength` in px^3/frame^2.
    Attraction(sim::Vec2 planet, double strength) : m_planet(planet), m_strength(strength) {}

    std::vector<sim::Region> regions(sim::DirectionRule directionRule) const override;
    int count(const sim::State &state, sim::PointRange points) const override;
    sim::Dependence dependence() const override { return sim::Dependence::coupledPoints; }
    void add(const sim::State &state, sim::PointRange movers, double scale, sim::DirectionRule directionRule,
             Eigen::ArrayX2d &into) const override;
    std::optional<double> potentialEnergy(const sim::State &state) const override;
    std::vector<sim::LiveValue> explain(const sim::State &state, int mover,
                                        sim::DirectionRule directionRule) const override;

private:
    sim::Vec2 m_planet;
    double m_strength;
};
