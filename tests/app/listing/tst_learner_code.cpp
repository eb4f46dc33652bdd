// The learner's code computes the run, and the run before the change stays visible as the ghost.

#include "app/listing/limits.h"
#include "app/model/analysis/accuracy_study.h"
#include "app/model/listing/changed_lines.h"
#include "app/model/listing/listing_names.h"
#include "app/model/run/run_program.h"
#include "tests/app/listing/code_session.h"
#include "tests/suite.h"

#include <QSignalSpy>

using namespace app;
using code_session::Opened;
using code_session::published;
using code_session::sameMotion;

namespace {

/// The listing of `radial` with 0.4 in place of k. It moves like the compiled pipeline with k = 0.4.
QString stiffer(const Opened &opened)
{
    return Opened::with(opened.listing(), "k * (target", "0.4 * (target");
}

sim::State publishedWith(const Opened &opened, double k, std::int64_t frame)
{
    sim::Script script = opened.session.timeline().script();
    script.values.set("k", k);
    return published(opened.session.step(), std::move(script), frame);
}

}

class LearnerCodeTest : public QObject
{
    Q_OBJECT

private slots:
    void theStepsOwnMethodIsItsListing()
    {
        Opened opened("single_spring", "radial");
        const LearnerCode &code = opened.session.code();
        QVERIFY(code.isOffered());
        QVERIFY(code.isInUse());
        QVERIFY(code.isRunning());
        QVERIFY(!code.isChanged());
        QCOMPARE(code.text(), opened.listing());
        QVERIFY(code.mistakes().empty());
        QCOMPARE(opened.session.timeline().script().method->id(), std::string("published"));
        QCOMPARE(opened.session.editor().undoStack().count(), 0);
    }

    void changedNumberGivesTheMotionOfTheChangedParameter()
    {
        Opened opened("single_spring", "radial");
        Session &session = opened.session;
        session.input().grab("foot");
        session.input().moveTo({100, 300});
        session.playback().frameForward();
        session.input().moveTo({160, 320});
        session.playback().frameForward();
        session.input().release();
        opened.goTo(120);
        const std::vector<sim::Event> input = session.timeline().script().input;
        QVERIFY(!input.empty());

        session.code().write(stiffer(opened));
        opened.waitUntilThere();
        QCOMPARE(session.timeline().script().method->id(), std::string("listing"));
        QCOMPARE(session.timeline().cursor(), (sim::Cursor{120, 0}));
        QVERIFY(session.timeline().script().input == input);
        QVERIFY(session.code().isInUse() && session.code().isChanged());
        QVERIFY(sameMotion(session.timeline().state(), publishedWith(opened, 0.4, 120)));
    }

    void runBeforeTheChangeBecomesTheGhost()
    {
        Opened opened("single_spring", "radial");
        Session &session = opened.session;
        opened.goTo(40);
        const sim::State before = session.timeline().state();
        session.code().write(stiffer(opened));
        opened.waitUntilThere();
        QTRY_VERIFY(!session.comparisons().isComputing());
        QVERIFY(session.timeline().comparison());
        QVERIFY(sameMotion(session.timeline().comparison()->state(), before));
        QVERIFY(!sameMotion(session.timeline().state(), before));
        QCOMPARE(session.comparisons().comparisonName(),
                 QString("before: foot.velocity += k * (target - …")); // not cut inside a word
    }

    void aCommentDoesNotNameTheGhost()
    {
        Opened opened("two_body", "leg_line"); // its listing begins with a comment
        Session &session = opened.session;
        opened.goTo(10);
        session.code().write("void frame()\n{\n}\n");
        opened.waitUntilThere();
        QTRY_COMPARE(session.comparisons().comparisonName(),
                     QString("before: Vec2 nearest(Body me, Body anchor)"));
    }

    void theGhostOfOneBurstOfTypingIsTheRunBeforeIt()
    {
        Opened opened("single_spring", "radial");
        Session &session = opened.session;
        opened.goTo(40);
        const sim::State before = session.timeline().state();
        for (const char *number : {"0.4", "0.45", "0.456"}) {
            session.code().write(
                Opened::with(opened.listing(), "k * (target", QString(number) + " * (target"));
            opened.waitUntilThere();
        }
        QCOMPARE(session.comparisons().branches().all().size(), std::size_t(1));
        QVERIFY(sameMotion(session.timeline().comparison()->state(), before));
        QVERIFY(sameMotion(session.timeline().state(), publishedWith(opened, 0.456, 40)));
        QCOMPARE(session.editor().undoStack().count(), 1);
    }

    void undoGoesBackOnePauseAtATime()
    {
        Opened opened("single_spring", "radial");
        Session &session = opened.session;
        opened.goTo(30);
        const sim::State start = session.timeline().state();
        const QString first = stiffer(opened), second = Opened::with(first, "*= damp", "*= 0.5");
        session.code().write(first);
        opened.waitUntilThere();
        const sim::State between = session.timeline().state();
        session.editor().endGesture(); // as after a pause
        session.code().write(second);
        opened.waitUntilThere();
        const sim::State end = session.timeline().state();
        QCOMPARE(session.editor().undoStack().count(), 2);

        session.editor().undo();
        opened.waitUntilThere();
        QCOMPARE(session.code().text(), first);
        QVERIFY(sameMotion(session.timeline().state(), between));
        session.editor().undo();
        opened.waitUntilThere();
        QCOMPARE(session.code().text(), opened.listing());
        QVERIFY(!session.code().isChanged());
        QVERIFY(sameMotion(session.timeline().state(), start));
        QCOMPARE(session.timeline().script().method->id(), std::string("published"));
        session.editor().redo();
        session.editor().redo();
        opened.waitUntilThere();
        QCOMPARE(session.code().text(), second);
        QVERIFY(sameMotion(session.timeline().state(), end));
    }

    void lastCompiledCodeRunsWhileTheTextDoesNotCompile()
    {
        Opened opened("single_spring", "radial");
        Session &session = opened.session;
        opened.goTo(20);
        session.code().write(stiffer(opened));
        opened.waitUntilThere();
        const sim::State good = session.timeline().state();
        const QString broken = Opened::with(stiffer(opened), "foot.velocity *= damp", "foot.velocty *= damp");
        session.code().write(broken);
        QCOMPARE(session.code().text(), broken);
        QVERIFY(session.code().isInUse());
        QVERIFY(!session.code().isRunning());
        QCOMPARE(session.code().mistakes().size(), std::size_t(1));
        const CodeMistake mistake = session.code().mistakes().front();
        QCOMPARE(mistake.line, opened.lineOf("velocty"));
        QCOMPARE(mistake.column, 14); // eight spaces and "foot."
        QCOMPARE(mistake.length, 7);
        QCOMPARE(mistake.sentence, QString("'velocty' is not a member of Body. Did you mean 'velocity'?"));
        QVERIFY(sameMotion(session.timeline().state(), good));
        session.playback().frameForward();
        QVERIFY(sameMotion(session.timeline().state(), publishedWith(opened, 0.4, 21)));

        const QString mended = Opened::with(broken, "velocty", "velocity");
        session.code().write(mended);
        opened.waitUntilThere();
        QVERIFY(session.code().isRunning());
        QVERIFY(session.code().mistakes().empty());
        QCOMPARE(session.code().text(), mended);
    }

    void aDraftIsUndoneLikeCodeThatRuns()
    {
        Opened opened("single_spring", "radial");
        Session &session = opened.session;
        session.code().write(opened.listing() + "}");
        QCOMPARE(session.editor().undoStack().count(), 1);
        QVERIFY(!session.code().mistakes().empty());
        QCOMPARE(session.comparisons().branches().all().size(), std::size_t(0));
        session.editor().undo();
        QCOMPARE(session.code().text(), opened.listing());
        QVERIFY(session.code().isRunning());
        session.editor().redo();
        QCOMPARE(session.code().text(), opened.listing() + "}");
    }

    void columnsCountCharactersNotBytes()
    {
        Opened opened("single_spring", "radial");
        opened.session.code().write(
            Opened::with(opened.listing(), "foot.velocity *= damp;", "/* dämpfen */ foot.velocity *= dämp;"));
        const std::vector<CodeMistake> mistakes = opened.session.code().mistakes();
        QVERIFY(!mistakes.empty());
        QCOMPARE(mistakes.front().line, opened.lineOf("dämp;"));
        const QString line = opened.session.code().text().split('\n')[mistakes.front().line - 1];
        QVERIFY2(mistakes.front().column <= line.indexOf("dämp;") + 3 &&
                     mistakes.front().column >= line.indexOf("dämp;") + 1,
                 qPrintable(QString::number(mistakes.front().column)));
    }

    void resettingBringsTheListingAndItsMethodBack()
    {
        Opened opened("single_spring", "radial");
        Session &session = opened.session;
        opened.goTo(25);
        const sim::State before = session.timeline().state();
        session.code().write(stiffer(opened));
        opened.waitUntilThere();
        QSignalSpy wasReset(&session.code(), &LearnerCode::wasReset);
        session.code().reset();
        opened.waitUntilThere();
        QCOMPARE(wasReset.count(), 1);
        QVERIFY(!session.code().isChanged());
        QCOMPARE(session.timeline().script().method->id(), std::string("published"));
        QVERIFY(sameMotion(session.timeline().state(), before));
        session.editor().undo();
        QCOMPARE(session.code().text(), stiffer(opened));
    }

    void anotherMethodKeepsTheText()
    {
        Opened opened("single_spring", "radial");
        Session &session = opened.session;
        session.code().write(stiffer(opened));
        session.editor().setMethod("rk4");
        QVERIFY(!session.code().isInUse());
        QCOMPARE(session.code().text(), stiffer(opened));
        QCOMPARE(session.timeline().script().method->id(), std::string("rk4"));
        const QString third = Opened::with(stiffer(opened), "*= damp", "*= 0.25");
        session.code().write(third); // kept, but not run
        QCOMPARE(session.timeline().script().method->id(), std::string("rk4"));
        session.code().use();
        QVERIFY(session.code().isInUse() && session.code().isRunning());
        QCOMPARE(session.code().text(), third);
        QCOMPARE(session.timeline().script().method->id(), std::string("listing"));
        session.editor().undo();
        QCOMPARE(session.timeline().script().method->id(), std::string("rk4"));
        QCOMPARE(session.code().text(), third);
    }

    void theStepsOwnMethodKeepsTheTextToo()
    {
        Opened opened("single_spring", "radial");
        Session &session = opened.session;
        session.code().write(stiffer(opened));
        session.editor().setMethod("published");
        QVERIFY(!session.code().isInUse());
        QCOMPARE(session.code().text(), stiffer(opened));
        session.code().use();
        QCOMPARE(session.timeline().script().method->id(), std::string("listing"));
    }

    void halfAStepIsRefusedForCode()
    {
        Opened opened("single_spring", "radial");
        Session &session = opened.session;
        session.code().write(stiffer(opened));
        QSignalSpy messages(&session.changes(), &ChangeNotifier::messageRequested);
        session.editor().setStepSize(0.5);
        QCOMPARE(session.timeline().script().step.h, 1.0);
        QCOMPARE(
            messages.last().first().toString(),
            QString("Your code computes whole frames, so its step cannot be 0.5. Choose a step of 1 frame."));
    }

    void aMistakeWhileItRunsStopsOnItsLine()
    {
        Opened opened("single_spring", "radial");
        Session &session = opened.session;
        opened.goTo(50);
        const QString divides = Opened::with(opened.listing(), "foot.velocity *= damp;",
                                             "int zero = 0; int one = frame_number > 9 ? 1 / zero : 0;");
        session.code().write(divides);
        QVERIFY(session.timeline().stop());
        QCOMPARE(session.timeline().stop()->frame, 9);
        QCOMPARE(session.timeline().cursor(), (sim::Cursor{9, 0}));
        const std::optional<listing::RunError> error = session.code().runError();
        QVERIFY(error);
        QCOMPARE(error->line, opened.lineOf("1 / zero"));
        QCOMPARE(endSentence(session.timeline().track()),
                 QString("Stopped at frame 9. Line %1 of your code: This divides by 0.").arg(error->line));
        // After the correction, the run is computed up to the learner's frame.
        session.code().write(stiffer(opened));
        opened.waitUntilThere();
        QCOMPARE(session.timeline().cursor(), (sim::Cursor{50, 0}));
        QVERIFY(!session.code().runError());
    }

    void aBranchKeepsItsCode()
    {
        Opened opened("single_spring", "radial");
        Session &session = opened.session;
        opened.goTo(30);
        session.code().write(stiffer(opened));
        opened.waitUntilThere();
        session.editor().endGesture();
        const QString softer = Opened::with(opened.listing(), "k * (target", "0.05 * (target");
        session.code().write(softer);
        opened.waitUntilThere();
        QCOMPARE(session.comparisons().branches().all().size(), std::size_t(2));
        session.editor().goBackTo(session.comparisons().branches().all().back().id);
        opened.waitUntilThere();
        QCOMPARE(session.code().text(), stiffer(opened));
        QVERIFY(sameMotion(session.timeline().state(), publishedWith(opened, 0.4, 30)));
        QVERIFY(session.code().isRunning());
        // The step's own run has no code, so the text stays as a draft.
        session.editor().goBackTo(session.comparisons().branches().all().front().id);
        QCOMPARE(session.timeline().script().method->id(), std::string("published"));
        QCOMPARE(session.code().text(), stiffer(opened));
        QVERIFY(!session.code().isInUse());
    }

    void everyStepKeepsItsOwnText()
    {
        Opened opened("single_spring", "radial");
        Session &session = opened.session;
        session.code().write(stiffer(opened));
        session.openStep("single_spring", "drag");
        QVERIFY(!session.code().isChanged());
        QCOMPARE(session.code().text(), opened.listing());
        session.code().write("void frame() {");
        session.openStep("single_spring", "radial");
        QCOMPARE(session.code().text(), stiffer(opened));
        QVERIFY(session.code().isRunning());
        session.openStep("single_spring", "drag");
        QCOMPARE(session.code().text(), QString("void frame() {"));
        QVERIFY(!session.code().mistakes().empty());
    }

    void hintSaysThatCodeCannotTakeShorterSteps()
    {
        Opened opened("multi_foot", "grown_feet");
        Session &session = opened.session;
        int halfFrame = 0;
        while (session.step().tries[std::size_t(halfFrame)].id != "half_frame")
            ++halfFrame;
        QCOMPARE(session.todo(halfFrame), QString());
        session.code().write(opened.listing() + "// mine\n");
        session.editor().setStepSize(0.5); // refused
        const QString todo = session.todo(halfFrame);
        QVERIFY2(todo.startsWith("your code computes this run, in steps of 1 frame."), qPrintable(todo));
        session.code().write(opened.listing());
        QCOMPARE(session.todo(halfFrame), QString());
        session.editor().setStepSize(0.5);
        QCOMPARE(session.timeline().script().step.h, 0.5);
    }

    void hintSaysThatCodeHasNoPhases()
    {
        Opened opened("rigid_constraint", "pair"); // its try asks for the pointer first, then for a phase
        Session &session = opened.session;
        const int beforeStick = 1;
        QCOMPARE(session.step().tries[std::size_t(beforeStick)].id, QString("before_stick"));
        QCOMPARE(session.todo(beforeStick), QString());
        session.code().write(opened.listing() + "// mine\n");
        const QString todo = session.todo(beforeStick);
        QVERIFY2(todo.startsWith("your code computes this run, and it has no phases."), qPrintable(todo));
        session.code().write(opened.listing());
        QCOMPARE(session.todo(beforeStick), QString());
    }

    void aPresetAndAnotherNumberOfFeetKeepTheCode()
    {
        Opened opened("multi_foot", "any_number");
        Session &session = opened.session;
        const QString text = Opened::with(opened.listing(), "me.velocity *= damp", "me.velocity *= 0.5");
        session.code().write(text);
        session.editor().setParameter("feet", 7);
        QCOMPARE(session.timeline().script().method->id(), std::string("listing"));
        QVERIFY(session.code().isRunning());
        opened.goTo(60);
        QCOMPARE(session.timeline().track().interval().scene.names.size(), std::size_t(8));
        sim::Script script = session.timeline().script();
        script.values.set("damp", 0.5);
        QVERIFY(sameMotion(session.timeline().state(), published(session.step(), script, 60)));
        session.editor().startAfresh();
        QCOMPARE(session.timeline().script().method->id(), std::string("published"));
        QCOMPARE(session.code().text(), text);
    }

    void oneChangeIsAnnouncedOnce()
    {
        Opened opened("single_spring", "radial");
        Session &session = opened.session;
        int texts = 0, runs = 0;
        session.onChange(ChangeKind::code, &session, [&] { ++texts; });
        session.onChange(ChangeKind::run, &session, [&] { ++runs; });
        session.code().write(stiffer(opened));
        QCOMPARE(texts, 1);
        QCOMPARE(runs, 1);
        session.code().write(stiffer(opened) + " ?");
        QCOMPARE(texts, 2);
        QCOMPARE(runs, 1);
        session.code().write(stiffer(opened) + " ?"); // the same
        QCOMPARE(texts, 2);
    }

    void tooLongTextIsAMistake()
    {
        Opened opened("single_spring", "radial");
        opened.session.code().write(opened.listing() + "// " + QString(int(listing::maxTextBytes), 'x'));
        QCOMPARE(opened.session.code().mistakes().size(), std::size_t(1));
        QCOMPARE(opened.session.timeline().script().method->id(), std::string("published"));
    }

    void theAccuracyStudyLeavesCodeOutAndSaysWhy()
    {
        Opened opened("single_spring", "radial");
        Session &session = opened.session;
        std::optional<sim::StudyPlan> asked;
        std::string measured;
        AccuracyStudy study(
            session.run(), session.editor(),
            [&](const sim::Script &script, const sim::StudyPlan &plan, const sim::StudyProgress &) {
                asked = plan;
                measured = script.method->id();
                return sim::Accuracy();
            });
        QVERIFY(study.leftOut().isEmpty());
        session.code().write(stiffer(opened));
        study.start();
        QTRY_COMPARE(study.stage(), AccuracyStudy::Stage::done);
        QVERIFY(asked && !asked->inUse);
        QCOMPARE(measured, std::string("published"));
        QVERIFY(study.leftOut().startsWith("Your code is left out"));
    }

    void theMarginShowsTheLinesThatChanged()
    {
        const QString before = "a\nb\nc\nd\n";
        QCOMPARE(changedLines(before, before), ChangedLines());
        QCOMPARE(changedLines(before, "a\nB\nc\nd\n"), (ChangedLines{{2}, {}}));
        QCOMPARE(changedLines(before, "a\nb\nnew\nc\nd\n"), (ChangedLines{{3}, {}}));
        QCOMPARE(changedLines(before, "a\nc\nd\n"), (ChangedLines{{}, {2}}));
        QCOMPARE(changedLines(before, "a\nb\n"), (ChangedLines{{}, {3}}));
        QCOMPARE(changedLines(before, "x\ny\na\nb\nc\n"), (ChangedLines{{1, 2}, {6}}));
        QCOMPARE(changedLines(before, "a  \nb\nc\nd"), ChangedLines()); // spaces at the end do not count
        QCOMPARE(changedLines({}, "a\nb"), (ChangedLines{{1, 2}, {}}));
    }

    void completionKnowsNamesAndMembers()
    {
        Opened opened("multi_foot", "any_number");
        const listing::Vocabulary &names = opened.session.code().vocabulary();
        const auto at = [&](const QString &line) {
            const QString text =
                "void frame()\n{\n    Vec2 from = feet[0].position;\n    Body foot = feet[1];\n" + line;
            return completionsAt(text, 5, static_cast<int>(line.size()) + 1, names);
        };
        QCOMPARE(at("fee"), QStringList{"feet"});
        QCOMPARE(at("fo"), (QStringList{"foot", "for"}));
        QVERIFY(at("ra").contains("radius") && at("ra").contains("random"));
        QCOMPARE(at("foot.po"), QStringList{"position"});
        QCOMPARE(at("feet[0].v"), QStringList{"velocity"});
        QCOMPARE(at("feet."), QStringList{"count"});
        QVERIFY(at("from.").contains("x") && at("from.").contains("y"));
        QVERIFY(at("feet[i].position.").contains("x"));
        QVERIFY(at("// fee").isEmpty());
        QVERIFY(at("12").isEmpty());
        QVERIFY(at("").isEmpty());
    }
};

SUITE(tst_learner_code, LearnerCodeTest)
#include "tst_learner_code.moc"
