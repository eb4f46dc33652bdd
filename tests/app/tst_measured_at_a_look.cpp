// What is measured follows the one cursor, too: the stability gauge, and the error over the run.

#include "cursor_bench.h"
#include "measure_bench.h"

#include "app/ui/measure/accuracy_panel.h"
#include "app/ui/measure/run_plot.h"
#include "app/ui/stability/stability_gauge.h"
#include "app/ui/stability/stability_panel.h"
#include "sim/analysis/stability/stability.h"

#include <QTemporaryDir>

using namespace app;
using cursor_bench::Bench;
using cursor_bench::stands;

namespace {

/// A run whose spring is made stiffer half way.
struct Stiffened : Bench
{
    Stiffened()
    {
        goTo(stands / 2);
        session.setParameter("k", 0.3);
        goTo(80);
        goTo(stands);
        settle();
        park();
        QVERIFY(QTest::qWaitFor([&] { return qRound(gauge.percent()) == qRound(percentAt(stands)); }));
    }
    /// What the gauge should say of a moment.
    double percentAt(std::int64_t frame)
    {
        sim::Track track(session.timeline().script(), 0);
        track.seek({frame, 0});
        const sim::Script &script = track.script();
        return 100.0 *
               sim::stabilityOf(track.nextInterval()->scene, track.state(), *script.method, script.step.h)
                   .share();
    }
    bool waitsFor(double percent)
    {
        return QTest::qWaitFor([&] { return std::abs(gauge.percent() - percent) < 1e-9; });
    }
    QString heard(QAccessible::Text kind)
    {
        return QAccessible::queryAccessibleInterface(&gauge)->text(kind);
    }

    StabilityGauge &gauge = *window.findChild<StabilityGauge *>();
};

/// The window as Measure has it, with made-up errors over the run.
struct Measuring : Bench
{
    Measuring() : Bench("multi_foot", "two_feet", measure_bench::madeUpAtOnce())
    {
        window.setMode(MainWindow::Mode::measure);
        panel.setView(AccuracyPanel::overTheRun);
        QVERIFY(QTest::qWaitFor([&] {
            if (panel.run().spots().empty() && !button->text().startsWith("Cancel"))
                button->click();
            return !panel.run().spots().empty();
        }));
        goTo(stands);
        park();
    }
    QPointF onRun(double frame)
    {
        return {panel.run().xAxis->coordToPixel(frame), panel.run().height() / 2.0};
    }

    AccuracyPanel &panel = *window.findChild<AccuracyPanel *>();
    QPushButton *button = panel.findChild<QPushButton *>("measure");
};

}

class TestMeasuredAtALook : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QStandardPaths::setTestModeEnabled(true);
        QCoreApplication::setOrganizationName("springstep-test");
        QCoreApplication::setApplicationName("measured_at_a_look");
        QVERIFY(m_settings.isValid());
        window_bench::keepSettingsIn(m_settings.path());
    }

    void theGaugeShowsHowNearTheLimitIsThereAndGoesBack()
    {
        Stiffened bench;
        const QString words = bench.gauge.words(), heard = bench.heard(QAccessible::Description);
        QVERIFY(std::abs(bench.percentAt(20) - bench.percentAt(stands)) > 5.0);
        bench.hover(bench.timeline, bench.onTrack(20));
        QVERIFY(bench.session.isGlancing());
        const std::int64_t frame = bench.session.shown().cursor().frame;
        QVERIFY(bench.waitsFor(bench.percentAt(frame)));
        QVERIFY(!bench.gauge.isPale());
        QVERIFY(bench.gauge.words() != words);
        QVERIFY2(bench.heard(QAccessible::Description).startsWith(QString("Looking at frame %1").arg(frame)),
                 qPrintable(bench.heard(QAccessible::Description)));
        bench.park();
        QCOMPARE(bench.gauge.words(), words); // at once: it was not forgotten
        QCOMPARE(bench.heard(QAccessible::Description), heard);
    }

    void aHandThatMovesOnEndsAtTheMomentWhereItStands()
    {
        Stiffened bench;
        for (const std::int64_t frame : {50, 40, 20, 10, 35})
            bench.hover(bench.timeline, bench.onTrack(frame));
        QVERIFY(bench.session.isGlancing());
        QVERIFY(bench.waitsFor(bench.percentAt(bench.session.shown().cursor().frame)));
        QVERIFY(bench.waitsFor(bench.percentAt(35)));
    }

    void theReasonsInThePanelStayThoseOfTheRun()
    {
        Stiffened bench;
        bench.window.showStability(true);
        auto &panel = *bench.window.findChild<StabilityPanel *>();
        QCoreApplication::processEvents();
        const QString verdict = panel.verdict();
        bench.hover(bench.timeline, bench.onTrack(20));
        QVERIFY(bench.waitsFor(bench.percentAt(bench.session.shown().cursor().frame)));
        QCOMPARE(panel.verdict(), verdict);
    }

    void theMouseInTheErrorOverTheRunLooksThere()
    {
        Measuring bench;
        RunPlot &plot = bench.panel.run();
        const QImage before = plot.grab().toImage();
        bench.hover(plot, bench.onRun(20.0));
        QVERIFY(bench.session.isGlancing());
        QCOMPARE(bench.session.shown().cursor().frame, 20);
        QCOMPARE(plot.hovered(), 20);
        QCOMPARE(bench.timeline.pointed(), 20);
        QVERIFY(QLineF(bench.shown("foot0"), bench.places(20, "foot0")).length() < 1e-9);
        bench.park();
        QVERIFY(!bench.session.marked());
        QVERIFY(!plot.hovered());
        QCOMPARE(plot.grab().toImage(), before);
    }

    void aLookFromElsewhereIsAThinLineInTheErrorOverTheRun()
    {
        Measuring bench;
        RunPlot &plot = bench.panel.run();
        const QImage before = plot.grab().toImage();
        bench.hover(bench.timeline, bench.onTrack(30));
        QVERIFY(plot.hovered());
        const std::int64_t frame = bench.session.shown().cursor().frame;
        QCOMPARE(plot.hovered(), frame);
        const QImage during = plot.grab().toImage();
        const auto differs = [&](double at) {
            const int x = qRound(plot.xAxis->coordToPixel(at)), y = plot.axisRect()->top() + 30;
            bool any = false;
            for (int i = -1; i <= 1; ++i)
                any |= during.pixel(x + i, y) != before.pixel(x + i, y);
            return any;
        };
        QVERIFY(differs(static_cast<double>(frame)));
        QVERIFY(!differs(stands)); // the cursor stays
        bench.park();
        QCOMPARE(plot.grab().toImage(), before);
    }

    void whatIsNotComputedYetIsNoMomentToLookAt()
    {
        Measuring bench;
        bench.hover(bench.panel.run(), bench.onRun(90.0));
        QVERIFY(!bench.session.marked());
    }

private:
    QTemporaryDir m_settings;
};

QTEST_MAIN(TestMeasuredAtALook)
#include "tst_measured_at_a_look.moc"
