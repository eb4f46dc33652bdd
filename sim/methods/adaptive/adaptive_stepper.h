#pragma once

#include "sim/methods/adaptive/steps/step_rule.h"
#include "sim/pipeline/dense_segment.h"
#include "sim/pipeline/method.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace sim {

/// What an adaptive method computes of one island: equations, surfaces, and how.
class IslandIntegrator
{
public:
    /// `tolerance`: px (or degrees) that a step may be off, in a place or in the way of a frame.
    IslandIntegrator(const Scene &scene, OdeSystem island, const StepRule &how, double tolerance);

    /// How many columns of State::stages it uses.
    static int columns(const StepRule &rule) { return 3 + rule.denseColumns(); }

    OdeSystem system;
    const StepRule &rule;
    double tolerance;
    double longestStep; ///< frames, the longest step
    ContactCandidates contacts;
    std::size_t islandIndex = 0; ///< which of State::ahead is its own
    Eigen::Index column = 0;     ///< where in State::stages its columns begin
};

/// Counts the tries of all islands in a frame, and asks after some whether anybody still waits.
class StepBudget
{
public:
    /// The most tries, rejected ones included, that a frame may take for a scene of `points` points that all hang together.
    static std::int64_t maxTries(int points)
    {
        return std::min(maxTriesOfIsland, (baseBudget + budgetPerPoint * points) / std::max(1, points));
    }
    static constexpr std::int64_t maxTriesOfIsland = 20'000; ///< tries of an island a frame

    /// For a scene of `points` points.
    StepBudget(const ShouldContinue &shouldContinue, int points)
        : m_shouldContinue(shouldContinue), m_left(baseBudget + budgetPerPoint * points)
    {
    }
    /// To be called before each try of an island of `points` points.
    bool isCancelled(int points)
    {
        m_left -= points;
        return m_tries++ % triesBetween == triesBetween - 1 && !m_shouldContinue();
    }
    /// Whether the frame has taken so many tries, whatever the scene, that it is not to go on: a
    /// run that leads nowhere stops in the end, and nobody waits for it.
    bool isExhausted() const { return m_left < 0; }

private:
    static constexpr std::int64_t triesBetween = 20;
    static constexpr std::int64_t baseBudget = 8'000'000; ///< tries times points
    static constexpr std::int64_t budgetPerPoint = 300;   ///< tries

    const ShouldContinue &m_shouldContinue;
    std::int64_t m_tries = 0;
    std::int64_t m_left; ///< tries times points
};

/// Takes an island of a state on to the next frame by steps of its own length. What it computes ahead it leaves in the
/// state.
class AdaptiveStepper
{
public:
    AdaptiveStepper(const IslandIntegrator &integrator, State &state);
    /// Returns whether it has got there or has given up; if not, nobody waited any more on the way.
    bool toNextFrame(StepBudget &budget);
    /// The same; tells each step as it is done, up to the frame.
    bool toNextFrame(StepBudget &budget, const SegmentVisitor &visit);

private:
    /// From a state that holds no step: puts what is past a surface onto it.
    void begin();
    /// Tries a step from where the last one ended. Rejected, it leaves only a shorter length for the next.
    void tryStep();
    void shorten(double h);
    StepAttempt attemptOf(double start, double h);
    /// How far a step may be off, px.
    double exactness() const;
    void accept(const StepAttempt &step);
    /// The step's end, early where a point touches a surface.
    void end(double start, double h);
    /// Whether anything can touch a surface in the step, or leave one.
    bool mayMeet() const;
    /// The same of one surface that nothing rests on: its point is past it at the end, or has turned round.
    bool mayTouch(const ContactCandidates::Candidate &place) const;
    /// Where a point first touches one: the share of the step, above 1 for none.
    double firstTouch(double h) const;
    /// The same of one surface that its point may touch.
    double touch(const ContactCandidates::Candidate &place, double h) const;
    /// Where one that rests is first pulled off its surface: likewise.
    double firstLift(double start, double h);
    /// Bounces what touches a surface at the end of the step.
    void bounce();
    /// Accelerations at the end of the step, of what rests without what its surface takes up.
    void settle();
    void writeOutput();
    /// Notes in the state that its steps lead no further.
    void giveUp();
    /// Tells the visitor of the step that `ahead` describes, from `start` on.
    void reportStep(double start) const;
    void reportFromStart(const Eigen::ArrayXd &place, const Eigen::ArrayXd &speed) const;

    Vec2 at(const double *numbers, int row) const { return {numbers[row], numbers[m_points + row]}; }
    void put(double *numbers, int row, Vec2 value) const
    {
        numbers[row] = value.x;
        numbers[m_points + row] = value.y;
    }
    /// Where the dense output has the point of a row, and its velocity, at a share of the step.
    struct PointAt
    {
        Vec2 x;
        Vec2 v;
    };
    PointAt dense(int row, double h, double theta) const;
    void denseAll(double h, double theta, double *x, double *v) const;
    bool isResting(const ContactCandidates::Candidate &place) const
    {
        return m_accelerations.isResting(place);
    }
    bool free(const ContactCandidates::Candidate &place) const
    {
        return m_state.isDynamic(place.point) && !isResting(place);
    }

    double *column(int number) const { return m_state.stages.data() + m_integrator.column + number * m_size; }
    double *endPlace() const { return column(0); }
    double *endSpeed() const { return column(1); }
    double *endSlope() const { return column(2); }
    double *denseColumns() const { return column(3); }

    const IslandIntegrator &m_integrator;
    State &m_state;
    AdaptiveStep &m_lastStep;
    int m_size;
    int m_points; ///< of the island
    ContactAccelerations m_accelerations;
    double *m_place; ///< where the step began; scratch, like the rest
    double *m_speed;
    double *m_slope;
    double *m_trial;   ///< where it ends, and then what the rule needs
    int m_lifted = -1; ///< the point that has just been pulled off: rounding may not put it back
    std::vector<StageWeights> *m_weights; ///< one a stretch
    NystromWeights *m_nystrom;
    const SegmentVisitor *m_visit = nullptr; ///< who is told of steps; null: nobody
};

}
