#include "sim/scenes/cloth.h"

#include "sim/effects/drags/damping.h"
#include "sim/effects/fields/gravity.h"
#include "sim/effects/springs/radial_spring.h"
#include "sim/scenes/links.h"
#include "sim/scenes/points.h"

namespace scenes::cloth {

sim::Scene hung(int side, double k, double damp)
{
    const int points = side * side;
    std::vector<sim::Vec2> positions;
    for (int point = 0; point < points; ++point)
        positions.push_back({100.0 + spacing * (point % side), 50.0 + spacing * (point / side)});
    sim::Scene scene = pointsAt(positions);
    scene.start.inverseMass.head(side).setZero();
    scene.groups.front().points = {side, points - side};
    add<sim::RadialSpring>(scene, gridLinks(side), k, spacing);
    add<sim::Gravity>(scene, weight);
    add<sim::Damping>(scene, damp);
    return scene;
}

}
