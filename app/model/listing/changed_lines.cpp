#include "app/model/listing/changed_lines.h"

#include <QStringList>

#include <algorithm>

namespace app {

namespace {

/// Returns the lines of `text` without spaces at their ends, and without blank lines at the end of the text.
QStringList trimmedLines(const QString &text)
{
    QStringList lines = text.split('\n');
    for (QString &line : lines) {
        while (!line.isEmpty() && line.back().isSpace())
            line.chop(1);
    }
    while (!lines.isEmpty() && lines.back().isEmpty())
        lines.pop_back();
    return lines;
}

/// Lengths of the longest common subsequences of two lists of lines, from each pair of positions to the ends.
class CommonLengths
{
public:
    CommonLengths(const QStringList &a, const QStringList &b)
        : m_width(static_cast<std::size_t>(b.size()) + 1),
          m_lengths((static_cast<std::size_t>(a.size()) + 1) * m_width, 0)
    {
        for (qsizetype i = a.size() - 1; i >= 0; --i) {
            for (qsizetype j = b.size() - 1; j >= 0; --j)
                at(i, j) = a[i] == b[j] ? at(i + 1, j + 1) + 1 : std::max(at(i + 1, j), at(i, j + 1));
        }
    }
    int &at(qsizetype i, qsizetype j)
    {
        return m_lengths[static_cast<std::size_t>(i) * m_width + static_cast<std::size_t>(j)];
    }

private:
    std::size_t m_width;
    std::vector<int> m_lengths;
};

}

ChangedLines changedLines(const QString &original, const QString &text)
{
    QStringList before = trimmedLines(original), after = trimmedLines(text);
    // Equal lines at both ends need no comparison, and most of a text is equal while the learner types.
    int first = 0;
    while (!before.isEmpty() && !after.isEmpty() && before.front() == after.front()) {
        before.pop_front();
        after.pop_front();
        ++first;
    }
    while (!before.isEmpty() && !after.isEmpty() && before.back() == after.back()) {
        before.pop_back();
        after.pop_back();
    }
    ChangedLines result;
    constexpr qsizetype mostPairs = 4'000'000; // such a text has no line in common with the listing
    if (before.size() * after.size() > mostPairs) {
        for (int j = 0; j < after.size(); ++j)
            result.changed.push_back(first + j + 1);
        return result;
    }
    CommonLengths lengths(before, after);
    qsizetype i = 0, j = 0;
    while (i < before.size() || j < after.size()) {
        int removed = 0, added = 0;
        while ((i < before.size() || j < after.size()) &&
               !(i < before.size() && j < after.size() && before[i] == after[j])) {
            if (j >= after.size() || (i < before.size() && lengths.at(i + 1, j) >= lengths.at(i, j + 1))) {
                ++i;
                ++removed;
            } else {
                result.changed.push_back(first + static_cast<int>(++j));
                ++added;
            }
        }
        // A line that replaces another one is only changed.
        if (removed > added)
            result.removedBefore.push_back(first + static_cast<int>(j) + 1);
        ++i;
        ++j;
    }
    return result;
}

}
