#pragma once

#include "sim/scene/effect.h"

#include <QHash>
#include <QString>
#include <QStringList>

#include <optional>
#include <vector>

namespace app {

/// A line as it stands in a file.
struct SourceLine
{
    QString text;
    int number = 0; ///< in the file, from 1
    friend bool operator==(const SourceLine &, const SourceLine &) = default;
};

/// The source that is built into the program: what runs was compiled from these very lines.
class SourceBook
{
public:
    /// The lines between the region's two markers, without the markers of other regions inside, without blank lines
    /// at either end, and without the indentation that they have in common. Empty when there is no such file or
    /// no such pair of markers.
    std::optional<std::vector<SourceLine>> text(const sim::Region &region);

private:
    const QStringList &linesOf(const QString &file);

    QHash<QString, QStringList> m_files;
};

}
