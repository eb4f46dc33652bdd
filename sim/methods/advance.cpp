#include "sim/methods/advance.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sim {

namespace {

constexpr int mostTries = 20'000;    ///< steps a frame, the rejected ones included
constexpr double longestStep = 10.0; ///< frames
/// What damping leaves in one step is at least e^-2: past that, the polynomial through a step would have to follow
/// e^(c t), which the error at its end does not show.
constexpr double mostDamping = 2.0;

/// Numbers that live for one frame only. Kept by the thread, so that a frame allocates nothing; nothing is read
/// from them that the same frame has not written.
struct Scratch
{
    std::vector<double> numbers;
    std::vector<StageWeights> weights;
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

/// What damping leaves of a velocity after `time` frames.
double kept(const Flow::Stretch &rows, double time)
{
    return rows.rate == 0.0 || std::isinf(rows.rate) ? 1.0 : std::exp(-rows.rate * time);
}

/// Infinite where a number is not finite.
double largest(const double *numbers, int size)
{
    double most = 0.0, sum = 0.0;
    for (int i = 0; i < size; ++i) {
        most = std::max(most, std::abs(numbers[i]));
        sum += numbers[i] - numbers[i]; // 0, or not a number
    }
    return sum == 0.0 ? most : std::numeric_limits<double>::infinity();
}

}

Course::Course(const Scene &scene, const Pair &how, Directions directions, double within)
    : flow(scene, directions), pair(how), tolerance(within), longest(longestStep), touching(scene)
{
    for (const EffectPtr &effect : scene.effects) {
        if (dynamic_cast<const Contact *>(effect.get()))
            contacts.push_back(effect);
    }
    for (const Flow::Stretch &rows : flow.stretches()) {
        if (rows.rate > 0.0 && std::isfinite(rows.rate))
            longest = std::min(longest, mostDamping / rows.rate);
    }
}

std::vector<EffectPtr> Course::effects() const
{
    std::vector<EffectPtr> all = flow.effects();
    all.insert(all.end(), contacts.begin(), contacts.end());
    return all;
}

Advance::Advance(const Course &course, State &state)
    : m_course(course), m_state(state), m_size(course.flow.size()), m_points(state.points()),
      m_stages(course.pair.tableau().stages + course.pair.extraStages()),
      m_weights(scratch(static_cast<std::size_t>(m_size * (4 + 2 * m_stages)), course.flow.stretches().size())
                    .weights)
{
    m_place = scratch(0, 0).numbers.data();
    m_speed = m_place + m_size;
    m_trial = m_speed + m_size;
    m_speeds = m_trial + m_size;
    m_slopes = m_speeds + m_size * m_stages;
    m_lift = m_slopes + m_size * m_stages;
}

double *Advance::speedOf(int number) const
{
    return m_speeds + number * m_size;
}

double *Advance::slopeOf(int number) const
{
    return m_slopes + number * m_size;
}

void Advance::toNextFrame()
{
    Ahead &ahead = m_state.ahead;
    //! [adaptive_order]
    if (ahead.to <= 0)
        begin();
    // until a step ends past the frame
    for (int i = 0; ahead.to < 1; ++i) {
        if (i == mostTries)
            return giveUp();
        tryStep();
    }
    // then the frame is read off it
    readOff();
    //! [adaptive_order]
    ahead.from -= 1.0;
    ahead.to -= 1.0;
}

void Advance::clockTo(double time)
{
    if (time == m_clock)
        return;
    m_course.flow.tick(m_state, time - m_clock);
    m_clock = time;
}

void Advance::begin()
{
    m_course.flow.read(m_state, endPlace(), endSpeed());
    for (const Flow::Stretch &rows : m_course.flow.stretches()) {
        if (std::isinf(rows.rate)) // damping stops it at once
            std::fill(endSpeed() + rows.first, endSpeed() + rows.end(), 0.0);
    }
    m_state.ahead.from = m_state.ahead.to = 0.0;
    m_state.resting.setZero();
    const Eigen::ArrayXd place = Eigen::Map<Eigen::ArrayXd>(endPlace(), m_visit ? m_size : 0);
    const Eigen::ArrayXd speed = Eigen::Map<Eigen::ArrayXd>(endSpeed(), m_visit ? m_size : 0);
    bounce();
    settle();
    if (m_visit)
        tellBegun(place, speed);
    if (m_state.ahead.next > 0.0)
        return;
    // A guess; the first error estimate puts it right.
    const double pull = largest(endSlope(), m_size) + 1e-10;
    const double share =
        std::pow(m_course.tolerance / (pull + m_course.tolerance), 1.0 / m_course.pair.order());
    m_state.ahead.next = std::min(m_course.longest, std::clamp(0.5 * share, 1e-6, 1.0));
}

void Advance::setWeights(double h)
{
    const std::vector<Flow::Stretch> &stretches = m_course.flow.stretches();
    for (std::size_t i = 0; i < stretches.size(); ++i)
        m_weights[i].set(m_course.pair.tableau(), stretches[i].rate, h, m_stages);
}

/// The place of a stage, the pull there, and the velocity that belongs to it.
void Advance::stage(int number, double start, double h)
{
    const std::vector<Flow::Stretch> &stretches = m_course.flow.stretches();
    const auto row = static_cast<std::size_t>(number);
    for (std::size_t i = 0; i < stretches.size(); ++i) {
        blendRows(m_trial, m_place, 1.0, m_speeds, m_weights[i].place[row].data(), number, stretches[i].first,
                  stretches[i].end(), m_size);
        blendRows(speedOf(number), m_speed, m_weights[i].keep[row], m_slopes, m_weights[i].speed[row].data(),
                  number, stretches[i].first, stretches[i].end(), m_size);
    }
    clockTo(start + m_course.pair.tableau().c[row] * h);
    m_course.flow.place(m_trial, m_state);
    m_course.flow.accelerations(m_state, slopeOf(number));
    ++m_state.evaluations;
    hold(slopeOf(number));
}

//! [try_step]
void Advance::tryStep()
{
    double start = m_state.ahead.to;
    double h = m_state.ahead.next;
    std::copy_n(endPlace(), m_size, m_place);
    std::copy_n(endSpeed(), m_size, m_speed);
    std::copy_n(endSpeed(), m_size, speedOf(0));
    std::copy_n(endSlope(), m_size, slopeOf(0));
    setWeights(h);
    int last = m_course.pair.tableau().stages;
    for (int i = 1; i < last; ++i)
        stage(i, start, h);
    double share = error(h);
    if (share <= 1) // exact enough
        accept(start, h);
    else // again, with a shorter step
        share = std::min(share, 1e9);
    int order = m_course.pair.order();
    double next = nextStep(h, share + 1e-12, order);
    m_state.ahead.next = std::min(next, m_course.longest);
    if (m_state.ahead.to == start)
        shorten(h); // it led nowhere
}
//! [try_step]

void Advance::shorten(double h)
{
    // Besides rejected steps: a contact at the very start that left all as it was. The polynomial is too rough there.
    m_state.ahead.next = std::min(m_state.ahead.next, 0.5 * h);
}

double Advance::error(double h) const
{
    const double most = estimate(m_course.pair.error());
    if (!std::isfinite(most))
        return std::numeric_limits<double>::infinity();
    // Two estimates are put together so that the lower one counts only where the higher is unsure.
    const double lower = m_course.pair.hasLowerError() ? estimate(m_course.pair.lowerError()) : 0.0;
    const double both = most > 0.0 ? most * (most / std::hypot(most, 0.1 * lower)) : 0.0;
    // Nothing is more exact than the digits of a place allow.
    const double digits = 8.0 * std::numeric_limits<double>::epsilon() * largest(m_place, m_size);
    return h * (lower > 0.0 ? both : most) / std::max(m_course.tolerance, digits);
}

double Advance::estimate(const Tableau::Row &weights) const
{
    const std::vector<Flow::Stretch> &stretches = m_course.flow.stretches();
    const int stages = m_course.pair.tableau().stages;
    double most = 0.0;
    for (std::size_t n = 0; n < stretches.size(); ++n) {
        const int first = stretches[n].first, end = stretches[n].end();
        Tableau::Row since{}; // with what damping leaves at the end of what each stage's slope has made
        const auto &keep = m_weights[n].keep;
        for (std::size_t j = 0; j < static_cast<std::size_t>(stages); ++j)
            since[j] =
                keep[j] > 0.0 ? weights[j] * keep[static_cast<std::size_t>(stages) - 1] / keep[j] : 0.0;
        blendRows(m_lift, m_speeds, 0.0, m_speeds, weights.data(), stages, first, end, m_size);
        most = std::max(most, largest(m_lift + first, end - first));
        blendRows(m_lift, m_slopes, 0.0, m_slopes, since.data(), stages, first, end, m_size);
        most = std::max(most, largest(m_lift + first, end - first));
    }
    return most;
}

void Advance::accept(double start, double h)
{
    const int last = m_course.pair.tableau().stages - 1;
    Ahead &ahead = m_state.ahead;
    ahead.from = start;
    ahead.length = h;
    ahead.to = start + h;
    std::copy_n(m_trial, m_size, endPlace());
    std::copy_n(speedOf(last), m_size, endSpeed());
    std::copy_n(slopeOf(last), m_size, endSlope());
    const bool readsFrame = start < 1.0 && ahead.to > 1.0;
    const bool meets = mayMeet();
    if (readsFrame || meets || m_visit)
        makeDense(h);
    if (meets)
        end(start, h);
    if (m_visit)
        tell(start);
}

void Advance::makeDense(double h)
{
    const double start = m_state.ahead.from;
    for (int i = m_course.pair.tableau().stages; i < m_stages; ++i)
        stage(i, start, h);
    StepData step{m_place, m_speed, m_speeds, m_slopes, m_size, 0, 0, 0.0, h, nullptr};
    for (std::size_t n = 0; n < m_course.flow.stretches().size(); ++n) {
        const Flow::Stretch &rows = m_course.flow.stretches()[n];
        step.keep = m_weights[n].keep.data();
        step.first = rows.first;
        step.end = rows.end();
        step.rate = std::isinf(rows.rate) ? 0.0 : rows.rate; // it stands still
        m_course.pair.makeDense(step, endPlace(), endSpeed(), denseColumns());
    }
}

Advance::Moving Advance::dense(int point, double h, double theta) const
{
    const auto row = [&](int i) {
        for (const Flow::Stretch &rows : m_course.flow.stretches()) {
            if (i < rows.end())
                return m_course.pair.dense(denseColumns(), m_size, i, kept(rows, h * theta), h, theta);
        }
        return Pair::At{};
    };
    const Pair::At x = row(point), y = row(m_points + point);
    return {{x.place, y.place}, {x.speed, y.speed}};
}

void Advance::denseAll(double h, double theta, double *x, double *v) const
{
    for (const Flow::Stretch &rows : m_course.flow.stretches()) {
        const double left = kept(rows, h * theta);
        for (int i = rows.first; i < rows.end(); ++i) {
            const Pair::At at = m_course.pair.dense(denseColumns(), m_size, i, left, h, theta);
            x[i] = at.place;
            v[i] = at.speed;
        }
    }
}

// Shown lines are short.
// clang-format off
//! [read_off]
void Advance::readOff()
{
    Ahead &ahead = m_state.ahead;
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
    clockTo(1);
    m_course.flow.place(x, m_state);
    m_course.flow.push(v, m_state);
}
//! [read_off]
// clang-format on

void Advance::giveUp()
{
    // A run stops where numbers stop being finite: at the point that is pulled hardest.
    int worst = 0;
    for (int i = 0; i < m_points; ++i) {
        if (!(length(at(endSlope(), i)) <= length(at(endSlope(), worst))))
            worst = i;
    }
    const double nan = std::numeric_limits<double>::quiet_NaN();
    m_state.place(worst, {nan, nan});
}

}
