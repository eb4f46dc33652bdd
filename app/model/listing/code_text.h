#pragma once

#include "app/listing/values.h"

#include <QElapsedTimer>
#include <QString>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace app {

// What all code that learners write has in common.

/// A mistake in the text, for the editor.
struct CodeMistake
{
    int line = 1;     ///< from 1
    int column = 1;   ///< from 1, in characters
    int length = 1;   ///< characters, of the word that is wrong
    QString sentence; ///< the mistake and the names that exist, translated
    friend bool operator==(const CodeMistake &, const CodeMistake &) = default;
};

/// Returns the mistakes that the compiler found in `text`.
std::vector<CodeMistake> mistakesOf(const std::vector<listing::CompileError> &errors, const QString &text);

/// Returns the first line of `text` that `other` does not have, as part of the name of a run.
QString firstNewLine(const QString &other, const QString &text);

/// Groups edits for undo: edits without a pause between them are one entry.
class TypingPause
{
public:
    /// After this time without a change of the text, the next one is undone separately, in ms.
    static constexpr int milliseconds = 1000;

    /// Notes a change of the text. Returns whether there was a pause before it.
    bool endsWithChange()
    {
        const bool wasLong = !m_sinceChange.isValid() || m_sinceChange.hasExpired(milliseconds);
        m_sinceChange.start();
        return wasLong;
    }

private:
    QElapsedTimer m_sinceChange;
};

/// The last few results of a function, which takes long for some keys.
template <class Key, class Result>
class RecentResults
{
public:
    /// Returns the result for `key`, which `make()` computes if it is not among the last ones.
    template <class Make>
    const Result &of(const Key &key, const Make &make)
    {
        const auto found = std::find_if(m_results.begin(), m_results.end(),
                                        [&](const auto &one) { return one.first == key; });
        if (found != m_results.end()) {
            std::rotate(m_results.begin(), found, found + 1);
        } else {
            m_results.emplace(m_results.begin(), key, make());
            if (m_results.size() > most)
                m_results.pop_back();
        }
        return m_results.front().second;
    }

private:
    static constexpr std::size_t most =
        4; ///< for texts: the step's, the learner's, and those of the last undo

    std::vector<std::pair<Key, Result>> m_results; ///< the latest first
};

}
