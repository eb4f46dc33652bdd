// The ledger of energy and momentum: each account against a closed form.

#include "sim/run/script/composed_interval.h"
#include "tests/sim/support/energy_scenes.h"
#include "tests/sim/support/energy_support.h"
#include "tests/sim/support/implicit_scenes.h"
#include "tests/sim/support/support.h"

#include "sim/analysis/energy/ledger.h"
#include "sim/effects/constraints/sticks.h"
#include "sim/effects/contacts/walls.h"
#include "sim/effects/fields/gravity.h"
#include "sim/methods/methods.h"
#include "tests/suite.h"

#include <QTest>

using namespace sim;
using namespace energy_scenes;
using namespace energy_support;
using implicit_scenes::oscillator;
using std::make_shared;

class TestEnergyLedger : public QObject
{
    Q_OBJECT

private slots:
    /// v = n g h after n steps. In each step Euler methods move with a velocity that is g h / 2 too large or
    /// too small, which changes the energy by m g^2 h^2 / 2. The other methods fall exactly.
    void fallingBodyTurnsPotentialIntoKineticEnergy_data() { addMethodRows(anyMethod); }
    void fallingBodyTurnsPotentialIntoKineticEnergy()
    {
        QFETCH(QString, method);
        constexpr double g = 0.5, mass = 3.0, h = 0.25;
        constexpr int frames = 12;
        Scene scene = singlePoint(mass);
        scene.effects = {make_shared<Gravity>(g)};
        const Balance balance = balanceOf(scriptOf(scene, method.toStdString(), h), frames);
        const QStringList endVelocityMethods = {"published", "semi_implicit_euler", "backward_euler"};
        double drift = 0.0;
        if (endVelocityMethods.contains(method))
            drift = -0.5 * mass * g * g * h * h * (frames / h);
        else if (method == "explicit_euler")
            drift = 0.5 * mass * g * g * h * h * (frames / h);
        const double speed = g * frames;
        QVERIFY(std::abs(balance.after.moving - 0.5 * mass * speed * speed) < 1e-9);
        QVERIFY2(std::abs(balance.energy[Account::drift] - drift) < 1e-9,
                 qPrintable(QString::number(balance.energy[Account::drift])));
        QVERIFY(std::abs(balance.momentum[Account::gravity].y - mass * speed) < 1e-9);
        QVERIFY(length(balance.momentum[Account::drift]) < 1e-9);
        QVERIFY(balance.errorEstimate < 1e-9);
    }

    void explicitEulerGainsEnergyByTheFactorOnePlusKhSquaredPerStep_data()
    {
        QTest::addColumn<double>("h");
        QTest::newRow("one frame") << 1.0;
        QTest::newRow("a quarter frame") << 0.25;
    }
    void explicitEulerGainsEnergyByTheFactorOnePlusKhSquaredPerStep()
    {
        QFETCH(double, h);
        constexpr double k = 0.2;
        constexpr int frames = 10;
        const Balance balance = balanceOf(scriptOf(oscillator(k, 1.0), "explicit_euler", h), frames);
        const double start = 0.5 * (3.0 * 3.0 + 8.0 * 8.0) + 0.5 * k * (100.0 * 100.0 + 40.0 * 40.0);
        const double gained = start * (std::pow(1.0 + k * h * h, frames / h) - 1.0);
        QVERIFY(std::abs(balance.before.total() - start) < 1e-9 * start);
        QVERIFY(std::abs(balance.energy[Account::drift] - gained) < 1e-9 * gained);
        QCOMPARE(balance.energy[Account::damping], 0.0);
    }

    /// A fall from height H onto a floor with restitution b loses (1 - b^2) m g H.
    void bounceLosesEnergyToTheFloor_data()
    {
        QTest::addColumn<QString>("method");
        QTest::addColumn<double>("bounce");
        for (const QString method : {"dormand_prince", "dop853"}) {
            for (const double bounce : {1.0, 0.5, 0.0})
                QTest::addRow("%s, %g", qPrintable(method), bounce) << method << bounce;
        }
    }
    void bounceLosesEnergyToTheFloor()
    {
        QFETCH(QString, method);
        QFETCH(double, bounce);
        constexpr double g = 0.5, mass = 2.0, half = 15.0, floor = 165.0; // 100 px to fall: 20 frames
        Scene scene = singlePoint(mass);
        scene.effects = {make_shared<Gravity>(g), make_shared<Walls>(Room{-1e3, 1e3, floor, bounce},
                                                                     Eigen::ArrayXd::Constant(1, half))};
        const Balance before = balanceOf(scriptOf(scene, method.toStdString(), 0.01), 19);
        QVERIFY(std::abs(before.energy[Account::impact]) < 1e-9);
        const Balance balance = balanceOf(scriptOf(scene, method.toStdString(), 0.01), 25);
        const double loss = -(1.0 - bounce * bounce) * mass * g * 100.0;
        QVERIFY2(std::abs(balance.energy[Account::impact] - loss) < 1e-7,
                 qPrintable(QString::number(balance.energy[Account::impact], 'g', 12)));
        QVERIFY2(std::abs(balance.energy[Account::drift]) < 1e-7,
                 qPrintable(QString::number(balance.energy[Account::drift])));
        const double reversed = -mass * (1.0 + bounce) * 10.0; // it hits the floor at 10 px/frame
        const double pressed = bounce == 0.0 ? -mass * g * 5.0 : 0.0;
        if (bounce > 0.0)
            QVERIFY(std::abs(balance.momentum[Account::impact].y - reversed - pressed) < 1e-6);
    }

    /// A contact phase changes the kinetic energy, and lifts the body out of the floor.
    void contactPhaseIsAccountedExactly_data()
    {
        addMethodRows([](const Method &m) { return m.stepping() == Stepping::fixed; });
    }
    void contactPhaseIsAccountedExactly()
    {
        QFETCH(QString, method);
        constexpr double g = 0.5, bounce = 0.5;
        Scene scene = singlePoint(1.0);
        scene.start.place(0, {100.0, 364.0});
        scene.start.setVelocity(0, {2.0, 8.0});
        scene.effects = {make_shared<Gravity>(g), make_shared<Walls>(Room{0.0, 540.0, 380.0, bounce},
                                                                     Eigen::ArrayXd::Constant(1, 15.0))};
        const Script script = scriptOf(scene, method.toStdString(), 1.0);
        const Balance balance = balanceOf(script, 1);
        Scene sceneWithoutFloor = scene; // before the floor phase
        sceneWithoutFloor.effects.pop_back();
        Track free(scriptOf(sceneWithoutFloor, method.toStdString(), 1.0), 0);
        free.seek({1, 0});
        const Vec2 x = free.state().positionOf(0), v = free.state().velocityOf(0);
        QVERIFY(x.y > 365.0);
        const double impact = 0.5 * (bounce * bounce - 1.0) * v.y * v.y + g * (x.y - 365.0);
        QVERIFY(std::abs(balance.energy[Account::impact] - impact) < 1e-10);
        QVERIFY(std::abs(balance.momentum[Account::impact].y + (1.0 + bounce) * v.y) < 1e-10);
    }

    void accountsAddUpToTheEnergyOfTheRun_data()
    {
        QTest::addColumn<QString>("scene");
        QTest::addColumn<QString>("method");
        for (const support::Sample &sample : support::samples()) {
            const Scene scene = sample.build(sample.values);
            for (const MethodPtr &method : allMethods()) {
                if (!StoredEnergyReader::whyNot(scene) && support::fits(scene, *method))
                    QTest::addRow("%s, %s", sample.name.c_str(), method->id().c_str())
                        << QString::fromStdString(sample.name) << QString::fromStdString(method->id());
            }
        }
    }
    void accountsAddUpToTheEnergyOfTheRun()
    {
        QFETCH(QString, scene);
        QFETCH(QString, method);
        const support::Sample &sample = support::sample(scene.toStdString());
        Script script = support::script(sample, method.toStdString());
        script.step = support::stepFor(*script.method, 0.5);
        const std::string name = sample.build(sample.values).names.front();
        script.input = {{3, Grab{name}}, {4, Move{{250.0, 190.0}}}, {6, Release{}}};
        Track track(script, Timeline::defaultBudget);
        track.seek({10, 0});
        if (track.stop())
            return;
        Ledger ledger;
        const StoredEnergyReader reader(track.interval().scene);
        for (std::int64_t frame = 1; frame <= 10; ++frame) {
            const Balance step = ledger.balanceAt(track, frame).value();
            const StoredEnergy is = reader.read(track.stateAt(frame)),
                               was = reader.read(track.stateAt(frame - 1));
            const double scale = 1.0 + std::abs(is.moving) + std::abs(is.springs) + std::abs(is.gravity);
            QVERIFY(std::abs(step.before.total() - was.total()) <= 1e-12 * scale);
            QVERIFY(std::abs(step.after.total() - is.total()) <= 1e-9 * scale);
            QVERIFY(length(step.after.momentum - is.momentum) <= 1e-9 * scale);
            double sum = step.before.total();
            for (const AccountName &account : accountNames())
                sum += step.energy[account.account];
            QVERIFY(std::abs(sum - step.after.total()) <= 1e-12 * scale);
        }
    }

    void changedStiffnessChangesTheStoredEnergy()
    {
        Script script;
        script.build = [](const Values &values) { return oscillator(values["k"], 1.0); };
        script.values.set("k", 0.1);
        script.method = findMethod("velocity_verlet");
        script.step = StepSize::ofLength(1.0);
        script.input = {{5, Set{"k", 0.3}}};
        Track track(script, Timeline::defaultBudget);
        track.seek({5, 0});
        Ledger ledger;
        const Balance step = ledger.balanceAt(track, 5).value();
        const Vec2 x = track.stateAt(4).positionOf(0);
        const double changed = 0.5 * 0.2 * (x.x * x.x + x.y * x.y);
        QVERIFY(std::abs(step.energy[Account::changes] - changed) < 1e-9);
        QCOMPARE(step.energy[Account::hand], 0.0);
        QCOMPARE(ledger.balanceAt(track, 4)->energy[Account::changes], 0.0);
    }

    void sticksHaveTheirOwnAccount_data()
    {
        addMethodRows(
            [](const Method &m) { return m.stepping() == Stepping::fixed && m.requirements().empty(); });
    }
    void sticksHaveTheirOwnAccount()
    {
        QFETCH(QString, method);
        Scene scene = scenes::creature(1);
        scene.start.place(0, {250.0, 200.0});
        scene.start.setVelocity(0, {1.0, 4.0});
        scene.effects = {make_shared<Sticks>(std::vector<Stick>{{0, 1, 20.0, 0.5}}, 2)};
        const Balance balance = balanceOf(scriptOf(scene, method.toStdString(), 1.0), 20);
        const double gained = balance.after.moving - balance.before.moving;
        QVERIFY(std::abs(gained) > 1e-6);
        QVERIFY(std::abs(balance.energy[Account::sticks] - gained) < 1e-9);
        QVERIFY(std::abs(balance.energy[Account::drift]) < 1e-9);
    }

    void sceneWithoutInertiaHasNoLedger()
    {
        Scene scene = springPair(0.2);
        QVERIFY(!StoredEnergyReader::whyNot(scene));
        scene.groups[0].motion = Motion::prescribed;
        QVERIFY(StoredEnergyReader::whyNot(scene) == NoEnergy::noInertia);
        Scene fixed = singlePoint(1.0);
        fixed.start.inverseMass.setZero();
        QVERIFY(StoredEnergyReader::whyNot(fixed) == NoEnergy::nothingMoves);
        Track track(scriptOf(scene, "semi_implicit_euler", 1.0), 0);
        track.seek({1, 0});
        QVERIFY(!Ledger().balanceAt(track, 1));
    }

    void forceIsTheNegativeGradientOfPotentialEnergy_data()
    {
        QTest::addColumn<QString>("scene");
        for (const support::Sample &sample : support::samples())
            QTest::newRow(sample.name.c_str()) << QString::fromStdString(sample.name);
    }
    void forceIsTheNegativeGradientOfPotentialEnergy()
    {
        QFETCH(QString, scene);
        const support::Sample &sample = support::sample(scene.toStdString());
        const Scene gained = sample.build(sample.values);
        State state = gained.start;
        support::scatter(state, 11, 150.0);
        for (const EffectPtr &effect : gained.effects) {
            const auto *force = dynamic_cast<const Force *>(effect.get());
            if (!force || !force->potentialEnergy(state))
                continue;
            Eigen::ArrayX2d pull = Eigen::ArrayX2d::Zero(state.pointCount(), 2);
            force->add(state, {0, state.pointCount()}, 1.0, DirectionRule::regularised, pull);
            for (int i = 0; i < state.pointCount(); ++i) {
                for (int axis = 0; axis < 2 && state.isDynamic(i); ++axis) {
                    State to = state, fro = state;
                    to.position(i, axis) += 1e-4;
                    fro.position(i, axis) -= 1e-4;
                    const double gradient =
                        (*force->potentialEnergy(to) - *force->potentialEnergy(fro)) / 2e-4;
                    const double forceOnPoint = pull(i, axis) / state.inverseMass[i];
                    QVERIFY2(
                        std::abs(gradient + forceOnPoint) < 1e-5 * (1.0 + std::abs(forceOnPoint)),
                        qPrintable(
                            QString("%1: %2, %3").arg(effect->id().c_str()).arg(gradient).arg(forceOnPoint)));
                }
            }
        }
    }
};

SUITE(tst_energy_ledger, TestEnergyLedger)
#include "tst_energy_ledger.moc"
