// Stepping through a frame line by line, forwards and back.

#include "app/listing/limits.h"
#include "app/ui/time/line_position.h"
#include "tests/app/listing/code_session.h"
#include "tests/suite.h"

using namespace app;
using code_session::chipAt;
using code_session::Opened;
using code_session::published;
using code_session::sameMotion;
using code_session::valuesOf;

namespace {

/// Returns the code of the lines that run in the next frame, without spaces around it.
QStringList codeOf(const Opened &opened)
{
    const QStringList text = opened.session.code().text().split('\n');
    QStringList code;
    for (const listing::TracedLine &line : opened.session.lines().nextFrame()->lines())
        code << text[line.line - 1].trimmed();
    return code;
}

}

class LineStepperTest : public QObject
{
    Q_OBJECT

private slots:
    void theLinesRunInTheOrderOfTheText()
    {
        Opened opened("single_spring", "radial");
        opened.goTo(5);
        QVERIFY(opened.session.lines().isAvailable());
        QCOMPARE(
            codeOf(opened),
            (QStringList{"if (body.held)", "if (foot.held)", "Vec2 from = foot.position - body.position;",
                         "double angle = atan2(from.y, from.x);",
                         "Vec2 target = body.position + radius * Vec2(cos(angle), sin(angle));",
                         "foot.velocity += k * (target - foot.position);", "foot.velocity *= damp;",
                         "foot.position += foot.velocity;", "}"}));
        QCOMPARE(opened.session.lines().count(), 9);
        QCOMPARE(opened.session.lines().nextLine(), opened.lineOf("if (body.held)"));
    }

    void everyListingCanBeSteppedThrough_data()
    {
        QTest::addColumn<QString>("lesson");
        QTest::addColumn<QString>("step");
        const LessonLibrary library = LessonLibrary::load({LESSON_DIR});
        for (const LessonEntry &lesson : library.lessons) {
            for (const lessons::Step &step : lesson.steps) {
                if (!step.listing.isEmpty())
                    QTest::addRow("%s/%s", qPrintable(lesson.id), qPrintable(step.id))
                        << lesson.id << step.id;
            }
        }
    }
    void everyListingCanBeSteppedThrough()
    {
        QFETCH(QString, lesson);
        QFETCH(QString, step);
        Opened opened(lesson, step);
        Session &session = opened.session;
        opened.goTo(6);
        QVERIFY(session.lines().isAvailable());
        const std::shared_ptr<const ListingFrame> frame = session.lines().nextFrame();
        QVERIFY(frame && !frame->error() && frame->count() > 0);
        const sim::State end = published(session.step(), session.timeline().script(), 7);
        const sim::State reached = frame->stateAfter(listing::maxLinesPerFrame);
        QVERIFY((reached.position - end.position).abs().maxCoeff() <= 1e-9);
        if (end.angle.size() > 0)
            QVERIFY((reached.angle - end.angle).abs().maxCoeff() <= 1e-9);

        const int middle = frame->count() / 2;
        session.lines().goTo(middle);
        QCOMPARE(session.lines().index(), middle);
        const LineValues values = valuesOf(opened);
        QCOMPARE(values.calls.front(), QString("frame"));
        QCOMPARE(values.calls.back(), QString::fromStdString(frame->line(middle).function));
        QVERIFY(!values.chips.empty());
        for (const LineChip &chip : values.chips)
            QVERIFY(chip.text.contains(" = ") && !chip.tip.isEmpty());
        session.lines().back();
        QCOMPARE(session.lines().index(), middle - 1);
        opened.goTo(7);
        QVERIFY(!valuesOf(opened).chips.empty());
    }

    void theSceneShowsWhatTheLinesHaveDone()
    {
        Opened opened("single_spring", "radial");
        Session &session = opened.session;
        opened.goTo(5);
        const sim::State start = session.timeline().state();
        const sim::State end = published(session.step(), session.timeline().script(), 6);
        const int foot = session.timeline().track().interval().scene.find("foot");
        for (int i = 1; i <= 8; ++i) {
            session.lines().forward();
            QCOMPARE(session.lines().index(), i);
            QCOMPARE(session.timeline().cursor(), (sim::Cursor{5, 0}));
            const sim::State shown = session.presentation().picture().state;
            const sim::State &expected = i < 8 ? start : end; // the line before the last brace moves it
            QVERIFY(shown.positionOf(foot) == expected.positionOf(foot));
            QVERIFY(i < 7 || shown.velocityOf(foot) == end.velocityOf(foot));
            QVERIFY(i > 5 || shown.velocityOf(foot) == start.velocityOf(foot));
        }
        session.lines().forward();
        QCOMPARE(session.lines().index(), 0);
        QCOMPARE(session.timeline().cursor(), (sim::Cursor{6, 0}));
        QVERIFY(sameMotion(session.presentation().picture().state, end));
    }

    void backGoesThroughTheSameStates()
    {
        Opened opened("multi_foot", "any_number");
        Session &session = opened.session;
        opened.goTo(2);
        std::vector<sim::State> states;
        std::vector<int> lines;
        while (session.timeline().cursor().frame < 4) {
            states.push_back(session.presentation().picture().state);
            lines.push_back(session.lines().nextLine());
            session.lines().forward();
        }
        QVERIFY(states.size() > 60); // two frames of three feet and more
        while (!states.empty()) {
            session.lines().back();
            QVERIFY(sameMotion(session.presentation().picture().state, states.back()));
            QCOMPARE(session.lines().nextLine(), lines.back());
            states.pop_back();
            lines.pop_back();
        }
        QCOMPARE(session.timeline().cursor(), (sim::Cursor{2, 0}));
        QCOMPARE(session.lines().index(), 0);
    }

    void theFirstFrameHasNothingBeforeIt()
    {
        Opened opened("single_spring", "radial");
        LineStepper &lines = opened.session.lines();
        lines.back();
        QCOMPARE(opened.session.timeline().cursor(), sim::Cursor{});
        QCOMPARE(lines.index(), 0);
        QVERIFY(!lines.shown().frame);
        lines.forward();
        QCOMPARE(lines.index(), 1);
        lines.back();
        QCOMPARE(lines.index(), 0);
    }

    void callsAreSteppedIntoOverAndOutOf()
    {
        Opened opened("multi_foot", "any_number");
        Session &session = opened.session;
        LineStepper &lines = session.lines();
        QVERIFY(lines.runTo(opened.lineOf("foot.velocity += pull(foot, body);")));
        const int before = lines.index();
        lines.forward();
        QCOMPARE(lines.nextLine(), opened.lineOf("Vec2 from = me.position"));
        QCOMPARE(valuesOf(opened).calls, (QStringList{"frame", "pull"}));
        lines.stepOut();
        QCOMPARE(lines.nextLine(), opened.lineOf("move(foot);"));
        lines.goTo(before);
        lines.stepOver();
        QCOMPARE(lines.nextLine(), opened.lineOf("move(foot);"));
        lines.stepOver();
        QVERIFY(lines.nextLine() != opened.lineOf("me.velocity *= damp;"));
        lines.stepOut(); // of frame: to the next frame
        QCOMPARE(session.timeline().cursor(), (sim::Cursor{1, 0}));
        QCOMPARE(lines.index(), 0);
    }

    void runningToALineGoesOnToTheNextFrame()
    {
        Opened opened("single_spring", "radial");
        Session &session = opened.session;
        const int target = opened.lineOf("Vec2 target");
        QVERIFY(session.lines().runTo(target));
        QCOMPARE(session.lines().nextLine(), target);
        QCOMPARE(session.timeline().cursor().frame, 0);
        QVERIFY(session.lines().runTo(target));
        QCOMPARE(session.lines().nextLine(), target);
        QCOMPARE(session.timeline().cursor().frame, 1);
        const int index = session.lines().index();
        QVERIFY(!session.lines().runTo(opened.lineOf("body.position = hand"))); // nobody holds the body
        QCOMPARE(session.lines().index(), index);
        QCOMPARE(session.timeline().cursor().frame, 1);
    }

    void aHeldBodyIsSteppedThroughWithTheHand()
    {
        Opened opened("single_spring", "radial");
        Session &session = opened.session;
        opened.goTo(3);
        session.input().grab("foot");
        session.input().moveTo({120, 300});
        const int foot = session.timeline().track().interval().scene.find("foot");
        const sim::Vec2 before = session.timeline().state().positionOf(foot);
        session.lines().forward();
        session.lines().forward();
        QCOMPARE(session.lines().nextLine(), opened.lineOf("foot.velocity = hand"));
        QVERIFY(session.presentation().picture().state.positionOf(foot) == before);
        session.lines().forward();
        const LineStepper::Shown shown = session.lines().shown();
        QVERIFY(std::get<sim::Vec2>(*shown.frame->valueOf("foot.velocity", shown.index)) ==
                (sim::Vec2{120, 300} - before));
        QVERIFY(std::get<sim::Vec2>(*shown.frame->valueOf("hand", shown.index)) == (sim::Vec2{120, 300}));
        session.lines().forward();
        session.lines().forward(); // after the brace
        QCOMPARE(session.timeline().cursor(), (sim::Cursor{4, 0}));
        QVERIFY(session.timeline().state().positionOf(foot) == (sim::Vec2{120, 300}));
    }

    void otherMovesOfTheCursorLeaveTheLines()
    {
        Opened opened("single_spring", "radial");
        Session &session = opened.session;
        opened.goTo(4);
        const auto enter = [&] {
            session.lines().goTo(3);
            return session.lines().index() == 3 && session.lines().state();
        };
        QVERIFY(enter());
        session.playback().frameForward();
        QCOMPARE(session.lines().index(), 0);
        QVERIFY(!session.lines().state());
        QVERIFY(enter());
        opened.goTo(2);
        QCOMPARE(session.lines().index(), 0);
        QVERIFY(enter());
        session.playback().phaseForward();
        QCOMPARE(session.lines().index(), 0);
        QVERIFY(!session.lines().shown().frame);
        opened.goTo(2);
        QVERIFY(enter());
        session.openStep("single_spring", "drag");
        QCOMPARE(session.lines().index(), 0);
    }

    void aNumberChangedInsideAFrameKeepsThePlace()
    {
        Opened opened("single_spring", "radial");
        Session &session = opened.session;
        opened.goTo(4);
        session.lines().goTo(6);
        session.editor().setParameter("k", 0.45);
        QCOMPARE(session.lines().index(), 6);
        sim::Script script = session.timeline().script();
        const sim::State end = published(session.step(), script, 5);
        const int foot = session.timeline().track().interval().scene.find("foot");
        session.lines().forward();
        QVERIFY(session.presentation().picture().state.velocityOf(foot) == end.velocityOf(foot));
    }

    void textThatDoesNotCompileHasNoLines()
    {
        Opened opened("single_spring", "radial");
        Session &session = opened.session;
        session.lines().goTo(3);
        session.code().write(opened.listing() + "?");
        QVERIFY(!session.lines().isAvailable());
        QCOMPARE(session.lines().index(), 0);
        QCOMPARE(session.lines().nextLine(), 0);
        QVERIFY(!session.lines().shown().frame);
        session.lines().forward();
        QCOMPARE(session.lines().index(), 0);
        session.editor().setMethod("rk4");
        session.code().reset();
        QVERIFY(!session.lines().isAvailable()); // another method computes the run
    }

    void aMistakeEndsTheFrameOnItsLine()
    {
        Opened opened("single_spring", "radial");
        Session &session = opened.session;
        session.code().write(
            Opened::with(opened.listing(), "foot.velocity *= damp;", "int zero = 0; int one = 1 / zero;"));
        opened.goTo(5);
        QCOMPARE(session.timeline().cursor(), sim::Cursor{});
        for (int i = 0; i < 20; ++i)
            session.lines().forward();
        QCOMPARE(session.timeline().cursor(), sim::Cursor{});
        QCOMPARE(session.lines().nextLine(), opened.lineOf("1 / zero"));
        QCOMPARE(valuesOf(opened).message,
                 QString("Line %1 of your code: This divides by 0.").arg(opened.lineOf("1 / zero")));
        QVERIFY(!chipAt(opened, "Vec2 target").text.isEmpty()); // the values that led there
    }

    void numberOfLinesIsShownOnlyIfItIsKnown()
    {
        Opened opened("single_spring", "radial");
        opened.session.code().write("void frame()\n{\n    while (true)\n        foot.velocity *= damp;\n}\n");
        opened.session.lines().goTo(3);
        QCOMPARE(progressOf(opened.session.lines()), QString("before line 4, 3 lines run"));
        opened.session.code().write(
            "void frame()\n{\n    foot.velocity *= damp;\n    foot.velocity *= damp;\n}\n");
        opened.session.lines().goTo(1);
        QCOMPARE(progressOf(opened.session.lines()), QString("before line 4, 1 of 3 lines run"));
    }

    void playingStopsBeforeTheLineWithTheMistake_data()
    {
        QTest::addColumn<QString>("code");
        QTest::addColumn<QString>("line");
        QTest::newRow("division") << "int zero = 0; int one = frame_number > 4 ? 1 / zero : 0;"
                                  << "1 / zero";
        QTest::newRow("not finite") << "foot.velocity *= frame_number > 4 ? 1e300 * 1e300 : damp;"
                                    << "1e300";
        QTest::newRow("endless loop") << "while (frame_number > 4)\n        foot.velocity *= damp;"
                                      << "while";
    }
    void playingStopsBeforeTheLineWithTheMistake()
    {
        QFETCH(QString, code);
        QFETCH(QString, line);
        Opened opened("single_spring", "radial");
        Session &session = opened.session;
        session.code().write(Opened::with(opened.listing(), "foot.velocity *= damp;", code));
        session.playback().play();
        QTRY_VERIFY(!session.playback().isPlaying());
        QCOMPARE(session.timeline().cursor(), (sim::Cursor{4, 0}));
        QCOMPARE(session.lines().nextLine(), opened.lineOf(line));
        QVERIFY(session.lines().index() > 0);
        QVERIFY(!chipAt(opened, "Vec2 target").text.isEmpty()); // the values that led there
        session.code().write(opened.listing());
        QCOMPARE(session.lines().index(), 0);
        QVERIFY(!session.timeline().stop());
    }
};

SUITE(tst_line_stepper, LineStepperTest)
#include "tst_line_stepper.moc"
