#include "view.h"

#include "lessons/api/view/acting.h"
#include "lessons/rigid_constraint/text.h"
#include "scenes.h"
#include "sim/effects/constraints/sticks.h"
#include "sim/effects/contacts/room_limits.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace lessons;

namespace rigid_constraint {

namespace {

View sticksView(const sim::Scene &scene)
{
    View view;
    view.bodies.resize(scene.names.size(), {BodyView::Shape::joint, jointRadius});
    for (const sim::Stick &stick : sticksOf(scene))
        view.sticks.push_back({stick.a, stick.b, stick.length});
    return view;
}

/// Returns a function for Measure::of that calls `largest(scene, state)`. Its result is NaN if there is no
/// stick.
template <class Largest>
auto measureOfSticks(Largest largest)
{
    return
        [largest](const sim::Scene &scene, const sim::State &state, const sim::State *, const sim::Values &) {
            return sticksOf(scene).empty() ? std::numeric_limits<double>::quiet_NaN() : largest(scene, state);
        };
}

}

std::vector<sim::Stick> sticksOf(const sim::Scene &scene)
{
    std::vector<sim::Stick> all;
    for (const sim::Sticks *sticks : sim::sticksAmong(scene.effects))
        all.insert(all.end(), sticks->list().begin(), sticks->list().end());
    return all;
}

double largestError(const sim::Scene &scene, const sim::State &state)
{
    double largest = 0.0;
    for (const sim::Stick &stick : sticksOf(scene))
        largest = std::max(largest, std::abs(stickError(stick, state)));
    return largest;
}

double largestStretch(const sim::Scene &scene, const sim::State &state)
{
    double largest = 0.0;
    for (const sim::Stick &stick : sticksOf(scene)) {
        if (stick.length > 0.0)
            largest = std::max(largest, 100.0 * std::abs(stickError(stick, state)) / stick.length);
    }
    return largest;
}

View pointerView(const sim::Scene &scene, const sim::Values &)
{
    View view = sticksView(scene);
    view.pointerPoint = 0;
    return view;
}

View boxView(const sim::Scene &scene, const sim::Values &values)
{
    View view = sticksView(scene);
    if (effectOf<sim::RoomLimits>(scene))
        view.room = sim::Room{values["left"], values["right"], values["floor"], 0.0};
    return view;
}

View ragdollView(const sim::Scene &scene, const sim::Values &values)
{
    View view = boxView(scene, values);
    if (values.points)
        return view;
    view.bodies[0] = {BodyView::Shape::body, headRadius};
    view.limbs = {{1, 2, 18.0}, {1, 3, 20.0}, {2, 3, 20.0}, {1, 4, 14.0},  {4, 5, 11.0},  {2, 6, 14.0},
                  {6, 7, 11.0}, {3, 8, 17.0}, {8, 9, 13.0}, {3, 10, 17.0}, {10, 11, 13.0}};
    return view;
}

Measure errorMeasure()
{
    return {
        .name = Text::tr("Largest error"),
        .unit = Text::tr("px"),
        .help = Text::tr("How far the length of the worst stick is from what it should be."),
        .decimals = 2,
        .of = measureOfSticks(largestError),
    };
}

Measure stretchMeasure()
{
    return {
        .name = Text::tr("Largest stretch"),
        .unit = Text::tr("%"),
        .help = Text::tr("How far the worst stick is from its length, as a part of that length."),
        .decimals = 1,
        .of = measureOfSticks(largestStretch),
    };
}

}
