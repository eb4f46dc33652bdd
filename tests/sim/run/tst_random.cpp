// Random numbers that depend only on their arguments.

#include "sim/base/random.h"
#include "tests/suite.h"

#include <QTest>

#include <cmath>
#include <vector>

using namespace sim;

// The first numbers of SplitMix64 from the seed 1234567, as its authors' reference program prints them.
static_assert(mixBits(1234567u) == 6457827717110365317u);
static_assert(mixBits(1234567u + 0x9E3779B97F4A7C15u) == 3203168211198807973u);
static_assert(mixBits(1234567u + 2 * 0x9E3779B97F4A7C15u) == 9817491932198370423u);
static_assert(mixBits(0) == 0xE220A8397B1DCDAFu);
// Computed by another program. A saved file with a seed must always give the same run.
static_assert(uniform(1, 0, 0) == 0x1.631405e8db1b0p-1);
static_assert(uniform(1, 1, 0) == 0x1.5dd4992a69f86p-2);
static_assert(uniform(1, 0, 1) == 0x1.b15e57852cedep-2);
static_assert(uniform(42, 18000, 99) == 0x1.42d4e53118e0cp-1);

namespace {

constexpr int sampleCount = 200'000;

double correlation(const std::vector<double> &a, const std::vector<double> &b)
{
    double sum = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i)
        sum += (a[i] - 0.5) * (b[i] - 0.5);
    return sum / static_cast<double>(a.size()) * 12.0;
}

}

class TestRandom : public QObject
{
    Q_OBJECT

private slots:
    void numbersFillTheUnitInterval_data()
    {
        QTest::addColumn<int>("argument");
        QTest::newRow("as the seed counts up") << 0;
        QTest::newRow("as the frame counts up") << 1;
        QTest::newRow("as the index counts up") << 2;
    }
    void numbersFillTheUnitInterval()
    {
        QFETCH(int, argument);
        double sum = 0.0, squares = 0.0;
        std::vector<int> bins(100);
        for (int i = 0; i < sampleCount; ++i) {
            const double u = argument == 0   ? uniform(static_cast<std::uint64_t>(i), 3, 4)
                             : argument == 1 ? uniform(5, i, 4)
                                             : uniform(5, 3, i);
            QVERIFY(u >= 0.0 && u < 1.0);
            sum += u;
            squares += (u - 0.5) * (u - 0.5);
            ++bins[static_cast<std::size_t>(u * 100)];
        }
        // Five standard deviations of each: sqrt(1/12 n), sqrt(1/180 n), and sqrt(2 * 99) for chi-square.
        QVERIFY(std::abs(sum / sampleCount - 0.5) < 5 * std::sqrt(1.0 / 12 / sampleCount));
        QVERIFY(std::abs(squares / sampleCount - 1.0 / 12) < 5 * std::sqrt(1.0 / 180 / sampleCount));
        double chiSquare = 0.0;
        for (const int count : bins)
            chiSquare +=
                (count - sampleCount / 100.0) * (count - sampleCount / 100.0) / (sampleCount / 100.0);
        QVERIFY(std::abs(chiSquare - 99.0) < 5 * std::sqrt(2.0 * 99));
    }

    void neighboursAreUncorrelated()
    {
        std::vector<double> reference, nextSeed, nextFrame, nextIndex, swapped;
        for (int i = 0; i < sampleCount; ++i) {
            reference.push_back(uniform(1, i, 7));
            nextSeed.push_back(uniform(2, i, 7));
            nextFrame.push_back(uniform(1, i + 1, 7));
            nextIndex.push_back(uniform(1, i, 8));
            swapped.push_back(uniform(1, 7, i));
        }
        const double limit = 5 / std::sqrt(double(sampleCount));
        for (const auto *other : {&nextSeed, &nextFrame, &nextIndex, &swapped})
            QVERIFY(std::abs(correlation(reference, *other)) < limit);
    }

    void extremeArgumentsStayInTheUnitInterval()
    {
        for (const std::uint64_t seed : {std::uint64_t{0}, ~std::uint64_t{0}, std::uint64_t{1} << 63}) {
            for (const std::int64_t frame : {std::int64_t{0}, std::int64_t{-1}}) {
                const auto index = static_cast<std::int64_t>(seed);
                QVERIFY(uniform(seed, frame, index) >= 0.0 && uniform(seed, frame, index) < 1.0);
            }
        }
    }
};

SUITE(tst_random, TestRandom)
#include "tst_random.moc"
