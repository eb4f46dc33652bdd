#pragma once

#include "app/model/catalog/lesson_library.h"

#include <vector>

namespace app {

/// A term that a step teaches.
struct GlossaryEntry
{
    lessons::Term term;
    QString lesson; ///< id
    QString step;   ///< id
    QString where;  ///< "Single spring: A fixed centre"
};

/// A place where a glossary term occurs in a text.
struct Mention
{
    qsizetype start = 0;
    qsizetype length = 0;
    std::size_t entry = 0; ///< index in Glossary::entries()
};

/// The terms that the lessons define, sorted by name. If two have the same name, the one taught first is used.
class Glossary
{
public:
    explicit Glossary(const LessonLibrary &library);

    const std::vector<GlossaryEntry> &entries() const { return m_entries; }
    /// Returns the entry with this name, ignoring case, or null.
    const GlossaryEntry *find(const QString &name) const;
    /// Returns the entries that contain `typed`: first in the name or its other forms, then in the text. Returns
    /// all entries if `typed` is empty.
    std::vector<const GlossaryEntry *> matching(const QString &typed) const;
    /// Returns the first occurrence of each term in `text` as a whole word, from left to right. If two overlap, the
    /// longer one is used.
    std::vector<Mention> mentionsIn(const QString &text) const;

private:
    std::vector<GlossaryEntry> m_entries;
};

}
