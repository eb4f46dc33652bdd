// Predictions: the truth about their runs, the desk at which a learner predicts, and her notes.

#include "app/model/learning/prediction_desk.h"
#include "app/model/learning/prediction_text.h"
#include "app/model/learning/run_setup.h"
#include "app/model/run/same_run.h"
#include "app/model/text/user_error.h"
#include "tests/app/support/session_fixture.h"
#include "tests/suite.h"

#include <QSettings>
#include <QSignalSpy>
#include <QTest>

#include <algorithm>
#include <cmath>

using namespace app;
using namespace tests;

namespace {

using Asked = lessons::Question::Kind;

/// The hand carries the foot 100 px to the right in 10 frames and lets go. Nothing pulls it.
lessons::Prediction throwOfFoot()
{
    lessons::Prediction one{"throw", "Where does it stop?"};
    one.run.values = {{"damp", "0.9"}};
    one.run.places = {{"foot", {100.0, 200.0}}};
    one.run.drags = {{"foot", {200.0, 200.0}, 10}};
    one.run.frames = 120;
    one.run.until = "frame > 11 and speed(foot) < 0.05";
    one.question = {Asked::place, "foot", "px"};
    one.answer = "It glides.";
    return one;
}

/// The foot is pulled to a cross at 270, 200. How many frames pass until it is on the other side?
lessons::Prediction pastTheCross()
{
    lessons::Prediction one{"past", "After how many frames?"};
    one.run.values = {{"k", "0.05"}, {"damp", "0.9"}};
    one.run.places = {{"foot", {510.0, 200.0}}};
    one.run.frames = 100;
    one.run.until = "foot.x < 270";
    one.question = {Asked::number, "frames", {}};
    one.answer = "So many.";
    return one;
}

/// Which curve shows the x of the foot on its way to the cross?
lessons::Prediction curveToCross()
{
    lessons::Prediction one{"which", "Which curve?"};
    one.run.values = {{"k", "0.05"}, {"damp", "0.9"}};
    one.run.places = {{"foot", {510.0, 200.0}}};
    one.run.frames = 60;
    one.question = {Asked::curve, "foot.x", "px"};
    one.otherCurves = {one.run, one.run};
    one.otherCurves[0].values = {{"k", "0.2"}, {"damp", "0.9"}};
    one.otherCurves[1].values = {{"k", "0.05"}, {"damp", "0.3"}};
    one.answer = "The slow one.";
    return one;
}

/// Returns x of the foot at each frame, by the two lines of the published program.
std::vector<double> publishedX(double x, double k, double damp, int frames)
{
    std::vector<double> all{x};
    double velocity = 0.0;
    for (int i = 0; i < frames; ++i) {
        velocity = (velocity + k * (270.0 - x)) * damp;
        x += velocity;
        all.push_back(x);
    }
    return all;
}

/// Returns the program's lessons, with these predictions in the first steps of lesson 1.
LessonLibrary predictedLessons()
{
    LessonLibrary library = LessonLibrary::load({LESSON_DIR});
    for (lessons::Step &step : library.lessons[0].steps) {
        step.predictions.clear();
        if (step.id == u"drag")
            step.predictions = {throwOfFoot()};
        if (step.id == u"fixed_centre")
            step.predictions = {pastTheCross(), curveToCross()};
    }
    return library;
}

struct PredictionFixture : SessionFixture
{
    explicit PredictionFixture(const QString &step) : SessionFixture(predictedLessons())
    {
        session.openStep("single_spring", step);
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
    std::int64_t frame() const { return session.timeline().cursor().frame; }

    PredictionDesk desk{session};
};

}

class PredictionsTest : public QObject
{
    Q_OBJECT

private slots:
    void init() { QSettings().clear(); }

    void aThrowEndsWhereItsVelocitiesAddUpTo();
    void theFramesUntilTheEndAreCounted();
    void curvesAreThoseOfThePublishedProgram();
    void aNumberAtTheEndIsComputed();
    void aRunThatDoesNotExistIsExplained_data();
    void aRunThatDoesNotExistIsExplained();
    void everyPredictionOfALessonHasAnAnswer_data();
    void everyPredictionOfALessonHasAnAnswer();
    void committingPlaysTheRunToItsEnd();
    void undoBringsTheLearnersOwnRunBack();
    void aNoteIsKeptAndShownAgain();
    void predictingAgainStartsOver();
    void aChangeOfTheRunInterruptsIt();
    void anotherStepEndsIt();
    void pausingDoesNotLoseTheEnd();
    void newTextsOfTheStepAreFollowed();
    void theRunOfAPredictionTicksNothing();
    void aPlaceIsPickedAtTheBeginningOfTheRun();
    void outcomesAreSentences_data();
    void outcomesAreSentences();
};

void PredictionsTest::aThrowEndsWhereItsVelocitiesAddUpTo()
{
    const LessonLibrary library = predictedLessons();
    const auto truth = truthOf(throwOfFoot(), *library.lesson("single_spring")->step("drag"));
    // It leaves the hand at frame 10 with 10 px per frame, of which 0.9 stay in each frame.
    const int free = static_cast<int>(std::ceil(std::log(0.05 / 10.0) / std::log(0.9)));
    const double way = 10.0 * 0.9 * (1.0 - std::pow(0.9, free)) / (1.0 - 0.9);
    QVERIFY(truth && truth->isReached);
    QCOMPARE(truth->end, std::int64_t{10 + free});
    QVERIFY2(std::abs(truth->answer.place.x - (200.0 + way)) < 1e-9,
             qPrintable(QString::number(truth->answer.place.x)));
    QCOMPARE(truth->answer.place.y, 200.0);
}

void PredictionsTest::theFramesUntilTheEndAreCounted()
{
    const LessonLibrary library = predictedLessons();
    const auto truth = truthOf(pastTheCross(), *library.lesson("single_spring")->step("fixed_centre"));
    const std::vector<double> x = publishedX(510.0, 0.05, 0.9, 100);
    const auto past = std::find_if(x.begin(), x.end(), [](double at) { return at < 270.0; }) - x.begin();
    QVERIFY(truth && truth->isReached);
    QCOMPARE(truth->end, std::int64_t{past});
    QCOMPARE(truth->answer.number, static_cast<double>(past));
}

void PredictionsTest::curvesAreThoseOfThePublishedProgram()
{
    const LessonLibrary library = predictedLessons();
    const auto truth = truthOf(curveToCross(), *library.lesson("single_spring")->step("fixed_centre"));
    QVERIFY(truth && truth->curves.size() == 3U);
    const std::pair<double, double> numbers[] = {{0.05, 0.9}, {0.2, 0.9}, {0.05, 0.3}};
    for (std::size_t i = 0; i < 3; ++i) {
        const std::vector<double> x = publishedX(510.0, numbers[i].first, numbers[i].second, 60);
        QCOMPARE(truth->curves[i].size(), x.size());
        for (std::size_t j = 0; j < x.size(); ++j)
            QVERIFY(std::abs(truth->curves[i][j] - x[j]) < 1e-9);
    }
}

void PredictionsTest::aNumberAtTheEndIsComputed()
{
    const LessonLibrary library = predictedLessons();
    lessons::Prediction one = pastTheCross();
    one.run.frames = 3;
    one.run.until.clear();
    one.question = {Asked::number, "(foot.x - 270) / 240 + frame", "px"};
    const auto truth = truthOf(one, *library.lesson("single_spring")->step("fixed_centre"));
    QVERIFY(truth);
    QCOMPARE(truth->end, std::int64_t{3});
    QVERIFY(std::abs(truth->answer.number -
                     ((publishedX(510.0, 0.05, 0.9, 3).back() - 270.0) / 240.0 + 3.0)) < 1e-12);
}

void PredictionsTest::aRunThatDoesNotExistIsExplained_data()
{
    QTest::addColumn<QString>("what");
    QTest::addColumn<QString>("value");
    QTest::addColumn<QString>("says");
    QTest::newRow("parameter") << "stiffness"
                               << "1"
                               << "There is no parameter \"stiffness\" here; there are k, damp";
    QTest::newRow("number") << "k"
                            << "much"
                            << "k cannot be \"much\". It can be a number from";
    QTest::newRow("range") << "damp"
                           << "1e9"
                           << "damp cannot be \"1e9\".";
    QTest::newRow("body") << "place"
                          << "tail"
                          << "There is no body \"tail\" here; there are foot";
    QTest::newRow("method") << "method"
                            << "magic"
                            << "There is no method \"magic\".";
    QTest::newRow("until") << "until"
                           << "foot.z > 1"
                           << "Character 6: ";
    QTest::newRow("number asked") << "ask"
                                  << "foot.x > 1"
                                  << "true or false, not a number";
}

void PredictionsTest::aRunThatDoesNotExistIsExplained()
{
    QFETCH(QString, what);
    QFETCH(QString, value);
    QFETCH(QString, says);
    const LessonLibrary library = predictedLessons();
    lessons::Prediction one = pastTheCross();
    if (what == u"place")
        one.run.places = {{value, {1.0, 1.0}}};
    else if (what == u"method")
        one.run.method = value;
    else if (what == u"until")
        one.run.until = value;
    else if (what == u"ask")
        one.question = {Asked::number, value, "px"};
    else
        one.run.values = {{what, value}};
    QString sentence;
    try {
        truthOf(one, *library.lesson("single_spring")->step("fixed_centre"));
    } catch (const UserError &error) {
        sentence = error.sentence();
    }
    QVERIFY2(sentence.contains(says), qPrintable(sentence));
}

void PredictionsTest::everyPredictionOfALessonHasAnAnswer_data()
{
    QTest::addColumn<QString>("lesson");
    for (const LessonEntry &lesson : LessonLibrary::load({LESSON_DIR}).lessons)
        QTest::newRow(qPrintable(lesson.id)) << lesson.id;
}

void PredictionsTest::everyPredictionOfALessonHasAnAnswer()
{
    QFETCH(QString, lesson);
    const LessonLibrary library = LessonLibrary::load({LESSON_DIR});
    QStringList wrong;
    for (const lessons::Step &step : library.lesson(lesson)->steps) {
        for (const lessons::Prediction &one : step.predictions) {
            const QString where = step.id + '/' + one.id + ": ";
            try {
                const PredictionTruth truth = truthOf(one, step).value();
                if (!truth.isReached)
                    wrong << where + QString("its condition does not hold within %1 frames").arg(truth.end);
                if (!std::isfinite(truth.answer.number) || !std::isfinite(truth.answer.place.x))
                    wrong << where + "its answer is not a number";
                if (one.question.kind != Asked::curve)
                    continue;
                double least = truth.curves[0][0], most = least;
                for (const std::vector<double> &curve : truth.curves) {
                    least = std::min(least, *std::min_element(curve.begin(), curve.end()));
                    most = std::max(most, *std::max_element(curve.begin(), curve.end()));
                }
                for (std::size_t a = 0; a < 3; ++a) {
                    const std::vector<double> &first = truth.curves[a], &second = truth.curves[(a + 1) % 3];
                    double apart = 0.0;
                    for (std::size_t i = 0; i < std::min(first.size(), second.size()); ++i)
                        apart = std::max(apart, std::abs(first[i] - second[i]));
                    if (apart < 0.1 * (most - least) || most <= least)
                        wrong << where + QString("curves %1 and %2 look the same").arg(a).arg((a + 1) % 3);
                }
            } catch (const std::exception &error) {
                wrong << where + error.what();
            }
        }
    }
    QVERIFY2(wrong.isEmpty(), qPrintable('\n' + wrong.join('\n')));
}

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
    // The end holds once only.
    fixture.session.playback().play();
    QTRY_VERIFY_WITH_TIMEOUT(fixture.frame() > end + 5, 30'000);
}

void PredictionsTest::undoBringsTheLearnersOwnRunBack()
{
    PredictionFixture fixture("fixed_centre");
    fixture.session.editor().setParameter("k", 0.33);
    fixture.session.playback().goTo({12, 0});
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

void PredictionsTest::aChangeOfTheRunInterruptsIt()
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

void PredictionsTest::anotherStepEndsIt()
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
        QCOMPARE(fixture.session.todo(i), QString());
    }
}

void PredictionsTest::aPlaceIsPickedAtTheBeginningOfTheRun()
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
                            << QString("You said **40\u202Fframes**. It is **38\u202Fframes**: you said "
                                       "2\u202Fframes too much.");
    QTest::newRow("right frames")
        << 1 << PredictedAnswer{.number = 38.0} << PredictedAnswer{.number = 38.0}
        << QString("You said **38\u202Fframes**. It is **38\u202Fframes**: exactly as you said.");
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
