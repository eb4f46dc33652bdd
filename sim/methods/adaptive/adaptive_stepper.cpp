#include "sim/methods/adaptive/adaptive_stepper.h"

#include "sim/methods/adaptive/steps/nystrom.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace sim {

namespace {

constexpr double longestStep = 10.0; ///< frames
/// What damping leaves in one step is at least e^-2: past that, the polynomial through a step would have to follow
/// e^(c t), which the error at its end does not show.
constexpr double mostDamping = 2.0;

/// Numbers that live for one frame only. Kept by the thread, so that a frame allocates nothing; nothing is read
/// from them that the same frame has not written, but for weights, which know what they are for.
struct Scratch
{
    std::vector<double> numbers;
    std::vector<StageWeights> weights;
    NystromWeights nystrom;
};

Scratch &scratch(std::size_t numbers, std::size_t stretches)
{
    thread_local Scratch kept;
    if (kept.numbers.size() < numbers)
        kept.numbers.resize(numbers);
    if (kept.weights.size() < stretches)
        kept.weights.resize(stretches);
    return kept;
}

/// How long the next step should be: the error of a method of order p grows with the power p + 1 of a step, and
/// one power is left as a margin. `error`: of this step, as a share of the tolerance.
/// Source: Hairer, Norsett and Wanner, "Solving ordinary differential equations I", section II.4.
// Shown lines are short.
// clang-format off
//! [next_step]
double nextStep(
    double h, double error, int order)
{
    double fit = 0.9
        * std::pow(error, -1.0 / order);
    fit = std::clamp(fit, 0.2, 6.0);
    // the same length is cheaper
    bool same = fit > 1 && fit < 1.15;
    return same ? h : h * fit;
}
//! [next_step]
// clang-format on

}

Course::Course(const Scene &scene, Flow island, const StepRule &how, double within)
    : flow(std::move(island)), rule(how), tolerance(within), longest(longestStep),
      touching(scene, flow.runs())
{
    for (const Flow::Stretch &rows : flow.stretches()) {
        if (rows.rate > 0.0 && std::isfinite(rows.rate))
            longest = std::min(longest, mostDamping / rows.rate);
    }
}

Advance::Advance(const Course &course, State &state)
    : m_course(course), m_state(state), m_ahead(state.ahead[course.number]), m_size(course.flow.size()),
      m_points(course.flow.points()), m_pulls(course.flow, course.touching, state)
{
    const int columns = 6 + course.rule.scratchColumns();
    Scratch &numbers = scratch(static_cast<std::size_t>(m_size * columns), course.flow.stretches().size());
    m_place = numbers.numbers.data();
    m_speed = m_place + m_size;
    m_slope = m_speed + m_size;
    m_trial = m_slope + m_size;
    m_weights = &numbers.weights;
    m_nystrom = &numbers.nystrom;
}

Attempt Advance::attemptOf(double start, double h)
{
    Attempt step = {m_pulls, m_course.flow, start, h, m_place, m_speed, m_slope};
    step.endPlace = m_trial;
    step.endSpeed = m_trial + m_size;
    step.endSlope = m_trial + 2 * m_size;
    step.columns = denseColumns();
    step.scratch = m_trial + 3 * m_size;
    step.weights = m_weights;
    step.nystrom = m_nystrom;
    return step;
}

bool Advance::toNextFrame(Patient &patient)
{
    Ahead &ahead = m_ahead;
    //! [adaptive_order]
    if (ahead.to <= 0)
        begin();
    // until a step ends past the frame
    for (int i = 0; ahead.to < 1; ++i) {
        if (patient.leavesOff(m_points))
            return false;
        if (i == Patient::mostOfOne || patient.isSpent()) {
            giveUp();
            return true;
        }
        tryStep();
    }
    // then the frame is read off it
    readOff();
    //! [adaptive_order]
    ahead.from -= 1.0;
    ahead.to -= 1.0;
    return true;
}

void Advance::begin()
{
    m_course.flow.read(m_state, endPlace(), endSpeed());
    for (const Flow::Stretch &rows : m_course.flow.stretches()) {
        if (std::isinf(rows.rate)) // damping stops it at once
            std::fill(endSpeed() + rows.first, endSpeed() + rows.end(), 0.0);
    }
    m_ahead.from = m_ahead.to = 0.0;
    for (const Points &run : m_course.flow.runs())
        m_state.resting.segment(run.first, run.count).setZero();
    const Eigen::ArrayXd place = Eigen::Map<Eigen::ArrayXd>(endPlace(), m_visit ? m_size : 0);
    const Eigen::ArrayXd speed = Eigen::Map<Eigen::ArrayXd>(endSpeed(), m_visit ? m_size : 0);
    bounce();
    settle();
    if (m_visit)
        tellBegun(place, speed);
    if (m_ahead.next > 0.0)
        return;
    // A guess; the first error estimate puts it right.
    const double pull = largest(endSlope(), m_size) + 1e-10;
    const double share =
        std::pow(m_course.tolerance / (pull + m_course.tolerance), 1.0 / m_course.rule.errorOrder());
    m_ahead.next = std::min(m_course.longest, std::clamp(0.5 * share, 1e-6, 1.0));
}

// Shown lines are short.
// clang-format off
//! [try_step]
void Advance::tryStep()
{
    double start = m_ahead.to;
    double h = m_ahead.next;
    std::copy_n(endPlace(), m_size, m_place);
    std::copy_n(endSpeed(), m_size, m_speed);
    std::copy_n(endSlope(), m_size, m_slope);
    Attempt step = attemptOf(start, h);
    const StepRule &rule = m_course.rule;
    double off = rule.attempt(step);
    double share = off / exactness();
    if (share <= 1) // exact enough
        accept(step);
    else // again, with a shorter step
        share = std::min(share, 1e9);
    double next = nextStep(h,
        share + 1e-12, rule.errorOrder());
    m_ahead.next =
        std::min(next, m_course.longest);
    if (m_ahead.to == start)
        shorten(h); // it led nowhere
}
//! [try_step]
// clang-format on

void Advance::shorten(double h)
{
    // Besides rejected steps: a contact at the very start that left all as it was. The polynomial is too rough there.
    m_ahead.next = std::min(m_ahead.next, 0.5 * h);
}

double Advance::exactness() const
{
    // Nothing is more exact than the digits of a place allow.
    const double digits = 8.0 * std::numeric_limits<double>::epsilon() * largest(m_place, m_size);
    return std::max(m_course.tolerance, digits);
}

void Advance::accept(const Attempt &step)
{
    Ahead &ahead = m_ahead;
    ahead.from = step.start;
    ahead.length = step.h;
    ahead.to = step.start + step.h;
    std::copy_n(step.endPlace, m_size, endPlace());
    std::copy_n(step.endSpeed, m_size, endSpeed());
    std::copy_n(step.endSlope, m_size, endSlope());
    const bool readsFrame = step.start < 1.0 && ahead.to > 1.0;
    const bool meets = mayMeet();
    if (readsFrame || meets || m_visit)
        m_course.rule.makeDense(step);
    if (meets)
        end(step.start, step.h);
    if (m_visit)
        tell(step.start);
}

Advance::Moving Advance::dense(int row, double h, double theta) const
{
    Moving at;
    const auto find = [&](int i, double &place, double &speed) {
        for (const Flow::Stretch &rows : m_course.flow.stretches()) {
            if (i < rows.first || i >= rows.end())
                continue;
            m_course.rule.dense(denseColumns(), m_size, i, i + 1, m_course.rule.instant(rows.rate, h, theta),
                                &place, &speed);
        }
    };
    find(row, at.x.x, at.v.x);
    find(m_points + row, at.x.y, at.v.y);
    return at;
}

void Advance::denseAll(double h, double theta, double *x, double *v) const
{
    for (const Flow::Stretch &rows : m_course.flow.stretches()) {
        m_course.rule.dense(denseColumns(), m_size, rows.first, rows.end(),
                            m_course.rule.instant(rows.rate, h, theta), x + rows.first, v + rows.first);
    }
}

// Shown lines are short.
// clang-format off
//! [read_off]
void Advance::readOff()
{
    Ahead &ahead = m_ahead;
    double *x = endPlace();
    double *v = endSpeed();
    if (ahead.to > 1) {
        // inside the step
        double h = ahead.length;
        double part = (1 - ahead.from) / h;
        x = m_place;
        v = m_speed;
        denseAll(h, part, x, v);
    }
    m_pulls.clockTo(1);
    m_course.flow.place(x, m_state);
    m_course.flow.push(v, m_state);
}
//! [read_off]
// clang-format on

void Advance::giveUp()
{
    int worst = 0;
    for (int i = 0; i < m_points; ++i) {
        if (!(length(at(endSlope(), i)) <= length(at(endSlope(), worst))))
            worst = i;
    }
    m_ahead.stuck = m_course.flow.pointAt(worst);
}

namespace {

constexpr double touching = 1e-10; ///< px, closer counts as in touch
constexpr double none = 2.0;       ///< past the end of the step

}

void Advance::end(double start, double h)
{
    const double touchAt = firstTouch(h);
    const double liftAt = firstLift(start, h);
    const double first = std::min(touchAt, liftAt);
    if (first > 1.0)
        return;
    denseAll(h, first, endPlace(), endSpeed());
    m_ahead.to = start + first * h;
    if (liftAt > first) {
        m_lifted = -1;
    } else {
        for (const Touching::Place &place : m_course.touching.places()) {
            if (rests(place) && m_lifted == place.point)
                m_state.resting[place.point] &= ~place.bit;
        }
    }
    bounce();
    settle();
}

bool Advance::mayTouch(const Touching::Place &place) const
{
    const Surface &surface = place.surface;
    if (gap(surface, at(endPlace(), place.row)) < 0.0)
        return true;
    return away(surface, at(m_speed, place.row)) <= 0.0 && away(surface, at(endSpeed(), place.row)) > 0.0;
}

bool Advance::mayMeet() const
{
    const std::vector<Touching::Place> &places = m_course.touching.places();
    return std::any_of(places.begin(), places.end(),
                       [&](const Touching::Place &place) { return rests(place) || mayTouch(place); });
}

double Advance::firstTouch(double h) const
{
    double first = none;
    for (const Touching::Place &place : m_course.touching.places()) {
        if (!free(place) || !mayTouch(place))
            continue;
        // One look spares the search for what is still in the air when another has touched.
        const bool late = first <= 1.0 && gap(place.surface, dense(place.row, h, first).x) > 0.0;
        if (!late)
            first = std::min(first, touch(place, h));
    }
    return first;
}

double Advance::touch(const Touching::Place &place, double h) const
{
    const Surface &surface = place.surface;
    const auto gapAt = [&](double theta) { return gap(surface, dense(place.row, h, theta).x); };
    const auto speedAt = [&](double theta) { return away(surface, dense(place.row, h, theta).v); };
    if (gap(surface, at(endPlace(), place.row)) < 0.0) {
        // What has just bounced stands on the surface: it can only come back after its highest point.
        const bool leaves = away(surface, at(m_speed, place.row)) > 0.0;
        const bool returns = away(surface, at(endSpeed(), place.row)) > 0.0;
        const double highest = leaves && !returns ? firstRoot(speedAt, 0.0, 1.0) : 0.0;
        if (gapAt(highest) <= 0.0)
            return highest;
        return firstRoot(gapAt, highest, 1.0);
    }
    // It may have been past the surface in between.
    const double lowest = firstRoot([&](double theta) { return -speedAt(theta); }, 0.0, 1.0);
    if (gapAt(lowest) >= 0.0 || gapAt(0.0) < 0.0)
        return none;
    return firstRoot(gapAt, 0.0, lowest);
}

double Advance::firstLift(double start, double h)
{
    m_lifted = -1;
    double *x = m_trial, *a = m_trial + m_size;
    const auto pullAt = [&](double theta) {
        denseAll(h, theta, x, a);
        m_pulls.whole(x, start + theta * h, a);
    };
    // The pull of a place's surface less what it takes up: below 0 it lifts.
    const auto press = [&](const Touching::Place &place) { return -away(place.surface, at(a, place.row)); };
    std::vector<const Touching::Place *> lifting; // the last is looked at first
    const auto keepLifting = [&](double theta) {
        pullAt(theta);
        std::erase_if(lifting, [&](const Touching::Place *place) { return press(*place) >= 0.0; });
    };
    const std::vector<Touching::Place> &places = m_course.touching.places();
    for (auto place = places.rbegin(); place != places.rend(); ++place) {
        if (rests(*place))
            lifting.push_back(&*place);
    }
    if (lifting.empty())
        return none;
    keepLifting(1.0);
    double first = none;
    // Each search takes all forces many times: what still rests when another has lifted is not searched for.
    while (!lifting.empty()) {
        const Touching::Place &place = *lifting.back();
        lifting.pop_back();
        const auto pressAt = [&](double theta) {
            pullAt(theta);
            return press(place);
        };
        const double lift = firstRoot(pressAt, 0.0, 1.0);
        if (lift < first) {
            first = lift;
            m_lifted = place.point;
        }
        if (!lifting.empty())
            keepLifting(first);
    }
    return first;
}

void Advance::bounce()
{
    for (const Touching::Place &place : m_course.touching.places()) {
        if (!free(place))
            continue;
        const Surface &surface = place.surface;
        const Vec2 x = at(endPlace(), place.row), v = at(endSpeed(), place.row);
        const double distance = gap(surface, x);
        if (distance < 0.0)
            put(endPlace(), place.row, x - distance * surface.normal);
        if (distance <= touching && away(surface, v) < 0.0)
            put(endSpeed(), place.row, bounced(surface, v));
    }
}

void Advance::settle()
{
    m_pulls.whole(endPlace(), m_ahead.to, endSlope());
    for (const Touching::Place &place : m_course.touching.places()) {
        if (!m_state.feels(place.point))
            continue;
        const Surface &surface = place.surface;
        const double pull = away(surface, at(endSlope(), place.row));
        const Vec2 x = at(endPlace(), place.row), v = at(endSpeed(), place.row);
        const double into = std::max(0.0, -pull);
        const bool slow = std::abs(away(surface, v)) <= restingSpeed(into, m_course.tolerance) &&
                          gap(surface, x) <= touching;
        if (rests(place) && pull > 0.0)
            m_state.resting[place.point] &= ~place.bit;
        else if (!rests(place) && slow && pull <= 0.0 && place.point != m_lifted)
            m_state.resting[place.point] |= place.bit;
        if (rests(place))
            put(endSpeed(), place.row, held(surface, v));
    }
    m_pulls.hold(endSlope());
}

bool Advance::toNextFrame(Patient &patient, const LapVisit &visit)
{
    m_visit = &visit;
    if (m_ahead.to > 0.0)
        tell(0.0);
    return toNextFrame(patient);
}

void Advance::tell(double start) const
{
    const Ahead &ahead = m_ahead;
    Lap lap;
    lap.flow = &m_course.flow;
    lap.start = start;
    lap.end = std::min(ahead.to, 1.0);
    lap.at = [this, from = ahead.from, h = ahead.length](double time, Eigen::ArrayXd &place,
                                                         Eigen::ArrayXd &speed) {
        place.resize(m_size);
        speed.resize(m_size);
        denseAll(h, (time - from) / h, place.data(), speed.data());
    };
    if (ahead.to > 1.0) {
        lap.at(1.0, lap.nextPlace, lap.nextSpeed);
    } else {
        lap.nextPlace = Eigen::Map<const Eigen::ArrayXd>(endPlace(), m_size);
        lap.nextSpeed = Eigen::Map<const Eigen::ArrayXd>(endSpeed(), m_size);
    }
    (*m_visit)(lap);
}

void Advance::tellBegun(const Eigen::ArrayXd &place, const Eigen::ArrayXd &speed) const
{
    Lap lap; // of no length: what stood past a surface is put onto it
    lap.flow = &m_course.flow;
    lap.at = [&](double, Eigen::ArrayXd &x, Eigen::ArrayXd &v) {
        x = place;
        v = speed;
    };
    lap.nextPlace = Eigen::Map<const Eigen::ArrayXd>(endPlace(), m_size);
    lap.nextSpeed = Eigen::Map<const Eigen::ArrayXd>(endSpeed(), m_size);
    (*m_visit)(lap);
}

}
