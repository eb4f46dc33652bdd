// Predictions in the window: places, numbers, curves, and the choices of things to try, by mouse and keys.

#include "app/ui/learn/after/summary_page.h"
#include "app/ui/learn/choice_row.h"
#include "app/ui/learn/learn_panel.h"
#include "app/ui/learn/narration_text.h"
#include "app/ui/learn/step/curve_button.h"
#include "app/ui/learn/step/guess_box.h"
#include "app/ui/learn/step/narration.h"
#include "app/ui/learn/step/prediction_box.h"
#include "app/ui/learn/step/try_box.h"
#include "app/ui/learn/why_box.h"
#include "tests/app/support/panel_fixture.h"
#include "tests/app/support/window_fixture.h"
#include "tests/suite.h"

#include <QLineEdit>
#include <QPushButton>
#include <QSettings>
#include <QTest>
#include <QToolButton>

using namespace app;
using namespace tests;

namespace {

using PredictedKind = lessons::Question::Kind;

lessons::Prediction predictedThrow()
{
    lessons::Prediction one{"throw", "The hand **throws** the foot. Where does it stop?"};
    one.run.places = {{"foot", {100.0, 200.0}}};
    one.run.drags = {{"foot", {200.0, 200.0}, 10}};
    one.run.frames = 120;
    one.run.until = "frame > 11 and speed(foot) < 0.05";
    one.question = {PredictedKind::place, "foot", "px"};
    one.answer = "It *glides*.";
    return one;
}

lessons::Prediction predictedNumber()
{
    lessons::Prediction one{"slow", "After how many frames is it slow?"};
    one.run = predictedThrow().run;
    one.run.until = "frame > 11 and speed(foot) < 5";
    one.question = {PredictedKind::number, "frames", {}};
    one.answer = "Soon.";
    return one;
}

lessons::Prediction predictedCurve()
{
    lessons::Prediction one{"curve", "Which curve shows it?"};
    one.run = predictedThrow().run;
    one.run.until.clear();
    one.run.frames = 30;
    one.question = {PredictedKind::curve, "foot.x", "px"};
    one.otherCurves = {one.run, one.run};
    one.otherCurves[0].values = {{"damp", "0"}};
    one.otherCurves[1].values = {{"damp", "1"}};
    one.answer = "It keeps nine tenths.";
    return one;
}

LessonLibrary lessonsWith(const std::vector<lessons::Prediction> &predictions)
{
    LessonLibrary library = LessonLibrary::load({LESSON_DIR});
    for (lessons::Step &step : library.lessons[0].steps) {
        if (step.id == u"drag")
            step.predictions = predictions;
        else
            step.predictions.clear();
    }
    return library;
}

struct PredictionWindow : WindowFixture
{
    explicit PredictionWindow(const std::vector<lessons::Prediction> &predictions)
        : WindowFixture({.step = "drag", .library = lessonsWith(predictions)})
    {
        session.playback().setSpeed(4.0);
        const bool isKnown = QTest::qWaitFor(
            [&] { return desk.truth(session.step().predictions.back().id) != nullptr; }, 20'000);
        if (!isKnown)
            qFatal("the truth does not come");
        settle();
    }

    PredictionBox &box() const { return part<PredictionBox>(); }
    template <class Widget>
    Widget &in(const QString &name) const
    {
        return *box().findChild<Widget *>(name);
    }
    QString sentence() const { return in<NarrationText>("predictionSentence").toPlainText(); }
    bool isShown(const QString &id) const { return desk.sheet(id).stage == PredictionDesk::Stage::shown; }
    QPoint at(double x, double y) const { return view.mapFromScene(x, y); }
    sim::Vec2 said() const { return desk.mark().value_or(PredictionDesk::PlaceMark{}).said; }
    static bool areNear(sim::Vec2 a, sim::Vec2 b, double within) { return sim::length(a - b) <= within; }

    PredictionDesk &desk = part<LearnPanel>().narration().predictions();
};

/// Returns two lessons whose first thing to try asks a question with choices.
LessonLibrary lessonsWithChoices()
{
    LessonLibrary library = twoLessons();
    lessons::Try &one = library.lessons[0].steps[0].tries[0];
    one.id = "wait";
    one.text = "Wait five frames. What happens?";
    one.answer = "It comes nearer.";
    one.choices = {{"It stands still.", "It comes **nearer**.", "It goes away."}, 1};
    return library;
}

struct ChoiceFixture : PanelFixture<LearnPanel>
{
    ChoiceFixture() : PanelFixture(lessonsWithChoices(), {280, 732}) {}

    GuessBox &guess() const { return *panel.findChild<GuessBox *>(); }
    WhyButton &title() const { return *guess().findChild<WhyButton *>(); }
    ChoiceRow &row(int number) const
    {
        return *guess().findChild<ChoiceRow *>(QStringLiteral("guess%1").arg(number));
    }
    NarrationText &saidText() const { return *guess().findChild<NarrationText *>("guessSaid"); }
};

}

class PredictionBoxTest : public QObject
{
    Q_OBJECT

private slots:
    void init() { QSettings().clear(); }

    void clickedPositionIsComparedWithTheTrueOne();
    void positionCanBeChosenWithTheKeyboard();
    void noBodyIsDraggedWhileAPositionIsPicked();
    void escapeLeavesTheCrossWhereItIs();
    void aNumberIsTypedAndEnterPlays();
    void digitsReachTheFieldOfAPredictionThatIsOpened();
    void anInvalidNumberCannotBeCommitted();
    void aCurveIsChosenByItsKey();
    void aCurveIsChosenWithTheMouse();
    void theFirstQuestionIsOpenAndTheOthersAreFolded();
    void aButtonAboveTheThingsToTryLeadsToTheQuestion();
    void theSummaryListsWhatWasPredicted();
    void theEndOfALongAnswerIsInView();
    void theTitleKeepsItsSpacesAndBoldWords();
    void theTickSaysAnswered();
    void aChoiceIsKeptAndJudgedWhenTheThingIsDone();
    void aChoiceReturnsAfterARestart();
};

void PredictionBoxTest::clickedPositionIsComparedWithTheTrueOne()
{
    PredictionWindow fixture({predictedThrow()});
    auto &pick = fixture.in<QPushButton>("pickPlace");
    auto &commit = fixture.in<QPushButton>("commitPrediction");
    QVERIFY(!commit.isEnabled());
    QVERIFY(!commit.toolTip().isEmpty());
    QTest::mouseClick(&pick, Qt::LeftButton);
    QVERIFY(fixture.desk.picking());
    QVERIFY(fixture.view.hasFocus());
    QTest::mouseMove(fixture.view.viewport(), fixture.at(150, 150));
    QTRY_COMPARE(fixture.view.viewport()->cursor().shape(), Qt::CrossCursor);
    QTest::mouseClick(fixture.view.viewport(), Qt::LeftButton, {}, fixture.at(260, 180));
    QVERIFY(PredictionWindow::areNear(fixture.said(), {260, 180}, 1.5));
    QVERIFY(fixture.sentence().startsWith("Your cross is at 2"));
    QVERIFY(commit.isEnabled());
    QTest::mouseClick(fixture.view.viewport(), Qt::LeftButton, {}, fixture.at(280, 200)); // another place
    QVERIFY(PredictionWindow::areNear(fixture.said(), {280, 200}, 1.5));
    const QImage before = fixture.view.picture();
    QTest::mouseClick(&commit, Qt::LeftButton);
    QVERIFY(!fixture.desk.picking());
    QTRY_VERIFY_WITH_TIMEOUT(fixture.isShown("throw"), 30'000);
    QCOMPARE(fixture.frame(), fixture.desk.truth("throw")->end);
    const double apart = sim::length(fixture.said() - *fixture.desk.mark()->found);
    QVERIFY2(fixture.sentence().contains(QString("%1\u202Fpx away").arg(apart, 0, 'f', 0)),
             qPrintable(fixture.sentence()));
    QVERIFY(fixture.in<NarrationText>("predictionAnswer").isVisibleTo(&fixture.box()));
    QVERIFY(!pick.isVisibleTo(&fixture.box()) && !commit.isVisibleTo(&fixture.box()));
    QVERIFY(fixture.view.picture() != before);
    QVERIFY(fixture.view.accessibleDescription().contains("away from the true place"));
    QTest::mouseClick(&fixture.in<QPushButton>("predictAgain"), Qt::LeftButton);
    QVERIFY(!fixture.desk.mark());
    QVERIFY(pick.isVisibleTo(&fixture.box()));
}

void PredictionBoxTest::positionCanBeChosenWithTheKeyboard()
{
    PredictionWindow fixture({predictedThrow()});
    auto &pick = fixture.in<QPushButton>("pickPlace");
    pick.setFocus(Qt::TabFocusReason);
    QTest::keyClick(&pick, Qt::Key_Space);
    QVERIFY(fixture.view.hasFocus());
    fixture.key(Qt::Key_Right); // from where the body is
    QVERIFY(fixture.said() == (sim::Vec2{110.0, 200.0}));
    fixture.key(Qt::Key_Up);
    fixture.key(Qt::Key_Right, Qt::ShiftModifier);
    QVERIFY(fixture.said() == (sim::Vec2{111.0, 190.0}));
    QCOMPARE(fixture.frame(), std::int64_t{0}); // arrows step through frames at other times
    fixture.key(Qt::Key_Return);
    QVERIFY(fixture.desk.sheet("throw").stage == PredictionDesk::Stage::playing);
    QTRY_VERIFY_WITH_TIMEOUT(fixture.isShown("throw"), 30'000);
    const std::int64_t end = fixture.frame();
    fixture.key(Qt::Key_Left);
    QCOMPARE(fixture.frame(), end - 1); // and again
}

void PredictionBoxTest::noBodyIsDraggedWhileAPositionIsPicked()
{
    PredictionWindow fixture({predictedThrow()});
    QTest::mouseClick(&fixture.in<QPushButton>("pickPlace"), Qt::LeftButton);
    const std::vector<sim::Event> input = fixture.session.timeline().script().input;
    fixture.drag("foot", {60, -20});
    QVERIFY(fixture.session.timeline().script().input == input);
    QVERIFY(!fixture.session.playback().isPlaying());
    const sim::Vec2 released = fixture.said(); // the cross follows the drag
    const QPoint at = fixture.onScreen("foot") + QPoint(60, -20);
    const QPointF there = fixture.view.mapToScene(at);
    QVERIFY(PredictionWindow::areNear(released, {there.x(), there.y()}, 2.0));
    fixture.key(Qt::Key_Right, Qt::AltModifier); // it would move the selected body
    QVERIFY(fixture.session.timeline().script().input == input);
    QVERIFY(fixture.desk.picking());
}

void PredictionBoxTest::escapeLeavesTheCrossWhereItIs()
{
    PredictionWindow fixture({predictedThrow()});
    auto &pick = fixture.in<QPushButton>("pickPlace");
    QTest::mouseClick(&pick, Qt::LeftButton);
    QTest::mouseClick(fixture.view.viewport(), Qt::LeftButton, {}, fixture.at(260, 180));
    fixture.key(Qt::Key_Escape);
    QVERIFY(!fixture.desk.picking());
    const sim::Vec2 said = fixture.said();
    QVERIFY(PredictionWindow::areNear(said, {260, 180}, 1.5));
    fixture.key(Qt::Key_Right); // steps forward
    QCOMPARE(fixture.frame(), std::int64_t{1});
    QTest::mouseClick(&pick, Qt::LeftButton);
    QCOMPARE(fixture.frame(), std::int64_t{0});
    QVERIFY(fixture.said() == said);
}

void PredictionBoxTest::aNumberIsTypedAndEnterPlays()
{
    PredictionWindow fixture({predictedNumber()});
    auto &field = fixture.in<QLineEdit>("predictedNumber");
    QVERIFY(!field.accessibleName().isEmpty() && !field.toolTip().isEmpty());
    field.setFocus(Qt::TabFocusReason);
    QTest::keyClicks(&field, "25");
    QCOMPARE(fixture.desk.sheet("slow").said->number, 25.0);
    QTest::keyClick(&field, Qt::Key_Return);
    QTRY_VERIFY_WITH_TIMEOUT(fixture.isShown("slow"), 30'000);
    // 10 px per frame, of which 0.9 stay: 0.9^7 is the first share below a half.
    QCOMPARE(fixture.frame(), std::int64_t{17});
    QVERIFY2(fixture.sentence().contains("8\u202Fframes too high"), qPrintable(fixture.sentence()));
    QCOMPARE(fixture.in<NarrationText>("predictionAnswer").toPlainText(), QString("Soon."));
    QVERIFY(!field.isVisibleTo(&fixture.box()));
    QTest::mouseClick(&fixture.in<QPushButton>("predictAgain"), Qt::LeftButton);
    QVERIFY(field.isVisibleTo(&fixture.box()));
    QCOMPARE(field.text(), QString());
}

void PredictionBoxTest::digitsReachTheFieldOfAPredictionThatIsOpened()
{
    PredictionWindow fixture({predictedThrow(), predictedNumber()});
    auto &box = *fixture.window.findChildren<PredictionBox *>().at(1);
    auto &title = *box.findChild<WhyButton *>();
    QTest::mouseClick(&title, Qt::LeftButton);
    auto &field = *box.findChild<QLineEdit *>("predictedNumber"); // made when the box is opened
    QTRY_VERIFY(field.hasFocus());
    QTest::keyClicks(&field, "10");
    QCOMPARE(fixture.desk.sheet("slow").said->number, 10.0);
    fixture.desk.commit("slow");
    QTRY_VERIFY_WITH_TIMEOUT(fixture.isShown("slow"), 30'000);
    fixture.view.setFocus();
    QTest::mouseClick(&title, Qt::LeftButton); // folds it
    QVERIFY(fixture.view.hasFocus());
    QTest::mouseClick(&title, Qt::LeftButton);
    QVERIFY(fixture.view.hasFocus()); // nothing is asked
    QTest::mouseClick(box.findChild<QPushButton *>("predictAgain"), Qt::LeftButton);
    QTRY_VERIFY(field.hasFocus());
}

void PredictionBoxTest::anInvalidNumberCannotBeCommitted()
{
    PredictionWindow fixture({predictedNumber()});
    auto &field = fixture.in<QLineEdit>("predictedNumber");
    auto &commit = fixture.in<QPushButton>("commitPrediction");
    field.setFocus(Qt::TabFocusReason);
    QTest::keyClicks(&field, "a-");
    QCOMPARE(field.text(), QString("-"));
    QVERIFY(!commit.isEnabled());
    QTest::keyClick(&field, Qt::Key_Return);
    QVERIFY(!fixture.session.playback().isPlaying());
    QTest::keyClicks(&field, "1,5");
    QCOMPARE(fixture.desk.sheet("slow").said->number, -1.5);
    QVERIFY(commit.isEnabled());
    field.selectAll();
    QTest::keyClick(&field, Qt::Key_Delete);
    QVERIFY(!commit.isEnabled());
}

void PredictionBoxTest::aCurveIsChosenByItsKey()
{
    PredictionWindow fixture({predictedCurve()});
    const std::array<int, 3> order = curveOrder(predictedCurve());
    auto &first = fixture.in<CurveButton>("curve1");
    QVERIFY(first.accessibleName().startsWith("Curve 1: from 100 to"));
    first.setFocus(Qt::TabFocusReason);
    QTest::keyClick(&first, Qt::Key_3);
    auto &third = fixture.in<CurveButton>("curve3");
    QVERIFY(third.isChecked() && third.hasFocus() && !first.isChecked());
    QTest::keyClick(&third, Qt::Key_2);
    QVERIFY(fixture.in<CurveButton>("curve2").isChecked() && !third.isChecked());
    QCOMPARE(fixture.desk.sheet("curve").said->curve, order[1]);
    QTest::keyClick(&fixture.in<CurveButton>("curve2"), Qt::Key_Return);
    QTRY_VERIFY_WITH_TIMEOUT(fixture.isShown("curve"), 30'000);
    const auto right = std::find(order.begin(), order.end(), 0) - order.begin() + 1;
    for (int i = 1; i <= 3; ++i) {
        const auto &button = fixture.in<CurveButton>(QStringLiteral("curve%1").arg(i));
        QCOMPARE(button.accessibleName().endsWith(", right"), i == right);
        QVERIFY(!button.isEnabled());
    }
}

void PredictionBoxTest::aCurveIsChosenWithTheMouse()
{
    PredictionWindow fixture({predictedCurve()});
    const std::array<int, 3> order = curveOrder(predictedCurve());
    const auto right = std::find(order.begin(), order.end(), 0) - order.begin() + 1;
    QTest::mouseClick(&fixture.in<CurveButton>(QStringLiteral("curve%1").arg(right)), Qt::LeftButton);
    QTest::mouseClick(&fixture.in<QPushButton>("commitPrediction"), Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(fixture.isShown("curve"), 30'000);
    QCOMPARE(fixture.sentence(), QString("You said curve %1, and so it is.").arg(right));
    QCOMPARE(fixture.frame(), std::int64_t{30});
}

void PredictionBoxTest::theFirstQuestionIsOpenAndTheOthersAreFolded()
{
    PredictionWindow fixture({predictedThrow(), predictedNumber()});
    const auto boxes = fixture.window.findChildren<PredictionBox *>();
    QCOMPARE(boxes.size(), 2);
    const auto title = [&](qsizetype i) { return boxes[i]->findChild<WhyButton *>(); };
    QVERIFY(title(0)->isChecked() && !title(1)->isChecked());
    QCOMPARE(title(0)->text(), QString("The hand throws the foot. Where does it stop?"));
    title(1)->setFocus(Qt::TabFocusReason);
    QTest::keyClick(title(1), Qt::Key_Space);
    QVERIFY(boxes[1]->findChild<QLineEdit *>()->isVisibleTo(boxes[1]));
}

void PredictionBoxTest::aButtonAboveTheThingsToTryLeadsToTheQuestion()
{
    PredictionWindow fixture({predictedNumber()});
    auto &button = fixture.part<QToolButton>("toPredictions");
    QVERIFY(button.isVisible());
    QVERIFY(!button.toolTip().isEmpty());
    QTest::mouseClick(&button, Qt::LeftButton);
    auto &field = fixture.in<QLineEdit>("predictedNumber");
    QTRY_VERIFY(field.hasFocus());
    QTRY_VERIFY(!field.visibleRegion().isEmpty());
    QTest::keyClicks(&field, "17");
    QTest::keyClick(&field, Qt::Key_Return);
    QTRY_VERIFY_WITH_TIMEOUT(fixture.isShown("slow"), 30'000);
    QVERIFY(!button.isVisible()); // nothing is left to predict
    QTRY_VERIFY(!button.sizePolicy().retainSizeWhenHidden());
    fixture.session.openFollowing();
    fixture.session.openPreceding();
    QTRY_VERIFY(!button.isVisible() && !button.sizePolicy().retainSizeWhenHidden());
}

void PredictionBoxTest::theSummaryListsWhatWasPredicted()
{
    PredictionWindow fixture({predictedThrow(), predictedNumber()});
    fixture.desk.say("slow", PredictedAnswer{.number = 20.0});
    fixture.desk.commit("slow");
    QTRY_VERIFY_WITH_TIMEOUT(fixture.isShown("slow"), 30'000);
    auto &panel = fixture.part<LearnPanel>();
    panel.showSummary(true);
    QString text;
    for (const NarrationText *one : panel.findChild<SummaryPage *>()->findChildren<NarrationText *>())
        text += one->toPlainText();
    QVERIFY2(text.contains("After how many frames is it slow?"), qPrintable(text));
    QVERIFY2(text.contains("You said 20\u202Fframes. It is 17\u202Fframes"), qPrintable(text));
    QVERIFY(!text.contains("Where does it stop?"));
}

void PredictionBoxTest::theEndOfALongAnswerIsInView()
{
    lessons::Prediction asked = predictedNumber();
    asked.text = QString("This question is long, and it needs some lines of the panel. ").repeated(3);
    asked.answer = QString("The answer is long, too, so that it needs many lines. ").repeated(5);
    PredictionWindow fixture({asked});
    fixture.part<LearnPanel>().setForm(LearnPanel::Form::whole);
    settle();
    fixture.box().focusField();
    auto &field = fixture.in<QLineEdit>("predictedNumber");
    QTest::keyClicks(&field, "25");
    QTest::keyClick(&field, Qt::Key_Return);
    QTRY_VERIFY_WITH_TIMEOUT(fixture.isShown("slow"), 30'000);
    const auto &answer = fixture.in<NarrationText>("predictionAnswer");
    const auto &again = fixture.in<QPushButton>("predictAgain");
    QTRY_COMPARE(again.visibleRegion().boundingRect(), again.rect());
    const auto below = [&](const QWidget &one) {
        return one.mapTo(&fixture.window, QPoint(0, one.height())).y();
    };
    QTRY_VERIFY(below(answer) <= below(again) - again.height());
    QVERIFY(answer.height() >= answer.heightForWidth(answer.width()));
}

void PredictionBoxTest::theTitleKeepsItsSpacesAndBoldWords()
{
    lessons::Prediction asked = predictedNumber();
    asked.text = "**Damping** is 0.9, and the foot is 100\u202Fpx away. After how many frames is it slow?";
    PredictionWindow fixture({asked});
    auto &title = *fixture.box().findChild<WhyButton *>();
    QCOMPARE(title.text(),
             QString("Damping is 0.9, and the foot is 100\u202Fpx away. After how many frames is "
                     "it slow?"));
    QCOMPARE(title.accessibleName(), title.text());
    const QImage bold = title.grab().toImage();
    title.setMarkdown(title.text());
    settle();
    QVERIFY(title.grab().toImage() != bold);
}

void PredictionBoxTest::theTickSaysAnswered()
{
    PredictionWindow fixture({predictedNumber()});
    auto &title = *fixture.box().findChild<WhyButton *>();
    QVERIFY(!title.toolTip().contains("Answered"));
    fixture.desk.say("slow", PredictedAnswer{.number = 1.0}); // wrong
    fixture.desk.commit("slow");
    QTRY_VERIFY_WITH_TIMEOUT(fixture.isShown("slow"), 30'000);
    QVERIFY(title.text().endsWith("✓"));
    QVERIFY(title.accessibleName().endsWith(", answered"));
    QVERIFY(title.toolTip().startsWith("Answered"));
    QTest::mouseClick(&title, Qt::LeftButton);
    QVERIFY(!title.isChecked());
    QVERIFY(title.toolTip().startsWith("Answered"));
    title.setChecked(true);
    QTest::mouseClick(&fixture.in<QPushButton>("predictAgain"), Qt::LeftButton);
    QVERIFY(!title.toolTip().contains("Answered"));
    QVERIFY(!title.text().endsWith("✓"));
}

void PredictionBoxTest::aChoiceIsKeptAndJudgedWhenTheThingIsDone()
{
    ChoiceFixture fixture;
    QVERIFY(!fixture.row(1).isVisible());
    QCOMPARE(fixture.title().text(), QString("What do you expect?"));
    QTest::mouseClick(&fixture.title(), Qt::LeftButton);
    QTRY_VERIFY(fixture.row(1).isVisible());
    QTest::mouseClick(&fixture.row(1), Qt::LeftButton, {}, fixture.row(1).rect().center());
    QCOMPARE(fixture.title().text(), QString("You said: It stands still."));
    fixture.row(3).setFocus(Qt::TabFocusReason);
    QTest::keyClick(&fixture.row(3), Qt::Key_Space);
    QVERIFY(fixture.row(3).isChecked() && !fixture.row(1).isChecked());
    const Note note = *fixture.session.notes().find("one/first/choice:wait");
    QCOMPARE(note.said, QString("3"));
    QCOMPARE(note.found, QString("2"));
    QVERIFY(!note.isRight);
    QVERIFY(!fixture.saidText().isVisible()); // nothing is given away yet
    fixture.goTo(6);
    QTRY_VERIFY(fixture.saidText().isVisible());
    QCOMPARE(fixture.saidText().toPlainText(), QString("You said: It goes away. ✗"));
    QVERIFY(!fixture.row(1).isVisible() && !fixture.title().isVisible());
    QVERIFY(fixture.panel.findChild<NarrationText *>("answerText")->isVisible());
}

void PredictionBoxTest::aChoiceReturnsAfterARestart()
{
    Notes().keep("one/first/choice:wait", {"choice", "2", "2", true});
    ChoiceFixture fixture;
    QCOMPARE(fixture.title().text(), QString("You said: It comes nearer."));
    QVERIFY(fixture.row(2).isChecked());
    fixture.goTo(6);
    QTRY_VERIFY(fixture.saidText().isVisible());
    QCOMPARE(fixture.saidText().toPlainText(), QString("You said: It comes nearer. ✓"));
}

SUITE(tst_prediction_box, PredictionBoxTest)
#include "tst_prediction_box.moc"
