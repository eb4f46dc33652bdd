// Breakpoints on lines of the listing.

#include "app/model/listing/changed_lines.h"
#include "app/model/listing/line_of_code.h"
#include "app/ui/code/engine/code_view.h"
#include "tests/app/listing/code_session.h"
#include "tests/app/listing/listing_window.h"
#include "tests/suite.h"

#include <QCheckBox>
#include <QLineEdit>

using namespace app;
using code_session::Opened;
using code_session::published;
using listing_window::ListingFixture;

namespace {

CodePlace inListing(int line)
{
    return {{}, line};
}

/// Returns the lines of the listing that have breakpoints.
QList<int> stopLines(const Session &session)
{
    QList<int> lines;
    for (const Breakpoint &one : session.playback().breakpoints().all())
        lines << one.place->line;
    return lines;
}

void setStop(Opened &opened, const QString &code)
{
    opened.session.playback().breakpoints().toggle(inListing(opened.lineOf(code)));
}

/// Plays until the run stops, or past `frame`. Returns whether a breakpoint stopped it.
bool playTo(Session &session, std::int64_t frame)
{
    session.playback().setSpeed(4.0);
    session.playback().play();
    const auto isOver = [&] {
        return !session.playback().isPlaying() || session.timeline().cursor().frame > frame;
    };
    const bool ends = QTest::qWaitFor(isOver, 20'000);
    session.playback().pause();
    return ends && session.playback().breakHit();
}

/// The middle of the dot of a breakpoint.
QPoint dotOf(const ListingFixture &shown, int line)
{
    return shown.editor.stopRect(line).center();
}

}

class LineBreakpointsTest : public QObject
{
    Q_OBJECT

private slots:
    void playingStopsBeforeTheLineInsideEachFrame()
    {
        Opened opened("single_spring", "radial");
        Session &session = opened.session;
        setStop(opened, "foot.position += foot.velocity;");
        for (std::int64_t frame = 0; frame < 4; ++frame) {
            QVERIFY(playTo(session, 20));
            QCOMPARE(session.timeline().cursor(), (sim::Cursor{frame, 0}));
            QCOMPARE(session.lines().nextLine(), opened.lineOf("foot.position += foot.velocity;"));
            // The lines above have run: the velocity is already the one at the end of the frame, the position not yet.
            const int foot = session.timeline().track().interval().scene.find("foot");
            const sim::Script &script = session.timeline().script();
            const sim::State before = published(session.step(), script, frame),
                             after = published(session.step(), script, frame + 1);
            QVERIFY(session.lines().state()->velocityOf(foot) == after.velocityOf(foot));
            QVERIFY(session.lines().state()->positionOf(foot) == before.positionOf(foot));
            QCOMPARE(session.playback().breakHit()->sentence,
                     QString("Stopped at frame %1 before line %2 of the listing.")
                         .arg(frame)
                         .arg(session.lines().nextLine()));
        }
    }

    void breakpointInALoopStopsInEachIteration()
    {
        Opened opened("multi_foot", "any_number");
        Session &session = opened.session;
        session.editor().setParameter("feet", 3);
        setStop(opened, "move(foot);");
        for (std::int64_t frame = 0; frame < 2; ++frame) {
            for (int turn = 0; turn < 3; ++turn) {
                QVERIFY(playTo(session, 20));
                QCOMPARE(session.timeline().cursor(), (sim::Cursor{frame, 0}));
                const LineStepper::Shown shown = session.lines().shown();
                QVERIFY(shown.isInside && session.playback().breakHit());
                QVERIFY(std::get<std::int64_t>(*shown.frame->valueOf("i", shown.index)) == turn);
            }
        }
    }

    void theFirstLineStopsBetweenTwoFramesAndThenGoesOn()
    {
        Opened opened("single_spring", "radial");
        Session &session = opened.session;
        session.playback().breakpoints().toggle(inListing(session.lines().nextLine()));
        for (std::int64_t frame = 1; frame < 4; ++frame) { // the start never counts
            QVERIFY(playTo(session, 20));
            QCOMPARE(session.timeline().cursor(), (sim::Cursor{frame, 0}));
            QCOMPARE(session.lines().index(), 0);
        }
        session.lines().forward();
        session.lines().back();
        session.playback().frameForward(); // neither does a line that was stepped back to
        QCOMPARE(session.timeline().cursor().frame, 4);
    }

    void conditionIsEvaluatedOnlyAtItsLine()
    {
        Opened opened("single_spring", "radial");
        Session &session = opened.session;
        const int foot = session.timeline().track().interval().scene.find("foot");
        setStop(opened, "foot.velocity *= damp");
        const int id = session.playback().breakpoints().all().front().id;
        session.playback().breakpoints().setCondition(id, "frame == 7 and angle > -10");
        QVERIFY(playTo(session, 30));
        QCOMPARE(session.timeline().cursor(), (sim::Cursor{7, 0}));
        QCOMPARE(session.lines().nextLine(), opened.lineOf("foot.velocity *= damp"));
        QVERIFY(session.lines().state()->velocityOf(foot) !=
                published(session.step(), session.timeline().script(), 7).velocityOf(foot));
        QVERIFY(session.playback().breakHit()->sentence.endsWith(": frame == 7 and angle > -10."));
        QVERIFY(!playTo(session, 30));
    }

    void runningToALineStopsAtABreakpointBefore()
    {
        Opened opened("single_spring", "radial");
        Session &session = opened.session;
        const int last = opened.lineOf("foot.position += foot.velocity;");
        const int stop = opened.lineOf("foot.velocity *= damp");
        setStop(opened, "foot.velocity *= damp");
        for (std::int64_t frame = 0; frame < 3; ++frame) { // the second time through the end of a frame
            QVERIFY(session.lines().runTo(last));
            QCOMPARE(session.timeline().cursor(), (sim::Cursor{frame, 0}));
            QCOMPARE(session.lines().nextLine(), stop);
            QVERIFY(session.playback().breakHit());
            QVERIFY(session.lines().runTo(last));
            QCOMPARE(session.timeline().cursor(), (sim::Cursor{frame, 0}));
            QCOMPARE(session.lines().nextLine(), last);
            QVERIFY(!session.playback().breakHit());
        }
    }

    void runningToALineStopsAtTheFirstLineOfTheNextFrame()
    {
        Opened opened("single_spring", "radial");
        Session &session = opened.session;
        const int last = opened.lineOf("foot.position += foot.velocity;"), first = session.lines().nextLine();
        QVERIFY(session.lines().runTo(last));
        session.playback().breakpoints().toggle(inListing(first));
        QVERIFY(session.lines().runTo(last));
        QCOMPARE(session.timeline().cursor(), (sim::Cursor{1, 0}));
        QCOMPARE(session.lines().nextLine(), first);
        QVERIFY(session.playback().breakHit());
    }

    void disabledBreakpointOrOneOfAnotherMethodDoesNotStop()
    {
        Opened opened("single_spring", "radial");
        Session &session = opened.session;
        setStop(opened, "foot.velocity *= damp");
        session.playback().breakpoints().setOn(session.playback().breakpoints().all().front().id, false);
        QVERIFY(!playTo(session, 10));
        session.playback().breakpoints().setOn(session.playback().breakpoints().all().front().id, true);
        session.editor().setMethod("rk4");
        QVERIFY(!playTo(session, 20));
        session.editor().setMethod("published");
        QVERIFY(playTo(session, 30));
    }

    void breakpointOnALineThatDoesNotRunDoesNotStop()
    {
        Opened opened("single_spring", "radial");
        setStop(opened, "foot.position = hand;");
        QVERIFY(!playTo(opened.session, 10));
    }

    void breakpointsStayWithTheirStep()
    {
        Opened opened("single_spring", "radial");
        Session &session = opened.session;
        setStop(opened, "foot.velocity *= damp");
        const QList<int> lines = stopLines(session);
        session.openStep("single_spring", "drag");
        QCOMPARE(stopLines(session), QList<int>());
        session.openStep("single_spring", "radial");
        QCOMPARE(stopLines(session), lines);
    }

    void breakpointsMoveWithTheText()
    {
        Opened opened("single_spring", "radial");
        Session &session = opened.session;
        setStop(opened, "foot.velocity *= damp");
        const int line = opened.lineOf("foot.velocity *= damp");
        session.code().write("// one\n// two\n" + opened.listing());
        QCOMPARE(stopLines(session), QList<int>{line + 2});
        QCOMPARE(opened.lineOf("foot.velocity *= damp"), line + 2);
        session.code().write(Opened::with(session.code().text(), "velocity *= damp", "velocity *= 0.5"));
        QCOMPARE(stopLines(session), QList<int>{line + 2}); // also while it is rewritten
        session.editor().endGesture();
        session.editor().undo();
        QCOMPARE(session.code().text(), opened.listing());
        QCOMPARE(stopLines(session), QList<int>{line});
        QVERIFY(playTo(session, 20));
        session.code().write(Opened::with(session.code().text(), "        foot.velocity *= damp;\n", ""));
        QCOMPARE(stopLines(session), QList<int>());
    }

    void linesOfTwoTextsArePaired_data()
    {
        QTest::addColumn<QString>("before");
        QTest::addColumn<QString>("after");
        QTest::addColumn<QList<int>>("moved");
        const auto row = [](const char *name, const char *before, const char *after,
                            const QList<int> &moved) {
            QTest::newRow(name) << QString(before).replace(' ', '\n') << QString(after).replace(' ', '\n')
                                << moved;
        };
        row("the same", "a b c", "a b c", {1, 2, 3});
        row("inserted above", "a b c", "x a b c", {2, 3, 4});
        row("inserted between", "a b c", "a x y b c", {1, 4, 5});
        row("deleted", "a b c", "a c", {1, 0, 2});
        row("rewritten", "a b c", "a x c", {1, 2, 3});
        row("rewritten by more", "a b c", "a x y c", {1, 2, 4});
        row("rewritten by fewer", "a b c d", "a x d", {1, 2, 0, 3});
        row("two places", "a b c d e", "x b c d y z", {1, 2, 3, 4, 5});
        row("two places, shifted", "a b c d e", "x a b d e", {2, 3, 0, 4, 5});
        row("twice the same", "a a b", "a b", {1, 0, 2});
        row("everything", "a b", "x", {1, 0});
        row("from nothing", "", "a", {});
    }

    void linesOfTwoTextsArePaired()
    {
        QFETCH(QString, before);
        QFETCH(QString, after);
        QFETCH(QList<int>, moved);
        const std::vector<int> found = movedLines(before, after);
        QCOMPARE(QList<int>(found.begin() + 1, found.end()), moved);
    }

    void everyLineOfEveryListingThatRunsIsALineOfCode()
    {
        const LessonLibrary library = LessonLibrary::load({LESSON_DIR});
        int lines = 0;
        for (const LessonEntry &lesson : library.lessons) {
            for (const lessons::Step &step : lesson.steps) {
                if (step.listing.isEmpty())
                    continue;
                Session session(library);
                session.openStep(lesson.id, step.id);
                const std::shared_ptr<const ListingFrame> frame = session.lines().nextFrame();
                QVERIFY(frame);
                for (const listing::TracedLine &line : frame->lines()) {
                    QVERIFY2(lineOfCodeFrom(step.listing.text, line.line) == line.line,
                             qPrintable(QString("%1/%2, line %3").arg(lesson.id, step.id).arg(line.line)));
                    ++lines;
                }
            }
        }
        QVERIFY(lines > 1000);
    }

    void lineWithoutCodeSelectsTheNextLineOfCode()
    {
        const QString text = "double clock = 0; // runs once\n\nvoid frame()\n{\n    // a comment\n"
                             "    double a = 1 +\n        2;\n    if (a > 2)\n    {\n        a = 1;\n    }\n"
                             "    else\n        a = 2;\n}\n";
        for (const auto &[asked, found] :
             {std::pair(1, 6), {5, 6}, {6, 6}, {7, 8}, {9, 10}, {12, 13}, {14, 14}})
            QCOMPARE(lineOfCodeFrom(text, asked), found);
        QCOMPARE(lineOfCodeFrom(text, 15), 0);
        QCOMPARE(lineOfCodeFrom({}, 1), 0);
        QCOMPARE(lineOfCodeFrom("} ) if (", 1), 0); // no program at all
    }

    void ctrlAndAClickInTheMarginSetsADot()
    {
        ListingFixture shown("single_spring", "radial");
        const int line = shown.line("if (foot.held)");
        const auto click = [&](Qt::KeyboardModifiers modifiers, const QPoint &at) {
            QTest::mouseClick(shown.editor.viewport(), Qt::LeftButton, modifiers, at);
            tests::settle();
        };
        const QPoint number(20, shown.editor.lineRect(line).center().y());
        QVERIFY(shown.editor.tipAt(number).contains("Ctrl+click sets a breakpoint (F9)"));
        click(Qt::ControlModifier, number);
        QCOMPARE(stopLines(shown.session), QList<int>{line});
        QCOMPARE(shown.next(), shown.session.lines().nextLine()); // it did not run there
        QCOMPARE(shown.frame(), 0);
        QCOMPARE(shown.session.lines().index(), 0);
        const QImage picture = shown.editor.viewport()->grab().toImage();
        QCOMPARE(picture.pixelColor(dotOf(shown, line) * picture.devicePixelRatio()),
                 shown.theme.tokens().past);
        QVERIFY(shown.editor.tipAt(number).startsWith("The run stops before this line."));
        click({}, number); // beside the dot it runs to the line
        QCOMPARE(shown.next(), line);
        QCOMPARE(stopLines(shown.session), QList<int>{line});
        click({}, dotOf(shown, line));
        QCOMPARE(stopLines(shown.session), QList<int>());
    }

    void f9TogglesABreakpointOnTheLineOfTheCaret()
    {
        ListingFixture shown("single_spring", "radial");
        const int comment = shown.line("// the nearest place");
        shown.editor.setFocus();
        shown.editor.setCursorPosition(comment - 1, 0);
        QTest::keyClick(&shown.editor, Qt::Key_F9);
        QCOMPARE(stopLines(shown.session), QList<int>{comment + 1}); // the comment itself does not run
        QTest::keyClick(&shown.editor, Qt::Key_F9);
        QCOMPARE(stopLines(shown.session), QList<int>{comment + 1});
        shown.editor.setCursorPosition(comment, 4);
        QTest::keyClick(&shown.editor, Qt::Key_F9);
        QCOMPARE(stopLines(shown.session), QList<int>());
    }

    void aLineTypedAboveMovesTheDot()
    {
        ListingFixture shown("single_spring", "radial");
        const int line = shown.line("foot.velocity *= damp");
        shown.editor.setFocus();
        shown.editor.setCursorPosition(line - 1, 0);
        QTest::keyClick(&shown.editor, Qt::Key_F9);
        shown.editor.setCursorPosition(0, 0);
        QTest::keyClicks(&shown.editor, "// mine");
        QTest::keyClick(&shown.editor, Qt::Key_Return);
        shown.compile();
        QCOMPARE(shown.line("foot.velocity *= damp"), line + 1);
        QCOMPARE(shown.editor.stops().front().line, line + 1);
    }

    void theListNamesTheLineAndShowsIt()
    {
        ListingFixture shown("single_spring", "radial");
        const int line = shown.line("foot.velocity *= damp");
        shown.session.playback().breakpoints().toggle(inListing(line));
        tests::settle();
        const int id = shown.session.playback().breakpoints().all().front().id;
        const auto rowOf = [&](const BreakpointList &list) {
            return list.findChild<QCheckBox *>(QStringLiteral("on%1").arg(id));
        };
        QCheckBox *row = rowOf(shown.panel.stops());
        QVERIFY(row);
        QCOMPARE(row->text(), QString("line %1").arg(line));
        QTest::mouseClick(row, Qt::LeftButton, {}, {8, row->height() / 2});
        QCOMPARE(shown.editor.stops().front().isOn, false);
        shown.pages.choose(CodePages::Page::engine);
        tests::settle(); // the rows get their places
        row = rowOf(shown.pages.engine().stops());
        QVERIFY(row && row->isVisible());
        QTest::mouseClick(row, Qt::LeftButton, {}, {8, row->height() / 2}); // on again: its line is shown
        QVERIFY(shown.pages.page() == CodePages::Page::listing);
        int caretLine = 0, index = 0;
        shown.editor.getCursorPosition(&caretLine, &index);
        QCOMPARE(caretLine + 1, line);
    }

    void theListTakesAConditionForTheLine()
    {
        ListingFixture shown("single_spring", "radial");
        shown.session.playback().breakpoints().toggle(inListing(shown.line("foot.velocity *= damp")));
        tests::settle();
        const int id = shown.session.playback().breakpoints().all().front().id;
        auto *field = shown.panel.stops().findChild<QLineEdit *>(QStringLiteral("condition%1").arg(id));
        tests::typeInto(*field, "frame == 5");
        QCOMPARE(shown.panel.stops().errorText(), QString());
        QCOMPARE(shown.session.playback().breakpoints().find(id)->condition, QString("frame == 5"));
        QVERIFY(shown.editor.stops().front().hasCondition);
        QVERIFY(playTo(shown.session, 30));
        QCOMPARE(shown.frame(), 5);
        tests::settle();
        QCOMPARE(shown.next(), shown.line("foot.velocity *= damp"));
        QVERIFY(shown.editor.marks().isInside);
    }
};

SUITE(tst_line_breakpoints, LineBreakpointsTest)
#include "tst_line_breakpoints.moc"
