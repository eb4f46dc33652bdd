#include "sim/methods/adaptive/island_integrators.h"

#include "sim/scene/islands.h"

#include <algorithm>

namespace sim {

namespace {

/// Drivers run one clock for all, and place things after everything else. Where things turn, drivers do that.
bool isOneIsland(const Scene &scene)
{
    const auto drives = [&](const EffectPtr &effect) {
        return as<Driver>(effect) && effect->count(scene.start, {0, scene.start.points()}) > 0;
    };
    return scene.start.spin.rows() > 0 || std::any_of(scene.effects.begin(), scene.effects.end(), drives);
}

std::vector<std::vector<Points>> partsOf(const Scene &scene)
{
    if (isOneIsland(scene))
        return {{{0, scene.start.points()}}};
    return islandsOf(scene);
}

/// Whether any of its points can move, held or not.
bool canMove(const Scene &scene, const std::vector<Points> &runs)
{
    for (const Points &run : runs) {
        for (int point = run.first; point < run.end(); ++point) {
            if (scene.start.feels(point) && scene.hasInertia(point))
                return true;
        }
    }
    return false;
}

}

Courses::Courses(const Scene &scene, const StepRule &rule, Directions directions, double tolerance)
{
    Eigen::Index column = 0;
    for (std::vector<Points> &runs : partsOf(scene)) {
        if (!canMove(scene, runs))
            continue;
        Course &course =
            m_courses.emplace_back(scene, Flow(scene, directions, std::move(runs)), rule, tolerance);
        course.number = m_courses.size() - 1;
        course.column = column;
        column += static_cast<Eigen::Index>(course.flow.size()) * Course::columns(rule);
    }
}

template <class One>
bool Courses::each(State &state, One &&advance) const
{
    state.ahead.resize(m_courses.size());
    for (const Course &course : m_courses) {
        if (!advance(course))
            return false;
        if (state.ahead[course.number].stuck >= 0)
            return true;
    }
    return true;
}

bool Courses::toNextFrame(State &state, const GoesOn &goesOn) const
{
    Patient patient(goesOn, state.points());
    return each(state, [&](const Course &course) { return Advance(course, state).toNextFrame(patient); });
}

bool Courses::toNextFrame(State &state, const GoesOn &goesOn, const LapVisit &visit) const
{
    Patient patient(goesOn, state.points());
    return each(state,
                [&](const Course &course) { return Advance(course, state).toNextFrame(patient, visit); });
}

const Course *Courses::of(int point) const
{
    for (const Course &course : m_courses) {
        for (const Points &run : course.flow.runs()) {
            if (run.contains(point))
                return &course;
        }
    }
    return nullptr;
}

}
