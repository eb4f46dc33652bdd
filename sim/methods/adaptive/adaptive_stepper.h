#pragma once

#include "sim/methods/adaptive/steps/step_rule.h"
#include "sim/pipeline/dense_segment.h"
#include "sim/pipeline/method.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace sim {

/// What an adaptive method computes of one island: equations, surfaces, and how.
class Course
{
public:
    /// `tolerance`: px (or degrees) that a step may be off, in a place or in the way of a frame.
    Course(const Scene &scene, Flow island, const StepRule &how, double tolerance);

    /// How many columns of State::stages it uses.
    static int columns(const StepRule &rule) { return 3 + rule.denseColumns(); }

    Flow flow;
    const StepRule &rule;
    double tolerance;
    double longest; ///< frames, the longest step
    Touching touching;
    std::size_t number = 0;  ///< which of State::ahead is its own
    Eigen::Index column = 0; ///< where in State::stages its columns begin
};

/// Counts the tries of all islands in a frame, and asks after some whether anybody still waits.
class Patient
{
public:
    /// The most tries, rejected ones included, that a frame may take for a scene of `points` points that all hang together.
    static std::int64_t mostTries(int points)
    {
        return std::min(mostOfOne, (atLeast + forEach * points) / std::max(1, points));
    }
    static constexpr std::int64_t mostOfOne = 20'000; ///< tries of an island a frame

    /// For a scene of `points` points.
    Patient(const GoesOn &goesOn, int points) : m_goesOn(goesOn), m_left(atLeast + forEach * points) {}
    /// To be called before each try of an island of `points` points.
    bool leavesOff(int points)
    {
        m_left -= points;
        return m_tries++ % triesBetween == triesBetween - 1 && !m_goesOn();
    }
    /// Whether the frame has taken so many tries, whatever the scene, that it is not to go on: a
    /// run that leads nowhere stops in the end, and nobody waits for it.
    bool isSpent() const { return m_left < 0; }

private:
    static constexpr std::int64_t triesBetween = 20;
    static constexpr std::int64_t atLeast = 8'000'000; ///< tries times points
    static constexpr std::int64_t forEach = 300;       ///< tries

    const GoesOn &m_goesOn;
    std::int64_t m_tries = 0;
    std::int64_t m_left; ///< tries times points
};

/// Takes an island of a state on to the next frame by steps of its own length. What it computes ahead it leaves in the
/// state.
class Advance
{
public:
    Advance(const Course &course, State &state);
    /// Returns whether it has got there or has given up; if not, nobody waited any more on the way.
    bool toNextFrame(Patient &patient);
    /// The same; tells each step as it is done, up to the frame.
    bool toNextFrame(Patient &patient, const LapVisit &visit);

private:
    /// From a state that holds no step: puts what is past a surface onto it.
    void begin();
    /// Tries a step from where the last one ended. Rejected, it leaves only a shorter length for the next.
    void tryStep();
    void shorten(double h);
    Attempt attemptOf(double start, double h);
    /// How far a step may be off, px.
    double exactness() const;
    void accept(const Attempt &step);
    /// The step's end, early where a point touches a surface.
    void end(double start, double h);
    /// Whether anything can touch a surface in the step, or leave one.
    bool mayMeet() const;
    /// The same of one surface that nothing rests on: its point is past it at the end, or has turned round.
    bool mayTouch(const Touching::Place &place) const;
    /// Where a point first touches one: the share of the step, above 1 for none.
    double firstTouch(double h) const;
    /// The same of one surface that its point may touch.
    double touch(const Touching::Place &place, double h) const;
    /// Where one that rests is first pulled off its surface: likewise.
    double firstLift(double start, double h);
    /// Bounces what touches a surface at the end of the step.
    void bounce();
    /// Accelerations at the end of the step, of what rests without what its surface takes up.
    void settle();
    void readOff();
    /// Notes in the state that its steps lead no further.
    void giveUp();
    /// Tells the visitor of the step that `ahead` describes, from `start` on.
    void tell(double start) const;
    void tellBegun(const Eigen::ArrayXd &place, const Eigen::ArrayXd &speed) const;

    Vec2 at(const double *numbers, int row) const { return {numbers[row], numbers[m_points + row]}; }
    void put(double *numbers, int row, Vec2 value) const
    {
        numbers[row] = value.x;
        numbers[m_points + row] = value.y;
    }
    /// Where the dense output has the point of a row, and its velocity, at a share of the step.
    struct Moving
    {
        Vec2 x;
        Vec2 v;
    };
    Moving dense(int row, double h, double theta) const;
    void denseAll(double h, double theta, double *x, double *v) const;
    bool rests(const Touching::Place &place) const { return m_pulls.rests(place); }
    bool free(const Touching::Place &place) const { return m_state.feels(place.point) && !rests(place); }

    double *column(int number) const { return m_state.stages.data() + m_course.column + number * m_size; }
    double *endPlace() const { return column(0); }
    double *endSpeed() const { return column(1); }
    double *endSlope() const { return column(2); }
    double *denseColumns() const { return column(3); }

    const Course &m_course;
    State &m_state;
    Ahead &m_ahead;
    int m_size;
    int m_points; ///< of the island
    Pulls m_pulls;
    double *m_place; ///< where the step began; scratch, like the rest
    double *m_speed;
    double *m_slope;
    double *m_trial;   ///< where it ends, and then what the rule needs
    int m_lifted = -1; ///< the point that has just been pulled off: rounding may not put it back
    std::vector<StageWeights> *m_weights; ///< one a stretch
    NystromWeights *m_nystrom;
    const LapVisit *m_visit = nullptr; ///< who is told of steps; null: nobody
};

}
