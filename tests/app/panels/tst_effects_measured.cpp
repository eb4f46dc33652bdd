// When the ledger of effects measures, and when it does not.

#include "tests/app/panels/effects_panel_support.h"
#include "tests/suite.h"

using namespace app;
using namespace effects_support;
using namespace effects_panel_support;

class EffectsMeasuredTest : public QObject
{
    Q_OBJECT

private slots:
    void nothingRunsWhenMeasuringIsDone()
    {
        EffectsFixture fixture;
        QVERIFY(Activity().comesToRest(500));
        QVERIFY(fixture.panel.ledger().costs().isAtRest());
        QCOMPARE(fixture.meter.begun.load(), 1);
        auto *again = fixture.panel.findChild<QToolButton *>("tab");
        QVERIFY(!again->toolTip().isEmpty());
        QTest::mouseClick(again, Qt::LeftButton);
        QVERIFY(fixture.settle());
        QCOMPARE(fixture.meter.begun.load(), 2);
    }

    void panelMeasuresOnlyWhileItIsVisible()
    {
        EffectsFixture fixture;
        fixture.panel.hide();
        fixture.session.editor().setParameter("k", 0.3);
        settle();
        QVERIFY(fixture.panel.ledger().costs().isAtRest()); // neither due nor under way
        QCOMPARE(fixture.meter.begun.load(), 1);
        fixture.panel.show();
        QVERIFY(fixture.settle());
        QCOMPARE(fixture.meter.begun.load(), 2);
        fixture.panel.setCovered(true);
        fixture.session.editor().setParameter("k", 0.4);
        settle();
        QVERIFY(fixture.panel.ledger().costs().isAtRest()); // neither due nor under way
        QCOMPARE(fixture.meter.begun.load(), 2);
        fixture.meter.held = true;
        fixture.panel.setCovered(false);
        QTRY_COMPARE(fixture.meter.begun.load(), 3);
        fixture.panel.hide(); // in the middle of it
        QTRY_COMPARE(fixture.meter.stopped.load(), 1);
        fixture.meter.held = false;
    }

    void aChangeCancelsWhatIsUnderWay()
    {
        EffectsFixture fixture;
        fixture.meter.held = true;
        fixture.session.editor().setParameter("k", 0.3);
        QTRY_COMPARE(fixture.meter.begun.load(), 2);
        fixture.session.editor().setEffect("body_spring", false);
        QTRY_COMPARE(fixture.meter.stopped.load(), 1);
        QCOMPARE(fixture.line("damping").frame, "…"); // nothing is known of this frame yet
        fixture.meter.held = false;
        QVERIFY(fixture.settle());
        QCOMPARE(fixture.line("damping").frame, "0.0046");
    }

    void captionNamesTheMeasuredFrame()
    {
        EffectsFixture fixture;
        fixture.session.playback().goTo({12, 0});
        QVERIFY2(fixture.panel.caption().endsWith("measured at frame 0"),
                 qPrintable(fixture.panel.caption()));
        fixture.panel.measureAgain()->trigger();
        QVERIFY(fixture.settle());
        QVERIFY(fixture.panel.caption().endsWith("measured now"));
    }

    /// With the real meter, every active effect has a figure, and idle effects have none.
    void theRealMeterFillsTheLines()
    {
        PanelFixture<EffectsPanel> fixture(legLibrary(), {620, 320});
        EffectsPanel &panel = fixture.panel;
        QVERIFY(QTest::qWaitFor([&] { return panel.isSettled(); }, 60'000));
        const auto &lines = panel.list().lines().lines();
        QCOMPARE(lines[0].id, "body_spring");
        QVERIFY(lines[0].ns > 0.0);
        QCOMPARE(lines[0].runs, "×1");
        QCOMPARE(lines[1].role, EffectRole::idle);
        QVERIFY(!panel.ledger().costs().cost()->effects.empty());
    }
};

SUITE(tst_effects_measured, EffectsMeasuredTest)
#include "tst_effects_measured.moc"
