// The recall questions of the lessons: their scenes fit, each can be answered, and answers are kept.

#include "app/model/experiment/experiment_line.h"
#include "app/model/learning/recall_desk.h"
#include "app/model/notebook/notebook_check.h"
#include "lessons/api/text/document.h"
#include "tests/app/notebook/notebook_maker.h"
#include "tests/app/support/two_lessons.h"
#include "tests/suite.h"

#include <QSignalSpy>
#include <QTest>

#include <algorithm>

using namespace app;

namespace {

/// The actions of a learner who answers a question in its scene.
struct RecallSolution
{
    const char *lesson;
    const char *question;
    std::vector<std::pair<const char *, double>> parameters = {};
    const char *method = nullptr;
    double h = 0.0;                       ///< frames, the step; 0: as it is
    const char *body = nullptr;           ///< dragged, and held at the end
    sim::Vec2 by = {};                    ///< px, in ten frames
    std::optional<sim::Vec2> target = {}; ///< px, from a click
    int frames = 0;                       ///< to go on afterwards
};

const RecallSolution recallSolutions[] = {
    {.lesson = "single_spring", .question = "twice_the_pull", .body = "foot", .by = {50, 0}, .frames = 3},
    {.lesson = "single_spring", .question = "left_of_body", .body = "foot", .by = {-120, -30}},
    {.lesson = "two_body", .question = "middle_stays", .method = "semi_implicit_euler", .frames = 60},
    {.lesson = "multi_foot", .question = "sixty_hold", .parameters = {{"k", 0.02}}, .frames = 400},
    {.lesson = "gravity_walls",
     .question = "hang_lower",
     .parameters = {{"k", 0.05}},
     .body = "body",
     .by = {0, -60},
     .frames = 300},
    {.lesson = "walking_gait", .question = "long_steps", .parameters = {{"leg", 90}}, .frames = 100},
    {.lesson = "swaying_tree", .question = "seven_branches", .parameters = {{"min_scale", 0.6}}},
    {.lesson = "rigid_constraint", .question = "comes_behind", .body = "p0", .by = {-220, 0}, .frames = 3},
    {.lesson = "codeling", .question = "look_down", .target = sim::Vec2{300, 900}, .frames = 300},
    {.lesson = "accuracy", .question = "on_the_ring", .method = "rk4", .frames = 100},
    {.lesson = "hard_cases", .question = "thirty", .h = 0.125, .frames = 120},
};

const lessons::RecallQuestion &questionOf(const LessonEntry &lesson, const QString &id)
{
    const std::vector<lessons::RecallQuestion> &all = lesson.recall.questions;
    const auto found = std::find_if(all.begin(), all.end(), [&](const auto &one) { return one.id == id; });
    return found == all.end() ? all.front() : *found;
}

/// Steps through the frames until the question is answered, at most `frames` of them.
void goOn(Session &session, const RecallDesk &desk, int frames)
{
    for (int i = 0; i < frames && !desk.isDone(); ++i)
        session.playback().frameForward();
}

void carryOut(const RecallSolution &solution, Session &session, const RecallDesk &desk)
{
    for (const auto &[id, value] : solution.parameters)
        session.editor().setParameter(id, value);
    if (solution.method)
        session.editor().setMethod(solution.method);
    if (solution.h > 0.0)
        session.editor().setStepSize(solution.h);
    if (solution.target)
        session.input().setTarget(*solution.target);
    if (solution.body) {
        const sim::Timeline &run = session.timeline();
        const sim::Vec2 from = run.state().positionOf(run.track().interval().scene.find(solution.body));
        session.input().grab(solution.body);
        for (int i = 1; i <= 10; ++i) {
            session.input().moveTo(from + (i / 10.0) * solution.by);
            goOn(session, desk, 1);
        }
    }
    goOn(session, desk, solution.frames);
}

/// Returns what a check finds about the answer in a notebook of this learner: the word for it.
QString foundInNotebook(const QString &lesson, Session &session)
{
    const Notebook book = collectNotebook({.lessons = {lesson}}, session.library(), session.progress(),
                                          session.notes(), session.proofs());
    for (const NotebookEntry &entry : book.entries) {
        if (entry.kind == NotebookEntry::Kind::answer)
            return wordFor(checkEntry(entry, session.library())->result);
    }
    return {};
}

/// Returns lessons of which the first has a question with choices, and one about its first step.
LessonLibrary lessonsWithQuestions()
{
    LessonLibrary library = tests::twoLessons();
    lessons::RecallQuestion choice{.id = "choice", .text = "Which?"};
    choice.choices = {{"Right", ""}, {"Wrong", "No."}, {"Also wrong", "No."}, {"Wrong, too", "No."}};
    lessons::RecallQuestion task{.id = "task", .text = "Do it."};
    task.task =
        lessons::RecallTask{{.step = "two/many", .values = {{"k", "0.5"}}, .until = "body.x > 0"}, "So."};
    task.task->setup.places = {{"foot", {100, 100}}};
    library.lessons[0].recall = {"one/recall.md", "Questions", "Two.", {choice, task}};
    return library;
}

}

class RecallQuestionsTest : public QObject
{
    Q_OBJECT

private slots:
    void init() { tests::forgetRecords(); }

    void everyQuestionFitsItsScene();
    void aSceneThatDoesNotFitIsNamed_data();
    void aSceneThatDoesNotFitIsNamed();
    void theSolutionOfEachQuestionIsAccepted_data();
    void theSolutionOfEachQuestionIsAccepted();
    void wrongAttemptsAreNotAccepted_data();
    void wrongAttemptsAreNotAccepted();
    void everySceneHasASolutionHere();
    void orderOfTheShuffledChoicesIsReproducible();
    void answersAreKeptAndCanBeChanged();
    void theSceneOpensWithItsValuesAndCanBeUndone();
    void waitingDoesNotAnswerAQuestion();
    void anotherStepEndsIt();
    void questionCanBeStartedAgain();
};

void RecallQuestionsTest::everyQuestionFitsItsScene()
{
    const LessonLibrary library = LessonLibrary::load({LESSON_DIR});
    int tasks = 0;
    for (const LessonEntry &lesson : library.lessons) {
        checkRecall(lesson.recall, library); // throws if it does not fit
        for (const lessons::RecallQuestion &question : lesson.recall.questions)
            tasks += question.task ? 1 : 0;
    }
    QVERIFY(tasks >= 10);
}

void RecallQuestionsTest::aSceneThatDoesNotFitIsNamed_data()
{
    using Setup = lessons::RunSetup;
    QTest::addColumn<Setup>("setup");
    QTest::addColumn<QString>("says");
    QTest::newRow("a step that is not there")
        << Setup{.step = "one/third", .until = "foot.x > 0"} << "there is no step \"one/third\".";
    QTest::newRow("a parameter that is not there")
        << Setup{.step = "one/first", .values = {{"mass", "1"}}, .until = "foot.x > 0"}
        << "no parameter \"mass\"";
    QTest::newRow("a value out of range")
        << Setup{.step = "one/first", .values = {{"damp", "7"}}, .until = "foot.x > 0"}
        << "damp cannot be \"7\".";
    QTest::newRow("a body that is not there") << Setup{.step = "one/first", .until = "leg.x > 0"} << "leg";
    QTest::newRow("a condition without an end")
        << Setup{.step = "one/first", .until = "foot.x >"} << "Character";
}

void RecallQuestionsTest::aSceneThatDoesNotFitIsNamed()
{
    QFETCH(lessons::RunSetup, setup);
    QFETCH(QString, says);
    LessonLibrary library = lessonsWithQuestions();
    setup.line = 12;
    library.lessons[0].recall.questions[1].task->setup = setup;
    try {
        checkRecall(library.lessons[0].recall, library);
        QFAIL("no mistake was found");
    } catch (const lessons::DocumentError &error) {
        const QString mistake = error.what();
        QVERIFY2(mistake.startsWith("one/recall.md, line 12: ") && mistake.contains(says),
                 qPrintable(mistake));
    }
}

void RecallQuestionsTest::theSolutionOfEachQuestionIsAccepted_data()
{
    QTest::addColumn<int>("number");
    int number = 0;
    for (const RecallSolution &one : recallSolutions)
        QTest::addRow("%s: %s", one.lesson, one.question) << number++;
}

void RecallQuestionsTest::theSolutionOfEachQuestionIsAccepted()
{
    QFETCH(int, number);
    const RecallSolution &solution = recallSolutions[number];
    const LessonLibrary library = LessonLibrary::load({LESSON_DIR});
    Session session(library);
    RecallDesk desk(session);
    const LessonEntry &lesson = *library.lesson(solution.lesson);
    desk.start(lesson, questionOf(lesson, solution.question));
    QVERIFY(desk.question() && desk.question()->id == solution.question);
    QVERIFY(!desk.isDone());
    goOn(session, desk, 5);
    QVERIFY(!desk.isDone());
    desk.startAgain();
    carryOut(solution, session, desk);
    QVERIFY(desk.isDone());
    QCOMPARE(foundInNotebook(lesson.id, session), QString("shown"));
}

void RecallQuestionsTest::wrongAttemptsAreNotAccepted_data()
{
    QTest::addColumn<RecallSolution>("attempt");
    const auto row = [](const char *name, const RecallSolution &attempt) { QTest::newRow(name) << attempt; };
    row("turned by its tail",
        {.lesson = "codeling", .question = "look_down", .body = "tail", .by = {40, -60}});
    row("looks down on its way only",
        {.lesson = "codeling", .question = "look_down", .target = sim::Vec2{30, 215}, .frames = 100});
    row("carried to the ring",
        {.lesson = "accuracy", .question = "on_the_ring", .body = "foot", .by = {-33.917, 0}, .frames = 120});
    row("held still",
        {.lesson = "multi_foot", .question = "sixty_hold", .body = "body", .by = {1, 0}, .frames = 400});
    row("carried by its own end", {.lesson = "rigid_constraint",
                                   .question = "comes_behind",
                                   .body = "p1",
                                   .by = {120, 0},
                                   .frames = 3});
    row("another method",
        {.lesson = "hard_cases", .question = "thirty", .method = "backward_euler", .frames = 120});
    row("held",
        {.lesson = "hard_cases", .question = "thirty", .body = "foot", .by = {-20, 0}, .frames = 120});
}

void RecallQuestionsTest::wrongAttemptsAreNotAccepted()
{
    QFETCH(RecallSolution, attempt);
    const LessonLibrary library = LessonLibrary::load({LESSON_DIR});
    Session session(library);
    RecallDesk desk(session);
    const LessonEntry &lesson = *library.lesson(attempt.lesson);
    desk.start(lesson, questionOf(lesson, attempt.question));
    carryOut(attempt, session, desk);
    QVERIFY(!desk.isDone());
}

void RecallQuestionsTest::everySceneHasASolutionHere()
{
    const LessonLibrary library = LessonLibrary::load({LESSON_DIR});
    for (const LessonEntry &lesson : library.lessons) {
        for (const lessons::RecallQuestion &question : lesson.recall.questions) {
            const bool isThere =
                std::any_of(std::begin(recallSolutions), std::end(recallSolutions), [&](const auto &one) {
                    return lesson.id == one.lesson && question.id == one.question;
                });
            QVERIFY2(!question.task || isThere, qPrintable(lesson.id + ": " + question.id));
        }
    }
}

void RecallQuestionsTest::orderOfTheShuffledChoicesIsReproducible()
{
    QVector<int> firstPlaces(4, 0);
    for (int i = 0; i < 200; ++i) {
        lessons::RecallQuestion question{.id = QString::number(i), .text = "Which?"};
        question.choices.resize(4);
        std::vector<std::size_t> order = RecallDesk::shuffled(question);
        QCOMPARE(order, RecallDesk::shuffled(question));
        ++firstPlaces[static_cast<qsizetype>(std::find(order.begin(), order.end(), 0u) - order.begin())];
        std::sort(order.begin(), order.end());
        QCOMPARE(order, std::vector<std::size_t>({0, 1, 2, 3}));
    }
    for (const int count : firstPlaces)
        QVERIFY2(count > 25 && count < 75, qPrintable(QString::number(count))); // of 200
}

void RecallQuestionsTest::answersAreKeptAndCanBeChanged()
{
    const LessonLibrary library = lessonsWithQuestions();
    const LessonEntry &lesson = library.lessons[0];
    const lessons::RecallQuestion &question = lesson.recall.questions[0];
    {
        Session session(library);
        RecallDesk desk(session);
        QVERIFY(!desk.chosen(lesson, question) && !desk.isAnswered(lesson, question));
        desk.choose(lesson, question, 2);
        QCOMPARE(desk.chosen(lesson, question), std::optional<std::size_t>(2));
        const Note *note = session.notes().find("one/recall:choice");
        QVERIFY(note && note->kind == "recall" && note->said == "2" && !note->isRight);
        desk.choose(lesson, question, 9); // there is no such choice
        QCOMPARE(desk.chosen(lesson, question), std::optional<std::size_t>(2));
    }
    Session session(library); // the next start of the program
    RecallDesk desk(session);
    QCOMPARE(desk.chosen(lesson, question), std::optional<std::size_t>(2));
    desk.choose(lesson, question, 0);
    QVERIFY(session.notes().find("one/recall:choice")->isRight);
}

void RecallQuestionsTest::theSceneOpensWithItsValuesAndCanBeUndone()
{
    const LessonLibrary library = lessonsWithQuestions();
    Session session(library);
    RecallDesk desk(session);
    desk.start(library.lessons[0], library.lessons[0].recall.questions[1]);
    QCOMPARE(session.lesson().id, QString("two"));
    QCOMPARE(session.editor().parameter("k"), 0.5);
    QCOMPARE(session.timeline().state().positionOf(0).x, 100.0);
    QVERIFY(!session.playback().isPlaying());
    QCOMPARE(desk.lesson(), &library.lessons[0]);
    session.editor().undo();
    QVERIFY(session.editor().parameter("k") != 0.5);
}

void RecallQuestionsTest::waitingDoesNotAnswerAQuestion()
{
    const LessonLibrary library = lessonsWithQuestions(); // the condition always holds
    Session session(library);
    RecallDesk desk(session);
    QSignalSpy changes(&desk, &RecallDesk::changed);
    desk.start(library.lessons[0], library.lessons[0].recall.questions[1]);
    goOn(session, desk, 20);
    QVERIFY(!desk.isDone());
    QVERIFY(!desk.isAnswered(library.lessons[0], *desk.question()));
    const auto before = changes.count();
    session.input().grab("foot");
    session.input().moveTo({120, 100});
    goOn(session, desk, 2);
    QVERIFY(desk.isDone());
    QCOMPARE(changes.count(), before + 1);
    QVERIFY(desk.isAnswered(library.lessons[0], *desk.question()));
    QCOMPARE(foundInNotebook("one", session), QString("shown"));
    // A notebook does not count it either: a run without input shows no answer.
    desk.startAgain();
    session.proofs().keep(RecallDesk::keyOf("one", "task"),
                          {.run = experimentLine(session.experiment(), library), .at = {20, 0}});
    QCOMPARE(foundInNotebook("one", session), QString("not shown"));
}

void RecallQuestionsTest::anotherStepEndsIt()
{
    const LessonLibrary library = lessonsWithQuestions();
    Session session(library);
    RecallDesk desk(session);
    desk.start(library.lessons[0], library.lessons[0].recall.questions[1]);
    session.editor().setParameter("feet", 7); // a new run of the same step
    QVERIFY(desk.question());
    session.openStep("one", "first");
    QVERIFY(!desk.question() && !desk.lesson());
    desk.start(library.lessons[0], library.lessons[0].recall.questions[0]); // it has no scene
    QVERIFY(!desk.question());
    QCOMPARE(session.step().id, QString("first"));
}

void RecallQuestionsTest::questionCanBeStartedAgain()
{
    const LessonLibrary library = lessonsWithQuestions();
    Session session(library);
    RecallDesk desk(session);
    desk.start(library.lessons[0], library.lessons[0].recall.questions[1]);
    session.editor().setParameter("k", 0.1);
    QVERIFY(desk.isDone());
    desk.startAgain();
    QVERIFY(desk.question() && !desk.isDone());
    QCOMPARE(session.editor().parameter("k"), 0.5);
    desk.stop();
    QVERIFY(!desk.question());
    desk.startAgain(); // nothing to start
    QVERIFY(!desk.question());
}

SUITE(tst_recall_questions, RecallQuestionsTest)
#include "tst_recall_questions.moc"
