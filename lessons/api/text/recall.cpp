#include "lessons/api/text/recall.h"

#include "lessons/api/text/document.h"
#include "lessons/api/text/document_scan.h"
#include "lessons/api/text/document_source.h"
#include "lessons/api/text/run_setup.h"

#include <QCoreApplication>
#include <QRegularExpression>
#include <QSet>

namespace lessons {

namespace {

struct RecallText
{
    Q_DECLARE_TR_FUNCTIONS(Recall)
};

constexpr std::size_t mostChoices = 4;

/// Interprets the sections of a file with questions. Errors name the file.
class RecallReader
{
public:
    RecallReader(const ScannedDocument &scanned, const QString &file) : m_scanned(scanned)
    {
        m_recall.file = file;
    }

    Recall read()
    {
        m_recall.title = m_scanned.title.heading;
        m_recall.text = joinedText(m_scanned.title.body);
        if (m_recall.text.isEmpty())
            reject(m_scanned.title.line,
                   RecallText::tr("there is no text below the title. Write one sentence there."));
        if (m_scanned.sections.empty())
            reject(m_scanned.title.line,
                   RecallText::tr("there is no question. Write “## Question {#id}” and its text."));
        for (const DocumentSection &section : m_scanned.sections)
            readQuestion(section);
        return std::move(m_recall);
    }

private:
    [[noreturn]] void reject(int line, const QString &why) const
    {
        throw DocumentError(m_recall.file, line, why);
    }

    QString idOf(const DocumentPart &heading)
    {
        static const QRegularExpression pattern(QStringLiteral("^Question\\s*\\{#([a-z0-9_]+)\\}$"));
        const auto match = pattern.match(heading.heading);
        if (!match.hasMatch())
            reject(heading.line,
                   RecallText::tr("“## %1” is not a heading of a recall question. Write “## Question {#id}”, "
                                  "where id is made of a to z, 0 to 9 and _.")
                       .arg(heading.heading));
        const QString id = match.captured(1);
        if (m_ids.contains(id))
            reject(heading.line, RecallText::tr("the id “%1” was used above. Choose another one.").arg(id));
        m_ids.insert(id);
        return id;
    }

    QString textOf(const DocumentPart &part, const QString &signs) const
    {
        QString text = joinedText(part.body);
        if (text.isEmpty())
            reject(part.line,
                   RecallText::tr("there is no text below “%1 %2”. Write it there, or remove the heading.")
                       .arg(signs, part.heading));
        return text;
    }
    QString textOf(const DocumentPart &field) const { return textOf(field, QStringLiteral("###")); }

    void readQuestion(const DocumentSection &section)
    {
        RecallQuestion question;
        question.id = idOf(section.part);
        question.line = section.part.line;
        question.text = textOf(section.part, QStringLiteral("##"));
        QString answer;
        bool hasRight = false;
        RunSetup solution;
        std::vector<RecallChoice> wrong;
        for (const DocumentPart &field : section.fields) {
            if (field.heading == u"Right") {
                checkFirst(hasRight, field);
                hasRight = true;
                question.choices.push_back(choiceOf(field));
            } else if (field.heading == u"Wrong") {
                wrong.push_back(wrongChoiceOf(field));
            } else if (field.heading == u"Do") {
                checkFirst(question.task.has_value(), field);
                question.task = RecallTask{setupOf(field), {}};
            } else if (field.heading == u"Solution") {
                checkFirst(solution.line > 0, field);
                solution = solutionOf(field);
            } else if (field.heading == u"Answer") {
                checkFirst(!answer.isEmpty(), field);
                answer = textOf(field);
            } else {
                reject(field.line,
                       RecallText::tr("“### %1” does not belong here. Here you can write “### Right” and "
                                      "“### Wrong”, or “### Do” and “### Answer”.")
                           .arg(field.heading));
            }
        }
        question.choices.insert(question.choices.end(), wrong.begin(), wrong.end());
        checkWhole(question, hasRight, !answer.isEmpty());
        if (question.task) {
            question.task->answer = answer;
            question.task->solution = solution;
        }
        m_recall.questions.push_back(std::move(question));
    }

    /// Checks that a heading that may be there once was not there before.
    void checkFirst(bool wasThere, const DocumentPart &field) const
    {
        if (wasThere)
            reject(field.line,
                   RecallText::tr("“### %1” is there twice. Remove one of them.").arg(field.heading));
    }

    void checkWhole(const RecallQuestion &question, bool hasRight, bool hasAnswer) const
    {
        const std::size_t choices = question.choices.size();
        if (question.task ? choices > 0 || !hasAnswer : hasAnswer || !hasRight || choices < 2)
            reject(question.line,
                   RecallText::tr("the question “%1” is incomplete. Write one “### Right” and one to three "
                                  "“### Wrong”, or “### Do” and “### Answer”.")
                       .arg(question.id));
        if (choices > mostChoices)
            reject(question.line, RecallText::tr("the question “%1” has %2 choices. Keep four at most.")
                                      .arg(question.id)
                                      .arg(choices));
    }

    RecallChoice choiceOf(const DocumentPart &field) const
    {
        const QString text = textOf(field);
        const qsizetype end = text.indexOf(QStringLiteral("\n\n"));
        RecallChoice choice{text.left(end), end < 0 ? QString() : text.mid(end + 2)};
        if (choice.text.startsWith(QStringLiteral("```")))
            reject(field.line, RecallText::tr("the choice begins with ```. Write its code in backticks."));
        if (choice.text.size() > RecallChoice::longest)
            reject(field.line, RecallText::tr("the choice has %1 characters. Make its first paragraph %2 or "
                                              "shorter, and explain it in the next one.")
                                   .arg(choice.text.size())
                                   .arg(RecallChoice::longest));
        return choice;
    }

    RecallChoice wrongChoiceOf(const DocumentPart &field) const
    {
        RecallChoice choice = choiceOf(field);
        if (choice.explanation.isEmpty())
            reject(field.line, RecallText::tr("this choice is not explained. Write why it is wrong below it, "
                                              "after a blank line."));
        return choice;
    }

    RunSetup setupOf(const DocumentPart &field) const
    {
        const RunSetup setup = parseRunSetup(field, m_recall.file);
        static const QRegularExpression step(QStringLiteral("^[a-z0-9_]+/[a-z0-9_]+$"));
        if (!step.match(setup.step).hasMatch())
            reject(field.line,
                   RecallText::tr("the scene is missing. Write “- step: lesson/step” in the list."));
        if (setup.until.isEmpty())
            reject(field.line, RecallText::tr("nothing says when this is done. Write “- until: condition” in "
                                              "the list."));
        return setup;
    }

    RunSetup solutionOf(const DocumentPart &field) const
    {
        const RunSetup solution = parseRunSetup(field, m_recall.file);
        if (solution.frames == 0 || !solution.until.isEmpty() || !solution.step.isEmpty())
            reject(field.line,
                   RecallText::tr("this run needs “- frames: ” and the number of frames in which it is "
                                  "done, and has no “until” and no “step”."));
        return solution;
    }

    const ScannedDocument &m_scanned;
    Recall m_recall;
    QSet<QString> m_ids;
};

}

Recall parseRecall(const QByteArray &source, const QString &file)
{
    const ScannedDocument scanned = scanDocument(source, file);
    return RecallReader(scanned, file).read();
}

Recall readRecall(const QString &lesson)
{
    const std::optional<DocumentSource> source = documentSource(lesson, QStringLiteral("recall"));
    if (!source)
        return {};
    return parseRecall(source->text, source->file);
}

}
