// The energy drift of the ledger is the method's error: it shrinks with the method's order.

#include "tests/sim/support/energy_support.h"
#include "tests/sim/support/implicit_scenes.h"
#include "tests/sim/support/support.h"

#include "sim/analysis/energy/power_integrals.h"
#include "sim/methods/methods.h"
#include "tests/suite.h"

#include <QTest>

#include <complex>

using namespace sim;
using namespace energy_support;
using implicit_scenes::oscillator;
using implicit_scenes::SmoothScene;
using implicit_scenes::smoothScenes;

class TestEnergyDrift : public QObject
{
    Q_OBJECT

private slots:
    void driftShrinksWithTheOrderOfTheMethod_data()
    {
        QTest::addColumn<QString>("method");
        QTest::addColumn<int>("number");
        for (const MethodPtr &method : support::fixedMethods()) {
            for (std::size_t i = 0; i < smoothScenes().size(); ++i)
                QTest::addRow("%s, %s", method->id().c_str(), smoothScenes()[i].name.c_str())
                    << QString::fromStdString(method->id()) << int(i);
        }
    }
    void driftShrinksWithTheOrderOfTheMethod()
    {
        QFETCH(QString, method);
        QFETCH(int, number);
        const SmoothScene &smooth = smoothScenes()[std::size_t(number)];
        const MethodPtr rule = findMethod(method.toStdString());
        constexpr int frames = 10;
        std::vector<double> drifts;
        for (const double h : {0.5, 0.25, 0.125}) {
            const LedgerTotals totals = totalsOf(scriptOf(smooth.scene, rule->id(), h), frames);
            drifts.push_back(totals.absoluteDrift);
            if (totals.absoluteDrift < 1e-6)
                return; // the method has no drift in this scene
            QVERIFY2(totals.balance.errorEstimate < 0.1 * totals.absoluteDrift,
                     qPrintable(QString("h %1: drift %2, doubt %3")
                                    .arg(h)
                                    .arg(totals.absoluteDrift)
                                    .arg(totals.balance.errorEstimate)));
        }
        for (std::size_t i = 1; i < drifts.size(); ++i) {
            const double order = std::log2(drifts[i - 1] / drifts[i]);
            QVERIFY2(order > rule->order() - 0.35,
                     qPrintable(QString("%1 -> %2: order %3").arg(drifts[i - 1]).arg(drifts[i]).arg(order)));
        }
    }

    void dampingAccountMatchesTheExactLoss_data() { addMethodRows(anyMethod); }
    void dampingAccountMatchesTheExactLoss()
    {
        QFETCH(QString, method);
        const MethodPtr rule = findMethod(method.toStdString());
        const SmoothScene &swing = smoothScenes()[0];
        constexpr int frames = 10;
        constexpr double k = 0.2;
        const implicit_scenes::Coordinates end = swing.exact(frames), start = swing.exact(0);
        const auto energy = [&](const implicit_scenes::Coordinates &e) {
            return 0.5 * (e.v.square().sum() + k * e.x.square().sum());
        };
        const double loss = energy(end) - energy(start);
        std::vector<double> errors;
        for (const double h : {0.25, 0.125, 0.0625}) {
            const Balance balance = balanceOf(scriptOf(swing.scene, rule->id(), h), frames);
            errors.push_back(std::abs(balance.energy[Account::damping] - loss));
        }
        if (rule->stepping() == Stepping::adaptive) {
            QVERIFY2(errors[0] < 1e-5 * -loss, qPrintable(QString::number(errors[0])));
            return;
        }
        const double order = std::log2(errors[1] / errors[2]);
        QVERIFY2(order > rule->order() - 0.35 && errors[2] < 0.1 * -loss,
                 qPrintable(QString("%1 %2 %3").arg(errors[0]).arg(errors[1]).arg(errors[2])));
    }

    /// Between exact states the error of the power integral is of order h^6, and the doubt bounds it.
    void powerIntegralsHaveOrderSix()
    {
        constexpr double k = 0.2, damp = 0.8;
        const Scene scene = oscillator(k, damp);
        const StoredEnergyReader reader(scene);
        const PowerIntegrals integrals(scene, reader, DirectionRule::regularised);
        const auto exactAt = [&](double t) { // of x'' = -k x - c x', by its complex root
            using Complex = std::complex<double>;
            const double c = -std::log(damp);
            const Complex root = -c / 2 + std::sqrt(Complex(c * c / 4 - k, 0.0));
            State state = scene.start;
            for (int i = 0; i < 2; ++i) {
                const double x = scene.start.position(0, i), v = scene.start.velocity(0, i);
                const Complex a = (v - std::conj(root) * x) / (root - std::conj(root));
                state.position(0, i) = 2.0 * (a * std::exp(root * t)).real();
                state.velocity(0, i) = 2.0 * (a * root * std::exp(root * t)).real();
            }
            return state;
        };
        constexpr double span = 8.0;
        const double loss = reader.read(exactAt(span)).total() - reader.read(exactAt(0.0)).total();
        std::vector<double> errors;
        for (const double h : {2.0, 1.0, 0.5}) {
            Balance balance;
            for (int i = 0; i < span / h; ++i)
                integrals.step(exactAt(i * h), exactAt((i + 1) * h), h, balance);
            errors.push_back(std::abs(balance.energy[Account::damping] - loss));
            QVERIFY2(errors.back() < balance.errorEstimate,
                     qPrintable(QString("%1, doubt %2").arg(errors.back()).arg(balance.errorEstimate)));
            QVERIFY(balance.errorEstimate < 50.0 * errors.back());
        }
        for (std::size_t i = 1; i < errors.size(); ++i) {
            const double order = std::log2(errors[i - 1] / errors[i]);
            QVERIFY2(order > 5.6, qPrintable(QString::number(order)));
        }
    }

    /// The spring turns by 7 rad per step, so the states at both ends of a step do not show its motion.
    void doubtIsLargeForStepsThatMissOscillations()
    {
        const Balance fine = balanceOf(scriptOf(oscillator(0.1, 0.9), "implicit_midpoint", 1.0), 20);
        QVERIFY(fine.errorEstimate < 1e-2 * std::abs(fine.energy[Account::damping]));
        const Balance coarse = balanceOf(scriptOf(oscillator(50.0, 0.9), "implicit_midpoint", 1.0), 20);
        QVERIFY2(
            coarse.errorEstimate > 0.5 * std::abs(coarse.energy[Account::damping]),
            qPrintable(QString("%1 of %2").arg(coarse.errorEstimate).arg(coarse.energy[Account::damping])));
    }

    void gaitClockDoesWork()
    {
        const SmoothScene *walker = nullptr;
        for (const SmoothScene &smooth : smoothScenes())
            walker = smooth.name == "undamped legs that swing" ? &smooth : walker;
        QVERIFY(walker);
        const LedgerTotals totals = totalsOf(scriptOf(walker->scene, "dop853", 1e-6), 20);
        QVERIFY(std::abs(totals.balance.energy[Account::motors]) > 1.0);
        const double gained = totals.balance.after.total() - totals.balance.before.total();
        QVERIFY2(std::abs(totals.balance.energy[Account::motors] - gained) < 1e-6 * std::abs(gained),
                 qPrintable(QString("%1 of %2").arg(totals.balance.energy[Account::motors]).arg(gained)));
    }

    void driftOfAnAdaptiveMethodShrinksWithTheTolerance_data()
    {
        QTest::addColumn<QString>("method");
        QTest::addColumn<int>("number");
        for (const QString method : {"dormand_prince", "dop853"}) {
            for (std::size_t i = 0; i < smoothScenes().size(); ++i)
                QTest::addRow("%s, %s", qPrintable(method), smoothScenes()[i].name.c_str())
                    << method << int(i);
        }
    }
    void driftOfAnAdaptiveMethodShrinksWithTheTolerance()
    {
        QFETCH(QString, method);
        QFETCH(int, number);
        const SmoothScene &smooth = smoothScenes()[std::size_t(number)];
        const LedgerTotals coarse = totalsOf(scriptOf(smooth.scene, method.toStdString(), 10.0), 20);
        const LedgerTotals fine = totalsOf(scriptOf(smooth.scene, method.toStdString(), 1e-6), 20);
        const double scale = coarse.balance.before.moving + coarse.balance.before.springs;
        QVERIFY2(fine.absoluteDrift < 1e-7 * scale,
                 qPrintable(QString("%1 of %2").arg(fine.absoluteDrift).arg(scale)));
        QVERIFY2(fine.absoluteDrift < 0.05 * coarse.absoluteDrift,
                 qPrintable(QString("%1, %2").arg(coarse.absoluteDrift).arg(fine.absoluteDrift)));
    }
};

SUITE(tst_energy_drift, TestEnergyDrift)
#include "tst_energy_drift.moc"
