// The tools of the sandbox, with a mouse and with keys alone.

#include "tests/app/sandbox/sandbox_support.h"
#include "tests/suite.h"

using namespace app;
using namespace tests;
using namespace sandbox_support;

class SandboxTools : public QObject
{
    Q_OBJECT

private slots:
    void thePictureStaysUnderThePointerAsLongAsAllIsSeen()
    {
        SandboxFixture fixture;
        fixture.build();
        const auto stage = [&] { return fixture.session.presentation().picture().view->stage; };
        const QRectF before = stage();
        const QPoint middle = fixture.on({270, 200});
        fixture.key(Qt::Key_P);
        const QPointF nearTop(fixture.view.viewport()->width() / 2.0, 40.0);
        fixture.click(Camera(fixture.view.viewportTransform()).back(nearTop));
        QVERIFY(stage() != before); // else nothing would have moved anyway
        QCOMPARE(fixture.on({270, 200}), middle);
        fixture.session.editor().setParameter("floor", 900); // is not seen, and the next part shows it
        const QRectF wide = stage();
        fixture.click(Camera(fixture.view.viewportTransform()).back({2.0, 200.0}));
        QVERIFY(stage() != wide);
        QVERIFY(fixture.on({270, 200}) != middle);
        QVERIFY(fixture.view.viewport()->rect().contains(fixture.on({270, 900})));
    }

    void everyDragMakesOneLinkAndEnds()
    {
        SandboxFixture fixture;
        fixture.build();
        fixture.key(Qt::Key_P);
        for (const sim::Vec2 place : {sim::Vec2{100, 100}, {160, 100}, {130, 50}})
            fixture.click(place);
        fixture.key(Qt::Key_T);
        fixture.drag({100, 100}, {160, 100});
        QVERIFY(!fixture.editor().first());
        fixture.drag({160, 100}, {130, 50}); // from where the last one ended
        fixture.drag({130, 50}, {100, 100});
        QCOMPARE(fixture.plan().sticks.size(), std::size_t(3));
        QVERIFY(!fixture.editor().first());
    }

    void twoSeparateDragsMakeTwoSprings()
    {
        SandboxFixture fixture;
        fixture.build();
        const std::size_t points = fixture.plan().points.size();
        const int edits = fixture.session.editor().undoStack().count();
        fixture.key(Qt::Key_S);
        fixture.drag({100, 100}, {160, 100});
        fixture.drag({100, 200}, {160, 200});
        QCOMPARE(fixture.plan().springs.size(), std::size_t(3)); // with the one that was there
        QCOMPARE(fixture.plan().points.size(), points + 4);
        QCOMPARE(fixture.plan().springs[1].a, int(points));
        QCOMPARE(fixture.plan().springs[1].b, int(points) + 1);
        QCOMPARE(fixture.plan().springs[2].a, int(points) + 2);
        QCOMPARE(fixture.plan().springs[2].b, int(points) + 3);
        QCOMPARE(fixture.session.editor().undoStack().count(),
                 edits + 2); // with its points, each is one entry
        QCOMPARE(fixture.session.editor().undoStack().undoText(), QString("Add spring"));
        fixture.session.editor().undo();
        QCOMPARE(fixture.plan().points.size(), points + 2);
    }

    void aDragEndsAChainOfClicks()
    {
        SandboxFixture fixture;
        fixture.build();
        fixture.key(Qt::Key_S);
        fixture.click({100, 100});
        fixture.click({160, 100});
        QVERIFY(fixture.editor().first()); // clicks go on
        fixture.drag({100, 200}, {160, 200});
        QVERIFY(!fixture.editor().first());
        QCOMPARE(fixture.plan().springs.size(), std::size_t(3));
        const sim::BlueprintSpring &last = fixture.plan().springs.back();
        QVERIFY(isNear(fixture.plan().points[std::size_t(last.a)].x, {100, 200}, 1.5));
        QVERIFY(isNear(fixture.plan().points[std::size_t(last.b)].x, {160, 200}, 1.5));
    }

    void aCancelledDragCreatesNothing()
    {
        SandboxFixture fixture;
        fixture.build();
        const sim::Blueprint before = fixture.plan();
        fixture.key(Qt::Key_S);
        QTest::mousePress(fixture.view.viewport(), Qt::LeftButton, {}, fixture.on({100, 100}));
        QTest::mouseMove(fixture.view.viewport(), fixture.on({160, 100}));
        fixture.key(Qt::Key_Escape);
        QTest::mouseRelease(fixture.view.viewport(), Qt::LeftButton, {}, fixture.on({160, 100}));
        QVERIFY(fixture.plan() == before);
        QVERIFY(fixture.editor().tool() == BuildTool::spring); // Esc gave up no more than the drag
    }

    void undoingSaysWhatWasBuilt()
    {
        SandboxFixture fixture;
        fixture.build();
        const QUndoStack &edits = fixture.session.editor().undoStack();
        fixture.key(Qt::Key_P);
        fixture.click({100, 100});
        QCOMPARE(edits.undoText(), QString("Add point"));
        fixture.key(Qt::Key_N);
        fixture.click({100, 100});
        QCOMPARE(edits.undoText(), QString("Nail p2 down"));
        fixture.click({100, 100});
        QCOMPARE(edits.undoText(), QString("Free p2"));
        fixture.key(Qt::Key_V);
        fixture.drag({100, 100}, {130, 120});
        QCOMPARE(edits.undoText(), QString("Move p2"));
        fixture.type("mass", "3");
        QCOMPARE(fixture.plan().points[2].mass, 3.0);
        QCOMPARE(edits.undoText(), QString("Change mass of point p2"));
        fixture.view.setFocus();
        QTest::keyClick(&fixture.window, Qt::Key_J, Qt::ControlModifier);
        QCOMPARE(edits.undoText(), QString("Duplicate p2"));
        QTest::keyClick(&fixture.window, Qt::Key_Delete);
        QCOMPARE(edits.undoText(), QString("Delete p3"));
    }

    void aMouseBuilds()
    {
        SandboxFixture fixture;
        fixture.build();
        const std::size_t points = fixture.plan().points.size();
        fixture.key(Qt::Key_P);
        fixture.click({100, 100});
        fixture.click({160, 100});
        QCOMPARE(fixture.plan().points.size(), points + 2);
        QVERIFY(isNear(fixture.plan().points[points].x, {100, 100}, 1.5));
        fixture.key(Qt::Key_S);
        fixture.click({100, 100});
        fixture.click({160, 100});
        QCOMPARE(fixture.plan().springs.size(), std::size_t(2));
        QVERIFY(fixture.editor().first()); // the next one would go on from here
        fixture.key(Qt::Key_Escape);
        QVERIFY(!fixture.editor().first());
        fixture.key(Qt::Key_T);
        fixture.drag({160, 100}, {220, 140}); // in one drag, to a point that is made
        QCOMPARE(fixture.plan().sticks.size(), std::size_t(1));
        QCOMPARE(fixture.plan().points.size(), points + 3);
        fixture.key(Qt::Key_Escape);
        fixture.key(Qt::Key_N);
        fixture.click({100, 100});
        QVERIFY(fixture.plan().points[points].fixed);
        fixture.key(Qt::Key_F);
        fixture.click({220, 140});
        fixture.click({220, 200});
        QCOMPARE(fixture.plan().feet.size(), std::size_t(1));
        QCOMPARE(fixture.plan().gaits.size(), std::size_t(1));
    }

    void aMouseChoosesAndDrags()
    {
        SandboxFixture fixture;
        fixture.build();
        const sim::Vec2 place = fixture.plan().points[1].x;
        fixture.drag(place, {place.x + 40, place.y - 20});
        QVERIFY(isNear(fixture.plan().points[1].x, {place.x + 40, place.y - 20}, 2.5));
        QCOMPARE(fixture.session.editor().undoStack().count(), 1);                  // one drag, one entry
        QCOMPARE(fixture.session.timeline().script().input.size(), std::size_t(0)); // nothing was dragged
        fixture.click({10, 10});
        QVERIFY(fixture.editor().chosen().isEmpty());
        const sim::Vec2 middle = 0.5 * (fixture.plan().points[0].x + fixture.plan().points[1].x);
        fixture.click(middle);
        QVERIFY(fixture.editor().chosen() == (Selection{{}, {0}, {}}));
        fixture.drag({200, 20}, {500, 300}); // a box
        QVERIFY(fixture.editor().chosen() == (Selection{{0, 1}, {0}, {}}));
        fixture.click(fixture.plan().points[0].x, Qt::ShiftModifier);
        QVERIFY(fixture.editor().chosen() == (Selection{{1}, {0}, {}}));
    }

    void keysAloneBuild()
    {
        SandboxFixture fixture;
        fixture.build();
        fixture.view.setFocus();
        const std::size_t points = fixture.plan().points.size();
        fixture.key(Qt::Key_P);
        fixture.key(Qt::Key_Left);
        fixture.key(Qt::Key_Return);
        QCOMPARE(fixture.plan().points.size(), points + 1);
        QVERIFY(fixture.session.timeline().cursor() == sim::Cursor{}); // no arrow went to the timeline
        fixture.key(Qt::Key_S);
        fixture.key(Qt::Key_Return); // begins at the point that the cross is on
        QVERIFY(fixture.editor().first());
        for (int i = 0; i < 5; ++i)
            fixture.key(Qt::Key_Right);
        fixture.key(Qt::Key_Down, Qt::ShiftModifier);
        fixture.key(Qt::Key_Return);
        QCOMPARE(fixture.plan().points.size(), points + 2);
        QCOMPARE(fixture.plan().springs.size(), std::size_t(2));
        const sim::Vec2 way = fixture.plan().points[points + 1].x - fixture.plan().points[points].x;
        QVERIFY(isNear(way, {50, 1}, 1e-9));
        fixture.key(Qt::Key_Escape);
        fixture.key(Qt::Key_Escape);
        QVERIFY(fixture.editor().tool() == BuildTool::select);
        fixture.key(Qt::Key_BracketRight);
        const std::vector<int> chosen = fixture.editor().chosen().points;
        QCOMPARE(chosen.size(), std::size_t(1));
        const sim::Vec2 before = fixture.plan().points[std::size_t(chosen[0])].x;
        fixture.key(Qt::Key_Right, Qt::AltModifier);
        QVERIFY(isNear(fixture.plan().points[std::size_t(chosen[0])].x, {before.x + 10, before.y}, 1e-9));
        fixture.key(Qt::Key_BraceRight, Qt::ShiftModifier);
        QCOMPARE(fixture.editor().chosen().springs.size(), std::size_t(1));
        QTest::keyClick(&fixture.window, Qt::Key_Delete);
        QCOMPARE(fixture.plan().springs.size(), std::size_t(1));
        QTest::keyClick(&fixture.window, Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(fixture.plan().springs.size(), std::size_t(2));
        QTest::keyClick(&fixture.window, Qt::Key_A, Qt::ControlModifier);
        QTest::keyClick(&fixture.window, Qt::Key_J, Qt::ControlModifier);
        QCOMPARE(fixture.plan().points.size(), 2 * (points + 2));
    }

    void enterBeginsAtThePointThatTheKeysHaveChosen()
    {
        SandboxFixture fixture;
        fixture.build();
        const std::size_t points = fixture.plan().points.size();
        fixture.key(Qt::Key_F);
        fixture.key(Qt::Key_BracketRight);
        fixture.key(Qt::Key_Return); // no arrow was pressed, so no cross was there yet
        QCOMPARE(fixture.plan().points.size(), points);
        QCOMPARE(fixture.editor().first(), std::optional<int>(1));
        for (int i = 0; i < 6; ++i)
            fixture.key(Qt::Key_Down);
        fixture.key(Qt::Key_Return);
        QCOMPARE(fixture.plan().feet.size(), std::size_t(1));
        QCOMPARE(fixture.plan().feet[0].body, 1);
    }

    void hintOfTheSelectedToolSaysWhatToClick()
    {
        SandboxFixture fixture;
        fixture.build();
        fixture.click(fixture.plan().points[1].x);
        fixture.key(Qt::Key_F);
        const QLabel *hint = nullptr;
        for (const QLabel *one : fixture.panel().findChildren<QLabel *>()) {
            if (one->isVisible() &&
                one->text() == "Click a body, then each of its feet, or where you want one.")
                hint = one;
        }
        QVERIFY(hint); // though what is chosen has properties
        QTRY_VERIFY(fixture.row("mass")->isVisible());
        fixture.click(fixture.plan().points[1].x);
        QVERIFY2(fixture.panel().hint().startsWith("Click each of its feet"),
                 qPrintable(fixture.panel().hint()));
    }
};

SUITE(tst_sandbox_tools, SandboxTools)
#include "tst_sandbox_tools.moc"
