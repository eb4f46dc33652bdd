#include "sim/analysis/cost/instrumented_effect.h"

namespace sim {

namespace {

/// Removes all entries of `jacobian` but keeps its memory. The time of an allocation depends on the heap and
/// is no cost of an effect.
void clearEntries(Jacobian &jacobian, const State &state)
{
    const Jacobian empty(state.pointCount());
    jacobian = empty;
}

/// The part that is the same for all kinds of effects.
template <class Base>
class Instrumented : public Base
{
public:
    Instrumented(std::shared_ptr<const Base> effect, CallCounter &counter)
        : m_effect(std::move(effect)), m_counter(counter)
    {
    }

    std::string id() const override { return m_effect->id(); }
    std::string title() const override { return m_effect->title(); }
    EffectKind kind() const override { return m_effect->kind(); }
    std::vector<Region> regions(DirectionRule directionRule) const override
    {
        return m_effect->regions(directionRule);
    }
    int count(const State &state, PointRange points) const override { return m_effect->count(state, points); }
    Dependence dependence() const override { return m_effect->dependence(); }
    void addCouplings(std::vector<Coupling> &into) const override { m_effect->addCouplings(into); }
    bool isIdle() const override { return m_effect->isIdle(); }

protected:
    const std::shared_ptr<const Base> m_effect;
    CallCounter &m_counter;
};

class InstrumentedForce : public Instrumented<Force>
{
public:
    using Instrumented::Instrumented;
    void add(const State &state, PointRange movers, double scale, DirectionRule directionRule,
             Eigen::ArrayX2d &into) const override
    {
        countAndAdd(state, into, {movers},
                    [effect = m_effect, movers, scale, directionRule](const State &at, Eigen::ArrayX2d &sum) {
                        effect->add(at, movers, scale, directionRule, sum);
                    });
    }
    AccelerationAdder adderFor(const std::vector<PointRange> &ranges) const override
    {
        return [this, ranges, add = m_effect->adderFor(ranges)](const State &state, Eigen::ArrayX2d &into) {
            countAndAdd(state, into, ranges, add);
        };
    }
    bool addJacobian(const State &state, PointRange movers, double scale, DirectionRule directionRule,
                     Jacobian &jacobian) const override
    {
        const auto compute = [effect = m_effect, movers, scale, directionRule](const State &at,
                                                                               Jacobian &sum) {
            clearEntries(sum, at);
            effect->addJacobian(at, movers, scale, directionRule, sum);
        };
        m_counter.jacobianCalls.add([&] {
            return replayOf([compute, state, jacobian = Jacobian(0)]() mutable { compute(state, jacobian); });
        });
        for (int i = 0; i < m_counter.repeats; ++i)
            compute(state, m_counter.jacobianScratch);
        return m_effect->addJacobian(state, movers, scale, directionRule, jacobian);
    }
    bool dependsOnVelocity() const override { return m_effect->dependsOnVelocity(); }
    std::optional<double> potentialEnergy(const State &state) const override
    {
        return m_effect->potentialEnergy(state);
    }
    bool conservesMomentum(const State &state) const override { return m_effect->conservesMomentum(state); }
    std::vector<LiveValue> explain(const State &state, int mover, DirectionRule directionRule) const override
    {
        return m_effect->explain(state, mover, directionRule);
    }

private:
    template <class Add>
    void countAndAdd(const State &state, Eigen::ArrayX2d &into, const std::vector<PointRange> &ranges,
                     const Add &add) const
    {
        m_counter.allocateScratch(state);
        for (const PointRange &range : ranges)
            m_counter.countPoints(range);
        m_counter.effectCalls.add(
            [&] { return replayOf([add, state, into = into]() mutable { add(state, into); }); });
        for (int i = 0; i < m_counter.repeats; ++i)
            add(state, m_counter.accelerationScratch);
        add(state, into);
    }
};

class InstrumentedTorque : public Instrumented<Torque>
{
public:
    using Instrumented::Instrumented;
    void add(const State &state, PointRange movers, double scale, Eigen::ArrayXd &into) const override
    {
        m_counter.allocateScratch(state);
        m_counter.countPoints(movers);
        m_counter.effectCalls.add([&] {
            return replayOf([effect = m_effect, state, movers, scale, into = into]() mutable {
                effect->add(state, movers, scale, into);
            });
        });
        for (int i = 0; i < m_counter.repeats; ++i)
            m_effect->add(state, movers, scale, m_counter.angularAccelerationScratch);
        m_effect->add(state, movers, scale, into);
    }
    bool addJacobian(const State &state, PointRange movers, double scale, Jacobian &jacobian) const override
    {
        const auto compute = [effect = m_effect, movers, scale](const State &at, Jacobian &sum) {
            clearEntries(sum, at);
            effect->addJacobian(at, movers, scale, sum);
        };
        m_counter.jacobianCalls.add([&] {
            return replayOf([compute, state, jacobian = Jacobian(0)]() mutable { compute(state, jacobian); });
        });
        for (int i = 0; i < m_counter.repeats; ++i)
            compute(state, m_counter.jacobianScratch);
        return m_effect->addJacobian(state, movers, scale, jacobian);
    }
    std::optional<double> potentialEnergy(const State &state) const override
    {
        return m_effect->potentialEnergy(state);
    }
    Eigen::ArrayXd inertia() const override { return m_effect->inertia(); }
    std::vector<LiveValue> explain(const State &state, int mover) const override
    {
        return m_effect->explain(state, mover);
    }
};

class InstrumentedDriver : public Instrumented<Driver>
{
public:
    using Instrumented::Instrumented;
    void drive(State &state, double h) const override
    {
        m_counter.allocateScratch(state);
        m_counter.countPoints({0, state.pointCount()});
        m_counter.effectCalls.add(
            [&] { return replayOf([effect = m_effect, state, h]() mutable { effect->drive(state, h); }); });
        for (int i = 0; i < m_counter.repeats; ++i)
            m_effect->drive(m_counter.stateScratch, h);
        m_effect->drive(state, h);
    }
    DriverTiming timing() const override { return m_effect->timing(); }
    std::vector<LiveValue> explain(const State &before, const State &after, int point) const override
    {
        return m_effect->explain(before, after, point);
    }
};

// The kinds below always have a phase to themselves, which is timed. So their calls are only counted.

class InstrumentedDrag : public Instrumented<Drag>
{
public:
    using Instrumented::Instrumented;
    void apply(State &state, PointRange points, double h) const override
    {
        m_counter.countPoints(points);
        ++m_counter.effectCalls.count;
        m_effect->apply(state, points, h);
    }
    std::optional<double> dampingRate(int point) const override { return m_effect->dampingRate(point); }
    std::vector<LiveValue> explain(const State &before, const State &after, int point,
                                   double h) const override
    {
        return m_effect->explain(before, after, point, h);
    }
};

class InstrumentedConstraint : public Instrumented<Constraint>
{
public:
    using Instrumented::Instrumented;
    void enforce(State &state, PointRange points, DirectionRule directionRule, double h) const override
    {
        m_counter.countPoints(points);
        ++m_counter.effectCalls.count;
        m_effect->enforce(state, points, directionRule, h);
    }
    std::vector<LiveValue> explain(const State &before, const State &after, int point) const override
    {
        return m_effect->explain(before, after, point);
    }
};

class InstrumentedContact : public Instrumented<Contact>
{
public:
    using Instrumented::Instrumented;
    void resolve(State &state, PointRange points) const override
    {
        m_counter.countPoints(points);
        ++m_counter.effectCalls.count;
        m_effect->resolve(state, points);
    }
    std::vector<Surface> surfaces(int point) const override { return m_effect->surfaces(point); }
};

template <class Base, class InstrumentedType>
EffectPtr instrumentedAs(const EffectPtr &effect, CallCounter &counter)
{
    const auto typed = sharedAs<Base>(effect);
    return typed ? std::make_shared<const InstrumentedType>(typed, counter) : nullptr;
}

}

EffectPtr instrumented(const EffectPtr &effect, CallCounter &counter)
{
    for (const auto wrap :
         {instrumentedAs<Force, InstrumentedForce>, instrumentedAs<Torque, InstrumentedTorque>,
          instrumentedAs<Driver, InstrumentedDriver>, instrumentedAs<Drag, InstrumentedDrag>,
          instrumentedAs<Constraint, InstrumentedConstraint>, instrumentedAs<Contact, InstrumentedContact>}) {
        if (const EffectPtr instrumentedEffect = wrap(effect, counter))
            return instrumentedEffect;
    }
    return effect;
}

}
