// Notebooks as files: bad ones are named in one sentence, and pages escape what learners write.

#include "tests/app/notebook/notebook_maker.h"

#include "app/model/experiment/experiment_line.h"
#include "app/model/files/whole_file.h"
#include "app/model/notebook/notebook_file.h"
#include "app/model/notebook/notebook_page.h"
#include "tests/suite.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>

using namespace app;
using namespace tests;

namespace {

/// A notebook with one try and its run, one prediction, one task, two choices, an answer in a scene, and one scene.
Notebook shortNotebook()
{
    const QString lesson = QStringLiteral("single_spring");
    const LessonEntry &entry = *allLessons().lesson(lesson);
    Experiment dragged = newExperiment(lesson, "drag", allLessons());
    dragged.script.input.push_back({1, sim::Grab{"foot"}});
    for (int frame = 2; frame < 40; ++frame) // enough that a line is compressed
        dragged.script.input.push_back({frame, sim::Move{{300.0 + frame, 200.0}}});
    const QByteArray run = textInLine(experimentLine(dragged, allLessons()));
    const QDateTime when({2026, 1, 31}, {12, 0}, Qt::UTC);
    Notebook book{.name = "Ada", .when = when};
    book.entries.push_back({.kind = NotebookEntry::Kind::tried,
                            .lesson = lesson,
                            .step = "drag",
                            .id = entry.step("drag")->tries.front().id,
                            .when = when,
                            .run = {run, {12, 0}}});
    book.entries.push_back({.kind = NotebookEntry::Kind::prediction,
                            .lesson = lesson,
                            .step = "fixed_centre",
                            .id = "other_side",
                            .when = when,
                            .said = "1.0, 2.0",
                            .found = "3.0, 4.0"});
    book.entries.push_back({.kind = NotebookEntry::Kind::code,
                            .lesson = lesson,
                            .step = "fixed_centre",
                            .id = "pull",
                            .when = when,
                            .code = "// a < b && \"c\" <script>\nvoid frame()\n{\n}\n"});
    book.entries.push_back({.kind = NotebookEntry::Kind::answer,
                            .lesson = lesson,
                            .step = "offset",
                            .id = "from_left",
                            .when = when,
                            .said = "3",
                            .isRight = false});
    book.entries.push_back({.kind = NotebookEntry::Kind::answer,
                            .lesson = lesson,
                            .id = "share_kept",
                            .when = when,
                            .said = "2",
                            .isRight = true});
    book.entries.push_back({.kind = NotebookEntry::Kind::answer,
                            .lesson = lesson,
                            .id = "left_of_body",
                            .when = when,
                            .run = {run, {7, 1}}});
    book.entries.push_back({.kind = NotebookEntry::Kind::scene,
                            .lesson = lesson,
                            .id = "<b>Walker</b> & co",
                            .when = when,
                            .run = {run, {}}});
    return book;
}

QByteArray shortText()
{
    return notebookText(shortNotebook());
}

/// A line that expands to far more than it has.
QString bombLine()
{
    constexpr int lengthBytes = 4; // length prefix that Qt writes before the zlib data
    const QByteArray data = qCompress(QByteArray(8 << 20, ' '), 9).mid(lengthBytes);
    return "springstep:" + data.toBase64(QByteArray::Base64UrlEncoding);
}

}

class NotebookFileTest : public QObject
{
    Q_OBJECT

private slots:
    void aWrittenNotebookIsReadBack();
    void aNotebookWithoutANameNamesNobody();
    void anotherLayoutKeepsTheSeal();
    void aBadFileIsOneSentence_data();
    void aBadFileIsOneSentence();
    void aPathThatIsNoNotebookIsNamed();
    void thePageEscapesWhatLearnersWrite();
    void thePageHasTheAnswers_data();
    void thePageHasTheAnswers();
    void markdownBecomesHtml_data();
    void markdownBecomesHtml();
    void thePdfHasPages();
};

void NotebookFileTest::aWrittenNotebookIsReadBack()
{
    const Notebook book = shortNotebook();
    const Notebook read = parseNotebook(shortText(), "a", allLessons());
    QCOMPARE(read.entries, book.entries);
    QCOMPARE(read.name, book.name);
    QCOMPARE(read.when, book.when);
    QVERIFY(read.isSealed);
}

void NotebookFileTest::aNotebookWithoutANameNamesNobody()
{
    Notebook book = shortNotebook();
    book.name.clear();
    QVERIFY(!notebookText(book).contains("\"name\""));
    QVERIFY(parseNotebook(notebookText(book), "a", allLessons()).isSealed);
}

void NotebookFileTest::anotherLayoutKeepsTheSeal()
{
    const QByteArray text = shortText();
    QVERIFY(parseNotebook(QByteArray(text).replace("\n", "\r\n"), "a", allLessons()).isSealed);
    QVERIFY(parseNotebook("\xEF\xBB\xBF" + text, "a", allLessons()).isSealed);
    QVERIFY(!parseNotebook(QByteArray(text).replace("Ada", "Eve"), "a", allLessons()).isSealed);
}

void NotebookFileTest::aBadFileIsOneSentence_data()
{
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QString>("piece");
    const QByteArray good = shortText();
    const auto row = [](const char *name, const QByteArray &text, const char *piece) {
        QTest::newRow(name) << text << QString(piece);
    };
    const auto changed = [&](const char *name, const char *from, const QByteArray &to, const char *piece) {
        const QByteArray text = QByteArray(good).replace(from, to);
        QTest::newRow(name) << text << QString(text == good ? "the row changes nothing" : piece);
    };
    row("empty", {}, "a:");
    row("cut in half", good.left(good.size() / 2), "line ");
    row("without its end", good.chopped(3), "line ");
    row("another text", "Dear teacher,\n", "line 1");
    row("UTF-16", QByteArray::fromHex("fffe7b000a00"), "UTF-8");
    row("Latin-1", QByteArray(good).replace("Ada", "Ad\xe4"), "UTF-8");
    row("an experiment", experimentText(newExperiment("single_spring", "drag", allLessons()), allLessons()),
        "this is not a notebook");
    changed("another version", "notebook/1", "notebook/2", "reads \"springstep-notebook/1\"");
    changed("an unknown lesson", "\"single_spring\"", "\"singing\"", "there is no lesson \"singing\"");
    changed("an unknown step", "\"drag\"", "\"drop\"", "no step \"drop\"");
    changed("an unknown task", "\"pull\"", "\"push\"", "there is no code called \"push\"");
    changed("an unknown kind", "\"prediction\"", "\"guess\"", "\"kind\" is \"guess\"");
    changed("an unknown field", "\"said\"", "\"told\"", "\"said\"");
    changed("a recall question that is not there", "\"share_kept\"", "\"share_lost\"",
            "there is no answer called \"share_lost\" in \"single_spring\"");
    changed("a thing to try without choices", "\"from_left\"", "\"negative\"",
            "there is no answer called \"negative\" in \"single_spring/offset\"");
    changed("an unknown step of an answer", "\"offset\"", "\"onset\"", "no step \"onset\"");
    changed("a choice without its number", "\"said\": \"2\",", "", "\"said\"");
    changed("a choice that is a number", "\"said\": \"2\"", "\"said\": 2", "\"said\"");
    changed("a choice without a verdict", ",\n   \"right\": true", "", "\"right\"");
    changed("a choice with a run", "\"said\": \"2\"", "\"said\": \"2\", \"run\": \"{}\"", "\"run\"");
    changed("an answer in a scene with a choice", "\"frame\": 7", "\"frame\": 7, \"said\": \"1\"",
            "\"said\"");
    changed("a time that is none", "2026-01-31T12:00:00Z", "noon", "is not a time");
    changed("a frame below 0", "\"frame\": 12", "\"frame\": -1", "\"frame\" is -1");
    changed("a damaged run", "springstep:", "springstep:AAAA", "is damaged");
    changed("entries that are no list", "\"entries\": [", "\"entries\": 1, \"x\": [", "line ");
    row("a long name", QByteArray(good).replace("Ada", QByteArray(101, 'a')), "\"name\" has 101 letters");
    const QString packed = lineOf(shortNotebook().entries.front().run.text);
    row("a bomb", QString(good).replace(packed, bombLine()).toUtf8(), "larger than 4 MiB");
    const QString entries = QString(good).section("\"entries\": [", 1).section("]", 0, 0);
    row("an entry twice", QString(good).replace(entries, entries + ',' + entries).toUtf8(), "is there twice");
}

void NotebookFileTest::aBadFileIsOneSentence()
{
    QFETCH(QByteArray, text);
    QFETCH(QString, piece);
    try {
        parseNotebook(text, "a", allLessons());
    } catch (const UserError &error) {
        const QString sentence = error.sentence();
        QVERIFY2(sentence.contains(piece), qPrintable(sentence));
        QVERIFY2(sentence.startsWith("a: ") && sentence.endsWith('.') && !sentence.contains('\n'),
                 qPrintable(sentence));
        return;
    }
    QFAIL("it was read");
}

void NotebookFileTest::aPathThatIsNoNotebookIsNamed()
{
    const QTemporaryDir folder;
    QVERIFY_THROWS_EXCEPTION(UserError, readNotebook(folder.path(), allLessons()));
    QVERIFY_THROWS_EXCEPTION(UserError, readNotebook(folder.filePath("none"), allLessons()));
    QFile large(folder.filePath("large"));
    QVERIFY(large.open(QIODevice::WriteOnly));
    QVERIFY(large.resize(largestNotebook + 1)); // a sparse file takes no space
    large.close();
    QVERIFY_THROWS_EXCEPTION(UserError, readNotebook(large.fileName(), allLessons()));
    QVERIFY_THROWS_EXCEPTION(UserError, writeWholeFile(folder.filePath("none/a"), "a"));
}

void NotebookFileTest::thePageEscapesWhatLearnersWrite()
{
    Notebook book = shortNotebook();
    book.name = "<script>alert(1)</script>";
    QImage picture(2, 2, QImage::Format_RGB32);
    picture.fill(Qt::white);
    const QString page = notebookHtml(book, allLessons(), [&](const NotebookEntry &) { return picture; });
    QVERIFY(page.startsWith("<!DOCTYPE html>"));
    QVERIFY(!page.contains("<script"));
    QVERIFY(page.contains("Notebook of &lt;script&gt;alert(1)&lt;/script&gt;"));
    QVERIFY(page.contains("// a &lt; b &amp;&amp; &quot;c&quot; &lt;script&gt;"));
    QVERIFY(page.contains("&lt;b&gt;Walker&lt;/b&gt; &amp; co"));
    QCOMPARE(page.count("src=\"data:image/png;base64,"), 3); // the try, the answer and the scene
    QVERIFY(!page.contains("http"));
    QVERIFY(!page.contains("**"));
}

void NotebookFileTest::thePageHasTheAnswers_data()
{
    using Entries = std::vector<NotebookEntry>;
    const QString lesson = "single_spring", step = "fixed_centre", guess = "no_damping";
    const auto answer = [&](const QString &in, const QString &id, const QString &said) {
        return NotebookEntry{
            .kind = NotebookEntry::Kind::answer, .lesson = lesson, .step = in, .id = id, .said = said};
    };
    const NotebookEntry tried{.lesson = lesson, .step = step, .id = guess};
    QTest::addColumn<Entries>("entries");
    QTest::addColumn<QStringList>("paragraphs");
    const LessonEntry &entry = *allLessons().lesson(lesson);
    const lessons::RecallQuestion &recall = entry.recall.questions[1];
    QCOMPARE(recall.id, QString("share_kept"));
    const lessons::RecallQuestion &task = entry.recall.questions.back();
    const auto wide = std::find_if(entry.step(step)->tries.begin(), entry.step(step)->tries.end(),
                                   [&](const lessons::Try &one) { return one.id == guess; });
    const QStringList &expected = wide->choices.texts;
    QTest::newRow("right") << Entries{answer({}, recall.id, "1")}
                           << QStringList{recall.text, "✓ " + recall.choices[0].text,
                                          recall.choices[0].explanation};
    QTest::newRow("wrong") << Entries{answer({}, recall.id, "2")}
                           << QStringList{recall.text, "→ " + recall.choices[1].text,
                                          recall.choices[1].explanation};
    QTest::newRow("unreadable") << Entries{answer({}, recall.id, "<b>")} << QStringList{recall.text};
    QTest::newRow("in a scene") << Entries{answer({}, task.id, {})}
                                << QStringList{"✓ " + task.text, task.task->answer};
    QTest::newRow("a guess before it is tried")
        << Entries{answer(step, guess, "1")} << QStringList{wide->text, expected[0]};
    QTest::newRow("a wrong guess") << Entries{tried, answer(step, guess, "1")}
                                   << QStringList{"✓ " + wide->text, wide->text, "→ " + expected[0],
                                                  wide->answer};
    QTest::newRow("a right guess") << Entries{tried, answer(step, guess, "2")}
                                   << QStringList{"✓ " + wide->text, wide->text, "✓ " + expected[1],
                                                  wide->answer};
}

void NotebookFileTest::thePageHasTheAnswers()
{
    QFETCH(std::vector<NotebookEntry>, entries);
    QFETCH(QStringList, paragraphs);
    const Notebook book{.when = QDateTime({2026, 1, 31}, {12, 0}, Qt::UTC), .entries = entries};
    const QString page = notebookHtml(book, allLessons(), {}), body = page.section("<h3>", 1);
    const QString heading = entries[0].step.isEmpty() ? "What do you remember?" : "A fixed centre";
    QVERIFY2(body.startsWith(heading), qPrintable(body));
    QStringList shown;
    for (const QString &part : body.split("<p>").mid(1))
        shown << part.section("</p>", 0, 0);
    for (QString &one : paragraphs)
        one = htmlOf(one);
    QCOMPARE(shown, paragraphs);
}

void NotebookFileTest::markdownBecomesHtml_data()
{
    QTest::addColumn<QString>("markdown");
    QTest::addColumn<QString>("html");
    QTest::newRow("bold") << "Press **Space** twice."
                          << "Press <b>Space</b> twice.";
    QTest::newRow("code") << "Change `a * b < c`."
                          << "Change <code>a * b &lt; c</code>.";
    QTest::newRow("code with stars") << "`a**b` and `c**d`"
                                     << "<code>a**b</code> and <code>c**d</code>";
    QTest::newRow("signs") << "1 < 2 & \"3\""
                           << "1 &lt; 2 &amp; &quot;3&quot;";
}

void NotebookFileTest::markdownBecomesHtml()
{
    QFETCH(QString, markdown);
    QFETCH(QString, html);
    QCOMPARE(htmlOf(markdown), html);
}

void NotebookFileTest::thePdfHasPages()
{
    const QByteArray pdf = notebookPdf(shortNotebook(), allLessons(), {});
    QVERIFY(pdf.startsWith("%PDF-"));
    QVERIFY(pdf.contains("/Type /Page"));
    QVERIFY(pdf.trimmed().endsWith("%%EOF"));
}

SUITE(tst_notebook_file, NotebookFileTest)
#include "tst_notebook_file.moc"
