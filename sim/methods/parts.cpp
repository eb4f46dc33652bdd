#include "sim/methods/parts.h"

namespace sim {

namespace {

const char *const here = "sim/methods/parts.h";

/// A phase that is the method's own work.
Phase ownPhase(const char *id, const char *title, const Share &share)
{
    Phase phase;
    phase.id = id;
    phase.title = title;
    phase.points = share.points;
    phase.group = share.group;
    phase.regions = {{here, id}};
    return phase;
}

}

PhaseList::PhaseList(const Scene &scene, Directions directions, double h)
    : m_scene(scene), m_directions(directions), m_h(h)
{
}

Share PhaseList::everything() const
{
    return {{0, m_scene.start.points()}, -1};
}

std::vector<Share> PhaseList::groups() const
{
    std::vector<Share> shares;
    for (const Group &group : m_scene.groups)
        shares.push_back({group.points, static_cast<int>(shares.size())});
    return shares;
}

template <class Type, class Visit>
void PhaseList::forEach(const Share &share, Visit &&visit) const
{
    for (const EffectPtr &effect : m_scene.effects) {
        const auto typed = std::dynamic_pointer_cast<const Type>(effect);
        if (typed && typed->count(m_scene.start, share.points) > 0)
            visit(typed);
    }
}

Phase PhaseList::phaseOf(const EffectPtr &effect, const Share &share) const
{
    Phase phase;
    phase.id = effect->id();
    phase.title = effect->title();
    phase.kind = effect->kind();
    phase.effect = effect;
    phase.points = share.points;
    phase.group = share.group;
    phase.regions = effect->regions(m_directions);
    return phase;
}

bool PhaseList::canMove(Points points) const
{
    for (int i = points.first; i < points.end(); ++i) {
        if (m_scene.start.feels(i))
            return true;
    }
    return false;
}

void PhaseList::forces(const Share &share, AddForce add, const Region &shown)
{
    forEach<Force>(share, [&](const std::shared_ptr<const Force> &force) {
        Phase phase = phaseOf(force, share);
        phase.regions.push_back(shown);
        phase.run = [force, add, points = share.points, h = m_h](State &state) {
            add(*force, state, points, h);
        };
        phase.explain = [force, way = m_directions](const State &before, const State &after, int point) {
            std::vector<Live> live = force->explain(before, point, way);
            if (!live.empty() && before.speed(point) != after.speed(point))
                live.push_back({"velocity", after.speed(point), before.speed(point)});
            return live;
        };
        m_phases.push_back(std::move(phase));
    });
}

void PhaseList::kick(const Share &share)
{
    bool any = false;
    forEach<Force>(share, [&](const auto &) { any = true; });
    if (!any)
        return;
    Phase phase = ownPhase("kick", SIM_TEXT("kick"), share);
    phase.run = [points = share.points, h = m_h](State &state) {
        for (int i = points.first; i < points.end(); ++i) {
            const Vec2 a = {state.acceleration(i, 0), state.acceleration(i, 1)};
            if (state.feels(i))
                state.push(i, sim::kick(state.speed(i), a, h));
        }
    };
    phase.explain = [](const State &before, const State &after, int point) {
        return std::vector<Live>{{"v", after.speed(point), before.speed(point)}};
    };
    m_phases.push_back(std::move(phase));
}

void PhaseList::damping(const Share &share)
{
    forEach<Drag>(share, [&](const std::shared_ptr<const Drag> &drag) {
        Phase phase = phaseOf(drag, share);
        phase.regions.push_back({here, "damp"});
        const double keep = drag->keep(m_h);
        phase.run = [points = share.points, keep](State &state) {
            for (int i = points.first; i < points.end(); ++i) {
                if (state.feels(i))
                    state.push(i, damp(state.speed(i), keep));
            }
        };
        phase.explain = [keep](const State &before, const State &after, int point) {
            return std::vector<Live>{{"keep", keep, {}}, {"v", after.speed(point), before.speed(point)}};
        };
        m_phases.push_back(std::move(phase));
    });
}

void PhaseList::move(const Share &share)
{
    if (!canMove(share.points))
        return;
    Phase phase = ownPhase("move", SIM_TEXT("move"), share);
    phase.moves = true;
    phase.run = [points = share.points, h = m_h](State &state) {
        for (int i = points.first; i < points.end(); ++i) {
            if (state.feels(i))
                state.place(i, sim::move(state.at(i), state.speed(i), h));
        }
    };
    phase.explain = [](const State &before, const State &after, int point) {
        return std::vector<Live>{{"x", after.at(point), before.at(point)}};
    };
    m_phases.push_back(std::move(phase));
}

void PhaseList::contacts(const Share &share)
{
    forEach<Contact>(share, [&](const std::shared_ptr<const Contact> &contact) {
        Phase phase = phaseOf(contact, share);
        phase.run = [contact, points = share.points](State &state) { contact->resolve(state, points); };
        phase.explain = [](const State &before, const State &after, int point) {
            std::vector<Live> live;
            if (before.at(point) != after.at(point))
                live.push_back({"x", after.at(point), before.at(point)});
            if (before.speed(point) != after.speed(point))
                live.push_back({"v", after.speed(point), before.speed(point)});
            return live;
        };
        m_phases.push_back(std::move(phase));
    });
}

}
