#include "lessons/api/text/document.h"

#include "lessons/api/text/document_scan.h"
#include "lessons/api/text/document_source.h"
#include "lessons/api/text/formula_reader.h"
#include "lessons/api/text/parameter_text.h"
#include "lessons/api/text/predict_reader.h"
#include "lessons/api/text/run_setup.h"

#include <QCoreApplication>
#include <QFile>
#include <QRegularExpression>
#include <QSet>

#include <algorithm>

namespace lessons {

namespace {

struct DocumentText
{
    Q_DECLARE_TR_FUNCTIONS(Document)
};

constexpr int hintsOfTask = 3;

/// Interprets the sections of a document. Errors name the file.
class DocumentReader
{
public:
    DocumentReader(const ScannedDocument &scanned, const QString &file) : m_scanned(scanned)
    {
        m_document.file = file;
    }

    Document read()
    {
        m_document.title = m_scanned.title.heading;
        m_document.story = joinedText(m_scanned.title.body);
        if (m_document.story.isEmpty())
            reject(m_scanned.title.line, DocumentText::tr("the story is missing. Write it below the title."));
        for (const DocumentSection &section : m_scanned.sections)
            readSection(section);
        return std::move(m_document);
    }

private:
    /// The parts of a heading "KIND: NAME {#ID}".
    struct Heading
    {
        QString kind, name, id;
    };

    [[noreturn]] void reject(int line, const QString &why) const
    {
        throw DocumentError(m_document.file, line, why);
    }

    static QString shown(const DocumentPart &part, const QString &signs)
    {
        return QStringLiteral("“%1 %2”").arg(signs, part.heading);
    }

    static Heading parsedHeading(const QString &heading)
    {
        static const QRegularExpression pattern(
            QStringLiteral("^(\\w+)\\s*(?::\\s*(.*?))?\\s*(?:\\{#([a-z0-9_]+)\\}|\\{#.*\\})?$"));
        const auto match = pattern.match(heading);
        return {match.captured(1), match.captured(2), match.captured(3)};
    }

    void readSection(const DocumentSection &section)
    {
        const Heading heading = parsedHeading(section.part.heading);
        if (heading.kind == u"Try")
            readTry(section, heading);
        else if (heading.kind == u"Predict")
            readPredict(section, heading);
        else if (heading.kind == u"Task")
            readTask(section, heading);
        else if (heading.kind == u"Parameter")
            readParameter(section, heading);
        else if (heading.kind == u"Word")
            readWord(section, heading);
        else if (heading.kind == u"Concept")
            readConcept(section, heading);
        else if (heading.kind == u"Why")
            readWhy(section, heading);
        else if (heading.kind == u"Learnt")
            readLearnt(section);
        else
            reject(section.part.line,
                   DocumentText::tr("%1 is not a heading of a lesson. Write “## Try {#id}”, “## Predict "
                                    "{#id}”, “## Task: title {#id}”, “## Parameter: name {#id}”, “## Word: "
                                    "name”, “## Concept: title {#id}”, “## Why: question” or “## Learnt”.")
                       .arg(shown(section.part, QStringLiteral("##"))));
    }

    /// Returns the text below a heading.
    QString textOf(const DocumentPart &part, const QString &signs) const
    {
        QString text = joinedText(part.body);
        if (text.isEmpty())
            reject(part.line,
                   DocumentText::tr("there is no text below %1. Write it there, or remove the heading.")
                       .arg(shown(part, signs)));
        return text;
    }

    QString textOf(const DocumentSection &section) const
    {
        return textOf(section.part, QStringLiteral("##"));
    }
    QString textOf(const DocumentPart &field) const { return textOf(field, QStringLiteral("###")); }

    /// Checks that the heading has an id, which no other heading of `kind` has.
    void checkId(const DocumentSection &section, const Heading &heading)
    {
        if (heading.id.isEmpty())
            reject(section.part.line,
                   DocumentText::tr(
                       "%1 has no id. End the heading with “{#id}”, where id is made of a to z, 0 to 9 "
                       "and _.")
                       .arg(shown(section.part, QStringLiteral("##"))));
        const QString key = heading.kind + '#' + heading.id;
        if (m_ids.contains(key))
            reject(section.part.line,
                   DocumentText::tr("the id “%1” was used above. Choose another one.").arg(heading.id));
        m_ids.insert(key);
    }

    void checkName(const DocumentSection &section, const Heading &heading) const
    {
        if (heading.name.isEmpty() || !heading.id.isEmpty())
            reject(section.part.line,
                   DocumentText::tr("%1 is incomplete. Write “## %2: ” and a text after it.")
                       .arg(shown(section.part, QStringLiteral("##")), heading.kind));
    }

    [[noreturn]] void rejectField(const DocumentPart &field, const QString &known) const
    {
        reject(field.line, DocumentText::tr("%1 does not belong here. Here you can write %2.")
                               .arg(shown(field, QStringLiteral("###")), known));
    }

    void checkNoFields(const DocumentSection &section) const
    {
        if (!section.fields.empty())
            reject(section.fields.front().line,
                   DocumentText::tr("%1 does not belong here. Remove it, or write it below a “## Try”.")
                       .arg(shown(section.fields.front(), QStringLiteral("###"))));
    }

    [[noreturn]] void rejectSecond(const DocumentPart &field) const
    {
        reject(field.line, DocumentText::tr("%1 is there twice. Remove one of them.")
                               .arg(shown(field, QStringLiteral("###"))));
    }

    /// Sets a text that may be there once.
    void setOnce(QString &text, const DocumentPart &field) const
    {
        if (!text.isEmpty())
            rejectSecond(field);
        text = textOf(field);
    }

    void readTry(const DocumentSection &section, const Heading &heading)
    {
        checkId(section, heading);
        TryText one;
        one.id = heading.id;
        one.line = section.part.line;
        one.text = textOf(section);
        for (const DocumentPart &field : section.fields) {
            if (field.heading == u"Hint")
                setOnce(one.hint, field);
            else if (field.heading == u"Answer")
                setOnce(one.answer, field);
            else if (field.heading == u"Missing")
                readMissing(one, field);
            else if (field.heading == u"Choices")
                readChoices(one, field);
            else if (field.heading == u"Done when")
                readDoneWhen(one, field);
            else if (field.heading == u"Solution")
                readSolution(one, field);
            else
                rejectField(field, QStringLiteral("“### Choices”, “### Hint”, “### Answer”, “### Missing”, "
                                                  "“### Done when”, “### Solution”"));
        }
        if (!one.choices.isEmpty() && one.answer.isEmpty())
            reject(one.line,
                   DocumentText::tr("the thing to try “%1” has choices, but no answer. Write it below an "
                                    "“### Answer”.")
                       .arg(one.id));
        if (one.hint.isEmpty())
            reject(one.line,
                   DocumentText::tr("the thing to try “%1” has no hint. Write it below a “### Hint”.")
                       .arg(one.id));
        m_document.tries.push_back(one);
    }

    void readMissing(TryText &one, const DocumentPart &field) const
    {
        static const QRegularExpression item(QStringLiteral("^- ([a-z0-9_]+): (\\S.*)$"));
        if (one.missingLine > 0)
            rejectSecond(field);
        one.missingLine = field.line;
        const QStringList lines = textOf(field).split('\n', Qt::SkipEmptyParts);
        for (const QString &line : lines) {
            const auto match = item.match(line);
            if (!match.hasMatch())
                reject(field.line,
                       DocumentText::tr("“%1” has no name. Write “- name: sentence”, where the name is made "
                                        "of a to z, 0 to 9 and _.")
                           .arg(line));
            if (one.missing.contains(match.captured(1)))
                reject(field.line,
                       DocumentText::tr("the name “%1” is there twice. Remove one of the sentences.")
                           .arg(match.captured(1)));
            one.missing.insert(match.captured(1), match.captured(2));
        }
    }

    void readChoices(TryText &one, const DocumentPart &field) const
    {
        if (!one.choices.isEmpty())
            rejectSecond(field);
        one.choices = parseChoices(field, m_document.file);
    }

    void readDoneWhen(TryText &one, const DocumentPart &field) const
    {
        static const QRegularExpression name(QStringLiteral("^[a-z0-9_]+$"));
        if (!one.doneWhen.empty())
            rejectSecond(field);
        one.doneWhen = parseList(field, m_document.file);
        QSet<QString> names;
        for (const ListItem &item : one.doneWhen) {
            if (!name.match(item.name).hasMatch() || names.contains(item.name))
                reject(item.line, DocumentText::tr("a condition cannot be called “%1”. Give it a name of its "
                                                   "own, made of a to z, 0 to 9 and _.")
                                      .arg(item.name));
            names.insert(item.name);
        }
    }

    void readSolution(TryText &one, const DocumentPart &field) const
    {
        if (one.solution.line > 0)
            rejectSecond(field);
        one.solution = parseRunSetup(field, m_document.file);
        if (one.solution.frames == 0 || !one.solution.until.isEmpty() || !one.solution.step.isEmpty())
            reject(field.line,
                   DocumentText::tr("this run needs “- frames: ” and the number of frames in which "
                                    "the thing is done, and has no “until” and no “step”."));
    }

    void readPredict(const DocumentSection &section, const Heading &heading)
    {
        checkId(section, heading);
        m_document.predictions.push_back(parsePrediction(section, heading.id, m_document.file));
    }

    void readTask(const DocumentSection &section, const Heading &heading)
    {
        checkId(section, heading);
        if (heading.name.isEmpty())
            reject(section.part.line,
                   DocumentText::tr("the task “%1” has no title. Write “## Task: title {#%1}”.")
                       .arg(heading.id));
        CodeTask task;
        task.id = heading.id;
        task.title = heading.name;
        task.text = textOf(section);
        for (const DocumentPart &field : section.fields) {
            if (field.heading == u"Comment")
                setOnce(task.comment, field);
            else if (field.heading == u"Hint")
                task.hints << textOf(field);
            else if (field.heading.startsWith(u"Near miss"))
                task.nearMisses.push_back(nearMiss(field));
            else
                rejectField(field, QStringLiteral("“### Comment”, “### Hint”, “### Near miss”"));
        }
        if (task.comment.isEmpty())
            reject(section.part.line,
                   DocumentText::tr(
                       "the task “%1” has no comment for the empty place. Write it below a “### Comment”.")
                       .arg(task.id));
        if (task.hints.size() != hintsOfTask)
            reject(section.part.line,
                   DocumentText::tr(
                       "the number of hints of the task “%1” is %2, not 3. Write each below a “### Hint”.")
                       .arg(task.id)
                       .arg(task.hints.size()));
        m_document.tasks.push_back(task);
        m_document.taskLines.push_back(section.part.line);
    }

    void readParameter(const DocumentSection &section, const Heading &heading)
    {
        checkId(section, heading);
        checkNoFields(section);
        if (heading.name.isEmpty())
            reject(section.part.line,
                   DocumentText::tr("the parameter “%1” has no name. Write “## Parameter: name {#%1}”.")
                       .arg(heading.id));
        m_document.parameters.push_back(
            parseParameter(section.part, heading.name, heading.id, m_document.file));
    }

    NearMiss nearMiss(const DocumentPart &field) const
    {
        static const QRegularExpression pattern(QStringLiteral("^Near miss(?: in ([a-z0-9_]+))?$"));
        const auto match = pattern.match(field.heading);
        if (!match.hasMatch())
            rejectField(field, QStringLiteral("“### Near miss”, “### Near miss in id”"));
        const FencedCode fenced = takeCode(field.body);
        const QString sentence = joinedText(fenced.after);
        if (!fenced.isThere || sentence.isEmpty())
            reject(field.line,
                   DocumentText::tr("this near miss is incomplete. Write its code between two lines ```, and "
                                    "below it a sentence about what the code does."));
        return {fenced.code, sentence, match.captured(1)};
    }

    void readWord(const DocumentSection &section, const Heading &heading)
    {
        static const QString formsSign = QStringLiteral("Forms:");
        checkName(section, heading);
        checkNoFields(section);
        if (m_ids.contains(QStringLiteral("Word#") + heading.name))
            reject(section.part.line,
                   DocumentText::tr("the word “%1” is there twice. Remove one of them.").arg(heading.name));
        m_ids.insert(QStringLiteral("Word#") + heading.name);
        Term term{heading.name, heading.name, textOf(section)};
        if (term.text.startsWith(formsSign)) {
            const qsizetype end = term.text.indexOf(QStringLiteral("\n\n"));
            QStringList forms;
            for (const QString &form : term.text.mid(0, end).mid(formsSign.size()).split(','))
                forms << form.trimmed();
            term.forms = forms == QStringList{QStringLiteral("none")} ? QString() : forms.join('|');
            term.text = end < 0 ? QString() : term.text.mid(end + 2);
        }
        if (term.text.isEmpty())
            reject(section.part.line,
                   DocumentText::tr("the word “%1” is not explained. Write one to three sentences, "
                                    "after a blank line.")
                       .arg(term.name));
        m_document.explanation.terms.push_back(term);
    }

    void readConcept(const DocumentSection &section, const Heading &heading)
    {
        static const QString restsSign = QStringLiteral("Rests on:");
        checkId(section, heading);
        checkNoFields(section);
        const int line = section.part.line;
        if (heading.name.isEmpty() || heading.name.size() > Concept::longestTitle)
            reject(line, DocumentText::tr("the title of the concept “%1” has %2 characters. Write 1 to %3, "
                                          "as in “## Concept: title {#%1}”.")
                             .arg(heading.id)
                             .arg(heading.name.size())
                             .arg(Concept::longestTitle));
        Concept one{.id = heading.id, .title = heading.name, .file = m_document.file, .line = line};
        QStringList paragraphs = textOf(section).split(QStringLiteral("\n\n"));
        if (paragraphs.first().startsWith(restsSign)) {
            for (const QString &id : paragraphs.takeFirst().mid(restsSign.size()).split(','))
                one.restsOn << id.trimmed();
        }
        if (paragraphs.size() != 1)
            reject(line, DocumentText::tr("the concept “%1” needs one paragraph besides “Rests on: …”. Write "
                                          "one sentence there.")
                             .arg(one.id));
        one.text = paragraphs.first();
        m_document.explanation.concepts.push_back(one);
    }

    void readWhy(const DocumentSection &section, const Heading &heading)
    {
        checkName(section, heading);
        checkNoFields(section);
        DocumentPart part = section.part;
        std::vector<Formula> formulas = takeFormulas(part.body, part.line + 1, m_document.file);
        m_document.explanation.whys.push_back(
            {heading.name, textOf(part, QStringLiteral("##")), std::move(formulas)});
    }

    void readLearnt(const DocumentSection &section)
    {
        checkNoFields(section);
        if (!m_document.explanation.learnt.isEmpty())
            reject(section.part.line, DocumentText::tr("%1 is there twice. Remove one of them.")
                                          .arg(shown(section.part, QStringLiteral("##"))));
        m_document.explanation.learnt = textOf(section);
    }

    const ScannedDocument &m_scanned;
    Document m_document;
    QSet<QString> m_ids; ///< "Try#throw"
};

}

DocumentError::DocumentError(const QString &file, int line, const QString &why)
    : std::runtime_error(DocumentText::tr("%1, line %2: %3").arg(file).arg(line).arg(why).toStdString())
{
}

Document parseDocument(const QByteArray &source, const QString &file)
{
    const ScannedDocument scanned = scanDocument(source, file);
    return DocumentReader(scanned, file).read();
}

QString documentLanguage()
{
    //: The code of the language of this file, for the lessons' documents: de, fr
    return DocumentText::tr("en");
}

QStringList documentNames(const QString &step)
{
    const QString english = step + QStringLiteral(".md");
    const QString language = documentLanguage();
    if (language == u"en")
        return {english};
    return {QStringLiteral("%1.%2.md").arg(step, language), english};
}

std::optional<DocumentSource> documentSource(const QString &lesson, const QString &name)
{
    for (const QString &candidate : documentNames(name)) {
        QFile file(QStringLiteral(":/documents/%1/%2").arg(lesson, candidate));
        if (file.open(QIODevice::ReadOnly))
            return DocumentSource{file.readAll(), QStringLiteral("%1/%2").arg(lesson, candidate)};
    }
    return std::nullopt;
}

Document readDocument(const QString &lesson, const QString &step)
{
    if (const std::optional<DocumentSource> source = documentSource(lesson, step))
        return parseDocument(source->text, source->file);
    throw DocumentError(QStringLiteral("%1/%2.md").arg(lesson, step), 1,
                        DocumentText::tr("the file is missing. Write it, and configure the build again."));
}

}
