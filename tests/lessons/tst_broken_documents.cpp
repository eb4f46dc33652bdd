// Documents with a mistake: each gets a sentence with the file, the line and the remedy.

#include "lessons/api/step.h"
#include "tests/lessons/support/mistakes.h"
#include "tests/suite.h"

#include <QTest>

namespace {

const QByteArray goodDocument = R"(# A foot

A foot on a **spring**.

### A subheading

It swings.

## Try {#pull}

Pull the foot. Does it
come back?

### Hint

Press **Space**.

### Choices

- [ ] No.
- [x] Yes, it
  does.

### Answer

Yes.

### Missing

- far: pull it farther. It came %1 px,
  and that is little.

## Predict {#rest}

Where does the foot
come to **rest**?

### Run

- k: 0.3
- mode: printed
- method: verlet
- foot: 300, -20.5
- drag foot: 310, 220, 10
- press: 5, 6, 20
- click: 7, 8
- frames: 120
- until: speed(foot) < 0.05

### Ask

- place: foot

### Answer

It rests on the cross.

## Predict {#curve}

Which curve?

### Run

- k: 0.2
- foot: 300, 220
- frames: 60

### Ask

- curve: foot.angle
- unit: degrees

### Other curve

- k: 0.1

### Other curve

- foot: 200, 220
- frames: 50

### Answer

The first.

## Task: the pull {#pull}

Write the **pull**.

### Comment

The pull.

### Hint

One.

### Hint

Two:

`foot`

### Hint

Three.

### Near miss

```
foot = 1;

## no heading
```

It stays.

### Near miss in damping

```
foot = 2;
```

It goes.

## Word: Spring

Forms: spring, springs

It pulls.

## Word: Foot

A small disc.

## Word: Toe

Forms: none

A part of a foot.

## Concept: Springs pull {#springs}

Rests on: frame, velocity

A spring pulls with
k times the distance.

## Concept: Feet {#feet}

They stand.

## Why: Why does it pull?

Because of

`k * x`

## Learnt

A spring pulls.
)";

const QString documentName = QStringLiteral("one/step.md");

/// Returns a step whose try, task and gaps are those of `goodDocument`.
lessons::Step goodStep()
{
    lessons::Step step;
    step.listing.gaps = {{"pull", 1, 1}, {"damping", 2, 1}};
    step.checks = {{.id = "pull",
                    .conditions = {{[](const sim::Timeline &) { return true; }},
                                   {[](const sim::Timeline &) { return false; }, "far"}}}};
    return step;
}

/// Returns what() of the mistake in a document of goodStep(). Empty if it has none.
QString mistakeIn(const QByteArray &source)
{
    return support::mistakeOf([&] { goodStep().setTexts(lessons::parseDocument(source, documentName)); });
}

const support::Mistake mistakes[] = {
    {"no title", "# A foot\n", "", "A foot on", "the title is missing. Begin the file with “# ”"},
    {"a second title", "## Learnt", "# Learnt", "# Learnt", "this is a second title. Write “## ” instead."},
    {"no story", "A foot on a **spring**.\n\n### A subheading\n\nIt swings.\n", "", "# A foot",
     "the story is missing. Write it below the title."},
    {"an unknown heading", "## Learnt", "## Learned", "## Learned",
     "“## Learned” is not a heading of a lesson."},
    {"a German heading", "## Why: W", "## Warum: W", "## Warum", "Write “## Try {#id}”"},
    {"a parameter of a lesson in C++", "## Try {#pull}", "## Parameter: K {#own}\n\nText.\n\n## Try {#pull}",
     "## Parameter", "the step has no parameter “own”."},
    {"no id", "## Try {#pull}", "## Try", "## Try", "“## Try” has no id. End the heading with “{#id}”"},
    {"an id with a capital", "## Try {#pull}", "## Try {#Pull}", "## Try",
     "“## Try {#Pull}” has no id. End the heading with “{#id}”, where id is made of a to z, 0 to 9 and _."},
    {"an id twice", "## Task: the pull", "## Try {#pull}\n\nAgain.\n\n### Hint\n\nSo.\n\n## Task: the pull",
     "## Try {#pull}\n\nAgain", "the id “pull” was used above. Choose another one."},
    {"a try without a text", "Pull the foot. Does it\ncome back?\n", "", "## Try",
     "there is no text below “## Try {#pull}”."},
    {"a try without a hint", "### Hint\n\nPress **Space**.\n", "", "## Try",
     "the thing to try “pull” has no hint. Write it below a “### Hint”."},
    {"an empty hint", "Press **Space**.\n", "", "### Hint",
     "there is no text below “### Hint”. Write it there, or remove the heading."},
    {"an answer twice", "### Missing", "### Answer\n\nNo.\n\n### Missing", "### Answer\n\nNo",
     "“### Answer” is there twice. Remove one of them."},
    {"an unknown field", "### Answer", "### Proof", "### Proof",
     "“### Proof” does not belong here. Here you can write “### Choices”, “### Hint”"},
    {"a condition with a wrong name", "### Missing", "### Done when\n\n- Far away: k > 1\n\n### Missing",
     "- Far away", "a condition cannot be called “Far away”."},
    {"a condition twice", "### Missing", "### Done when\n\n- far: k > 1\n- far: k > 2\n\n### Missing",
     "- far: k > 2", "a condition cannot be called “far”."},
    {"a solution without an end", "### Missing", "### Solution\n\n- k: 1\n\n### Missing", "### Solution",
     "this run needs “- frames: ”"},
    {"a sentence without a name", "- far: pull", "- pull", "### Missing",
     "has no name. Write “- name: sentence”"},
    {"a name twice", "- far: pull", "- far: more.\n- far: pull", "### Missing",
     "the name “far” is there twice."},
    {"a task without a title", "## Task: the pull {#pull}", "## Task {#pull}", "## Task {",
     "the task “pull” has no title. Write “## Task: title {#pull}”."},
    {"a task without a comment", "### Comment\n\nThe pull.\n", "", "## Task",
     "the task “pull” has no comment for the empty place."},
    {"two hints", "### Hint\n\nThree.\n", "", "## Task",
     "the number of hints of the task “pull” is 2, not 3."},
    {"code without an end", "foot = 2;\n```", "foot = 2;", "```\nfoot = 2;",
     "the code has no end. Write ```"},
    {"a near miss without code", "```\nfoot = 2;\n```\n", "", "### Near miss in",
     "this near miss is incomplete."},
    {"a near miss without a sentence", "It goes.\n", "", "### Near miss in", "this near miss is incomplete."},
    {"a near miss of another kind", "### Near miss in damping", "### Near miss: damping",
     "### Near miss:", "does not belong here. Here you can write “### Near miss”"},
    {"a word without a name", "## Word: Foot", "## Word", "## Word\n", "“## Word” is incomplete."},
    {"a word without an explanation", "It pulls.\n", "", "## Word: Spring",
     "the word “Spring” is not explained."},
    {"a word twice", "## Word: Foot", "## Word: Spring", "## Word: Spring\n\nA small",
     "the word “Spring” is there twice."},
    {"a concept without an id", "## Concept: Feet {#feet}", "## Concept: Feet", "## Concept: Feet",
     "“## Concept: Feet” has no id. End the heading with “{#id}”"},
    {"a concept without a title", "## Concept: Feet {#feet}", "## Concept {#feet}", "## Concept {",
     "the title of the concept “feet” has 0 characters. Write 1 to 22"},
    {"a long title of a concept", "## Concept: Feet {#feet}", "## Concept: Feet that stand on them {#feet}",
     "## Concept: Feet that", "the title of the concept “feet” has 23 characters. Write 1 to 22"},
    {"a concept twice", "## Concept: Feet {#feet}", "## Concept: Feet {#springs}", "## Concept: Feet",
     "the id “springs” was used above."},
    {"a concept without a sentence", "A spring pulls with\nk times the distance.\n", "",
     "## Concept: Springs", "the concept “springs” needs one paragraph besides “Rests on: …”."},
    {"a concept with two paragraphs", "They stand.", "They stand.\n\nThey go.", "## Concept: Feet",
     "the concept “feet” needs one paragraph"},
    {"a concept without a text", "They stand.\n", "", "## Concept: Feet", "there is no text below"},
    {"a field below a concept", "They stand.\n", "They stand.\n\n### Answer\n\nYes.\n",
     "### Answer\n\nYes.\n\n## Why", "“### Answer” does not belong here."},
    {"a why without a question", "## Why: Why does it pull?", "## Why", "## Why", "“## Why” is incomplete."},
    {"a why without an answer", "Because of\n\n`k * x`\n", "", "## Why", "there is no text below “## Why:"},
    {"learnt twice", "## Learnt", "## Learnt\n\nMuch.\n\n## Learnt", "## Learnt\n\nA spring",
     "“## Learnt” is there twice."},
    {"a field below a word", "A small disc.\n", "A small disc.\n\n### Hint\n\nNo.\n", "### Hint\n\nNo",
     "“### Hint” does not belong here."},
    {"Latin-1", "It stays.", "Er f\xE4llt.", "Er f",
     "this is not UTF-8. Save the file with the encoding UTF-8."},
    {"zeros", "It stays.", QByteArray("It\0stays.", 9), QByteArray("It\0", 3), "this is not UTF-8."},
    {"choices without an answer", "### Answer\n\nYes.\n", "", "## Try",
     "the thing to try “pull” has choices, but no answer."},
    {"no right choice", "- [x] Yes", "- [ ] Yes", "### Choices", "the number of right choices is 0, not 1."},
    {"two right choices", "- [ ] No", "- [x] No", "### Choices", "the number of right choices is 2, not 1."},
    {"one choice", "- [ ] No.\n", "", "### Choices", "the number of choices is 1. Write two to four."},
    {"a choice without a box", "- [ ] No.", "- No.", "### Choices",
     "“- No.” is not a choice. Write “- [ ] text”"},
    {"choices twice", "### Missing", "### Choices\n\n- [x] A.\n- [ ] B.\n\n### Missing",
     "### Choices\n\n- [x] A", "“### Choices” is there twice."},
    {"a prediction without an id", "## Predict {#rest}", "## Predict", "## Predict",
     "“## Predict” has no id."},
    {"a prediction without a question", "Where does the foot\ncome to **rest**?\n", "", "## Predict {#rest}",
     "the question of the prediction “rest” is missing."},
    {"a prediction without a run", "### Run\n\n- k: 0.2\n- foot: 300, 220\n- frames: 60\n", "",
     "## Predict {#curve}", "the prediction “curve” is incomplete. Write “### Run”"},
    {"a prediction that asks nothing", "### Ask\n\n- place: foot\n", "", "## Predict {#rest}",
     "the prediction “rest” is incomplete. Write “### Ask”"},
    {"a prediction without an answer", "### Answer\n\nIt rests on the cross.\n", "", "## Predict {#rest}",
     "the prediction “rest” is incomplete. Write “### Answer”"},
    {"an unknown field of a prediction", "### Answer\n\nIt rests", "### Hint\n\nIt rests",
     "### Hint\n\nIt rests", "“### Hint” does not belong here. Here you can write “### Run”, “### Ask”"},
    {"a run twice", "### Ask\n\n- place", "### Run\n\n- k: 1\n\n### Ask\n\n- place", "### Run\n\n- k: 1",
     "“### Run” is there twice. Remove one of them."},
    {"a run without an end", "- frames: 120\n", "", "### Run", "this run has no end. Write “- frames: ”"},
    {"a run that is too long", "- frames: 120", "- frames: 2001", "- frames: 2001",
     "“2001” is not a number of frames. Write a whole number from 1 to 2000."},
    {"half a frame", "- frames: 120", "- frames: 0.5", "- frames: 0.5", "“0.5” is not a number of frames."},
    {"a place without y", "- foot: 300, -20.5", "- foot: 300,", "- foot: 300,",
     "“300,” is not a place. Write x and y in px, as in “- foot: 300, 220”."},
    {"a drag without frames", "310, 220, 10", "310, 220", "- drag foot",
     "“310, 220” is incomplete. Write x and y in px and the number of frames, as in “- drag foot: 300, 220, "
     "10”."},
    {"a list with a sentence", "- k: 0.3\n", "The run.\n", "The run.",
     "“The run.” does not belong in this list. Write “- name: value”, on one line."},
    {"an empty list", "- place: foot\n", "", "### Ask", "there is no list below “### Ask”."},
    {"frames twice", "- frames: 120", "- frames: 120\n- frames: 30", "- frames: 30",
     "“frames” is there twice. Remove one of them."},
    {"a drag of nothing", "- drag foot: 310", "- drag: 310", "- drag: 310",
     "nothing says which body to drag. Write its name, as in “- drag foot: 310, 220, 10”."},
    {"until twice", "- until: speed", "- until: foot.x < 1\n- until: speed", "- until: speed",
     "“until” is there twice. Remove one of them."},
    {"an unknown question", "- place: foot", "- where: foot", "- where: foot",
     "“where” cannot be asked. Write “- place: body”"},
    {"two questions", "- place: foot", "- place: foot\n- number: frames", "- number: frames",
     "“number” does not belong here. A prediction asks one question"},
    {"frames without a condition", "- curve: foot.angle\n- unit: degrees", "- number: frames",
     "### Run\n\n- k: 0.2", "the number of frames is given away by the run. Write “- until: ”"},
    {"one other curve", "### Other curve\n\n- k: 0.1\n", "", "## Predict {#curve}",
     "the number of other curves of the prediction “curve” is 1, not 2."},
    {"other curves of a place", "- curve: foot.angle\n- unit: degrees", "- place: foot", "### Other curve",
     "“### Other curve” does not belong here."},
    {"an unknown try", "## Try {#pull}", "## Try {#push}", "## Try",
     "the thing to try “push” is unknown. Use one of the ids of this step: pull."},
    {"a missing sentence", "### Missing\n\n- far: pull it farther. It came %1 px,\n  and that is little.\n",
     "", "## Try", "the thing to try “pull” says nothing about what is missing for “far”."},
    {"an unknown sentence", "- far:", "- near: no.\n- far:", "### Missing",
     "the thing to try “pull” has no condition “near”. Remove the sentence, or give it one of the names: "
     "far."},
    {"an unknown gap", "{#pull}\n\nWrite", "{#push}\n\nWrite", "## Task",
     "the listing has no gap “push”. Use one of: pull, damping."},
    {"an unknown gap of a near miss", "miss in damping", "miss in gravity", "## Task",
     "the listing has no gap “gravity”."},
};

}

class BrokenDocumentsTest : public QObject
{
    Q_OBJECT

private slots:
    void aDocumentIsReadAsWritten();
    void predictionsAreReadAsWritten();
    void lineEndsAndAByteOrderMarkMakeNoDifference();
    void aMistakeIsNamedWithItsRemedy_data();
    void aMistakeIsNamedWithItsRemedy();
    void mistakeLeavesTheStepUnchanged();
    void errorOfAListingWithoutAGapSaysHowToAddOne();
    void conditionsGetTheirHints();
};

void BrokenDocumentsTest::aDocumentIsReadAsWritten()
{
    const lessons::Document document = lessons::parseDocument(goodDocument, documentName);
    QCOMPARE(document.title, QString("A foot"));
    QCOMPARE(document.story, QString("A foot on a **spring**.\n\n### A subheading\n\nIt swings."));
    QCOMPARE(document.tries.size(), 1u);
    QCOMPARE(document.tries[0].text, QString("Pull the foot. Does it come back?"));
    QCOMPARE(document.tries[0].missing.value("far"),
             QString("pull it farther. It came %1 px, and that is little."));
    QCOMPARE(document.tries[0].choices.texts, QStringList({"No.", "Yes, it does."}));
    QCOMPARE(document.tries[0].choices.right, 1);
    const lessons::CodeTask &task = document.tasks[0];
    QCOMPARE(task.title, QString("the pull"));
    QCOMPARE(task.hints, QStringList({"One.", "Two:\n\n`foot`", "Three."}));
    QCOMPARE(task.nearMisses[0].code, QString("foot = 1;\n\n## no heading"));
    QCOMPARE(task.nearMisses[1].gap, QString("damping"));
    QCOMPARE(document.explanation.terms[0].forms, QString("spring|springs"));
    QCOMPARE(document.explanation.terms[1].forms, QString("Foot"));
    QCOMPARE(document.explanation.terms[2].forms, QString());
    QCOMPARE(document.explanation.concepts[0].id, QString("springs"));
    QCOMPARE(document.explanation.concepts[0].title, QString("Springs pull"));
    QCOMPARE(document.explanation.concepts[0].restsOn, QStringList({"frame", "velocity"}));
    QCOMPARE(document.explanation.concepts[0].text, QString("A spring pulls with k times the distance."));
    QCOMPARE(document.explanation.concepts[1].restsOn, QStringList());
    QCOMPARE(document.explanation.whys[0].answer, QString("Because of\n\n`k * x`"));
    QCOMPARE(mistakeIn(goodDocument), QString());
}

void BrokenDocumentsTest::predictionsAreReadAsWritten()
{
    const lessons::Document document = lessons::parseDocument(goodDocument, documentName);
    QCOMPARE(document.predictions.size(), 2u);
    const lessons::Prediction &rest = document.predictions[0];
    QCOMPARE(rest.text, QString("Where does the foot come to **rest**?"));
    QCOMPARE(rest.answer, QString("It rests on the cross."));
    QVERIFY(rest.question.kind == lessons::Question::Kind::place);
    QCOMPARE(rest.question.of, QString("foot"));
    using Values = std::vector<std::pair<QString, QString>>;
    QVERIFY(rest.run.values == Values({{"k", "0.3"}, {"mode", "printed"}}));
    QCOMPARE(rest.run.method, QString("verlet"));
    QVERIFY(rest.run.places.at(0).at == (sim::Vec2{300.0, -20.5}));
    QCOMPARE(rest.run.drags.at(0).body, QString("foot"));
    QVERIFY(rest.run.drags.at(0).to == (sim::Vec2{310.0, 220.0}));
    QCOMPARE(rest.run.drags.at(0).frames, 10);
    QVERIFY(rest.run.press && rest.run.press->at == (sim::Vec2{5.0, 6.0}) && rest.run.press->frames == 20);
    QVERIFY(rest.run.click && *rest.run.click == (sim::Vec2{7.0, 8.0}));
    QCOMPARE(rest.run.frames, 120);
    QCOMPARE(rest.run.until, QString("speed(foot) < 0.05"));
    const lessons::Prediction &curve = document.predictions[1];
    QCOMPARE(curve.question.unit, QString("degrees"));
    QVERIFY(curve.otherCurves.at(0).values == Values({{"k", "0.1"}})); // in place of that of the run
    QVERIFY(curve.otherCurves.at(0).places.at(0).at == (sim::Vec2{300.0, 220.0}));
    QVERIFY(curve.otherCurves.at(1).values == Values({{"k", "0.2"}}));
    QVERIFY(curve.otherCurves.at(1).places.at(0).at == (sim::Vec2{200.0, 220.0}));
    QCOMPARE(curve.otherCurves.at(1).frames, 50);
    lessons::Step step = goodStep();
    step.setTexts(document);
    QCOMPARE(step.predictions.size(), 2u);
    QCOMPARE(step.tries.at(0).choices.texts.size(), 2);
}

void BrokenDocumentsTest::lineEndsAndAByteOrderMarkMakeNoDifference()
{
    QByteArray other = "\xEF\xBB\xBF" + goodDocument;
    other.replace("\n", "\r\n");
    const lessons::Document document = lessons::parseDocument(other, documentName);
    QCOMPARE(document.title, QString("A foot"));
    QCOMPARE(document.tasks[0].nearMisses[0].code, QString("foot = 1;\n\n## no heading"));
    QCOMPARE(mistakeIn(other), QString());
}

void BrokenDocumentsTest::aMistakeIsNamedWithItsRemedy_data()
{
    support::addMistakeRows(mistakes);
}

void BrokenDocumentsTest::aMistakeIsNamedWithItsRemedy()
{
    support::checkMistake(goodDocument, documentName, mistakeIn);
}

void BrokenDocumentsTest::mistakeLeavesTheStepUnchanged()
{
    lessons::Step step = goodStep();
    step.setTexts(lessons::parseDocument(goodDocument, documentName));
    QByteArray other = goodDocument;
    other.replace("# A foot\n", "# Another\n");
    other.replace("## Try {#pull}", "## Try {#push}");
    QVERIFY_THROWS_EXCEPTION(lessons::DocumentError,
                             step.setTexts(lessons::parseDocument(other, documentName)));
    QCOMPARE(step.title, QString("A foot"));
    QCOMPARE(step.tries[0].id, QString("pull"));
}

void BrokenDocumentsTest::errorOfAListingWithoutAGapSaysHowToAddOne()
{
    lessons::Step step = goodStep();
    step.listing = {};
    QString why;
    try {
        step.setTexts(lessons::parseDocument(goodDocument, "foot.md"));
    } catch (const lessons::DocumentError &error) {
        why = QString::fromUtf8(error.what());
    }
    const QString remedy = "the listing has no gap “pull”. In foot.code, put the lines that learners write "
                           "between “//> pull” and “//<”.";
    QVERIFY2(why.endsWith(remedy), qPrintable(why));
}

void BrokenDocumentsTest::conditionsGetTheirHints()
{
    lessons::Step step = goodStep();
    step.setTexts(lessons::parseDocument(goodDocument, documentName));
    const std::vector<lessons::Condition> &all = step.tries[0].conditions.all();
    QCOMPARE(all[0].todo, QString());
    QCOMPARE(all[1].todo, QString("pull it farther. It came %1 px, and that is little."));
}

SUITE(tst_broken_documents, BrokenDocumentsTest)
#include "tst_broken_documents.moc"
