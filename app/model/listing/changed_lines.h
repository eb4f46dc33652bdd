#pragma once

#include <QString>

#include <vector>

namespace app {

/// The difference between a listing and the step's own, for the margin of the editor.
struct ChangedLines
{
    std::vector<int> changed; ///< lines of the text that the original does not have, from 1, ascending
    std::vector<int>
        removedBefore; ///< lines before which lines of the original are missing; the number of lines + 1
                       ///< if they are missing at the end
    friend bool operator==(const ChangedLines &, const ChangedLines &) = default;
};

/// Compares line by line. Spaces at the end of a line do not count.
ChangedLines changedLines(const QString &original, const QString &text);

/// Returns where each line of `before` is in `after`: for line `i`, from 1, element `i` is its line there, or 0 if it was
/// deleted. A line that was rewritten stays the same line. Element 0 means nothing.
std::vector<int> movedLines(const QString &before, const QString &after);

}
