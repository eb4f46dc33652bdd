// Finds the lines of the previous step that were removed, and their former positions.

#include "app/model/code/code_lines.h"
#include "app/model/code/code_listing.h"

#include <QHash>
#include <QSet>

#include <algorithm>

namespace app {

namespace {

int sharedLines(const CodeSection &one, const CodeSection &other)
{
    QSet<QString> texts;
    for (const CodeLine &line : one.lines)
        texts.insert(comparable(line));
    texts.remove(QString());
    return static_cast<int>(
        std::count_if(other.lines.begin(), other.lines.end(),
                      [&texts](const CodeLine &line) { return texts.contains(comparable(line)); }));
}

/// Returns the section of `listing` that corresponds to `was`, or `last` if none of its lines are left.
std::size_t becameOf(const CodeSection &was, const CodeListing &listing, std::size_t last)
{
    int most = 0;
    std::size_t found = last;
    for (std::size_t i = 0; i < listing.sections.size(); ++i) {
        if (listing.sections[i].role != was.role)
            continue;
        const int shared = sharedLines(was, listing.sections[i]);
        if (shared > most) {
            most = shared;
            found = i;
        }
    }
    return found;
}

/// Goes through a section of the previous step, and adds its removed lines to the corresponding section.
class Walk
{
public:
    Walk(CodeSection &section, bool isTheSame)
        : m_section(section), m_at(isTheSame ? 0 : section.lines.size())
    {
    }

    void keep(const QString &text)
    {
        for (std::size_t i = m_at; i < m_section.lines.size(); ++i) {
            if (comparable(m_section.lines[i]) != text)
                continue;
            m_at = i + 1;
            return;
        }
    }
    void lose(const CodeLine &line) { m_section.gone.push_back({m_at, line.source.text, line.file}); }

private:
    CodeSection &m_section;
    std::size_t m_at;
};

}

void markGone(CodeListing &listing, const CodeListing &before)
{
    if (listing.sections.empty())
        return;
    QHash<QString, int> left = countsOf(listing);
    QSet<CodeLinePlace> seen;
    std::size_t last = 0;
    for (const CodeSection &was : before.sections) {
        const std::size_t became = becameOf(was, listing, last);
        Walk walk(listing.sections[became], sharedLines(was, listing.sections[became]) > 0);
        last = became;
        for (const CodeLine &line : was.lines) {
            const QString text = comparable(line);
            if (text.isEmpty())
                continue;
            if (seen.contains(placeOf(line)) || left[text] > 0) {
                left[text] -= seen.contains(placeOf(line)) ? 0 : 1;
                walk.keep(text);
            } else {
                walk.lose(line);
            }
            seen.insert(placeOf(line));
        }
    }
    for (CodeSection &section : listing.sections)
        std::stable_sort(section.gone.begin(), section.gone.end(),
                         [](const GoneLine &a, const GoneLine &b) { return a.before < b.before; });
}

}
