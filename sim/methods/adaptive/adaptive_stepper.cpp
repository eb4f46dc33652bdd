#include "sim/methods/adaptive/adaptive_stepper.h"

#include "sim/methods/adaptive/steps/nystrom.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace sim {

namespace {

constexpr double maxStep = 10.0; ///< frames
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

IslandIntegrator::IslandIntegrator(const Scene &scene, OdeSystem island, const StepRule &how, double within)
    : system(std::move(island)), rule(how), tolerance(within), longestStep(maxStep),
      contacts(scene, system.ranges())
{
    for (const OdeSystem::RateRange &rows : system.rateRanges()) {
        if (rows.rate > 0.0 && std::isfinite(rows.rate))
            longestStep = std::min(longestStep, mostDamping / rows.rate);
    }
}

AdaptiveStepper::AdaptiveStepper(const IslandIntegrator &integrator, State &state)
    : m_integrator(integrator), m_state(state), m_lastStep(state.adaptiveSteps[integrator.islandIndex]),
      m_size(integrator.system.size()), m_points(integrator.system.points()),
      m_accelerations(integrator.system, integrator.contacts, state)
{
    const int columns = 6 + integrator.rule.scratchColumns();
    Scratch &numbers =
        scratch(static_cast<std::size_t>(m_size * columns), integrator.system.rateRanges().size());
    m_place = numbers.numbers.data();
    m_speed = m_place + m_size;
    m_slope = m_speed + m_size;
    m_trial = m_slope + m_size;
    m_weights = &numbers.weights;
    m_nystrom = &numbers.nystrom;
}

StepAttempt AdaptiveStepper::attemptOf(double start, double h)
{
    StepAttempt step = {m_accelerations, m_integrator.system, start, h, m_place, m_speed, m_slope};
    step.endPlace = m_trial;
    step.endSpeed = m_trial + m_size;
    step.endSlope = m_trial + 2 * m_size;
    step.columns = denseColumns();
    step.scratch = m_trial + 3 * m_size;
    step.weights = m_weights;
    step.nystrom = m_nystrom;
    return step;
}

bool AdaptiveStepper::toNextFrame(StepBudget &budget)
{
    AdaptiveStep &lastStep = m_lastStep;
    //! [adaptive_order]
    if (lastStep.end <= 0)
        begin();
    // until a step ends past the frame
    for (int i = 0; lastStep.end < 1; ++i) {
        if (budget.isCancelled(m_points))
            return false;
        if (i == StepBudget::maxTriesOfIsland || budget.isExhausted()) {
            giveUp();
            return true;
        }
        tryStep();
    }
    // then the frame is read off it
    writeOutput();
    //! [adaptive_order]
    lastStep.start -= 1.0;
    lastStep.end -= 1.0;
    return true;
}

void AdaptiveStepper::begin()
{
    m_integrator.system.readState(m_state, endPlace(), endSpeed());
    for (const OdeSystem::RateRange &rows : m_integrator.system.rateRanges()) {
        if (std::isinf(rows.rate)) // damping stops it at once
            std::fill(endSpeed() + rows.first, endSpeed() + rows.end(), 0.0);
    }
    m_lastStep.start = m_lastStep.end = 0.0;
    for (const PointRange &range : m_integrator.system.ranges())
        m_state.restingContacts.segment(range.first, range.count).setZero();
    const Eigen::ArrayXd place = Eigen::Map<Eigen::ArrayXd>(endPlace(), m_visit ? m_size : 0);
    const Eigen::ArrayXd speed = Eigen::Map<Eigen::ArrayXd>(endSpeed(), m_visit ? m_size : 0);
    bounce();
    settle();
    if (m_visit)
        reportFromStart(place, speed);
    if (m_lastStep.nextLength > 0.0)
        return;
    // A guess; the first error estimate puts it right.
    const double pull = maxAbs(endSlope(), m_size) + 1e-10;
    const double share = std::pow(m_integrator.tolerance / (pull + m_integrator.tolerance),
                                  1.0 / m_integrator.rule.errorOrder());
    m_lastStep.nextLength = std::min(m_integrator.longestStep, std::clamp(0.5 * share, 1e-6, 1.0));
}

// Shown lines are short.
// clang-format off
//! [try_step]
void AdaptiveStepper::tryStep()
{
    double start = m_lastStep.end;
    double h = m_lastStep.nextLength;
    std::copy_n(endPlace(), m_size, m_place);
    std::copy_n(endSpeed(), m_size, m_speed);
    std::copy_n(endSlope(), m_size, m_slope);
    StepAttempt step = attemptOf(start, h);
    const StepRule &rule = m_integrator.rule;
    double off = rule.attempt(step);
    double share = off / exactness();
    if (share <= 1) // exact enough
        accept(step);
    else // again, with a shorter step
        share = std::min(share, 1e9);
    double next = nextStep(h,
        share + 1e-12, rule.errorOrder());
    m_lastStep.nextLength =
        std::min(next, m_integrator.longestStep);
    if (m_lastStep.end == start)
        shorten(h); // it led nowhere
}
//! [try_step]
// clang-format on

void AdaptiveStepper::shorten(double h)
{
    // Besides rejected steps: a contact at the very start that left all as it was. The polynomial is too rough there.
    m_lastStep.nextLength = std::min(m_lastStep.nextLength, 0.5 * h);
}

double AdaptiveStepper::exactness() const
{
    // Nothing is more exact than the digits of a place allow.
    const double digits = 8.0 * std::numeric_limits<double>::epsilon() * maxAbs(m_place, m_size);
    return std::max(m_integrator.tolerance, digits);
}

void AdaptiveStepper::accept(const StepAttempt &step)
{
    AdaptiveStep &lastStep = m_lastStep;
    lastStep.start = step.start;
    lastStep.length = step.h;
    lastStep.end = step.start + step.h;
    std::copy_n(step.endPlace, m_size, endPlace());
    std::copy_n(step.endSpeed, m_size, endSpeed());
    std::copy_n(step.endSlope, m_size, endSlope());
    const bool readsFrame = step.start < 1.0 && lastStep.end > 1.0;
    const bool meets = mayMeet();
    if (readsFrame || meets || m_visit)
        m_integrator.rule.makeDense(step);
    if (meets)
        end(step.start, step.h);
    if (m_visit)
        reportStep(step.start);
}

AdaptiveStepper::PointAt AdaptiveStepper::dense(int row, double h, double theta) const
{
    PointAt at;
    const auto find = [&](int i, double &place, double &speed) {
        for (const OdeSystem::RateRange &rows : m_integrator.system.rateRanges()) {
            if (i < rows.first || i >= rows.end())
                continue;
            m_integrator.rule.dense(denseColumns(), m_size, i, i + 1,
                                    m_integrator.rule.instant(rows.rate, h, theta), &place, &speed);
        }
    };
    find(row, at.x.x, at.v.x);
    find(m_points + row, at.x.y, at.v.y);
    return at;
}

void AdaptiveStepper::denseAll(double h, double theta, double *x, double *v) const
{
    for (const OdeSystem::RateRange &rows : m_integrator.system.rateRanges()) {
        m_integrator.rule.dense(denseColumns(), m_size, rows.first, rows.end(),
                                m_integrator.rule.instant(rows.rate, h, theta), x + rows.first,
                                v + rows.first);
    }
}

// Shown lines are short.
// clang-format off
//! [read_off]
void AdaptiveStepper::writeOutput()
{
    AdaptiveStep &lastStep = m_lastStep;
    double *x = endPlace();
    double *v = endSpeed();
    if (lastStep.end > 1) {
        // inside the step
        double h = lastStep.length;
        double part = (1 - lastStep.start) / h;
        x = m_place;
        v = m_speed;
        denseAll(h, part, x, v);
    }
    m_accelerations.advanceDriversTo(1);
    m_integrator.system.writePositions(x, m_state);
    m_integrator.system.writeVelocities(v, m_state);
}
//! [read_off]
// clang-format on

void AdaptiveStepper::giveUp()
{
    int worst = 0;
    for (int i = 0; i < m_points; ++i) {
        if (!(length(at(endSlope(), i)) <= length(at(endSlope(), worst))))
            worst = i;
    }
    m_lastStep.stuckPoint = m_integrator.system.pointAt(worst);
}

namespace {

constexpr double touching = 1e-10; ///< px, closer counts as in touch
constexpr double none = 2.0;       ///< past the end of the step

}

void AdaptiveStepper::end(double start, double h)
{
    const double touchAt = firstTouch(h);
    const double liftAt = firstLift(start, h);
    const double first = std::min(touchAt, liftAt);
    if (first > 1.0)
        return;
    denseAll(h, first, endPlace(), endSpeed());
    m_lastStep.end = start + first * h;
    if (liftAt > first) {
        m_lifted = -1;
    } else {
        for (const ContactCandidates::Candidate &place : m_integrator.contacts.all()) {
            if (isResting(place) && m_lifted == place.point)
                m_state.restingContacts[place.point] &= ~place.bit;
        }
    }
    bounce();
    settle();
}

bool AdaptiveStepper::mayTouch(const ContactCandidates::Candidate &place) const
{
    const Surface &surface = place.surface;
    if (gap(surface, at(endPlace(), place.row)) < 0.0)
        return true;
    return normalVelocity(surface, at(m_speed, place.row)) <= 0.0 &&
           normalVelocity(surface, at(endSpeed(), place.row)) > 0.0;
}

bool AdaptiveStepper::mayMeet() const
{
    const std::vector<ContactCandidates::Candidate> &places = m_integrator.contacts.all();
    return std::any_of(places.begin(), places.end(), [&](const ContactCandidates::Candidate &place) {
        return isResting(place) || mayTouch(place);
    });
}

double AdaptiveStepper::firstTouch(double h) const
{
    double first = none;
    for (const ContactCandidates::Candidate &place : m_integrator.contacts.all()) {
        if (!free(place) || !mayTouch(place))
            continue;
        // One look spares the search for what is still in the air when another has touched.
        const bool late = first <= 1.0 && gap(place.surface, dense(place.row, h, first).x) > 0.0;
        if (!late)
            first = std::min(first, touch(place, h));
    }
    return first;
}

double AdaptiveStepper::touch(const ContactCandidates::Candidate &place, double h) const
{
    const Surface &surface = place.surface;
    const auto gapAt = [&](double theta) { return gap(surface, dense(place.row, h, theta).x); };
    const auto speedAt = [&](double theta) { return normalVelocity(surface, dense(place.row, h, theta).v); };
    if (gap(surface, at(endPlace(), place.row)) < 0.0) {
        // What has just bounced stands on the surface: it can only come back after its highest point.
        const bool leaves = normalVelocity(surface, at(m_speed, place.row)) > 0.0;
        const bool returns = normalVelocity(surface, at(endSpeed(), place.row)) > 0.0;
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

double AdaptiveStepper::firstLift(double start, double h)
{
    m_lifted = -1;
    double *x = m_trial, *a = m_trial + m_size;
    const auto pullAt = [&](double theta) {
        denseAll(h, theta, x, a);
        m_accelerations.unconstrained(x, start + theta * h, a);
    };
    // The pull of a place's surface less what it takes up: below 0 it lifts.
    const auto press = [&](const ContactCandidates::Candidate &place) {
        return -normalVelocity(place.surface, at(a, place.row));
    };
    std::vector<const ContactCandidates::Candidate *> lifting; // the last is looked at first
    const auto keepLifting = [&](double theta) {
        pullAt(theta);
        std::erase_if(lifting,
                      [&](const ContactCandidates::Candidate *place) { return press(*place) >= 0.0; });
    };
    const std::vector<ContactCandidates::Candidate> &places = m_integrator.contacts.all();
    for (auto place = places.rbegin(); place != places.rend(); ++place) {
        if (isResting(*place))
            lifting.push_back(&*place);
    }
    if (lifting.empty())
        return none;
    keepLifting(1.0);
    double first = none;
    // Each search takes all forces many times: what still rests when another has lifted is not searched for.
    while (!lifting.empty()) {
        const ContactCandidates::Candidate &place = *lifting.back();
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

void AdaptiveStepper::bounce()
{
    for (const ContactCandidates::Candidate &place : m_integrator.contacts.all()) {
        if (!free(place))
            continue;
        const Surface &surface = place.surface;
        const Vec2 x = at(endPlace(), place.row), v = at(endSpeed(), place.row);
        const double distance = gap(surface, x);
        if (distance < 0.0)
            put(endPlace(), place.row, x - distance * surface.normal);
        if (distance <= touching && normalVelocity(surface, v) < 0.0)
            put(endSpeed(), place.row, bounced(surface, v));
    }
}

void AdaptiveStepper::settle()
{
    m_accelerations.unconstrained(endPlace(), m_lastStep.end, endSlope());
    for (const ContactCandidates::Candidate &place : m_integrator.contacts.all()) {
        if (!m_state.isDynamic(place.point))
            continue;
        const Surface &surface = place.surface;
        const double pull = normalVelocity(surface, at(endSlope(), place.row));
        const Vec2 x = at(endPlace(), place.row), v = at(endSpeed(), place.row);
        const double into = std::max(0.0, -pull);
        const bool slow =
            std::abs(normalVelocity(surface, v)) <= restingSpeed(into, m_integrator.tolerance) &&
            gap(surface, x) <= touching;
        if (isResting(place) && pull > 0.0)
            m_state.restingContacts[place.point] &= ~place.bit;
        else if (!isResting(place) && slow && pull <= 0.0 && place.point != m_lifted)
            m_state.restingContacts[place.point] |= place.bit;
        if (isResting(place))
            put(endSpeed(), place.row, restingAcceleration(surface, v));
    }
    m_accelerations.removeConstrained(endSlope());
}

bool AdaptiveStepper::toNextFrame(StepBudget &budget, const SegmentVisitor &visit)
{
    m_visit = &visit;
    if (m_lastStep.end > 0.0)
        reportStep(0.0);
    return toNextFrame(budget);
}

void AdaptiveStepper::reportStep(double start) const
{
    const AdaptiveStep &lastStep = m_lastStep;
    DenseSegment segment;
    segment.system = &m_integrator.system;
    segment.start = start;
    segment.end = std::min(lastStep.end, 1.0);
    segment.evaluate = [this, from = lastStep.start, h = lastStep.length](double time, Eigen::ArrayXd &place,
                                                                          Eigen::ArrayXd &speed) {
        place.resize(m_size);
        speed.resize(m_size);
        denseAll(h, (time - from) / h, place.data(), speed.data());
    };
    if (lastStep.end > 1.0) {
        segment.evaluate(1.0, segment.positionAfter, segment.velocityAfter);
    } else {
        segment.positionAfter = Eigen::Map<const Eigen::ArrayXd>(endPlace(), m_size);
        segment.velocityAfter = Eigen::Map<const Eigen::ArrayXd>(endSpeed(), m_size);
    }
    (*m_visit)(segment);
}

void AdaptiveStepper::reportFromStart(const Eigen::ArrayXd &place, const Eigen::ArrayXd &speed) const
{
    DenseSegment segment; // of no length: what stood past a surface is put onto it
    segment.system = &m_integrator.system;
    segment.evaluate = [&](double, Eigen::ArrayXd &x, Eigen::ArrayXd &v) {
        x = place;
        v = speed;
    };
    segment.positionAfter = Eigen::Map<const Eigen::ArrayXd>(endPlace(), m_size);
    segment.velocityAfter = Eigen::Map<const Eigen::ArrayXd>(endSpeed(), m_size);
    (*m_visit)(segment);
}

}
