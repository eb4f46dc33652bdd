#include "tests/app/breakpoints_bench.h"

#include <map>

using namespace breakpoints_bench;

/// Where runs stop by themselves.
class TestBreakpoints : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QStandardPaths::setTestModeEnabled(true);
        QVERIFY(!library().lessons.empty());
    }

    void aConditionStopsWhereASearchFindsThatItComesTrue_data()
    {
        QTest::addColumn<Way>("way");
        QTest::addColumn<QString>("condition");
        for (const auto &[name, way] :
             {std::pair{"play", Way::play}, {"step", Way::frames}, {"run", Way::runTo}}) {
            for (const char *text :
                 {"foot0.y > 371", "frame == 12", "body.vx * body.vx + body.vy * body.vy > 25",
                  "foot0.vy < 0 and phase == \"walls\"", "frame / 7 == 3 or frame > 38"})
                QTest::addRow("%s, %s", name, text) << way << QString(text);
        }
    }
    void aConditionStopsWhereASearchFindsThatItComesTrue()
    {
        QFETCH(Way, way);
        QFETCH(QString, condition);
        const std::map<QString, Question> questions = {
            {"foot0.y > 371", [](const auto &run) { return run.state().position(0, 1) > 371; }},
            {"frame == 12", [](const auto &run) { return run.cursor().frame == 12; }},
            {"body.vx * body.vx + body.vy * body.vy > 25",
             [](const auto &run) {
                 const sim::Vec2 v = run.state().velocityOf(run.track().interval().scene.find("body"));
                 return v.x * v.x + v.y * v.y > 25;
             }},
            {"foot0.vy < 0 and phase == \"walls\"",
             [](const auto &run) {
                 return run.state().velocityOf(0).y < 0 && nextPhase(run).title == "walls";
             }},
            {"frame / 7 == 3 or frame > 38",
             [](const auto &run) { return run.cursor().frame == 21 || run.cursor().frame > 38; }}};
        Bench bench;
        const auto expected = search(bench.session.timeline().script(), 60, questions.at(condition), true);
        QVERIFY(!expected.empty());
        bench.session.breakpoints().add(condition);
        QVERIFY(bench.stops(way, 59) == expected);
    }

    void aLineStopsBeforeEachPhaseThatItBelongsTo_data() { everyWay(); }
    void aLineStopsBeforeEachPhaseThatItBelongsTo()
    {
        QFETCH(Way, way);
        Bench bench;
        QVERIFY(bench.session.breakpoints().toggle(placeOf("sim/effects/pairs/spring.h", "pull = k * d")));
        const auto expected = search(
            bench.session.timeline().script(), 4,
            [](const sim::Timeline &run) { return nextPhase(run).id == "radial_spring"; }, false);
        QCOMPARE(expected.size(), std::size_t(7)); // of the feet, and of the body; it begins at the first
        QVERIFY(bench.stops(way, 3) == expected);
    }

    void aLineWithAConditionStopsWhereBothAreSo_data() { everyWay(); }
    void aLineWithAConditionStopsWhereBothAreSo()
    {
        QFETCH(Way, way);
        Bench bench;
        const CodePlace place = placeOf("sim/effects/contacts/walls.h", "x.y = room.floor - half");
        bench.session.breakpoints().toggle(place);
        const int id = bench.session.breakpoints().at(place)->id;
        bench.session.breakpoints().setCondition(id, "foot0.y > 372.5");
        const auto expected = search(
            bench.session.timeline().script(), 60,
            [](const sim::Timeline &run) {
                return nextPhase(run).title == "walls" && run.state().position(0, 1) > 372.5;
            },
            false);
        QVERIFY(expected.size() > 3);
        QVERIFY(bench.stops(way, 59) == expected);
    }

    void stepsOfPartsOfAFrameAndOfSeveralFramesStopToo_data()
    {
        QTest::addColumn<double>("h");
        QTest::newRow("half frames") << 0.5;
        QTest::newRow("two frames") << 2.0;
    }
    void stepsOfPartsOfAFrameAndOfSeveralFramesStopToo()
    {
        QFETCH(double, h);
        Bench bench;
        bench.session.setMethod("semi_implicit_euler");
        bench.session.setStepSize(h);
        bench.session.breakpoints().toggle(
            placeOf("sim/effects/fields/gravity.cpp", "Vec2 pull = {0, gravity}"));
        bench.session.breakpoints().add("foot1.y > 300");
        const auto expected = [&] {
            bool held = false;
            return search(
                bench.session.timeline().script(), 24,
                [&](const sim::Timeline &run) {
                    const bool low = run.state().position(1, 1) > 300;
                    const bool comes = low && !held && run.cursor() != sim::Cursor{};
                    held = low;
                    return comes || nextPhase(run).id == "gravity";
                },
                false);
        }();
        QVERIFY(expected.size() >= (h < 1.0 ? 48 : 12));
        QVERIFY(bench.stops(Way::frames, 23) == expected);
    }

    void everyStepStopsInTheMiddleOfAFrame_data()
    {
        QTest::addColumn<QString>("lesson");
        QTest::addColumn<QString>("step");
        for (const LessonEntry &lesson : library().lessons) {
            for (const lessons::Step &step : lesson.steps) {
                if (step.script().build(step.defaultValues()).start.pointCount() < 500)
                    QTest::addRow("%s/%s", qPrintable(lesson.id), qPrintable(step.id))
                        << lesson.id << step.id;
            }
        }
    }
    void everyStepStopsInTheMiddleOfAFrame()
    {
        QFETCH(QString, lesson);
        QFETCH(QString, step);
        Bench bench(lesson, step);
        const sim::Phase &last = bench.session.timeline().track().nextInterval()->pipeline.phases.back();
        const QString text =
            QString("frame == 3 and phase == \"%1\"").arg(QString::fromStdString(last.title));
        const auto expected = search(
            bench.session.timeline().script(), 5,
            [&](const sim::Timeline &run) {
                return run.cursor().frame == 3 && nextPhase(run).title == last.title;
            },
            true);
        bench.session.breakpoints().add(text);
        QVERIFY(bench.stops(Way::frames, 4) == expected);
    }

    void theSentenceNamesFramePhaseAndReason()
    {
        Bench bench;
        bench.session.breakpoints().add("frame == 4 and phase == \"gravity\"");
        bench.session.runTo({10, 0});
        QCOMPARE(bench.session.stoppedBy()->sentence,
                 QString("Stopped at frame 4 before gravity: frame == 4 and phase == \"gravity\"."));
        bench.session.restart();
        QVERIFY(!bench.session.stoppedBy());
        bench.session.breakpoints().remove(bench.session.breakpoints().all().front().id);
        const CodePlace place = placeOf("sim/effects/contacts/walls.h", "x.y = room.floor - half");
        bench.session.breakpoints().toggle(place);
        bench.session.frameForward();
        QCOMPARE(bench.session.stoppedBy()->sentence,
                 QString("Stopped at frame 0 before walls: walls.h, line %1.").arg(place.line));
    }

    void oneThatIsSwitchedOffOrTakenAwayStopsNothing()
    {
        Bench bench;
        Breakpoints &points = bench.session.breakpoints();
        points.add("frame == 3");
        points.setOn(points.all().front().id, false);
        QVERIFY(!points.isAnyOn());
        QVERIFY(bench.stops(Way::frames, 5).empty());
        bench.session.restart();
        points.setOn(points.all().front().id, true);
        QCOMPARE(bench.stops(Way::frames, 5).size(), std::size_t(1));
        bench.session.restart();
        points.remove(points.all().front().id);
        QVERIFY(bench.stops(Way::frames, 5).empty());
    }

    void goingToAFrameByTheTimelineAndBackDoesNotStop()
    {
        Bench bench;
        bench.session.breakpoints().add("frame == 3");
        bench.session.goTo({9, 0});
        QCOMPARE(bench.at(), (sim::Cursor{9, 0}));
        bench.session.frameBack();
        bench.session.runTo({2, 0});
        QCOMPARE(bench.at(), (sim::Cursor{2, 0}));
        bench.session.runTo({9, 0});
        QCOMPARE(bench.at(), (sim::Cursor{3, 0}));
        bench.session.phaseForward();
        QVERIFY(!bench.session.stoppedBy());
        bench.session.runTo({9, 0});
        QCOMPARE(bench.at(), (sim::Cursor{9, 0}));
    }

    void aFarFrameIsStoppedAtAfterEverythingRests()
    {
        Bench bench("single_spring", "radial");
        bench.session.breakpoints().add("frame == 30000 and phase == \"damping\"");
        bench.session.runTo({40000, 0});
        QVERIFY(QTest::qWaitFor([&] { return !bench.session.goingTo(); }, 60000));
        QCOMPARE(bench.at().frame, std::int64_t(30000));
        QVERIFY(bench.session.stoppedBy());
    }

    void whatRestsPlaysOnToAFrameThatIsAskedFor()
    {
        Bench bench("single_spring", "radial");
        bench.session.goTo({20000, 0});
        QVERIFY(QTest::qWaitFor([&] { return !bench.session.goingTo(); }, 60000));
        bench.session.play();
        QVERIFY(QTest::qWaitFor([&] { return bench.session.isResting(); }, 20000));
        const std::int64_t frame = bench.at().frame + 20;
        bench.session.breakpoints().add(QString("frame == %1").arg(frame));
        QVERIFY(!bench.session.isResting());
        QVERIFY(QTest::qWaitFor([&] { return !bench.session.isPlaying(); }, 20000));
        QCOMPARE(bench.at(), (sim::Cursor{frame, 0}));
    }

    void whatRestsIsLeftAloneWhenNothingCanComeTrueAnyMore()
    {
        Bench bench("single_spring", "radial");
        bench.session.goTo({20000, 0});
        QVERIFY(QTest::qWaitFor([&] { return !bench.session.goingTo(); }, 60000));
        bench.session.breakpoints().add("foot.x > 10000");
        bench.session.play();
        QVERIFY(QTest::qWaitFor([&] { return bench.session.isResting(); }, 20000));
        QVERIFY(bench.session.timeline().isFinished());
    }

    void aRunThatEndsByItselfEndsWhereItWould()
    {
        Bench bench;
        bench.session.setMethod("explicit_euler");
        bench.session.setParameter("k", 5.0);
        bench.session.setParameter("damp", 1.0);
        sim::Timeline straight(bench.session.timeline().script());
        straight.seek({100000, 0});
        if (!straight.stop())
            QSKIP("this run does not end");
        bench.session.breakpoints().add("frame == 1000000");
        bench.session.runTo({100000, 0});
        QVERIFY(QTest::qWaitFor([&] { return !bench.session.goingTo(); }, 20000));
        QCOMPARE(bench.at(), straight.cursor());
        QVERIFY(!bench.session.stoppedBy());
        QVERIFY(sim::sameBits(bench.session.timeline().state(), straight.state()));
    }

    void aConditionOnABodyThatIsGoneWaitsUntilItIsThere()
    {
        Bench bench;
        bench.session.setParameter("feet", 6);
        bench.session.breakpoints().add("foot5.y > 0 and frame == 2");
        bench.session.setParameter("feet", 3);
        QVERIFY(bench.stops(Way::frames, 5).empty());
        bench.session.restart();
        bench.session.setParameter("feet", 6);
        QCOMPARE(bench.stops(Way::frames, 5).size(), std::size_t(1));
    }

    void aParameterThatChangesOnTheWayIsReadAsItIs()
    {
        Bench bench;
        bench.session.goTo({6, 0});
        bench.session.setParameter("gravity", 2.0);
        bench.session.setParameter("feet", 7); // other bodies in one and the same run
        bench.session.goTo({0, 0});
        bench.session.breakpoints().add("gravity > 1");
        bench.session.runTo({9, 0});
        QCOMPARE(bench.at(), (sim::Cursor{6, 0}));
        bench.session.breakpoints().add("foot6.y > 0 and frame == 7");
        bench.session.runTo({9, 0});
        QCOMPARE(bench.at(), (sim::Cursor{7, 0}));
    }

    void eachStepKeepsItsOwn()
    {
        Bench bench;
        bench.session.breakpoints().add("frame == 3");
        bench.session.openStep("gravity_walls", "walls");
        QVERIFY(bench.session.breakpoints().all().empty());
        QVERIFY(bench.stops(Way::frames, 5).empty());
        bench.session.openStep("gravity_walls", "gravity");
        QCOMPARE(bench.session.breakpoints().all().size(), std::size_t(1));
        bench.session.startAfresh();
        QCOMPARE(bench.stops(Way::frames, 5).size(), std::size_t(1));
    }

    void stopsDoNotChangeTheRun()
    {
        Bench bench;
        bench.session.breakpoints().add("foot0.y > 300");
        bench.session.breakpoints().add("phase == \"move\"");
        bench.stops(Way::frames, 20);
        while (bench.at().frame < 40 || bench.at().phase > 0)
            bench.session.phaseForward();
        sim::Timeline straight(bench.session.timeline().script());
        straight.seek(bench.at());
        QVERIFY(sim::sameBits(straight.state(), bench.session.timeline().state()));
        QVERIFY(bench.session.timeline().script().input.empty());
    }
};

QTEST_GUILESS_MAIN(TestBreakpoints)
#include "tst_breakpoints.moc"
