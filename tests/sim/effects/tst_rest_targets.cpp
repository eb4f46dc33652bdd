// Springs and sticks do nothing to a point at its rest target.

#include "tests/sim/support/support.h"

#include "sim/effects/constraints/soft_sticks.h"
#include "sim/effects/constraints/sticks.h"
#include "sim/effects/springs/leg_spring.h"
#include "sim/effects/springs/offset_spring.h"
#include "sim/effects/springs/radial_spring.h"
#include "sim/effects/springs/springs.h"
#include "tests/suite.h"

#include <QTest>

using namespace sim;
using support::Dice;

namespace {

constexpr int scatteredPoints = 4;

State scattered(Dice &dice)
{
    State state = State::ofPoints(scatteredPoints);
    for (int i = 0; i < scatteredPoints; ++i)
        state.place(i, {dice.real(-300, 300), dice.real(-300, 300)});
    state.gait = Eigen::ArrayXd::Constant(1, dice.real(-3, 3));
    return state;
}

using EffectOf = std::function<EffectPtr(Dice &)>;

}

class TestRestTargets : public QObject
{
    Q_OBJECT

    static constexpr double k = 0.3;

private slots:
    void pointAtItsRestTargetStaysThere_data()
    {
        QTest::addColumn<EffectOf>("make");
        QTest::newRow("radial spring") << EffectOf([](Dice &dice) {
            return std::make_shared<RadialSpring>(std::vector<Link>{{0, 3}}, k, dice.real(1, 90));
        });
        QTest::newRow("offset spring") << EffectOf([](Dice &dice) {
            return std::make_shared<OffsetSpring>(std::vector<Link>{{1, 3}}, k, dice.real(1, 90));
        });
        QTest::newRow("spring with individual stiffness") << EffectOf([](Dice &dice) {
            return std::make_shared<Springs>(std::vector<Spring>{{0, 2, k, dice.real(1, 90)}},
                                             scatteredPoints);
        });
        for (const Aim aim : {Aim::bone, Aim::below, Aim::swing})
            QTest::addRow("leg %d", int(aim)) << EffectOf([aim](Dice &dice) {
                LegRule rule;
                rule.k = k;
                rule.leg = dice.real(10, 90);
                rule.drop = dice.real(0, 90);
                rule.aim = aim;
                return std::make_shared<LegSpring>(std::vector<Leg>{{0, 3, dice.real(0, 6)}}, rule);
            });
        QTest::newRow("stick") << EffectOf([](Dice &dice) {
            Stick stick;
            stick.a = 1;
            stick.b = 2;
            stick.length = dice.real(1, 90);
            return std::make_shared<Sticks>(std::vector<Stick>{stick}, scatteredPoints);
        });
        QTest::newRow("soft stick") << EffectOf([](Dice &dice) {
            const double rest = dice.real(30, 60);
            return std::make_shared<SoftSticks>(std::vector<SoftStick>{{0, 1, rest - 20, rest, rest + 20}},
                                                Strengths{0.1, 0.8});
        });
    }

    void pointAtItsRestTargetStaysThere()
    {
        QFETCH(EffectOf, make);
        Dice dice(7);
        for (int i = 0; i < 50; ++i) {
            const EffectPtr effect = make(dice);
            const State state = scattered(dice);
            std::vector<RestTarget> targets;
            effect->addRestTargets(state, targets);
            QVERIFY(!targets.empty());
            for (const RestTarget &rest : targets) {
                State atRest = state;
                atRest.place(rest.mover, rest.position);
                QVERIFY2(changeOf(*effect, state, rest.mover) > 1e-6, "it would be at rest anywhere");
                const double change = changeOf(*effect, atRest, rest.mover);
                QVERIFY2(change < 1e-9, qPrintable(QString::number(change)));
            }
        }
    }

private:
    /// Returns the acceleration that a force gives `point`, px/frame^2, or how far a constraint moves it, px.
    static double changeOf(const Effect &effect, State state, int point)
    {
        if (const auto *force = dynamic_cast<const Force *>(&effect)) {
            Eigen::ArrayX2d accelerations = Eigen::ArrayX2d::Zero(scatteredPoints, 2);
            force->add(state, {0, scatteredPoints}, 1.0, DirectionRule::regularised, accelerations);
            return length(Vec2{accelerations(point, 0), accelerations(point, 1)});
        }
        const Vec2 before = state.positionOf(point);
        dynamic_cast<const Constraint &>(effect).enforce(state, {0, scatteredPoints},
                                                         DirectionRule::regularised, 1.0);
        return length(state.positionOf(point) - before);
    }
};

SUITE(tst_rest_targets, TestRestTargets)
#include "tst_rest_targets.moc"
