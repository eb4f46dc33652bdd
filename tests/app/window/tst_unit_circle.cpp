// The unit circle over the scene: its numbers, and when it is shown.

#include "app/ui/scene/hud/unit_circle.h"
#include "tests/app/support/window_fixture.h"
#include "tests/suite.h"

#include <QLocale>
#include <QRandomGenerator>
#include <QSettings>
#include <QTest>

#include <algorithm>
#include <cmath>

using namespace app;
using namespace tests;

namespace {

/// The window on a step with an angle.
class CircleWindow : public WindowFixture
{
public:
    explicit CircleWindow(const QString &step = "radial", QSize size = {1280, 800})
        : WindowFixture({.lesson = "single_spring", .step = step, .size = size})
    {
    }

    UnitCircle &circle() const { return part<UnitCircle>(); }
    sim::Vec2 place(const char *body) const
    {
        const Picture picture = session.presentation().picture();
        return picture.state.positionOf(picture.interval->scene.find(body));
    }
};

}

class UnitCircleTest : public QObject
{
    Q_OBJECT

private slots:
    void init() { QSettings().clear(); }

    void numbersAreThoseOfTheAngle_data();
    void numbersAreThoseOfTheAngle();
    void cosineAndSineMatchRandomPositions();
    void circleFollowsDragsAndTheRun();
    void anArrowWithoutLengthHasNoDirection();
    void aBranchHasAnAngle();
    void circleIsShownOnlyInStepsWithAnAngle();
    void theKeySwitchesItAndTheChoiceIsRemembered();
    void eachChangePaintsItOnce();
    void circleAvoidsBodies();
    void circleCoversNoLegend();
    void circleIsHiddenWhereItWouldHideTheWholeFigure();
    void screenReadersGetTheNumbers();
};

void UnitCircleTest::numbersAreThoseOfTheAngle_data()
{
    QTest::addColumn<QPointF>("vector");
    QTest::addColumn<double>("degrees");
    QTest::addColumn<double>("cosine");
    QTest::addColumn<double>("sine");
    const double half = std::sqrt(0.5);
    QTest::newRow("right") << QPointF(50, 0) << 0.0 << 1.0 << 0.0;
    QTest::newRow("down: y points down") << QPointF(0, 50) << 90.0 << 0.0 << 1.0;
    QTest::newRow("up") << QPointF(0, -50) << -90.0 << 0.0 << -1.0;
    QTest::newRow("left") << QPointF(-50, 0) << 180.0 << -1.0 << 0.0;
    QTest::newRow("3, 4, 5") << QPointF(40, 30) << 36.86989764584402 << 0.8 << 0.6;
    QTest::newRow("up to the left") << QPointF(-7, -7) << -135.0 << -half << -half;
}

void UnitCircleTest::numbersAreThoseOfTheAngle()
{
    QFETCH(const QPointF, vector);
    QFETCH(const double, degrees);
    QFETCH(const double, cosine);
    QFETCH(const double, sine);
    const ArrowAngle arrow{{270, 200}, {270 + vector.x(), 200 + vector.y()}};
    QVERIFY(std::abs(arrow.angle() * 180.0 / M_PI - degrees) < 1e-12);
    QVERIFY(std::abs(arrow.cosine() - cosine) < 1e-15);
    QVERIFY(std::abs(arrow.sine() - sine) < 1e-15);
}

void UnitCircleTest::cosineAndSineMatchRandomPositions()
{
    CircleWindow fixture;
    fixture.session.playback().play();
    QRandomGenerator random(7);
    const QPoint foot = fixture.onScreen("foot");
    QTest::mousePress(fixture.view.viewport(), Qt::LeftButton, {}, foot);
    for (int i = 0; i < 50; ++i) {
        const QPoint to =
            fixture.onScreen("body") + QPoint(random.bounded(-150, 150), random.bounded(-150, 150));
        moveMouse(*fixture.view.viewport(), to, Qt::LeftButton);
        const sim::Vec2 from = fixture.place("body"), end = fixture.place("foot");
        const double angle = std::atan2(end.y - from.y, end.x - from.x);
        if (end == from)
            continue;
        QVERIFY(fixture.circle().arrow());
        QVERIFY(std::abs(fixture.circle().arrow()->cosine() - std::cos(angle)) < 1e-12);
        QVERIFY(std::abs(fixture.circle().arrow()->sine() - std::sin(angle)) < 1e-12);
        const auto shown = [](double value, int decimals) {
            QString text = QLocale().toString(std::abs(value) < 0.5 * std::pow(10.0, -decimals) ? 0.0 : value,
                                              'f', decimals);
            return text.replace('-', QChar(0x2212));
        };
        const QStringList lines = fixture.circle().lines();
        QVERIFY2(lines[1].endsWith("= " + shown(std::cos(angle), 3)), qPrintable(lines[1]));
        QVERIFY2(lines[3].endsWith("= " + shown(std::sin(angle), 3)), qPrintable(lines[3]));
        QVERIFY2(lines[0].contains(shown(angle, 3)), qPrintable(lines[0]));
    }
    QTest::mouseRelease(fixture.view.viewport(), Qt::LeftButton, {}, foot);
}

void UnitCircleTest::circleFollowsDragsAndTheRun()
{
    CircleWindow fixture;
    QVERIFY(fixture.circle().isVisible());
    const auto isTrue = [&] {
        return fixture.circle().arrow() && fixture.circle().arrow()->from == fixture.place("body") &&
               fixture.circle().arrow()->to == fixture.place("foot");
    };
    QVERIFY(isTrue());
    const ArrowAngle before = *fixture.circle().arrow();
    fixture.key(Qt::Key_Right);
    QVERIFY(isTrue());
    QVERIFY(*fixture.circle().arrow() != before);
    fixture.goTo(40);
    QVERIFY(isTrue());
    fixture.drag("foot", {20, 30});
    QVERIFY(isTrue());
}

void UnitCircleTest::anArrowWithoutLengthHasNoDirection()
{
    const ArrowAngle arrow{{3, 4}, {3, 4}};
    QCOMPARE(arrow.angle(), 0.0);
    QCOMPARE(arrow.cosine(), 1.0);
    QCOMPARE(arrow.sine(), 0.0);
}

void UnitCircleTest::aBranchHasAnAngle()
{
    WindowFixture fixture({.lesson = "swaying_tree", .step = "trunk"});
    const auto &circle = fixture.part<UnitCircle>();
    QVERIFY(circle.isVisible());
    QVERIFY(std::abs(circle.arrow()->angle() + M_PI / 2) < 1e-9);
    QVERIFY(std::abs(circle.arrow()->cosine()) < 1e-9);
    QVERIFY(std::abs(circle.arrow()->sine() + 1.0) < 1e-9);
}

void UnitCircleTest::circleIsShownOnlyInStepsWithAnAngle()
{
    CircleWindow fixture("offset");
    QVERIFY(!fixture.circle().isVisible());
    QVERIFY(fixture.circle().lines().isEmpty());
    QVERIFY(fixture.view.shown().card.isEmpty());
    QVERIFY(!fixture.action("unitCircle").isEnabled());
    QVERIFY(!fixture.action("unitCircle").isChecked()); // and yet the choice is kept
    fixture.session.openStep("single_spring", "radial");
    QVERIFY(fixture.circle().isVisible());
    QVERIFY(fixture.action("unitCircle").isEnabled());
    QVERIFY(fixture.action("unitCircle").isChecked());
    QCOMPARE(fixture.view.shown().card, QRectF(fixture.circle().geometry()));
    fixture.session.openStep("single_spring", "drag");
    QVERIFY(!fixture.circle().isVisible());
    QVERIFY(!fixture.action("unitCircle").isChecked());
    QVERIFY(fixture.view.extras().unitCircle);
}

void UnitCircleTest::theKeySwitchesItAndTheChoiceIsRemembered()
{
    {
        CircleWindow fixture;
        const QImage shown = fixture.view.picture();
        QVERIFY(fixture.action("unitCircle").isChecked());
        fixture.key(Qt::Key_U);
        QVERIFY(!fixture.circle().isVisible());
        QVERIFY(!fixture.action("unitCircle").isChecked());
        QVERIFY(fixture.view.picture() != shown); // the triangle goes, too
    }
    {
        CircleWindow fixture;
        QVERIFY(!fixture.circle().isVisible());
        fixture.key(Qt::Key_U);
        QVERIFY(fixture.circle().isVisible());
    }
    QVERIFY(CircleWindow().circle().isVisible());
}

void UnitCircleTest::eachChangePaintsItOnce()
{
    CircleWindow fixture;
    settle();
    PaintCounter paints(fixture.circle());
    fixture.key(Qt::Key_Right);
    settle();
    QCOMPARE(paints.count, 1);
    fixture.session.openStep("single_spring", "offset");
    settle();
    QCOMPARE(paints.count, 1);
}

void UnitCircleTest::circleAvoidsBodies()
{
    CircleWindow fixture;
    const auto isCovered = [&](const char *body) {
        return fixture.circle().geometry().contains(fixture.onScreen(body));
    };
    QVERIFY(!isCovered("foot") && !isCovered("body"));
    const QPoint corner = fixture.circle().geometry().center();
    fixture.drag("foot", corner - fixture.onScreen("foot"));
    QVERIFY(!isCovered("foot") && !isCovered("body"));
    QVERIFY(fixture.circle().isVisible());
}

void UnitCircleTest::circleCoversNoLegend()
{
    QSettings().setValue("code/page", "engine");
    WindowFixture fixture({.lesson = "walking_gait", .step = "bones", .size = {1280, 800}});
    const auto &circle = fixture.part<UnitCircle>();
    const auto isBelow = [&] { return circle.geometry().top() > fixture.view.height() / 2; };
    const QPoint top(fixture.view.width() / 2, 80);
    fixture.drag("body", top - fixture.onScreen("body"));
    QVERIFY(isBelow());
    fixture.key(Qt::Key_Home);
    fixture.key(Qt::Key_Right, Qt::ShiftModifier);
    int rows = 0;
    for (int width = fixture.view.width(); width > 480; width -= 10) {
        fixture.view.resize(width, fixture.view.height());
        const QRectF legend = fixture.view.legendBox();
        rows = std::max(rows, static_cast<int>(legend.height() / 20.0));
        QVERIFY2(!circle.isVisible() || !legend.intersects(QRectF(circle.geometry())),
                 qPrintable(QString::number(width)));
    }
    QCOMPARE(rows, 2); // in narrow views
}

void UnitCircleTest::circleIsHiddenWhereItWouldHideTheWholeFigure()
{
    CircleWindow fixture;
    QVERIFY(fixture.circle().isVisible());
    fixture.key(Qt::Key_3, Qt::ControlModifier); // energy, below the scene
    QTRY_VERIFY(fixture.view.height() < 2 * fixture.circle().height());
    QTRY_VERIFY(!fixture.circle().isVisible());
    fixture.key(Qt::Key_3, Qt::ControlModifier);
    QTRY_VERIFY(fixture.circle().isVisible());
}

void UnitCircleTest::screenReadersGetTheNumbers()
{
    CircleWindow fixture;
    QCOMPARE(fixture.circle().accessibleName(), QString("Unit circle"));
    QCOMPARE(fixture.circle().accessibleDescription(), fixture.circle().lines().join(". "));
    QVERIFY(fixture.circle().accessibleDescription().contains("cosine = 30.0 / 42.4 = 0.707"));
}

SUITE(tst_unit_circle, UnitCircleTest)
#include "tst_unit_circle.moc"
