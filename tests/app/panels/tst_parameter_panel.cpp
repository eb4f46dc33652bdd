// The parameter panel: updates, resets, folding and the tab order.

#include "app/ui/parameters/number_box.h"
#include "app/ui/parameters/parameter_slider.h"
#include "tests/app/support/panel_fixture.h"
#include "tests/suite.h"

#include <QApplication>
#include <QSettings>
#include <QSignalSpy>
#include <QTest>
#include <QToolButton>

using namespace app;
using namespace tests;

class ParameterPanelTest : public QObject
{
    Q_OBJECT

private slots:
    void init() { QSettings().clear(); }

    void aChangeInThePastLeavesAGhostMark();
    void theNameOfAGhostHasAllFiguresOfALargeNumber();
    void theRowsFollowValuesThatChangeInTime();
    void resetBringsOneParameterBack();
    void resetAllIsOnlyForChanges();
    void theRestUnfolds();
    void thePanelUnfoldsWhenThereIsRoom();
    void automaticUnfoldingDoesNotChangeTheSizeHint();
    void tabVisitsTheFieldsInOrder();
};

void ParameterPanelTest::aChangeInThePastLeavesAGhostMark()
{
    PanelFixture<ParameterPanel> fixture({400, 192});
    const auto *slider = rowOf(fixture.panel, "damp")->findChild<ParameterSlider *>();
    for (int i = 0; i < 20; ++i)
        fixture.session.playback().frameForward();
    fixture.goTo(5);
    typeInto(*rowOf(fixture.panel, "damp")->findChild<NumberBox *>(), "0.5");
    QVERIFY(fixture.session.timeline().comparison());
    QCOMPARE(fixture.session.comparisons().comparisonName(), QString("before: damping 0.9"));
    QCOMPARE(slider->comparison(), std::optional<double>(0.9));
    QCOMPARE(rowOf(fixture.panel, "k")->findChild<ParameterSlider *>()->comparison(),
             std::optional<double>());
    fixture.session.comparisons().removeShown();
    QCOMPARE(slider->comparison(), std::optional<double>());
}

void ParameterPanelTest::theNameOfAGhostHasAllFiguresOfALargeNumber()
{
    PanelFixture<ParameterPanel> fixture({400, 192});
    fixture.session.editor().setParameter("k", 1e6);
    for (int i = 0; i < 5; ++i)
        fixture.session.playback().frameForward();
    fixture.goTo(2);
    fixture.session.editor().setParameter("k", 0.2);
    QCOMPARE(fixture.session.comparisons().comparisonName(), QString("before: stiffness 1000000"));
}

void ParameterPanelTest::theRowsFollowValuesThatChangeInTime()
{
    PanelFixture<ParameterPanel> fixture({400, 192});
    fixture.session.playback().frameForward();
    fixture.session.playback().frameForward();
    fixture.session.editor().setParameter("k", 0.6);
    fixture.session.playback().frameForward();
    const auto *box = rowOf(fixture.panel, "k")->findChild<NumberBox *>();
    const auto *slider = rowOf(fixture.panel, "k")->findChild<ParameterSlider *>();
    int changes = 0;
    fixture.session.onChange(ChangeKind::run, this, [&] { ++changes; });
    QCOMPARE(box->text(), QString("0.60"));
    fixture.session.playback().goTo({});
    QCOMPARE(box->text(), QString("0.20"));
    QCOMPARE(slider->value(), 20);
    fixture.goTo(3);
    QCOMPARE(box->text(), QString("0.60"));
    QCOMPARE(slider->value(), 60);
    QCOMPARE(changes, 0); // the panel edits nothing
}

void ParameterPanelTest::resetBringsOneParameterBack()
{
    PanelFixture<ParameterPanel> fixture({400, 192});
    auto *reset = rowOf(fixture.panel, "k")->findChild<QToolButton *>("reset");
    QVERIFY(!reset->isVisible());
    fixture.session.editor().setParameter("k", 0.4);
    fixture.session.editor().setParameter("damp", 0.4);
    QVERIFY(reset->isVisible());
    QVERIFY(reset->width() >= 24 && reset->height() >= 24);
    QTest::mouseClick(reset, Qt::LeftButton);
    QCOMPARE(fixture.session.editor().parameter("k"), 0.2);
    QCOMPARE(fixture.session.editor().parameter("damp"), 0.4);
    QVERIFY(!reset->isVisible());
}

void ParameterPanelTest::resetAllIsOnlyForChanges()
{
    PanelFixture<ParameterPanel> fixture({400, 192});
    auto *reset = fixture.panel.findChild<QToolButton *>("resetAll");
    QVERIFY(!reset->isEnabled());
    QVERIFY(reset->toolTip().contains("Nothing to reset"));
    fixture.session.editor().setParameter("k", 0.4);
    fixture.session.editor().setParameter("damp", 0.4);
    QVERIFY(reset->isEnabled());
    QTest::mouseClick(reset, Qt::LeftButton);
    QCOMPARE(fixture.session.editor().parameter("k"), 0.2);
    QCOMPARE(fixture.session.editor().parameter("damp"), 0.9);
    QVERIFY(!reset->isEnabled());
}

void ParameterPanelTest::theRestUnfolds()
{
    SessionFixture world;
    world.session.openStep("two", "many");
    ParameterPanel panel(world.session.run(), world.session.editor(), world.session.playback(), world.theme);
    show(panel, {400, panel.sizeHint().height()});
    auto *more = panel.findChild<QToolButton *>("disclosure");
    QCOMPARE(more->text(), QString("Offset, radius"));
    QVERIFY(rowOf(panel, "feet")->isVisible());
    QVERIFY(!rowOf(panel, "radius")->isVisible());
    const int folded = panel.sizeHint().height();
    QTest::mouseClick(more, Qt::LeftButton);
    QVERIFY(rowOf(panel, "radius")->isVisible());
    QCOMPARE(panel.sizeHint().height(), folded + 2 * 36);
    more->setFocus(Qt::TabFocusReason);
    QTest::keyClick(more, Qt::Key_Space);
    QVERIFY(!rowOf(panel, "radius")->isVisible());
}

void ParameterPanelTest::thePanelUnfoldsWhenThereIsRoom()
{
    SessionFixture world;
    world.session.openStep("two", "many");
    ParameterPanel panel(world.session.run(), world.session.editor(), world.session.playback(), world.theme);
    show(panel, {400, 500});
    QVERIFY(rowOf(panel, "radius")->isVisible());
    panel.resize(400, 200);
    QTRY_VERIFY(!rowOf(panel, "radius")->isVisible());
}

void ParameterPanelTest::automaticUnfoldingDoesNotChangeTheSizeHint()
{
    SessionFixture world;
    world.session.openStep("two", "many");
    ParameterPanel panel(world.session.run(), world.session.editor(), world.session.playback(), world.theme);
    const int folded = panel.sizeHint().height();
    show(panel, {400, 500});
    QVERIFY(rowOf(panel, "radius")->isVisible());
    QCOMPARE(panel.sizeHint().height(), folded);
}

void ParameterPanelTest::tabVisitsTheFieldsInOrder()
{
    SessionFixture world;
    world.session.editor().setParameter("k", 0.4);
    ParameterPanel panel(world.session.run(), world.session.editor(), world.session.playback(), world.theme);
    show(panel, {400, 192});
    const QList<QWidget *> order = {panel.findChild<QToolButton *>("resetAll"),
                                    rowOf(panel, "k")->findChild<ParameterSlider *>(),
                                    rowOf(panel, "k")->findChild<NumberBox *>(),
                                    rowOf(panel, "k")->findChild<QToolButton *>("reset"),
                                    rowOf(panel, "damp")->findChild<ParameterSlider *>(),
                                    rowOf(panel, "damp")->findChild<NumberBox *>()};
    order.front()->setFocus(Qt::TabFocusReason);
    for (int i = 1; i < order.size(); ++i) {
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
        QCOMPARE(QApplication::focusWidget(), order[i]);
    }
}

SUITE(tst_parameter_panel, ParameterPanelTest)

#include "tst_parameter_panel.moc"
