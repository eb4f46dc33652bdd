#include "sim/run/script/composed_interval.h"
#include "sim/run/script/script.h"
#include "tests/lessons/support.h"

#include <QTest>

#include <cstring>
#include <map>
#include <set>

using namespace support;

namespace {

/// Everything that an effect can change, one row a point, and what belongs to no point.
struct Done
{
    std::vector<std::vector<double>> points;
    std::vector<double> rest;
};

bool sameBitsIn(const std::vector<double> &a, const std::vector<double> &b)
{
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0;
}

/// What `effect` does where things are as in `before`.
Done doneBy(const sim::Effect &effect, const sim::State &before, sim::DirectionRule way)
{
    constexpr double h = 0.5; // frames
    sim::State state = before;
    const sim::PointRange all = {0, state.pointCount()};
    state.acceleration.setZero(state.pointCount(), 2);
    state.angularAcceleration.setZero(state.spin.rows());
    if (const auto *force = dynamic_cast<const sim::Force *>(&effect))
        force->add(before, all, 1.0, way, state.acceleration);
    else if (const auto *torque = dynamic_cast<const sim::Torque *>(&effect))
        torque->add(before, all, 1.0, state.angularAcceleration);
    else if (const auto *drag = dynamic_cast<const sim::Drag *>(&effect))
        drag->apply(state, all, h);
    else if (const auto *driver = dynamic_cast<const sim::Driver *>(&effect))
        driver->drive(state, h);
    else if (const auto *constraint = dynamic_cast<const sim::Constraint *>(&effect))
        constraint->enforce(state, all, way, h);
    else if (const auto *contact = dynamic_cast<const sim::Contact *>(&effect))
        contact->resolve(state, all);
    Done done;
    for (int i = 0; i < state.pointCount(); ++i) {
        done.points.push_back({state.position(i, 0), state.position(i, 1), state.velocity(i, 0),
                               state.velocity(i, 1), state.acceleration(i, 0), state.acceleration(i, 1)});
        for (const Eigen::ArrayXd *numbers : {&state.angle, &state.spin, &state.angularAcceleration}) {
            if (numbers->rows() > 0)
                done.points.back().push_back((*numbers)[i]);
        }
    }
    // How far it moves what belongs to no point, not where that comes to: what is changed there is not seen.
    for (Eigen::Index i = 0; i < state.gait.rows(); ++i)
        done.rest.insert(done.rest.end(),
                         {state.gait[i] - before.gait[i], state.gaitSpeed[i] - before.gaitSpeed[i]});
    done.rest.insert(done.rest.end(), {state.gustExtent.front - before.gustExtent.front,
                                       state.gustExtent.tail - before.gustExtent.tail});
    return done;
}

/// Another state of the world: the same but for one thing.
struct Change
{
    std::string what;
    bool isTime = false;
    std::function<void(sim::State &)> make;
};

std::vector<Change> changesOfTheRest()
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
        {"gale", false,
         [](sim::State &s) {
             s.gustExtent = {700.0, 30.0};
         }},
        {"frame", true, [](sim::State &s) { s.frame += 7; }},
    };
}

std::vector<Change> changesOf(int point)
{
    return {
        {"place", false,
         [=](sim::State &s) {
             s.place(point, s.positionOf(point) + sim::Vec2{37.0, -21.0});
         }},
        {"speed", false,
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
        {"place before", false,
         [=](sim::State &s) {
             if (s.previous.rows() > 0)
                 s.previous(point, 0) += 9.0;
         }},
    };
}

/// For each point whether `effect` ties it to `point`, straight or by way of others.
std::vector<bool> tiedTo(const sim::Effect &effect, int point, int points)
{
    std::vector<sim::Coupling> ties;
    effect.addCouplings(ties);
    std::vector<bool> tied(static_cast<std::size_t>(points), false);
    tied[static_cast<std::size_t>(point)] = true;
    for (bool grows = true; grows;) {
        grows = false;
        for (const auto &[a, b] : ties) {
            const auto first = static_cast<std::size_t>(a), second = static_cast<std::size_t>(b);
            if (tied[first] != tied[second])
                tied[first] = tied[second] = grows = true;
        }
    }
    return tied;
}

/// States of a run of `step` to try effects in: as it runs by itself, and with all that comes from outside there.
std::vector<sim::State> statesOf(const sim::Script &script)
{
    sim::State state = stateAfter(script, 20);
    if (state.previous.rows() == 0)
        state.previous = state.position;
    sim::State blown = state;
    blown.input.pointer = sim::Vec2{200.0, 150.0};
    blown.input.pointerDown = true;
    blown.input.newTargets.push_back({100.0, 300.0});
    blown.input.keys.left = true;
    blown.gustExtent = {900.0, 0.0};
    sim::State close = state; // some effects see those nearby only, or do nothing to what stands still
    for (int i = 0; i < close.pointCount(); ++i) {
        close.place(i, close.positionOf(0) + 0.05 * (close.positionOf(i) - close.positionOf(0)));
        close.setVelocity(i, {3.0 + i, 2.0 - i});
    }
    sim::State outside = state; // or at a wall
    outside.position.col(0) -= 1e4;
    return {state, blown, close, outside};
}

/// Some points of a scene, its first and its last among them.
std::vector<int> somePoints(int points)
{
    std::set<int> some = {0, points - 1};
    for (int i = 0; i < points; i += 1 + points / 10)
        some.insert(i);
    return {some.begin(), some.end()};
}

}

/// What an effect says that it sees decides what may sleep and what is computed apart. Here nobody is believed: one
/// thing in a state is changed, and what the effect does elsewhere may differ only if it said so.
class WhatEffectsSee : public QObject
{
    Q_OBJECT

    /// Of the effects called so, those that did something else elsewhere once another point, or what belongs to none,
    /// was changed. Filled by the first test, over all lessons.
    struct Found
    {
        sim::Dependence dependence = sim::Dependence::coupledPoints;
        bool ties = false;
        std::set<std::string> byOthers;
        std::set<std::string> byTheRest;
    };
    std::map<std::string, Found> m_found;

    static std::string nameOf(const sim::Effect &effect)
    {
        const std::map<sim::Dependence, std::string> words = {{sim::Dependence::coupledPoints, "tied"},
                                                              {sim::Dependence::scene, "scene"},
                                                              {sim::Dependence::time, "time"}};
        return effect.id() + " (" + words.at(effect.dependence()) + ")";
    }

    /// What changes elsewhere when the rest of the state does: nothing that the effect has not said.
    void checkRest(const sim::Effect &effect, const sim::State &state, sim::DirectionRule way)
    {
        const Done before = doneBy(effect, state, way);
        for (const Change &change : changesOfTheRest()) {
            sim::State other = state;
            change.make(other);
            const Done after = doneBy(effect, other, way);
            bool same = sameBitsIn(before.rest, after.rest);
            for (std::size_t i = 0; i < before.points.size(); ++i)
                same = same && sameBitsIn(before.points[i], after.points[i]);
            if (same)
                continue;
            m_found[nameOf(effect)].byTheRest.insert(change.what);
            const bool said = effect.dependence() == sim::Dependence::time ||
                              (effect.dependence() == sim::Dependence::scene && !change.isTime);
            QVERIFY2(said, (nameOf(effect) + " sees: " + change.what).c_str());
        }
    }

    /// The same for one point.
    void checkPoint(const sim::Effect &effect, const sim::State &state, sim::DirectionRule way, int point)
    {
        const Done before = doneBy(effect, state, way);
        const std::vector<bool> tied = tiedTo(effect, point, state.pointCount());
        for (const Change &change : changesOf(point)) {
            sim::State other = state;
            change.make(other);
            const Done after = doneBy(effect, other, way);
            for (std::size_t i = 0; i < before.points.size(); ++i) {
                if (static_cast<int>(i) == point || sameBitsIn(before.points[i], after.points[i]))
                    continue;
                m_found[nameOf(effect)].byOthers.insert(change.what);
                QVERIFY2(effect.dependence() != sim::Dependence::coupledPoints || tied[i],
                         (nameOf(effect) + " sees the " + change.what + " of another point").c_str());
            }
        }
    }

private slots:
    void noEffectSeesMoreThanItSays_data()
    {
        QTest::addColumn<QString>("lesson");
        QTest::addColumn<QString>("id");
        for (const QString &lesson : lessonIds()) {
            for (const lessons::Step &step : loadLesson(lesson).steps)
                QTest::addRow("%s/%s", qPrintable(lesson), qPrintable(step.id)) << lesson << step.id;
        }
    }
    void noEffectSeesMoreThanItSays()
    {
        QFETCH(QString, lesson);
        QFETCH(QString, id);
        const sim::Script script = loadLesson(lesson).step(id).script();
        const sim::Scene scene = sim::sceneOf(script, script.values);
        for (const sim::State &state : statesOf(script)) {
            for (const sim::EffectPtr &effect : scene.effects) {
                std::vector<sim::Coupling> ties;
                effect->addCouplings(ties);
                Found &found = m_found[nameOf(*effect)];
                found.dependence = effect->dependence();
                found.ties = found.ties || !ties.empty();
                for (const sim::DirectionRule way :
                     {sim::DirectionRule::regularised, sim::DirectionRule::published}) {
                    checkRest(*effect, state, way);
                    for (const int point : somePoints(state.pointCount()))
                        checkPoint(*effect, state, way, point);
                }
            }
        }
    }

    void eachSeesWhatItSaysSomewhere()
    {
        QVERIFY(m_found.size() > 10);
        for (const auto &[name, found] : m_found) {
            if (found.dependence != sim::Dependence::coupledPoints)
                QVERIFY2(!found.byTheRest.empty(), name.c_str());
            if (found.dependence == sim::Dependence::time)
                QVERIFY2(found.byTheRest.contains("frame"), name.c_str());
            if (found.dependence == sim::Dependence::coupledPoints && found.ties)
                QVERIFY2(!found.byOthers.empty(), name.c_str());
        }
    }
};

QTEST_GUILESS_MAIN(WhatEffectsSee)
#include "tst_effect_dependences.moc"
