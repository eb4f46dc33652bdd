#pragma once

#include "app/model/lesson_library.h"

#include <vector>

namespace app {

/// A word that some step teaches.
struct GlossaryEntry
{
    lessons::Term term;
    QString lesson; ///< id
    QString step;   ///< id
    QString where;  ///< "Single spring: A fixed centre"
};

/// Where a word of the glossary stands in a text.
struct Mention
{
    qsizetype start = 0;
    qsizetype length = 0;
    std::size_t entry = 0; ///< its place in Glossary::entries()
};

/// The words that the lessons bring with them, by name. Of two with the same name the one that is taught first counts.
class Glossary
{
public:
    explicit Glossary(const LessonLibrary &library);

    const std::vector<GlossaryEntry> &entries() const { return m_entries; }
    /// Null if there is no such word; a capital letter does not matter.
    const GlossaryEntry *find(const QString &name) const;
    /// Those whose name or whose other forms contain what was typed, then those whose text does; all, if it is empty.
    std::vector<const GlossaryEntry *> matching(const QString &typed) const;
    /// The first time that each word stands in `text`, as a whole word, from left to right; the longer of two that
    /// overlap.
    std::vector<Mention> mentionsIn(const QString &text) const;

private:
    std::vector<GlossaryEntry> m_entries;
};

}
