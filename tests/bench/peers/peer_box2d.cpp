// Box2D on the creatures of crowd.h; peer_rooms.h lists what is the same. It uses the iterations that its
// manual recommends, 8 for velocities and 3 for positions, in single precision. Its soft joints are implicit.
// Its damping factor is 1 / (1 + c h), with c chosen to match ours. One metre is 50 px and one second is 30
// frames, because Box2D is tuned for objects of a few metres.

#include "tests/bench/peers/peer_rooms.h"
#include "tests/bench/scenes/crowd_runs.h"

#include <box2d/box2d.h>

namespace {

using namespace bench::crowd;

constexpr double pixel = 1.0 / 50.0; ///< m
constexpr double perSecond = 30.0;   ///< frames
constexpr int velocityRounds = 8, placeRounds = 3;
constexpr std::uint16_t walls = 1, creature = 2; ///< categories

float single(double value)
{
    return static_cast<float>(value);
}

b2Vec2 metres(sim::Vec2 at)
{
    return {single(at.x * pixel), single(at.y * pixel)};
}

class Box2D : public Runner
{
public:
    Box2D(const sim::Scene &scene, int creatures)
        : m_world(b2Vec2(0.0f, single(gravity * pixel * perSecond * perSecond))), m_creatures(creatures)
    {
        m_world.SetAllowSleeping(false);
        b2BodyDef still;
        m_walls = m_world.CreateBody(&still);
        for (int number = 0; number < creatures; ++number) {
            addRoom(roomOf(creatures, number));
            for (int foot = -1; foot < feet; ++foot)
                addPoint(scene.start.positionOf(pointOf(creatures, number, foot)) + roomOf(creatures, number),
                         foot < 0 ? halfBody : halfFoot);
            for (int foot = 0; foot < feet; ++foot)
                addSpring(bodyOf(number, -1), bodyOf(number, foot));
        }
    }

    void restart() override
    {
        for (std::size_t i = 0; i < m_bodies.size(); ++i) {
            m_bodies[i]->SetTransform(m_start[i], 0.0f);
            m_bodies[i]->SetLinearVelocity({0.0f, 0.0f});
        }
    }
    void frame() override { m_world.Step(single(1.0 / perSecond), velocityRounds, placeRounds); }
    sim::Vec2 at(int number, int foot) const override
    {
        const b2Vec2 at = bodyOf(number, foot)->GetPosition();
        return sim::Vec2{double(at.x) / pixel, double(at.y) / pixel} - roomOf(m_creatures, number);
    }

private:
    b2Body *bodyOf(int number, int foot) const { return m_bodies[std::size_t(points * number + foot + 1)]; }

    void addRoom(sim::Vec2 room)
    {
        constexpr double top = -300.0; // px; creatures never reach it, and the room above begins at -420
        const auto wall = [&](sim::Vec2 from, sim::Vec2 to) {
            b2EdgeShape edge;
            edge.SetTwoSided(metres(from + room), metres(to + room));
            b2FixtureDef fixture;
            fixture.shape = &edge;
            fixture.friction = 0.0f;
            fixture.restitution = single(bounce);
            fixture.filter.categoryBits = walls;
            fixture.filter.maskBits = creature;
            m_walls->CreateFixture(&fixture);
        };
        wall({left, top}, {left, bench::crowd::floor});
        wall({left, bench::crowd::floor}, {right, bench::crowd::floor});
        wall({right, bench::crowd::floor}, {right, top});
    }

    void addPoint(sim::Vec2 at, double half)
    {
        b2BodyDef def;
        def.type = b2_dynamicBody;
        def.position = metres(at);
        def.fixedRotation = true;
        def.linearDamping = single((1.0 / damp - 1.0) * perSecond);
        b2CircleShape disc;
        disc.m_radius = single(half * pixel);
        b2FixtureDef fixture;
        fixture.shape = &disc;
        fixture.density = 1.0f / (b2_pi * disc.m_radius * disc.m_radius); // for a mass of 1 kg
        fixture.friction = 0.0f;
        fixture.restitution = single(bounce);
        fixture.filter.categoryBits = creature;
        fixture.filter.maskBits = walls;
        m_bodies.push_back(m_world.CreateBody(&def));
        m_bodies.back()->CreateFixture(&fixture);
        m_start.push_back(def.position);
    }

    void addSpring(b2Body *body, b2Body *foot)
    {
        b2DistanceJointDef def;
        def.bodyA = body;
        def.bodyB = foot;
        def.length = single(radius * pixel);
        def.stiffness = single(k * perSecond * perSecond); // N/m
        m_world.CreateJoint(&def);
    }

    b2World m_world;
    int m_creatures;
    b2Body *m_walls = nullptr;
    std::vector<b2Body *> m_bodies; ///< in the world, creature by creature: the body, then the feet
    std::vector<b2Vec2> m_start;
};

const benchmark::internal::Benchmark *const entered =
    enter({"box2d", inTheRoom,
           [](const sim::Scene &scene, int creatures) { return std::make_unique<Box2D>(scene, creatures); },
           10.0})
        ->Iterations(frames);

}
