// A notebook is checked by replaying its runs, which detects changes by hand.

#include "tests/app/notebook/notebook_maker.h"

#include "app/cli/notebook_report.h"
#include "app/model/experiment/experiment_line.h"
#include "app/model/learning/project_start.h"
#include "app/model/learning/recall_desk.h"
#include "app/model/notebook/notebook_check.h"
#include "app/model/notebook/notebook_file.h"
#include "tests/suite.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTest>

using namespace app;
using namespace tests;

namespace {

using EntryKind = NotebookEntry::Kind;
using Found = NotebookFinding::Result;
/// Changes a notebook as somebody could do in an editor.
using Forgery = std::function<NotebookEntry &(Notebook &)>;

const QString usualLesson = QStringLiteral("single_spring");

/// The right choices are the first of `share_kept`, and the second of `no_damping`.
NotebookEntry choiceOf(const QString &step, const QString &id, const QString &said, bool isRight)
{
    return {.kind = EntryKind::answer,
            .lesson = usualLesson,
            .step = step,
            .id = id,
            .said = said,
            .isRight = isRight};
}

/// Answers a recall question in its scene, as a learner does: she drags the foot to the left of the body.
const NotebookEntry &answerInScene()
{
    static const NotebookEntry entry = [] {
        forgetRecords();
        Session session(allLessons());
        RecallDesk desk(session);
        const LessonEntry &lesson = *allLessons().lesson(usualLesson);
        desk.start(lesson, lesson.recall.questions.back());
        const sim::Timeline &run = session.timeline();
        const sim::Vec2 body = run.state().positionOf(run.track().interval().scene.find("body"));
        session.input().grab("foot");
        for (int i = 0; i < 20 && !desk.isDone(); ++i) {
            session.input().moveTo(body - sim::Vec2{60.0, 0.0});
            session.playback().frameForward();
        }
        return collectNotebook({.lessons = {usualLesson}}, allLessons(), session.progress(), session.notes(),
                               session.proofs())
            .entries.at(0);
    }();
    return entry;
}

QByteArray plainRun(const QString &lesson, const QString &step)
{
    return textInLine(experimentLine(newExperiment(lesson, step, allLessons()), allLessons()));
}

CheckedNotebook checkedOf(const Notebook &notebook)
{
    CheckedNotebook checked{.file = "a.springstep-notebook", .notebook = notebook};
    for (const NotebookEntry &entry : notebook.entries)
        checked.findings.push_back(*checkEntry(entry, allLessons()));
    return checked;
}

/// A notebook with three results, and a name that a spreadsheet could take for a formula.
CheckedNotebook smallCheck()
{
    Notebook small{.name = "=1+1, \"Ada\"", .when = QDateTime({2026, 1, 31}, {12, 0}, Qt::UTC)};
    Notebook all = notebookOfAll(usualLesson);
    const NotebookEntry shown = entryOf(all, EntryKind::prediction, "other_side");
    NotebookEntry off = shown, missing = entryOf(all, EntryKind::level, "on_time");
    missing.run = {};
    off.said = "0.0, 0.0";
    off.isRight = false;
    small.entries = {shown, off, missing};
    return checkedOf(small);
}

}

Q_DECLARE_METATYPE(Forgery)

class NotebookCheckTest : public QObject
{
    Q_OBJECT

private slots:
    void theWorkInANotebookIsShown_data();
    void theWorkInANotebookIsShown();
    void aNotebookOfALessonIsSmall();
    void aForgeryIsFoundOut_data();
    void aForgeryIsFoundOut();
    void anAnswerIsChecked_data();
    void anAnswerIsChecked();
    void answersAreCollected();
    void aTickWithoutARunIsNamed();
    void anOldTickGetsItsRunWhenItIsDoneAgain();
    void aCancelledCheckSaysNothing();
    void theTableNamesEachResult();
    void theCsvHasARowForEachEntry();
    void theJsonHasTheDocumentedShape();
};

void NotebookCheckTest::theWorkInANotebookIsShown_data()
{
    QTest::addColumn<QString>("lesson");
    const QStringList slow = {"swaying_tree", "accuracy",
                              "hard_cases"}; // they take longer than all others together
    for (const LessonEntry &lesson : allLessons().lessons) {
        if (!slow.contains(lesson.id))
            QTest::newRow(qPrintable(lesson.id)) << lesson.id;
    }
}

void NotebookCheckTest::theWorkInANotebookIsShown()
{
    QFETCH(QString, lesson);
    const Notebook read =
        parseNotebook(notebookText(notebookOfAll(lesson)), "a.springstep-notebook", allLessons());
    QVERIFY(read.isSealed);
    QCOMPARE(read.entries.size(), notebookOfAll(lesson).entries.size());
    for (std::size_t i = 0; i < read.entries.size(); ++i)
        QVERIFY2(read.entries[i] == notebookOfAll(lesson).entries[i], qPrintable(read.entries[i].id));
    qsizetype tries = 0;
    for (const lessons::Step &step : allLessons().lesson(lesson)->steps)
        tries += static_cast<qsizetype>(step.tries.size());
    for (const NotebookEntry &entry : read.entries) {
        const NotebookFinding finding = *checkEntry(entry, allLessons());
        const Found expected = entry.said.isEmpty() ? Found::shown : Found::right;
        QVERIFY2(finding.result == expected, qPrintable(entry.step + '/' + entry.id + ": " +
                                                        wordFor(finding.result) + ' ' + finding.why));
        tries -= entry.kind == EntryKind::tried;
    }
    QCOMPARE(tries, 0);
}

void NotebookCheckTest::aNotebookOfALessonIsSmall()
{
    const QByteArray text = notebookText(notebookOfAll(usualLesson));
    QVERIFY2(text.size() < 100'000, qPrintable(QString::number(text.size())));
}

void NotebookCheckTest::aForgeryIsFoundOut_data()
{
    QTest::addColumn<Forgery>("forge");
    const Notebook &all = notebookOfAll(usualLesson);
    const NotebookEntry tried = all.entries.front();
    QCOMPARE(tried.kind, EntryKind::tried);
    const auto row = [](const char *name, const Forgery &forge) { QTest::newRow(name) << forge; };
    const auto ofTry = [id = tried.id](Notebook &book) -> NotebookEntry & {
        return entryOf(book, EntryKind::tried, id);
    };
    const auto ofCode = [](Notebook &book) -> NotebookEntry & {
        return entryOf(book, EntryKind::code, "pull");
    };
    const auto ofLevel = [](Notebook &book) -> NotebookEntry & {
        return entryOf(book, EntryKind::level, "on_time");
    };
    const auto ofGuess = [](Notebook &book) -> NotebookEntry & {
        return entryOf(book, EntryKind::prediction, "other_side");
    };
    const auto forged = [&row](const char *name, auto entryIn, auto change) {
        row(name, [entryIn, change](Notebook &book) -> NotebookEntry & {
            NotebookEntry &entry = entryIn(book);
            change(entry);
            return entry;
        });
    };
    forged("a try at another moment", ofTry, [](NotebookEntry &entry) { entry.run.at = {}; });
    forged("a try whose run has no input", ofTry,
           [](NotebookEntry &entry) { entry.run.text = plainRun(entry.lesson, entry.step); });
    forged("a try with the run of another step", ofTry,
           [](NotebookEntry &entry) { entry.run.text = plainRun(entry.lesson, "radial"); });
    forged("a try with an unknown field", ofTry, [](NotebookEntry &entry) {
        entry.run.text.chop(1);
        entry.run.text += ",\"speed\":1}";
    });
    forged("a try whose run is a text", ofTry, [](NotebookEntry &entry) { entry.run.text = "{\"a\":1}"; });
    forged("code with an empty place", ofCode, [](NotebookEntry &entry) {
        const lessons::Step &step = *allLessons().lesson(entry.lesson)->step(entry.step);
        entry.code = step.listing.with("pull", "");
    });
    forged("code that does not compile", ofCode, [](NotebookEntry &entry) { entry.code = "void frame("; });
    forged("a level with the start scene", ofLevel, [](NotebookEntry &entry) {
        const Experiment start = projectStart(*allLessons().lesson(entry.lesson), allLessons());
        entry.run.text = textInLine(experimentLine(start, allLessons()));
    });
    forged("a level with another run", ofLevel,
           [](NotebookEntry &entry) { entry.run.text = plainRun("two_body", "mutual"); });
    forged("a wrong guess that counts as right", ofGuess,
           [](NotebookEntry &entry) { entry.said = "1.0, 1.0"; });
    forged("a right guess that counts as wrong", ofGuess,
           [](NotebookEntry &entry) { entry.isRight = false; });
    forged("another outcome", ofGuess, [](NotebookEntry &entry) { entry.said = entry.found = "1.0, 1.0"; });
    forged("a guess that is none", ofGuess, [](NotebookEntry &entry) { entry.said = "over there"; });
}

void NotebookCheckTest::aForgeryIsFoundOut()
{
    QFETCH(Forgery, forge);
    Notebook book = notebookOfAll(usualLesson);
    const NotebookEntry forged = forge(book);
    // If the forger computes the seal again, the replay detects the change.
    const Notebook sealed = parseNotebook(notebookText(book), "a.springstep-notebook", allLessons());
    QVERIFY(sealed.isSealed);
    const NotebookFinding finding = *checkEntry(forged, allLessons());
    QCOMPARE(wordFor(finding.result), QString("not shown"));
    QVERIFY2(finding.why.endsWith('.') && !finding.why.contains('\n'), qPrintable(finding.why));
    // Otherwise the seal detects it.
    const QString written = notebookText(notebookOfAll(usualLesson)),
                  seal = written.section("\"seal\": ", 1).left(66);
    const QString changed = notebookText(book), own = changed.section("\"seal\": ", 1).left(66);
    QVERIFY(seal != own);
    const QByteArray unsealed = QString(changed).replace(own, seal).toUtf8();
    QVERIFY(!parseNotebook(unsealed, "a.springstep-notebook", allLessons()).isSealed);
}

void NotebookCheckTest::anAnswerIsChecked_data()
{
    QTest::addColumn<NotebookEntry>("entry");
    QTest::addColumn<QString>("result");
    QTest::addColumn<QString>("why");
    const auto row = [](const char *name, const NotebookEntry &entry, const char *result,
                        const char *why = "") {
        QTest::newRow(name) << entry << QString(result) << QString(why);
    };
    const auto inScene = [&](const char *name, auto change, const char *result, const char *why = "") {
        NotebookEntry entry = answerInScene();
        change(entry);
        row(name, entry, result, why);
    };
    const QString recall = "share_kept", guess = "no_damping", step = "fixed_centre";
    row("a right choice", choiceOf({}, recall, "1", true), "right");
    row("a wrong choice", choiceOf({}, recall, "2", false), "off", " was said; it is ");
    row("a wrong choice that counts as right", choiceOf({}, recall, "2", true), "not shown", " as right, ");
    row("a right choice that counts as wrong", choiceOf({}, recall, "1", false), "not shown",
        " as not right, ");
    row("a choice that is not there", choiceOf({}, recall, "9", true), "not shown", "cannot be read");
    row("a choice below the first", choiceOf({}, recall, "0", true), "not shown", "cannot be read");
    row("a choice that is none", choiceOf({}, recall, "the first", true), "not shown", "cannot be read");
    row("a right guess", choiceOf(step, guess, "2", true), "right");
    row("a wrong guess", choiceOf(step, guess, "1", false), "off", "as wide as at first");
    row("a wrong guess that counts as right", choiceOf(step, guess, "3", true), "not shown", "Each swing");
    inScene(
        "done in the scene", [](NotebookEntry &) {}, "shown");
    inScene(
        "another moment", [](NotebookEntry &entry) { entry.run.at = {}; }, "not shown", "At frame 0");
    inScene(
        "a run without input", [](NotebookEntry &entry) { entry.run.text = plainRun(usualLesson, "radial"); },
        "not shown", "does not do it");
    inScene(
        "the run of another step",
        [](NotebookEntry &entry) { entry.run.text = plainRun(usualLesson, "drag"); }, "not shown",
        "another step");
    inScene(
        "a text for a run", [](NotebookEntry &entry) { entry.run.text = "{}"; }, "not shown");
    inScene(
        "no run", [](NotebookEntry &entry) { entry.run = {}; }, "no run");
}

void NotebookCheckTest::anAnswerIsChecked()
{
    QFETCH(NotebookEntry, entry);
    QFETCH(QString, result);
    QFETCH(QString, why);
    const Notebook book{.when = QDateTime({2026, 1, 31}, {12, 0}, Qt::UTC), .entries = {entry}};
    const Notebook read = parseNotebook(notebookText(book), "a.springstep-notebook", allLessons());
    QVERIFY(read.isSealed);
    QCOMPARE(read.entries, book.entries);
    const CheckedNotebook checked = checkedOf(read);
    const NotebookFinding &finding = checked.findings[0];
    QCOMPARE(wordFor(finding.result), result);
    QVERIFY2(finding.why.contains(why), qPrintable(finding.why));
    QVERIFY(notebookCsv({checked}).contains("\"answer\",\"" + entry.id + '"'));
    QVERIFY(notebookTable({checked}).simplified().contains(" answer " + entry.id + ' ' + result));
}

void NotebookCheckTest::answersAreCollected()
{
    Record record;
    const LessonEntry &lesson = *allLessons().lesson(usualLesson);
    record.notes.keep(Notes::keyOf(usualLesson, "fixed_centre", "choice", "no_damping"),
                      {"choice", "1", "2", false});
    record.notes.keep(RecallDesk::keyOf(usualLesson, "share_kept"), {"recall", "2", "0", false});
    record.notes.keep(RecallDesk::keyOf(usualLesson, "left_of_body"), {"recall", {}, {}, true});
    QCOMPARE(notebookEntries(lesson, record.progress, record.notes), 3);
    // A question that has changed since has no such choice.
    record.notes.keep(RecallDesk::keyOf(usualLesson, "sign_of_pull"), {"recall", "7", "0", false});
    record.notes.keep(RecallDesk::keyOf(usualLesson, "twice_the_pull"), {"recall", "0", "0", true});
    const Notebook book = collectNotebook({.lessons = {usualLesson}}, allLessons(), record.progress,
                                          record.notes, record.proofs);
    QStringList said;
    for (const NotebookEntry &entry : book.entries)
        said << entry.step + '/' + entry.id + ' ' + entry.said;
    QCOMPARE(said, QStringList({"fixed_centre/no_damping 1", "/share_kept 3", "/left_of_body "}));
}

void NotebookCheckTest::aTickWithoutARunIsNamed()
{
    Record old; // of a version that kept no runs
    old.progress.markDone(usualLesson, "drag", 0);
    old.progress.markWritten(usualLesson, "drag", "throw");
    const Notebook book =
        collectNotebook({.lessons = {usualLesson}}, allLessons(), old.progress, old.notes, old.proofs);
    QCOMPARE(book.entries.size(), 2U);
    for (const NotebookEntry &entry : book.entries)
        QCOMPARE(wordFor(checkEntry(entry, allLessons())->result), QString("no run"));
    QCOMPARE(parseNotebook(notebookText(book), "a", allLessons()).entries, book.entries);
}

void NotebookCheckTest::anOldTickGetsItsRunWhenItIsDoneAgain()
{
    Record old;
    const LessonEntry &lesson = *allLessons().lesson(usualLesson);
    const lessons::Step &step = lesson.steps.front();
    for (int i = 0; i < static_cast<int>(step.tries.size()); ++i)
        old.progress.markDone(usualLesson, step.id, i);
    const QString key = Notes::keyOf(usualLesson, step.id, "try", step.tries.front().id);
    QVERIFY(!old.proofs.has(key));
    tryAll(usualLesson, old);
    QVERIFY(old.proofs.has(key));
    const Proof proof = *old.proofs.find(key);
    QCOMPARE(*Proofs().find(key), proof); // the next start reads the same
}

void NotebookCheckTest::aCancelledCheckSaysNothing()
{
    Notebook book = notebookOfAll(usualLesson);
    NotebookEntry &entry = entryOf(book, EntryKind::code, "pull");
    QVERIFY(!checkEntry(entry, allLessons(), [] { return false; }));
}

void NotebookCheckTest::theTableNamesEachResult()
{
    CheckedNotebook checked = smallCheck();
    checked.notebook.isSealed = false;
    const QStringList lines = notebookTable({checked}).split('\n');
    QCOMPARE(lines[0], QString("a.springstep-notebook, =1+1, \"Ada\", 2026-01-31T12:00:00Z"));
    QCOMPARE(lines[1].simplified(), QString("single_spring/fixed_centre prediction other_side right"));
    QVERIFY(lines[2].simplified().startsWith("single_spring/fixed_centre prediction other_side off"));
    QVERIFY(lines[3].simplified().startsWith("single_spring level on_time no run"));
    QCOMPARE(lines[4],
             QString("  2 of 3 are shown by their runs. The file was changed after it was written."));
    QVERIFY(!checked.holds());
}

void NotebookCheckTest::theCsvHasARowForEachEntry()
{
    const QStringList lines = notebookCsv({smallCheck()}).split('\n', Qt::SkipEmptyParts);
    QCOMPARE(lines.size(), 4);
    QCOMPARE(lines[0], QString("file,name,lesson,step,kind,id,when,result,sealed,why"));
    QVERIFY2(lines[1].startsWith("\"a.springstep-notebook\",\"'=1+1, \"\"Ada\"\"\",\"single_spring\","
                                 "\"fixed_centre\",\"prediction\",\"other_side\","),
             qPrintable(lines[1]));
    QVERIFY(lines[1].endsWith(",\"right\",\"yes\",\"\""));
}

void NotebookCheckTest::theJsonHasTheDocumentedShape()
{
    const CheckedNotebook unread{.file = "b", .mistake = "b: it is damaged."};
    const QJsonObject all = QJsonDocument::fromJson(notebookJson({smallCheck(), unread}).toUtf8()).object();
    const QJsonArray books = all["notebooks"].toArray();
    QCOMPARE(books.size(), 2);
    const QJsonObject first = books[0].toObject();
    QCOMPARE(first.keys(), QStringList({"entries", "file", "mistake", "name", "sealed", "when"}));
    QCOMPARE(first["entries"].toArray()[2].toObject().keys(),
             QStringList({"id", "kind", "lesson", "result", "step", "when", "why"}));
    QCOMPARE(first["entries"].toArray()[2].toObject()["result"].toString(), QString("no run"));
    QCOMPARE(books[1].toObject()["mistake"].toString(), unread.mistake);
}

SUITE(tst_notebook_check, NotebookCheckTest)
#include "tst_notebook_check.moc"
