// The parameters as a whole: what they follow, resets, folding, the way of Tab.

#include "app/ui/panels/number_box.h"
#include "app/ui/panels/parameter_slider.h"
#include "panels_bench.h"

#include <QApplication>
#include <QSignalSpy>
#include <QTest>
#include <QToolButton>

using namespace app;

class ParameterPanelTest : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase() { prepareProgram(); }
    void init() { forgetProgress(); }

    void aChangeInThePastLeavesAGhostMark();
    void theRowsFollowValuesThatChangeInTime();
    void resetBringsOneParameterBack();
    void resetAllIsOnlyForChanges();
    void theRestUnfolds();
    void thePanelUnfoldsWhenThereIsRoom();
    void tabVisitsTheFieldsInOrder();
};

void ParameterPanelTest::aChangeInThePastLeavesAGhostMark()
{
    World world;
    ParameterPanel panel(world.session, world.theme);
    show(panel, {400, 192});
    const auto *slider = rowOf(panel, "damp")->findChild<ParameterSlider *>();
    for (int i = 0; i < 20; ++i)
        world.session.frameForward();
    world.session.goTo({5, 0});
    type(*rowOf(panel, "damp")->findChild<NumberBox *>(), "0.5");
    QVERIFY(world.session.timeline().comparison());
    QCOMPARE(world.session.ghostName(), QString("before: damp 0.9"));
    QCOMPARE(slider->ghost(), std::optional<double>(0.9));
    QCOMPARE(rowOf(panel, "k")->findChild<ParameterSlider *>()->ghost(), std::optional<double>());
    world.session.forgetGhost();
    QCOMPARE(slider->ghost(), std::optional<double>());
}

void ParameterPanelTest::theRowsFollowValuesThatChangeInTime()
{
    World world;
    ParameterPanel panel(world.session, world.theme);
    show(panel, {400, 192});
    world.session.frameForward();
    world.session.frameForward();
    world.session.setParameter("k", 0.6);
    world.session.frameForward();
    const auto *box = rowOf(panel, "k")->findChild<NumberBox *>();
    const auto *slider = rowOf(panel, "k")->findChild<ParameterSlider *>();
    QSignalSpy changed(&world.session, &Session::runChanged);
    QCOMPARE(box->text(), QString("0.60"));
    world.session.goTo({});
    QCOMPARE(box->text(), QString("0.20"));
    QCOMPARE(slider->value(), 20);
    world.session.goTo({3, 0});
    QCOMPARE(box->text(), QString("0.60"));
    QCOMPARE(slider->value(), 60);
    QCOMPARE(changed.count(), 0); // the panel only looked
}

void ParameterPanelTest::resetBringsOneParameterBack()
{
    World world;
    ParameterPanel panel(world.session, world.theme);
    show(panel, {400, 192});
    auto *reset = rowOf(panel, "k")->findChild<QToolButton *>("reset");
    QVERIFY(!reset->isVisible());
    world.session.setParameter("k", 0.4);
    world.session.setParameter("damp", 0.4);
    QVERIFY(reset->isVisible());
    QVERIFY(reset->width() >= 24 && reset->height() >= 24);
    QTest::mouseClick(reset, Qt::LeftButton);
    QCOMPARE(world.session.parameter("k"), 0.2);
    QCOMPARE(world.session.parameter("damp"), 0.4);
    QVERIFY(!reset->isVisible());
}

void ParameterPanelTest::resetAllIsOnlyForChanges()
{
    World world;
    ParameterPanel panel(world.session, world.theme);
    show(panel, {400, 192});
    auto *reset = panel.findChild<QToolButton *>("resetAll");
    QVERIFY(!reset->isEnabled());
    QVERIFY(reset->toolTip().contains("Nothing to reset"));
    world.session.setParameter("k", 0.4);
    world.session.setParameter("damp", 0.4);
    QVERIFY(reset->isEnabled());
    QTest::mouseClick(reset, Qt::LeftButton);
    QCOMPARE(world.session.parameter("k"), 0.2);
    QCOMPARE(world.session.parameter("damp"), 0.9);
    QVERIFY(!reset->isEnabled());
}

void ParameterPanelTest::theRestUnfolds()
{
    World world;
    world.session.openStep("two", "many");
    ParameterPanel panel(world.session, world.theme);
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
    World world;
    world.session.openStep("two", "many");
    ParameterPanel panel(world.session, world.theme);
    show(panel, {400, 500});
    QVERIFY(rowOf(panel, "radius")->isVisible());
    panel.resize(400, 200);
    QTRY_VERIFY(!rowOf(panel, "radius")->isVisible());
}

void ParameterPanelTest::tabVisitsTheFieldsInOrder()
{
    World world;
    world.session.setParameter("k", 0.4);
    ParameterPanel panel(world.session, world.theme);
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

QTEST_MAIN(ParameterPanelTest)

#include "tst_parameter_panel.moc"
