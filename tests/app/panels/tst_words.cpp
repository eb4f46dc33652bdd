// The words that lessons explain: links in the text, cards and the glossary, by mouse and keys.

#include "app/ui/learn/learn_panel.h"
#include "app/ui/learn/narration_text.h"
#include "app/ui/learn/prose.h"
#include "app/ui/learn/words/glossary_page.h"
#include "app/ui/learn/words/word_card.h"
#include "tests/app/support/panel_fixture.h"
#include "tests/suite.h"

#include <QLabel>
#include <QLineEdit>
#include <QSettings>
#include <QTest>

using namespace app;
using namespace tests;

namespace {

/// Returns two lessons. The first explains "Spring", the second "Damping".
LessonLibrary lessonsWithWords()
{
    LessonLibrary library = twoLessons();
    lessons::Step &first = library.lessons[0].steps[0];
    first.narration = "A **spring** pulls the foot. It is a spring.";
    first.explanation.terms = {{"Spring", "spring|springs", "It pulls two bodies together."}};
    library.lessons[1].steps[0].explanation.terms = {{"Damping", "damping", "A share that is kept."}};
    return library;
}

struct WordsFixture : PanelFixture<LearnPanel>
{
    WordsFixture() : PanelFixture(lessonsWithWords(), {280, 732}) {}

    NarrationText &text() const { return *panel.findChild<NarrationText *>(); }
    WordCard &card() const { return *panel.findChild<WordCard *>(); }
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

}

class WordCardTest : public QObject
{
    Q_OBJECT

private slots:
    void init() { QSettings().clear(); }

    void aWordIsLinkedWhereItStandsFirst();
    void aWordOpensACard_data();
    void aWordOpensACard();
    void theCardIsAsHighAsWhatIsOnIt();
    void theCardLeadsToTheStepThatTeachesTheWord();
    void linkOnTheCardOpensTheGlossary();
    void theGlossaryFindsWordsAsTheyAreTyped();
};

void WordCardTest::aWordIsLinkedWhereItStandsFirst()
{
    WordsFixture fixture;
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

void WordCardTest::aWordOpensACard_data()
{
    QTest::addColumn<bool>("byKey");
    QTest::newRow("mouse") << false;
    QTest::newRow("keyboard") << true;
}

void WordCardTest::aWordOpensACard()
{
    QFETCH(bool, byKey);
    WordsFixture fixture;
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
    QVERIFY(fixture.card().findChild<NarrationText *>()->toPlainText().contains("pulls two bodies together"));
    QCOMPARE(fixture.session.step().id, QString("first")); // the lesson is not left
    QTest::keyClick(&fixture.card(), Qt::Key_Escape);
    QVERIFY(!fixture.card().isVisible());
}

void WordCardTest::theCardIsAsHighAsWhatIsOnIt()
{
    WordsFixture fixture;
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

void WordCardTest::theCardLeadsToTheStepThatTeachesTheWord()
{
    WordsFixture fixture;
    fixture.card().popUp("Damping", {100, 100});
    auto *text = fixture.card().findChild<NarrationText *>();
    QTest::keyClick(text, Qt::Key_Tab);
    QTest::keyClick(text, Qt::Key_Return);
    QVERIFY(!fixture.card().isVisible());
    QCOMPARE(fixture.session.lesson().id, QString("two"));
}

void WordCardTest::linkOnTheCardOpensTheGlossary()
{
    WordsFixture fixture;
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

void WordCardTest::theGlossaryFindsWordsAsTheyAreTyped()
{
    SessionFixture world{lessonsWithWords()};
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

SUITE(tst_words, WordCardTest)
#include "tst_words.moc"
