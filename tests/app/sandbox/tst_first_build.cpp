// The guided first build: a creature that walks, with the mouse and with keys alone.

#include "app/model/sandbox/build_guide.h"
#include "app/model/sandbox/sandbox.h"
#include "app/ui/sandbox/guide_box.h"
#include "app/ui/sandbox/guide_ring.h"
#include "tests/app/sandbox/sandbox_support.h"
#include "tests/suite.h"

#include <QScrollBar>

using namespace app;
using namespace tests;
using namespace sandbox_support;

namespace {

struct Guided : SandboxFixture
{
    explicit Guided(QSize size = {1280, 800}) : SandboxFixture(size)
    {
        build();
        QTest::mouseClick(button("First build: a walker"), Qt::LeftButton);
    }

    BuildGuide &guide() const { return *window.findChild<BuildGuide *>(); }
    BuildGuide::Step step() const { return guide().step(); }
    QString said() const { return panel().guideBox().text(); }
    QToolButton *tool(const QString &name) const
    {
        for (QToolButton *one : panel().findChildren<QToolButton *>("tool")) {
            if (one->text() == name)
                return one;
        }
        return nullptr;
    }
    /// Checks that the ring is round this widget, and clicks it.
    void clickHighlighted(QWidget *expected) const
    {
        QVERIFY(ring() && ring()->widget() == expected);
        QTRY_VERIFY(expected->isVisible() && !expected->visibleRegion().isEmpty());
        QTest::mouseClick(expected, Qt::LeftButton, {}, QPoint(12, expected->height() / 2));
    }
    /// It may be the child of any widget in the window.
    GuideRing *ring() const { return window.findChild<GuideRing *>("guideRing"); }
    sim::Vec2 body() { return session.timeline().state().positionOf(0); }

    /// The feet that the guide asks for, with the mouse.
    void giveFeet()
    {
        clickHighlighted(tool("Foot"));
        click(plan().points[0].x);
        for (int foot = 0; foot < 2; ++foot) {
            QVERIFY(guide().place());
            click(*guide().place());
        }
    }
};

}

class FirstBuild : public QObject
{
    Q_OBJECT

private slots:
    void tenClicksMakeACreatureThatWalks_data()
    {
        QTest::addColumn<QSize>("size");
        QTest::newRow("1280x800") << QSize(1280, 800);
        QTest::newRow("1920x1080") << QSize(1920, 1080);
    }

    void tenClicksMakeACreatureThatWalks()
    {
        QFETCH(QSize, size);
        Guided fixture(size);
        fixture.giveFeet();                               // 1 to 4
        fixture.clickHighlighted(fixture.tool("Select")); // 5
        fixture.click(fixture.plan().points[1].x);        // 6
        QCOMPARE(fixture.ring()->widget(), fixture.row("speed"));
        QTRY_VERIFY(fixture.ring()->isVisible());
        QTRY_VERIFY(!fixture.row("speed")->visibleRegion().isEmpty()); // 7
        fixture.type("speed", "0.05");
        fixture.clickHighlighted(fixture.effect("Ground")); // 8
        fixture.clickHighlighted(fixture.effect("Walls"));  // 9
        auto *play = fixture.window.findChild<QToolButton *>("play");
        const sim::Vec2 from = fixture.body();
        fixture.clickHighlighted(play); // 10
        QVERIFY(fixture.session.playback().isPlaying());
        QVERIFY(fixture.step() == BuildGuide::Step::watch);
        QTRY_VERIFY_WITH_TIMEOUT(fixture.step() == BuildGuide::Step::done, 60'000);
        fixture.session.playback().pause();
        fixture.session.playback().goTo({600, 0});
        QTRY_COMPARE(fixture.session.timeline().cursor().frame, 600);
        QVERIFY2(std::abs(fixture.body().x - from.x) > 400.0, qPrintable(QString::number(fixture.body().x)));
        QVERIFY(fixture.said().startsWith("It walks"));
    }

    void afterTheLastSwitchSpacePlays()
    {
        Guided fixture;
        fixture.giveFeet();
        fixture.clickHighlighted(fixture.tool("Select"));
        fixture.type("speed", "0.05");
        QVERIFY(!qobject_cast<NumberBox *>(QApplication::focusWidget())); // Return has given the keys back
        fixture.clickHighlighted(fixture.effect("Ground"));
        fixture.clickHighlighted(fixture.effect("Walls"));
        QWidget *focus = QApplication::focusWidget();
        QTest::keyClick(focus ? focus : &fixture.window, Qt::Key_Space);
        QVERIFY(fixture.session.playback().isPlaying());
    }

    void creatureCanBeBuiltWithTheKeyboard()
    {
        Guided fixture;
        fixture.view.setFocus();
        fixture.key(Qt::Key_F);
        fixture.key(Qt::Key_BracketRight);
        fixture.key(Qt::Key_Return);
        QVERIFY(fixture.step() == BuildGuide::Step::leftFoot);
        const auto go = [&](int key, int times) {
            for (int i = 0; i < times; ++i)
                fixture.key(key);
        };
        go(Qt::Key_Left, 5);
        go(Qt::Key_Down, 5);
        fixture.key(Qt::Key_Return);
        QVERIFY(fixture.step() == BuildGuide::Step::rightFoot);
        go(Qt::Key_Right, 10);
        fixture.key(Qt::Key_Return);
        QVERIFY(fixture.step() == BuildGuide::Step::chooseTool);
        fixture.key(Qt::Key_V);
        while (fixture.step() == BuildGuide::Step::foot)
            fixture.key(Qt::Key_BracketRight);
        auto *swing = fixture.row("speed")->findChild<NumberBox *>();
        swing->setFocus(Qt::TabFocusReason);
        QTest::keyClicks(swing, "0.05");
        QTest::keyClick(swing, Qt::Key_Return);
        for (const char *effect : {"Ground", "Walls"}) {
            QTRY_VERIFY(fixture.effect(effect)->isVisible());
            fixture.effect(effect)->setFocus(Qt::TabFocusReason);
            QTest::keyClick(fixture.effect(effect), Qt::Key_Space);
        }
        QVERIFY(fixture.step() == BuildGuide::Step::play);
        fixture.view.setFocus();
        fixture.key(Qt::Key_Space);
        QVERIFY(fixture.session.playback().isPlaying());
    }

    void guideShowsOneStepAtATimeAndFollowsUndo()
    {
        Guided fixture;
        QVERIFY(fixture.said().contains("Foot"));
        fixture.giveFeet();
        QVERIFY2(fixture.said().contains("Select"), qPrintable(fixture.said()));
        fixture.session.editor().undo();
        QCOMPARE(fixture.plan().feet.size(), std::size_t(1));
        QVERIFY(fixture.step() == BuildGuide::Step::body); // from which the second foot goes on
        fixture.session.editor().redo();
        fixture.clickHighlighted(fixture.tool("Select"));
        fixture.click(fixture.plan().points[1].x);
        fixture.click({10, 10}); // the foot is not chosen any more
        QVERIFY(fixture.step() == BuildGuide::Step::foot);
    }

    void feetOnOneSideAreNotOpposite()
    {
        Guided fixture;
        fixture.clickHighlighted(fixture.tool("Foot"));
        fixture.click(fixture.plan().points[0].x);
        const sim::Vec2 left = *fixture.guide().place();
        fixture.click(left);
        fixture.click({left.x + 10, left.y - 30});
        QCOMPARE(fixture.plan().feet.size(), std::size_t(2));
        QVERIFY(fixture.step() == BuildGuide::Step::rightFoot);
        fixture.click(*fixture.guide().place());
        QVERIFY(fixture.step() == BuildGuide::Step::chooseTool);
    }

    void guideCanBeLeftAndStartedAgain()
    {
        Guided fixture;
        fixture.giveFeet();
        const sim::Blueprint built = fixture.plan();
        for (QToolButton *one : fixture.panel().guideBox().findChildren<QToolButton *>()) {
            if (one->text() == "Leave")
                QTest::mouseClick(one, Qt::LeftButton);
        }
        QVERIFY(!fixture.panel().guideBox().isVisible());
        QVERIFY(fixture.plan() == built);
        QVERIFY(!fixture.ring()->widget());
        QTest::mouseClick(fixture.button("First build: a walker"), Qt::LeftButton);
        QVERIFY(fixture.panel().guideBox().isVisible());
        QVERIFY(fixture.step() == BuildGuide::Step::footTool);
        QVERIFY(fixture.plan().feet.empty());
        fixture.session.editor().undo();
        QVERIFY(fixture.plan() == built);
    }

    void anExampleEndsItAndIsSeenWhole()
    {
        Guided fixture;
        fixture.giveFeet();
        fixture.view.horizontalScrollBar()->setValue(fixture.view.horizontalScrollBar()->maximum());
        QVERIFY(!fixture.view.viewport()->rect().contains(fixture.on(fixture.plan().points[0].x)));
        const lessons::Example &bridge = fixture.session.step().examples[1];
        QVERIFY(takeExample(fixture.session.run(), fixture.session.editor(), bridge));
        QVERIFY(!fixture.guide().isOn());
        for (const sim::BlueprintPoint &point : fixture.plan().points)
            QVERIFY(fixture.view.viewport()->rect().contains(fixture.on(point.x)));
    }

    void anotherLessonEndsIt()
    {
        Guided fixture;
        fixture.session.openStep("two_body", "mutual");
        QVERIFY(!fixture.guide().isOn());
        fixture.build();
        QVERIFY(!fixture.panel().guideBox().isVisible());
    }
};

SUITE(tst_first_build, FirstBuild)
#include "tst_first_build.moc"
