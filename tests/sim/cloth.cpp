#include "cloth.h"

#include "sim/effects/drags/damping.h"
#include "sim/effects/fields/gravity.h"
#include "sim/effects/springs/radial_spring.h"

namespace cloth {

namespace {

/// Both ways, for each pair of neighbours.
std::vector<sim::Link> neighbours(int side)
{
    std::vector<sim::Link> links;
    const auto join = [&links](int a, int b) {
        links.push_back({a, b});
        links.push_back({b, a});
    };
    for (int row = 0; row < side; ++row) {
        for (int column = 0; column < side; ++column) {
            const int point = row * side + column;
            if (column + 1 < side)
                join(point, point + 1);
            if (row + 1 < side)
                join(point, point + side);
        }
    }
    return links;
}

}

sim::Scene hung(int side, double k, double damp)
{
    const int points = side * side;
    sim::Scene scene;
    scene.start = sim::State::ofPoints(points);
    for (int point = 0; point < points; ++point) {
        scene.names.push_back(std::string("p").append(std::to_string(point)));
        scene.start.place(point, {100.0 + spacing * (point % side), 50.0 + spacing * (point / side)});
    }
    scene.start.inverseMass.head(side).setZero();
    scene.groups = {{"cloth", {side, points - side}}};
    scene.effects = {std::make_shared<sim::RadialSpring>(neighbours(side), k, spacing),
                     std::make_shared<sim::Gravity>(weight), std::make_shared<sim::Damping>(damp)};
    return scene;
}

double sag(int side, double k, int row)
{
    const double carried = row * side - row * (row + 1) / 2.0; // the sum of side - m, m from 1 to row
    return weight * carried / k;
}

}
