#include "app/cli/notebook_report.h"

#include "app/model/text/csv.h"
#include "app/model/text/json_writer.h"
#include "app/model/text/quoting.h"

#include <QCoreApplication>

#include <algorithm>
#include <optional>

namespace app {

namespace {

struct NotebookReportText
{
    Q_DECLARE_TR_FUNCTIONS(NotebookReportText)
};

QString placeOf(const NotebookEntry &entry)
{
    return entry.step.isEmpty() ? entry.lesson : entry.lesson + '/' + entry.step;
}

std::optional<QString> textOrNull(const QString &text)
{
    return text.isEmpty() ? std::nullopt : std::optional(text);
}

std::optional<QString> timeOrNull(const QDateTime &time)
{
    return time.isValid() ? std::optional(time.toString(Qt::ISODate)) : std::nullopt;
}

/// Returns a field of CSV that no spreadsheet takes for a formula, because learners write names and titles.
QByteArray writtenField(const QString &text)
{
    const bool isFormula = !text.isEmpty() && QStringLiteral("=+-@").contains(text.front());
    return quotedField(isFormula ? '\'' + text : text);
}

/// Returns how many entries of a notebook are shown.
QString summaryLine(const CheckedNotebook &checked)
{
    const auto faults = std::count_if(checked.findings.begin(), checked.findings.end(),
                                      [](const NotebookFinding &one) { return one.isFault(); });
    const auto all = static_cast<qint64>(checked.findings.size());
    QString line =
        all == 0 ? NotebookReportText::tr("Nothing is in it.")
                 : NotebookReportText::tr("%1 of %2 are shown by their runs.").arg(all - faults).arg(all);
    if (!checked.notebook.isSealed)
        line += ' ' + NotebookReportText::tr("The file was changed after it was written.");
    return "  " + line + '\n';
}

}

bool CheckedNotebook::holds() const
{
    return mistake.isEmpty() && notebook.isSealed &&
           std::none_of(findings.begin(), findings.end(),
                        [](const NotebookFinding &one) { return one.isFault(); });
}

QString notebookTable(const std::vector<CheckedNotebook> &all)
{
    QString text;
    for (const CheckedNotebook &checked : all) {
        if (!checked.mistake.isEmpty())
            continue;
        const Notebook &notebook = checked.notebook;
        text += shownPath(checked.file);
        if (!notebook.name.isEmpty())
            text += ", " + escaped(notebook.name);
        text += ", " + notebook.when.toString(Qt::ISODate) + '\n';
        for (std::size_t i = 0; i < notebook.entries.size(); ++i) {
            const NotebookEntry &entry = notebook.entries[i];
            const NotebookFinding &finding = checked.findings[i];
            QString line = "  " + placeOf(entry).leftJustified(34) + ' ' +
                           wordFor(entry.kind).leftJustified(11) + escaped(entry.id).leftJustified(20) + ' ' +
                           wordFor(finding.result);
            if (!finding.why.isEmpty())
                line = line.leftJustified(80) + ' ' + escaped(finding.why);
            text += line.trimmed().prepend("  ") + '\n';
        }
        text += summaryLine(checked) + '\n';
    }
    return text;
}

QString notebookCsv(const std::vector<CheckedNotebook> &all)
{
    QByteArray text = "file,name,lesson,step,kind,id,when,result,sealed,why\n";
    for (const CheckedNotebook &checked : all) {
        if (!checked.mistake.isEmpty())
            continue;
        const Notebook &notebook = checked.notebook;
        for (std::size_t i = 0; i < notebook.entries.size(); ++i) {
            const NotebookEntry &entry = notebook.entries[i];
            const NotebookFinding &finding = checked.findings[i];
            QByteArrayList row;
            for (const QString &field :
                 {checked.file, notebook.name, entry.lesson, entry.step, wordFor(entry.kind), entry.id,
                  timeOrNull(entry.when).value_or(QString()), wordFor(finding.result),
                  notebook.isSealed ? QStringLiteral("yes") : QStringLiteral("no"), finding.why})
                row << writtenField(field);
            text += row.join(',') + '\n';
        }
    }
    return QString::fromUtf8(text);
}

QString notebookJson(const std::vector<CheckedNotebook> &all)
{
    JsonWriter json(4);
    json.beginObject();
    json.beginList("notebooks");
    for (const CheckedNotebook &checked : all) {
        const Notebook &notebook = checked.notebook;
        json.beginObject();
        json.field("file", checked.file);
        json.field("mistake", textOrNull(checked.mistake));
        if (checked.mistake.isEmpty()) {
            json.field("name", textOrNull(notebook.name));
            json.field("when", timeOrNull(notebook.when));
            json.field("sealed", notebook.isSealed);
            json.beginList("entries");
            for (std::size_t i = 0; i < notebook.entries.size(); ++i) {
                const NotebookEntry &entry = notebook.entries[i];
                const NotebookFinding &finding = checked.findings[i];
                json.beginObject();
                json.field("lesson", entry.lesson);
                json.field("step", textOrNull(entry.step));
                json.field("kind", wordFor(entry.kind));
                json.field("id", entry.id);
                json.field("when", timeOrNull(entry.when));
                json.field("result", wordFor(finding.result));
                json.field("why", textOrNull(finding.why));
                json.endObject();
            }
            json.endList();
        }
        json.endObject();
    }
    json.endList();
    json.endObject();
    return QString::fromUtf8(json.text()) + '\n';
}

}
