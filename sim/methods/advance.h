#pragma once

#include "sim/flow.h"
#include "sim/lap.h"
#include "sim/methods/pair.h"
#include "sim/methods/touching.h"

namespace sim {

/// What an adaptive method computes: equations, surfaces, and how.
class Course
{
public:
    /// `tolerance`: px (or degrees) that a step may be off, in a place or in the way of a frame.
    Course(const Scene &scene, const Pair &how, Directions directions, double tolerance);

    /// How many columns of State::stages it uses.
    static int columns(const Pair &pair) { return 3 + pair.denseColumns(); }
    std::vector<EffectPtr> effects() const;

    Flow flow;
    const Pair &pair;
    double tolerance;
    double longest; ///< frames, the longest step
    Touching touching;
    std::vector<EffectPtr> contacts;
};

/// Takes a state on to the next frame by steps of its own length. What it computes ahead it leaves in the state.
class Advance
{
public:
    Advance(const Course &course, State &state);
    void toNextFrame();
    /// The same; tells each step as it is done, up to the frame.
    void toNextFrame(const LapVisit &visit);

private:
    /// From a state that holds no step: puts what is past a surface onto it.
    void begin();
    /// Tries a step from where the last one ended. Rejected, it leaves only a shorter length for the next.
    void tryStep();
    void shorten(double h);
    void setWeights(double h);
    void stage(int number, double start, double h);
    /// The largest error of the step just tried, as a share of the tolerance.
    double error(double h) const;
    /// The largest number that the stages' slopes come to with these weights, px/frame; infinite if one is not finite.
    double estimate(const Tableau::Row &weights) const;
    void accept(double start, double h);
    void makeDense(double h);
    /// The step's end, early where a point touches a surface.
    void end(double start, double h);
    /// Whether anything can touch a surface in the step, or leave one.
    bool mayMeet() const;
    /// Where a point first touches one: the share of the step, above 1 for none.
    double firstTouch(double h) const;
    double touch(const Touching::Place &place, double h) const;
    /// Where one that rests is first pulled off its surface: likewise.
    double firstLift(double start, double h);
    /// Bounces what touches a surface at the end of the step.
    void bounce();
    /// Accelerations at the end of the step, of what rests without what its surface takes up.
    void settle();
    void hold(double *numbers) const;
    void readOff();
    void giveUp();
    /// Tells the visitor of the step that `ahead` describes, from `start` on.
    void tell(double start) const;
    void tellBegun(const Eigen::ArrayXd &place, const Eigen::ArrayXd &speed) const;

    void clockTo(double time);
    Vec2 at(const double *numbers, int point) const { return {numbers[point], numbers[m_points + point]}; }
    void put(double *numbers, int point, Vec2 value) const
    {
        numbers[point] = value.x;
        numbers[m_points + point] = value.y;
    }
    /// Where the dense output has a point, and its velocity, at a share of the step.
    struct Moving
    {
        Vec2 x;
        Vec2 v;
    };
    Moving dense(int point, double h, double theta) const;
    void denseAll(double h, double theta, double *x, double *v) const;
    bool rests(const Touching::Place &place) const { return (m_state.resting[place.point] & place.bit) != 0; }
    bool free(const Touching::Place &place) const { return m_state.feels(place.point) && !rests(place); }

    double *column(int number) const { return m_state.stages.data() + number * m_size; }
    double *endPlace() const { return column(0); }
    double *endSpeed() const { return column(1); }
    double *endSlope() const { return column(2); }
    double *denseColumns() const { return column(3); }
    double *speedOf(int number) const;
    double *slopeOf(int number) const;

    const Course &m_course;
    State &m_state;
    int m_size;
    int m_points;
    int m_stages;
    double m_clock = 0.0; ///< frames since the last whole one, to which the drivers have been taken
    double *m_place;      ///< where the step began; scratch, like the rest
    double *m_speed;
    double *m_trial;
    double *m_speeds;
    double *m_slopes;
    double *m_lift;
    int m_lifted = -1; ///< the point that has just been pulled off: rounding may not put it back
    std::vector<StageWeights> &m_weights; ///< one a stretch
    const LapVisit *m_visit = nullptr;    ///< who is told of steps; null: nobody
};

}
