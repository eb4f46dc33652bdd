#include "sim/methods/parts.h"

namespace sim {

namespace {

const char *const here = "sim/methods/parts.h";

/// What changed from `before` to `after`, for a line that assigns to `name`.
std::vector<Live> changed(const char *name, Vec2 before, Vec2 after)
{
    return {Live{name, after, before}};
}

Phase effectPhase(const EffectPtr &effect, Share share, Directions directions)
{
    Phase phase;
    phase.id = effect->id();
    phase.title = effect->title();
    phase.kind = effect->kind();
    phase.effect = effect;
    phase.points = share.points;
    phase.group = share.group;
    phase.regions = effect->regions(directions);
    return phase;
}

/// Calls `visit(effect, ptr)` for the effects of one type that have something to do among `points`.
template <class Type, class Visit>
void forEach(const Scene &scene, Points points, Visit &&visit)
{
    for (const EffectPtr &effect : scene.effects) {
        const auto *typed = dynamic_cast<const Type *>(effect.get());
        if (typed && typed->count(scene.start, points) > 0)
            visit(*typed, effect);
    }
}

template <class Type>
bool hasAny(const Scene &scene, Points points)
{
    bool any = false;
    forEach<Type>(scene, points, [&](const Type &, const EffectPtr &) { any = true; });
    return any;
}

}

Share everything(const Scene &scene)
{
    return {{0, scene.start.points()}, -1};
}

bool canMove(const Scene &scene, Points points)
{
    for (int i = points.first; i < points.end(); ++i) {
        if (scene.start.feels(i))
            return true;
    }
    return false;
}

void addForcePhases(std::vector<Phase> &phases, const Scene &scene, Share share, Directions directions,
                    const Region &shown, const RunForce &run)
{
    forEach<Force>(scene, share.points, [&](const Force &force, const EffectPtr &effect) {
        Phase phase = effectPhase(effect, share, directions);
        phase.regions.push_back(shown);
        phase.run = [&force, effect, run](State &state) { run(force, state); };
        phase.explain = [&force, effect, directions](const State &before, const State &after, int point) {
            std::vector<Live> live = force.explain(before, point, directions);
            if (!live.empty() && !sameBits(before, after) && before.speed(point) != after.speed(point))
                live.push_back({"velocity", after.speed(point), before.speed(point)});
            return live;
        };
        phases.push_back(std::move(phase));
    });
}

void addKickPhase(std::vector<Phase> &phases, const Scene &scene, Share share, double h)
{
    if (!hasAny<Force>(scene, share.points))
        return;
    Phase phase;
    phase.id = "kick";
    phase.title = SIM_TEXT("kick");
    phase.points = share.points;
    phase.group = share.group;
    phase.regions = {{here, "kick"}};
    phase.run = [points = share.points, h](State &state) {
        for (int i = points.first; i < points.end(); ++i) {
            const Vec2 a = {state.acceleration(i, 0), state.acceleration(i, 1)};
            if (state.feels(i))
                state.push(i, kick(state.speed(i), a, h));
        }
    };
    phase.explain = [](const State &before, const State &after, int point) {
        return changed("v", before.speed(point), after.speed(point));
    };
    phases.push_back(std::move(phase));
}

void addDampPhases(std::vector<Phase> &phases, const Scene &scene, Share share, Directions directions,
                   double h)
{
    forEach<Drag>(scene, share.points, [&](const Drag &drag, const EffectPtr &effect) {
        Phase phase = effectPhase(effect, share, directions);
        phase.regions.push_back({here, "damp"});
        const double keep = drag.keep(h);
        phase.run = [points = share.points, keep](State &state) {
            for (int i = points.first; i < points.end(); ++i) {
                if (state.feels(i))
                    state.push(i, damp(state.speed(i), keep));
            }
        };
        phase.explain = [keep](const State &before, const State &after, int point) {
            std::vector<Live> live = changed("v", before.speed(point), after.speed(point));
            live.insert(live.begin(), Live{"keep", keep});
            return live;
        };
        phases.push_back(std::move(phase));
    });
}

void addMovePhase(std::vector<Phase> &phases, const Scene &scene, Share share, double h)
{
    if (!canMove(scene, share.points))
        return;
    Phase phase;
    phase.id = "move";
    phase.title = SIM_TEXT("move");
    phase.moves = true;
    phase.points = share.points;
    phase.group = share.group;
    phase.regions = {{here, "move"}};
    phase.run = [points = share.points, h](State &state) {
        for (int i = points.first; i < points.end(); ++i) {
            if (state.feels(i))
                state.place(i, move(state.at(i), state.speed(i), h));
        }
    };
    phase.explain = [](const State &before, const State &after, int point) {
        return changed("x", before.at(point), after.at(point));
    };
    phases.push_back(std::move(phase));
}

void addContactPhases(std::vector<Phase> &phases, const Scene &scene, Share share, Directions directions)
{
    forEach<Contact>(scene, share.points, [&](const Contact &contact, const EffectPtr &effect) {
        Phase phase = effectPhase(effect, share, directions);
        phase.run = [&contact, effect, points = share.points](State &state) {
            contact.resolve(state, points);
        };
        phase.explain = [](const State &before, const State &after, int point) {
            std::vector<Live> live;
            if (before.at(point) != after.at(point))
                live.push_back({"x", after.at(point), before.at(point)});
            if (before.speed(point) != after.speed(point))
                live.push_back({"v", after.speed(point), before.speed(point)});
            return live;
        };
        phases.push_back(std::move(phase));
    });
}

}
