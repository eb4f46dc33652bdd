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
    return {{.shape = Guide::Shape::cross, .a = centre},
            {.shape = Guide::Shape::cross, .a = start},
            {.shape = Guide::Shape::cross, .a = centre + (centre - start)}};
}

std::vector<Guide> middleMarks(const sim::Scene &scene, const sim::State &state, const sim::Values &)
{
    const sim::Vec2 was = middleOf(scene.start);
    const sim::Vec2 is = middleOf(state);
    std::vector<Guide> marks = {{.shape = Guide::Shape::cross, .a = was}};
    const double way = sim::length(is - was);
    if (way >= leastShown)
        marks.push_back({.shape = Guide::Shape::line,
                         .a = was,
                         .b = is,
                         .label = Text::tr("the middle moved %1 px").arg(QLocale().toString(way, 'f', 0))});
    return marks;
}

}
