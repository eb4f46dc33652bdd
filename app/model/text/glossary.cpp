#include "app/model/text/glossary.h"

#include "app/model/text/phrases.h"

#include <QCoreApplication>

#include <algorithm>
#include <optional>

namespace app {

namespace {

struct GlossaryText
{
    Q_DECLARE_TR_FUNCTIONS(GlossaryText)
};

struct Form
{
    QString text;
    std::size_t entry;
};

std::vector<Form> longestFirst(const std::vector<GlossaryEntry> &entries)
{
    std::vector<Form> forms;
    for (std::size_t i = 0; i < entries.size(); ++i) {
        for (const QString &form : entries[i].term.forms.split('|', Qt::SkipEmptyParts))
            forms.push_back({form, i});
    }
    std::stable_sort(forms.begin(), forms.end(),
                     [](const Form &a, const Form &b) { return a.text.size() > b.text.size(); });
    return forms;
}

bool isWholeWord(const QString &text, qsizetype start, qsizetype length)
{
    const qsizetype end = start + length;
    return (start == 0 || !text[start - 1].isLetterOrNumber()) &&
           (end == text.size() || !text[end].isLetterOrNumber());
}

/// Marks every occurrence of `form` that no longer form already covers, so that no part of it is found again.
/// Returns the first such position.
std::optional<qsizetype> take(const QString &text, const QString &form, std::vector<bool> &taken)
{
    std::optional<qsizetype> first;
    qsizetype at = text.indexOf(form, 0, Qt::CaseInsensitive);
    for (; at >= 0; at = text.indexOf(form, at + 1, Qt::CaseInsensitive)) {
        const auto begin = taken.begin() + at;
        const auto end = begin + form.size();
        if (!isWholeWord(text, at, form.size()) || std::find(begin, end, true) != end)
            continue;
        std::fill(begin, end, true);
        first = first.value_or(at);
    }
    return first;
}

bool contains(const QString &text, const QString &typed)
{
    return text.contains(typed, Qt::CaseInsensitive);
}

}

Glossary::Glossary(const LessonLibrary &library)
{
    for (std::size_t i = 0; i < library.entries(); ++i) {
        const LessonEntry &lesson = library.entry(i);
        for (const lessons::Step &step : lesson.steps) {
            for (const lessons::Term &term : step.explanation.terms) {
                if (!find(term.name))
                    m_entries.push_back({term, lesson.id, step.id, labelled(lesson.title, step.title)});
            }
        }
    }
    std::sort(m_entries.begin(), m_entries.end(), [](const GlossaryEntry &a, const GlossaryEntry &b) {
        return QString::localeAwareCompare(a.term.name.toLower(), b.term.name.toLower()) < 0;
    });
}

const GlossaryEntry *Glossary::find(const QString &name) const
{
    const auto found = std::find_if(m_entries.begin(), m_entries.end(), [&](const GlossaryEntry &one) {
        return one.term.name.compare(name, Qt::CaseInsensitive) == 0;
    });
    return found == m_entries.end() ? nullptr : &*found;
}

std::vector<const GlossaryEntry *> Glossary::matching(const QString &typed) const
{
    const QString wanted = typed.simplified();
    std::vector<const GlossaryEntry *> byName, byText;
    for (const GlossaryEntry &one : m_entries) {
        if (contains(one.term.name, wanted) || contains(one.term.forms, wanted))
            byName.push_back(&one);
        else if (contains(one.term.text, wanted))
            byText.push_back(&one);
    }
    byName.insert(byName.end(), byText.begin(), byText.end());
    return byName;
}

std::vector<Mention> Glossary::mentionsIn(const QString &text) const
{
    std::vector<bool> taken(static_cast<std::size_t>(text.size()), false);
    std::vector<std::optional<Mention>> first(m_entries.size());
    for (const Form &form : longestFirst(m_entries)) {
        const std::optional<qsizetype> at = take(text, form.text, taken);
        std::optional<Mention> &known = first[form.entry];
        if (at && (!known || *at < known->start))
            known = Mention{*at, form.text.size(), form.entry};
    }
    std::vector<Mention> mentions;
    for (const std::optional<Mention> &one : first) {
        if (one)
            mentions.push_back(*one);
    }
    std::sort(mentions.begin(), mentions.end(),
              [](const Mention &a, const Mention &b) { return a.start < b.start; });
    return mentions;
}

}
