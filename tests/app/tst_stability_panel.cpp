// The gauge and its reasons, in the window, driven as a learner drives them.

#include "stability_panel_bench.h"

#include "app/ui/code/code_panel.h"
#include "app/ui/measure/accuracy_panel.h"

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
    void initTestCase();
    void theGaugeStandsInTheStatusBar();
    void theBarPassesItsTickWhenTheLimitIsPassed();
    void theGaugeIsHollowWithoutALimit();
    void clickAndKeysOpenTheReasonsInPlaceOfTheCode();
    void theReasonsCloseByTheirCross();
    void noLineOfTheReasonsEndsBetweenANumberAndItsUnit();
    void inMeasureTheyTakeThePlaceOfAccuracy();
    void oneClickOnARemedyMends_data();
    void oneClickOnARemedyMends();
    void oneClickMakesSticksFit_data();
    void oneClickMakesSticksFit();
    void aScreenReaderHearsGaugeAndMap();
    void everyControlHasATip();
};

void StabilityPanelTest::initTestCase()
{
    useOwnSettings();
}

void StabilityPanelTest::theGaugeStandsInTheStatusBar()
{
    StabilityPanelBench bench;
    QVERIFY(bench.gauge.isVisible());
    QCOMPARE(bench.gauge.parentWidget(), bench.window.statusBar());
    QCOMPARE(bench.gauge.words(), "89\u2009% of the limit");
    QVERIFY(bench.window.statusBar()->rect().contains(bench.gauge.geometry()));
    QVERIFY(bench.gauge.toolTip().contains("decides it"));
}

void StabilityPanelTest::theBarPassesItsTickWhenTheLimitIsPassed()
{
    StabilityPanelBench bench;
    const auto barAt = [&](double share) {
        // The bar starts after the caption; it ends 92 px later.
        const int words = QFontMetrics(bench.theme.ui(12)).horizontalAdvance("Stability");
        return colourAt(bench.gauge,
                        {8.0 + words + 8.0 + share * StabilityGauge::barWidth, bench.gauge.height() / 2.0});
    };
    QVERIFY(bench.gauge.filled() < StabilityGauge::limitPlace);
    QVERIFY(isNear(barAt(0.5), bench.theme.tokens().near));
    QVERIFY(!isNear(barAt(0.92), bench.theme.tokens().near));
    bench.session.setParameter("k", 0.3);
    bench.settle();
    QVERIFY(bench.gauge.filled() > StabilityGauge::limitPlace);
    QVERIFY(isNear(barAt(0.92), bench.theme.tokens().past));
    bench.session.setMethod("semi_implicit_euler");
    bench.settle();
    QVERIFY(bench.gauge.filled() > 0.1 && bench.gauge.filled() < 0.5);
    QVERIFY(isNear(barAt(0.1), bench.theme.tokens().ok));
}

void StabilityPanelTest::theGaugeIsHollowWithoutALimit()
{
    StabilityPanelBench bench;
    bench.session.setMethod("backward_euler");
    bench.settle();
    QCOMPARE(bench.gauge.words(), "no limit");
    QCOMPARE(bench.gauge.filled(), 0.0);
}

void StabilityPanelTest::clickAndKeysOpenTheReasonsInPlaceOfTheCode()
{
    StabilityPanelBench bench;
    const auto isOpen = [&] { return bench.panel.isVisible() && !bench.isSeen<CodePanel>(); };
    const auto isClosed = [&] { return !bench.panel.isVisible() && bench.isSeen<CodePanel>(); };
    QVERIFY(isClosed());
    QTest::mouseClick(&bench.gauge, Qt::LeftButton);
    QVERIFY(isOpen());
    QTest::mouseClick(&bench.gauge, Qt::LeftButton);
    QVERIFY(isClosed());
    QTest::keyClick(&bench.window, Qt::Key_L, Qt::ControlModifier);
    QVERIFY(isOpen());
    QVERIFY(bench.gauge.isChecked());
    QTest::keyClick(&bench.window, Qt::Key_L, Qt::ControlModifier);
    QVERIFY(isClosed());
    for (const Qt::Key key : {Qt::Key_Space, Qt::Key_Return}) {
        bench.gauge.setFocus(Qt::TabFocusReason);
        QTest::keyClick(&bench.gauge, key);
        QVERIFY(isOpen());
        QVERIFY(!bench.session.isPlaying());
        bench.gauge.setFocus(Qt::TabFocusReason);
        QTest::keyClick(&bench.gauge, key);
        QVERIFY(isClosed());
    }
}

void StabilityPanelTest::theReasonsCloseByTheirCross()
{
    StabilityPanelBench bench;
    QTest::mouseClick(&bench.gauge, Qt::LeftButton);
    QTest::mouseClick(bench.panel.findChild<QToolButton *>("closeStability"), Qt::LeftButton);
    QVERIFY(!bench.panel.isVisible());
    QVERIFY(!bench.gauge.isChecked());
    QVERIFY(bench.isSeen<CodePanel>());
}

void StabilityPanelTest::inMeasureTheyTakeThePlaceOfAccuracy()
{
    StabilityPanelBench bench;
    bench.window.setMode(MainWindow::Mode::measure);
    QVERIFY(bench.isSeen<AccuracyPanel>());
    QTest::mouseClick(&bench.gauge, Qt::LeftButton);
    QVERIFY(bench.panel.isVisible());
    QVERIFY(!bench.isSeen<AccuracyPanel>());
    bench.window.setMode(MainWindow::Mode::learn);
    QVERIFY(!bench.panel.isVisible());
    QVERIFY(bench.isSeen<CodePanel>());
    QVERIFY(!bench.isSeen<AccuracyPanel>());
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
    StabilityPanelBench bench;
    bench.session.setParameter("k", 0.3);
    QTest::mouseClick(&bench.gauge, Qt::LeftButton);
    QVERIFY(QTest::qWaitFor([&] { return !bench.panel.remedies().empty(); }));
    bench.settle();
    QCOMPARE(nearnessOf(bench.window.stability().reading()->stability), Nearness::past);
    QPushButton *wanted = nullptr;
    for (QPushButton *button : bench.panel.remedies()) {
        if (button->text().startsWith(starts))
            wanted = button;
    }
    QVERIFY(wanted);
    QVERIFY(wanted->isVisible());
    QTest::mouseClick(wanted, Qt::LeftButton);
    bench.settle();
    QVERIFY(nearnessOf(bench.window.stability().reading()->stability) != Nearness::past);
    QVERIFY(!bench.panel.verdict().contains("grow by"));
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
    StabilityPanelBench bench("rigid_constraint", "ragdoll");
    bench.session.setParameter("iterations", 1);
    bench.session.grab("p0");
    for (int frame = 1; frame <= 12; ++frame) {
        bench.session.moveHand({270.0, 95.0 - 4.0 * frame});
        bench.session.goTo({frame, 0});
    }
    bench.session.letGo();
    bench.settle();
    QTest::mouseClick(&bench.gauge, Qt::LeftButton);
    QVERIFY(QTest::qWaitFor([&] { return !bench.panel.remedies().empty(); }));
    bench.settle();
    const auto isWanted = [&](QPushButton *button) {
        return button->text().startsWith(starts) && (starts != "Use " || button->text().endsWith("passes"));
    };
    const auto buttons = bench.panel.remedies();
    const auto wanted = std::find_if(buttons.begin(), buttons.end(), isWanted);
    QVERIFY(wanted != buttons.end());
    QVERIFY(bench.panel.verdict().contains("px too long") || bench.panel.verdict().contains("px too short"));
    const sim::StickAdvice before = *bench.window.stability().reading()->sticks;
    const auto at = static_cast<std::size_t>(wanted - buttons.begin());
    const double promised = before.remedies.at(at).stickError.value();
    QVERIFY(promised <= sim::fitting);
    const std::int64_t frame = bench.session.timeline().cursor().frame;
    QTest::mouseClick(*wanted, Qt::LeftButton);
    QTRY_COMPARE(bench.session.timeline().cursor().frame, frame);
    bench.settle();
    QCOMPARE(std::abs(bench.window.stability().reading()->sticks.value().now.error), promised);
    QVERIFY(bench.panel.verdict().contains("Sticks fit"));
    QVERIFY(bench.panel.remedies().empty());
    bench.session.undo();
    QTRY_VERIFY(bench.panel.verdict().contains("px too long"));
    bench.settle();
    QCOMPARE(bench.window.stability().reading()->sticks.value().now.error, before.now.error);
}

void StabilityPanelTest::aScreenReaderHearsGaugeAndMap()
{
    StabilityPanelBench bench;
    QAccessibleInterface *gauge = QAccessible::queryAccessibleInterface(&bench.gauge);
    QVERIFY(gauge);
    QCOMPARE(gauge->text(QAccessible::Name), "Stability");
    QCOMPARE(gauge->text(QAccessible::Value), "89\u2009% of the limit");
    QVERIFY(gauge->text(QAccessible::Description).contains("decides it"));
    QVERIFY(gauge->valueInterface());
    QCOMPARE(qRound(gauge->valueInterface()->currentValue().toDouble()), 89);
    QTest::mouseClick(&bench.gauge, Qt::LeftButton);
    QTest::mouseClick(bench.plane(0), Qt::LeftButton);
    bench.mapped();
    QAccessibleInterface *map = QAccessible::queryAccessibleInterface(&bench.panel.plot());
    QVERIFY(map);
    QVERIFY(map->text(QAccessible::Value).startsWith("You are at k 0.2"));
}

void StabilityPanelTest::noLineOfTheReasonsEndsBetweenANumberAndItsUnit()
{
    StabilityPanelBench bench;
    bench.session.setParameter("k", 0.3);
    QTest::mouseClick(&bench.gauge, Qt::LeftButton);
    bench.settle();
    int reasons = 0;
    for (const QLabel *label : bench.panel.findChildren<QLabel *>()) {
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
    StabilityPanelBench bench;
    bench.session.setParameter("k", 0.3);
    QTest::mouseClick(&bench.gauge, Qt::LeftButton);
    QVERIFY(QTest::qWaitFor([&] { return !bench.panel.remedies().empty(); }));
    for (const QAbstractButton *button : bench.panel.findChildren<QAbstractButton *>()) {
        QVERIFY2(!button->toolTip().isEmpty(), qPrintable(button->text()));
        QVERIFY(!button->text().isEmpty() || !button->accessibleName().isEmpty());
        QVERIFY(button->focusPolicy() != Qt::NoFocus);
    }
}

QTEST_MAIN(StabilityPanelTest)
#include "tst_stability_panel.moc"
