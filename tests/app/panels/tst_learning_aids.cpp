// Hints, words, why-boxes and the summary, asked for with mouse and keyboard.

#include "app/ui/learn/after/summary_page.h"
#include "app/ui/learn/learn_panel.h"
#include "app/ui/learn/lessons/lesson_list.h"
#include "app/ui/learn/lessons/lesson_model.h"
#include "app/ui/learn/narration_text.h"
#include "app/ui/learn/prose.h"
#include "app/ui/learn/step/narration.h"
#include "app/ui/learn/step/try_box.h"
#include "app/ui/learn/step/try_row.h"
#include "app/ui/learn/step_button.h"
#include "app/ui/learn/why_box.h"
#include "app/ui/learn/words/glossary_page.h"
#include "app/ui/learn/words/word_card.h"
#include "tests/app/support/panel_fixture.h"
#include "tests/suite.h"

#include <QAbstractTextDocumentLayout>
#include <QLabel>
#include <QLineEdit>
#include <QSettings>
#include <QTest>
#include <QTextBlock>
#include <QToolButton>

using namespace app;
using namespace tests;

namespace {

/// Returns two lessons whose first step has hints, a question and a term.
LessonLibrary toldLessons()
{
    LessonLibrary library = twoLessons();
    lessons::Step &first = library.lessons[0].steps[0];
    first.narration = "A **spring** pulls the foot. It is a spring.";
    first.explanation.learnt = "A spring pulls.";
    first.tries[0].hint = "Press **Right** five times.";
    first.tries.push_back(first.tries[0]);
    first.tries[1].hint = "Press it once more.";
    first.explanation.whys = {{"Why twice the pull?", "Because\n\n`pull = k × distance`"}};
    first.explanation.terms = {{"Spring", "spring|springs", "It pulls together what is too far apart."}};
    library.lessons[1].steps[0].explanation.terms = {{"Damping", "damping", "A share that is kept."}};
    return library;
}

struct LearnFixture : PanelFixture<LearnPanel>
{
    LearnFixture() : PanelFixture(toldLessons(), {280, 732}) {}

    std::vector<TryBox *> boxes() const
    {
        const auto found = panel.findChildren<TryBox *>();
        return {found.begin(), found.end()};
    }
    NarrationText &text() const { return *panel.findChild<NarrationText *>(); }
    WordCard &card() const { return *panel.findChild<WordCard *>(); }
    SummaryPage &summary() const { return *panel.findChild<SummaryPage *>(); }
    QToolButton &startOver() const { return *panel.findChild<QToolButton *>("startOver"); }
    bool isDone() const { return session.lesson().id == "one" && tick()->isChecked(); }
    TryRow *tick() const { return boxes().front()->findChild<TryRow *>(); }
};

/// The middle of the letter at `position` of a text.
QPoint placeOf(const NarrationText &text, int position)
{
    QTextCursor cursor(text.document());
    cursor.setPosition(position);
    const QRect before = text.cursorRect(cursor);
    cursor.setPosition(position + 1);
    return (before.center() + text.cursorRect(cursor).center()) / 2;
}

QToolButton *lampOf(const TryBox &box)
{
    return box.findChild<QToolButton *>("hint");
}

}

class LearningAidsTest : public QObject
{
    Q_OBJECT

private slots:
    void init() { QSettings().clear(); }

    void aHintIsShownWhenItIsAskedFor_data();
    void aHintIsShownWhenItIsAskedFor();
    void theNextHintIsTheFirstThatIsNotShown();
    void hintsAreRememberedUntilTheProgramEnds();
    void whatIsDoneNeedsNoHint();
    void whatIsBegunSaysWhatIsMissing();
    void whatIsToStopCountsOnlyWhileTheRunStands();
    void anAnswerAppearsWhenItsQuestionIsTickedOff();
    void whatUnfoldsBelowALongTextIsInView();
    void aNumberStaysOnOneLineWithItsUnit_data();
    void aNumberStaysOnOneLineWithItsUnit();
    void aWordIsLinkedWhereItStandsFirst();
    void aWordOpensACard_data();
    void aWordOpensACard();
    void theCardIsAsHighAsWhatIsOnIt();
    void theCardLeadsToTheStepThatTeachesTheWord();
    void theCardLeadsToAllWords();
    void theGlossaryFindsWordsAsTheyAreTyped();
    void anAnswerUnfolds_data();
    void anAnswerUnfolds();
    void theSummaryTellsWhatWasLearntAndWhatIsOpen();
    void goingOnAfterTheLastStepShowsTheSummaryFirst();
    void theSummaryIsInTheList();
    void aLessonCanBeStartedOverAndTheTicksBroughtBack();
};

void LearningAidsTest::aHintIsShownWhenItIsAskedFor_data()
{
    QTest::addColumn<bool>("byKey");
    QTest::newRow("mouse") << false;
    QTest::newRow("keyboard") << true;
}

void LearningAidsTest::aHintIsShownWhenItIsAskedFor()
{
    QFETCH(bool, byKey);
    LearnFixture fixture;
    const TryBox &box = *fixture.boxes()[0];
    QVERIFY(!box.showsHint());
    const int high = box.height();
    if (byKey) {
        lampOf(box)->setFocus(Qt::TabFocusReason);
        QTest::keyClick(lampOf(box), Qt::Key_Space);
    } else {
        QTest::mouseClick(lampOf(box), Qt::LeftButton);
    }
    QVERIFY(box.showsHint());
    QCOMPARE(box.findChild<NarrationText *>("hintText")->toPlainText(), QString("Press Right five times."));
    QTRY_VERIFY(box.height() > high);
    QVERIFY(!fixture.boxes()[1]->showsHint());
    QTest::mouseClick(lampOf(box), Qt::LeftButton);
    QVERIFY(!box.showsHint());
}

void LearningAidsTest::theNextHintIsTheFirstThatIsNotShown()
{
    LearnFixture fixture;
    fixture.panel.narration().showNextHint();
    QVERIFY(fixture.boxes()[0]->showsHint() && !fixture.boxes()[1]->showsHint());
    fixture.panel.narration().showNextHint();
    QVERIFY(fixture.boxes()[0]->showsHint() && fixture.boxes()[1]->showsHint());
    fixture.panel.narration().showNextHint(); // no more
}

void LearningAidsTest::hintsAreRememberedUntilTheProgramEnds()
{
    {
        LearnFixture fixture;
        QTest::mouseClick(lampOf(*fixture.boxes()[1]), Qt::LeftButton);
        fixture.session.openStep("one", "second");
        fixture.session.openStep("one", "first");
        QVERIFY(!fixture.boxes()[0]->showsHint() && fixture.boxes()[1]->showsHint());
    }
    LearnFixture again;
    QVERIFY(!again.boxes()[1]->showsHint());
}

void LearningAidsTest::whatIsDoneNeedsNoHint()
{
    LearnFixture fixture;
    QTest::mouseClick(lampOf(*fixture.boxes()[0]), Qt::LeftButton);
    for (int i = 0; i < 5; ++i)
        fixture.session.playback().frameForward();
    QVERIFY(fixture.isDone());
    QVERIFY(!fixture.boxes()[0]->showsHint() && !lampOf(*fixture.boxes()[0])->isVisible());
}

namespace {

/// A thing to try that is begun at frame 1 and done at frame 5.
lessons::Try toFrameFive()
{
    const auto frame = [](const sim::Timeline &run) { return static_cast<double>(run.cursor().frame); };
    lessons::Condition atFive = lessons::atLeast(5.0, frame, {}, 0);
    atFive.todo = "go on to frame **5**. This is frame %1.";
    return {"Go to frame 5. What is there?", {lessons::atLeast(1.0, frame), atFive}};
}

LessonLibrary lessonsWith(const lessons::Try &one)
{
    LessonLibrary library = twoLessons();
    library.lessons[0].steps[0].tries = {one, one};
    return library;
}

NarrationText *textOf(const TryBox &box, const char *name)
{
    return box.findChild<NarrationText *>(name);
}

}

void LearningAidsTest::whatIsBegunSaysWhatIsMissing()
{
    PanelFixture<LearnPanel> fixture(lessonsWith(toFrameFive()), {280, 732});
    const TryBox &box = *fixture.panel.findChild<TryBox *>();
    QVERIFY(!textOf(box, "todoText")->isVisible());
    fixture.session.playback().goTo({3, 0});
    QTRY_VERIFY(textOf(box, "todoText")->isVisible());
    QCOMPARE(textOf(box, "todoText")->toPlainText(),
             QString("Still to do: go on to frame 5. This is frame 3."));
    QCOMPARE(box.findChild<TryRow *>()->accessibleDescription(), textOf(box, "todoText")->toPlainText());
    fixture.session.playback().goTo({5, 0});
    QVERIFY(box.isDone());
    QVERIFY(!textOf(box, "todoText")->isVisible());
    QVERIFY(box.findChild<TryRow *>()->accessibleDescription().isEmpty());
}

void LearningAidsTest::whatIsToStopCountsOnlyWhileTheRunStands()
{
    lessons::Try one = toFrameFive();
    one.onlyWhilePaused = true;
    PanelFixture<LearnPanel> fixture(lessonsWith(one), {280, 732});
    const TryBox &box = *fixture.panel.findChild<TryBox *>();
    fixture.session.playback().play();
    QTRY_VERIFY(fixture.session.timeline().cursor().frame > 6);
    QVERIFY(fixture.session.playback().isPlaying());
    QVERIFY(!box.isDone());
    QTRY_VERIFY(textOf(box, "todoText")->toPlainText().contains("Space"));
    fixture.session.playback().pause();
    QVERIFY(box.isDone());
}

void LearningAidsTest::anAnswerAppearsWhenItsQuestionIsTickedOff()
{
    lessons::Try one = toFrameFive();
    one.answer = "Nothing *new*.";
    PanelFixture<LearnPanel> fixture(lessonsWith(one), {280, 732});
    const auto found = fixture.panel.findChildren<TryBox *>();
    TryBox &first = *found[0], &second = *found[1];
    QVERIFY(!textOf(first, "answerText")->isVisible());
    QVERIFY(!lampOf(first)->isVisible()); // it has no hint
    fixture.session.playback().goTo({5, 0});
    QCOMPARE(textOf(second, "answerText")->toPlainText(), QString("Nothing new."));
    QVERIFY(textOf(second, "answerText")->isVisible()); // of what was done last
    QVERIFY(!textOf(first, "answerText")->isVisible());
    QVERIFY(lampOf(first)->accessibleName().startsWith("Answer"));
    QTest::mouseClick(lampOf(first), Qt::LeftButton);
    QVERIFY(textOf(first, "answerText")->isVisible());
    QTest::mouseClick(lampOf(first), Qt::LeftButton);
    QVERIFY(!textOf(first, "answerText")->isVisible());
}

void LearningAidsTest::whatUnfoldsBelowALongTextIsInView()
{
    lessons::Try asked = toFrameFive();
    asked.answer = QString("The answer is long, so that it needs many lines. ").repeated(8);
    LessonLibrary library = lessonsWith(asked);
    library.lessons[0].steps[0].narration = QString("A text that is longer than the panel. ").repeated(60);
    PanelFixture<LearnPanel> fixture(library, {280, 640});
    const auto boxes = fixture.panel.findChildren<TryBox *>();
    QTRY_VERIFY(!boxes[0]->visibleRegion().isEmpty());
    fixture.session.playback().goTo({5, 0});
    const NarrationText &answer = *textOf(*boxes[1], "answerText");
    QTRY_VERIFY(answer.isVisible());
    QTRY_COMPARE(answer.visibleRegion().boundingRect().bottom(), answer.rect().bottom());
}

void LearningAidsTest::aNumberStaysOnOneLineWithItsUnit_data()
{
    QTest::addColumn<QString>("markdown");
    QTest::addColumn<QString>("together");
    QTest::newRow("two sizes") << "It has left the stage of 540 × 400\u202Fpx."
                               << "540\u00A0×\u00A0400\u202Fpx.";
    QTest::newRow("a product") << "The first flight takes 2 ×\n0.8 times as long."
                               << "2\u00A0×\u00A00.8";
    QTest::newRow("a plain space") << "The stick is now 150 px long."
                                   << "150\u202Fpx";
    QTest::newRow("a thin space") << "It is at 72\u2009% of the limit."
                                  << "72\u202F%";
}

void LearningAidsTest::aNumberStaysOnOneLineWithItsUnit()
{
    QFETCH(QString, markdown);
    QFETCH(QString, together);
    const Theme theme(Scheme::light);
    QTextDocument document;
    setProse(document, markdown, ProseStyle(), theme);
    const QTextBlock block = document.firstBlock();
    const auto from = static_cast<int>(block.text().indexOf(together));
    QVERIFY2(from >= 0, qPrintable(block.text()));
    for (int width = 110; width < 400; width += 5) {
        layOut(document, width);
        QVERIFY(document.size().height() > 0.0); // lays it out
        const QTextLayout &lines = *block.layout();
        QCOMPARE(lines.lineForTextPosition(from).lineNumber(),
                 lines.lineForTextPosition(from + static_cast<int>(together.size()) - 1).lineNumber());
    }
}

void LearningAidsTest::aWordIsLinkedWhereItStandsFirst()
{
    LearnFixture fixture;
    const QString plain = fixture.text().toPlainText();
    const auto linkAt = [&](qsizetype position) {
        QTextCursor cursor(fixture.text().document());
        cursor.setPosition(static_cast<int>(position) + 1);
        return wordOf(QUrl(cursor.charFormat().anchorHref()));
    };
    QCOMPARE(linkAt(plain.indexOf("spring")), QString("Spring"));
    QCOMPARE(linkAt(plain.lastIndexOf("spring")), QString());
    QCOMPARE(linkAt(plain.indexOf("pulls")), QString());
    QVERIFY(fixture.text().focusPolicy() & Qt::TabFocus);
}

void LearningAidsTest::aWordOpensACard_data()
{
    aHintIsShownWhenItIsAskedFor_data();
}

void LearningAidsTest::aWordOpensACard()
{
    QFETCH(bool, byKey);
    LearnFixture fixture;
    if (byKey) {
        fixture.text().setFocus(Qt::TabFocusReason);
        QTest::keyClick(&fixture.text(), Qt::Key_Tab);
        QTest::keyClick(&fixture.text(), Qt::Key_Return);
    } else {
        const auto at = static_cast<int>(fixture.text().toPlainText().indexOf("spring")) + 2;
        QTest::mouseClick(fixture.text().viewport(), Qt::LeftButton, {}, placeOf(fixture.text(), at));
    }
    QVERIFY(fixture.card().isVisible());
    QCOMPARE(fixture.card().accessibleName(), QString("Spring"));
    QVERIFY(fixture.card().findChild<NarrationText *>()->toPlainText().contains("too far apart"));
    QCOMPARE(fixture.session.step().id, QString("first")); // the lesson is not left
    QTest::keyClick(&fixture.card(), Qt::Key_Escape);
    QVERIFY(!fixture.card().isVisible());
}

void LearningAidsTest::theCardIsAsHighAsWhatIsOnIt()
{
    LearnFixture fixture;
    for (const char *word : {"Spring", "Damping"}) {
        fixture.card().popUp(word, {100, 100});
        QCoreApplication::processEvents();
        const auto *name = fixture.card().findChild<QLabel *>("heading");
        const auto *text = fixture.card().findChild<NarrationText *>();
        QCOMPARE(name->height(), name->sizeHint().height());
        QCOMPARE(text->height(), text->heightForWidth(text->width()));
        fixture.card().close();
    }
}

void LearningAidsTest::theCardLeadsToTheStepThatTeachesTheWord()
{
    LearnFixture fixture;
    fixture.card().popUp("Damping", {100, 100});
    auto *text = fixture.card().findChild<NarrationText *>();
    QTest::keyClick(text, Qt::Key_Tab);
    QTest::keyClick(text, Qt::Key_Return);
    QVERIFY(!fixture.card().isVisible());
    QCOMPARE(fixture.session.lesson().id, QString("two"));
}

void LearningAidsTest::theCardLeadsToAllWords()
{
    LearnFixture fixture;
    QString asked;
    connect(&fixture.panel, &LearnPanel::glossaryRequested, &fixture.panel,
            [&](const QString &name) { asked = name; });
    fixture.card().popUp("Damping", {100, 100});
    auto *text = fixture.card().findChild<NarrationText *>();
    QTest::keyClick(text, Qt::Key_Tab);
    QTest::keyClick(text, Qt::Key_Tab);
    QTest::keyClick(text, Qt::Key_Return);
    QCOMPARE(asked, QString("Damping"));
}

void LearningAidsTest::theGlossaryFindsWordsAsTheyAreTyped()
{
    SessionFixture world{toldLessons()};
    const Glossary glossary(world.library);
    GlossaryPage page(glossary, world.theme);
    page.search({});
    QVERIFY(QTest::qWaitForWindowActive(&page));
    auto *list = page.findChild<QTextBrowser *>();
    auto *field = page.findChild<QLineEdit *>();
    QVERIFY(list->toPlainText().contains("Spring") && list->toPlainText().contains("Damping"));
    QTest::keyClicks(field, "spri");
    QVERIFY(list->toPlainText().contains("Spring") && !list->toPlainText().contains("Damping"));
    QTest::keyClicks(field, "xyz");
    QCOMPARE(list->toPlainText(), QString("No word found for “sprixyz”. Try only a part of it."));
    page.search("*_x_* <b>[a](b)\\");
    QCOMPARE(list->toPlainText(), QString("No word found for “*_x_* <b>[a](b)\\”. Try only a part of it."));
    QString asked;
    connect(&page, &GlossaryPage::stepRequested, &page,
            [&](const QString &lesson, const QString &step) { asked = lesson + '/' + step; });
    page.search("Damping");
    QTest::keyClick(field, Qt::Key_Tab);
    QTest::keyClick(list, Qt::Key_Tab);
    QTest::keyClick(list, Qt::Key_Return);
    QCOMPARE(asked, QString("two/many"));
    QVERIFY(page.isVisible());
    QTest::keyClick(&page, Qt::Key_Escape);
    QVERIFY(!page.isVisible());
}

void LearningAidsTest::anAnswerUnfolds_data()
{
    QTest::addColumn<int>("key"); // 0: the mouse
    QTest::newRow("mouse") << 0;
    QTest::newRow("space") << int(Qt::Key_Space);
    QTest::newRow("enter") << int(Qt::Key_Return);
}

void LearningAidsTest::anAnswerUnfolds()
{
    QFETCH(int, key);
    LearnFixture fixture;
    auto *button = fixture.panel.findChild<WhyButton *>();
    const auto &box = *fixture.panel.findChild<WhyBox *>();
    QCOMPARE(button->accessibleName(), QString("Why twice the pull?"));
    QVERIFY(!box.findChild<NarrationText *>()); // made when the box is opened
    const auto ask = [&] {
        if (key == 0)
            QTest::mouseClick(button, Qt::LeftButton);
        else
            QTest::keyClick(button, Qt::Key(key));
    };
    ask();
    const auto *answer = box.findChild<NarrationText *>();
    QVERIFY(answer && answer->isVisible());
    QVERIFY(answer->toPlainText().contains("pull = k × distance"));
    ask();
    QVERIFY(!answer->isVisible());
}

void LearningAidsTest::theSummaryTellsWhatWasLearntAndWhatIsOpen()
{
    LearnFixture fixture;
    fixture.session.progress().markDone("one", "first", 1);
    fixture.panel.showSummary(true);
    const auto *text = fixture.summary().findChild<NarrationText *>();
    QVERIFY(fixture.summary().isVisible() && !fixture.panel.narration().isVisible());
    QVERIFY(text->toPlainText().contains("1 of 2 things tried."));
    QVERIFY(text->toPlainText().contains("A spring pulls."));
    QVERIFY(text->toPlainText().contains("Still to try: Wait five frames."));
    QVERIFY(text->toPlainText().contains("Next: Lesson two. The second."));
    fixture.session.openStep("one", "second");
    QVERIFY(!fixture.summary().isVisible() && fixture.panel.narration().isVisible());
}

void LearningAidsTest::goingOnAfterTheLastStepShowsTheSummaryFirst()
{
    LearnFixture fixture;
    const Session &session = fixture.session;
    fixture.panel.goOn();
    QCOMPARE(session.step().id, QString("second"));
    fixture.panel.goOn();
    QVERIFY(fixture.summary().isVisible());
    QCOMPARE(session.step().id, QString("second"));
    fixture.panel.goBack();
    QVERIFY(!fixture.summary().isVisible());
    QCOMPARE(session.step().id, QString("second"));
    fixture.panel.goOn();
    fixture.panel.goOn();
    QVERIFY(!fixture.summary().isVisible());
    QCOMPARE(session.lesson().id, QString("two"));
    fixture.panel.goBack();
    QCOMPARE(session.lesson().id, QString("one"));
    fixture.panel.hide(); // nobody would see the summary
    fixture.panel.goOn();
    QCOMPARE(session.lesson().id, QString("two"));
}

void LearningAidsTest::theSummaryIsInTheList()
{
    LearnFixture fixture;
    auto *list = fixture.panel.findChild<LessonList *>();
    const QModelIndex lesson = list->model()->index(0, 0);
    const QModelIndex row = list->model()->index(2, 0, lesson);
    QCOMPARE(row.data().toString(), QString("What you learnt"));
    QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, list->visualRect(row).center());
    QVERIFY(fixture.summary().isVisible());
    QVERIFY(row.data(LessonModel::openRole).toBool());
    // And back to the step that is open anyway.
    const QModelIndex step = list->model()->index(0, 0, lesson);
    QVERIFY(!step.data(LessonModel::openRole).toBool());
    QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, list->visualRect(step).center());
    QVERIFY(!fixture.summary().isVisible());
    QVERIFY(step.data(LessonModel::openRole).toBool());
}

void LearningAidsTest::aLessonCanBeStartedOverAndTheTicksBroughtBack()
{
    LearnFixture fixture;
    Progress &progress = fixture.session.progress();
    fixture.panel.showSummary(true);
    QVERIFY(!fixture.startOver().isEnabled());
    progress.markDone("one", "first", 0);
    progress.markDone("two", "many", 0);
    QCOMPARE(fixture.startOver().text(), QString("Restart this lesson"));
    QTest::mouseClick(&fixture.startOver(), Qt::LeftButton);
    QVERIFY(!progress.isDone("one", "first", 0) && progress.isDone("two", "many", 0));
    QCOMPARE(fixture.startOver().text(), QString("Restore the ticks"));
    QTest::keyClick(&fixture.startOver(), Qt::Key_Space);
    QVERIFY(progress.isDone("one", "first", 0));
    QCOMPARE(fixture.startOver().text(), QString("Restart this lesson"));
}

SUITE(tst_learning_aids, LearningAidsTest)
#include "tst_learning_aids.moc"
