// The gauge of stability and its panel in the window, used with mouse and keys.

#include "tests/app/panels/stability_panel_support.h"

#include "app/ui/accuracy/accuracy_panel.h"
#include "app/ui/code/engine/code_panel.h"
#include "tests/suite.h"

#include <QAccessible>
#include <QLabel>
#include <QPushButton>
#include <QStatusBar>
#include <QTextDocument>

using namespace app;

class StabilityPanelTest : public QObject
{
    Q_OBJECT

private slots:
    void gaugeIsInTheStatusBar();
    void theBarPassesItsTickWhenTheLimitIsPassed();
    void theGaugeIsHollowWithoutALimit();
    void clickAndKeysOpenTheReasonsInPlaceOfTheCode();
    void theReasonsCloseByTheirCross();
    void noLineOfTheReasonsEndsBetweenANumberAndItsUnit();
    void reasonsReplaceAccuracyInMeasureMode();
    void oneClickOnARemedyMends_data();
    void oneClickOnARemedyMends();
    void oneClickMakesSticksFit_data();
    void oneClickMakesSticksFit();
    void aScreenReaderHearsGaugeAndMap();
    void everyControlHasATip();
};

void StabilityPanelTest::gaugeIsInTheStatusBar()
{
    StabilityFixture fixture;
    QVERIFY(fixture.gauge.isVisible());
    QCOMPARE(fixture.gauge.parentWidget(), fixture.window.statusBar());
    QCOMPARE(fixture.gauge.words(), "89\u2009% of the limit");
    QVERIFY(fixture.window.statusBar()->rect().contains(fixture.gauge.geometry()));
    QVERIFY(fixture.gauge.toolTip().contains("sets the limit"));
}

void StabilityPanelTest::theBarPassesItsTickWhenTheLimitIsPassed()
{
    StabilityFixture fixture;
    const auto barAt = [&](double share) {
        // The bar starts after the caption; it ends 92 px later.
        const int words = QFontMetrics(fixture.theme.ui(12)).horizontalAdvance("Stability");
        return colourAt(fixture.gauge,
                        {8.0 + words + 8.0 + share * StabilityGauge::barWidth, fixture.gauge.height() / 2.0});
    };
    QVERIFY(fixture.gauge.filled() < StabilityGauge::limitPlace);
    QVERIFY(isNear(barAt(0.5), fixture.theme.tokens().near));
    QVERIFY(!isNear(barAt(0.92), fixture.theme.tokens().near));
    fixture.session.editor().setParameter("k", 0.3);
    fixture.waitForReading();
    QVERIFY(fixture.gauge.filled() > StabilityGauge::limitPlace);
    QVERIFY(isNear(barAt(0.92), fixture.theme.tokens().past));
    fixture.session.editor().setMethod("semi_implicit_euler");
    fixture.waitForReading();
    QVERIFY(fixture.gauge.filled() > 0.1 && fixture.gauge.filled() < 0.5);
    QVERIFY(isNear(barAt(0.1), fixture.theme.tokens().ok));
}

void StabilityPanelTest::theGaugeIsHollowWithoutALimit()
{
    StabilityFixture fixture;
    fixture.session.editor().setMethod("backward_euler");
    fixture.waitForReading();
    QCOMPARE(fixture.gauge.words(), "no limit");
    QCOMPARE(fixture.gauge.filled(), 0.0);
}

void StabilityPanelTest::clickAndKeysOpenTheReasonsInPlaceOfTheCode()
{
    StabilityFixture fixture;
    const auto isOpen = [&] { return fixture.panel.isVisible() && !fixture.isSeen<CodePanel>(); };
    const auto isClosed = [&] { return !fixture.panel.isVisible() && fixture.isSeen<CodePanel>(); };
    QVERIFY(isClosed());
    QTest::mouseClick(&fixture.gauge, Qt::LeftButton);
    QVERIFY(isOpen());
    QTest::mouseClick(&fixture.gauge, Qt::LeftButton);
    QVERIFY(isClosed());
    QTest::keyClick(&fixture.window, Qt::Key_L, Qt::ControlModifier);
    QVERIFY(isOpen());
    QVERIFY(fixture.gauge.isChecked());
    QTest::keyClick(&fixture.window, Qt::Key_L, Qt::ControlModifier);
    QVERIFY(isClosed());
    for (const Qt::Key key : {Qt::Key_Space, Qt::Key_Return}) {
        fixture.gauge.setFocus(Qt::TabFocusReason);
        QTest::keyClick(&fixture.gauge, key);
        QVERIFY(isOpen());
        QVERIFY(!fixture.session.playback().isPlaying());
        fixture.gauge.setFocus(Qt::TabFocusReason);
        QTest::keyClick(&fixture.gauge, key);
        QVERIFY(isClosed());
    }
}

void StabilityPanelTest::theReasonsCloseByTheirCross()
{
    StabilityFixture fixture;
    QTest::mouseClick(&fixture.gauge, Qt::LeftButton);
    QTest::mouseClick(fixture.panel.findChild<QToolButton *>("closeStability"), Qt::LeftButton);
    QVERIFY(!fixture.panel.isVisible());
    QVERIFY(!fixture.gauge.isChecked());
    QVERIFY(fixture.isSeen<CodePanel>());
}

void StabilityPanelTest::reasonsReplaceAccuracyInMeasureMode()
{
    StabilityFixture fixture;
    fixture.window.setMode(MainWindow::Mode::measure);
    QVERIFY(fixture.isSeen<AccuracyPanel>());
    QTest::mouseClick(&fixture.gauge, Qt::LeftButton);
    QVERIFY(fixture.panel.isVisible());
    QVERIFY(!fixture.isSeen<AccuracyPanel>());
    fixture.window.setMode(MainWindow::Mode::learn);
    QVERIFY(!fixture.panel.isVisible());
    QVERIFY(fixture.isSeen<CodePanel>());
    QVERIFY(!fixture.isSeen<AccuracyPanel>());
}

void StabilityPanelTest::oneClickOnARemedyMends_data()
{
    QTest::addColumn<QString>("starts");
    QTest::addRow("step") << "Use a step of";
    QTest::addRow("damping") << "Damp more: damp 0.8";
    QTest::addRow("holding method") << "Use Semi-implicit Euler";
    QTest::addRow("boundless method") << "Use TR-BDF2";
}

void StabilityPanelTest::oneClickOnARemedyMends()
{
    QFETCH(QString, starts);
    StabilityFixture fixture;
    fixture.session.editor().setParameter("k", 0.3);
    QTest::mouseClick(&fixture.gauge, Qt::LeftButton);
    QVERIFY(QTest::qWaitFor([&] { return !fixture.panel.remedies().empty(); }));
    fixture.waitForReading();
    QCOMPARE(nearnessOf(fixture.window.stability().reading()->stability), Nearness::past);
    QPushButton *wanted = nullptr;
    for (QPushButton *button : fixture.panel.remedies()) {
        if (button->text().startsWith(starts))
            wanted = button;
    }
    QVERIFY(wanted);
    QVERIFY(wanted->isVisible());
    QTest::mouseClick(wanted, Qt::LeftButton);
    fixture.waitForReading();
    QVERIFY(nearnessOf(fixture.window.stability().reading()->stability) != Nearness::past);
    QVERIFY(!fixture.panel.verdict().contains("grow by"));
}

void StabilityPanelTest::oneClickMakesSticksFit_data()
{
    QTest::addColumn<QString>("starts");
    QTest::addRow("step") << "Use a step of";
    QTest::addRow("passes") << "Use ";
}

void StabilityPanelTest::oneClickMakesSticksFit()
{
    QFETCH(QString, starts);
    StabilityFixture fixture("rigid_constraint", "ragdoll");
    fixture.session.editor().setParameter("iterations", 1);
    fixture.session.input().grab("p0");
    for (int frame = 1; frame <= 12; ++frame) {
        fixture.session.input().moveTo({270.0, 95.0 - 4.0 * frame});
        fixture.session.playback().goTo({frame, 0});
    }
    fixture.session.input().release();
    fixture.waitForReading();
    QTest::mouseClick(&fixture.gauge, Qt::LeftButton);
    QVERIFY(QTest::qWaitFor([&] { return !fixture.panel.remedies().empty(); }));
    fixture.waitForReading();
    const auto isWanted = [&](QPushButton *button) {
        return button->text().startsWith(starts) && (starts != "Use " || button->text().endsWith("passes"));
    };
    const auto buttons = fixture.panel.remedies();
    const auto wanted = std::find_if(buttons.begin(), buttons.end(), isWanted);
    QVERIFY(wanted != buttons.end());
    QVERIFY(fixture.panel.verdict().contains("px too long") ||
            fixture.panel.verdict().contains("px too short"));
    const sim::StickAdvice before = *fixture.window.stability().reading()->sticks;
    const auto at = static_cast<std::size_t>(wanted - buttons.begin());
    const double promised = before.remedies.at(at).stickError.value();
    QVERIFY(promised <= sim::fitting);
    const std::int64_t frame = fixture.session.timeline().cursor().frame;
    QTest::mouseClick(*wanted, Qt::LeftButton);
    QTRY_COMPARE(fixture.session.timeline().cursor().frame, frame);
    fixture.waitForReading();
    QCOMPARE(std::abs(fixture.window.stability().reading()->sticks.value().now.error), promised);
    QVERIFY(fixture.panel.verdict().contains("Sticks keep their lengths"));
    QVERIFY(fixture.panel.remedies().empty());
    fixture.session.editor().undo();
    QTRY_VERIFY(fixture.panel.verdict().contains("px too long"));
    fixture.waitForReading();
    QCOMPARE(fixture.window.stability().reading()->sticks.value().now.error, before.now.error);
}

void StabilityPanelTest::aScreenReaderHearsGaugeAndMap()
{
    StabilityFixture fixture;
    QAccessibleInterface *gauge = QAccessible::queryAccessibleInterface(&fixture.gauge);
    QVERIFY(gauge);
    QCOMPARE(gauge->text(QAccessible::Name), "Stability");
    QCOMPARE(gauge->text(QAccessible::Value), "89\u2009% of the limit");
    QVERIFY(gauge->text(QAccessible::Description).contains("sets the limit"));
    QVERIFY(gauge->valueInterface());
    QCOMPARE(qRound(gauge->valueInterface()->currentValue().toDouble()), 89);
    QTest::mouseClick(&fixture.gauge, Qt::LeftButton);
    QTest::mouseClick(fixture.plane(0), Qt::LeftButton);
    fixture.waitForMap();
    QAccessibleInterface *map = QAccessible::queryAccessibleInterface(&fixture.panel.plot());
    QVERIFY(map);
    QVERIFY(map->text(QAccessible::Value).startsWith("You are at k 0.2"));
}

void StabilityPanelTest::noLineOfTheReasonsEndsBetweenANumberAndItsUnit()
{
    StabilityFixture fixture;
    fixture.session.editor().setParameter("k", 0.3);
    QTest::mouseClick(&fixture.gauge, Qt::LeftButton);
    fixture.waitForReading();
    int reasons = 0;
    for (const QLabel *label : fixture.panel.findChildren<QLabel *>()) {
        if (label->textFormat() != Qt::RichText)
            continue;
        ++reasons;
        QTextDocument document; // as the label sets it
        document.setHtml(label->text());
        QVERIFY(document.toRawText().contains(QRegularExpression("\\d\\x{A0}frames")));
        QVERIFY(!document.toRawText().contains(QRegularExpression("\\d[ \\x{2009}](frames|%)")));
    }
    QCOMPARE(reasons, 1);
}

void StabilityPanelTest::everyControlHasATip()
{
    StabilityFixture fixture;
    fixture.session.editor().setParameter("k", 0.3);
    QTest::mouseClick(&fixture.gauge, Qt::LeftButton);
    QVERIFY(QTest::qWaitFor([&] { return !fixture.panel.remedies().empty(); }));
    const auto buttons = fixture.panel.findChildren<QAbstractButton *>();
    QVERIFY(!buttons.isEmpty());
    for (const QAbstractButton *button : buttons) {
        QVERIFY2(!button->toolTip().isEmpty(), qPrintable(button->text()));
        QVERIFY(!button->text().isEmpty() || !button->accessibleName().isEmpty());
        QVERIFY(button->focusPolicy() != Qt::NoFocus);
    }
}

SUITE(tst_stability_panel, StabilityPanelTest)
#include "tst_stability_panel.moc"
