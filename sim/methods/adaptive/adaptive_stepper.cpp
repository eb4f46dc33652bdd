#include "sim/methods/adaptive/adaptive_stepper.h"

#include "sim/methods/adaptive/steps/nystrom.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace sim {

namespace {

constexpr double maxStep = 10.0; ///< frames
/// frames. A shorter step makes no progress: the accelerations are not finite beyond this time.
constexpr double minStep = 1e-14;
/// The maximum of damping rate times step length. Beyond it the dense output would have to follow e^(c t),
/// and the error at the end of the step does not measure that.
constexpr double maxDamping = 2.0;

/// Scratch memory of one thread, so that a frame allocates nothing. A frame reads only numbers that it has
/// written itself, except the weights, which remember their arguments.
struct Scratch
{
    std::vector<double> numbers;
    std::vector<StageWeights> weights;
    NystromWeights nystrom;
};

Scratch &scratch(std::size_t numbers, std::size_t rateRanges)
{
    thread_local Scratch kept;
    if (kept.numbers.size() < numbers)
        kept.numbers.resize(numbers);
    if (kept.weights.size() < rateRanges)
        kept.weights.resize(rateRanges);
    return kept;
}

/// Returns the length of the next step, in frames. The error of a method of order p is proportional to h^(p +
/// 1). The formula uses h^p as a margin. `error`: of this step, as a share of the tolerance.
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

IslandIntegrator::IslandIntegrator(const Scene &scene, OdeSystem island, const StepRule &stepRule,
                                   double stepTolerance)
    : system(std::move(island)), rule(stepRule), tolerance(stepTolerance), longestStep(maxStep),
      contacts(scene, system.ranges())
{
    for (const OdeSystem::RateRange &rows : system.rateRanges()) {
        if (rows.rate > 0.0 && std::isfinite(rows.rate))
            longestStep = std::min(longestStep, maxDamping / rows.rate);
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
    m_x = numbers.numbers.data();
    m_v = m_x + m_size;
    m_a = m_v + m_size;
    m_trial = m_a + m_size;
    m_weights = &numbers.weights;
    m_nystrom = &numbers.nystrom;
}

StepAttempt AdaptiveStepper::attemptOf(double start, double h)
{
    StepAttempt step = {m_accelerations, m_integrator.system, start, h, m_x, m_v, m_a};
    step.endX = m_trial;
    step.endV = m_trial + m_size;
    step.endA = m_trial + 2 * m_size;
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
        if (i == StepBudget::maxTriesOfIsland || budget.isExhausted() || lastStep.nextLength < minStep) {
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
    m_integrator.system.readState(m_state, endX(), endV());
    for (const OdeSystem::RateRange &rows : m_integrator.system.rateRanges()) {
        if (std::isinf(rows.rate)) // damping stops it at once
            std::fill(endV() + rows.first, endV() + rows.end(), 0.0);
    }
    m_lastStep.start = m_lastStep.end = 0.0;
    for (const PointRange &range : m_integrator.system.ranges())
        m_state.restingContacts.segment(range.first, range.count).setZero();
    const Eigen::ArrayXd position = Eigen::Map<Eigen::ArrayXd>(endX(), m_visitor ? m_size : 0);
    const Eigen::ArrayXd velocity = Eigen::Map<Eigen::ArrayXd>(endV(), m_visitor ? m_size : 0);
    bounce();
    settle();
    if (m_visitor)
        reportFromStart(position, velocity);
    if (m_lastStep.nextLength > 0.0)
        return;
    // A guess, which the first error estimate corrects.
    const double acceleration = maxAbs(endA(), m_size) + 1e-10;
    const double share = std::pow(m_integrator.tolerance / (acceleration + m_integrator.tolerance),
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
    std::copy_n(endX(), m_size, m_x);
    std::copy_n(endV(), m_size, m_v);
    std::copy_n(endA(), m_size, m_a);
    StepAttempt step = attemptOf(start, h);
    const StepRule &rule = m_integrator.rule;
    double error = rule.attempt(step);
    double share = error / maxError();
    if (share <= 1) // exact enough
        accept(step);
    else // again, with a shorter step
        share = std::min(share, 1e9);
    double next = nextStep(h,
        share + 1e-12, rule.errorOrder());
    m_lastStep.nextLength =
        std::min(next, m_integrator.longestStep);
    if (m_lastStep.end == start)
        shorten(h); // no progress
}
//! [try_step]
// clang-format on

void AdaptiveStepper::shorten(double h)
{
    // After a rejected step, or a contact event at the very start that changed nothing because the dense
    // output is not accurate enough there.
    m_lastStep.nextLength = std::min(m_lastStep.nextLength, 0.5 * h);
}

double AdaptiveStepper::maxError() const
{
    // The digits of a position limit the accuracy.
    const double digits = 8.0 * std::numeric_limits<double>::epsilon() * maxAbs(m_x, m_size);
    return std::max(m_integrator.tolerance, digits);
}

void AdaptiveStepper::accept(const StepAttempt &step)
{
    AdaptiveStep &lastStep = m_lastStep;
    lastStep.start = step.start;
    lastStep.length = step.h;
    lastStep.end = step.start + step.h;
    std::copy_n(step.endX, m_size, endX());
    std::copy_n(step.endV, m_size, endV());
    std::copy_n(step.endA, m_size, endA());
    const bool containsFrame = step.start < 1.0 && lastStep.end > 1.0;
    const bool mayMeet = mayHaveContactEvent();
    if (containsFrame || mayMeet || m_visitor)
        m_integrator.rule.makeDense(step);
    if (mayMeet)
        endAtContactEvent(step.start, step.h);
    if (m_visitor)
        reportStep(step.start);
}

AdaptiveStepper::PointAt AdaptiveStepper::dense(int row, double h, double theta) const
{
    PointAt at;
    const auto find = [&](int i, double &position, double &velocity) {
        for (const OdeSystem::RateRange &rows : m_integrator.system.rateRanges()) {
            if (i < rows.first || i >= rows.end())
                continue;
            m_integrator.rule.dense(denseColumns(), m_size, i, i + 1,
                                    m_integrator.rule.instant(rows.rate, h, theta), &position, &velocity);
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
    double *x = endX();
    double *v = endV();
    if (lastStep.end > 1) {
        // inside the step
        double h = lastStep.length;
        double part = (1 - lastStep.start) / h;
        x = m_x;
        v = m_v;
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
        if (!(length(at(endA(), i)) <= length(at(endA(), worst))))
            worst = i;
    }
    m_lastStep.stuckPoint = m_integrator.system.pointAt(worst);
}

namespace {

constexpr double contactDistance = 1e-10; ///< px, a point closer to a surface touches it
constexpr double noEvent = 2.0;           ///< a time after the end of the step

}

void AdaptiveStepper::endAtContactEvent(double start, double h)
{
    const double touchAt = firstTouch(h);
    const double liftAt = firstLift(start, h);
    const double first = std::min(touchAt, liftAt);
    if (first > 1.0)
        return;
    denseAll(h, first, endX(), endV());
    m_lastStep.end = start + first * h;
    if (liftAt > first) {
        m_lifted = -1;
    } else {
        for (const ContactCandidates::Candidate &candidate : m_integrator.contacts.all()) {
            if (isResting(candidate) && m_lifted == candidate.point)
                m_state.restingContacts[candidate.point] &= ~candidate.bit;
        }
    }
    bounce();
    settle();
}

bool AdaptiveStepper::mayTouch(const ContactCandidates::Candidate &candidate) const
{
    const Surface &surface = candidate.surface;
    if (gap(surface, at(endX(), candidate.row)) < 0.0)
        return true;
    return normalVelocity(surface, at(m_v, candidate.row)) <= 0.0 &&
           normalVelocity(surface, at(endV(), candidate.row)) > 0.0;
}

bool AdaptiveStepper::mayHaveContactEvent() const
{
    const std::vector<ContactCandidates::Candidate> &candidates = m_integrator.contacts.all();
    return std::any_of(candidates.begin(), candidates.end(),
                       [&](const ContactCandidates::Candidate &candidate) {
                           return isResting(candidate) || mayTouch(candidate);
                       });
}

double AdaptiveStepper::firstTouch(double h) const
{
    double first = noEvent;
    for (const ContactCandidates::Candidate &candidate : m_integrator.contacts.all()) {
        if (!canHit(candidate) || !mayTouch(candidate))
            continue;
        // A single evaluation avoids the search for a point that is still in the air at the first touch so
        // far.
        const bool late = first <= 1.0 && gap(candidate.surface, dense(candidate.row, h, first).x) > 0.0;
        if (!late)
            first = std::min(first, touch(candidate, h));
    }
    return first;
}

double AdaptiveStepper::touch(const ContactCandidates::Candidate &candidate, double h) const
{
    const Surface &surface = candidate.surface;
    const auto gapAt = [&](double theta) { return gap(surface, dense(candidate.row, h, theta).x); };
    const auto speedAt = [&](double theta) {
        return normalVelocity(surface, dense(candidate.row, h, theta).v);
    };
    if (gap(surface, at(endX(), candidate.row)) < 0.0) {
        // A point that has just bounced is on the surface. It can only return after its highest point.
        const bool leaves = normalVelocity(surface, at(m_v, candidate.row)) > 0.0;
        const bool returns = normalVelocity(surface, at(endV(), candidate.row)) > 0.0;
        const double highest = leaves && !returns ? firstRoot(speedAt, 0.0, 1.0) : 0.0;
        if (gapAt(highest) <= 0.0)
            return highest;
        return firstRoot(gapAt, highest, 1.0);
    }
    // It may have been behind the surface in between.
    const double lowest = firstRoot([&](double theta) { return -speedAt(theta); }, 0.0, 1.0);
    if (gapAt(lowest) >= 0.0 || gapAt(0.0) < 0.0)
        return noEvent;
    return firstRoot(gapAt, 0.0, lowest);
}

double AdaptiveStepper::firstLift(double start, double h)
{
    m_lifted = -1;
    double *x = m_trial, *a = m_trial + m_size;
    const auto computeAccelerations = [&](double theta) {
        denseAll(h, theta, x, a);
        m_accelerations.unconstrained(x, a, start + theta * h, a);
    };
    // The acceleration that presses a point against its surface. Below 0 the point lifts.
    const auto press = [&](const ContactCandidates::Candidate &candidate) {
        return -normalVelocity(candidate.surface, at(a, candidate.row));
    };
    std::vector<const ContactCandidates::Candidate *> lifting; // the last is searched first
    const auto keepLifting = [&](double theta) {
        computeAccelerations(theta);
        std::erase_if(
            lifting, [&](const ContactCandidates::Candidate *candidate) { return press(*candidate) >= 0.0; });
    };
    const std::vector<ContactCandidates::Candidate> &candidates = m_integrator.contacts.all();
    for (auto candidate = candidates.rbegin(); candidate != candidates.rend(); ++candidate) {
        if (isResting(*candidate))
            lifting.push_back(&*candidate);
    }
    if (lifting.empty())
        return noEvent;
    keepLifting(1.0);
    double first = noEvent;
    // Each search computes all forces many times, so points that still rest at the first lift so far are
    // skipped.
    while (!lifting.empty()) {
        const ContactCandidates::Candidate &candidate = *lifting.back();
        lifting.pop_back();
        const auto pressAt = [&](double theta) {
            computeAccelerations(theta);
            return press(candidate);
        };
        const double lift = firstRoot(pressAt, 0.0, 1.0);
        if (lift < first) {
            first = lift;
            m_lifted = candidate.point;
        }
        if (!lifting.empty())
            keepLifting(first);
    }
    return first;
}

void AdaptiveStepper::bounce()
{
    for (const ContactCandidates::Candidate &candidate : m_integrator.contacts.all()) {
        if (!canHit(candidate))
            continue;
        const Surface &surface = candidate.surface;
        const Vec2 x = at(endX(), candidate.row), v = at(endV(), candidate.row);
        const double distance = gap(surface, x);
        if (distance < 0.0)
            put(endX(), candidate.row, x - distance * surface.normal);
        if (distance <= contactDistance && normalVelocity(surface, v) < 0.0)
            put(endV(), candidate.row, bounced(surface, v));
    }
}

void AdaptiveStepper::settle()
{
    m_accelerations.unconstrained(endX(), endV(), m_lastStep.end, endA());
    for (const ContactCandidates::Candidate &candidate : m_integrator.contacts.all()) {
        if (!m_state.isDynamic(candidate.point))
            continue;
        const Surface &surface = candidate.surface;
        const double pull = normalVelocity(surface, at(endA(), candidate.row));
        const Vec2 x = at(endX(), candidate.row), v = at(endV(), candidate.row);
        const double pressing = std::max(0.0, -pull);
        const bool slow =
            std::abs(normalVelocity(surface, v)) <= restingSpeed(pressing, m_integrator.tolerance) &&
            gap(surface, x) <= contactDistance;
        if (isResting(candidate) && pull > 0.0)
            m_state.restingContacts[candidate.point] &= ~candidate.bit;
        else if (!isResting(candidate) && slow && pull <= 0.0 && candidate.point != m_lifted)
            m_state.restingContacts[candidate.point] |= candidate.bit;
        if (isResting(candidate))
            put(endV(), candidate.row, restingAcceleration(surface, v));
    }
    m_accelerations.removeConstrained(endA());
}

bool AdaptiveStepper::toNextFrame(StepBudget &budget, const SegmentVisitor &visit)
{
    m_visitor = &visit;
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
    segment.evaluate = [this, stepStart = lastStep.start, h = lastStep.length](
                           double time, Eigen::ArrayXd &position, Eigen::ArrayXd &velocity) {
        position.resize(m_size);
        velocity.resize(m_size);
        denseAll(h, (time - stepStart) / h, position.data(), velocity.data());
    };
    if (lastStep.end > 1.0) {
        segment.evaluate(1.0, segment.positionAfter, segment.velocityAfter);
    } else {
        segment.positionAfter = Eigen::Map<const Eigen::ArrayXd>(endX(), m_size);
        segment.velocityAfter = Eigen::Map<const Eigen::ArrayXd>(endV(), m_size);
    }
    (*m_visitor)(segment);
}

void AdaptiveStepper::reportFromStart(const Eigen::ArrayXd &position, const Eigen::ArrayXd &velocity) const
{
    DenseSegment segment; // of length 0: points behind a surface jump onto it
    segment.system = &m_integrator.system;
    segment.evaluate = [&](double, Eigen::ArrayXd &x, Eigen::ArrayXd &v) {
        x = position;
        v = velocity;
    };
    segment.positionAfter = Eigen::Map<const Eigen::ArrayXd>(endX(), m_size);
    segment.velocityAfter = Eigen::Map<const Eigen::ArrayXd>(endV(), m_size);
    (*m_visitor)(segment);
}

}
