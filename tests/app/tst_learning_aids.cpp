// Hints, words, why-boxes and the summary, asked for with mouse and keyboard.

#include "app/ui/panels/glossary_page.h"
#include "app/ui/panels/learn_panel.h"
#include "app/ui/panels/lesson_list.h"
#include "app/ui/panels/lesson_model.h"
#include "app/ui/panels/narration.h"
#include "app/ui/panels/narration_text.h"
#include "app/ui/panels/prose.h"
#include "app/ui/panels/step_button.h"
#include "app/ui/panels/summary_page.h"
#include "app/ui/panels/try_box.h"
#include "app/ui/panels/try_row.h"
#include "app/ui/panels/why_box.h"
#include "app/ui/panels/word_card.h"
#include "panels_bench.h"

#include <QAbstractTextDocumentLayout>
#include <QLabel>
#include <QLineEdit>
#include <QTest>
#include <QTextBlock>
#include <QToolButton>

using namespace app;

namespace {

/// The lessons of the bench, and what is told besides.
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

struct Bench
{
    World world{toldLessons()};
    LearnPanel panel{world.session, world.theme};

    Bench() { show(panel, {280, 732}); }

    std::vector<TryBox *> boxes() const
    {
        const auto found = panel.findChildren<TryBox *>();
        return {found.begin(), found.end()};
    }
    NarrationText &text() const { return *panel.findChild<NarrationText *>(); }
    WordCard &card() const { return *panel.findChild<WordCard *>(); }
    SummaryPage &summary() const { return *panel.findChild<SummaryPage *>(); }
    QToolButton &startOver() const { return *panel.findChild<QToolButton *>("startOver"); }
    bool isDone() const { return world.session.lesson().id == "one" && tick()->isChecked(); }
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
    void initTestCase() { prepareProgram(); }
    void init() { forgetProgress(); }

    void aHintIsShownWhenItIsAskedFor_data();
    void aHintIsShownWhenItIsAskedFor();
    void theNextHintIsTheFirstThatIsNotShown();
    void hintsAreRememberedUntilTheProgramEnds();
    void whatIsDoneNeedsNoHint();
    void whatIsBegunSaysWhatIsMissing();
    void whatIsToStopCountsOnlyWhileTheRunStands();
    void anAnswerAppearsWhenItsQuestionIsTickedOff();
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
    Bench bench;
    const TryBox &box = *bench.boxes()[0];
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
    QVERIFY(!bench.boxes()[1]->showsHint());
    QTest::mouseClick(lampOf(box), Qt::LeftButton);
    QVERIFY(!box.showsHint());
}

void LearningAidsTest::theNextHintIsTheFirstThatIsNotShown()
{
    Bench bench;
    bench.panel.narration().showNextHint();
    QVERIFY(bench.boxes()[0]->showsHint() && !bench.boxes()[1]->showsHint());
    bench.panel.narration().showNextHint();
    QVERIFY(bench.boxes()[0]->showsHint() && bench.boxes()[1]->showsHint());
    bench.panel.narration().showNextHint(); // no more
}

void LearningAidsTest::hintsAreRememberedUntilTheProgramEnds()
{
    {
        Bench bench;
        QTest::mouseClick(lampOf(*bench.boxes()[1]), Qt::LeftButton);
        bench.world.session.openStep("one", "second");
        bench.world.session.openStep("one", "first");
        QVERIFY(!bench.boxes()[0]->showsHint() && bench.boxes()[1]->showsHint());
    }
    Bench again;
    QVERIFY(!again.boxes()[1]->showsHint());
}

void LearningAidsTest::whatIsDoneNeedsNoHint()
{
    Bench bench;
    QTest::mouseClick(lampOf(*bench.boxes()[0]), Qt::LeftButton);
    for (int i = 0; i < 5; ++i)
        bench.world.session.frameForward();
    QVERIFY(bench.isDone());
    QVERIFY(!bench.boxes()[0]->showsHint() && !lampOf(*bench.boxes()[0])->isVisible());
}

namespace {

/// A thing to try that is begun at frame 1 and done at frame 5.
lessons::Try toFrameFive()
{
    const auto frame = [](const sim::Timeline &run) { return static_cast<double>(run.cursor().frame); };
    return {"Go to frame 5. What is there?",
            {lessons::atLeast(1.0, frame, {}),
             lessons::atLeast(5.0, frame, "go on to frame **5**. This is frame %1.", 0)}};
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
    World world{lessonsWith(toFrameFive())};
    LearnPanel panel(world.session, world.theme);
    show(panel, {280, 732});
    const TryBox &box = *panel.findChild<TryBox *>();
    QVERIFY(!textOf(box, "todoText")->isVisible());
    world.session.goTo({3, 0});
    QTRY_VERIFY(textOf(box, "todoText")->isVisible());
    QCOMPARE(textOf(box, "todoText")->toPlainText(),
             QString("Still to do: go on to frame 5. This is frame 3."));
    QCOMPARE(box.findChild<TryRow *>()->accessibleDescription(), textOf(box, "todoText")->toPlainText());
    world.session.goTo({5, 0});
    QVERIFY(box.isDone());
    QVERIFY(!textOf(box, "todoText")->isVisible());
    QVERIFY(box.findChild<TryRow *>()->accessibleDescription().isEmpty());
}

void LearningAidsTest::whatIsToStopCountsOnlyWhileTheRunStands()
{
    lessons::Try one = toFrameFive();
    one.onlyWhilePaused = true;
    World world{lessonsWith(one)};
    LearnPanel panel(world.session, world.theme);
    show(panel, {280, 732});
    const TryBox &box = *panel.findChild<TryBox *>();
    world.session.play();
    QTRY_VERIFY(world.session.timeline().cursor().frame > 6);
    QVERIFY(world.session.isPlaying());
    QVERIFY(!box.isDone());
    QTRY_VERIFY(textOf(box, "todoText")->toPlainText().contains("Space"));
    world.session.pause();
    QVERIFY(box.isDone());
}

void LearningAidsTest::anAnswerAppearsWhenItsQuestionIsTickedOff()
{
    lessons::Try one = toFrameFive();
    one.answer = "Nothing *new*.";
    World world{lessonsWith(one)};
    LearnPanel panel(world.session, world.theme);
    show(panel, {280, 732});
    const auto found = panel.findChildren<TryBox *>();
    TryBox &first = *found[0], &second = *found[1];
    QVERIFY(!textOf(first, "answerText")->isVisible());
    QVERIFY(!lampOf(first)->isVisible()); // it has no hint
    world.session.goTo({5, 0});
    QCOMPARE(textOf(second, "answerText")->toPlainText(), QString("Nothing new."));
    QVERIFY(textOf(second, "answerText")->isVisible()); // of what was done last
    QVERIFY(!textOf(first, "answerText")->isVisible());
    QVERIFY(lampOf(first)->accessibleName().startsWith("Answer"));
    QTest::mouseClick(lampOf(first), Qt::LeftButton);
    QVERIFY(textOf(first, "answerText")->isVisible());
    QTest::mouseClick(lampOf(first), Qt::LeftButton);
    QVERIFY(!textOf(first, "answerText")->isVisible());
}

void LearningAidsTest::aWordIsLinkedWhereItStandsFirst()
{
    Bench bench;
    const QString plain = bench.text().toPlainText();
    const auto linkAt = [&](qsizetype position) {
        QTextCursor cursor(bench.text().document());
        cursor.setPosition(static_cast<int>(position) + 1);
        return wordOf(QUrl(cursor.charFormat().anchorHref()));
    };
    QCOMPARE(linkAt(plain.indexOf("spring")), QString("Spring"));
    QCOMPARE(linkAt(plain.lastIndexOf("spring")), QString());
    QCOMPARE(linkAt(plain.indexOf("pulls")), QString());
    QVERIFY(bench.text().focusPolicy() & Qt::TabFocus);
}

void LearningAidsTest::aWordOpensACard_data()
{
    aHintIsShownWhenItIsAskedFor_data();
}

void LearningAidsTest::aWordOpensACard()
{
    QFETCH(bool, byKey);
    Bench bench;
    if (byKey) {
        bench.text().setFocus(Qt::TabFocusReason);
        QTest::keyClick(&bench.text(), Qt::Key_Tab);
        QTest::keyClick(&bench.text(), Qt::Key_Return);
    } else {
        const auto at = static_cast<int>(bench.text().toPlainText().indexOf("spring")) + 2;
        QTest::mouseClick(bench.text().viewport(), Qt::LeftButton, {}, placeOf(bench.text(), at));
    }
    QVERIFY(bench.card().isVisible());
    QCOMPARE(bench.card().accessibleName(), QString("Spring"));
    QVERIFY(bench.card().findChild<NarrationText *>()->toPlainText().contains("too far apart"));
    QCOMPARE(bench.world.session.step().id, QString("first")); // the lesson is not left
    QTest::keyClick(&bench.card(), Qt::Key_Escape);
    QVERIFY(!bench.card().isVisible());
}

void LearningAidsTest::theCardIsAsHighAsWhatIsOnIt()
{
    Bench bench;
    for (const char *word : {"Spring", "Damping"}) {
        bench.card().popUp(word, {100, 100});
        QCoreApplication::processEvents();
        const auto *name = bench.card().findChild<QLabel *>("heading");
        const auto *text = bench.card().findChild<NarrationText *>();
        QCOMPARE(name->height(), name->sizeHint().height());
        QCOMPARE(text->height(), text->heightForWidth(text->width()));
        bench.card().close();
    }
}

void LearningAidsTest::theCardLeadsToTheStepThatTeachesTheWord()
{
    Bench bench;
    bench.card().popUp("Damping", {100, 100});
    auto *text = bench.card().findChild<NarrationText *>();
    QTest::keyClick(text, Qt::Key_Tab);
    QTest::keyClick(text, Qt::Key_Return);
    QVERIFY(!bench.card().isVisible());
    QCOMPARE(bench.world.session.lesson().id, QString("two"));
}

void LearningAidsTest::theCardLeadsToAllWords()
{
    Bench bench;
    QString asked;
    connect(&bench.panel, &LearnPanel::glossaryAsked, &bench.panel,
            [&](const QString &name) { asked = name; });
    bench.card().popUp("Damping", {100, 100});
    auto *text = bench.card().findChild<NarrationText *>();
    QTest::keyClick(text, Qt::Key_Tab);
    QTest::keyClick(text, Qt::Key_Tab);
    QTest::keyClick(text, Qt::Key_Return);
    QCOMPARE(asked, QString("Damping"));
}

void LearningAidsTest::theGlossaryFindsWordsAsTheyAreTyped()
{
    World world{toldLessons()};
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
    QCOMPARE(list->toPlainText(), QString("No word is found for “sprixyz”. Try a part of it."));
    page.search("*_x_* <b>[a](b)\\");
    QCOMPARE(list->toPlainText(), QString("No word is found for “*_x_* <b>[a](b)\\”. Try a part of it."));
    QString asked;
    connect(&page, &GlossaryPage::stepAsked, &page,
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
    Bench bench;
    auto *button = bench.panel.findChild<WhyButton *>();
    const auto *answer = bench.panel.findChild<WhyBox *>()->findChild<NarrationText *>();
    QCOMPARE(button->accessibleName(), QString("Why twice the pull?"));
    QVERIFY(!answer->isVisible());
    const auto ask = [&] {
        if (key == 0)
            QTest::mouseClick(button, Qt::LeftButton);
        else
            QTest::keyClick(button, Qt::Key(key));
    };
    ask();
    QVERIFY(answer->isVisible());
    QVERIFY(answer->toPlainText().contains("pull = k × distance"));
    ask();
    QVERIFY(!answer->isVisible());
}

void LearningAidsTest::theSummaryTellsWhatWasLearntAndWhatIsOpen()
{
    Bench bench;
    bench.world.session.progress().markDone("one", "first", 1);
    bench.panel.showSummary(true);
    const auto *text = bench.summary().findChild<NarrationText *>();
    QVERIFY(bench.summary().isVisible() && !bench.panel.narration().isVisible());
    QVERIFY(text->toPlainText().contains("1 of 2 things tried."));
    QVERIFY(text->toPlainText().contains("A spring pulls."));
    QVERIFY(text->toPlainText().contains("Still to try: Wait five frames."));
    QVERIFY(text->toPlainText().contains("Next: Lesson two. The second."));
    bench.world.session.openStep("one", "second");
    QVERIFY(!bench.summary().isVisible() && bench.panel.narration().isVisible());
}

void LearningAidsTest::goingOnAfterTheLastStepShowsTheSummaryFirst()
{
    Bench bench;
    const Session &session = bench.world.session;
    bench.panel.goOn();
    QCOMPARE(session.step().id, QString("second"));
    bench.panel.goOn();
    QVERIFY(bench.summary().isVisible());
    QCOMPARE(session.step().id, QString("second"));
    bench.panel.goBack();
    QVERIFY(!bench.summary().isVisible());
    QCOMPARE(session.step().id, QString("second"));
    bench.panel.goOn();
    bench.panel.goOn();
    QVERIFY(!bench.summary().isVisible());
    QCOMPARE(session.lesson().id, QString("two"));
    bench.panel.goBack();
    QCOMPARE(session.lesson().id, QString("one"));
    bench.panel.hide(); // nobody would see the summary
    bench.panel.goOn();
    QCOMPARE(session.lesson().id, QString("two"));
}

void LearningAidsTest::theSummaryIsInTheList()
{
    Bench bench;
    auto *list = bench.panel.findChild<LessonList *>();
    const QModelIndex lesson = list->model()->index(0, 0);
    const QModelIndex row = list->model()->index(2, 0, lesson);
    QCOMPARE(row.data().toString(), QString("What you learnt"));
    QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, list->visualRect(row).center());
    QVERIFY(bench.summary().isVisible());
    QVERIFY(row.data(LessonModel::openRole).toBool());
    // And back to the step that is open anyway.
    const QModelIndex step = list->model()->index(0, 0, lesson);
    QVERIFY(!step.data(LessonModel::openRole).toBool());
    QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, list->visualRect(step).center());
    QVERIFY(!bench.summary().isVisible());
    QVERIFY(step.data(LessonModel::openRole).toBool());
}

void LearningAidsTest::aLessonCanBeStartedOverAndTheTicksBroughtBack()
{
    Bench bench;
    Progress &progress = bench.world.session.progress();
    bench.panel.showSummary(true);
    QVERIFY(!bench.startOver().isEnabled());
    progress.markDone("one", "first", 0);
    progress.markDone("two", "many", 0);
    QCOMPARE(bench.startOver().text(), QString("Start this lesson over"));
    QTest::mouseClick(&bench.startOver(), Qt::LeftButton);
    QVERIFY(!progress.isDone("one", "first", 0) && progress.isDone("two", "many", 0));
    QCOMPARE(bench.startOver().text(), QString("Bring the ticks back"));
    QTest::keyClick(&bench.startOver(), Qt::Key_Space);
    QVERIFY(progress.isDone("one", "first", 0));
    QCOMPARE(bench.startOver().text(), QString("Start this lesson over"));
}

QTEST_MAIN(LearningAidsTest)
#include "tst_learning_aids.moc"
