// Tasks in listings: the gaps of a listing, and the judgement of the learner's code.

#include "app/model/listing/learner_code.h"
#include "app/model/listing/task_desk.h"
#include "lessons/api/listing.h"
#include "tests/app/support/session_fixture.h"
#include "tests/suite.h"

#include <QSettings>
#include <QSignalSpy>
#include <QTest>

using namespace app;
using namespace tests;

namespace {

const char *const source = R"(void frame()
{
    //> pull
    foot.velocity += 1;
    if (true)
        foot.velocity *= 2;
    //<
    //> move
    foot.position += foot.velocity;
    //<
}
)";

const char *const rightPull = "foot.velocity = foot.velocity + (centre - foot.position) * k;";

struct DeskFixture : SessionFixture
{
    DeskFixture() : SessionFixture(LessonLibrary::load({LESSON_DIR}))
    {
        session.openStep("single_spring", "fixed_centre");
    }

    /// Returns the learner's text with `code` in place of the pull.
    QString with(const QString &code) const { return session.step().listing.with("pull", code); }
    /// Types `code` in place of the pull, and waits for the judgement.
    void write(const QString &code)
    {
        session.code().write(with(code));
        waitForJudge();
    }
    void waitForJudge()
    {
        QVERIFY(QTest::qWaitFor([this] { return !desk.isJudging(); }, 30'000));
    }
    bool isTicked() { return session.progress().isWritten("single_spring", "fixed_centre", "pull"); }
    const lessons::CodeTask &pull() const { return session.step().codeTasks.front(); }

    TaskDesk desk{session};
};

}

class CodeTasksTest : public QObject
{
    Q_OBJECT

private slots:
    void init() { QSettings().clear(); }

    void aListingHidesTheMarkersOfItsGaps();
    void aGapIsReplacedWithItsIndentation();
    void wrongMarkersAreRejected_data();
    void wrongMarkersAreRejected();
    void startingATaskEmptiesItsGap();
    void noLineOfTheSolutionNamesTheGhost();
    void startingCanBeUndone();
    void rightCodeTicksTheTask();
    void nearMissGetsItsOwnSentence();
    void codeThatDoesNotCompileHasNoJudgement();
    void theLastTextIsJudged();
    void resettingTheListingTicksNothing();
    void theSolutionTicksNothing();
    void typingTheListingsOwnLineTicks();
    void hintsComeOneByOne();
    void everyJudgementSaysThatItIsAtWork();
    void aTaskCountsForTheStep();
    void aTaskWaitsWhileAnotherStepIsOpen();
    void theWholeFrameBeginsWithAnEmptyFunction();
};

void CodeTasksTest::aListingHidesTheMarkersOfItsGaps()
{
    const lessons::Listing listing = lessons::parseListing(source);
    QCOMPARE(listing.text,
             QString("void frame()\n{\n    foot.velocity += 1;\n    if (true)\n        foot.velocity "
                     "*= 2;\n    foot.position += foot.velocity;\n}\n"));
    QCOMPARE(listing.gaps.size(), 2U);
    QVERIFY(*listing.gap("pull") == (lessons::Gap{"pull", 3, 3}));
    QVERIFY(*listing.gap("move") == (lessons::Gap{"move", 6, 1}));
    QVERIFY(!listing.gap("other"));
    QCOMPARE(listing.solution("pull"), QString("foot.velocity += 1;\nif (true)\n    foot.velocity *= 2;\n"));
    QCOMPARE(listing.solution("frame"), listing.text);
    QVERIFY(lessons::parseListing({}).isEmpty());
}

void CodeTasksTest::aGapIsReplacedWithItsIndentation()
{
    const lessons::Listing listing = lessons::parseListing(source);
    QCOMPARE(
        listing.with("move", "a;\n\n    b;"),
        QString("void frame()\n{\n    foot.velocity += 1;\n    if (true)\n        foot.velocity *= 2;\n    "
                "a;\n\n        b;\n}\n"));
    QCOMPARE(listing.with("pull", listing.solution("pull")), listing.text);
    QCOMPARE(listing.with("other", "a;"), listing.text);
    lessons::CodeTask task;
    task.id = "pull";
    task.comment = "First\nand second";
    QCOMPARE(listing.emptied(task), QString("void frame()\n{\n    // First\n    // and second\n    \n    "
                                            "foot.position += foot.velocity;\n}\n"));
    QCOMPARE(listing.lineToWrite(task), 5);
    task.comment = "A comment that is too long for a narrow panel is broken between two words.";
    QVERIFY(listing.emptied(task).contains("    // A comment that is too long for a\n    // narrow panel"));
}

void CodeTasksTest::wrongMarkersAreRejected_data()
{
    QTest::addColumn<QString>("text");
    QTest::addColumn<QString>("place");
    QTest::newRow("no end") << "//> a\nx;\n"
                            << "line 2";
    QTest::newRow("no begin") << "x;\n//<\n"
                              << "line 2";
    QTest::newRow("inside another") << "//> a\n//> b\nx;\n//<\n//<\n"
                                    << "line 2";
    QTest::newRow("empty") << "//> a\n//<\n"
                           << "line 2";
    QTest::newRow("twice") << "//> a\nx;\n//<\n//> a\ny;\n//<\n"
                           << "line 4";
    QTest::newRow("no id") << "//>\nx;\n//<\n"
                           << "line 1";
    QTest::newRow("whole frame") << "//> frame\nx;\n//<\n"
                                 << "line 1";
}

void CodeTasksTest::wrongMarkersAreRejected()
{
    QFETCH(QString, text);
    QFETCH(QString, place);
    try {
        lessons::parseListing(text);
        QFAIL("accepted");
    } catch (const std::runtime_error &error) {
        QVERIFY2(QString(error.what()).startsWith(place), error.what());
    }
}

void CodeTasksTest::startingATaskEmptiesItsGap()
{
    DeskFixture world;
    QVERIFY(!world.desk.task());
    world.desk.start("pull");
    QCOMPARE(world.desk.task(), &world.pull());
    QCOMPARE(world.session.code().text(), world.session.step().listing.emptied(world.pull()));
    QVERIFY(world.desk.sentence().isEmpty());
    QVERIFY(!world.desk.verdict());
    world.desk.start("no such task");
    QCOMPARE(world.desk.task(), &world.pull());
}

void CodeTasksTest::noLineOfTheSolutionNamesTheGhost()
{
    DeskFixture world;
    world.goTo(20);
    world.desk.start("pull");
    QTRY_VERIFY(world.arrives());
    QCOMPARE(world.session.comparisons().comparisonName(), "before: the listing of the step");
    world.session.code().write(world.with("foot.velocity.x = 1;"));
    QTRY_VERIFY(world.arrives());
    world.desk.start("pull");
    QTRY_VERIFY(world.arrives());
    QCOMPARE(world.session.comparisons().comparisonName(), "before: your code");
}

void CodeTasksTest::startingCanBeUndone()
{
    DeskFixture world;
    world.session.code().write(world.session.step().listing.text + "// mine\n");
    const QString before = world.session.code().text();
    world.desk.start("pull");
    world.session.editor().undo();
    QCOMPARE(world.session.code().text(), before);
    QVERIFY(!world.desk.task());
    QVERIFY(!world.isTicked());
}

void CodeTasksTest::rightCodeTicksTheTask()
{
    DeskFixture world;
    world.desk.start("pull");
    QSignalSpy ticks(&world.session.progress(), &Progress::changed);
    world.write(rightPull);
    QVERIFY(world.desk.verdict()->kind == Verdict::Kind::right);
    QVERIFY(world.isTicked() && world.desk.isDone(world.pull()));
    QCOMPARE(ticks.count(), 1);
    QVERIFY(world.desk.sentence().startsWith("Right"));
    QVERIFY(Progress().isWritten("single_spring", "fixed_centre", "pull")); // also after a new start
    QVERIFY(!world.session.progress().isDone("single_spring", "fixed_centre", 0));
    world.session.progress().forgetLesson("single_spring");
    QVERIFY(!world.isTicked());
}

void CodeTasksTest::nearMissGetsItsOwnSentence()
{
    DeskFixture world;
    world.desk.start("pull");
    world.write("foot.velocity -= (centre - foot.position) * k;");
    QVERIFY(world.desk.verdict()->kind == Verdict::Kind::nearMiss);
    QVERIFY(world.desk.sentence().contains("points away"));
    QVERIFY(!world.isTicked());
}

void CodeTasksTest::codeThatDoesNotCompileHasNoJudgement()
{
    DeskFixture world;
    world.desk.start("pull");
    world.write("foot.velocity += k * (foot.position - centre);");
    QVERIFY(world.desk.verdict());
    world.write("foot.velocity += k * (");
    QVERIFY(!world.desk.verdict());
    QVERIFY(world.desk.sentence().isEmpty()); // the editor says what is wrong
}

void CodeTasksTest::theLastTextIsJudged()
{
    DeskFixture world;
    world.desk.start("pull");
    world.session.code().write(world.with(rightPull));
    world.write("foot.velocity += k * (foot.position - centre);"); // before the first judgement has arrived
    QVERIFY(world.desk.verdict()->kind == Verdict::Kind::nearMiss);
    QVERIFY(!world.isTicked());
}

void CodeTasksTest::resettingTheListingTicksNothing()
{
    DeskFixture world;
    world.desk.start("pull");
    world.session.code().reset();
    world.waitForJudge();
    QCOMPARE(world.session.code().text(), world.session.step().listing.text);
    QVERIFY(!world.desk.task());
    QVERIFY(!world.isTicked());
}

void CodeTasksTest::theSolutionTicksNothing()
{
    DeskFixture world;
    world.desk.start("pull");
    world.desk.showSolution();
    world.waitForJudge();
    QCOMPARE(world.session.code().text(), world.session.step().listing.text);
    QVERIFY(world.desk.isSolutionShown());
    QVERIFY(world.desk.sentence().contains("solution"));
    QVERIFY(!world.isTicked());
    world.write(rightPull); // nor does another text while it is shown
    QVERIFY(!world.isTicked());
    world.desk.start("pull");
    QVERIFY(!world.desk.isSolutionShown());
    world.write(rightPull);
    QVERIFY(world.isTicked());
}

void CodeTasksTest::typingTheListingsOwnLineTicks()
{
    DeskFixture world;
    world.desk.start("pull");
    world.write("foot.velocity += k * (centre - foot.position);"); // exactly the text of the listing
    QCOMPARE(world.session.code().text(), world.session.step().listing.text);
    QVERIFY(world.isTicked());
}

void CodeTasksTest::hintsComeOneByOne()
{
    DeskFixture world;
    world.desk.showNextHint(); // no task yet
    QCOMPARE(world.desk.hintsShown(), 0);
    world.desk.start("pull");
    for (const int shown : {1, 2, 3, 3}) {
        world.desk.showNextHint();
        QCOMPARE(world.desk.hintsShown(), shown);
    }
    world.desk.stop();
    QVERIFY(!world.desk.task());
    QCOMPARE(world.desk.hintsShown(), 0);
}

void CodeTasksTest::everyJudgementSaysThatItIsAtWork()
{
    DeskFixture world;
    world.desk.start("pull");
    for (const char *code :
         {"foot.velocity -= (centre - foot.position) * k;", rightPull, "foot.velocity.x += 1;"}) {
        world.session.code().write(world.with(code));
        QVERIFY(world.desk.isJudging());
        QVERIFY(!world.desk.verdict());
        QVERIFY2(world.desk.sentence().startsWith("Trying your code"), qPrintable(world.desk.sentence()));
        world.waitForJudge();
        QVERIFY(!world.desk.sentence().startsWith("Trying your code"));
    }
}

void CodeTasksTest::aTaskCountsForTheStep()
{
    DeskFixture world;
    const lessons::Step &step = world.session.step();
    const auto isDone = [&] { return world.session.isStepDone(world.session.lesson(), step); };
    QVERIFY(!step.tries.empty());
    // A progress file of a version without tasks.
    QStringList ticks;
    for (int i = 0; i < static_cast<int>(step.tries.size()); ++i)
        ticks << QString("single_spring/fixed_centre/%1").arg(i);
    world.session.progress().giveBack(ticks);
    QVERIFY(world.session.progress().isDone("single_spring", "fixed_centre", 0));
    QVERIFY(!isDone());
    world.desk.start("pull");
    world.write(rightPull);
    QVERIFY(isDone());
    const Session restarted(world.library);
    QVERIFY(restarted.isStepDone(*world.library.lesson("single_spring"), step));
    const QStringList forgotten = world.session.progress().forgetLesson("single_spring");
    QVERIFY(!isDone());
    world.session.progress().giveBack(forgotten);
    QVERIFY(isDone());
}

void CodeTasksTest::aTaskWaitsWhileAnotherStepIsOpen()
{
    DeskFixture world;
    world.desk.start("pull");
    world.desk.showNextHint();
    world.session.openStep("single_spring", "drag");
    QVERIFY(!world.desk.task());
    world.session.openStep("single_spring", "fixed_centre");
    QCOMPARE(world.desk.task(), &world.pull());
    QCOMPARE(world.desk.hintsShown(), 1);
    world.write(rightPull);
    QVERIFY(world.isTicked());
}

void CodeTasksTest::theWholeFrameBeginsWithAnEmptyFunction()
{
    DeskFixture world;
    world.session.openStep("single_spring", "radial");
    world.desk.start("frame");
    QVERIFY(world.desk.task()->isWholeFrame());
    QVERIFY(world.session.code().text().endsWith("\nvoid frame()\n{\n    \n}\n"));
    QVERIFY(world.session.code().text().startsWith("// "));
    QVERIFY(world.session.code().program());
}

SUITE(tst_code_tasks, CodeTasksTest)
#include "tst_code_tasks.moc"
