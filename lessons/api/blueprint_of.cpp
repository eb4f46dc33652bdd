#include "lessons/api/blueprint_of.h"

#include "sim/effects/body_spring.h"
#include "sim/effects/gait_clock.h"
#include "sim/effects/leg_spring.h"
#include "sim/effects/point_spring.h"
#include "sim/effects/push.h"
#include "sim/effects/radial_spring.h"
#include "sim/effects/springs.h"

#include <algorithm>
#include <numbers>
#include <set>

namespace lessons {

namespace {

constexpr double usualSize = 10.0; ///< px, of what is not drawn as a body

/// Takes a scene apart, effect by effect.
class Taker
{
public:
    Taker(const sim::Scene &scene, const sim::State &now, const Look &look) : m_scene(scene), m_now(now)
    {
        m_taken.points = now.points();
        for (int i = 0; i < now.points(); ++i) {
            const BodyLook &body = look.bodies[static_cast<std::size_t>(i)];
            const double size = body.shape == BodyLook::Shape::none ? usualSize : 2.0 * body.radius;
            const double inverse = scene.start.inverseMass[i];
            plan().points.push_back({scene.names[static_cast<std::size_t>(i)], now.at(i), now.speed(i),
                                     inverse == 0.0 ? 1.0 : 1.0 / inverse, size, inverse == 0.0});
        }
    }

    sim::Taken take()
    {
        for (const sim::EffectPtr &effect : m_scene.effects) {
            if (!effect->takeInto(m_taken) && !takeLinks(*effect))
                m_taken.leave(effect->title());
        }
        return m_taken;
    }

private:
    sim::Blueprint &plan() { return m_taken.blueprint; }

    /// `name`, with a number behind it where a point is called so already.
    std::string freeName(const std::string &name)
    {
        std::string free = name;
        const auto isTaken = [&](const sim::BuiltPoint &one) { return one.name == free; };
        for (int i = 2; std::any_of(plan().points.begin(), plan().points.end(), isTaken); ++i)
            free = name + std::to_string(i);
        return free;
    }

    bool takeLinks(const sim::Effect &effect)
    {
        if (const auto *springs = dynamic_cast<const sim::Springs *>(&effect)) {
            for (const sim::Spring &one : springs->list())
                plan().springs.push_back({one.a, one.b, one.k, one.length});
        } else if (const auto *radial = dynamic_cast<const sim::RadialSpring *>(&effect)) {
            takePairs(radial->links(), radial->k(), radial->radius());
        } else if (const auto *plain = dynamic_cast<const sim::BodySpring *>(&effect)) {
            takePairs(plain->links(), plain->k(), 0.0);
        } else if (const auto *centred = dynamic_cast<const sim::PointSpring *>(&effect)) {
            plan().points.push_back({freeName("centre"), centred->centre(), {}, 1.0, usualSize, true});
            plan().springs.push_back(
                {centred->mover(), static_cast<int>(plan().points.size()) - 1, centred->k(), 0.0});
        } else if (const auto *legs = dynamic_cast<const sim::LegSpring *>(&effect)) {
            takeLegs(*legs);
        } else if (const auto *push = dynamic_cast<const sim::Push *>(&effect)) {
            if (static_cast<int>(push->points().size()) != m_taken.points)
                return false; // of some points only
            m_taken.choose("push", {{"push", push->k()}, {"distance", push->distance()}});
        } else {
            return dynamic_cast<const sim::GaitClock *>(&effect); // it comes with the legs
        }
        return true;
    }

    /// A spring that is built pulls both ends.
    void takePairs(const std::vector<sim::Link> &links, double k, double length)
    {
        std::set<std::pair<int, int>> ways, pairs;
        for (const sim::Link &link : links)
            ways.emplace(link.mover, link.anchor);
        for (const sim::Link &link : links) {
            const bool answered = ways.contains({link.anchor, link.mover});
            if (!answered && m_scene.start.feels(link.anchor))
                m_taken.leave(SIM_TEXT("springs that pull one end only"));
            if (pairs.insert(std::minmax(link.mover, link.anchor)).second)
                plan().springs.push_back({link.mover, link.anchor, k, length});
        }
    }

    void takeLegs(const sim::LegSpring &legs)
    {
        std::map<int, int> groups; // by clock
        for (const sim::Leg &leg : legs.legs()) {
            if (!m_feet.insert(leg.foot).second) {
                m_taken.leave(SIM_TEXT("feet with more than one leg"));
                continue;
            }
            const auto [group, isNew] = groups.emplace(leg.clock, static_cast<int>(plan().gaits.size()));
            if (isNew)
                plan().gaits.push_back(gaitOf(legs.rule(), leg.clock));
            plan().feet.push_back({leg.foot, leg.body, leg.angle * 180.0 / std::numbers::pi, group->second});
        }
    }

    sim::BuiltGait gaitOf(const sim::LegRule &rule, int clock) const
    {
        sim::BuiltGait gait;
        gait.k = rule.k;
        gait.leg = rule.leg;
        gait.drop = rule.aim == sim::Aim::bone ? 0.0 : rule.drop;
        gait.pullsBody = rule.reaction == sim::Reaction::equal;
        if (rule.aim == sim::Aim::swing && clock < m_now.gait.rows()) {
            gait.start = m_now.gait[clock];
            gait.speed = m_now.gaitSpeed[clock];
        }
        return gait;
    }

    const sim::Scene &m_scene;
    const sim::State &m_now;
    sim::Taken m_taken;
    std::set<int> m_feet;
};

}

std::optional<sim::Taken> blueprintOf(const sim::Scene &scene, const sim::State &now, const Look &look)
{
    if (now.angle.rows() > 0)
        return {};
    return Taker(scene, now, look).take();
}

}
