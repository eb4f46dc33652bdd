#pragma once

#include "sim/scene/effect.h"

#include <QHash>
#include <QString>
#include <QStringList>

#include <optional>
#include <vector>

namespace app {

/// A line of a source file.
struct SourceLine
{
    QString text;
    int number = 0; ///< in the file, from 1
    friend bool operator==(const SourceLine &, const SourceLine &) = default;
};

/// The source files that are built into the program: the running code was compiled from these lines.
class SourceFiles
{
public:
    /// Returns the lines between the two markers of the region. Markers of nested regions, blank lines at either end and
    /// the common indentation are left out. Empty if there is no such file or no such pair of markers.
    std::optional<std::vector<SourceLine>> text(const sim::Region &region);

private:
    const QStringList &linesOf(const QString &file);

    QHash<QString, QStringList> m_files;
};

}
