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

}
