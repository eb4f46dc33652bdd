#include "sim/analysis/cost/instrumented_effect.h"

namespace sim {

namespace {

/// Leaves `slopes` without entries and with the memory that it has: to ask for more takes as long as the state of the
/// heap will have it, which is no cost of an effect.
void empty(Jacobian &jacobian, const State &state)
{
    const Jacobian none(state.pointCount());
    jacobian = none;
}

/// What is the same for every kind of effect.
template <class Base>
class Probe : public Base
{
public:
    Probe(std::shared_ptr<const Base> seen, CallCounter &counter)
        : m_seen(std::move(seen)), m_counter(counter)
    {
    }

    std::string id() const override { return m_seen->id(); }
    std::string title() const override { return m_seen->title(); }
    EffectKind kind() const override { return m_seen->kind(); }
    std::vector<Region> regions(DirectionRule directionRule) const override
    {
        return m_seen->regions(directionRule);
    }
    int count(const State &state, PointRange points) const override { return m_seen->count(state, points); }
    Dependence dependence() const override { return m_seen->dependence(); }
    void addCouplings(std::vector<Coupling> &into) const override { m_seen->addCouplings(into); }
    bool isIdle() const override { return m_seen->isIdle(); }

protected:
    const std::shared_ptr<const Base> m_seen;
    CallCounter &m_counter;
};

class ForceProbe : public Probe<Force>
{
public:
    using Probe::Probe;
    void add(const State &state, PointRange movers, double scale, DirectionRule directionRule,
             Eigen::ArrayX2d &into) const override
    {
        note(state, into, {movers},
             [seen = m_seen, movers, scale, directionRule](const State &at, Eigen::ArrayX2d &sum) {
                 seen->add(at, movers, scale, directionRule, sum);
             });
    }
    AccelerationAdder adderFor(const std::vector<PointRange> &ranges) const override
    {
        return [this, ranges, add = m_seen->adderFor(ranges)](const State &state, Eigen::ArrayX2d &into) {
            note(state, into, ranges, add);
        };
    }
    bool addJacobian(const State &state, PointRange movers, double scale, DirectionRule directionRule,
                     Jacobian &jacobian) const override
    {
        const auto alone = [seen = m_seen, movers, scale, directionRule](const State &at, Jacobian &sum) {
            empty(sum, at);
            seen->addJacobian(at, movers, scale, directionRule, sum);
        };
        m_counter.slopes.add([&] {
            return replayOf([alone, state, jacobian = Jacobian(0)]() mutable { alone(state, jacobian); });
        });
        for (int i = 0; i < m_counter.repeats; ++i)
            alone(state, m_counter.found);
        return m_seen->addJacobian(state, movers, scale, directionRule, jacobian);
    }
    std::optional<double> potentialEnergy(const State &state) const override
    {
        return m_seen->potentialEnergy(state);
    }
    bool conservesMomentum(const State &state) const override { return m_seen->conservesMomentum(state); }
    std::vector<LiveValue> explain(const State &state, int mover, DirectionRule directionRule) const override
    {
        return m_seen->explain(state, mover, directionRule);
    }

private:
    template <class Add>
    void note(const State &state, Eigen::ArrayX2d &into, const std::vector<PointRange> &ranges,
              const Add &add) const
    {
        m_counter.makeRoom(state);
        for (const PointRange &range : ranges)
            m_counter.turn(range);
        m_counter.acts.add(
            [&] { return replayOf([add, state, into = into]() mutable { add(state, into); }); });
        for (int i = 0; i < m_counter.repeats; ++i)
            add(state, m_counter.pulls);
        add(state, into);
    }
};

class TorqueProbe : public Probe<Torque>
{
public:
    using Probe::Probe;
    void add(const State &state, PointRange movers, double scale, Eigen::ArrayXd &into) const override
    {
        m_counter.makeRoom(state);
        m_counter.turn(movers);
        m_counter.acts.add([&] {
            return replayOf([seen = m_seen, state, movers, scale, into = into]() mutable {
                seen->add(state, movers, scale, into);
            });
        });
        for (int i = 0; i < m_counter.repeats; ++i)
            m_seen->add(state, movers, scale, m_counter.turns);
        m_seen->add(state, movers, scale, into);
    }
    bool addJacobian(const State &state, PointRange movers, double scale, Jacobian &jacobian) const override
    {
        const auto alone = [seen = m_seen, movers, scale](const State &at, Jacobian &sum) {
            empty(sum, at);
            seen->addJacobian(at, movers, scale, sum);
        };
        m_counter.slopes.add([&] {
            return replayOf([alone, state, jacobian = Jacobian(0)]() mutable { alone(state, jacobian); });
        });
        for (int i = 0; i < m_counter.repeats; ++i)
            alone(state, m_counter.found);
        return m_seen->addJacobian(state, movers, scale, jacobian);
    }
    std::optional<double> potentialEnergy(const State &state) const override
    {
        return m_seen->potentialEnergy(state);
    }
    Eigen::ArrayXd inertia() const override { return m_seen->inertia(); }
    std::vector<LiveValue> explain(const State &state, int mover) const override
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
        m_counter.makeRoom(state);
        m_counter.turn({0, state.pointCount()});
        m_counter.acts.add(
            [&] { return replayOf([seen = m_seen, state, h]() mutable { seen->drive(state, h); }); });
        for (int i = 0; i < m_counter.repeats; ++i)
            m_seen->drive(m_counter.state, h);
        m_seen->drive(state, h);
    }
    DriverTiming timing() const override { return m_seen->timing(); }
    std::vector<LiveValue> explain(const State &before, const State &after, int point) const override
    {
        return m_seen->explain(before, after, point);
    }
};

// What follows always has a phase of its own: it is measured there, and only counted here.

class DragProbe : public Probe<Drag>
{
public:
    using Probe::Probe;
    void apply(State &state, PointRange points, double h) const override
    {
        m_counter.turn(points);
        ++m_counter.acts.count;
        m_seen->apply(state, points, h);
    }
    std::optional<double> dampingRate(int point) const override { return m_seen->dampingRate(point); }
    std::vector<LiveValue> explain(const State &before, const State &after, int point,
                                   double h) const override
    {
        return m_seen->explain(before, after, point, h);
    }
};

class ConstraintProbe : public Probe<Constraint>
{
public:
    using Probe::Probe;
    void enforce(State &state, PointRange points, DirectionRule directionRule, double h) const override
    {
        m_counter.turn(points);
        ++m_counter.acts.count;
        m_seen->enforce(state, points, directionRule, h);
    }
    std::vector<LiveValue> explain(const State &before, const State &after, int point) const override
    {
        return m_seen->explain(before, after, point);
    }
};

class ContactProbe : public Probe<Contact>
{
public:
    using Probe::Probe;
    void resolve(State &state, PointRange points) const override
    {
        m_counter.turn(points);
        ++m_counter.acts.count;
        m_seen->resolve(state, points);
    }
    std::vector<Surface> surfaces(int point) const override { return m_seen->surfaces(point); }
};

template <class Base, class Seeing>
EffectPtr probed(const EffectPtr &effect, CallCounter &counter)
{
    const auto typed = sharedAs<Base>(effect);
    return typed ? std::make_shared<const Seeing>(typed, counter) : nullptr;
}

}

EffectPtr instrumented(const EffectPtr &effect, CallCounter &counter)
{
    for (const auto probe :
         {probed<Force, ForceProbe>, probed<Torque, TorqueProbe>, probed<Driver, DriverProbe>,
          probed<Drag, DragProbe>, probed<Constraint, ConstraintProbe>, probed<Contact, ContactProbe>}) {
        if (const EffectPtr found = probe(effect, counter))
            return found;
    }
    return effect;
}

}
