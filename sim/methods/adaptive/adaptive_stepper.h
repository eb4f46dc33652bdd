#pragma once

#include "sim/methods/adaptive/steps/step_rule.h"
#include "sim/pipeline/dense_segment.h"
#include "sim/pipeline/method.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace sim {

/// The equations of one island, its surfaces, and the rule for steps.
class IslandIntegrator
{
public:
    /// `stepTolerance`: px (or degrees), maximum error of a step in a position and in the displacement of a
    /// frame.
    IslandIntegrator(const Scene &scene, OdeSystem island, const StepRule &stepRule, double stepTolerance);

    /// Returns the number of columns of State::stages that it uses, with OdeSystem::size() numbers each.
    static int columns(const StepRule &rule) { return 3 + rule.denseColumns(); }

    OdeSystem system;
    const StepRule &rule;
    double tolerance;   ///< px or degrees
    double longestStep; ///< frames, maximum length of a step
    ContactCandidates contacts;
    std::size_t islandIndex = 0; ///< index in State::adaptiveSteps
    Eigen::Index column = 0;     ///< index of its first number in State::stages
};

/// The step budget of one frame. It counts the attempted steps of all islands, and checks for cancellation
/// now and then.
class StepBudget
{
public:
    /// Returns the maximum number of attempts per frame, rejected ones included, for a scene that is one
    /// island of `points` points.
    static std::int64_t maxTries(int points)
    {
        return std::min(maxTriesOfIsland, (baseBudget + budgetPerPoint * points) / std::max(1, points));
    }
    static constexpr std::int64_t maxTriesOfIsland = 20'000; ///< attempts per island and frame

    /// `points`: number of points in the scene.
    StepBudget(const ShouldContinue &shouldContinue, int points)
        : m_shouldContinue(shouldContinue), m_remaining(baseBudget + budgetPerPoint * points)
    {
    }
    /// Counts an attempt of an island of `points` points, which follows. Returns whether the frame was
    /// cancelled.
    bool isCancelled(int points)
    {
        m_remaining -= points;
        return m_tries++ % triesBetweenChecks == triesBetweenChecks - 1 && !m_shouldContinue();
    }
    /// Returns whether the budget is spent. A run whose steps become shorter and shorter stops then.
    bool isExhausted() const { return m_remaining < 0; }

private:
    static constexpr std::int64_t triesBetweenChecks = 20;
    static constexpr std::int64_t baseBudget = 8'000'000; ///< attempts times points
    static constexpr std::int64_t budgetPerPoint = 300;   ///< attempts

    const ShouldContinue &m_shouldContinue;
    std::int64_t m_tries = 0;
    std::int64_t m_remaining; ///< attempts times points
};

/// Advances one island of a state to the next frame by adaptive steps. Time that it computes beyond the frame
/// stays in the state (see AdaptiveStep).
class AdaptiveStepper
{
public:
    AdaptiveStepper(const IslandIntegrator &integrator, State &state);
    /// Returns true if the island reached the next frame or got stuck, false if the frame was cancelled.
    bool toNextFrame(StepBudget &budget);
    /// Does the same, and calls `visit` for the part of each finished step up to the next frame.
    bool toNextFrame(StepBudget &budget, const SegmentVisitor &visit);

private:
    /// Starts from a state without a step: moves points behind a surface onto it and guesses the length of
    /// the first step.
    void begin();
    /// Attempts a step from the end of the last one. If the step is rejected, only the planned length becomes
    /// shorter.
    void tryStep();
    /// Makes the next step at most half as long as `h`.
    void shorten(double h);
    StepAttempt attemptOf(double start, double h);
    /// Returns the maximum error of a step, px.
    double maxError() const;
    /// Makes an attempt the last step, up to its first contact event.
    void accept(const StepAttempt &step);
    /// Ends the step at its first contact event, if it has one.
    void endAtContactEvent(double start, double h);
    /// Returns whether the step may have a contact event: a point may touch a surface or leave one.
    bool mayHaveContactEvent() const;
    /// Returns whether a point that does not rest on a surface may touch it in the step: at the end it is
    /// behind the surface, or it approached the surface first and then moved away.
    bool mayTouch(const ContactCandidates::Candidate &candidate) const;
    /// Returns the time of the first touch as a share of the step, or a number above 1 if there is none.
    double firstTouch(double h) const;
    /// Returns the same for one candidate.
    double touch(const ContactCandidates::Candidate &candidate, double h) const;
    /// Returns the time at which the first resting point is pulled off its surface, likewise. Sets
    /// `m_lifted`.
    double firstLift(double start, double h);
    /// Reflects the velocities of points that touch a surface at the end of the step.
    void bounce();
    /// Updates which points rest at the end of the step, and computes the accelerations there.
    void settle();
    /// Writes positions and velocities at the next frame to the state.
    void writeOutput();
    /// Sets AdaptiveStep::stuckPoint, because the step budget is spent.
    void giveUp();
    /// Calls the visitor for the last step, from `start` on.
    void reportStep(double start) const;
    /// Calls the visitor for the jump that begin() made from these positions and velocities.
    void reportFromStart(const Eigen::ArrayXd &position, const Eigen::ArrayXd &velocity) const;

    Vec2 at(const double *numbers, int row) const { return {numbers[row], numbers[m_points + row]}; }
    void put(double *numbers, int row, Vec2 value) const
    {
        numbers[row] = value.x;
        numbers[m_points + row] = value.y;
    }
    /// Position and velocity of a point within a step.
    struct PointAt
    {
        Vec2 x;
        Vec2 v;
    };
    /// Returns the dense output of the point in `row` at the share `theta` of a step of length `h`.
    PointAt dense(int row, double h, double theta) const;
    /// Computes the dense output of all rows of q.
    void denseAll(double h, double theta, double *x, double *v) const;
    bool isResting(const ContactCandidates::Candidate &candidate) const
    {
        return m_accelerations.isResting(candidate);
    }
    /// Returns whether the point of `candidate` can hit its surface: it is dynamic and does not rest there.
    bool canHit(const ContactCandidates::Candidate &candidate) const
    {
        return m_state.isDynamic(candidate.point) && !isResting(candidate);
    }

    /// Returns a column of State::stages that belongs to the island.
    double *column(int number) const { return m_state.stages.data() + m_integrator.column + number * m_size; }
    double *endX() const { return column(0); }
    double *endV() const { return column(1); }
    double *endA() const { return column(2); }
    double *denseColumns() const { return column(3); }

    const IslandIntegrator &m_integrator;
    State &m_state;
    AdaptiveStep &m_lastStep;
    int m_size;
    int m_points; ///< of the island
    ContactAccelerations m_accelerations;
    double *m_x;       ///< positions at the start of the step; in scratch memory, like the next three
    double *m_v;       ///< velocities at the start of the step
    double *m_a;       ///< accelerations at the start of the step
    double *m_trial;   ///< the end of the attempted step, followed by the scratch memory of the rule
    int m_lifted = -1; ///< the point that has just left its surface; rounding must not put it back
    std::vector<StageWeights> *m_weights; ///< one per rate range
    NystromWeights *m_nystrom;
    const SegmentVisitor *m_visitor = nullptr; ///< receives steps; may be null
};

}
