// Chipmunk on the creatures of crowd.h; peer_rooms.h lists what is the same. It uses one iteration, its
// minimum. Its springs change velocities once per step, like ours. Its units are px and frames, too. Debian
// builds it with debug assertions, which slow it down.

#include "tests/bench/peers/peer_rooms.h"
#include "tests/bench/scenes/crowd_runs.h"

#include <chipmunk/chipmunk.h>

#include <limits>

namespace {

using namespace bench::crowd;

constexpr cpBitmask walls = 1, creature = 2; ///< categories

cpVect vector(sim::Vec2 at)
{
    return cpv(at.x, at.y);
}

class Chipmunk : public Runner
{
public:
    Chipmunk(const sim::Scene &scene, int creatures) : m_space(cpSpaceNew()), m_creatures(creatures)
    {
        cpSpaceSetIterations(m_space, 1);
        cpSpaceSetGravity(m_space, cpv(0.0, gravity));
        cpSpaceSetDamping(m_space, damp);
        for (int number = 0; number < creatures; ++number) {
            addRoom(roomOf(creatures, number));
            for (int foot = -1; foot < feet; ++foot)
                addPoint(scene.start.positionOf(pointOf(creatures, number, foot)) + roomOf(creatures, number),
                         foot < 0 ? halfBody : halfFoot);
            for (int foot = 0; foot < feet; ++foot)
                m_springs.push_back(
                    cpSpaceAddConstraint(m_space, cpDampedSpringNew(bodyOf(number, -1), bodyOf(number, foot),
                                                                    cpvzero, cpvzero, radius, k, 0.0)));
        }
    }
    Chipmunk(const Chipmunk &) = delete;
    Chipmunk &operator=(const Chipmunk &) = delete;
    ~Chipmunk() override
    {
        const auto freeAll = [this](const auto &all, auto remove, auto release) {
            for (const auto &one : all) {
                remove(m_space, one);
                release(one);
            }
        };
        freeAll(m_springs, cpSpaceRemoveConstraint, cpConstraintFree);
        freeAll(m_shapes, cpSpaceRemoveShape, cpShapeFree);
        freeAll(m_bodies, cpSpaceRemoveBody, cpBodyFree);
        cpSpaceFree(m_space);
    }

    void restart() override
    {
        for (std::size_t i = 0; i < m_bodies.size(); ++i) {
            cpBodySetPosition(m_bodies[i], m_start[i]);
            cpBodySetVelocity(m_bodies[i], cpvzero);
        }
    }
    void frame() override { cpSpaceStep(m_space, 1.0); }
    sim::Vec2 at(int number, int foot) const override
    {
        const cpVect at = cpBodyGetPosition(bodyOf(number, foot));
        return sim::Vec2{at.x, at.y} - roomOf(m_creatures, number);
    }

private:
    cpBody *bodyOf(int number, int foot) const { return m_bodies[std::size_t(points * number + foot + 1)]; }

    void add(cpShape *shape, cpBitmask own, cpBitmask meets)
    {
        cpShapeSetElasticity(shape, bounce);
        cpShapeSetFilter(shape, cpShapeFilterNew(CP_NO_GROUP, own, meets));
        m_shapes.push_back(cpSpaceAddShape(m_space, shape));
    }

    void addRoom(sim::Vec2 room)
    {
        constexpr double top = -300.0; // px; creatures never reach it, and the room above begins at -420
        const auto wall = [&](sim::Vec2 from, sim::Vec2 to) {
            add(cpSegmentShapeNew(cpSpaceGetStaticBody(m_space), vector(from + room), vector(to + room), 0.0),
                walls, creature);
        };
        wall({left, top}, {left, bench::crowd::floor});
        wall({left, bench::crowd::floor}, {right, bench::crowd::floor});
        wall({right, bench::crowd::floor}, {right, top});
    }

    void addPoint(sim::Vec2 at, double half)
    {
        cpBody *body = cpBodyNew(1.0, std::numeric_limits<double>::infinity());
        cpBodySetPosition(body, vector(at));
        m_bodies.push_back(cpSpaceAddBody(m_space, body));
        m_start.push_back(vector(at));
        add(cpCircleShapeNew(body, half, cpvzero), creature, walls);
    }

    cpSpace *m_space;
    int m_creatures;
    std::vector<cpBody *> m_bodies; ///< in the space, creature by creature: the body, then the feet
    std::vector<cpShape *> m_shapes;
    std::vector<cpConstraint *> m_springs;
    std::vector<cpVect> m_start;
};

const benchmark::internal::Benchmark *const entered =
    enter(
        {"chipmunk", inTheRoom,
         [](const sim::Scene &scene, int creatures) { return std::make_unique<Chipmunk>(scene, creatures); },
         10.0})
        ->Iterations(frames);

}
