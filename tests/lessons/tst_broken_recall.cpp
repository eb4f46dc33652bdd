// Files with recall questions that have a mistake: each gets a sentence with the file, the line and the remedy.

#include "lessons/api/text/document.h"
#include "lessons/api/text/recall.h"
#include "tests/lessons/support/mistakes.h"
#include "tests/suite.h"

#include <QTest>

namespace {

const QByteArray goodRecall = R"(# What do you remember?

About a foot
on a spring.

## Question {#sign}

Which line **pulls**?

### Wrong

`foot -= k;`

It pushes.

### Right

`foot += k;`

It pulls. It
does so always.

### Wrong

`foot = k;`

It jumps.

And it forgets.

## Question {#share}

How much is kept?

### Right

Nine tenths

### Wrong

A tenth

That is lost.

## Question {#left}

Drag the foot to the left.

### Do

- step: single_spring/radial
- k: 0.2
- foot: 300, 220
- until: foot.x < 200 and abs(foot.y) < 8

### Answer

The angle is π.
)";

const QString recallName = QStringLiteral("one/recall.md");

/// Returns what() of the mistake in a file with questions. Empty if it has none.
QString recallMistake(const QByteArray &source)
{
    return support::mistakeOf([&] { lessons::parseRecall(source, recallName); });
}

const support::Mistake recallMistakes[] = {
    {"no title", "# What do you remember?\n", "", "About a foot", "the title is missing."},
    {"no text", "About a foot\non a spring.\n", "", "# What", "there is no text below the title."},
    {"another heading", "## Question {#share}", "## Try {#share}", "## Try",
     "“## Try {#share}” is not a heading of a recall question. Write “## Question {#id}”"},
    {"no id", "## Question {#share}", "## Question", "## Question\n", "Write “## Question {#id}”"},
    {"an id with a capital", "{#share}", "{#Share}", "## Question {#Share}", "Write “## Question {#id}”"},
    {"an id twice", "{#share}", "{#sign}", "## Question {#sign}\n\nHow", "the id “sign” was used above."},
    {"a question without a text", "How much is kept?\n", "", "## Question {#share}",
     "there is no text below “## Question {#share}”."},
    {"an unknown field", "### Answer", "### Hint", "### Hint",
     "“### Hint” does not belong here. Here you can write “### Right” and “### Wrong”"},
    {"an empty choice", "Nine tenths\n", "", "### Right\n\n\n### Wrong",
     "there is no text below “### Right”."},
    {"a wrong choice that is not explained", "That is lost.\n", "", "### Wrong\n\nA tenth",
     "this choice is not explained. Write why it is wrong below it"},
    {"no right choice", "### Right\n\nNine tenths\n", "", "## Question {#share}",
     "the question “share” is incomplete. Write one “### Right” and one to three “### Wrong”"},
    {"no wrong choice", "### Wrong\n\nA tenth\n\nThat is lost.\n", "", "## Question {#share}",
     "the question “share” is incomplete."},
    {"two right choices", "### Wrong\n\nA tenth", "### Right\n\nA tenth", "### Right\n\nA tenth",
     "“### Right” is there twice. Remove one of them."},
    {"five choices", "### Wrong\n\n`foot = k;`",
     "### Wrong\n\nA\n\nNo.\n\n### Wrong\n\nB\n\nNo.\n\n### Wrong\n\n`foot = k;`", "## Question {#sign}",
     "the question “sign” has 5 choices. Keep four at most."},
    {"a choice of fenced code", "Nine tenths\n", "```\nfoot\n```\n", "### Right\n\n```",
     "the choice begins with ```."},
    {"a long choice", "Nine tenths\n", QByteArray(91, 'x') + '\n', "### Right\n\nxxx",
     "the choice has 91 characters. Make its first paragraph 90 or shorter"},
    {"a choice beside a task", "### Answer\n\nThe angle", "### Right\n\nYes\n\n### Answer\n\nThe angle",
     "## Question {#left}", "the question “left” is incomplete."},
    {"an answer beside choices", "That is lost.\n", "That is lost.\n\n### Answer\n\nNo.\n",
     "## Question {#share}", "the question “share” is incomplete."},
    {"a task without an answer", "### Answer\n\nThe angle is π.\n", "", "## Question {#left}",
     "the question “left” is incomplete."},
    {"a task twice", "### Answer", "### Do\n\n- step: a/b\n- until: 1 > 0\n\n### Answer",
     "### Do\n\n- step: a/b", "“### Do” is there twice."},
    {"a task without a scene", "- step: single_spring/radial\n", "", "### Do",
     "the scene is missing. Write “- step: lesson/step” in the list."},
    {"a scene without a lesson", "single_spring/radial", "radial", "### Do", "the scene is missing."},
    {"a task without an end", "- until: foot.x < 200 and abs(foot.y) < 8\n", "", "### Do",
     "nothing says when this is done. Write “- until: condition” in the list."},
    {"a line that is no item", "- k: 0.2", "k is 0.2", "k is 0.2", "does not belong in this list."},
    {"Latin-1", "It jumps.", "Er h\xFCpft.", "Er h", "this is not UTF-8."},
};

}

class BrokenRecallTest : public QObject
{
    Q_OBJECT

private slots:
    void questionsAreReadAsWritten();
    void aMistakeIsNamedWithItsRemedy_data();
    void aMistakeIsNamedWithItsRemedy();
    void fileWithoutQuestionsIsAMistake();
    void aLessonWithoutAFileHasNoQuestions();
};

void BrokenRecallTest::questionsAreReadAsWritten()
{
    const lessons::Recall recall = lessons::parseRecall(goodRecall, recallName);
    QCOMPARE(recall.title, QString("What do you remember?"));
    QCOMPARE(recall.text, QString("About a foot on a spring."));
    QCOMPARE(recall.questions.size(), 3u);
    const lessons::RecallQuestion &sign = recall.questions[0];
    QCOMPARE(sign.id, QString("sign"));
    QCOMPARE(sign.text, QString("Which line **pulls**?"));
    QCOMPARE(sign.line, 6);
    QCOMPARE(sign.choices.size(), 3u);
    QCOMPARE(sign.choices[0].text, QString("`foot += k;`")); // the right one first
    QCOMPARE(sign.choices[0].explanation, QString("It pulls. It does so always."));
    QCOMPARE(sign.choices[1].text, QString("`foot -= k;`"));
    QCOMPARE(sign.choices[2].explanation, QString("It jumps.\n\nAnd it forgets."));
    QCOMPARE(recall.questions[1].choices[0].explanation, QString());
    const lessons::RecallQuestion &left = recall.questions[2];
    QVERIFY(left.task && left.choices.empty());
    QCOMPARE(left.task->setup.step, QString("single_spring/radial"));
    QCOMPARE(left.task->setup.values.front().second, QString("0.2"));
    QCOMPARE(left.task->setup.places.front().at.x, 300.0);
    QCOMPARE(left.task->setup.until, QString("foot.x < 200 and abs(foot.y) < 8"));
    QCOMPARE(left.task->answer, QString("The angle is π."));
}

void BrokenRecallTest::aMistakeIsNamedWithItsRemedy_data()
{
    support::addMistakeRows(recallMistakes);
}

void BrokenRecallTest::aMistakeIsNamedWithItsRemedy()
{
    support::checkMistake(goodRecall, recallName, recallMistake);
}

void BrokenRecallTest::fileWithoutQuestionsIsAMistake()
{
    QCOMPARE(recallMistake("# A title\n\nA text.\n"),
             QString("one/recall.md, line 1: there is no question. Write “## Question {#id}” and its text."));
}

void BrokenRecallTest::aLessonWithoutAFileHasNoQuestions()
{
    QVERIFY(lessons::readRecall("no_such_lesson").questions.empty());
}

SUITE(tst_broken_recall, BrokenRecallTest)
#include "tst_broken_recall.moc"
