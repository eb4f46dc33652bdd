#include "view.h"

#include "lessons/api/view/look.h"
#include "scenes.h"

#include <QCoreApplication>
#include <QLocale>

using namespace lessons;

namespace hard_cases {

namespace {

struct Text
{
    Q_DECLARE_TR_FUNCTIONS(HardCases)
};

constexpr double leastShown = 0.5; ///< px: a shorter way has no line

sim::Vec2 middleOf(const sim::State &state)
{
    return {state.position.col(0).mean(), state.position.col(1).mean()};
}

}

std::vector<Guide> turningPlaces(const sim::Scene &scene, const sim::State &, const sim::Values &)
{
    const sim::Vec2 start = scene.start.at(0);
    return {{Guide::Shape::cross, centre, {}, 0.0, {}},
            {Guide::Shape::cross, start, {}, 0.0, {}},
            {Guide::Shape::cross, centre + (centre - start), {}, 0.0, {}}};
}

std::vector<Guide> middleMarks(const sim::Scene &scene, const sim::State &state, const sim::Values &)
{
    const sim::Vec2 was = middleOf(scene.start);
    const sim::Vec2 is = middleOf(state);
    std::vector<Guide> marks = {{Guide::Shape::cross, was, {}, 0.0, {}}};
    const double way = sim::length(is - was);
    if (way >= leastShown)
        marks.push_back({Guide::Shape::line, was, is, 0.0,
                         Text::tr("the middle moved %1 px").arg(QLocale().toString(way, 'f', 0))});
    return marks;
}

}
