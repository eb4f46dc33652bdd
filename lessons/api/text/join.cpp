#include "lessons/api/text/join.h"

#include <QCoreApplication>
#include <QFileInfo>

#include <algorithm>

namespace lessons {

namespace {

struct JoinText
{
    Q_DECLARE_TR_FUNCTIONS(Join)
};

template <class Items>
auto withId(const Items &items, const QString &id)
{
    return std::find_if(items.begin(), items.end(), [&id](const auto &one) { return one.id == id; });
}

template <class Items>
QString idsOf(const Items &items)
{
    QStringList ids;
    for (const auto &one : items)
        ids << one.id;
    return ids.isEmpty() ? JoinText::tr("none") : ids.join(QStringLiteral(", "));
}

/// Checks that the sentences below “### Missing” have the names in `conditions`.
void checkSentences(const Document &document, const TryText &text, const Conditions &conditions)
{
    const QStringList names = conditions.sentences();
    for (const QString &name : names) {
        if (!text.missing.contains(name))
            throw DocumentError(
                document.file, text.missingLine > 0 ? text.missingLine : text.line,
                JoinText::tr("the thing to try “%1” says nothing about what is missing for “%2”. Write "
                             "“- %2: sentence” below its “### Missing”.")
                    .arg(text.id, name));
    }
    QStringList possible;
    for (const ListItem &condition : text.doneWhen) // of a lesson without C++
        possible << condition.name;
    if (possible.isEmpty())
        possible = names;
    const QStringList given = text.missing.keys();
    for (const QString &name : given) {
        if (!names.contains(name))
            throw DocumentError(
                document.file, text.missingLine,
                JoinText::tr(
                    "the thing to try “%1” has no condition “%2”. Remove the sentence, or give it one of the "
                    "names: %3.")
                    .arg(text.id, name,
                         possible.isEmpty() ? JoinText::tr("none") : possible.join(QStringLiteral(", "))));
    }
}

}

std::vector<Try> joinedTries(const Document &document, const std::vector<Check> &checks)
{
    std::vector<Try> tries;
    for (const TryText &text : document.tries) {
        const auto check = withId(checks, text.id);
        if (check == checks.end())
            throw DocumentError(
                document.file, text.line,
                JoinText::tr("the thing to try “%1” is unknown. Use one of the ids of this step: %2.")
                    .arg(text.id, idsOf(checks)));
        checkSentences(document, text, check->conditions);
        tries.push_back({
            .text = text.text,
            .conditions = check->conditions.with(text.missing),
            .budget = check->budget,
            .onlyWhilePaused = check->onlyWhilePaused,
            .hint = text.hint,
            .answer = text.answer,
            .id = text.id,
            .choices = text.choices,
        });
    }
    for (const Check &check : checks) {
        if (withId(document.tries, check.id) == document.tries.end())
            throw DocumentError(
                document.file, 1,
                JoinText::tr("the thing to try “%1” is missing. Write “## Try {#%1}” and its text.")
                    .arg(check.id));
    }
    return tries;
}

void checkParameters(const Document &document, const std::vector<Parameter> &parameters)
{
    for (const ParameterText &text : document.parameters) {
        if (withId(parameters, text.id) == parameters.end())
            throw DocumentError(
                document.file, text.line,
                JoinText::tr("the step has no parameter “%1”. Remove the heading: only lessons without "
                             "C++ declare parameters in a document.")
                    .arg(text.id));
    }
}

void checkGaps(const Document &document, const Listing &listing)
{
    for (std::size_t i = 0; i < document.tasks.size(); ++i) {
        const CodeTask &task = document.tasks[i];
        QStringList gaps = task.isWholeFrame() ? QStringList() : QStringList{task.id};
        for (const NearMiss &miss : task.nearMisses) {
            if (!miss.gap.isEmpty())
                gaps << miss.gap;
        }
        for (const QString &gap : gaps) {
            if (listing.gap(gap))
                continue;
            const QString code = QFileInfo(document.file).baseName() + QStringLiteral(".code");
            throw DocumentError(document.file, document.taskLines[i],
                                listing.gaps.empty()
                                    ? JoinText::tr("the listing has no gap “%1”. In %2, put the lines that "
                                                   "learners write between “//> %1” and “//<”.")
                                          .arg(gap, code)
                                    : JoinText::tr("the listing has no gap “%1”. Use one of: %2.")
                                          .arg(gap, idsOf(listing.gaps)));
        }
    }
}

}
