#include "lessons/api/creature.h"

namespace lessons {

sim::Scene creature(int feet)
{
    sim::Scene scene;
    scene.start = sim::State::ofPoints(feet + 1);
    scene.start.position.col(0) = 270.0;
    scene.start.position.col(1) = 200.0;
    for (int i = 0; i < feet; ++i)
        scene.names.push_back(feet == 1 ? "foot" : "foot" + std::to_string(i));
    scene.names.push_back("body");
    scene.groups = {{feet == 1 ? SIM_TEXT("foot") : SIM_TEXT("feet"), {0, feet}},
                    {SIM_TEXT("body"), {feet, 1}}};
    return scene;
}

sim::Scene creatureOnHandle()
{
    sim::Scene scene = creature(1);
    scene.start.inverseMass[1] = 0.0;
    scene.groups.pop_back();
    return scene;
}

Eigen::ArrayXd halfWidths(const sim::Scene &scene)
{
    Eigen::ArrayXd half = Eigen::ArrayXd::Constant(scene.start.points(), footWidth / 2);
    half.tail(1) = bodyWidth / 2;
    return half;
}

Look creatureLook(const sim::Scene &scene)
{
    Look look;
    look.bodies.resize(static_cast<std::size_t>(scene.start.points()),
                       {BodyLook::Shape::foot, footWidth / 2});
    if (scene.names.back() == "body")
        look.bodies.back() = {BodyLook::Shape::body, bodyWidth / 2};
    return look;
}

Look creatureLookWithLegs(const sim::Scene &scene)
{
    Look look = creatureLook(scene);
    const int body = scene.start.points() - 1;
    for (int foot = 0; foot < body; ++foot)
        look.legs.push_back({body, foot});
    return look;
}

}
