#include "app/cli/terminal.h"
#include "app/cli/verbs.h"
#include "app/model/learning/concept_map.h"
#include "app/model/lesson_folders/lesson_check.h"
#include "app/model/lesson_folders/lesson_languages.h"
#include "app/model/text/json_writer.h"
#include "lessons/api/text/document.h"

#include <QCoreApplication>

#include <algorithm>

namespace app {

namespace {

struct CheckText
{
    Q_DECLARE_TR_FUNCTIONS(CheckText)
};

/// Returns the document that a finding is about: "swing", "recall", "project".
QString placeOf(const LessonFinding &one)
{
    if (one.kind == LessonFinding::Kind::question)
        return QStringLiteral("recall");
    return one.kind == LessonFinding::Kind::level ? QStringLiteral("project") : one.step;
}

bool isGood(const std::vector<LessonFinding> &findings)
{
    return std::all_of(findings.begin(), findings.end(), [](const LessonFinding &one) { return one.isGood; });
}

QString tableOf(const LessonEntry &lesson, const QStringList &languages,
                const std::vector<LessonFinding> &findings)
{
    qsizetype places = 0, ids = 0;
    for (const LessonFinding &one : findings) {
        places = std::max(places, placeOf(one).size());
        ids = std::max(ids, one.id.size());
    }
    constexpr int kinds = 10; // letters of "prediction"
    QString text = CheckText::tr("%1: %2 (steps: %3; languages besides the first: %4)\n")
                       .arg(lesson.id, lesson.title, QString::number(lesson.steps.size()),
                            languages.isEmpty() ? CheckText::tr("none") : languages.join(", "));
    for (const LessonFinding &one : findings)
        text += (one.isGood ? QStringLiteral("  ok    ") : QStringLiteral("  FAIL  ")) +
                placeOf(one).leftJustified(places) + "  " + wordFor(one.kind).leftJustified(kinds) + "  " +
                one.id.leftJustified(ids) + "  " + one.sentence + '\n';
    return text;
}

QString jsonOf(const LessonEntry &lesson, const QStringList &languages,
               const std::vector<LessonFinding> &findings)
{
    JsonWriter json(1);
    json.beginObject();
    json.field("id", lesson.id);
    json.field("title", lesson.title);
    json.field("good", isGood(findings));
    json.list("languages", languages, JsonWriter::Layout::oneLine);
    json.beginList("checked");
    for (const LessonFinding &one : findings) {
        json.beginObject(JsonWriter::Layout::oneLine);
        json.field("place", placeOf(one));
        json.field("kind", wordFor(one.kind));
        json.field("id", one.id);
        json.field("good", one.isGood);
        json.field("found", one.sentence);
        json.endObject();
    }
    json.endList();
    json.endObject();
    return QString::fromUtf8(json.text()) + '\n';
}

/// Checks what the concepts of `lesson` rest on, which reading it alone cannot.
void checkConceptsOf(const LessonEntry &lesson, LessonLibrary library)
{
    library.yours.push_back(lesson);
    try {
        checkConcepts(library);
    } catch (const lessons::DocumentError &error) {
        throw UserError(QString::fromUtf8(error.what()));
    }
}

}

int runCheck(const Arguments &arguments)
{
    const LessonLibrary library = LessonLibrary::load(LessonLibrary::folders());
    const LessonFiles files = readLessonFiles(arguments.names[0]);
    const LessonEntry lesson = lessonOf(files, QStringLiteral("en"), library);
    const QStringList languages = languagesOf(files);
    checkConceptsOf(lesson, library);
    for (const QString &language : languages)
        checkSameQuestions(lesson, lessonOf(files, language, library));
    listenForInterrupt();
    const std::vector<LessonFinding> findings =
        checkLesson(files, lesson, library, [] { return !isInterrupted(); });
    if (isInterrupted())
        return exitInterrupted;
    print(arguments.has("json") ? jsonOf(lesson, languages, findings) : tableOf(lesson, languages, findings));
    return isGood(findings) ? exitDone : exitNo;
}

}
