// The learner's choices of appearance, and their restoration at the next start.

#include "app/ui/scene/scene_view.h"
#include "app/ui/settings/size_menu.h"
#include "tests/app/window/keyboard_support.h"
#include "tests/suite.h"

#include <QMenu>
#include <QSettings>
#include <QTest>

#include <algorithm>
#include <cmath>

using namespace app;
using keyboard_support::LargeWindow;
using namespace tests;

class AppearanceTest : public QObject
{
    Q_OBJECT

private slots:
    void init() { QSettings().clear(); }
    void theColoursChosenAreThereAtTheNextStart_data();
    void theColoursChosenAreThereAtTheNextStart();
    void textHasItsContrast_data();
    void textHasItsContrast();
    void theSizeChosenHoldsFromTheNextStartOn();
    void theChoiceOfDrawingsIsRemembered();
    void lessMotionStopsWhatOnlyDecorates();
};

void AppearanceTest::theColoursChosenAreThereAtTheNextStart_data()
{
    QTest::addColumn<Qt::Key>("key");
    QTest::addColumn<Scheme>("scheme");
    QTest::newRow("dark") << Qt::Key_D << Scheme::dark;
    QTest::newRow("high contrast") << Qt::Key_H << Scheme::highContrast;
}

void AppearanceTest::theColoursChosenAreThereAtTheNextStart()
{
    QFETCH(const Qt::Key, key);
    QFETCH(const Scheme, scheme);
    {
        LargeWindow fixture;
        QCOMPARE(fixture.theme.scheme(), Scheme::light);
        QTest::keyClick(&fixture.window, key, Qt::ControlModifier | Qt::ShiftModifier);
        QCOMPARE(fixture.theme.scheme(), scheme);
    }
    QCOMPARE(storedScheme(), scheme);
    LargeWindow again;
    QCOMPARE(again.theme.scheme(), scheme);
    QTest::keyClick(&again.window, key, Qt::ControlModifier | Qt::ShiftModifier);
    QCOMPARE(storedScheme(), Scheme::light);
}

namespace {

/// Relative luminance and contrast as in WCAG 2.1.
double luminance(const QColor &color)
{
    const auto part = [](double c) { return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); };
    return 0.2126 * part(color.redF()) + 0.7152 * part(color.greenF()) + 0.0722 * part(color.blueF());
}

double contrast(const QColor &one, const QColor &other)
{
    const double a = luminance(one);
    const double b = luminance(other);
    return (std::max(a, b) + 0.05) / (std::min(a, b) + 0.05);
}

}

void AppearanceTest::textHasItsContrast_data()
{
    QTest::addColumn<Scheme>("scheme");
    QTest::addColumn<double>("least");
    QTest::newRow("light") << Scheme::light << 4.5;
    QTest::newRow("dark") << Scheme::dark << 4.5;
    QTest::newRow("high contrast") << Scheme::highContrast << 7.0;
}

void AppearanceTest::textHasItsContrast()
{
    QFETCH(const Scheme, scheme);
    QFETCH(const double, least);
    const Tokens t = Theme(scheme).tokens();
    for (const QColor &text : {t.ink, t.ink2, t.ink3, t.link, t.past}) {
        for (const QColor &ground : {t.win, t.panel, t.scene})
            QVERIFY2(contrast(text, ground) >= least, qPrintable(text.name() + " on " + ground.name()));
    }
    QVERIFY(contrast(t.onSunk, t.sunk) >= least);
    QVERIFY(contrast(t.ink, t.hover) >= least);
    QVERIFY(contrast(t.buttonText, t.button) >= least);
    QVERIFY(contrast(t.nowText, t.now) >= 4.5);
    for (const QColor &mark :
         {t.near, t.ok, t.spring, t.gravity, t.damping, t.contact, t.driver, t.wind, t.stick})
        QVERIFY2(contrast(mark, t.panel) >= 3.0, qPrintable(mark.name()));
}

void AppearanceTest::theSizeChosenHoldsFromTheNextStartOn()
{
    QCOMPARE(storedSize(), 100);
    {
        LargeWindow fixture;
        fixture.actionCalled("150\u2009%").trigger();
    }
    QCOMPARE(storedSize(), 150);
    QVERIFY(hasRoomFor(200, {1920, 1080}));
    QVERIFY(hasRoomFor(150, {1280, 800}) && !hasRoomFor(175, {1280, 800}));
    QVERIFY(hasRoomFor(100, {640, 480}));
    QSettings().setValue("window/size", 17); // written by somebody else
    QCOMPARE(storedSize(), 100);
}

void AppearanceTest::theChoiceOfDrawingsIsRemembered()
{
    const auto grid = [](const LargeWindow &fixture) {
        return fixture.window.findChild<SceneView *>()->extras().grid;
    };
    {
        LargeWindow fixture;
        QVERIFY(grid(fixture));
        for (QAction *one : fixture.window.findChildren<QAction *>()) {
            if (one->data().toString() == "grid")
                one->trigger();
        }
        QVERIFY(!grid(fixture));
    }
    const LargeWindow again;
    QVERIFY(!grid(again));
    QVERIFY(again.window.findChild<SceneView *>()->extras().trails);
}

void AppearanceTest::lessMotionStopsWhatOnlyDecorates()
{
    // A part of the picture that shows only wind, at one moment and ten frames later.
    const auto moves = [](LargeWindow &fixture) {
        auto *view = fixture.window.findChild<SceneView *>();
        view->zoomTo100(); // else the picture makes room for the tree, which the wind bends
        QTest::mousePress(view->viewport(), Qt::LeftButton, {}, {150, 300});
        fixture.session.playback().goTo({fixture.session.timeline().cursor().frame + 1, 0});
        const auto look = [view] { return view->viewport()->grab(QRect(0, 150, 260, 300)).toImage(); };
        const QImage before = look();
        fixture.session.playback().goTo({fixture.session.timeline().cursor().frame + 10, 0});
        const bool differs = look() != before;
        QTest::mouseRelease(view->viewport(), Qt::LeftButton, {}, {150, 300});
        return differs;
    };
    {
        LargeWindow fixture("swaying_tree", "wind");
        QVERIFY(fixture.window.isAnimated());
        QVERIFY(moves(fixture));
        fixture.action("lessMotion").trigger();
        QVERIFY(!fixture.window.isAnimated());
        QVERIFY(!QApplication::isEffectEnabled(Qt::UI_AnimateMenu));
        QVERIFY(!moves(fixture));
    }
    LargeWindow again("swaying_tree", "wind");
    QVERIFY(!again.window.isAnimated());
    QVERIFY(!moves(again));
    again.action("lessMotion").trigger();
    QVERIFY(moves(again));
}

SUITE(tst_appearance, AppearanceTest)
#include "tst_appearance.moc"
