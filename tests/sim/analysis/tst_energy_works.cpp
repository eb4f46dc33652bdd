// Work and momentum of drags, wind and forces without a potential.

#include "tests/sim/support/energy_scenes.h"
#include "tests/sim/support/energy_support.h"
#include "tests/sim/support/support.h"

#include "sim/analysis/energy/ledger.h"
#include "sim/effects/drags/damping.h"
#include "sim/effects/fields/breeze.h"
#include "sim/effects/springs/body_spring.h"
#include "sim/effects/springs/leg_spring.h"
#include "sim/effects/springs/push.h"
#include "sim/methods/methods.h"
#include "tests/suite.h"

#include <QTest>

using namespace sim;
using namespace energy_scenes;
using namespace energy_support;
using std::make_shared;

class TestEnergyWorks : public QObject
{
    Q_OBJECT

private:
    static bool movesAllPointsAtOnce(const Method &method) { return method.id() != "published"; }

private slots:
    /// The hand jumps by u px once per frame. In between, the other end oscillates about it.
    void workOfADragMatchesTheClosedForm_data() { addMethodRows(movesAllPointsAtOnce); }
    void workOfADragMatchesTheClosedForm()
    {
        QFETCH(QString, method);
        constexpr double k = 0.05, u = 2.0;
        constexpr int frames = 20;
        const Scene scene = scenes::linearCreature(1, k);
        const MethodPtr rule = findMethod(method.toStdString());
        const bool isAdaptive = rule->stepping() == Stepping::adaptive;
        Script script = scriptOf(scene, rule->id(), isAdaptive ? 1e-6 : 1.0 / 64);
        script.input.push_back({1, Grab{"body"}});
        for (int i = 1; i <= frames; ++i)
            script.input.push_back({i, Move{{270.0 + u * i, 200.0}}});
        const Balance balance = balanceOf(script, frames);
        const double omega = std::sqrt(k);
        double stretch = 0.0, velocity = 0.0, work = 0.5 * u * u; // the kinetic energy of the dragged body
        for (int i = 0; i < frames; ++i) {
            work += 0.5 * k * ((stretch - u) * (stretch - u) - stretch * stretch);
            stretch -= u;
            const double s = std::sin(omega), c = std::cos(omega), stretchBefore = stretch;
            stretch = c * stretchBefore + s / omega * velocity;
            velocity = -s * omega * stretchBefore + c * velocity;
        }
        const double tolerance = rule->order() == 1 ? 0.05 : 2e-4;
        QVERIFY2(std::abs(balance.energy[Account::hand] - work) < tolerance * work,
                 qPrintable(QString("%1, %2").arg(balance.energy[Account::hand]).arg(work)));
        // The hand is the only source of momentum.
        const double pushed = velocity + u;
        QVERIFY(std::abs(balance.momentum[Account::hand].x - pushed) < 10 * tolerance * pushed);
        QVERIFY(length(balance.momentum[Account::drift]) < 10 * tolerance * pushed);
    }

    void pairConservesMomentum_data() { addMethodRows(movesAllPointsAtOnce); }
    void pairConservesMomentum()
    {
        QFETCH(QString, method);
        const Balance balance = balanceOf(scriptOf(springPair(0.3), method.toStdString(), 1.0), 30);
        for (const AccountName &name : accountNames())
            QVERIFY2(length(balance.momentum[name.account]) < 1e-10, name.id.c_str());
    }

    /// A foot on a leg of a held body. The hand gives all the momentum that the foot gets.
    void handBalancesTheForceOnAHeldBody_data()
    {
        addMethodRows([](const Method &m) { return m.id() == "published" || m.id() == "velocity_verlet"; });
    }
    void handBalancesTheForceOnAHeldBody()
    {
        QFETCH(QString, method);
        Scene scene = scenes::creature(1);
        scene.start.place(0, {200.0, 260.0});
        const LegRule rule{0.1, 40.0, 0.0, Aim::bone, Reaction::equal};
        scene.effects = {make_shared<LegSpring>(std::vector<sim::Leg>{{0, 1, 0.0, 0}}, rule)};
        Script script = scriptOf(scene, method.toStdString(), 0.5);
        script.input = {{1, Grab{"body"}}};
        const Balance balance = balanceOf(script, 5);
        QVERIFY(length(balance.after.momentum) > 1.0);
        QVERIFY(length(balance.momentum[Account::hand] - balance.after.momentum) < 1e-9);
        QVERIFY(length(balance.momentum[Account::drift]) < 1e-9);
    }

    void publishedMethodViolatesMomentum()
    {
        const Script script = scriptOf(springPair(0.3), "published", 1.0);
        const Balance balance = balanceOf(script, 30);
        Track track(script, 0);
        track.seek({30, 0});
        const Vec2 gained = track.state().velocityOf(0) + track.state().velocityOf(1) - Vec2{1.0, -2.0};
        QVERIFY(length(gained) > 1.0);
        QVERIFY(length(balance.momentum[Account::drift] - gained) < 1e-10);
    }

    /// Without potential energy, the work of the forces and the damping make up the kinetic energy to
    /// rounding.
    void workOfForcesWithoutPotentialIsTheKineticEnergy_data()
    {
        addMethodRows([](const Method &m) {
            return QByteArray(m.region().file.c_str()).contains("euler.cpp") ||
                   QByteArray(m.region().file.c_str()).contains("verlet.cpp") || m.id() == "published";
        });
    }
    void workOfForcesWithoutPotentialIsTheKineticEnergy()
    {
        QFETCH(QString, method);
        if (method == "backward_euler")
            return; // it solves for the whole step at once
        Scene scene = scenes::creature(3);
        support::scatter(scene.start, 5, 200.0);
        scene.start.inverseMass << 1.0, 0.5, 2.0, 1.0;
        const std::vector<Link> chase = {{0, 1}, {1, 2}, {2, 3}, {3, 0}};
        scene.effects = {make_shared<BodySpring>(chase, 0.1),
                         make_shared<Push>(std::vector<int>{0, 1, 2, 3}, 0.2, 80.0, Reaction::none),
                         make_shared<Damping>(0.9)};
        const Balance balance = balanceOf(scriptOf(scene, method.toStdString(), 0.5), 20);
        QVERIFY(balance.energy[Account::pulls] > 1.0);
        QVERIFY(balance.energy[Account::damping] < -1.0);
        QCOMPARE(balance.after.springs, 0.0);
        QVERIFY2(std::abs(balance.energy[Account::drift]) < 1e-10 * balance.energy[Account::pulls],
                 qPrintable(QString::number(balance.energy[Account::drift])));
        QVERIFY(length(balance.momentum[Account::drift]) < 1e-9);
    }

    /// From rest the velocity is F t / m.
    void workOfWindIsTheKineticEnergy_data() { addMethodRows(anyMethod); }
    void workOfWindIsTheKineticEnergy()
    {
        QFETCH(QString, method);
        constexpr double wind = 0.2, width = 25.0, mass = 3.0, h = 0.25;
        constexpr int frames = 12;
        Scene scene = singlePoint(mass);
        scene.start.gait.setZero(1);
        scene.effects = {
            make_shared<Breeze>(BreezeStrength{wind, 0.0}, Eigen::ArrayXd::Constant(1, width), 0)};
        const Balance balance = balanceOf(scriptOf(scene, method.toStdString(), h), frames);
        const double push = wind * width / 10.0, velocity = push * frames / mass;
        // Backward Euler moves with a velocity that is a h / 2 too large, and the work is counted along that
        // movement.
        const double a = push / mass;
        const double excess = method == "backward_euler" ? 0.5 * mass * a * a * h * h * (frames / h) : 0.0;
        QVERIFY(std::abs(balance.after.moving - 0.5 * mass * velocity * velocity) < 1e-9);
        QCOMPARE(balance.after.springs, 0.0);
        QVERIFY(std::abs(balance.energy[Account::wind] - balance.after.moving - excess) < 1e-9);
        QVERIFY(std::abs(balance.energy[Account::drift] + excess) < 1e-9);
        QVERIFY(std::abs(balance.momentum[Account::wind].x - push * frames) < 1e-9);
        QVERIFY(length(balance.momentum[Account::drift]) < 1e-9);
    }
};

SUITE(tst_energy_works, TestEnergyWorks)
#include "tst_energy_works.moc"
