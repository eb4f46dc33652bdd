#include "app/model/files/recent_files.h"

#include <QFileInfo>
#include <QSettings>

namespace app {

namespace {

const char *const recentKey = "files/recent";

}

QStringList recentFiles()
{
    return QSettings().value(recentKey).toStringList().mid(0, mostRecentFiles);
}

void addRecentFile(const QString &path)
{
    const QString absolute = QFileInfo(path).absoluteFilePath();
    QStringList files = recentFiles();
    files.removeAll(absolute);
    files.prepend(absolute);
    QSettings().setValue(recentKey, QStringList(files.mid(0, mostRecentFiles)));
}

void dropRecentFile(const QString &path)
{
    QStringList files = recentFiles();
    files.removeAll(QFileInfo(path).absoluteFilePath());
    QSettings().setValue(recentKey, files);
}

}
