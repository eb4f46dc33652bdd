// Tasks in listings: the gaps of a listing, and the desk that a learner writes at.

#include "app/model/listing/learner_code.h"
#include "app/model/listing/task_desk.h"
#include "app/ui/learn/learn_panel.h"
#include "app/ui/learn/lesson_list.h"
#include "app/ui/learn/lesson_model.h"
#include "app/ui/learn/narration.h"
#include "app/ui/learn/narration_text.h"
#include "app/ui/learn/task_box.h"
#include "app/ui/learn/try_box.h"
#include "app/ui/learn/why_box.h"
#include "lessons/api/listing.h"
#include "tests/app/support/panel_fixture.h"
#include "tests/app/support/window_fixture.h"
#include "tests/suite.h"

#include <QScrollArea>
#include <QScrollBar>
#include <QSettings>
#include <QSignalSpy>
#include <QTest>
#include <QToolButton>

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

/// Windows of 1280 x 800 px: with text of 100 % and of 125 %.
void addWindows()
{
    QTest::addColumn<QSize>("size");
    QTest::addColumn<QString>("language");
    QTest::newRow("English") << QSize(1280, 800) << "en";
    QTest::newRow("German") << QSize(1280, 800) << "de";
    QTest::newRow("English, large text") << QSize(1024, 640) << "en";
    QTest::newRow("German, large text") << QSize(1024, 640) << "de";
}

/// Checks that these buttons of a task are whole and in view.
void checkButtons(const TaskBox &box, const QStringList &names)
{
    for (const QString &name : names) {
        const auto *button = box.findChild<QToolButton *>(name);
        QVERIFY2(button->isVisible(), qPrintable(name));
        QCOMPARE(button->visibleRegion().boundingRect(), button->rect());
        QVERIFY2(button->width() >= button->sizeHint().width(), qPrintable(button->text()));
    }
}

/// Scrolls the text so that `y` px of the box are above its upper edge.
void scrollTo(const TaskBox &box, int y)
{
    const QWidget *above = box.parentWidget();
    while (!qobject_cast<const QScrollArea *>(above))
        above = above->parentWidget();
    qobject_cast<const QScrollArea *>(above)->verticalScrollBar()->setValue(box.y() + y);
    settle();
}

struct TaskPanelFixture : PanelFixture<LearnPanel>
{
    TaskPanelFixture() : PanelFixture(LessonLibrary::load({LESSON_DIR}), QSize(280, 732))
    {
        session.openStep("single_spring", "fixed_centre");
        settle();
    }

    TaskBox &box() const { return *panel.findChild<TaskBox *>(); }
    QToolButton &button(const char *name) const { return *box().findChild<QToolButton *>(name); }
    /// Returns the visible texts of the box with this name.
    QStringList texts(const char *name) const
    {
        QStringList all;
        for (const NarrationText *text : box().findChildren<NarrationText *>(name)) {
            if (text->isVisible())
                all << text->toPlainText();
        }
        return all;
    }
    void press(const char *name)
    {
        QVERIFY(button(name).isVisible());
        QTest::mouseClick(&button(name), Qt::LeftButton);
    }
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
    void startingEmptiesThePlace();
    void startingCanBeUndone();
    void rightCodeTicksTheTask();
    void aNearMissTellsWhatItDoes();
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
    void tasksAreUnfoldedAndStartedWithTheMouse();
    void thePanelShowsWhatIsWrongAndThenTheTick();
    void theStepIsTickedInTheListOfLessons();
    void theButtonsOfATaskStayInView_data();
    void theButtonsOfATaskStayInView();
    void nothingIsCutOffInASmallWindow_data();
    void nothingIsCutOffInASmallWindow();
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
    QCOMPARE(listing.emptied(task),
             QString("void frame()\n{\n    // First\n    // and second\n    foot.position += "
                     "foot.velocity;\n}\n"));
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

void CodeTasksTest::startingEmptiesThePlace()
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

void CodeTasksTest::aNearMissTellsWhatItDoes()
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
    world.write("foot.velocity += k * (centre - foot.position);"); // the very text of the listing
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
    // A file of progress from before there were tasks.
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
    QVERIFY(world.session.code().text().endsWith("\nvoid frame()\n{\n}\n"));
    QVERIFY(world.session.code().text().startsWith("// "));
    QVERIFY(world.session.code().program());
}

void CodeTasksTest::tasksAreUnfoldedAndStartedWithTheMouse()
{
    TaskPanelFixture world;
    auto *title = world.box().findChild<WhyButton *>();
    QVERIFY(title->text().contains("pull"));
    QVERIFY(world.texts("taskText").isEmpty());
    QTest::mouseClick(title, Qt::LeftButton);
    QCOMPARE(world.texts("taskText").size(), 1);
    QVERIFY(!world.button("stopTask").isVisible());
    QSignalSpy requests(&world.panel.narration(), &Narration::listingRequested);
    world.press("startTask");
    QCOMPARE(requests.count(), 1);
    const QStringList lines = world.session.code().text().split('\n');
    const int before = requests[0][0].toInt() - 1; // the second line of the comment, which is the last one
    QCOMPARE(lines[before - 1].trimmed(), QString("// The spring pulls the foot towards the"));
    QCOMPARE(lines[before].trimmed(), QString("// centre."));
    QVERIFY(!lines[before + 1].contains("//"));
    QVERIFY(world.session.code().text() != world.session.step().listing.text);
    QVERIFY(!world.button("startTask").isVisible());
    world.press("taskHintButton");
    world.press("taskHintButton");
    QCOMPARE(world.texts("taskHint").size(), 2);
    QCOMPARE(world.button("taskHintButton").text(), QString("Hint 3 of 3"));
    world.press("taskSolution");
    QCOMPARE(world.session.code().text(), world.session.step().listing.text);
    QCOMPARE(world.texts("taskSentence").size(), 1);
    world.press("stopTask");
    QVERIFY(world.texts("taskHint").isEmpty() && world.texts("taskSentence").isEmpty());
}

void CodeTasksTest::thePanelShowsWhatIsWrongAndThenTheTick()
{
    TaskPanelFixture world;
    QTest::mouseClick(world.box().findChild<WhyButton *>(), Qt::LeftButton);
    world.press("startTask");
    const auto with = [&](const QString &code) { return world.session.step().listing.with("pull", code); };
    world.session.code().write(with("foot.velocity += k * (foot.position - centre);"));
    QVERIFY(QTest::qWaitFor([&] { return world.texts("taskSentence").join("").contains("points away"); },
                            30'000));
    world.session.code().write(with(rightPull));
    QVERIFY(
        QTest::qWaitFor([&] { return world.box().findChild<WhyButton *>()->text().endsWith("✓"); }, 30'000));
    QVERIFY(world.texts("taskSentence").join("").startsWith("Right"));
}

void CodeTasksTest::theStepIsTickedInTheListOfLessons()
{
    TaskPanelFixture world;
    const LessonModel &lessons = world.panel.findChild<LessonList *>()->lessons();
    const QModelIndex row = lessons.openRow();
    for (int i = 0; i < static_cast<int>(world.session.step().tries.size()); ++i)
        world.session.progress().markDone("single_spring", "fixed_centre", i);
    QVERIFY(!lessons.data(row, LessonModel::doneRole).toBool());
    QCOMPARE(lessons.stepsDone(), 0);
    world.session.progress().markWritten("single_spring", "fixed_centre", "pull");
    QVERIFY(lessons.data(row, LessonModel::doneRole).toBool());
    QCOMPARE(lessons.stepsDone(), 1);
    QVERIFY(lessons.data(row, Qt::AccessibleTextRole).toString().contains(", done"));
}

void CodeTasksTest::theButtonsOfATaskStayInView_data()
{
    addWindows();
}

void CodeTasksTest::theButtonsOfATaskStayInView()
{
    QFETCH(QSize, size);
    QFETCH(QString, language);
    WindowFixture shown({.lesson = "walking_gait", .step = "ground", .size = size, .language = language});
    shown.window.findChild<LearnPanel *>()->setForm(LearnPanel::Form::whole);
    for (std::size_t i = 0; i < shown.session.step().codeTasks.size(); ++i) {
        auto &narration = shown.part<Narration>();
        TaskBox &box = *narration.findChildren<TaskBox *>()[static_cast<qsizetype>(i)];
        settle();
        QTest::mouseClick(box.findChild<WhyButton *>(), Qt::LeftButton);
        settle();
        checkButtons(box, {"startTask"});
        QTest::mouseClick(box.findChild<QToolButton *>("startTask"), Qt::LeftButton);
        settle();
        checkButtons(box, {"taskHintButton", "taskSolution", "stopTask"});
        for (int hint = 0; hint < 3; ++hint) {
            QTest::mouseClick(box.findChild<QToolButton *>("taskHintButton"), Qt::LeftButton);
            settle();
            checkButtons(box, {"taskSolution", "stopTask"});
        }
        scrollTo(box, 0); // its title is at the top, its end is out of view
        checkButtons(box, {"taskSolution", "stopTask"});
        QTest::mouseClick(box.findChild<QToolButton *>("taskSolution"), Qt::LeftButton);
        settle();
        checkButtons(box, {"startTask", "stopTask"});
        QTest::mouseClick(box.findChild<QToolButton *>("stopTask"), Qt::LeftButton);
        settle();
    }
}

void CodeTasksTest::nothingIsCutOffInASmallWindow_data()
{
    addWindows();
}

void CodeTasksTest::nothingIsCutOffInASmallWindow()
{
    QFETCH(QSize, size);
    QFETCH(QString, language);
    WindowFixture shown({.lesson = "walking_gait", .step = "ground", .size = size, .language = language});
    shown.window.findChild<LearnPanel *>()->setForm(LearnPanel::Form::whole);
    settle();
    // Each thing to try has the height that its text needs.
    const auto rows = shown.part<Narration>().findChildren<TryBox *>();
    QCOMPARE(rows.size(), static_cast<qsizetype>(shown.session.step().tries.size()));
    for (const TryBox *row : rows)
        QVERIFY2(row->height() >= row->heightForWidth(row->width()), qPrintable(row->accessibleName()));
    // The last one can be scrolled into view, if it is not there.
    auto &area = *shown.part<Narration>().findChild<QScrollArea *>();
    area.verticalScrollBar()->setValue(area.verticalScrollBar()->maximum());
    settle();
    QVERIFY(!rows.back()->visibleRegion().isEmpty());
    QVERIFY(rows.back()->visibleRegion().boundingRect().bottom() >= rows.back()->height() - 1);
}

SUITE(tst_code_tasks, CodeTasksTest)
#include "tst_code_tasks.moc"
