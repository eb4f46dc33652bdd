// Measurements follow the shared cursor: the stability gauge, and the error over the run.

#include "tests/app/panels/accuracy_support.h"
#include "tests/app/window/cursor_support.h"

#include "app/ui/accuracy/accuracy_panel.h"
#include "app/ui/accuracy/run_plot.h"
#include "app/ui/stability/stability_gauge.h"
#include "app/ui/stability/stability_panel.h"
#include "sim/analysis/stability/stability.h"
#include "tests/suite.h"

using namespace app;
using cursor_support::currentFrame;
using cursor_support::CursorFixture;

namespace {

/// A run whose spring is made stiffer half way.
struct Stiffened : CursorFixture
{
    Stiffened()
    {
        goTo(currentFrame / 2);
        session.editor().setParameter("k", 0.3);
        goTo(80);
        goTo(currentFrame);
        settle();
        park();
        QVERIFY(QTest::qWaitFor([&] { return qRound(gauge.percent()) == qRound(percentAt(currentFrame)); }));
    }
    /// Returns the share of the stability limit that the gauge should show for a frame, in %.
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
struct Measuring : CursorFixture
{
    Measuring() : CursorFixture("multi_foot", "two_feet", accuracy_support::madeUpAtOnce())
    {
        window.setMode(MainWindow::Mode::measure);
        panel.setView(AccuracyPanel::overTheRun);
        QVERIFY(QTest::qWaitFor([&] {
            if (panel.run().spots().empty() && !button->text().startsWith("Cancel"))
                button->click();
            return !panel.run().spots().empty();
        }));
        goTo(currentFrame);
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

class TestMeasuredAtPreview : public QObject
{
    Q_OBJECT

private slots:
    void theGaugeShowsHowNearTheLimitIsThereAndGoesBack()
    {
        Stiffened fixture;
        const QString words = fixture.gauge.words(), heard = fixture.heard(QAccessible::Description);
        QVERIFY(std::abs(fixture.percentAt(20) - fixture.percentAt(currentFrame)) > 5.0);
        fixture.hover(fixture.timeline, fixture.onTrack(20));
        QVERIFY(fixture.session.preview().isActive());
        const std::int64_t frame = fixture.session.preview().run().cursor().frame;
        QVERIFY(fixture.waitsFor(fixture.percentAt(frame)));
        QVERIFY(!fixture.gauge.isPale());
        QVERIFY(fixture.gauge.words() != words);
        QVERIFY2(
            fixture.heard(QAccessible::Description).startsWith(QString("Preview of frame %1").arg(frame)),
            qPrintable(fixture.heard(QAccessible::Description)));
        fixture.park();
        QCOMPARE(fixture.gauge.words(), words); // at once: it was not forgotten
        QCOMPARE(fixture.heard(QAccessible::Description), heard);
    }

    void gaugeShowsTheFrameWhereTheMouseStopped()
    {
        Stiffened fixture;
        for (const std::int64_t frame : {50, 40, 20, 10, 35})
            fixture.hover(fixture.timeline, fixture.onTrack(frame));
        QVERIFY(fixture.session.preview().isActive());
        QVERIFY(fixture.waitsFor(fixture.percentAt(fixture.session.preview().run().cursor().frame)));
        QVERIFY(fixture.waitsFor(fixture.percentAt(35)));
    }

    void theReasonsInThePanelStayThoseOfTheRun()
    {
        Stiffened fixture;
        fixture.window.docks().show(Panel::stability, true);
        auto &panel = *fixture.window.findChild<StabilityPanel *>();
        QCoreApplication::processEvents();
        const QString verdict = panel.verdict();
        fixture.hover(fixture.timeline, fixture.onTrack(20));
        QVERIFY(fixture.waitsFor(fixture.percentAt(fixture.session.preview().run().cursor().frame)));
        QCOMPARE(panel.verdict(), verdict);
    }

    void hoveringTheErrorPlotPreviewsItsFrame()
    {
        Measuring fixture;
        RunPlot &plot = fixture.panel.run();
        const QImage before = plot.grab().toImage();
        fixture.hover(plot, fixture.onRun(20.0));
        QVERIFY(fixture.session.preview().isActive());
        QCOMPARE(fixture.session.preview().run().cursor().frame, 20);
        QCOMPARE(plot.hovered(), 20);
        QCOMPARE(fixture.timeline.pointed(), 20);
        QVERIFY(QLineF(fixture.shown("foot0"), fixture.places(20, "foot0")).length() < 1e-9);
        fixture.park();
        QVERIFY(!fixture.session.preview().marked());
        QVERIFY(!plot.hovered());
        QCOMPARE(plot.grab().toImage(), before);
    }

    void aPreviewFromElsewhereIsAThinLineInTheErrorOverTheRun()
    {
        Measuring fixture;
        RunPlot &plot = fixture.panel.run();
        const QImage before = plot.grab().toImage();
        fixture.hover(fixture.timeline, fixture.onTrack(30));
        QVERIFY(plot.hovered());
        const std::int64_t frame = fixture.session.preview().run().cursor().frame;
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
        QVERIFY(!differs(currentFrame)); // the cursor stays
        fixture.park();
        QCOMPARE(plot.grab().toImage(), before);
    }

    void framesNotComputedYetCannotBePreviewed()
    {
        Measuring fixture;
        fixture.hover(fixture.panel.run(), fixture.onRun(90.0));
        QVERIFY(!fixture.session.preview().marked());
    }
};

SUITE(tst_measured_at_preview, TestMeasuredAtPreview)
#include "tst_measured_at_preview.moc"
