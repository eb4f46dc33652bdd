// When the ledger of effects measures, and when it does not.

#include "effects_panel_bench.h"

using namespace app;
using namespace effects_bench;
using namespace effects_panel_bench;

class EffectsMeasuredTest : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase() { prepareProgram(); }

    void nothingRunsWhenMeasuringIsDone()
    {
        Bench bench;
        struct Counter : QObject
        {
            int timers = 0;
            bool eventFilter(QObject *, QEvent *event) override
            {
                timers += event->type() == QEvent::Timer;
                return false;
            }
        } counter;
        qApp->installEventFilter(&counter);
        const auto quietForHalfASecond = [&] {
            counter.timers = 0;
            QTest::qWait(500);
            return counter.timers == 0;
        };
        bool isQuiet = false;
        for (int i = 0; i < 20 && !isQuiet; ++i)
            isQuiet = quietForHalfASecond();
        QVERIFY(isQuiet);
        QVERIFY(bench.panel.ledger().costs().isAtRest());
        QCOMPARE(bench.reader.begun.load(), 1);
        auto *again = bench.panel.findChild<QToolButton *>("tab");
        QVERIFY(!again->toolTip().isEmpty());
        QTest::mouseClick(again, Qt::LeftButton);
        QVERIFY(bench.settle());
        QCOMPARE(bench.reader.begun.load(), 2);
        qApp->removeEventFilter(&counter);
    }

    void itMeasuresOnlyWhileItIsSeen()
    {
        Bench bench;
        bench.panel.hide();
        bench.session().setParameter("k", 0.3);
        QTest::qWait(2 * CostWatch::settleMilliseconds);
        QCOMPARE(bench.reader.begun.load(), 1);
        bench.panel.show();
        QVERIFY(bench.settle());
        QCOMPARE(bench.reader.begun.load(), 2);
        bench.panel.setCovered(true);
        bench.session().setParameter("k", 0.4);
        QTest::qWait(2 * CostWatch::settleMilliseconds);
        QCOMPARE(bench.reader.begun.load(), 2);
        bench.reader.held = true;
        bench.panel.setCovered(false);
        QTRY_COMPARE(bench.reader.begun.load(), 3);
        bench.panel.hide(); // in the middle of it
        QTRY_COMPARE(bench.reader.stopped.load(), 1);
        bench.reader.held = false;
    }

    void aChangeCancelsWhatIsUnderWay()
    {
        Bench bench;
        bench.reader.held = true;
        bench.session().setParameter("k", 0.3);
        QTRY_COMPARE(bench.reader.begun.load(), 2);
        bench.session().setEffect("body_spring", false);
        QTRY_COMPARE(bench.reader.stopped.load(), 1);
        QCOMPARE(bench.line("damping").frame, "…"); // nothing is known of this frame yet
        bench.reader.held = false;
        QVERIFY(bench.settle());
        QCOMPARE(bench.line("damping").frame, "0.0046");
    }

    void theMomentThatWasMeasuredIsSaid()
    {
        Bench bench;
        bench.session().goTo({12, 0});
        QVERIFY2(bench.panel.caption().endsWith("measured at frame 0"), qPrintable(bench.panel.caption()));
        bench.panel.measureAgain()->trigger();
        QVERIFY(bench.settle());
        QVERIFY(bench.panel.caption().endsWith("measured now"));
    }

    /// With the real meter: every effect that acts has a figure, and what does not act has none.
    void theRealMeterFillsTheLines()
    {
        World world(legLibrary());
        EffectsPanel panel(world.session, world.theme);
        show(panel, {620, 320});
        QVERIFY(QTest::qWaitFor([&] { return panel.isSettled(); }, 60'000));
        const auto &lines = panel.list().lines().lines();
        QCOMPARE(lines[0].id, "body_spring");
        QVERIFY(lines[0].ns > 0.0);
        QCOMPARE(lines[0].runs, "×1");
        QCOMPARE(lines[1].role, EffectRole::idle);
        QVERIFY(!panel.ledger().costs().cost()->effects.empty());
    }
};

QTEST_MAIN(EffectsMeasuredTest)
#include "tst_effects_measured.moc"
