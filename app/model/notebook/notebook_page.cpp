#include "app/model/notebook/notebook_page.h"

#include "app/model/catalog/lists.h"
#include "app/model/files/gallery.h"
#include "app/model/learning/prediction_text.h"
#include "app/model/notebook/notebook_question.h"
#include "app/model/text/pdf.h"
#include "app/model/text/phrases.h"

#include <QCoreApplication>
#include <QFont>
#include <QLocale>
#include <QRegularExpression>
#include <QTextDocument>

#include <algorithm>

namespace app {

namespace {

using Kind = NotebookEntry::Kind;

constexpr auto pageStyle = R"(
:root { color-scheme: light dark; --ink: #23262e; --soft: #5d6470; --line: #d9dce2; --sunk: #f3f4f7; --paper: #fff; }
@media (prefers-color-scheme: dark) {
  :root { --ink: #e6e8ec; --soft: #a3a9b5; --line: #3a3f4a; --sunk: #23262e; --paper: #1a1c22; }
}
body { font: 16px/1.5 system-ui, sans-serif; color: var(--ink); background: var(--paper); max-width: 44rem;
  margin: 2.5rem auto; padding: 0 1rem; }
h1 { font-size: 1.8rem; margin-bottom: .2rem; }
h2 { margin-top: 2.5rem; border-bottom: 1px solid var(--line); padding-bottom: .2rem; }
h3 { margin-top: 1.8rem; }
.entry { margin: 1rem 0 1.4rem; break-inside: avoid; }
.entry p { margin: .2rem 0; }
.soft { color: var(--soft); font-size: .9rem; }
pre { background: var(--sunk); border-radius: 6px; padding: .7rem .9rem; overflow-x: auto; font-size: .9rem;
  line-height: 1.35; }
code { font-family: ui-monospace, monospace; }
img { display: block; border: 1px solid var(--line); border-radius: 6px; margin-top: .4rem; }
)";

/// What a PDF can show of the same styles: it is printed on white paper.
constexpr auto printStyle =
    "h2 { margin-top: 22px; } .entry { margin-top: 10px; margin-bottom: 10px; } "
    ".soft { color: #5d6470; font-size: 8pt; } pre { background: #f3f4f7; font-size: 8pt; }";

/// A writer of the page's body.
class PageBody
{
    Q_DECLARE_TR_FUNCTIONS(NotebookPageText)

public:
    PageBody(const Notebook &notebook, const LessonLibrary &library, const EntryPicture &picture)
        : m_notebook(notebook), m_library(library), m_picture(picture)
    {
    }

    QString title() const
    {
        return m_notebook.name.isEmpty() ? tr("Notebook") : tr("Notebook of %1").arg(m_notebook.name);
    }

    QString html()
    {
        m_html = QStringLiteral("<h1>%1</h1>\n").arg(title().toHtmlEscaped());
        addSoft(tr("Springstep, %1").arg(dateOf(m_notebook.when)));
        if (m_notebook.entries.empty())
            addParagraph(tr("Nothing is done yet.").toHtmlEscaped());
        for (std::size_t i = 0; i < m_library.entries(); ++i)
            addLesson(m_library.entry(i));
        addSection(2, tr("Built and kept"), [](const auto &entry) { return entry.kind == Kind::scene; });
        return m_html;
    }

private:
    static QString dateOf(const QDateTime &when)
    {
        return QLocale().toString(when.toLocalTime(), QLocale::ShortFormat);
    }

    void addParagraph(const QString &html) { m_html += QStringLiteral("<p>%1</p>\n").arg(html); }
    void addSoft(const QString &text)
    {
        m_html += QStringLiteral("<p class=\"soft\">%1</p>\n").arg(text.toHtmlEscaped());
    }
    void addHeading(int level, const QString &text)
    {
        m_html += QStringLiteral("<h%1>%2</h%1>\n").arg(QString::number(level), text.toHtmlEscaped());
    }

    void addLesson(const LessonEntry &lesson)
    {
        const auto isHere = [&](const NotebookEntry &entry) {
            return entry.kind != Kind::scene && entry.lesson == lesson.id;
        };
        if (std::none_of(m_notebook.entries.begin(), m_notebook.entries.end(), isHere))
            return;
        addHeading(2, lesson.title);
        for (const lessons::Step &step : lesson.steps)
            addSection(3, step.title,
                       [&](const auto &entry) { return isHere(entry) && entry.step == step.id; });
        addSection(3, lesson.recall.title, [&](const auto &entry) {
            return isHere(entry) && entry.kind == Kind::answer && entry.step.isEmpty();
        });
        if (lesson.project)
            addSection(3, tr("Project: %1").arg(lesson.project->title),
                       [&](const auto &entry) { return isHere(entry) && entry.kind == Kind::level; });
    }

    /// Adds the entries that `isIn` chooses below a heading; nothing if there are none.
    template <class IsIn>
    void addSection(int level, const QString &heading, const IsIn &isIn)
    {
        bool isFirst = true;
        for (const NotebookEntry &entry : m_notebook.entries) {
            if (!isIn(entry))
                continue;
            if (isFirst)
                addHeading(level, heading);
            isFirst = false;
            m_html += QStringLiteral("<div class=\"entry\">\n");
            addEntry(*m_library.lesson(entry.lesson), entry);
            m_html += QStringLiteral("</div>\n");
        }
    }

    void addEntry(const LessonEntry &lesson, const NotebookEntry &entry)
    {
        switch (entry.kind) {
        case Kind::tried:
            addTry(*lesson.step(entry.step), entry);
            break;
        case Kind::prediction:
            addPrediction(*lesson.step(entry.step), entry);
            break;
        case Kind::code:
            addCode(*lesson.step(entry.step), entry);
            break;
        case Kind::level:
            addLevel(lesson, entry);
            break;
        case Kind::answer:
            addAnswer(lesson, entry);
            break;
        case Kind::scene:
            addParagraph(QStringLiteral("<b>%1</b>").arg(entry.id.toHtmlEscaped()));
            addMoment(entry);
            break;
        }
    }

    void addTry(const lessons::Step &step, const NotebookEntry &entry)
    {
        if (const lessons::Try *one = findById(step.tries, entry.id))
            addParagraph(QStringLiteral("✓ ") + htmlOf(one->text));
        addMoment(entry);
    }

    void addPrediction(const lessons::Step &step, const NotebookEntry &entry)
    {
        const lessons::Prediction *one = findById(step.predictions, entry.id);
        if (!one)
            return;
        addParagraph(htmlOf(one->text));
        const auto said = answerInNote(one->question, entry.said),
                   found = answerInNote(one->question, entry.found);
        if (said && found)
            addParagraph((entry.isRight ? QStringLiteral("✓ ") : QStringLiteral("→ ")) +
                         htmlOf(outcomeSentence(*one, *said, *found)));
        addWhen(entry);
    }

    void addAnswer(const LessonEntry &lesson, const NotebookEntry &entry)
    {
        const auto question = notebookQuestion(lesson, entry.step, entry.id);
        if (!question)
            return;
        if (question->task) {
            addParagraph(QStringLiteral("✓ ") + htmlOf(question->text));
            addParagraph(htmlOf(question->task->answer));
            addMoment(entry);
            return;
        }
        addParagraph(htmlOf(question->text));
        if (const lessons::RecallChoice *said = question->choice(entry.said))
            addChoice(*said, question->isRight(entry.said), entry);
        addWhen(entry);
    }

    void addChoice(const lessons::RecallChoice &said, bool isRight, const NotebookEntry &entry)
    {
        // As in the window, a thing to try tells its answer once it is done.
        if (!entry.step.isEmpty() && !isTried(entry)) {
            addParagraph(htmlOf(said.text));
            return;
        }
        addParagraph((isRight ? QStringLiteral("✓ ") : QStringLiteral("→ ")) + htmlOf(said.text));
        if (!said.explanation.isEmpty())
            addParagraph(htmlOf(said.explanation));
    }

    bool isTried(const NotebookEntry &choice) const
    {
        return std::any_of(m_notebook.entries.begin(), m_notebook.entries.end(), [&](const auto &entry) {
            return entry.kind == Kind::tried && entry.lesson == choice.lesson && entry.step == choice.step &&
                   entry.id == choice.id;
        });
    }

    void addCode(const lessons::Step &step, const NotebookEntry &entry)
    {
        if (const lessons::CodeTask *task = findById(step.codeTasks, entry.id))
            addParagraph(
                QStringLiteral("✓ <b>%1</b> %2").arg(task->title.toHtmlEscaped(), htmlOf(task->text)));
        if (!entry.code.isEmpty())
            m_html += QStringLiteral("<pre>%1</pre>\n").arg(entry.code.trimmed().toHtmlEscaped());
        addWhen(entry);
    }

    void addLevel(const LessonEntry &lesson, const NotebookEntry &entry)
    {
        const lessons::ProjectLevel *level =
            lesson.project ? findById(lesson.project->levels, entry.id) : nullptr;
        if (level)
            addParagraph(QStringLiteral("✓ <b>%1</b>").arg(level->title.toHtmlEscaped()));
        addMoment(entry);
    }

    void addWhen(const NotebookEntry &entry)
    {
        if (entry.when.isValid())
            addSoft(dateOf(entry.when));
    }

    /// Adds the date and the frame of a run, and its picture.
    void addMoment(const NotebookEntry &entry)
    {
        QStringList facts;
        if (entry.when.isValid())
            facts << dateOf(entry.when);
        if (entry.run.at.frame > 0)
            facts << frameName(entry.run.at.frame);
        if (!facts.isEmpty())
            addSoft(facts.join(QStringLiteral(", ")));
        const QImage picture = m_picture && !entry.run.text.isEmpty() ? m_picture(entry) : QImage();
        if (picture.isNull())
            return;
        const QSizeF size = picture.deviceIndependentSize();
        m_html += QStringLiteral(
                      "<p><img width=\"%1\" height=\"%2\" alt=\"%3\" src=\"data:image/png;base64,%4\"></p>\n")
                      .arg(QString::number(size.width()), QString::number(size.height()),
                           tr("The scene at that moment").toHtmlEscaped(),
                           QString::fromLatin1(pngOf(picture).toBase64()));
    }

    const Notebook &m_notebook;
    const LessonLibrary &m_library;
    const EntryPicture &m_picture;
    QString m_html;
};

}

QString htmlOf(const QString &markdown)
{
    static const QRegularExpression code(QStringLiteral("`([^`]+)`"));
    static const QRegularExpression bold(QStringLiteral("\\*\\*([^*]+)\\*\\*"));
    QString html;
    qsizetype end = 0;
    const auto addText = [&](const QString &text) {
        html += text.toHtmlEscaped().replace(bold, QStringLiteral("<b>\\1</b>"));
    };
    // Bold words do not reach into code, which may have stars of its own.
    for (auto match = code.globalMatch(markdown); match.hasNext();) {
        const QRegularExpressionMatch one = match.next();
        addText(markdown.mid(end, one.capturedStart() - end));
        html += QStringLiteral("<code>%1</code>").arg(one.captured(1).toHtmlEscaped());
        end = one.capturedEnd();
    }
    addText(markdown.mid(end));
    return html;
}

QByteArray notebookHtml(const Notebook &notebook, const LessonLibrary &library, const EntryPicture &picture)
{
    PageBody body(notebook, library, picture);
    const QString html =
        QStringLiteral("<!DOCTYPE html>\n<html lang=\"%1\">\n<head>\n<meta charset=\"utf-8\">\n"
                       "<meta name=\"viewport\" content=\"width=device-width\">\n"
                       "<title>%2</title>\n<style>%3</style>\n</head>\n<body>\n")
            .arg(lessons::documentLanguage(), body.title().toHtmlEscaped(), QString::fromUtf8(pageStyle));
    return (html + body.html() + QStringLiteral("</body>\n</html>\n")).toUtf8();
}

QByteArray notebookPdf(const Notebook &notebook, const LessonLibrary &library, const EntryPicture &picture)
{
    PageBody body(notebook, library, picture);
    QTextDocument document;
    document.setDefaultStyleSheet(QString::fromUtf8(printStyle));
    QFont font;
    font.setPointSizeF(10);
    document.setDefaultFont(font);
    document.setHtml(body.html());
    return pdfOf(document, body.title());
}

}
