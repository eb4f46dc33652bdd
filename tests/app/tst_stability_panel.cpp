// The gauge and its reasons, in the window, driven as a learner drives them.

#include "app/ui/code/code_panel.h"
#include "app/ui/measure/accuracy_panel.h"
#include "app/ui/stability/growth_plot.h"
#include "app/ui/stability/stability_gauge.h"
#include "app/ui/stability/stability_panel.h"
#include "app/ui/window/main_window.h"

#include <QAccessible>
#include <QPushButton>
#include <QSettings>
#include <QStandardPaths>
#include <QStatusBar>
#include <QTemporaryDir>
#include <QToolButton>
#include <QtTest>

using namespace app;

namespace {

/// In place of a study that takes seconds.
sim::Accuracy noStudy(const sim::Script &, const sim::StudyPlan &, const sim::StudyProgress &)
{
    return {};
}

struct Bench
{
    LessonLibrary library = LessonLibrary::load({LESSON_DIR});
    Theme theme{Scheme::light};
    Session session{library};
    MainWindow window{session, theme, noStudy};
    StabilityGauge &gauge = *window.findChild<StabilityGauge *>();
    StabilityPanel &panel = *window.findChild<StabilityPanel *>();

    explicit Bench(const char *lesson = "two_body", const char *step = "mutual")
    {
        theme.apply(*qApp);
        session.openStep(lesson, step);
        window.resize(1280, 800);
        window.show();
        QApplication::setActiveWindow(&window);
        settle();
    }
    void settle()
    {
        if (!QTest::qWaitFor([&] { return window.stability().reading() && window.stability().isCurrent(); },
                             20'000))
            qFatal("no reading");
        QCoreApplication::processEvents();
    }
    void mapped()
    {
        const auto whole = std::size_t(StabilityWatch::columns) * StabilityWatch::rows;
        if (!QTest::qWaitFor(
                [&] {
                    const StabilityWatch &watch = window.stability();
                    return !watch.isMapping() && watch.map() && watch.map()->growth.size() == whole;
                },
                60'000))
            qFatal("no map");
        QCoreApplication::processEvents();
    }
    QToolButton *plane(int index) const
    {
        QList<QToolButton *> buttons;
        for (QToolButton *button : panel.findChildren<QToolButton *>("tab"))
            buttons << button;
        return buttons.at(index);
    }
    template <class Widget>
    bool isSeen() const
    {
        return window.findChild<Widget *>()->isVisible();
    }
};

QColor colourAt(QWidget &widget, QPointF place)
{
    const QImage image = widget.grab().toImage();
    return image.pixelColor((place * image.devicePixelRatio()).toPoint());
}

bool isNear(const QColor &a, const QColor &b)
{
    return std::abs(a.red() - b.red()) + std::abs(a.green() - b.green()) + std::abs(a.blue() - b.blue()) < 30;
}

}

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
    void inMeasureTheyTakeThePlaceOfAccuracy();
    void oneClickOnARemedyMends_data();
    void oneClickOnARemedyMends();
    void theMapIsDrawnOnRequest();
    void theMapShowsWhereTheLearnerIsAndWas();
    void theMapTellsWhatIsUnderThePointer();
    void whereThereIsNoMapItSaysSo();
    void aScreenReaderHearsGaugeAndMap();
    void everyControlHasATip();
    void theWindowMayCloseWhileTheMapIsOpen();
};

void StabilityPanelTest::initTestCase()
{
    QStandardPaths::setTestModeEnabled(true);
    static const QTemporaryDir settings;
    QSettings::setDefaultFormat(QSettings::IniFormat);
    QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, settings.path());
    QCoreApplication::setOrganizationName("springstep-tests");
}

void StabilityPanelTest::theGaugeStandsInTheStatusBar()
{
    Bench bench;
    QVERIFY(bench.gauge.isVisible());
    QCOMPARE(bench.gauge.parentWidget(), bench.window.statusBar());
    QCOMPARE(bench.gauge.words(), "89\u2009% of the limit");
    QVERIFY(bench.window.statusBar()->rect().contains(bench.gauge.geometry()));
    QVERIFY(bench.gauge.toolTip().contains("decides it"));
}

void StabilityPanelTest::theBarPassesItsTickWhenTheLimitIsPassed()
{
    Bench bench;
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
    Bench bench;
    bench.session.setMethod("backward_euler");
    bench.settle();
    QCOMPARE(bench.gauge.words(), "no limit");
    QCOMPARE(bench.gauge.filled(), 0.0);
}

void StabilityPanelTest::clickAndKeysOpenTheReasonsInPlaceOfTheCode()
{
    Bench bench;
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
    Bench bench;
    QTest::mouseClick(&bench.gauge, Qt::LeftButton);
    QTest::mouseClick(bench.panel.findChild<QToolButton *>("closeStability"), Qt::LeftButton);
    QVERIFY(!bench.panel.isVisible());
    QVERIFY(!bench.gauge.isChecked());
    QVERIFY(bench.isSeen<CodePanel>());
}

void StabilityPanelTest::inMeasureTheyTakeThePlaceOfAccuracy()
{
    Bench bench;
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
    Bench bench;
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

void StabilityPanelTest::theMapIsDrawnOnRequest()
{
    Bench bench;
    QTest::mouseClick(&bench.gauge, Qt::LeftButton);
    bench.settle();
    GrowthPlot &plot = bench.panel.plot();
    QVERIFY(!plot.isVisible());
    QVERIFY(!bench.window.stability().isMapping());
    QTest::mouseClick(bench.plane(0), Qt::LeftButton);
    bench.mapped();
    QVERIFY(plot.isVisible());
    // At k = 0.02 all steps up to 4 frames hold; at k = 9 one of 2 frames does not.
    QVERIFY(isNear(colourAt(plot, plot.onScreen({0.02, 0.9, 0.1})), bench.theme.tokens().scene));
    QVERIFY(!isNear(colourAt(plot, plot.onScreen({9.0, 0.9, 2.0})), bench.theme.tokens().scene));
    QTest::mouseClick(bench.plane(1), Qt::LeftButton);
    bench.mapped();
    QCOMPARE(bench.window.stability().map()->y.parameter, "damp");
    QVERIFY(!bench.plane(0)->isChecked());
    QTest::mouseClick(bench.plane(1), Qt::LeftButton);
    QVERIFY(!plot.isVisible());
    QVERIFY(!bench.window.stability().map());
}

void StabilityPanelTest::theMapShowsWhereTheLearnerIsAndWas()
{
    Bench bench;
    QTest::mouseClick(&bench.gauge, Qt::LeftButton);
    QTest::mouseClick(bench.plane(1), Qt::LeftButton);
    bench.mapped();
    GrowthPlot &plot = bench.panel.plot();
    const QPointF first = plot.onScreen(bench.window.stability().tried().back());
    QVERIFY(isNear(colourAt(plot, first), bench.theme.tokens().now));
    bench.session.setParameter("k", 0.02);
    bench.session.setParameter("damp", 0.4);
    const QPointF here = plot.onScreen(bench.window.stability().tried().back());
    QVERIFY(here.x() < first.x() && here.y() > first.y());
    QVERIFY(isNear(colourAt(plot, here), bench.theme.tokens().now));
    QVERIFY(!isNear(colourAt(plot, first), bench.theme.tokens().now));
    // The way between: down along k = 0.02.
    bool drawn = false;
    for (const double beside : {-1.0, 0.0, 1.0}) {
        const QPointF between(here.x() + beside, 0.5 * (first.y() + here.y()));
        drawn = drawn || isNear(colourAt(plot, between), bench.theme.tokens().ink);
    }
    QVERIFY(drawn);
}

void StabilityPanelTest::theMapTellsWhatIsUnderThePointer()
{
    Bench bench;
    QTest::mouseClick(&bench.gauge, Qt::LeftButton);
    QTest::mouseClick(bench.plane(1), Qt::LeftButton);
    bench.mapped();
    GrowthPlot &plot = bench.panel.plot();
    QVERIFY(plot.wordsAt(plot.onScreen({0.05, 0.5, 1.0})).contains("it holds"));
    QVERIFY(plot.wordsAt(plot.onScreen({5.0, 0.9, 1.0})).contains("times a frame"));
    QVERIFY(plot.wordsAt({1.0, 1.0}).isEmpty());
    QVERIFY2(plot.sentence().contains("it holds"), qPrintable(plot.sentence()));
}

void StabilityPanelTest::whereThereIsNoMapItSaysSo()
{
    Bench bench("rigid_constraint", "list");
    QTest::mouseClick(&bench.gauge, Qt::LeftButton);
    bench.settle();
    QVERIFY(!bench.plane(0)->isEnabled());
    bool said = false;
    for (const QLabel *label : bench.panel.findChildren<QLabel *>("caption"))
        said = said || (label->isVisible() && label->text().startsWith("There is no map"));
    QVERIFY(said);
    QVERIFY(bench.panel.leftOut().contains("sticks"));
}

void StabilityPanelTest::aScreenReaderHearsGaugeAndMap()
{
    Bench bench;
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

void StabilityPanelTest::everyControlHasATip()
{
    Bench bench;
    bench.session.setParameter("k", 0.3);
    QTest::mouseClick(&bench.gauge, Qt::LeftButton);
    QVERIFY(QTest::qWaitFor([&] { return !bench.panel.remedies().empty(); }));
    for (const QAbstractButton *button : bench.panel.findChildren<QAbstractButton *>()) {
        QVERIFY2(!button->toolTip().isEmpty(), qPrintable(button->text()));
        QVERIFY(!button->text().isEmpty() || !button->accessibleName().isEmpty());
        QVERIFY(button->focusPolicy() != Qt::NoFocus);
    }
}

void StabilityPanelTest::theWindowMayCloseWhileTheMapIsOpen()
{
    Bench bench;
    bench.session.setParameter("k", 0.3);
    QTest::mouseClick(&bench.gauge, Qt::LeftButton);
    QVERIFY(QTest::qWaitFor([&] { return !bench.panel.remedies().empty(); }));
    QTest::mouseClick(bench.plane(0), Qt::LeftButton); // under way when the window goes
    bench.window.close();
    QCoreApplication::processEvents();
    QVERIFY(!bench.window.stability().isMapping());
}

QTEST_MAIN(StabilityPanelTest)
#include "tst_stability_panel.moc"
