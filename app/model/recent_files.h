#pragma once

#include <QStringList>

namespace app {

// The files that were opened or saved last, kept in the program's settings.

constexpr int mostRecentFiles = 8;

/// Absolute paths, the latest first.
QStringList recentFiles();
/// `path` becomes the latest.
void addRecentFile(const QString &path);
/// Takes one out, as when it is gone.
void dropRecentFile(const QString &path);

}
