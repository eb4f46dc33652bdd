#include "app/model/notebook/notebook_file.h"

#include "app/model/catalog/lists.h"
#include "app/model/experiment/experiment_line.h"
#include "app/model/experiment/json_fields.h"
#include "app/model/files/whole_file.h"
#include "app/model/notebook/notebook_question.h"
#include "app/model/text/json_writer.h"
#include "app/model/text/quoting.h"

#include <QCoreApplication>
#include <QCryptographicHash>
#include <QFileInfo>
#include <QSet>

namespace app {

namespace {

using Kind = NotebookEntry::Kind;

constexpr auto notebookFormat = "springstep-notebook/1";
constexpr Kind allKinds[] = {Kind::tried,      Kind::code,   Kind::level,
                             Kind::prediction, Kind::answer, Kind::scene};

/// How runs are written: in one compressed line for a file, and as they are for the seal, because compression may differ
/// between machines.
enum class RunText { packed, plain };

QString runText(const QByteArray &text, RunText form)
{
    return form == RunText::packed ? lineOf(text) : QString::fromUtf8(text);
}

void writeRunOf(const NotebookRun &run, RunText form, JsonWriter &json)
{
    if (run.text.isEmpty())
        return;
    json.field("run", runText(run.text, form));
    json.field("frame", run.at.frame);
    if (run.at.phase != 0)
        json.field("phase", run.at.phase);
    if (run.beside.isEmpty())
        return;
    json.field("beside", runText(run.beside, form));
    json.field("fork", run.fork);
}

void writeEntry(const NotebookEntry &entry, RunText form, JsonWriter &json)
{
    json.beginObject();
    json.field("kind", wordFor(entry.kind));
    json.field("lesson", entry.lesson);
    if (!entry.step.isEmpty())
        json.field("step", entry.step);
    json.field("id", entry.id);
    if (entry.when.isValid())
        json.field("when", entry.when.toString(Qt::ISODate));
    const bool isSaid = entry.kind == Kind::prediction || !entry.said.isEmpty();
    if (isSaid)
        json.field("said", entry.said);
    if (entry.kind == Kind::prediction)
        json.field("found", entry.found);
    if (isSaid)
        json.field("right", entry.isRight);
    if (!entry.code.isEmpty())
        json.field("code", entry.code);
    writeRunOf(entry.run, form, json);
    json.endObject();
}

QByteArray contentOf(const Notebook &notebook, RunText form, const QString &seal)
{
    JsonWriter json(1);
    json.beginObject();
    json.field("format", notebookFormat);
    json.field("seal", seal);
    if (!notebook.name.isEmpty())
        json.field("name", notebook.name);
    json.field("when", notebook.when.toString(Qt::ISODate));
    json.beginList("entries");
    for (const NotebookEntry &entry : notebook.entries)
        writeEntry(entry, form, json);
    json.endList();
    json.endObject();
    return json.text() + '\n';
}

/// Returns the seal of a notebook: the SHA-256 of what it says, however it is laid out and compressed.
QString sealOf(const Notebook &notebook)
{
    return QString::fromLatin1(
        QCryptographicHash::hash(contentOf(notebook, RunText::plain, {}), QCryptographicHash::Sha256)
            .toHex());
}

/// A reader of a notebook file.
class NotebookReader
{
    Q_DECLARE_TR_FUNCTIONS(NotebookFileText)

public:
    NotebookReader(const QString &file, const JsonValue &root, const LessonLibrary &library)
        : m_file(file), m_fields(file, root, tr("the file")), m_library(library)
    {
    }

    Notebook read()
    {
        const QString format = m_fields.text("format", quoted(notebookFormat));
        if (format != notebookFormat)
            m_fields.refuse("format",
                            tr("this is not a notebook: its \"format\" is %1, and this program reads %2.")
                                .arg(quoted(format), quoted(notebookFormat)));
        m_fields.refuseOthers({"format", "seal", "name", "when", "entries"});
        const QString seal = m_fields.text("seal", tr("the seal of the file"));
        Notebook notebook{.name = m_fields.optionalText("name"), .when = time(m_fields, "when")};
        if (notebook.name.size() > Notebook::longestName)
            m_fields.refuse("name", tr("\"name\" has %1 letters; it can have up to %2.")
                                        .arg(notebook.name.size())
                                        .arg(Notebook::longestName));
        const JsonValue &list = m_fields.require("entries", tr("a list of what was done"));
        const JsonValue::List &entries = listOf(m_file, list, "entries");
        if (entries.size() > Notebook::mostEntries)
            refuse(m_file, list.line,
                   tr("\"entries\" has %1 entries; it can have up to %2.")
                       .arg(entries.size())
                       .arg(Notebook::mostEntries));
        for (const JsonValue &entry : entries)
            notebook.entries.push_back(readEntry(entry));
        notebook.isSealed = seal == sealOf(notebook);
        return notebook;
    }

private:
    QDateTime time(const JsonFields &fields, const QString &name) const
    {
        const JsonValue *value = fields.find(name);
        if (!value)
            return {};
        const QDateTime time = QDateTime::fromString(textOf(m_file, *value, name), Qt::ISODate);
        if (!time.isValid())
            refuse(m_file, value->line,
                   tr("\"%1\" is not a time; write it as 2026-01-31T12:00:00Z.").arg(name));
        return time;
    }

    NotebookEntry readEntry(const JsonValue &value)
    {
        const JsonFields fields(m_file, value, tr("an entry"));
        NotebookEntry entry{.kind = readKind(fields)};
        entry.lesson = fields.text("lesson", lessonIds(m_library));
        entry.id = fields.text("id", tr("the id of what was done"));
        entry.when = time(fields, "when");
        const bool isOfStep = entry.kind == Kind::answer
                                  ? fields.find("step") != nullptr
                                  : entry.kind != Kind::level && entry.kind != Kind::scene;
        QStringList known = {"kind", "lesson", "id", "when"};
        if (isOfStep) {
            entry.step = fields.text("step", tr("the id of a step"));
            known << "step";
        }
        checkNames(fields, entry);
        const bool isChosen = isChoice(entry);
        if (entry.kind == Kind::prediction || isChosen) {
            entry.said = fields.text("said", tr("the answer"));
            entry.isRight = fields.boolean("right");
            known << QStringList{"said", "right"};
        }
        if (entry.kind == Kind::prediction) {
            entry.found = fields.text("found", tr("what the run showed"));
            known << "found";
        } else if (entry.kind == Kind::code) {
            entry.code = fields.optionalText("code");
            known << "code";
        } else if (!isChosen) {
            entry.run = readRunOf(fields, entry.id);
            known << QStringList{"run", "frame", "phase", "beside", "fork"};
        }
        fields.refuseOthers(known);
        return entry;
    }

    /// Returns whether the entry answers a question with choices.
    bool isChoice(const NotebookEntry &entry) const
    {
        return entry.kind == Kind::answer &&
               !notebookQuestion(*m_library.lesson(entry.lesson), entry.step, entry.id)->task;
    }

    Kind readKind(const JsonFields &fields) const
    {
        QStringList words;
        for (const Kind kind : allKinds)
            words << wordFor(kind);
        const QString word = fields.text("kind", quotedList(words));
        const qsizetype index = words.indexOf(word);
        if (index < 0)
            fields.refuse("kind",
                          tr("\"kind\" is %1; it can be %2.").arg(quoted(word), quotedList(words, word)));
        return allKinds[index];
    }

    QByteArray packed(const JsonFields &fields, const QString &name, const QString &id)
    {
        const JsonValue *value = fields.find(name);
        if (!value)
            return {};
        try {
            const QByteArray run = textInLine(textOf(m_file, *value, name), largestNotebookRun);
            m_runBytes += run.size();
            if (m_runBytes > largestNotebookRuns)
                throw UserError({});
            return run;
        } catch (const UserError &) {
            if (m_runBytes > largestNotebookRuns)
                refuse(m_file, value->line,
                       tr("the runs are larger than %1 MiB together, the maximum for a notebook.")
                           .arg(largestNotebookRuns >> 20));
            refuse(m_file, value->line,
                   tr("the run of %1 is damaged, or larger than %2 MiB; ask for the notebook again.")
                       .arg(quoted(id))
                       .arg(largestNotebookRun >> 20));
        }
    }

    NotebookRun readRunOf(const JsonFields &fields, const QString &id)
    {
        NotebookRun run{.text = packed(fields, "run", id)};
        constexpr int mostPhases = 1'000'000;
        run.at = {fields.integer("frame", 0, mostFrames, 0),
                  static_cast<int>(fields.integer("phase", 0, mostPhases, 0))};
        run.beside = packed(fields, "beside", id);
        run.fork = fields.integer("fork", 0, mostFrames, 0);
        return run;
    }

    bool isKnown(const LessonEntry &lesson, const lessons::Step *step, const NotebookEntry &entry) const
    {
        switch (entry.kind) {
        case Kind::tried:
            return findById(step->tries, entry.id);
        case Kind::code:
            return findById(step->codeTasks, entry.id);
        case Kind::prediction:
            return findById(step->predictions, entry.id);
        case Kind::answer:
            return notebookQuestion(lesson, entry.step, entry.id).has_value();
        case Kind::level:
            return lesson.project && findById(lesson.project->levels, entry.id);
        case Kind::scene:
            break;
        }
        return true;
    }

    void checkNames(const JsonFields &fields, const NotebookEntry &entry)
    {
        const LessonEntry *lesson = m_library.lesson(entry.lesson);
        if (!lesson)
            fields.refuse(
                "lesson",
                noLesson(entry.lesson, m_library) + ' ' +
                    tr("If it is a lesson without C++, name its folder or its zip beside the notebook."));
        const lessons::Step *step = entry.step.isEmpty() ? nullptr : lesson->step(entry.step);
        if (fields.find("step") && !step)
            fields.refuse("step", noStep(entry.step, *lesson));
        if (!isKnown(*lesson, step, entry))
            fields.refuse(
                "id",
                tr("there is no %1 called %2 in %3; the notebook may be from another version of the lesson.")
                    .arg(wordFor(entry.kind), quoted(entry.id),
                         quoted(step ? entry.lesson + '/' + entry.step : entry.lesson)));
        const QString key = wordFor(entry.kind) + '/' + entry.lesson + '/' + entry.step + '/' + entry.id;
        if (entry.kind != Kind::scene && m_seen.contains(key))
            refuse(m_file, fields.line(),
                   tr("%1 is there twice; ask for the notebook again.").arg(quoted(entry.id)));
        m_seen.insert(key);
    }

    QString m_file;
    JsonFields m_fields;
    const LessonLibrary &m_library;
    QSet<QString> m_seen; ///< of entries
    qint64 m_runBytes = 0;
};

}

Notebook parseNotebook(const QByteArray &text, const QString &name, const LessonLibrary &library)
{
    if (text.contains('\0'))
        throw UserError(
            NotebookReader::tr("%1: this is not a notebook; a notebook is text in UTF-8.").arg(name));
    const JsonValue root = parseJson(text, name);
    return NotebookReader(name, root, library).read();
}

Notebook readNotebook(const QString &path, const LessonLibrary &library)
{
    return parseNotebook(readWholeFile(path, largestNotebook), shownPath(QFileInfo(path).fileName()),
                         library);
}

QByteArray notebookText(const Notebook &notebook)
{
    const QByteArray text = contentOf(notebook, RunText::packed, sealOf(notebook));
    if (notebook.entries.size() > Notebook::mostEntries || text.size() > largestNotebook)
        throw UserError(
            NotebookReader::tr("The notebook would be too large. Choose fewer lessons, or leave out "
                               "the gallery."));
    return text;
}

}
