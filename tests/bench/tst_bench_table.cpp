// Tests the table of the benchmarks with invented results.

#include "tests/bench/table.h"
#include "tests/suite.h"

#include <QTest>

using namespace bench;

namespace {

QByteArray file(const QByteArray &runs)
{
    return R"({"context": {"num_cpus": 2, "load_avg": [1.5, 1, 2], "processor": "A", "compiler": "B"},
               "benchmarks": [)" +
           runs + "]}";
}

QByteArray median(const QByteArray &name, double cpu, const char *unit = "ns")
{
    return R"({"run_name": ")" + name +
           R"(", "run_type": "aggregate", "aggregate_name": "median", "cpu_time": )" +
           QByteArray::number(cpu) + R"(, "real_time": )" + QByteArray::number(3.0 * cpu) +
           R"(, "time_unit": ")" + unit + R"("})";
}

Results resultsOf(const QByteArray &runs)
{
    Results results;
    const std::string wrong = addResults(file(runs), results);
    return wrong.empty() ? results : Results{};
}

QString tableOf(const QByteArray &runs, const Row &row)
{
    return QString::fromStdString(table(resultsOf(runs), {row}, {}));
}

}

class TestBenchTable : public QObject
{
    Q_OBJECT

private slots:
    void timesAreReadInAnyUnit_data()
    {
        QTest::addColumn<QString>("unit");
        QTest::addColumn<double>("nanoseconds");
        QTest::newRow("nanoseconds") << "ns" << 2.0;
        QTest::newRow("microseconds") << "us" << 2e3;
        QTest::newRow("milliseconds") << "ms" << 2e6;
        QTest::newRow("seconds") << "s" << 2e9;
    }
    void timesAreReadInAnyUnit()
    {
        QFETCH(QString, unit);
        QFETCH(double, nanoseconds);
        const Results results = resultsOf(median("a", 2.0, unit.toUtf8()));
        QCOMPARE(results.medians.at("a").nanoseconds, nanoseconds);
    }

    void rowsMeasuredByTheWallClockAreReadByIt()
    {
        const Results results =
            resultsOf(median("a/4/real_time", 2.0) + "," + median("b/4/iterations:7", 2.0) + "," +
                      median("c/4/iterations:7/manual_time", 2.0));
        QCOMPARE(results.medians.at("a/4").nanoseconds, 6.0);
        QCOMPARE(results.medians.at("b/4").nanoseconds, 2.0);
        QCOMPARE(results.medians.at("c/4").nanoseconds, 6.0);
    }

    void aRatioIsToldAgainstWhatWasAskedFor_data()
    {
        QTest::addColumn<int>("ratio");
        QTest::addColumn<double>("ours");
        QTest::addColumn<double>("theirs");
        QTest::addColumn<QString>("figure");
        QTest::addColumn<QString>("verdict");
        const int cost = int(Ratio::oursByTheirs), speed = int(Ratio::theirsByOurs), time = int(Ratio::time);
        QTest::newRow("cost at the aim") << cost << 15.0 << 10.0 << "1.50x"
                                         << "aim";
        QTest::newRow("cost that is enough") << cost << 16.0 << 10.0 << "1.60x"
                                             << "enough";
        QTest::newRow("cost past it") << cost << 21.0 << 10.0 << "2.10x"
                                      << "**missed**";
        QTest::newRow("speed at the aim") << speed << 10.0 << 15.0 << "1.50x"
                                          << "enough";
        QTest::newRow("speed past the aim") << speed << 10.0 << 30.0 << "3.00x"
                                            << "aim";
        QTest::newRow("speed below it") << speed << 10.0 << 10.0 << "1.00x"
                                        << "**missed**";
        QTest::newRow("cost next to nothing") << cost << 1.0 << 8000.0 << "0.00013x"
                                              << "aim";
        QTest::newRow("a time") << time << 1.7 << 0.0 << "1.70 ns"
                                << "enough";
    }
    void aRatioIsToldAgainstWhatWasAskedFor()
    {
        QFETCH(int, ratio);
        QFETCH(double, ours);
        QFETCH(double, theirs);
        Row row{"work", "a", "b", "B", Ratio(ratio), 2.0, 1.5};
        if (row.ratio == Ratio::theirsByOurs)
            std::swap(row.atLeast, row.aim);
        const QString text = tableOf(median("a", ours) + "," + median("b", theirs), row);
        QTEST(text.section('\n', 4, 4).section('|', 1, 1).trimmed(), "figure");
        QTEST(text.section('\n', 4, 4).section('|', 4, 4).trimmed(), "verdict");
    }

    void aRowWhoseOtherSideIsNotInstalledIsLeftOut()
    {
        const Row row{"work", "a", "b", "B"};
        QVERIFY(tableOf(median("a", 1.0) + "," + median("b", 1.0), row).contains("work"));
        QVERIFY(!tableOf(median("a", 1.0), row).contains("work"));
    }

    void benchmarksThatRefuseSayWhyOnce()
    {
        const QByteArray refused =
            R"({"run_name": "a/5", "run_type": "iteration", "error_occurred": true, "error_message": "no AVX2"})";
        const QByteArray other = QByteArray(refused).replace("a/5", "c");
        const QString text = tableOf(refused + "," + other, {"work", "a/5", "b", "B"});
        QVERIFY2(text.contains("\na/5, c did not run: no AVX2\n"), qPrintable(text));
    }

    void growthIsGoogleBenchmarksFit()
    {
        const QByteArray fit = R"({"run_name": "a", "aggregate_name": "BigO", "cpu_coefficient": 3,
            "big_o": "N", "time_unit": "us"}, {"run_name": "a", "aggregate_name": "RMS", "rms": 0.04})";
        const Results results = resultsOf(median("a/10", 40.0) + "," + median("a/20", 60.0) + "," +
                                          median("a/30", 60.0) + "," + fit);
        QCOMPARE(results.growths.at("a").as, std::string("N"));
        QCOMPARE(results.growths.at("a").nanoseconds, 3e3);
        QCOMPARE(results.growths.at("a").off, 0.04);
        const QString text = QString::fromStdString(
            table(results, {}, {{"work", "a", "point", {"10", "20", "30"}, {10.0, 20.0, 30.0}}}));
        QVERIFY2(text.contains("4.00 ns, 3.00 ns, 2.00 ns"), qPrintable(text));
        QVERIFY2(text.contains("4 %"), qPrintable(text));
    }

    void aCounterThatIsNoNumberHarmsNothing()
    {
        const QByteArray run = R"({"run_name": "a", "aggregate_name": "cv", "cpu_time": 1, "px_apart": NaN})";
        QCOMPARE(resultsOf(run + "," + median("a", 2.0)).medians.at("a").nanoseconds, 2.0);
    }

    void twoSizesTellNoGrowth()
    {
        const QByteArray fit = R"({"run_name": "a", "aggregate_name": "BigO", "cpu_coefficient": 3,
            "big_o": "N", "time_unit": "us"})";
        const Results results = resultsOf(median("a/10", 40.0) + "," + median("a/20", 60.0) + "," + fit);
        const QString text = QString::fromStdString(
            table(results, {}, {{"work", "a", "point", {"10", "20", "30"}, {10.0, 20.0, 30.0}}}));
        QVERIFY2(!text.contains("work"), qPrintable(text));
    }

    void theMachineIsOnTop()
    {
        const QString text = tableOf(median("a", 1.0), {"work", "a", "b", "B"});
        QCOMPARE(text.section('\n', 0, 0), "A, 2 cores, B; load 1.5 when it began");
    }

    void aBrokenFileIsRefused_data()
    {
        QTest::addColumn<QByteArray>("json");
        QTest::newRow("nothing") << QByteArray();
        QTest::newRow("half of it") << file("").left(40);
        QTest::newRow("something else") << QByteArray("{\"a\": 1}");
    }
    void aBrokenFileIsRefused()
    {
        QFETCH(QByteArray, json);
        Results results;
        QVERIFY(!addResults(json, results).empty());
    }
};

SUITE(tst_bench_table, TestBenchTable)
#include "tst_bench_table.moc"
