// Every operation is rounded separately, on every machine and in every build.

#include "tests/sim/support/rounding.h"
#include "tests/sim/support/support.h"

#include "sim/pipeline/phase_builder.h"
#include "tests/hash.h"
#include "tests/suite.h"

#include <QTest>

#include <cstring>

using namespace sim;

namespace {

/// Returns `value`, hidden from the compiler's constant folding.
double opaque(double value)
{
    volatile double hidden = value;
    return hidden;
}

/// Returns the FNV-1a hash of positions, velocities, accelerations, masses and the drag.
std::uint64_t hashOf(const State &state)
{
    std::uint64_t hash = tests::emptyHash;
    const auto add = [&](const void *data, std::size_t bytes) {
        hash = tests::updatedHash(hash, data, bytes);
    };
    const auto addArray = [&](const auto &values) {
        const auto rows = static_cast<std::int64_t>(values.rows());
        add(&rows, sizeof rows);
        add(values.data(), static_cast<std::size_t>(values.size()) * sizeof(double));
    };
    addArray(state.position);
    addArray(state.velocity);
    addArray(state.acceleration);
    addArray(state.inverseMass);
    add(&state.hold.point, sizeof state.hold.point);
    add(&state.hold.hand, sizeof state.hold.hand);
    return hash;
}

}

class TestRounding : public QObject
{
    Q_OBJECT

private slots:
    void productsAreRoundedBeforeTheyAreSubtracted()
    {
        if (!canRunFused())
            QSKIP("this processor has no fused multiply-add");
        const double a = opaque(1.0 + 0x1.0p-30);
        const double rounded = opaque(a * a);
        QCOMPARE(productMinus(a, a, rounded), 0.0);
        QVERIFY(std::fma(a, a, -rounded) != 0.0); // the result with contraction
    }

    void phasesRoundTheirProducts()
    {
        const double a = opaque(1.0 + 0x1.0p-30);
        const double rounded = opaque(a * a);
        QCOMPARE(move({-rounded, 0}, {a, 0}, a).x, 0.0);
        QCOMPARE(kick({-rounded, 0}, {a, 0}, a).x, 0.0);
    }

    void aRunHasTheSameBitsInEveryBuild_data()
    {
        QTest::addColumn<double>("h");
        QTest::addColumn<quint64>("hash");
        QTest::newRow("one step per frame") << 1.0 << quint64(0xde5b2b8c64a2fe66);
        QTest::newRow("two steps per frame") << 0.5 << quint64(0xc7833748a05341dc);
    }
    void aRunHasTheSameBitsInEveryBuild()
    {
        QFETCH(double, h);
        QFETCH(quint64, hash);
        support::Sample sample = support::sample("creature in a room");
        // The powers of 0.25 are exact in every mathematics library, at both steps.
        sample.values.set("damp", 0.25);
        const Scene scene = sample.build(sample.values);
        QCOMPARE(QString::number(hashOf(support::plainRun(scene, "semi_implicit_euler", h, 200)), 16),
                 QString::number(hash, 16));
    }
};

SUITE(tst_rounding, TestRounding)
#include "tst_rounding.moc"
