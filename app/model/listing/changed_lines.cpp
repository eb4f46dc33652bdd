#include "app/model/listing/changed_lines.h"

#include <QStringList>

#include <algorithm>

namespace app {

namespace {

constexpr qsizetype mostPairs = 4'000'000; ///< of lines: two texts with more have no line in common

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

std::vector<int> movedLines(const QString &before, const QString &after)
{
    const QStringList from = trimmedLines(before), to = trimmedLines(after);
    std::vector<int> moved(static_cast<std::size_t>(from.size()) + 1, 0);
    const auto move = [&](qsizetype i, qsizetype j) {
        moved[static_cast<std::size_t>(i) + 1] = static_cast<int>(j) + 1;
    };
    const qsizetype most = std::min(from.size(), to.size());
    qsizetype head = 0, tail = 0;
    for (; head < most && from[head] == to[head]; ++head)
        move(head, head);
    for (; tail < most - head && from[from.size() - 1 - tail] == to[to.size() - 1 - tail]; ++tail)
        move(from.size() - 1 - tail, to.size() - 1 - tail);
    const QStringList removed = from.mid(head, from.size() - head - tail),
                      added = to.mid(head, to.size() - head - tail);
    const bool isComparable = removed.size() * added.size() <= mostPairs;
    CommonLengths lengths(isComparable ? removed : QStringList(), isComparable ? added : QStringList());
    for (qsizetype i = 0, j = 0; i < removed.size() || j < added.size(); ++i, ++j) {
        // Up to the next common line, the lines of one text take the places of those of the other.
        qsizetype nextI = i, nextJ = j;
        while ((nextI < removed.size() || nextJ < added.size()) &&
               !(nextI < removed.size() && nextJ < added.size() && removed[nextI] == added[nextJ])) {
            const bool isRemoved =
                nextJ >= added.size() ||
                (nextI < removed.size() &&
                 (!isComparable || lengths.at(nextI + 1, nextJ) >= lengths.at(nextI, nextJ + 1)));
            ++(isRemoved ? nextI : nextJ);
        }
        for (; i < nextI; ++i, j = std::min(j + 1, nextJ)) {
            if (j < nextJ)
                move(head + i, head + j);
        }
        j = nextJ;
        if (i < removed.size())
            move(head + i, head + j);
    }
    return moved;
}

}
