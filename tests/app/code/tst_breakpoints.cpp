#include "tests/app/code/breakpoints_support.h"
#include "tests/suite.h"

#include <map>

using namespace breakpoints_support;

/// Breakpoints, at which runs stop by themselves.
class TestBreakpoints : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase() { QVERIFY(!library().lessons.empty()); }

    void conditionStopsTheRunWhenItBecomesTrue_data()
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
    void conditionStopsTheRunWhenItBecomesTrue()
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
        Fixture fixture;
        const auto expected = search(fixture.session.timeline().script(), 60, questions.at(condition), true);
        QVERIFY(!expected.empty());
        fixture.session.playback().breakpoints().add(condition);
        QVERIFY(fixture.stops(way, 59) == expected);
    }

    void aLineStopsBeforeEachPhaseThatItBelongsTo_data() { everyWay(); }
    void aLineStopsBeforeEachPhaseThatItBelongsTo()
    {
        QFETCH(Way, way);
        Fixture fixture;
        QVERIFY(fixture.session.playback().breakpoints().toggle(
            placeOf("sim/effects/pairs/spring.h", "pull = k * d")));
        const auto expected = search(
            fixture.session.timeline().script(), 4,
            [](const sim::Timeline &run) { return nextPhase(run).id == "radial_spring"; }, false);
        QCOMPARE(expected.size(), std::size_t(7)); // of the feet, and of the body; it begins at the first
        QVERIFY(fixture.stops(way, 3) == expected);
    }

    void lineWithAConditionStopsOnlyWhileTheConditionHolds_data() { everyWay(); }
    void lineWithAConditionStopsOnlyWhileTheConditionHolds()
    {
        QFETCH(Way, way);
        Fixture fixture;
        const CodePlace place = placeOf("sim/effects/contacts/walls.h", "x.y = room.floor - half");
        fixture.session.playback().breakpoints().toggle(place);
        const int id = fixture.session.playback().breakpoints().at(place)->id;
        fixture.session.playback().breakpoints().setCondition(id, "foot0.y > 372.5");
        const auto expected = search(
            fixture.session.timeline().script(), 60,
            [](const sim::Timeline &run) {
                return nextPhase(run).title == "walls" && run.state().position(0, 1) > 372.5;
            },
            false);
        QVERIFY(expected.size() > 3);
        QVERIFY(fixture.stops(way, 59) == expected);
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
        Fixture fixture;
        fixture.session.editor().setMethod("semi_implicit_euler");
        fixture.session.editor().setStepSize(h);
        fixture.session.playback().breakpoints().toggle(
            placeOf("sim/effects/fields/gravity.cpp", "Vec2 pull = {0, gravity}"));
        fixture.session.playback().breakpoints().add("foot1.y > 300");
        const auto expected = [&] {
            bool held = false;
            return search(
                fixture.session.timeline().script(), 24,
                [&](const sim::Timeline &run) {
                    const bool low = run.state().position(1, 1) > 300;
                    const bool comes = low && !held && run.cursor() != sim::Cursor{};
                    held = low;
                    return comes || nextPhase(run).id == "gravity";
                },
                false);
        }();
        QVERIFY(expected.size() >= (h < 1.0 ? 48 : 12));
        QVERIFY(fixture.stops(Way::frames, 23) == expected);
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
        Fixture fixture(lesson, step);
        const sim::Phase &last = fixture.session.timeline().track().nextInterval()->pipeline.phases.back();
        const QString text =
            QString("frame == 3 and phase == \"%1\"").arg(QString::fromStdString(last.title));
        const auto expected = search(
            fixture.session.timeline().script(), 5,
            [&](const sim::Timeline &run) {
                return run.cursor().frame == 3 && nextPhase(run).title == last.title;
            },
            true);
        fixture.session.playback().breakpoints().add(text);
        QVERIFY(fixture.stops(Way::frames, 4) == expected);
    }

    void theSentenceNamesFramePhaseAndReason()
    {
        Fixture fixture;
        fixture.session.playback().breakpoints().add("frame == 4 and phase == \"gravity\"");
        fixture.session.playback().runTo({10, 0});
        QTRY_VERIFY(!fixture.session.playback().goal()); // computed in slices
        QCOMPARE(fixture.session.playback().breakHit()->sentence,
                 QString("Stopped at frame 4 before gravity: frame == 4 and phase == \"gravity\"."));
        fixture.session.editor().restart();
        QVERIFY(!fixture.session.playback().breakHit());
        fixture.session.playback().breakpoints().remove(
            fixture.session.playback().breakpoints().all().front().id);
        const CodePlace place = placeOf("sim/effects/contacts/walls.h", "x.y = room.floor - half");
        fixture.session.playback().breakpoints().toggle(place);
        fixture.session.playback().frameForward();
        QCOMPARE(fixture.session.playback().breakHit()->sentence,
                 QString("Stopped at frame 0 before walls: walls.h, line %1.").arg(place.line));
    }

    void disabledOrDeletedBreakpointDoesNotStopTheRun()
    {
        Fixture fixture;
        Breakpoints &points = fixture.session.playback().breakpoints();
        points.add("frame == 3");
        points.setOn(points.all().front().id, false);
        QVERIFY(fixture.stops(Way::frames, 5).empty());
        fixture.session.editor().restart();
        points.setOn(points.all().front().id, true);
        QCOMPARE(fixture.stops(Way::frames, 5).size(), std::size_t(1));
        fixture.session.editor().restart();
        points.remove(points.all().front().id);
        QVERIFY(fixture.stops(Way::frames, 5).empty());
    }

    void goingToAFrameByTheTimelineAndBackDoesNotStop()
    {
        Fixture fixture;
        fixture.session.playback().breakpoints().add("frame == 3");
        fixture.session.playback().goTo({9, 0});
        QCOMPARE(fixture.at(), (sim::Cursor{9, 0}));
        fixture.session.playback().frameBack();
        fixture.session.playback().runTo({2, 0});
        QTRY_VERIFY(!fixture.session.playback().goal()); // computed in slices
        QCOMPARE(fixture.at(), (sim::Cursor{2, 0}));
        fixture.session.playback().runTo({9, 0});
        QTRY_VERIFY(!fixture.session.playback().goal()); // computed in slices
        QCOMPARE(fixture.at(), (sim::Cursor{3, 0}));
        fixture.session.playback().phaseForward();
        QVERIFY(!fixture.session.playback().breakHit());
        fixture.session.playback().runTo({9, 0});
        QTRY_VERIFY(!fixture.session.playback().goal()); // computed in slices
        QCOMPARE(fixture.at(), (sim::Cursor{9, 0}));
    }

    void breakpointAtADistantFrameStopsARestingRun()
    {
        Fixture fixture("single_spring", "radial");
        fixture.session.playback().breakpoints().add("frame == 30000 and phase == \"damping\"");
        fixture.session.playback().runTo({40000, 0});
        QVERIFY(QTest::qWaitFor([&] { return !fixture.session.playback().goal(); }, 60000));
        QCOMPARE(fixture.at().frame, std::int64_t(30000));
        QVERIFY(fixture.session.playback().breakHit());
    }

    void aRestingRunPlaysOnToTheFrameOfABreakpoint()
    {
        Fixture fixture("single_spring", "radial");
        fixture.session.playback().goTo({20000, 0});
        QVERIFY(QTest::qWaitFor([&] { return !fixture.session.playback().goal(); }, 60000));
        fixture.session.playback().play();
        QVERIFY(QTest::qWaitFor([&] { return fixture.session.playback().isWaiting(); }, 20000));
        const std::int64_t frame = fixture.at().frame + 20;
        fixture.session.playback().breakpoints().add(QString("frame == %1").arg(frame));
        QVERIFY(!fixture.session.playback().isWaiting());
        QVERIFY(QTest::qWaitFor([&] { return !fixture.session.playback().isPlaying(); }, 20000));
        QCOMPARE(fixture.at(), (sim::Cursor{frame, 0}));
    }

    void aRestingRunWaitsIfNoBreakpointCanBeReached()
    {
        Fixture fixture("single_spring", "radial");
        fixture.session.playback().goTo({20000, 0});
        QVERIFY(QTest::qWaitFor([&] { return !fixture.session.playback().goal(); }, 60000));
        fixture.session.playback().breakpoints().add("foot.x > 10000");
        fixture.session.playback().play();
        QVERIFY(QTest::qWaitFor([&] { return fixture.session.playback().isWaiting(); }, 20000));
        QVERIFY(fixture.session.timeline().isFinished());
    }

    void unmetBreakpointDoesNotChangeTheEndOfARun()
    {
        Fixture fixture;
        fixture.session.editor().setMethod("explicit_euler");
        fixture.session.editor().setParameter("k", 5.0);
        fixture.session.editor().setParameter("damp", 1.0);
        sim::Timeline straight(fixture.session.timeline().script());
        straight.seek({100000, 0});
        QVERIFY(straight.stop());
        fixture.session.playback().breakpoints().add("frame == 1000000");
        fixture.session.playback().runTo({100000, 0});
        QVERIFY(QTest::qWaitFor([&] { return !fixture.session.playback().goal(); }, 20000));
        QCOMPARE(fixture.at(), straight.cursor());
        QVERIFY(!fixture.session.playback().breakHit());
        QVERIFY(sim::sameBits(fixture.session.timeline().state(), straight.state()));
    }

    void conditionOnAMissingBodyWaitsUntilTheBodyExists()
    {
        Fixture fixture;
        fixture.session.editor().setParameter("feet", 6);
        fixture.session.playback().breakpoints().add("foot5.y > 0 and frame == 2");
        fixture.session.editor().setParameter("feet", 3);
        QVERIFY(fixture.stops(Way::frames, 5).empty());
        fixture.session.editor().restart();
        fixture.session.editor().setParameter("feet", 6);
        QCOMPARE(fixture.stops(Way::frames, 5).size(), std::size_t(1));
    }

    void conditionReadsTheCurrentValueOfAParameter()
    {
        Fixture fixture;
        fixture.session.playback().goTo({6, 0});
        fixture.session.editor().setParameter("gravity", 2.0);
        fixture.session.editor().setParameter("feet", 7); // other bodies in one and the same run
        fixture.session.playback().goTo({0, 0});
        fixture.session.playback().breakpoints().add("gravity > 1");
        fixture.session.playback().runTo({9, 0});
        QTRY_VERIFY(!fixture.session.playback().goal()); // computed in slices
        QCOMPARE(fixture.at(), (sim::Cursor{6, 0}));
        fixture.session.playback().breakpoints().add("foot6.y > 0 and frame == 7");
        fixture.session.playback().runTo({9, 0});
        QTRY_VERIFY(!fixture.session.playback().goal()); // computed in slices
        QCOMPARE(fixture.at(), (sim::Cursor{7, 0}));
    }

    void eachLessonStepKeepsItsOwnBreakpoints()
    {
        Fixture fixture;
        fixture.session.playback().breakpoints().add("frame == 3");
        fixture.session.openStep("gravity_walls", "walls");
        QVERIFY(fixture.session.playback().breakpoints().all().empty());
        QVERIFY(fixture.stops(Way::frames, 5).empty());
        fixture.session.openStep("gravity_walls", "gravity");
        QCOMPARE(fixture.session.playback().breakpoints().all().size(), std::size_t(1));
        fixture.session.editor().startAfresh();
        QCOMPARE(fixture.stops(Way::frames, 5).size(), std::size_t(1));
    }

    void breakpointsDoNotChangeTheRun()
    {
        Fixture fixture;
        fixture.session.playback().breakpoints().add("foot0.y > 300");
        fixture.session.playback().breakpoints().add("phase == \"move\"");
        fixture.stops(Way::frames, 20);
        while (fixture.at().frame < 40 || fixture.at().phase > 0)
            fixture.session.playback().phaseForward();
        sim::Timeline straight(fixture.session.timeline().script());
        straight.seek(fixture.at());
        QVERIFY(sim::sameBits(straight.state(), fixture.session.timeline().state()));
        QVERIFY(fixture.session.timeline().script().input.empty());
    }
};

SUITE(tst_breakpoints, TestBreakpoints)
#include "tst_breakpoints.moc"
