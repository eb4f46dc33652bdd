// Predictions of a learner, and the notes that are kept of them.

#include "app/model/learning/prediction_desk.h"
#include "app/model/learning/prediction_text.h"
#include "app/model/run/same_run.h"
#include "tests/app/model/predictions_support.h"
#include "tests/app/support/session_fixture.h"
#include "tests/suite.h"

#include <QSettings>
#include <QSignalSpy>
#include <QTest>

#include <algorithm>

using namespace app;
using namespace predictions_support;
using namespace tests;

namespace {

struct PredictionFixture : SessionFixture
{
    explicit PredictionFixture(const QString &step, const QString &lesson = "single_spring")
        : SessionFixture(predictedLessons())
    {
        session.openStep(lesson, step);
        session.playback().setSpeed(4.0);
    }

    bool knows(const QString &id)
    {
        return QTest::qWaitFor([&] { return desk.truth(id) != nullptr; }, 20'000);
    }
    bool isShown(const QString &id) const { return desk.sheet(id).stage == PredictionDesk::Stage::shown; }
    /// Predicts, and waits until the run has ended.
    bool predict(const QString &id, const PredictedAnswer &answer)
    {
        desk.say(id, answer);
        desk.commit(id);
        return QTest::qWaitFor([&] { return isShown(id); }, 30'000);
    }
    const lessons::Step &stepCalled(const QString &id) const
    {
        return *library.lesson("single_spring")->step(id);
    }
    bool isTicked(int number)
    {
        return session.progress().isDone(session.lesson().id, session.step().id, number);
    }
    std::int64_t frame() const { return session.timeline().cursor().frame; }

    PredictionDesk desk{session};
};

}

class PredictionsTest : public QObject
{
    Q_OBJECT

private slots:
    void init() { QSettings().clear(); }

    void committingPlaysTheRunToItsEnd();
    void undoBringsTheLearnersOwnRunBack();
    void aNoteIsKeptAndShownAgain();
    void predictingAgainStartsOver();
    void changingTheRunInterruptsThePrediction();
    void openingAnotherStepEndsThePrediction();
    void pausingDoesNotLoseTheEnd();
    void newTextsOfTheStepAreFollowed();
    void theRunOfAPredictionTicksNothing();
    void theRunOfAPredictionSaysWhyNothingCountsInIt();
    void changesByThePredictionAreNotTickedWhenTheLearnerGoesOn();
    void changesByThePredictionAreNotTickedWhenTheRunComesBack();
    void positionIsPickedAtTheStartOfTheRun();
    void outcomesAreSentences_data();
    void outcomesAreSentences();
};

void PredictionsTest::committingPlaysTheRunToItsEnd()
{
    PredictionFixture fixture("fixed_centre");
    QVERIFY(fixture.knows("past"));
    const std::int64_t end = fixture.desk.truth("past")->end;
    fixture.desk.commit("past"); // without an answer
    QVERIFY(!fixture.session.playback().isPlaying());
    fixture.desk.say("past", PredictedAnswer{.number = 20.0});
    fixture.desk.commit("past");
    QCOMPARE(fixture.frame(), std::int64_t{0});
    QVERIFY(fixture.session.playback().isPlaying());
    QVERIFY(fixture.desk.sheet("past").stage == PredictionDesk::Stage::playing);
    QTRY_VERIFY_WITH_TIMEOUT(fixture.isShown("past"), 30'000);
    QCOMPARE(fixture.frame(), end);
    QVERIFY(!fixture.session.playback().isPlaying());
    QVERIFY(fixture.session.timeline().state().position(0, 0) < 270.0);
    QCOMPARE(fixture.desk.sheet("past").found->number, static_cast<double>(end));
    // The run is held only the first time that it reaches the end.
    fixture.session.playback().play();
    QTRY_VERIFY_WITH_TIMEOUT(fixture.frame() > end + 5, 30'000);
}

void PredictionsTest::undoBringsTheLearnersOwnRunBack()
{
    PredictionFixture fixture("fixed_centre");
    fixture.session.editor().setParameter("k", 0.33);
    fixture.goTo(12);
    const sim::Script own = fixture.session.timeline().script();
    const int edits = fixture.session.editor().undoStack().count();
    QVERIFY(fixture.predict("past", {.number = 20.0}));
    QCOMPARE(fixture.session.editor().undoStack().count(), edits + 1);
    QVERIFY(!sameScript(own, fixture.session.timeline().script()));
    fixture.session.editor().undo();
    QVERIFY(sameScript(own, fixture.session.timeline().script()));
    QVERIFY(fixture.isShown("past")); // her answer stays
    QVERIFY(!fixture.desk.mark());
}

void PredictionsTest::aNoteIsKeptAndShownAgain()
{
    const QString key = "single_spring/fixed_centre/predict:which";
    {
        PredictionFixture fixture("fixed_centre");
        QVERIFY(fixture.predict("which", {.curve = 2}));
        const Note *note = fixture.session.notes().find(key);
        QVERIFY(note);
        QCOMPARE(note->kind, QString("curve"));
        QCOMPARE(note->said, QString("2"));
        QCOMPARE(note->found, QString("0"));
        QVERIFY(!note->isRight);
        QVERIFY(note->at.isValid());
    }
    QSettings().sync();
    PredictionFixture fixture("fixed_centre"); // as after a restart
    QVERIFY(fixture.isShown("which"));
    QCOMPARE(fixture.desk.sheet("which").said->curve, 2);
    QCOMPARE(fixture.session.notes().find(key)->at, Notes().find(key)->at);
    fixture.session.notes().forget(key);
    QVERIFY(!Notes().find(key));
}

void PredictionsTest::predictingAgainStartsOver()
{
    PredictionFixture fixture("fixed_centre");
    QVERIFY(fixture.predict("past", {.number = 20.0}));
    fixture.desk.say("past", PredictedAnswer{.number = 21.0}); // too late
    QCOMPARE(fixture.desk.sheet("past").said->number, 20.0);
    fixture.desk.startAgain("past");
    QVERIFY(!fixture.desk.sheet("past").said);
    QVERIFY(fixture.predict("past", {.number = 9.0}));
    QCOMPARE(fixture.session.notes().find("single_spring/fixed_centre/predict:past")->said, QString("9"));
}

void PredictionsTest::changingTheRunInterruptsThePrediction()
{
    PredictionFixture fixture("fixed_centre");
    QVERIFY(fixture.knows("past"));
    fixture.session.playback().setSpeed(0.1);
    fixture.desk.say("past", PredictedAnswer{.number = 20.0});
    fixture.desk.commit("past");
    fixture.session.editor().setParameter("k", 0.4);
    QVERIFY(fixture.desk.sheet("past").stage == PredictionDesk::Stage::open);
    QVERIFY(fixture.desk.sheet("past").wasInterrupted);
    QVERIFY(fixture.desk.sheet("past").said);
    QVERIFY(!fixture.session.notes().find("single_spring/fixed_centre/predict:past"));
    fixture.session.playback().setSpeed(4.0);
    fixture.desk.commit("past");
    QTRY_VERIFY_WITH_TIMEOUT(fixture.isShown("past"), 30'000);
    QCOMPARE(fixture.frame(), fixture.desk.truth("past")->end);
}

void PredictionsTest::openingAnotherStepEndsThePrediction()
{
    PredictionFixture fixture("fixed_centre");
    QVERIFY(fixture.knows("past"));
    fixture.session.playback().setSpeed(0.1);
    fixture.desk.say("past", PredictedAnswer{.number = 20.0});
    fixture.desk.commit("past");
    fixture.session.openStep("single_spring", "drag");
    QVERIFY(!fixture.desk.sheet("past").said); // not of this step
    QVERIFY(fixture.knows("throw"));
    fixture.session.openStep("single_spring", "fixed_centre");
    QVERIFY(fixture.desk.sheet("past").stage == PredictionDesk::Stage::open);
    QCOMPARE(fixture.desk.sheet("past").said->number, 20.0);
}

void PredictionsTest::pausingDoesNotLoseTheEnd()
{
    PredictionFixture fixture("fixed_centre");
    QVERIFY(fixture.knows("past"));
    fixture.desk.say("past", PredictedAnswer{.number = 20.0});
    fixture.desk.commit("past");
    fixture.session.playback().pause();
    QVERIFY(fixture.desk.sheet("past").stage == PredictionDesk::Stage::playing);
    fixture.session.playback().play();
    QTRY_VERIFY_WITH_TIMEOUT(fixture.isShown("past"), 30'000);
    QCOMPARE(fixture.frame(), fixture.desk.truth("past")->end);
}

void PredictionsTest::newTextsOfTheStepAreFollowed()
{
    PredictionFixture fixture("fixed_centre");
    QVERIFY(fixture.predict("past", {.number = 20.0}));
    for (lessons::Step &step : fixture.library.lessons[0].steps) {
        if (step.id == u"fixed_centre")
            step.predictions[0].run.values = {{"k", "0.2"}, {"damp", "0.9"}};
    }
    fixture.session.announceTexts();
    QVERIFY(fixture.knows("past"));
    const std::vector<double> x = publishedX(510.0, 0.2, 0.9, 100);
    const auto past = std::find_if(x.begin(), x.end(), [](double at) { return at < 270.0; }) - x.begin();
    QCOMPARE(fixture.desk.truth("past")->end, std::int64_t{past});
    QCOMPARE(fixture.desk.sheet("past").found->number, static_cast<double>(past));
}

void PredictionsTest::theRunOfAPredictionTicksNothing()
{
    PredictionFixture fixture("drag");
    QVERIFY(fixture.predict("throw", {.place = {290.0, 200.0}}));
    const lessons::Step &step = fixture.session.step();
    QVERIFY(!step.tries.empty());
    for (int i = 0; i < static_cast<int>(step.tries.size()); ++i) {
        QVERIFY(!fixture.session.progress().isDone("single_spring", "drag", i));
        const QString todo = fixture.session.todo(i);
        QVERIFY2(todo.isEmpty() || todo.contains("set up for you"), qPrintable(todo));
    }
}

void PredictionsTest::theRunOfAPredictionSaysWhyNothingCountsInIt()
{
    PredictionFixture fixture("fixed_centre");
    const auto todo = [&] { return fixture.session.todo(1); }; // stop inside a frame, after the spring's pull
    QVERIFY(fixture.predict("past", {.number = 20.0}));
    QCOMPARE(todo(), QString());               // not begun yet
    fixture.session.playback().phaseForward(); // the learner continues this run
    QVERIFY(fixture.session.timeline().cursor().phase > 0);
    QVERIFY2(todo().contains("set up for you"), qPrintable(todo()));
    fixture.session.playback().play();
    QCOMPARE(todo(), QString()); // a playing run leaves no time to read
    fixture.session.editor().undo();
    fixture.session.playback().goTo({3, 1});
    QVERIFY2(!todo().contains("set up for you"), qPrintable(todo()));
}

// In the step "branches", the prediction sets the spread to 90°, which is also the first thing to try.
void PredictionsTest::changesByThePredictionAreNotTickedWhenTheLearnerGoesOn()
{
    PredictionFixture fixture("branches", "swaying_tree");
    RunEditor &editor = fixture.session.editor();
    QVERIFY(fixture.predict("left_again", {.place = {270.0, 300.0}}));
    QCOMPARE(editor.parameter("spread"), 90.0);
    QVERIFY(!fixture.isTicked(0));
    QVERIFY(fixture.session.todo(0).contains("set up for you"));
    editor.setParameter("slope", 0.7); // the second thing to try, in the run of the prediction
    QVERIFY(fixture.isTicked(1));
    QVERIFY(!fixture.isTicked(0));
    QVERIFY(fixture.session.todo(0).contains("set up for you"));
    editor.setParameter("spread", 40.0);
    QCOMPARE(fixture.session.todo(0), QString());
    editor.setParameter("spread", 90.0); // now the learner does it
    QVERIFY(fixture.isTicked(0));
}

void PredictionsTest::changesByThePredictionAreNotTickedWhenTheRunComesBack()
{
    PredictionFixture fixture("branches", "swaying_tree");
    RunEditor &editor = fixture.session.editor();
    QVERIFY(fixture.predict("left_again", {.place = {270.0, 300.0}}));
    fixture.session.openStep("swaying_tree", "trunk");
    fixture.session.openStep("swaying_tree", "branches"); // as it was left
    QCOMPARE(editor.parameter("spread"), 90.0);
    QVERIFY(!fixture.isTicked(0));
    fixture.desk.startAgain("left_again");
    editor.startAfresh();
    QVERIFY(editor.parameter("spread") != 90.0);
    QVERIFY(fixture.predict("left_again", {.place = {270.0, 300.0}}));
    editor.undo();
    QVERIFY(editor.parameter("spread") != 90.0);
    editor.redo();
    QCOMPARE(editor.parameter("spread"), 90.0);
    QVERIFY(!fixture.isTicked(0));
    editor.undo();
    editor.setParameter("spread", 90.0); // the same run, made by the learner
    QVERIFY(fixture.isTicked(0));
}

void PredictionsTest::positionIsPickedAtTheStartOfTheRun()
{
    PredictionFixture fixture("drag");
    QVERIFY(fixture.knows("throw"));
    QSignalSpy started(&fixture.desk, &PredictionDesk::pickingStarted);
    fixture.desk.pick("throw");
    QCOMPARE(started.size(), 1);
    QVERIFY(fixture.desk.picking());
    QCOMPARE(fixture.frame(), std::int64_t{0});
    QVERIFY(fixture.desk.placeOfBody() == (sim::Vec2{100.0, 200.0}));
    QVERIFY(!fixture.desk.mark());
    fixture.desk.say("throw", PredictedAnswer{.place = {250.0, 200.0}});
    QVERIFY(fixture.desk.mark()->said == (sim::Vec2{250.0, 200.0}));
    QVERIFY(!fixture.desk.mark()->found);
    const int edits = fixture.session.editor().undoStack().count();
    fixture.desk.commit("throw");
    QVERIFY(!fixture.desk.picking());
    QCOMPARE(fixture.session.editor().undoStack().count(), edits); // one undo entry in all
    QTRY_VERIFY_WITH_TIMEOUT(fixture.isShown("throw"), 30'000);
    const sim::Vec2 found = fixture.desk.mark()->found.value();
    QVERIFY(found == fixture.session.timeline().state().positionOf(0));
    fixture.desk.startAgain("throw");
    fixture.desk.pick("throw");
    fixture.session.playback().play(); // the run gives the place away
    QTRY_VERIFY_WITH_TIMEOUT(!fixture.desk.picking(), 30'000);
}

void PredictionsTest::outcomesAreSentences_data()
{
    QTest::addColumn<int>("which");
    QTest::addColumn<PredictedAnswer>("said");
    QTest::addColumn<PredictedAnswer>("found");
    QTest::addColumn<QString>("sentence");
    QTest::newRow("place") << 0 << PredictedAnswer{.place = {303.0, 204.0}}
                           << PredictedAnswer{.place = {300.0, 200.0}}
                           << QString("You said **303, 204**. It is **300, 200**: 5\u202Fpx away.");
    QTest::newRow("frames") << 1 << PredictedAnswer{.number = 40.0} << PredictedAnswer{.number = 38.0}
                            << QString("You said **40\u202Fframes**. It is **38\u202Fframes**: your "
                                       "number is 2\u202Fframes too high.");
    QTest::newRow("one frame") << 1 << PredictedAnswer{.number = 37.0} << PredictedAnswer{.number = 38.0}
                               << QString("You said **37\u202Fframes**. It is **38\u202Fframes**: your "
                                          "number is 1\u202Fframe too low.");
    QTest::newRow("right frames")
        << 1 << PredictedAnswer{.number = 38.0} << PredictedAnswer{.number = 38.0}
        << QString("You said **38\u202Fframes**. It is **38\u202Fframes**: exactly as you said.");
    QTest::newRow("a difference that is not shown")
        << 1 << PredictedAnswer{.number = 60.0} << PredictedAnswer{.number = 59.97}
        << QString("You said **60\u202Fframes**. It is **60.0\u202Fframes**: exactly as you said.");
    const std::array<int, 3> order = curveOrder(curveToCross());
    const auto shown = [&](int curve) {
        return std::find(order.begin(), order.end(), curve) - order.begin() + 1;
    };
    QTest::newRow("right curve") << 2 << PredictedAnswer{.curve = 0} << PredictedAnswer{.curve = 0}
                                 << QString("You said **curve %1**, and so it is.").arg(shown(0));
    QTest::newRow("curve")
        << 2 << PredictedAnswer{.curve = 1} << PredictedAnswer{.curve = 0}
        << QString("You said **curve %1**. It is **curve %2**.").arg(shown(1)).arg(shown(0));
}

void PredictionsTest::outcomesAreSentences()
{
    QFETCH(int, which);
    QFETCH(PredictedAnswer, said);
    QFETCH(PredictedAnswer, found);
    QFETCH(QString, sentence);
    const lessons::Prediction all[] = {throwOfFoot(), pastTheCross(), curveToCross()};
    QCOMPARE(outcomeSentence(all[which], said, found), sentence);
}

SUITE(tst_predictions, PredictionsTest)
#include "tst_predictions.moc"
