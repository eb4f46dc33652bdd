#include "app/ui/theme/theme.h"
#include "app/ui/time/timeline_axis.h"
#include "app/ui/time/timeline_painter.h"
#include "tests/suite.h"

#include <QFontMetricsF>
#include <QTest>

using namespace app;

class TestTimelineAxis : public QObject
{
    Q_OBJECT

private slots:
    void theAxisGrowsInNiceStepsAndNeverShrinks_data();
    void theAxisGrowsInNiceStepsAndNeverShrinks();
    void tickLabelsNeverMeet_data();
    void tickLabelsNeverMeet();
    void theNameOfARunFitsBesideItsFork_data();
    void theNameOfARunFitsBesideItsFork();
};

void TestTimelineAxis::theAxisGrowsInNiceStepsAndNeverShrinks_data()
{
    QTest::addColumn<qint64>("frame");
    QTest::addColumn<qint64>("frames");
    QTest::newRow("nothing yet") << qint64(0) << qint64(120);
    QTest::newRow("just full") << qint64(120) << qint64(120);
    QTest::newRow("one more") << qint64(121) << qint64(300);
    QTest::newRow("301") << qint64(301) << qint64(600);
    QTest::newRow("601") << qint64(601) << qint64(1200);
    QTest::newRow("1201") << qint64(1201) << qint64(3000);
    QTest::newRow("ten million") << qint64(10'000'000) << qint64(12'000'000);
}

void TestTimelineAxis::theAxisGrowsInNiceStepsAndNeverShrinks()
{
    QFETCH(qint64, frame);
    QFETCH(qint64, frames);
    TimelineAxis axis;
    QCOMPARE(axis.cover(frame), frames > 120);
    QCOMPARE(axis.frames(), frames);
    QVERIFY(!axis.cover(10));
    QCOMPARE(axis.frames(), frames);
    axis.setWidth(600);
    const std::vector<std::int64_t> ticks = axis.ticks(8);
    QCOMPARE(ticks.size(), std::size_t(7));
    for (std::size_t i = 0; i < ticks.size(); ++i) {
        QCOMPARE(ticks[i], frames / 6 * std::int64_t(i));
        QCOMPARE(axis.frameAt(axis.xOf(ticks[i])), ticks[i]);
    }
}

void TestTimelineAxis::tickLabelsNeverMeet_data()
{
    QTest::addColumn<int>("width");
    QTest::addColumn<qint64>("frame");
    for (const int width : {280, 400, 600, 1900}) {
        for (const qint64 frame : {0, 300, 9000, 10'000'000})
            QTest::addRow("%d px, %lld frames", width, frame) << width << frame;
    }
}

void TestTimelineAxis::tickLabelsNeverMeet()
{
    QFETCH(int, width);
    QFETCH(qint64, frame);
    TimelineAxis axis;
    axis.cover(frame);
    axis.setWidth(width);
    const QFontMetricsF metrics(Theme(Scheme::light).ui(11));
    const auto widthOf = [&](std::int64_t f) { return metrics.horizontalAdvance(QString::number(f)); };
    double end = -100.0;
    const std::vector<std::int64_t> ticks = axis.ticks(widthOf(axis.frames()));
    QVERIFY(ticks.size() >= 2);
    QCOMPARE(ticks.back(), axis.frames());
    for (const std::int64_t tick : ticks) {
        const double start =
            std::clamp(axis.xOf(tick) - widthOf(tick) / 2, axis.left(), axis.right() - widthOf(tick));
        QVERIFY(start >= end + 8);
        end = start + widthOf(tick);
    }
}

void TestTimelineAxis::theNameOfARunFitsBesideItsFork_data()
{
    QTest::addColumn<qint64>("fork");
    for (const qint64 fork : {0, 30, 60, 90, 110})
        QTest::addRow("fork at %lld", fork) << fork;
}

void TestTimelineAxis::theNameOfARunFitsBesideItsFork()
{
    QFETCH(qint64, fork);
    const Theme theme(Scheme::light);
    TimelineAxis axis;
    axis.setWidth(420);
    const ComparisonRun before{.fork = fork,
                               .end = 120,
                               .name =
                                   QString("before: double error = length(d) - stick.length ").repeated(3),
                               .id = 1};
    const QRectF area = comparisonRunArea(axis, before, theme);
    QVERIFY(area.left() >= axis.left() - 5.0 && area.right() <= axis.right() + 5.0);
}

SUITE(tst_timeline_axis, TestTimelineAxis)
#include "tst_timeline_axis.moc"
