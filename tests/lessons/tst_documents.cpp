// The documents of the steps have the required format, and all languages have the same contents.

#include "lessons/api/text/document.h"
#include "lessons/api/text/recall.h"
#include "tests/lessons/support/documents.h"
#include "tests/lessons/support/translated_text.h"
#include "tests/suite.h"

#include <QDirIterator>
#include <QRegularExpression>
#include <QTest>

#include <algorithm>

using namespace support;
using lessons::Document;

namespace {

/// Returns a description of a run in a few lines.
QStringList linesOf(const lessons::RunSetup &run)
{
    QStringList all{run.step, run.method, run.until, QString::number(run.frames)};
    const auto place = [](sim::Vec2 at) { return QStringLiteral("%1, %2").arg(at.x).arg(at.y); };
    for (const auto &[id, value] : run.values)
        all << id + ": " + value;
    for (const lessons::RunSetup::Place &one : run.places)
        all << one.body + ": " + place(one.at);
    for (const lessons::RunSetup::Drag &one : run.drags)
        all << QStringLiteral("drag %1: %2, %3").arg(one.body, place(one.to)).arg(one.frames);
    if (run.press)
        all << QStringLiteral("press: %1, %2").arg(place(run.press->at)).arg(run.press->frames);
    if (run.click)
        all << "click: " + place(*run.click);
    return all;
}

/// Returns the questions of a lesson in a language. Empty if there are none.
lessons::Recall recallOf(const QString &lesson, const QString &language)
{
    const QString name = language == u"en" ? QStringLiteral("recall") : "recall." + language;
    QFile file(QStringLiteral("%1%2/%3.md").arg(documentFolder, lesson, name));
    if (!file.open(QIODevice::ReadOnly))
        return {};
    return lessons::parseRecall(file.readAll(), file.fileName());
}

/// Returns all texts of the questions of a lesson in order.
std::vector<DocumentPlace> placesIn(const lessons::Recall &recall)
{
    std::vector<DocumentPlace> all = {{"title", recall.title}, {"text", recall.text}};
    for (const lessons::RecallQuestion &question : recall.questions) {
        all.push_back({"question " + question.id, question.text});
        for (const lessons::RecallChoice &choice : question.choices)
            all.insert(all.end(), {{"choice of " + question.id, choice.text},
                                   {"explanation in " + question.id, choice.explanation}});
        if (question.task)
            all.push_back({"answer of " + question.id, question.task->answer});
    }
    return all;
}

/// Returns the ids and scenes of questions.
QStringList headingsOf(const lessons::Recall &recall)
{
    QStringList all;
    for (const lessons::RecallQuestion &question : recall.questions) {
        all << QStringLiteral("%1, %2 choices").arg(question.id).arg(question.choices.size());
        if (question.task)
            all << linesOf(question.task->setup);
    }
    return all;
}

/// Returns the headings of a document, without their titles in the language of the document.
QStringList headingsOf(const Document &document)
{
    QStringList all;
    for (const lessons::TryText &one : document.tries) {
        all << "try " + one.id + (one.hint.isEmpty() ? "" : " hint") +
                   (one.answer.isEmpty() ? "" : " answer");
        all << one.missing.keys();
        if (!one.choices.isEmpty())
            all << QStringLiteral("%1 choices, right: %2")
                       .arg(one.choices.texts.size())
                       .arg(one.choices.right);
    }
    for (const lessons::Prediction &one : document.predictions) {
        all << "prediction " + one.id + ": " + one.question.of << linesOf(one.run);
        for (const lessons::RunSetup &other : one.otherCurves)
            all << linesOf(other);
    }
    for (const lessons::CodeTask &task : document.tasks) {
        all << QStringLiteral("task %1, %2 hints").arg(task.id).arg(task.hints.size());
        for (const lessons::NearMiss &miss : task.nearMisses)
            all << miss.gap + ": " + miss.code;
    }
    all << QStringLiteral("%1 words, of which these are not linked:").arg(document.explanation.terms.size());
    for (std::size_t i = 0; i < document.explanation.terms.size(); ++i) {
        if (document.explanation.terms[i].forms.isEmpty())
            all << QString::number(i);
    }
    for (const lessons::Concept &one : document.explanation.concepts)
        all << "concept " + one.id + " rests on " + one.restsOn.join(' ');
    all << QStringLiteral("%1 whys").arg(document.explanation.whys.size());
    all << (document.explanation.learnt.isEmpty() ? "nothing learnt" : "learnt");
    return all;
}

/// Returns how often each sign of Markdown is in a text.
QList<qsizetype> emphasisOf(const QString &text)
{
    QList<qsizetype> counts;
    for (const char *sign : {"\\*\\*", "(?m)^#+ ", "(?m)^([-*]|\\d+\\.) ", "\n\n", "(?m)^> ", "(?m)^\\|"})
        counts << foundIn(text, sign).size();
    return counts;
}

}

class DocumentsTest : public QObject
{
    Q_OBJECT

private slots:
    void everyStepHasADocumentInEveryLanguage();
    void everyDocumentBelongsToAStep();
    void stepsShowTheirDocuments_data() { addStepRows(); }
    void stepsShowTheirDocuments();
    void languagesHaveTheSameHeadings_data() { addTranslationRows(); }
    void languagesHaveTheSameHeadings();
    void languagesHaveTheSameEmphasis_data() { addTranslationRows(); }
    void languagesHaveTheSameEmphasis();
    void languagesHaveTheSameCodeAndNumbers_data() { addTranslationRows(); }
    void languagesHaveTheSameCodeAndNumbers();
    void numbersHaveACommaInTranslations_data() { addTranslationRows(); }
    void numbersHaveACommaInTranslations();
    void everyLessonHasThreeToFiveQuestions();
    void questionsAreAboutThisLessonOrTheTwoBefore();
    void languagesHaveTheSameQuestions_data();
    void languagesHaveTheSameQuestions();
    void linksHaveTargets_data() { addTranslationRows(); }
    void linksHaveTargets();

private:
    /// Adds one row for each document.
    void addTranslationRows();
    /// Compares each text of the row's document with the English one.
    template <class Same>
    void eachText(Same same);
};

void DocumentsTest::addTranslationRows()
{
    QTest::addColumn<QString>("lesson");
    QTest::addColumn<QString>("id");
    QTest::addColumn<QString>("language");
    const QStringList codes = documentLanguages();
    for (const LoadedLesson &lesson : allLessons()) {
        for (const lessons::Step &step : lesson.steps) {
            for (const QString &code : codes)
                QTest::addRow("%s/%s.%s", qPrintable(step.lesson), qPrintable(step.id), qPrintable(code))
                    << step.lesson << step.id << code;
        }
    }
}

void DocumentsTest::everyStepHasADocumentInEveryLanguage()
{
    QCOMPARE(documentLanguages().size(), 4);
    for (const LoadedLesson &lesson : allLessons()) {
        for (const lessons::Step &step : lesson.steps) {
            for (const QString &code : documentLanguages())
                QVERIFY2(!documentOf(step.lesson, step.id, code).title.isEmpty(),
                         qPrintable(step.lesson + '/' + step.id + ' ' + code));
        }
    }
}

void DocumentsTest::everyDocumentBelongsToAStep()
{
    for (const LoadedLesson &lesson : allLessons()) {
        QStringList ids = {"project", "recall"}; // of the whole lesson
        for (const lessons::Step &step : lesson.steps)
            ids << step.id;
        const QStringList names = QDir(documentFolder + idOf(lesson)).entryList({"*.md"});
        QVERIFY2(names.size() >= 2 * static_cast<qsizetype>(lesson.steps.size()), qPrintable(idOf(lesson)));
        for (const QString &name : names)
            QVERIFY2(ids.contains(name.section('.', 0, 0)), qPrintable(idOf(lesson) + '/' + name));
    }
}

void DocumentsTest::stepsShowTheirDocuments()
{
    QFETCH(QString, lesson);
    const lessons::Step step = stepOfRow();
    const Document document = documentOf(lesson, step.id, "en");
    QCOMPARE(step.title, document.title);
    QCOMPARE(step.narration, document.story);
    QCOMPARE(step.explanation.learnt, document.explanation.learnt);
    QCOMPARE(step.tries.size(), document.tries.size());
    for (std::size_t i = 0; i < step.tries.size(); ++i) {
        QCOMPARE(step.tries[i].id, document.tries[i].id);
        QCOMPARE(step.tries[i].text, document.tries[i].text);
        QVERIFY2(!step.tries[i].conditions.all().empty(), qPrintable(step.tries[i].id));
    }
    QCOMPARE(step.codeTasks.size(), document.tasks.size());
}

void DocumentsTest::languagesHaveTheSameHeadings()
{
    QFETCH(QString, lesson);
    QFETCH(QString, id);
    QFETCH(QString, language);
    QCOMPARE(headingsOf(documentOf(lesson, id, language)), headingsOf(documentOf(lesson, id, "en")));
}

template <class Same>
void DocumentsTest::eachText(Same same)
{
    QFETCH(QString, lesson);
    QFETCH(QString, id);
    QFETCH(QString, language);
    const std::vector<DocumentPlace> english = placesIn(documentOf(lesson, id, "en"));
    const std::vector<DocumentPlace> other = placesIn(documentOf(lesson, id, language));
    QCOMPARE(other.size(), english.size());
    QStringList wrong;
    for (std::size_t i = 0; i < english.size(); ++i) {
        if (!same(english[i].text, other[i].text))
            wrong << other[i].where + ": " + english[i].text + "\n  -> " + other[i].text;
    }
    QVERIFY2(wrong.isEmpty(), qPrintable('\n' + wrong.join('\n')));
}

void DocumentsTest::languagesHaveTheSameEmphasis()
{
    eachText([](const QString &english, const QString &other) {
        return emphasisOf(english) == emphasisOf(other);
    });
}

void DocumentsTest::languagesHaveTheSameCodeAndNumbers()
{
    eachText([](const QString &english, const QString &other) {
        return codeIn(english) == codeIn(other) && foundIn(english, "%\\d") == foundIn(other, "%\\d");
    });
}

void DocumentsTest::numbersHaveACommaInTranslations()
{
    QFETCH(QString, lesson);
    QFETCH(QString, id);
    QFETCH(QString, language);
    if (language == "en")
        return;
    for (const DocumentPlace &place : placesIn(documentOf(lesson, id, language))) {
        QVERIFY2(hasDecimalCommas(place.text), qPrintable(place.where + ": " + place.text));
    }
}

void DocumentsTest::everyLessonHasThreeToFiveQuestions()
{
    for (const LoadedLesson &lesson : allLessons()) {
        const bool isSandbox = lesson.steps.front().points == lessons::PointSource::scene;
        const std::size_t count = recallOf(idOf(lesson), "en").questions.size();
        QVERIFY2(isSandbox ? count == 0 : count >= 3 && count <= 5, qPrintable(idOf(lesson)));
    }
}

void DocumentsTest::questionsAreAboutThisLessonOrTheTwoBefore()
{
    QStringList ids;
    for (const LoadedLesson &lesson : allLessons()) {
        ids << idOf(lesson);
        const QStringList last = ids.mid(std::max(qsizetype{0}, ids.size() - 3));
        for (const lessons::RecallQuestion &question : recallOf(idOf(lesson), "en").questions) {
            if (!question.task)
                continue;
            const QString step = question.task->setup.step;
            QVERIFY2(last.contains(step.section('/', 0, 0)), qPrintable(idOf(lesson) + ": " + step));
        }
    }
}

void DocumentsTest::languagesHaveTheSameQuestions_data()
{
    QTest::addColumn<QString>("lesson");
    QTest::addColumn<QString>("language");
    for (const LoadedLesson &lesson : allLessons()) {
        if (recallOf(idOf(lesson), "en").questions.empty())
            continue;
        for (const QString &code : documentLanguages())
            QTest::addRow("%s.%s", qPrintable(idOf(lesson)), qPrintable(code)) << idOf(lesson) << code;
    }
}

void DocumentsTest::languagesHaveTheSameQuestions()
{
    QFETCH(QString, lesson);
    QFETCH(QString, language);
    const lessons::Recall english = recallOf(lesson, "en"), other = recallOf(lesson, language);
    QCOMPARE(headingsOf(other), headingsOf(english));
    const std::vector<DocumentPlace> source = placesIn(english), told = placesIn(other);
    for (std::size_t i = 0; i < source.size(); ++i) {
        QVERIFY2(emphasisOf(told[i].text) == emphasisOf(source[i].text), qPrintable(told[i].where));
        QVERIFY2(codeIn(told[i].text) == codeIn(source[i].text), qPrintable(told[i].where));
        QCOMPARE(told[i].text.isEmpty(), source[i].text.isEmpty());
    }
}

void DocumentsTest::linksHaveTargets()
{
    static const QRegularExpression link("\\[[^\\]]*\\]\\(([^)]*)\\)");
    QFETCH(QString, lesson);
    QFETCH(QString, id);
    QFETCH(QString, language);
    QStringList found;
    for (const DocumentPlace &place : placesIn(documentOf(lesson, id, language))) {
        for (auto at = link.globalMatch(place.text); at.hasNext();)
            found << QUrl::fromPercentEncoding(at.next().captured(1).toUtf8());
    }
    if (found.isEmpty())
        return;
    QStringList targets;
    for (const LoadedLesson &other : allLessons()) {
        for (const lessons::Step &step : other.steps) {
            targets << QStringLiteral("step:%1/%2").arg(step.lesson, step.id);
            for (const lessons::Term &term : documentOf(step.lesson, step.id, language).explanation.terms)
                targets << "word:" + term.name;
        }
    }
    for (const QString &target : found)
        QVERIFY2(targets.contains(target), qPrintable(target));
}

SUITE(tst_documents, DocumentsTest)
#include "tst_documents.moc"
