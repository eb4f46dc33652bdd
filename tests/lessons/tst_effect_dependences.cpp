#include "sim/run/script/composed_interval.h"
#include "sim/run/script/script.h"
#include "tests/lessons/support/support.h"
#include "tests/suite.h"

#include <QTest>

#include <cstring>
#include <map>
#include <set>

using namespace support;

namespace {

/// The quantities that an effect can change.
struct Result
{
    std::vector<std::vector<double>> points; ///< per point
    std::vector<double> global;              ///< that belong to no point
};

bool sameBitsIn(const std::vector<double> &a, const std::vector<double> &b)
{
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0;
}

/// Applies `effect` to a copy of `before`.
Result resultOf(const sim::Effect &effect, const sim::State &before, sim::DirectionRule rule)
{
    constexpr double h = 0.5; // frames
    sim::State state = before;
    const sim::PointRange all = {0, state.pointCount()};
    state.acceleration.setZero(state.pointCount(), 2);
    state.angularAcceleration.setZero(state.spin.rows());
    if (const auto *force = dynamic_cast<const sim::Force *>(&effect))
        force->add(before, all, 1.0, rule, state.acceleration);
    else if (const auto *torque = dynamic_cast<const sim::Torque *>(&effect))
        torque->add(before, all, 1.0, state.angularAcceleration);
    else if (const auto *drag = dynamic_cast<const sim::Drag *>(&effect))
        drag->apply(state, all, h);
    else if (const auto *driver = dynamic_cast<const sim::Driver *>(&effect))
        driver->drive(state, h);
    else if (const auto *constraint = dynamic_cast<const sim::Constraint *>(&effect))
        constraint->enforce(state, all, rule, h);
    else if (const auto *contact = dynamic_cast<const sim::Contact *>(&effect))
        contact->resolve(state, all);
    Result result;
    for (int i = 0; i < state.pointCount(); ++i) {
        result.points.push_back({state.position(i, 0), state.position(i, 1), state.velocity(i, 0),
                                 state.velocity(i, 1), state.acceleration(i, 0), state.acceleration(i, 1)});
        for (const Eigen::ArrayXd *numbers : {&state.angle, &state.spin, &state.angularAcceleration}) {
            if (numbers->rows() > 0)
                result.points.back().push_back((*numbers)[i]);
        }
    }
    // The change of each global quantity, so that a changed start value alone is no difference.
    for (Eigen::Index i = 0; i < state.gait.rows(); ++i)
        result.global.insert(result.global.end(),
                             {state.gait[i] - before.gait[i], state.gaitSpeed[i] - before.gaitSpeed[i]});
    result.global.insert(result.global.end(), {state.gustExtent.front - before.gustExtent.front,
                                               state.gustExtent.tail - before.gustExtent.tail});
    return result;
}

/// A change of one quantity of a state.
struct Change
{
    std::string quantity;
    bool isTime = false;
    std::function<void(sim::State &)> apply;
};

std::vector<Change> changesOfTheGlobals()
{
    return {
        {"gait", false, [](sim::State &s) { s.gait += 0.7; }},
        {"gait speed", false, [](sim::State &s) { s.gaitSpeed += 0.3; }},
        {"pointer", false,
         [](sim::State &s) {
             s.input.pointer = sim::Vec2{410.0, 90.0};
         }},
        {"button", false, [](sim::State &s) { s.input.pointerDown = !s.input.pointerDown; }},
        {"target", false,
         [](sim::State &s) {
             s.input.target = {17.0, 23.0};
         }},
        {"new target", false,
         [](sim::State &s) {
             s.input.newTargets.push_back({310.0, 20.0});
         }},
        {"gust", false, [](sim::State &s) { s.input.gust = 13.0; }},
        {"key", false, [](sim::State &s) { s.input.keys.right = !s.input.keys.right; }},
        {"gust extent", false,
         [](sim::State &s) {
             s.gustExtent = {700.0, 30.0};
         }},
        {"frame", true, [](sim::State &s) { s.frame += 7; }},
    };
}

std::vector<Change> changesOf(int point)
{
    return {
        {"position", false,
         [=](sim::State &s) {
             s.place(point, s.positionOf(point) + sim::Vec2{37.0, -21.0});
         }},
        {"velocity", false,
         [=](sim::State &s) {
             s.setVelocity(point, s.velocityOf(point) + sim::Vec2{-3.0, 5.0});
         }},
        {"mass", false, [=](sim::State &s) { s.inverseMass[point] = s.isDynamic(point) ? 0.0 : 1.0; }},
        {"angle", false,
         [=](sim::State &s) {
             if (s.angle.rows() > 0)
                 s.angle[point] += 20.0;
         }},
        {"spin", false,
         [=](sim::State &s) {
             if (s.spin.rows() > 0)
                 s.spin[point] += 4.0;
         }},
        {"previous position", false,
         [=](sim::State &s) {
             if (s.previous.rows() > 0)
                 s.previous(point, 0) += 9.0;
         }},
    };
}

/// Returns for each point whether `effect` couples it to `point`, directly or through other points.
std::vector<bool> coupledTo(const sim::Effect &effect, int point, int points)
{
    std::vector<sim::Coupling> couplings;
    effect.addCouplings(couplings);
    std::vector<bool> isCoupled(static_cast<std::size_t>(points), false);
    isCoupled[static_cast<std::size_t>(point)] = true;
    for (bool grows = true; grows;) {
        grows = false;
        for (const auto &[a, b] : couplings) {
            const auto first = static_cast<std::size_t>(a), second = static_cast<std::size_t>(b);
            if (isCoupled[first] != isCoupled[second])
                isCoupled[first] = isCoupled[second] = grows = true;
        }
    }
    return isCoupled;
}

/// Returns states of a run in which effects are tested: without input, with all input, contracted, and
/// outside walls.
std::vector<sim::State> statesOf(const sim::Script &script)
{
    sim::State state = stateAfter(script, 20);
    if (state.previous.rows() == 0)
        state.previous = state.position;
    sim::State withInput = state;
    withInput.input.pointer = sim::Vec2{200.0, 150.0};
    withInput.input.pointerDown = true;
    withInput.input.newTargets.push_back({100.0, 300.0});
    withInput.input.keys.left = true;
    withInput.gustExtent = {900.0, 0.0};
    sim::State contracted = state; // some effects act only on near or moving points
    for (int i = 0; i < contracted.pointCount(); ++i) {
        contracted.place(i, contracted.positionOf(0) +
                                0.05 * (contracted.positionOf(i) - contracted.positionOf(0)));
        contracted.setVelocity(i, {3.0 + i, 2.0 - i});
    }
    sim::State outside = state; // some act only at a wall
    outside.position.col(0) -= 1e4;
    return {state, withInput, contracted, outside};
}

/// Returns about ten points of a scene, including the first and the last.
std::vector<int> somePoints(int pointCount)
{
    std::set<int> chosen = {0, pointCount - 1};
    for (int i = 0; i < pointCount; i += 1 + pointCount / 10)
        chosen.insert(i);
    return {chosen.begin(), chosen.end()};
}

}

/// Tests Effect::dependence() and Effect::addCouplings(). They decide which points may sleep and which are
/// computed separately. The tests change one quantity of a state. The effect may change elsewhere only as it
/// has declared.
class EffectDependences : public QObject
{
    Q_OBJECT

    /// The dependences observed for an effect: quantities of other points and global quantities that changed
    /// its result. Filled by the first test, over all lessons.
    struct Found
    {
        sim::Dependence dependence = sim::Dependence::coupledPoints;
        bool hasCouplings = false;
        std::set<std::string> quantitiesOfOthers;
        std::set<std::string> globalQuantities;
    };
    std::map<std::string, Found> m_found; ///< by name of the effect

    static std::string nameOf(const sim::Effect &effect)
    {
        const std::map<sim::Dependence, std::string> words = {
            {sim::Dependence::coupledPoints, "coupled points"},
            {sim::Dependence::scene, "scene"},
            {sim::Dependence::time, "time"}};
        return effect.id() + " (" + words.at(effect.dependence()) + ")";
    }

    /// Checks that changed global quantities affect the result only as declared.
    void checkGlobals(const sim::Effect &effect, const sim::State &state, sim::DirectionRule rule)
    {
        const Result before = resultOf(effect, state, rule);
        for (const Change &change : changesOfTheGlobals()) {
            sim::State other = state;
            change.apply(other);
            const Result after = resultOf(effect, other, rule);
            bool same = sameBitsIn(before.global, after.global);
            for (std::size_t i = 0; i < before.points.size(); ++i)
                same = same && sameBitsIn(before.points[i], after.points[i]);
            if (same)
                continue;
            m_found[nameOf(effect)].globalQuantities.insert(change.quantity);
            const bool isDeclared = effect.dependence() == sim::Dependence::time ||
                                    (effect.dependence() == sim::Dependence::scene && !change.isTime);
            QVERIFY2(isDeclared, (nameOf(effect) + " depends on: " + change.quantity).c_str());
        }
    }

    /// Checks that a changed quantity of `point` affects other points only as declared.
    void checkPoint(const sim::Effect &effect, const sim::State &state, sim::DirectionRule rule, int point)
    {
        const Result before = resultOf(effect, state, rule);
        const std::vector<bool> isCoupled = coupledTo(effect, point, state.pointCount());
        for (const Change &change : changesOf(point)) {
            sim::State other = state;
            change.apply(other);
            const Result after = resultOf(effect, other, rule);
            for (std::size_t i = 0; i < before.points.size(); ++i) {
                if (static_cast<int>(i) == point || sameBitsIn(before.points[i], after.points[i]))
                    continue;
                m_found[nameOf(effect)].quantitiesOfOthers.insert(change.quantity);
                QVERIFY2(
                    effect.dependence() != sim::Dependence::coupledPoints || isCoupled[i],
                    (nameOf(effect) + " depends on the " + change.quantity + " of another point").c_str());
            }
        }
    }

private slots:
    void effectsDependOnlyOnWhatTheyDeclare_data() { addStepRows(); }
    void effectsDependOnlyOnWhatTheyDeclare()
    {
        const sim::Script script = stepOfRow().script();
        const sim::Scene scene = sim::sceneOf(script, script.values);
        for (const sim::State &state : statesOf(script)) {
            for (const sim::EffectPtr &effect : scene.effects) {
                std::vector<sim::Coupling> couplings;
                effect->addCouplings(couplings);
                Found &found = m_found[nameOf(*effect)];
                found.dependence = effect->dependence();
                found.hasCouplings = found.hasCouplings || !couplings.empty();
                for (const sim::DirectionRule rule :
                     {sim::DirectionRule::regularised, sim::DirectionRule::published}) {
                    checkGlobals(*effect, state, rule);
                    for (const int point : somePoints(state.pointCount()))
                        checkPoint(*effect, state, rule, point);
                }
            }
        }
    }

    void declaredDependencesOccur()
    {
        QVERIFY(m_found.size() > 10);
        for (const auto &[name, found] : m_found) {
            if (found.dependence != sim::Dependence::coupledPoints)
                QVERIFY2(!found.globalQuantities.empty(), name.c_str());
            if (found.dependence == sim::Dependence::time)
                QVERIFY2(found.globalQuantities.contains("frame"), name.c_str());
            if (found.dependence == sim::Dependence::coupledPoints && found.hasCouplings)
                QVERIFY2(!found.quantitiesOfOthers.empty(), name.c_str());
        }
    }
};

SUITE(tst_effect_dependences, EffectDependences)
#include "tst_effect_dependences.moc"
