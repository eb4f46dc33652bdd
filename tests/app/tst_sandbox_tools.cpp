// The tools of the sandbox, with a mouse and with keys alone.

#include "sandbox_bench.h"

using namespace app;
using namespace sandbox_bench;

class SandboxTools : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase() { prepareProgram(); }

    void thePictureStaysUnderThePointerAsLongAsAllIsSeen()
    {
        Bench bench;
        bench.build();
        const auto stage = [&] { return bench.session().picture().look->stage; };
        const QRectF before = stage();
        const QPoint middle = bench.on({270, 200});
        bench.key(Qt::Key_P);
        const QPointF nearTop(bench.view().viewport()->width() / 2.0, 40.0);
        bench.click(Camera(bench.view().viewportTransform()).back(nearTop));
        QVERIFY(stage() != before); // else nothing would have moved anyway
        QCOMPARE(bench.on({270, 200}), middle);
        bench.session().setParameter("floor", 900); // is not seen, and the next part shows it
        const QRectF wide = stage();
        bench.click(Camera(bench.view().viewportTransform()).back({2.0, 200.0}));
        QVERIFY(stage() != wide);
        QVERIFY(bench.on({270, 200}) != middle);
        QVERIFY(bench.view().viewport()->rect().contains(bench.on({270, 900})));
    }

    void everyDragMakesOneLinkAndEnds()
    {
        Bench bench;
        bench.build();
        bench.key(Qt::Key_P);
        for (const sim::Vec2 place : {sim::Vec2{100, 100}, {160, 100}, {130, 50}})
            bench.click(place);
        bench.key(Qt::Key_T);
        bench.drag({100, 100}, {160, 100});
        QVERIFY(!bench.bench().first());
        bench.drag({160, 100}, {130, 50}); // from where the last one ended
        bench.drag({130, 50}, {100, 100});
        QCOMPARE(bench.plan().sticks.size(), std::size_t(3));
        QVERIFY(!bench.bench().first());
    }

    void twoSeparateDragsMakeTwoSprings()
    {
        Bench bench;
        bench.build();
        const std::size_t points = bench.plan().points.size();
        const int deeds = bench.session().deeds().count();
        bench.key(Qt::Key_S);
        bench.drag({100, 100}, {160, 100});
        bench.drag({100, 200}, {160, 200});
        QCOMPARE(bench.plan().springs.size(), std::size_t(3)); // with the one that was there
        QCOMPARE(bench.plan().points.size(), points + 4);
        QCOMPARE(bench.plan().springs[1].a, int(points));
        QCOMPARE(bench.plan().springs[1].b, int(points) + 1);
        QCOMPARE(bench.plan().springs[2].a, int(points) + 2);
        QCOMPARE(bench.plan().springs[2].b, int(points) + 3);
        QCOMPARE(bench.session().deeds().count(), deeds + 2); // with its points, each is one entry
        QCOMPARE(bench.session().deeds().undoText(), QString("Add spring"));
        bench.session().undo();
        QCOMPARE(bench.plan().points.size(), points + 2);
    }

    void aDragEndsAChainOfClicks()
    {
        Bench bench;
        bench.build();
        bench.key(Qt::Key_S);
        bench.click({100, 100});
        bench.click({160, 100});
        QVERIFY(bench.bench().first()); // clicks go on
        bench.drag({100, 200}, {160, 200});
        QVERIFY(!bench.bench().first());
        QCOMPARE(bench.plan().springs.size(), std::size_t(3));
        const sim::BlueprintSpring &last = bench.plan().springs.back();
        QVERIFY(isNear(bench.plan().points[std::size_t(last.a)].x, {100, 200}, 1.5));
        QVERIFY(isNear(bench.plan().points[std::size_t(last.b)].x, {160, 200}, 1.5));
    }

    void aDragThatIsGivenUpMakesNothing()
    {
        Bench bench;
        bench.build();
        const sim::Blueprint before = bench.plan();
        bench.key(Qt::Key_S);
        QTest::mousePress(bench.view().viewport(), Qt::LeftButton, {}, bench.on({100, 100}));
        QTest::mouseMove(bench.view().viewport(), bench.on({160, 100}));
        bench.key(Qt::Key_Escape);
        QTest::mouseRelease(bench.view().viewport(), Qt::LeftButton, {}, bench.on({160, 100}));
        QVERIFY(bench.plan() == before);
        QVERIFY(bench.bench().tool() == BuildTool::spring); // Esc gave up no more than the drag
    }

    void undoingSaysWhatWasBuilt()
    {
        Bench bench;
        bench.build();
        const QUndoStack &deeds = bench.session().deeds();
        bench.key(Qt::Key_P);
        bench.click({100, 100});
        QCOMPARE(deeds.undoText(), QString("Add point"));
        bench.key(Qt::Key_N);
        bench.click({100, 100});
        QCOMPARE(deeds.undoText(), QString("Nail p2 down"));
        bench.click({100, 100});
        QCOMPARE(deeds.undoText(), QString("Free p2"));
        bench.key(Qt::Key_V);
        bench.drag({100, 100}, {130, 120});
        QCOMPARE(deeds.undoText(), QString("Move p2"));
        bench.type("mass", "3");
        QCOMPARE(bench.plan().points[2].mass, 3.0);
        QCOMPARE(deeds.undoText(), QString("Change mass of point p2"));
        bench.view().setFocus();
        QTest::keyClick(&bench.window, Qt::Key_J, Qt::ControlModifier);
        QCOMPARE(deeds.undoText(), QString("Duplicate p2"));
        QTest::keyClick(&bench.window, Qt::Key_Delete);
        QCOMPARE(deeds.undoText(), QString("Delete p3"));
    }

    void aMouseBuilds()
    {
        Bench bench;
        bench.build();
        const std::size_t points = bench.plan().points.size();
        bench.key(Qt::Key_P);
        bench.click({100, 100});
        bench.click({160, 100});
        QCOMPARE(bench.plan().points.size(), points + 2);
        QVERIFY(isNear(bench.plan().points[points].x, {100, 100}, 1.5));
        bench.key(Qt::Key_S);
        bench.click({100, 100});
        bench.click({160, 100});
        QCOMPARE(bench.plan().springs.size(), std::size_t(2));
        QVERIFY(bench.bench().first()); // the next one would go on from here
        bench.key(Qt::Key_Escape);
        QVERIFY(!bench.bench().first());
        bench.key(Qt::Key_T);
        bench.drag({160, 100}, {220, 140}); // in one drag, to a point that is made
        QCOMPARE(bench.plan().sticks.size(), std::size_t(1));
        QCOMPARE(bench.plan().points.size(), points + 3);
        bench.key(Qt::Key_Escape);
        bench.key(Qt::Key_N);
        bench.click({100, 100});
        QVERIFY(bench.plan().points[points].fixed);
        bench.key(Qt::Key_F);
        bench.click({220, 140});
        bench.click({220, 200});
        QCOMPARE(bench.plan().feet.size(), std::size_t(1));
        QCOMPARE(bench.plan().gaits.size(), std::size_t(1));
    }

    void aMouseChoosesAndDrags()
    {
        Bench bench;
        bench.build();
        const sim::Vec2 place = bench.plan().points[1].x;
        bench.drag(place, {place.x + 40, place.y - 20});
        QVERIFY(isNear(bench.plan().points[1].x, {place.x + 40, place.y - 20}, 2.5));
        QCOMPARE(bench.session().deeds().count(), 1);                               // one drag, one entry
        QCOMPARE(bench.session().timeline().script().input.size(), std::size_t(0)); // no hand did it
        bench.click({10, 10});
        QVERIFY(bench.bench().chosen().isEmpty());
        const sim::Vec2 middle = 0.5 * (bench.plan().points[0].x + bench.plan().points[1].x);
        bench.click(middle);
        QVERIFY(bench.bench().chosen() == (Chosen{{}, {0}, {}}));
        bench.drag({200, 20}, {500, 300}); // a box
        QVERIFY(bench.bench().chosen() == (Chosen{{0, 1}, {0}, {}}));
        bench.click(bench.plan().points[0].x, Qt::ShiftModifier);
        QVERIFY(bench.bench().chosen() == (Chosen{{1}, {0}, {}}));
    }

    void keysAloneBuild()
    {
        Bench bench;
        bench.build();
        bench.view().setFocus();
        const std::size_t points = bench.plan().points.size();
        bench.key(Qt::Key_P);
        bench.key(Qt::Key_Left);
        bench.key(Qt::Key_Return);
        QCOMPARE(bench.plan().points.size(), points + 1);
        QVERIFY(bench.session().timeline().cursor() == sim::Cursor{}); // no arrow went to the timeline
        bench.key(Qt::Key_S);
        bench.key(Qt::Key_Return); // begins at the point that the cross is on
        QVERIFY(bench.bench().first());
        for (int i = 0; i < 5; ++i)
            bench.key(Qt::Key_Right);
        bench.key(Qt::Key_Down, Qt::ShiftModifier);
        bench.key(Qt::Key_Return);
        QCOMPARE(bench.plan().points.size(), points + 2);
        QCOMPARE(bench.plan().springs.size(), std::size_t(2));
        const sim::Vec2 way = bench.plan().points[points + 1].x - bench.plan().points[points].x;
        QVERIFY(isNear(way, {50, 1}, 1e-9));
        bench.key(Qt::Key_Escape);
        bench.key(Qt::Key_Escape);
        QVERIFY(bench.bench().tool() == BuildTool::select);
        bench.key(Qt::Key_BracketRight);
        const std::vector<int> chosen = bench.bench().chosen().points;
        QCOMPARE(chosen.size(), std::size_t(1));
        const sim::Vec2 before = bench.plan().points[std::size_t(chosen[0])].x;
        bench.key(Qt::Key_Right, Qt::AltModifier);
        QVERIFY(isNear(bench.plan().points[std::size_t(chosen[0])].x, {before.x + 10, before.y}, 1e-9));
        bench.key(Qt::Key_BraceRight, Qt::ShiftModifier);
        QCOMPARE(bench.bench().chosen().springs.size(), std::size_t(1));
        QTest::keyClick(&bench.window, Qt::Key_Delete);
        QCOMPARE(bench.plan().springs.size(), std::size_t(1));
        QTest::keyClick(&bench.window, Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(bench.plan().springs.size(), std::size_t(2));
        QTest::keyClick(&bench.window, Qt::Key_A, Qt::ControlModifier);
        QTest::keyClick(&bench.window, Qt::Key_J, Qt::ControlModifier);
        QCOMPARE(bench.plan().points.size(), 2 * (points + 2));
    }

    void enterBeginsAtThePointThatTheKeysHaveChosen()
    {
        Bench bench;
        bench.build();
        const std::size_t points = bench.plan().points.size();
        bench.key(Qt::Key_F);
        bench.key(Qt::Key_BracketRight);
        bench.key(Qt::Key_Return); // no arrow was pressed, so no cross was there yet
        QCOMPARE(bench.plan().points.size(), points);
        QCOMPARE(bench.bench().first(), std::optional<int>(1));
        for (int i = 0; i < 6; ++i)
            bench.key(Qt::Key_Down);
        bench.key(Qt::Key_Return);
        QCOMPARE(bench.plan().feet.size(), std::size_t(1));
        QCOMPARE(bench.plan().feet[0].body, 1);
    }

    void theToolInHandSaysWhatToClick()
    {
        Bench bench;
        bench.build();
        bench.click(bench.plan().points[1].x);
        bench.key(Qt::Key_F);
        const QLabel *hint = nullptr;
        for (const QLabel *one : bench.panel().findChildren<QLabel *>()) {
            if (one->isVisible() &&
                one->text() == "Click a body, then each of its feet, or where one shall be.")
                hint = one;
        }
        QVERIFY(hint); // though what is chosen has properties
        QTRY_VERIFY(bench.row("mass")->isVisible());
        bench.click(bench.plan().points[1].x);
        QVERIFY2(bench.panel().hint().startsWith("Click each of its feet"), qPrintable(bench.panel().hint()));
    }
};

QTEST_MAIN(SandboxTools)
#include "tst_sandbox_tools.moc"
