#include "app/model/learning/project_numbers.h"

#include "app/model/learning/project_judge.h"
#include "sim/effects/constraints/sticks.h"
#include "sim/pipeline/method.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace app {

namespace {

/// What a number can be read from.
struct NumberSource
{
    const sim::Script &script;
    const sim::Scene &scene;
    const sim::State &start;
    const sim::State &state;
    std::int64_t frame;
    lessons::ExactRun &exact;
};

using Source = const NumberSource &;

Eigen::Index freePoints(const sim::State &state)
{
    return (state.inverseMass != 0.0).count();
}

/// Returns the mean of a coordinate of the bodies that can move.
double middle(const sim::State &state, Eigen::Index column)
{
    const Eigen::Index count = freePoints(state);
    return count == 0 ? 0.0
                      : (state.inverseMass != 0.0).select(state.position.col(column), 0.0).sum() /
                            static_cast<double>(count);
}

/// Returns the greatest of these distances; 0 if there are none.
double greatestLength(const Eigen::ArrayX2d &vectors)
{
    return vectors.rows() == 0 ? 0.0 : std::sqrt(vectors.square().rowwise().sum().maxCoeff());
}

double stickCount(Source from)
{
    std::size_t count = 0;
    for (const sim::Sticks *sticks : sim::sticksAmong(from.scene.effects))
        count += sticks->list().size();
    return static_cast<double>(count);
}

double greatestStickError(Source from)
{
    double greatest = 0.0;
    for (const sim::Sticks *sticks : sim::sticksAmong(from.scene.effects)) {
        for (const sim::Stick &stick : sticks->list())
            greatest = std::max(greatest, std::abs(sim::stickError(stick, from.state)));
    }
    return greatest;
}

double greatestStiffness(Source from)
{
    double greatest = 0.0;
    if (!from.script.values.blueprint)
        return greatest;
    for (const sim::BlueprintSpring &spring : from.script.values.blueprint->springs)
        greatest = std::max(greatest, spring.k);
    return greatest;
}

template <class Parts>
double countOf(Source from, Parts sim::Blueprint::*parts)
{
    const auto &plan = from.script.values.blueprint;
    return plan ? static_cast<double>(((*plan).*parts).size()) : 0.0;
}

double evaluations(Source from)
{
    const double counted = from.state.forceEvaluations();
    if (counted > 0.0)
        return counted;
    return from.script.method->evaluationsPerStep() * static_cast<double>(from.frame) / from.script.step.h;
}

double greatestMotion(Source from)
{
    const bool isComparable = from.start.pointCount() == from.state.pointCount();
    return isComparable ? greatestLength(from.state.position - from.start.position) : 0.0;
}

using NumberOf = double (*)(Source);

constexpr std::pair<const char *, NumberOf> numbersOfScene[] = {
    {"bodies", [](Source from) { return static_cast<double>(from.state.pointCount()); }},
    {"nails",
     [](Source from) { return static_cast<double>(from.state.pointCount() - freePoints(from.state)); }},
    {"springs", [](Source from) { return countOf(from, &sim::Blueprint::springs); }},
    {"sticks", stickCount},
    {"feet", [](Source from) { return countOf(from, &sim::Blueprint::feet); }},
    {"stiffest", greatestStiffness},
    {"stick_error", greatestStickError},
    {"leftmost", [](Source from) { return from.state.position.col(0).minCoeff(); }},
    {"rightmost", [](Source from) { return from.state.position.col(0).maxCoeff(); }},
    {"highest", [](Source from) { return from.state.position.col(1).minCoeff(); }},
    {"lowest", [](Source from) { return from.state.position.col(1).maxCoeff(); }},
    {"middle_x", [](Source from) { return middle(from.state, 0); }},
    {"middle_y", [](Source from) { return middle(from.state, 1); }},
    {"fastest", [](Source from) { return greatestLength(from.state.velocity); }},
    {"moved", greatestMotion},
    {"error", [](Source from) { return from.exact.distance(from.script, from.state, from.frame); }},
    {"evaluations", evaluations},
};

}

QStringList projectNumbers()
{
    QStringList names;
    for (const auto &[name, of] : numbersOfScene)
        names << QString::fromLatin1(name);
    return names;
}

std::optional<double> ProjectNumbers::at(const std::string &name, const sim::Scene &scene,
                                         const sim::State &state, std::int64_t frame) const
{
    const auto found = std::find_if(std::begin(numbersOfScene), std::end(numbersOfScene),
                                    [&](const auto &one) { return one.first == name; });
    if (found == std::end(numbersOfScene))
        return std::nullopt;
    const double number = found->second({m_script, scene, m_start, state, frame, m_exact});
    return std::isfinite(number) ? std::optional(number) : std::nullopt;
}

}
