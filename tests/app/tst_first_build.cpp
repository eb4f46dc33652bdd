// The guided first build: a creature that walks, with the mouse and with keys alone.

#include "app/model/build_guide.h"
#include "app/model/workshop.h"
#include "app/ui/sandbox/guide_box.h"
#include "app/ui/sandbox/guide_ring.h"
#include "sandbox_bench.h"

#include <QScrollBar>

using namespace app;
using namespace sandbox_bench;

namespace {

struct Guided : Bench
{
    explicit Guided(QSize size = {1280, 800}) : Bench(size)
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
    /// A click into the middle of what the ring is round.
    void clickWhatIsAsked(QWidget *expected) const
    {
        QVERIFY(ring() && ring()->widget() == expected);
        QTRY_VERIFY(expected->isVisible() && !expected->visibleRegion().isEmpty());
        QTest::mouseClick(expected, Qt::LeftButton, {}, QPoint(12, expected->height() / 2));
    }
    /// It may be the child of any widget in the window.
    GuideRing *ring() const { return window.findChild<GuideRing *>("guideRing"); }
    sim::Vec2 body() { return session().timeline().state().positionOf(0); }

    /// The feet that the guide asks for, with the mouse.
    void giveFeet()
    {
        clickWhatIsAsked(tool("Foot"));
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
    void initTestCase() { prepareProgram(); }

    void tenClicksMakeACreatureThatWalks_data()
    {
        QTest::addColumn<QSize>("size");
        QTest::newRow("1280x800") << QSize(1280, 800);
        QTest::newRow("1920x1080") << QSize(1920, 1080);
    }

    void tenClicksMakeACreatureThatWalks()
    {
        QFETCH(QSize, size);
        Guided bench(size);
        bench.giveFeet();                             // 1 to 4
        bench.clickWhatIsAsked(bench.tool("Choose")); // 5
        bench.click(bench.plan().points[1].x);        // 6
        QCOMPARE(bench.ring()->widget(), bench.row("speed"));
        QTRY_VERIFY(bench.ring()->isVisible());
        QTRY_VERIFY(!bench.row("speed")->visibleRegion().isEmpty()); // 7
        bench.type("speed", "0.05");
        bench.clickWhatIsAsked(bench.effect("Ground")); // 8
        bench.clickWhatIsAsked(bench.effect("Walls"));  // 9
        auto *play = bench.window.findChild<QToolButton *>("play");
        const sim::Vec2 from = bench.body();
        bench.clickWhatIsAsked(play); // 10
        QVERIFY(bench.session().isPlaying());
        QVERIFY(bench.step() == BuildGuide::Step::watch);
        QTRY_VERIFY_WITH_TIMEOUT(bench.step() == BuildGuide::Step::done, 60'000);
        bench.session().pause();
        bench.session().goTo({600, 0});
        QTRY_COMPARE(bench.session().timeline().cursor().frame, 600);
        QVERIFY2(std::abs(bench.body().x - from.x) > 400.0, qPrintable(QString::number(bench.body().x)));
        QVERIFY(bench.said().startsWith("It walks"));
    }

    void afterTheLastSwitchSpacePlays()
    {
        Guided bench;
        bench.giveFeet();
        bench.clickWhatIsAsked(bench.tool("Choose"));
        bench.type("speed", "0.05");
        QVERIFY(!qobject_cast<NumberBox *>(QApplication::focusWidget())); // Return has given the keys back
        bench.clickWhatIsAsked(bench.effect("Ground"));
        bench.clickWhatIsAsked(bench.effect("Walls"));
        QWidget *focus = QApplication::focusWidget();
        QTest::keyClick(focus ? focus : &bench.window, Qt::Key_Space);
        QVERIFY(bench.session().isPlaying());
    }

    void keysAloneDoIt()
    {
        Guided bench;
        bench.view().setFocus();
        bench.key(Qt::Key_F);
        bench.key(Qt::Key_BracketRight);
        bench.key(Qt::Key_Return);
        QVERIFY(bench.step() == BuildGuide::Step::leftFoot);
        const auto go = [&](int key, int times) {
            for (int i = 0; i < times; ++i)
                bench.key(key);
        };
        go(Qt::Key_Left, 5);
        go(Qt::Key_Down, 5);
        bench.key(Qt::Key_Return);
        QVERIFY(bench.step() == BuildGuide::Step::rightFoot);
        go(Qt::Key_Right, 10);
        bench.key(Qt::Key_Return);
        QVERIFY(bench.step() == BuildGuide::Step::chooseTool);
        bench.key(Qt::Key_V);
        while (bench.step() == BuildGuide::Step::foot)
            bench.key(Qt::Key_BracketRight);
        auto *swing = bench.row("speed")->findChild<NumberBox *>();
        swing->setFocus(Qt::TabFocusReason);
        QTest::keyClicks(swing, "0.05");
        QTest::keyClick(swing, Qt::Key_Return);
        for (const char *effect : {"Ground", "Walls"}) {
            QTRY_VERIFY(bench.effect(effect)->isVisible());
            bench.effect(effect)->setFocus(Qt::TabFocusReason);
            QTest::keyClick(bench.effect(effect), Qt::Key_Space);
        }
        QVERIFY(bench.step() == BuildGuide::Step::play);
        bench.view().setFocus();
        bench.key(Qt::Key_Space);
        QVERIFY(bench.session().isPlaying());
    }

    void itSaysOneThingAtATimeAndGoesBackWithUndo()
    {
        Guided bench;
        QVERIFY(bench.said().contains("Foot"));
        bench.giveFeet();
        QVERIFY2(bench.said().contains("Choose"), qPrintable(bench.said()));
        bench.session().undo();
        QCOMPARE(bench.plan().feet.size(), std::size_t(1));
        QVERIFY(bench.step() == BuildGuide::Step::body); // from which the second foot goes on
        bench.session().redo();
        bench.clickWhatIsAsked(bench.tool("Choose"));
        bench.click(bench.plan().points[1].x);
        bench.click({10, 10}); // the foot is not chosen any more
        QVERIFY(bench.step() == BuildGuide::Step::foot);
    }

    void feetOnOneSideAreNotOpposite()
    {
        Guided bench;
        bench.clickWhatIsAsked(bench.tool("Foot"));
        bench.click(bench.plan().points[0].x);
        const sim::Vec2 left = *bench.guide().place();
        bench.click(left);
        bench.click({left.x + 10, left.y - 30});
        QCOMPARE(bench.plan().feet.size(), std::size_t(2));
        QVERIFY(bench.step() == BuildGuide::Step::rightFoot);
        bench.click(*bench.guide().place());
        QVERIFY(bench.step() == BuildGuide::Step::chooseTool);
    }

    void itCanBeLeftAndBegunAgain()
    {
        Guided bench;
        bench.giveFeet();
        const sim::Blueprint built = bench.plan();
        for (QToolButton *one : bench.panel().guideBox().findChildren<QToolButton *>()) {
            if (one->text() == "Leave")
                QTest::mouseClick(one, Qt::LeftButton);
        }
        QVERIFY(!bench.panel().guideBox().isVisible());
        QVERIFY(bench.plan() == built);
        QVERIFY(!bench.ring()->widget());
        QTest::mouseClick(bench.button("First build: a walker"), Qt::LeftButton);
        QVERIFY(bench.panel().guideBox().isVisible());
        QVERIFY(bench.step() == BuildGuide::Step::footTool);
        QVERIFY(bench.plan().feet.empty());
        bench.session().undo();
        QVERIFY(bench.plan() == built);
    }

    void anExampleEndsItAndIsSeenWhole()
    {
        Guided bench;
        bench.giveFeet();
        bench.view().horizontalScrollBar()->setValue(bench.view().horizontalScrollBar()->maximum());
        QVERIFY(!bench.view().viewport()->rect().contains(bench.on(bench.plan().points[0].x)));
        const lessons::Example &bridge = bench.session().step().examples[1];
        QVERIFY(takeExample(bench.session(), bridge));
        QVERIFY(!bench.guide().isOn());
        for (const sim::BlueprintPoint &point : bench.plan().points)
            QVERIFY(bench.view().viewport()->rect().contains(bench.on(point.x)));
    }

    void anotherLessonEndsIt()
    {
        Guided bench;
        bench.session().openStep("two_body", "mutual");
        QVERIFY(!bench.guide().isOn());
        bench.build();
        QVERIFY(!bench.panel().guideBox().isVisible());
    }
};

QTEST_MAIN(FirstBuild)
#include "tst_first_build.moc"
