#include "sim/simd/portable_math.h"
#include "tests/suite.h"

#include <QTest>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>

using namespace sim;

/// The functions of portable_math.h against the C library in long double, which has eleven more binary
/// digits.
class TestPortableMath : public QObject
{
    Q_OBJECT

    std::mt19937 m_random{1};

    double between(double low, double high)
    {
        return std::uniform_real_distribution<double>(low, high)(m_random);
    }

    /// Returns the error of `found` in units of the last bit of `exact`.
    static double errorInUlp(double found, long double exact)
    {
        const double size = std::abs(static_cast<double>(exact));
        const double unit = std::nextafter(size, std::numeric_limits<double>::infinity()) - size;
        return static_cast<double>(std::abs(static_cast<long double>(found) - exact) / unit);
    }

private slots:
    void initTestCase()
    {
        if (std::numeric_limits<long double>::digits < 64)
            QSKIP("long double has no more digits than double here");
    }

    void sineAndCosineAreAccurateToTheLastBit_data()
    {
        QTest::addColumn<double>("limit");
        for (const double limit : {0.8, 3.2, 100.0, 1e4, 9e5})
            QTest::addRow("to %g rad", limit) << limit;
    }
    void sineAndCosineAreAccurateToTheLastBit()
    {
        QFETCH(double, limit);
        for (int i = 0; i < 20'000; ++i) {
            const double rad = between(-limit, limit);
            QVERIFY2(errorInUlp(portable::sin(rad), std::sin(static_cast<long double>(rad))) < 0.61,
                     qPrintable(QString::number(rad, 'g', 17)));
            QVERIFY2(errorInUlp(portable::cos(rad), std::cos(static_cast<long double>(rad))) < 0.61,
                     qPrintable(QString::number(rad, 'g', 17)));
        }
    }

    /// Near quarter turns nearly all digits of the angle cancel.
    void sineAndCosineAreAccurateNearQuarterTurns()
    {
        for (int quarter = -400; quarter <= 400; ++quarter) {
            double rad = quarter * 1.5707963267948966;
            for (int i = 0; i < 4; ++i, rad = std::nextafter(rad, 1e9)) {
                const long double sine = std::sin(static_cast<long double>(rad));
                const long double cosine = std::cos(static_cast<long double>(rad));
                QVERIFY(portable::sin(rad) == 0.0 ? sine == 0.0L
                                                  : errorInUlp(portable::sin(rad), sine) < 0.61);
                QVERIFY(errorInUlp(portable::cos(rad), cosine) < 0.61);
            }
        }
    }

    void invalidAndHugeAnglesAreHandled()
    {
        QVERIFY(std::isnan(portable::sin(std::numeric_limits<double>::quiet_NaN())));
        QVERIFY(std::isnan(portable::cos(std::numeric_limits<double>::quiet_NaN())));
        for (const double large : {1e7, 1e100, std::numeric_limits<double>::max()})
            QVERIFY(std::abs(portable::sin(large)) <= 1.0 && std::abs(portable::cos(-large)) <= 1.0);
    }

    void arcTangentIsAccurateToTheLastBit_data()
    {
        QTest::addColumn<double>("range"); // of the exponents of e
        for (const double range : {0.0, 1.0, 20.0, 200.0})
            QTest::addRow("sizes up to e^%g", range) << range;
    }
    void arcTangentIsAccurateToTheLastBit()
    {
        QFETCH(double, range);
        for (int i = 0; i < 40'000; ++i) {
            const double x = between(-1, 1) * std::exp(between(-range, range));
            const double y = between(-1, 1) * std::exp(between(-range, range));
            const long double exact = std::atan2(static_cast<long double>(y), static_cast<long double>(x));
            QVERIFY2(errorInUlp(portable::atan2(y, x), exact) < 0.56,
                     qPrintable(QString("%1, %2").arg(y, 0, 'g', 17).arg(x, 0, 'g', 17)));
        }
    }

    void fastFunctionsStayWithinTheirErrorBounds()
    {
        for (const double limit : {0.8, 3.2, 100.0, 1e4, 9e5}) {
            for (int i = 0; i < 20'000; ++i) {
                const double rad = between(-limit, limit);
                QVERIFY(std::abs(portable::fast::sin(rad) - std::sin(static_cast<long double>(rad))) <
                        1.5e-16L);
                QVERIFY(std::abs(portable::fast::cos(rad) - std::cos(static_cast<long double>(rad))) <
                        1.5e-16L);
            }
        }
        for (const double range : {0.0, 1.0, 20.0, 200.0}) {
            for (int i = 0; i < 40'000; ++i) {
                const double x = between(-1, 1) * std::exp(between(-range, range));
                const double y = between(-1, 1) * std::exp(between(-range, range));
                const long double exact =
                    std::atan2(static_cast<long double>(y), static_cast<long double>(x));
                QVERIFY(std::abs(portable::fast::atan2(y, x) - exact) < 5e-16L);
                QVERIFY(errorInUlp(portable::fast::atan2(y, x), exact) < 3.0); // also for small angles
            }
        }
        QCOMPARE(portable::fast::sin(0.0), 0.0);
        QCOMPARE(portable::fast::atan2(-0.0, -2.0), -std::numbers::pi);
        const double nan = std::numeric_limits<double>::quiet_NaN();
        QVERIFY(std::isnan(portable::fast::sin(nan)) && std::isnan(portable::fast::cos(nan)));
        QVERIFY(std::isnan(portable::fast::atan2(nan, 1.0)) && std::isnan(portable::fast::atan2(1.0, nan)));
        QVERIFY(std::isnan(portable::fast::atan2(0.0, 0.0)));
    }

    void arcTangentEqualsTheLibraryOnTheAxes()
    {
        for (const double x : {-3.0, -0.0, 0.0, 3.0}) {
            for (const double y : {-2.0, -0.0, 0.0, 2.0}) {
                QCOMPARE(portable::atan2(y, x), std::atan2(y, x));
                QCOMPARE(std::signbit(portable::atan2(y, x)), std::signbit(std::atan2(y, x)));
            }
        }
        for (const double nan :
             {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
            QVERIFY(std::isnan(portable::atan2(nan, 1.0)));
            QVERIFY(std::isnan(portable::atan2(1.0, nan)));
        }
    }

    void remainderEqualsTheLibrary()
    {
        for (int i = 0; i < 200'000; ++i) {
            const double x = between(-1, 1) * std::exp(between(-20, 30));
            QCOMPARE(portable::remainder(x, 360.0), std::remainder(x, 360.0));
        }
        for (int half = -3001; half <= 3001; ++half) { // at its jumps and beside them
            const double x = 180.0 * half;
            for (const double at : {std::nextafter(x, -1e9), x, std::nextafter(x, 1e9)})
                QCOMPARE(portable::remainder(at, 360.0), std::remainder(at, 360.0));
        }
    }
};

SUITE(tst_portable_math, TestPortableMath)
#include "tst_portable_math.moc"
