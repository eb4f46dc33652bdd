#pragma once

#include <QStringList>

namespace app {

// The files that were opened or saved most recently, stored in the program's settings.

constexpr int mostRecentFiles = 8;

/// Returns absolute paths, latest first.
QStringList recentFiles();
/// Makes `path` the latest file.
void addRecentFile(const QString &path);
/// Removes a file from the list, for example when it no longer exists.
void dropRecentFile(const QString &path);

}
