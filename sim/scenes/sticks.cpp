#include "sim/scenes/sticks.h"

#include "sim/effects/drags/damping.h"
#include "sim/effects/fields/gravity.h"
#include "sim/scenes/points.h"

namespace scenes {

std::vector<sim::Stick> chainOfSticks(int links, double length)
{
    std::vector<sim::Stick> sticks;
    for (int i = 0; i < links; ++i)
        sticks.push_back({i, i + 1, length});
    return sticks;
}

sim::Scene fallingSticks(const StickFigure &figure)
{
    sim::Scene scene = pointsAt(figure.places);
    for (const int point : figure.pinned)
        scene.start.inverseMass[point] = 0.0;
    add<sim::Gravity>(scene, figure.gravity);
    add<sim::Damping>(scene, figure.damp);
    add<sim::Sticks>(scene, figure.sticks, scene.start.pointCount(), figure.passes);
    return scene;
}

}
