#include "sim/analysis/cost/instrumented_effect.h"

namespace sim {

namespace {

/// Leaves `slopes` without entries and with the memory that it has: to ask for more takes as long as the state of the
/// heap will have it, which is no cost of an effect.
void empty(Slopes &slopes, const State &state)
{
    const Slopes none(state.points());
    slopes = none;
}

/// What is the same for every kind of effect.
template <class Base>
class Probe : public Base
{
public:
    Probe(std::shared_ptr<const Base> seen, Tally &tally) : m_seen(std::move(seen)), m_tally(tally) {}

    std::string id() const override { return m_seen->id(); }
    std::string title() const override { return m_seen->title(); }
    Kind kind() const override { return m_seen->kind(); }
    std::vector<Region> regions(Directions directions) const override { return m_seen->regions(directions); }
    int count(const State &state, Points points) const override { return m_seen->count(state, points); }
    Sees sees() const override { return m_seen->sees(); }
    void ties(std::vector<Tie> &into) const override { m_seen->ties(into); }
    bool idle() const override { return m_seen->idle(); }

protected:
    const std::shared_ptr<const Base> m_seen;
    Tally &m_tally;
};

class ForceProbe : public Probe<Force>
{
public:
    using Probe::Probe;
    void add(const State &state, Points movers, double scale, Directions directions,
             Eigen::ArrayX2d &into) const override
    {
        note(state, into, {movers},
             [seen = m_seen, movers, scale, directions](const State &at, Eigen::ArrayX2d &sum) {
                 seen->add(at, movers, scale, directions, sum);
             });
    }
    AddPart part(const std::vector<Points> &runs) const override
    {
        return [this, runs, add = m_seen->part(runs)](const State &state, Eigen::ArrayX2d &into) {
            note(state, into, runs, add);
        };
    }
    bool addSlopes(const State &state, Points movers, double scale, Directions directions,
                   Slopes &into) const override
    {
        const auto alone = [seen = m_seen, movers, scale, directions](const State &at, Slopes &slopes) {
            empty(slopes, at);
            seen->addSlopes(at, movers, scale, directions, slopes);
        };
        m_tally.slopes.add(
            [&] { return replayOf([alone, state, slopes = Slopes(0)]() mutable { alone(state, slopes); }); });
        for (int i = 0; i < m_tally.repeats; ++i)
            alone(state, m_tally.found);
        return m_seen->addSlopes(state, movers, scale, directions, into);
    }
    std::optional<double> energy(const State &state) const override { return m_seen->energy(state); }
    bool balances(const State &state) const override { return m_seen->balances(state); }
    std::vector<Live> explain(const State &state, int mover, Directions directions) const override
    {
        return m_seen->explain(state, mover, directions);
    }

private:
    template <class Add>
    void note(const State &state, Eigen::ArrayX2d &into, const std::vector<Points> &runs,
              const Add &add) const
    {
        m_tally.makeRoom(state);
        for (const Points &run : runs)
            m_tally.turn(run);
        m_tally.acts.add([&] { return replayOf([add, state, into = into]() mutable { add(state, into); }); });
        for (int i = 0; i < m_tally.repeats; ++i)
            add(state, m_tally.pulls);
        add(state, into);
    }
};

class TorqueProbe : public Probe<Torque>
{
public:
    using Probe::Probe;
    void add(const State &state, Points movers, double scale, Eigen::ArrayXd &into) const override
    {
        m_tally.makeRoom(state);
        m_tally.turn(movers);
        m_tally.acts.add([&] {
            return replayOf([seen = m_seen, state, movers, scale, into = into]() mutable {
                seen->add(state, movers, scale, into);
            });
        });
        for (int i = 0; i < m_tally.repeats; ++i)
            m_seen->add(state, movers, scale, m_tally.turns);
        m_seen->add(state, movers, scale, into);
    }
    bool addSlopes(const State &state, Points movers, double scale, Slopes &into) const override
    {
        const auto alone = [seen = m_seen, movers, scale](const State &at, Slopes &slopes) {
            empty(slopes, at);
            seen->addSlopes(at, movers, scale, slopes);
        };
        m_tally.slopes.add(
            [&] { return replayOf([alone, state, slopes = Slopes(0)]() mutable { alone(state, slopes); }); });
        for (int i = 0; i < m_tally.repeats; ++i)
            alone(state, m_tally.found);
        return m_seen->addSlopes(state, movers, scale, into);
    }
    std::optional<double> energy(const State &state) const override { return m_seen->energy(state); }
    Eigen::ArrayXd inertia() const override { return m_seen->inertia(); }
    std::vector<Live> explain(const State &state, int mover) const override
    {
        return m_seen->explain(state, mover);
    }
};

class DriverProbe : public Probe<Driver>
{
public:
    using Probe::Probe;
    void drive(State &state, double h) const override
    {
        m_tally.makeRoom(state);
        m_tally.turn({0, state.points()});
        m_tally.acts.add(
            [&] { return replayOf([seen = m_seen, state, h]() mutable { seen->drive(state, h); }); });
        for (int i = 0; i < m_tally.repeats; ++i)
            m_seen->drive(m_tally.state, h);
        m_seen->drive(state, h);
    }
    Pace pace() const override { return m_seen->pace(); }
    std::vector<Live> explain(const State &before, const State &after, int point) const override
    {
        return m_seen->explain(before, after, point);
    }
};

// What follows always has a phase of its own: it is measured there, and only counted here.

class DragProbe : public Probe<Drag>
{
public:
    using Probe::Probe;
    void slow(State &state, Points points, double h) const override
    {
        m_tally.turn(points);
        ++m_tally.acts.count;
        m_seen->slow(state, points, h);
    }
    std::optional<double> rate(int point) const override { return m_seen->rate(point); }
    std::vector<Live> explain(const State &before, const State &after, int point, double h) const override
    {
        return m_seen->explain(before, after, point, h);
    }
};

class ConstraintProbe : public Probe<Constraint>
{
public:
    using Probe::Probe;
    void enforce(State &state, Points points, Directions directions, double h) const override
    {
        m_tally.turn(points);
        ++m_tally.acts.count;
        m_seen->enforce(state, points, directions, h);
    }
    std::vector<Live> explain(const State &before, const State &after, int point) const override
    {
        return m_seen->explain(before, after, point);
    }
};

class ContactProbe : public Probe<Contact>
{
public:
    using Probe::Probe;
    void resolve(State &state, Points points) const override
    {
        m_tally.turn(points);
        ++m_tally.acts.count;
        m_seen->resolve(state, points);
    }
    std::vector<Surface> surfaces(int point) const override { return m_seen->surfaces(point); }
};

template <class Base, class Seeing>
EffectPtr probed(const EffectPtr &effect, Tally &tally)
{
    const auto typed = shared<Base>(effect);
    return typed ? std::make_shared<const Seeing>(typed, tally) : nullptr;
}

}

EffectPtr probeOf(const EffectPtr &effect, Tally &tally)
{
    for (const auto probe :
         {probed<Force, ForceProbe>, probed<Torque, TorqueProbe>, probed<Driver, DriverProbe>,
          probed<Drag, DragProbe>, probed<Constraint, ConstraintProbe>, probed<Contact, ContactProbe>}) {
        if (const EffectPtr found = probe(effect, tally))
            return found;
    }
    return effect;
}

}
