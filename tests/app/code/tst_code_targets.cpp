// Input in the code: the moment that a click on a line runs to, and the value of a dragged or typed number.

#include "app/model/code/code_targets.h"
#include "app/model/text/user_error.h"
#include "tests/app/code/listing_support.h"
#include "tests/suite.h"

#include <cmath>

using namespace listing_support;

class TestCodeTargets : public QObject
{
    Q_OBJECT

private slots:
    void runningToALineEndsAfterItsPhase()
    {
        const lessons::Step &step = stepOf("multi_foot", "any_number");
        sim::Timeline run = runOf(step); // feet: springs, damping, move; then the body
        const CodeListing listing = listingOf(step, run);
        const CodeSection &springs = listing.sections[2], &move = listing.sections[4];
        QVERIFY(!runTarget(listing.sections[0], run));
        QVERIFY(!runTarget(listing.sections[1], run));
        const auto at = [&](std::int64_t frame, int phase, const CodeSection &section) {
            run.seek({frame, phase});
            return *runTarget(section, run);
        };
        QCOMPARE(at(5, 0, springs), (sim::Cursor{5, 1}));
        QCOMPARE(at(5, 1, springs), (sim::Cursor{5, 4}));
        QCOMPARE(at(5, 4, springs), (sim::Cursor{6, 1}));
        QCOMPARE(at(5, 2, move), (sim::Cursor{5, 3}));
        QCOMPARE(at(5, 3, move), (sim::Cursor{6, 0}));
        QCOMPARE(at(5, 5, move), (sim::Cursor{6, 0}));
    }

    void lineShowsTheMomentAfterItsPhase()
    {
        const lessons::Step &step = stepOf("multi_foot", "any_number");
        sim::Timeline run = runOf(step);
        const CodeListing listing = listingOf(step, run);
        const CodeSection &springs = listing.sections[2], &move = listing.sections[4];
        QVERIFY(!momentOf(listing.sections[0], run));
        QVERIFY(!momentOf(listing.sections[1], run));
        const auto at = [&](int phase, const CodeSection &section) {
            run.seek({5, phase});
            return *momentOf(section, run);
        };
        QCOMPARE(at(0, springs), (sim::Cursor{5, 1}));
        QCOMPARE(at(0, move), (sim::Cursor{5, 3}));
        QCOMPARE(at(2, springs), (sim::Cursor{5, 1})); // those of the feet, which are done
        QCOMPARE(at(4, springs), (sim::Cursor{5, 4})); // those of the body
        QCOMPARE(at(4, move), (sim::Cursor{5, 3}));
    }

    void aDragGoesAsFarAsTheSlider()
    {
        lessons::Parameter one;
        one.min = -10.0, one.max = 20.0, one.sliderMin = 0.0, one.sliderMax = 10.0, one.decimals = 2;
        QCOMPARE(draggedValue(one, 1.0, 100), 6.0);
        QCOMPARE(draggedValue(one, 1.0, 100 * finePixel), 1.5);
        QCOMPARE(draggedValue(one, 1.0, -100000), -10.0);
        QCOMPARE(draggedValue(one, 1.0, 100000), 20.0);
        QCOMPARE(draggedValue(one, 0.123456, 0), 0.123456);
        one.isInteger = true;
        QCOMPARE(draggedValue(one, 3.0, 29), 4.0);
        one.isInteger = false, one.scale = lessons::Scale::logarithmic, one.sliderMin = 0.1,
        one.sliderMax = 1000.0;
        one.max = 1e6;
        QCOMPARE(draggedValue(one, 1.0, 50), 10.0);
        one.choices = {"a", "b", "c"}, one.min = 0.0, one.max = 2.0, one.scale = lessons::Scale::linear;
        QCOMPARE(draggedValue(one, 0.0, 25), 1.0);
        QCOMPARE(draggedValue(one, 0.0, 500), 2.0);
    }

    void typedValuesAreAcceptedOrRefused_data()
    {
        QTest::addColumn<QString>("parameter");
        QTest::addColumn<QString>("text");
        QTest::addColumn<double>("value"); ///< NaN: refused
        const double refused = std::nan("");
        QTest::newRow("number") << "gravity"
                                << "1.25" << 1.25;
        QTest::newRow("comma") << "gravity"
                               << " 1,25 " << 1.25;
        QTest::newRow("minus sign") << "left"
                                    << "−5" << -5.0;
        QTest::newRow("words") << "gravity"
                               << "much" << refused;
        QTest::newRow("nothing") << "gravity"
                                 << "" << refused;
        QTest::newRow("not finite") << "gravity"
                                    << "1e999" << refused;
        QTest::newRow("nan") << "gravity"
                             << "nan" << refused;
        QTest::newRow("out of range") << "k"
                                      << "-1e9" << refused;
        QTest::newRow("half a foot") << "feet"
                                     << "3.5" << refused;
        QTest::newRow("feet") << "feet"
                              << "7" << 7.0;
    }
    void typedValuesAreAcceptedOrRefused()
    {
        QFETCH(QString, parameter);
        QFETCH(QString, text);
        QFETCH(double, value);
        const lessons::Parameter &one = *stepOf("gravity_walls", "gravity").parameter(parameter);
        try {
            QCOMPARE(typedValue(one, text), value);
        } catch (const UserError &error) {
            QVERIFY2(std::isnan(value), qPrintable(error.sentence()));
            QVERIFY(error.sentence().startsWith(one.name));
        }
    }
};

SUITE(tst_code_targets, TestCodeTargets)
#include "tst_code_targets.moc"
